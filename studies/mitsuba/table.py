"""Tables of error against time, of both races."""

import csv
import os
import pathlib
import sys

COLUMNS = ["scene", "program", "setting", "seconds", "error"]


def row(args, program, setting, seconds, found):
    """A row at the end of the table."""
    is_new = not os.path.exists(args.output)
    with open(args.output, "a", newline="") as file:
        writer = csv.writer(file)
        if is_new:
            writer.writerow(COLUMNS)
        writer.writerow([pathlib.Path(args.scene).stem, program, setting, f"{seconds:.3f}", f"{found:.5f}"])
    print(f"{args.scene}, {program}, {setting}: {seconds:.3f} s, {100 * found:.3f} %", file=sys.stderr)


def integers(text):
    return [int(own) for own in text.split(",")]
