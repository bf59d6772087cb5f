"""The longest time in which runs on a terminal say nothing, and how much of them their stages are. See README.md.

    python silence.py SHARED [--command radiosity] [--only solve,heat]

The runs are those of `forecasts.py`, with all threads.
"""

import argparse
import fcntl
import os
import pathlib
import pty
import select
import shutil
import struct
import subprocess
import sys
import tempfile
import termios
import time

import forecasts
import measured

# Longest silence (s), and least part of a run that its stages are.
SILENT, STAGED = 2.0, 0.95


def watched(command, arguments):
    """Seconds of a run, its longest silence, when that began, and all that was told."""
    command = os.path.abspath(shutil.which(command) or command)
    ours, theirs = pty.openpty()
    fcntl.ioctl(theirs, termios.TIOCSWINSZ, struct.pack("HHHH", 40, 160, 0, 0))
    with tempfile.TemporaryDirectory() as here:
        begun = last = time.monotonic()
        process = subprocess.Popen([command, *map(str, arguments)], cwd=here, stdout=subprocess.DEVNULL, stderr=theirs)
        os.close(theirs)
        longest, since, text, before = 0.0, 0.0, b"", b""
        while True:
            ready, _, _ = select.select([ours], [], [], 0.05)
            now = time.monotonic()
            try:
                said = os.read(ours, 65536) if ready else b""
            except OSError:
                said = None
            is_over = said is None or (not ready and process.poll() is not None)
            if said or is_over:
                if now - last > longest:
                    longest, since, before = now - last, last - begun, text[-60:]
                last = now
                text += said or b""
            if is_over:
                break
        process.wait()
    os.close(ours)
    return now - begun, longest, since, text.decode(errors="replace"), before.decode(errors="replace")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("--command", default="radiosity")
    parser.add_argument("--only", help="verbs, separated by commas")
    args = parser.parse_args()
    only = args.only.split(",") if args.only else None
    rows = []
    for arguments in forecasts.runs(args.shared.resolve()):
        if only and arguments[0] not in only:
            continue
        wall, longest, since, text, before = watched(args.command, arguments)
        told = text.replace("\r", "\n")
        share = measured.share(measured.stages(told))
        rows.append((arguments[0], pathlib.Path(arguments[1]).name, wall, longest, since, share))
        print(rows[-1], repr(before) if longest > SILENT else "", file=sys.stderr)
    shown = [
        (verb, name, f"{wall:.2f}", f"{longest:.2f}", f"{since:.2f}", "–" if share is None else f"{share:.3f}")
        for verb, name, wall, longest, since, share in rows
    ]
    measured.table(["verb", "scene", "s", "longest silence, s", "begun at, s", "stages/all"], shown)
    loud = sum(row[3] <= SILENT for row in rows)
    staged = sum(row[5] is not None and row[5] >= STAGED for row in rows)
    print(f"\n{loud} of {len(rows)} runs are never silent for more than {SILENT:g} s; in {staged} stages are {STAGED:g} of all and more.")


if __name__ == "__main__":
    main()
