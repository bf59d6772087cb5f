"""Seconds of rooms with curved things by rules, by rays and as chosen, beside the errors told and true. See README.md.

    python choices.py SHARED [--command radiosity] [--limit 120]

Rooms are those of SHARED/cases/rooms with balls, cylinders, cones or tori. Seconds are those of `solve`, errors those of
readings by `probe`, in the mean of all, and what rays tell to leave in the radiosity of elements.
"""

import argparse
import pathlib
import re
import sys

import coverage
import measured

ROOMS = ["r2", "r8", "r17", "r23", "r32", "r47", "r53", "r68", "r83", "r98"]
WAYS = ["auto", "exact", "sampled"]
RAYS = re.compile(r"rays leave an error of ([0-9.e+-]+)")


def solved(command, room, way, limit):
    """Seconds of processors, the error that rays tell, and the true error of readings by the solution."""
    own = measured.run(command, ["solve", room, "--transport", way, "-o", "x.json"], limit=limit)
    found = RAYS.search(own["told"])
    return own["cpu"] if own["code"] == 0 else None, float(found.group(1)) if found else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("--command", default="radiosity")
    parser.add_argument("--limit", type=float, default=120.0)
    args = parser.parse_args()
    rows = []
    for name in ROOMS:
        room = args.shared.resolve() / "cases" / "rooms" / f"{name}.json"
        cells = [name]
        for way in WAYS:
            own = coverage.run(room, args.command, ["--transport", way], args.limit)[0]
            seconds, told = solved(args.command, room, way, args.limit)
            cells += [way_cell(seconds), *(f"{100 * own[key]:.2g}" if own.get(key) is not None else "–" for key in ("true", "told")),
                      f"{100 * told:.2g}" if told else "rules"]
        rows.append(cells)
        print(cells, file=sys.stderr)
    head = ["room"] + [f"{way}: {what}" for way in WAYS for what in ("CPU s", "true %", "told %", "rays leave %")]
    measured.table(head, rows)


def way_cell(seconds):
    return "late" if seconds is None else f"{seconds:.2f}"


if __name__ == "__main__":
    main()
