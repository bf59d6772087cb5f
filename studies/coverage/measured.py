"""A run of the command with its seconds, its peak of memory and what it told, and tables of such runs."""

import os
import re
import shutil
import subprocess
import tempfile
import threading
import time

STAGE = re.compile(r"([a-z][a-z -]*?) ([0-9.]+) s(?: \(forecast ([0-9.e+-]+) s\))?(?:, |$)")


def run(command, arguments, limit=600.0, here=None):
    """Seconds by the clock and of processors, megabytes at the most, exit code (None where it took more than `limit`) and
    what was told on stderr."""
    command = os.path.abspath(shutil.which(command) or command)
    with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryFile() as told:
        begun = time.monotonic()
        process = subprocess.Popen([command, *map(str, arguments)], cwd=here or folder, stdout=subprocess.DEVNULL, stderr=told)
        timer = threading.Timer(limit, process.kill)
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - begun
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        told.seek(0)
        text = told.read().decode(errors="replace")
    return {
        "wall": wall, "cpu": usage.ru_utime + usage.ru_stime, "megabytes": usage.ru_maxrss / 1024,
        "code": None if wall >= limit else process.returncode, "told": text,
    }


def listed(told):
    """Stages of the last summary: their names, seconds and forecasts."""
    lines = [line.removeprefix("stages: ") for line in told.splitlines() if line.startswith("stages: ")]
    return STAGE.findall(lines[-1]) if lines else []


def stages(told):
    """Seconds of the stages of a summary."""
    return {name: float(took) for name, took, _ in listed(told)}


def forecasts(told):
    """Forecasts of the stages of a summary that have one."""
    return {name: float(own) for name, _, own in listed(told) if own}


def share(own):
    """Part of a run that its stages are; None where none are told."""
    whole = sum(own.values())
    return (whole - own.get("other", 0)) / whole if whole else None


def table(head, rows):
    """Prints rows as a table."""
    print("| " + " | ".join(head) + " |\n|" + " --- |" * len(head))
    for row in rows:
        print("| " + " | ".join(map(str, row)) + " |", flush=True)
