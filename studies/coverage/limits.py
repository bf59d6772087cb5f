"""Whether runs whose time is limited end in time, and with which error. See README.md.

    python limits.py SHARED [--command radiosity] [--seconds 5] [--only soda,07]

SHARED is the folder with `scenes/mgf` and `cases/adversary`.
"""

import argparse
import pathlib
import subprocess
import sys
import tempfile

import measured

# A run may last so many times its limit, and so much longer at least.
OVER, LEAST = 1.2, 1.0
PICTURES = ["cornell-box", "teapot", "temple", "billiard", "cathedral", "soda.json", "classroom.json"]


def scenes(command, shared, folder):
    """Built-in scenes of light, MGF rooms and rooms that are hard, those of a program in `folder`."""
    listed = subprocess.run([command, "scenes"], capture_output=True, text=True, check=True).stdout
    # A table of scenes, then one of their parameters.
    yield from (line.split()[0] for line in listed.split("\n\n")[0].splitlines()[1:])
    yield from sorted((shared / "scenes" / "mgf").glob("*.mgf"))
    yield from (own for own in sorted((shared / "scenes" / "mgf").glob("*.json")) if "reference" not in own.name)
    hard = shared / "cases" / "adversary"
    yield from sorted(own for start in ("07", "10-") for own in hard.glob(f"{start}*.json"))
    subprocess.run([sys.executable, hard / "08-hall.py"], cwd=folder, capture_output=True, check=True)
    yield pathlib.Path(folder) / "h10000.json"


def told(text):
    """Words on the error of a run."""
    found = [line for line in text.splitlines() if "error" in line or line.startswith(("checked", "not checked"))]
    return "; ".join(line[:100] for line in found[-2:]) or "–"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("--command", default="radiosity")
    parser.add_argument("--seconds", type=float, default=5.0)
    parser.add_argument("--only", help="parts of names, separated by commas")
    args = parser.parse_args()
    only = args.only.split(",") if args.only else [""]
    most = max(OVER * args.seconds, args.seconds + LEAST)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        listed = [own for own in scenes(args.command, args.shared.resolve(), folder) if any(part in str(own) for part in only)]
        for verb in ("solve", "render"):
            for scene in listed:
                name = pathlib.Path(scene).name
                if verb == "render" and name not in PICTURES:
                    continue
                output = "x.json" if verb == "solve" else "x.png"
                limit = ["--time-limit", args.seconds, "-o", output]
                own = measured.run(args.command, [verb, scene, *limit], limit=60.0)
                whole = measured.share(measured.stages(own["told"]))
                rows.append((verb, name, f"{own['wall']:.2f}", "late" if own["wall"] > most else own["code"],
                             f"{own['megabytes']:.0f}", "–" if whole is None else f"{whole:.2f}", told(own["told"])))
                print(rows[-1], file=sys.stderr)
    measured.table(["verb", "scene", "s", "exit code", "MB", "stages/all", "told"], rows)
    late = sum(row[3] == "late" for row in rows)
    print(f"\n{len(rows) - late} of {len(rows)} runs end within {most:g} s.")


if __name__ == "__main__":
    main()
