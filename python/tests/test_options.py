"""Every option of the command is an argument, and every argument an option; what is not is listed here."""

from __future__ import annotations

import pydoc
import re

import pytest

import radiosity
from radiosity import options

RENAMED = {"for": "aim", "from": "format"}

# Results are arrays here: how they are written, shown and told is Python's own; `set` is an argument of `load`. Only the command records
# what it does, and reads files outside the folder of a scene. A sweep is `Scene.heat_sweep`.
OUTPUT = {"help", "version", "output", "format", "report", "quiet", "verbose", "set", "checkpoint", "resume", "inside"}
STYLE = {"show", "size", "range", "band", "log", "isolines"}

SCENE = set(options.Import.__annotations__)
LIGHT = SCENE | set(options.Solving.__annotations__) | {"aim"}

CASES = {
    "solve": (LIGHT, set()),
    "probe": (LIGHT - {"keep_partial"} | set(options.Reading.__annotations__) | {"points", "plane"}, {"picture", "planes", *STYLE}),
    "grid": (LIGHT - {"keep_partial"} | set(options.Cells.__annotations__) | {"cells"}, set()),
    "render": (
        LIGHT - {"keep_partial"} | set(options.Picture.__annotations__) | {"size"},
        {"importance", "preview", "eye", "target", "view_up", "fov", "exposure", "false_colour", "difference", "wireframe", *STYLE - {"show", "size"}},
    ),
    "audit": (LIGHT - {"keep_partial", "audit"} | set(options.Auditing.__annotations__), {"picture", "size", "of"}),
    "heat": (SCENE | set(options.HeatMethod.__annotations__), {"picture", "sweep", *STYLE}),
    "view-factors": (SCENE | set(options.Transfers.__annotations__) | {"pairs", "sparse"}, set()),
}


@pytest.mark.parametrize("verb", CASES)
def test_options_and_arguments_are_the_same(command, verb: str):
    arguments, left_out = CASES[verb]
    typed = set(re.findall(r"^ +(?:-\w, )?--([a-z-]+)", command(verb, "--help").decode(), re.MULTILINE)) - OUTPUT
    assert "eps" in typed, "the help is read"
    assert {RENAMED.get(name, name.replace("-", "_")) for name in typed} - left_out == arguments


def test_help_lists_every_option():
    shown = pydoc.plaintext.document(radiosity.options)
    listed = set(re.findall(r"^     \|  (\w+): ", shown, re.MULTILINE))
    groups = [group for group in vars(options).values() if hasattr(group, "__total__")]
    assert len(groups) == 9
    assert set().union(*(group.__annotations__ for group in groups)) <= listed
