"""Errors that runs tell beside their true ones, over folders of scenes with right values. See README.md.

    python coverage.py run FOLDER... -o runs.csv [--command radiosity] [--only r2,r3] [-- options of the command]
    python coverage.py table runs.csv

A scene is `NAME.json` or `NAME.toml` with right values `NAME.mc`. With sensors, `NAME.csv`, the command is `probe` and a line of
`NAME.mc` is a mean and its standard error; without them it is `heat` and a line is a surface, its flow with the standard error,
its temperature with the standard error.

    true² = Σ ((E − M)² − s²) / Σ (M² − s²)          over the readings of a scene, M ± s being right
"""

import argparse
import csv
import json
import math
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time
import tomllib

# Kinds of the rooms whose titles do not tell, by the starts of the names of surfaces.
STEMS = {
    "window": ["window", "rev"], "table": ["top", "desk", "dt"], "shelf": ["shelf", "cab"], "rug": ["rug", "pic"],
    "crate": ["crate"], "partition": ["par"], "sheet": ["sheet"], "shade": ["sh", "bulb"], "ball": ["ball", "dome"],
    "bin": ["bin", "col"], "cone": ["cone"], "torus": ["tor"], "pillar": ["pil", "across", "head"],
}
# Told over true between which an error counts as told, of those that can be seen.
BETWEEN = (0.6, 1.7)
LEAST = 1 / 3
COLUMNS = ["scene", "kinds", "code", "seconds", "readings", "true", "true_sd", "told", "told_sd", "visible", "own", "factor",
           "rows", "rows_beyond_1", "rows_beyond_3", "rows_told", "rows_true"]


def described(path):
    """The scene of a file, as a table."""
    text = path.read_text()
    return json.loads(text) if path.suffix == ".json" else tomllib.loads(text)


def kinds(scene):
    _, colon, listed = scene.get("title", "").partition(": ")
    if colon:
        return listed.split(", ")
    stems = {re.match(r"[^0-9:]*", own.get("name", "")).group() for own in scene["surfaces"]}
    return [kind for kind, starts in STEMS.items() if stems & set(starts)]


def judged(found, right):
    """The true relative error of (value, told error or None) and its standard error, and what is true and told of single rows."""
    offs = [(value - mean, noise, told) for (value, told), (mean, noise) in zip(found, right, strict=True)]
    whole = sum(mean**2 - noise**2 for mean, noise in right) or 1.0
    square = sum(off**2 - noise**2 for off, noise, _ in offs) / whole
    doubt = math.sqrt(sum(2 * noise**4 + 4 * max(off**2 - noise**2, 0) * noise**2 for off, noise, _ in offs)) / whole
    true = math.sqrt(max(square, 0))
    rows = [(abs(off), math.hypot(noise, told), told) for off, noise, told in offs if told is not None]
    return {
        "true": true,
        "true_sd": doubt / (2 * true) if square > doubt else math.sqrt(doubt),
        "rows": len(rows),
        "rows_beyond_1": sum(off > scale for off, scale, _ in rows),
        "rows_beyond_3": sum(off > 3 * scale for off, scale, _ in rows),
        "rows_told": math.sqrt(sum(told**2 for _, _, told in rows) / whole) if rows else None,
        "rows_true": true,
    }


def readings(rows):
    """Irradiances of the first band with the errors told of them, where there are any."""
    light = next(key for key in rows[0] if key.startswith("E_"))
    told = next((key for key in rows[0] if "error" in key), None)
    return [(float(row[light]), float(row[told]) if told and row[told] else None) for row in rows]


def warm(rows, right):
    """Flows (W) of surfaces of known temperature, temperatures (K) of the others: found with the errors told of them, and right."""
    by_name = {row["surface"]: row for row in rows}
    families = {"flows": ("Q", 1, []), "temperatures": ("T", 3, [])}
    for name, *numbers in right:
        key, first, own = families["flows" if float(by_name[name]["T_error"]) == 0 else "temperatures"]
        told = (float(by_name[name][key]), float(by_name[name][f"{key}_error"]))
        own.append((told, (float(numbers[first - 1]), float(numbers[first]))))
    return {name: list(zip(*own)) for name, (_, _, own) in families.items() if own}


def told_of(report):
    """What a report tells of the whole; one of before there was a referee tells the deviation of readings by rays alone."""
    own = (report.get("audit") or {}) | {key: value for key, value in report.items() if isinstance(value, (int, float))}
    by_rays = (report.get("read_error") or {}).get("rms")
    return {"told": own.get("error", by_rays), "told_sd": own.get("error_sd"), "visible": own.get("visible"),
            "own": own.get("own_error"), "factor": own.get("error_factor")}


def run(scene, command, options, limit):
    """The rows of one scene: one of its light, or those of its flows and its temperatures."""
    right = [line.split() for line in scene.with_suffix(".mc").read_text().splitlines()]
    sensors = scene.with_suffix(".csv")
    own = {"scene": scene.stem, "kinds": ";".join(kinds(described(scene)))}
    with tempfile.TemporaryDirectory() as folder:
        table, report = pathlib.Path(folder) / "table.csv", pathlib.Path(folder) / "report.json"
        verb = ["heat", str(scene)]
        if sensors.exists():
            verb = ["probe", str(scene), "--points", str(sensors), "--report", str(report)]
        start = time.perf_counter()
        try:
            done = subprocess.run([command, *verb, "-q", "-o", str(table), *options], capture_output=True, text=True,
                                  timeout=limit, check=False)
        except subprocess.TimeoutExpired:
            return [own | {"code": "late", "seconds": limit}]
        own |= {"code": done.returncode, "seconds": round(time.perf_counter() - start, 3)}
        if not table.exists():
            print(f"{scene}: {done.stderr.strip().splitlines()[:1]}", file=sys.stderr)
            return [own]
        rows = list(csv.DictReader(table.open()))
        told = told_of(json.loads(report.read_text())) if report.exists() else {}
    if sensors.exists():
        found, right = readings(rows), [(float(line[0]), float(line[1])) for line in right]
        return [own | {"readings": len(right)} | judged(found, right) | told]
    families = warm(rows, right)
    rows = [own | {"scene": f"{own['scene']} {name}", "kinds": f"{own['kinds']};{name}", "readings": len(found)}
            | judged(found, right) for name, (found, right) in families.items()]
    return [row | {"told": row["rows_told"]} for row in rows]


def run_all(args):
    scenes = [own for folder in args.folder for own in sorted(pathlib.Path(folder).glob("*.mc"), key=order)]
    with open(args.output, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS)
        writer.writeheader()
        for right in scenes:
            if args.only and right.stem not in args.only.split(","):
                continue
            scene = next(path for path in map(right.with_suffix, (".json", ".toml")) if path.exists())
            for row in run(scene, args.command, args.options, args.limit):
                writer.writerow(row)
                print(f"{row['scene']}: {row['seconds']} s, true {row.get('true')}, told {row.get('told')}", file=sys.stderr)
            file.flush()


def order(path):
    return path.stem[0], int(re.sub(r"\D", "", path.stem) or 0)


def number(row, key):
    return float(row[key]) if row.get(key) else None


def is_seen(row):
    """Whether the true error is above what the run says that it can see, and known to a fifth."""
    true, visible = number(row, "true"), number(row, "visible")
    return true is not None and true > 5 * number(row, "true_sd") and true > (visible or 0)


def line(name, rows):
    """The row of a kind."""
    done = [row for row in rows if number(row, "true") is not None]
    trues, seconds = [number(row, "true") for row in done], [number(row, "seconds") for row in rows]
    told = [number(row, "told") / number(row, "true") for row in done if is_seen(row) and number(row, "told") is not None]
    readings = [int(row["rows"]) for row in done]
    beyond = [sum(int(row[key]) for row in done) for key in ("rows_beyond_1", "rows_beyond_3")]

    def share(hits, of):
        return f"{100 * hits / of:.1f}" if of else "–"

    cells = [
        name, len(rows), f"{100 * statistics.median(trues):.2f}" if trues else "–", f"{100 * max(trues):.2f}" if trues else "–",
        len(told), f"{statistics.median(told):.2f}" if told else "–", f"{min(told):.2f}" if told else "–",
        f"{max(told):.2f}" if told else "–", share(sum(BETWEEN[0] <= own <= BETWEEN[1] for own in told), len(told)),
        share(sum(own < LEAST for own in told), len(told)), share(beyond[0], sum(readings)), share(beyond[1], sum(readings)),
        share(sum(row["code"] == "3" for row in rows), len(rows)), share(sum(row["code"] not in "03" for row in rows), len(rows)),
        f"{statistics.median(seconds):.2f}", f"{max(seconds):.1f}",
    ]
    print("| " + " | ".join(map(str, cells)) + " |")


def table(args):
    rows = list(csv.DictReader(open(args.table, newline="")))
    head = ["scenes with", "scenes", "true: median, %", "largest, %", "seen", "told/true: median", "least", "largest",
            f"within {BETWEEN[0]} to {BETWEEN[1]}, %", "below a third, %", "rows beyond their error, %", "beyond 3, %",
            "missed, %", "failed or late, %", "median s", "largest s"]
    print("| " + " | ".join(head) + " |\n|" + " --- |" * (len(head) - 2) + " ---: | ---: |")
    line("all", rows)
    for kind in sorted({kind for row in rows for kind in row["kinds"].split(";") if kind}):
        line(kind, [row for row in rows if kind in row["kinds"].split(";")])
    if args.accuracy:
        kept(rows, args.accuracy)
    if args.beside:
        beside(rows, list(csv.DictReader(open(args.beside, newline=""))))


def kept(rows, accuracy):
    """Of runs that were to be as accurate: kept within the noise of what is right, told as missed, missed in silence."""
    done = [row for row in rows if number(row, "true") is not None]
    beyond = [row for row in done if number(row, "true") - 2 * number(row, "true_sd") > accuracy]
    silent = [row for row in beyond if row["code"] == "0"]
    print(f"\nof {len(rows)} runs at {accuracy:g}: {len(done) - len(beyond)} kept, {len(beyond)} beyond, of which "
          f"{len(silent)} in silence; {sum(row['code'] == '3' for row in rows)} told as missed, {len(rows) - len(done)} failed or late")
    for row in beyond:
        name = "silent" if row["code"] == "0" else "told"
        print(f"{row['scene']} ({row['kinds']}): true {100 * number(row, 'true'):.2f} %, told {row['told']}, {name}")


def beside(rows, before):
    """Times of the same scenes in another table, paired."""
    earlier = {row["scene"]: number(row, "seconds") for row in before}
    ratios = [number(row, "seconds") / earlier[row["scene"]] for row in rows if row["scene"] in earlier]
    print(f"\ntimes over those before: median {statistics.median(ratios):.2f}, largest {max(ratios):.2f}, of {len(ratios)} scenes")


def arguments():
    words = sys.argv[1:]
    cut = words.index("--") if "--" in words else len(words)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parts = parser.add_subparsers(required=True)
    own = parts.add_parser("run", help="runs the command on the scenes of folders; its options stand behind --")
    own.set_defaults(run=run_all)
    own.add_argument("folder", nargs="+")
    own.add_argument("-o", "--output", required=True)
    own.add_argument("--command", default="target/release/radiosity")
    own.add_argument("--only", help="names of scenes, with commas")
    own.add_argument("--limit", type=float, default=600, help="seconds after which a run is given up")
    own = parts.add_parser("table", help="prints a table by kind")
    own.set_defaults(run=table)
    own.add_argument("table")
    own.add_argument("--accuracy", type=float, help="names runs that are less accurate")
    own.add_argument("--beside", help="another table of the same scenes, whose times are compared")
    args = parser.parse_args(words[:cut])
    args.options = words[cut + 1:]
    return args


if __name__ == "__main__":
    chosen = arguments()
    chosen.run(chosen)
