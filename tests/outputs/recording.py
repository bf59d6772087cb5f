"""The outputs of all commands, a folder for each: what it wrote, `stdout` and `stderr`, and `code`, its exit code."""

import os
import pathlib
import shlex
import shutil
import subprocess
import tempfile
import time
import tomllib
from dataclasses import dataclass

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
# Seconds after which a command is given up; the slowest takes a few.
LONGEST = 300


@dataclass(frozen=True)
class Command:
    """A command; its standard output goes to the file `stdout`."""

    name: str
    arguments: list[str]
    stdout: str


def commands() -> list[Command]:
    """The commands of `commands.toml`, in its order."""
    verbs = tomllib.loads((HERE / "commands.toml").read_text())
    return [_command(name, [verb, *shlex.split(typed)]) for verb, own in verbs.items() for name, typed in own.items()]


def _command(name: str, words: list[str]) -> Command:
    match words:
        case [*arguments, ">", stdout]:
            return Command(name, arguments, stdout)
        case _:
            return Command(name, words, "stdout")


def record(binary: pathlib.Path, folder: pathlib.Path, threads: int) -> dict[str, float]:
    """Runs all commands and moves their outputs to the new `folder`; the seconds of each by name.

    Raises FileExistsError where there is such a folder, RuntimeError where a command fails.
    """
    if folder.exists():
        raise FileExistsError(f"{folder} is there already")
    seconds = {}
    with tempfile.TemporaryDirectory() as scratch:
        room = pathlib.Path(scratch, "room")
        room.mkdir()
        (room / "repository").symlink_to(REPOSITORY)
        for command in commands():
            start = time.monotonic()
            _run(binary.resolve(), command, room / command.name, threads)
            seconds[command.name] = time.monotonic() - start
        (room / "repository").unlink()
        shutil.copytree(room, folder)
    return seconds


def _run(binary: pathlib.Path, command: Command, folder: pathlib.Path, threads: int) -> None:
    folder.mkdir()
    arguments = list(command.arguments)
    if _takes_threads(binary, arguments[0]):
        arguments += ["--threads", str(threads)]
    environment = os.environ | {"RAYON_NUM_THREADS": str(threads)}
    with open(folder / command.stdout, "wb") as stdout, open(folder / "stderr", "wb") as stderr:
        streams = {"stdin": subprocess.DEVNULL, "stdout": stdout, "stderr": stderr}
        code = subprocess.run([binary, *arguments], cwd=folder, env=environment, timeout=LONGEST, **streams).returncode
    (folder / "code").write_text(f"{code}\n")
    if code:
        raise RuntimeError(f"{command.name}: exit code {code}: {(folder / 'stderr').read_text()}")


def _takes_threads(binary: pathlib.Path, verb: str) -> bool:
    told = subprocess.run([binary, verb, "--help"], capture_output=True, text=True, check=True)
    return "--threads" in told.stdout


def outputs(folder: pathlib.Path) -> dict[str, list[str]]:
    """The names of the files of each command in a recording, in order."""
    found = {}
    for command in commands():
        if not (folder / command.name).is_dir():
            raise FileNotFoundError(f"{folder} holds no outputs of {command.name}: record it anew")
        found[command.name] = sorted(path.name for path in (folder / command.name).iterdir())
    return found
