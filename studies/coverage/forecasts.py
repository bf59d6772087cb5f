"""Seconds that runs tell before they begin beside those that they take, stage by stage. See README.md.

    python forecasts.py SHARED -o forecasts.csv [--command radiosity] [--only solve,heat] [--pictures OFFICE.json]
    python forecasts.py table forecasts.csv

SHARED is the folder with `scenes/mgf` and `cases/rooms`; with --pictures the runs are twenty pictures, films and other
outputs that show light, among them those of the office of `studies/mitsuba/office.py`. Each run has one thread. What a machine does besides
lengthens the stages, not the CPU time of a run: stages are scaled by the CPU time of the run over its wall time.
"""

import argparse
import csv
import pathlib
import statistics
import sys

import measured

COLUMNS = ["verb", "scene", "code", "wall", "cpu", "told", "stages", "parts"]


def runs(shared):
    """Verbs with their arguments, some forty."""
    mgf, rooms = shared / "scenes" / "mgf", shared / "cases" / "rooms"
    mgf = [mgf / name for name in ("soda.mgf", "soda.json", "classroom.mgf", "classroom.json")]
    soda = mgf[0]
    rooms = [rooms / f"{name}.json" for name in ("r0", "r13", "r25", "r40", "r57")]
    small = ["--size", "160x120"]
    for scene in ["cornell-box", "two-boxes", "teapot", "temple", "billiard", "cathedral", *mgf, *rooms[:3]]:
        yield ["solve", scene, "-o", "x.json"]
    for scene in ["cornell-box", "teapot", "billiard", "soda.json", rooms[1]]:
        yield ["render", mgf[1] if scene == "soda.json" else scene, *small, "-o", "x.png"]
    for scene in ["cornell-box", "two-boxes", "billiard", rooms[2], rooms[3]]:
        yield ["grid", scene, "--cells", "4x4", "-o", "x.csv"]
    for room in rooms:
        yield ["probe", room, "--points", room.with_suffix(".csv"), "-o", "x.csv"]
    for scene in ["cornell-box", rooms[4]]:
        yield ["report", scene, "-o", "x.html"]
    for scene in ["cornell-box", "temple", "teapot", soda, rooms[0]]:
        yield ["view-factors", scene, "-o", "x.npz"]
    yield ["heat", "oven"]
    yield ["heat", "oven", "--order", "5", "--eps", "1e-6"]
    yield ["heat", "oven", "--rays", "2000000"]
    yield ["heat", shared / "cases" / "heat" / "sat.toml"]
    yield ["heat", shared / "cases" / "heat" / "groove30.toml"]
    for scene in ["sliding-light", "blue-panel"]:
        yield ["animate", scene, "--frames", "0..3", *small, "-o", "frame-####.png"]


def pictures(shared, office):
    """Verbs with their arguments: pictures of growing size, films, tables and files of the light that they show."""
    examples = pathlib.Path(__file__).resolve().parents[2] / "examples"
    seen = {
        office: ["--eye", "0.6,0.6,1.7", "--target", "9,6,1.0", "--fov", "60"],
        shared / "scenes" / "mgf" / "soda.json": ["--eye", "-1.7,2.3,2.3", "--target", "2.7,.2,.3", "--view-up", "0,1,0", "--fov", "70"],
        shared / "scenes" / "mgf" / "classroom.json": ["--eye", "6.4,1,1.7", "--target", "2,9,1", "--fov", "70"],
    }
    office, soda, classroom = seen
    sizes = [
        ("cornell-box", "128x128"), ("cornell-box", "512x512"), ("cornell-box", "1024x1024"), (office, "160x120"), (office, "640x480"),
        ("teapot", "128x128"), ("teapot", "512x512"), ("temple", "512x384"), ("billiard", "640x360"),
        (examples / "textured-room.toml", "640x480"), (soda, "640x480"), (classroom, "640x480"),
    ]
    for scene, size in sizes:
        yield ["render", scene, *seen.get(scene, []), "--size", size, "-o", "x.png"]
    yield ["animate", "billiard", "--frames", "0..9", "--size", "640x360", "-o", "frame-####.png"]
    yield ["animate", "billiard-slide", "--frames", "0..9", "--size", "320x180", "-o", "frame-####.png"]
    yield ["animate", "sliding-light", "--frames", "0..9", "--size", "320x240", "-o", "frame-####.png"]
    yield ["render", "cornell-box", "-o", "x.glb"]
    yield ["render", "teapot", "-o", "x.html"]
    yield ["grid", office, "-o", "x.csv"]
    yield ["grid", soda, "-o", "x.csv"]
    yield ["report", office, "-o", "x.html"]


def run(command, arguments):
    """A run with its seconds, and its stages as they were told and took."""
    own = measured.run(command, [*arguments, "--threads", "1"])
    if own["code"] != 0:
        print(own["told"], file=sys.stderr)
    stages, told = measured.stages(own["told"]), measured.forecasts(own["told"])
    share = own["cpu"] / own["wall"]
    parts = " ".join(f"{name.replace(' ', '-')}:{took * share:.3g}/{told.get(name, 0):.3g}" for name, took in stages.items())
    return {
        "verb": arguments[0], "scene": pathlib.Path(arguments[1]).name, "code": own["code"], "wall": f"{own['wall']:.3g}",
        "cpu": f"{own['cpu']:.3g}", "told": f"{sum(told.values()):.3g}", "stages": f"{measured.share(stages) or 0:.3f}",
        "parts": parts,
    }


def table(path):
    """Prints the runs as a table, then how many were told within a factor of two."""
    with open(path, newline="") as rows:
        rows = list(csv.DictReader(rows))
    print("| verb | scene | CPU s | told s | told/CPU | stages/all | largest stages: CPU s / told s |\n| --- | --- | ---: | ---: | ---: | ---: | --- |")
    ratios = {}
    for row in rows:
        cpu, told = float(row["cpu"]), float(row["told"])
        parts = [part.split(":") for part in row["parts"].split()]
        parts.sort(key=lambda part: -max(map(float, part[1].split("/"))))
        print(
            f"| {row['verb']} | {row['scene']} | {cpu:.2f} | {told:.2f} | {told / cpu:.2f} | {float(row['stages']):.2f} | "
            + ", ".join(f"{name} {numbers}" for name, numbers in parts[:3]) + " |"
        )
        ratios.setdefault(row["verb"], []).append(told / cpu)
    everything = [ratio for own in ratios.values() for ratio in own]
    near = sum(0.5 <= ratio <= 2 for ratio in everything)
    told = sum(float(row["stages"]) >= 0.95 for row in rows)
    print(f"\n{near} of {len(everything)} runs are told within a factor of 2; in {told} the stages are 0.95 of all and more.")
    for verb, own in ratios.items():
        print(f"{verb}: told/CPU {min(own):.2f} to {max(own):.2f}, median {statistics.median(own):.2f}")


def main():
    if sys.argv[1:2] == ["table"]:
        return table(sys.argv[2])
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("-o", "--output", required=True)
    parser.add_argument("--command", default="radiosity")
    parser.add_argument("--only", help="verbs, separated by commas")
    parser.add_argument("--pictures", type=pathlib.Path, metavar="OFFICE", help="the twenty pictures and films instead")
    args = parser.parse_args()
    only = args.only.split(",") if args.only else None
    with open(args.output, "w", newline="") as output:
        writer = csv.DictWriter(output, COLUMNS)
        writer.writeheader()
        shared = args.shared.resolve()
        for arguments in pictures(shared, args.pictures.resolve()) if args.pictures else runs(shared):
            if only is None or arguments[0] in only:
                writer.writerow(run(args.command, arguments))
                output.flush()
    return table(args.output)


if __name__ == "__main__":
    main()
