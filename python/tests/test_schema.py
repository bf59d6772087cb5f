"""The JSON schema of the scene format: it takes whatever is a scene, and refuses what is wrong."""

from __future__ import annotations

import copy
import functools
import json
import subprocess
from pathlib import Path
from typing import Any

import jsonschema_rs
import pytest
import tomli
from conftest import COMMAND, ROOT

import radiosity
from radiosity import Error, Scene


@functools.cache
def schema() -> Any:
    return json.loads(subprocess.run([COMMAND, "schema"], check=True, capture_output=True).stdout)


@functools.cache
def validator() -> jsonschema_rs.Draft202012Validator:
    return jsonschema_rs.Draft202012Validator(schema())


def documented() -> list[Any]:
    """The scenes of the document, in TOML, as files of a scene of several, and in JSON."""
    blocks = (ROOT / "docs" / "scene.md").read_text().split("```")[1::2]
    read = {"toml": tomli.loads, "json": json.loads}
    headed = [block.split("\n", 1) for block in blocks]
    return [read[head.split(" ")[0]](text) for head, text in headed if head.split(" ")[0] in read]


def accept(scene: Any) -> None:
    assert [error.message for error in validator().iter_errors(scene)] == []


def test_the_schema_is_a_schema():
    assert jsonschema_rs.meta.is_valid(schema())
    assert schema()["$schema"] == "https://json-schema.org/draft/2020-12/schema"


def test_scenes_of_the_document_are_accepted():
    scenes = documented()
    assert len(scenes) > 20
    for scene in scenes:
        accept(scene)


@pytest.mark.parametrize(("name", "parameters"), radiosity.builtins().items())
def test_built_in_scenes_are_accepted(name: str, parameters: dict[str, float]):
    accept(tomli.loads(radiosity.load(name).to_toml()))
    typed = ROOT / "scenes" / f"{name}.toml"
    if typed.exists():
        text = typed.read_text()
        for parameter, value in parameters.items():
            text = text.replace(f"${parameter}", repr(value))
        # Teapots have their patches from a table.
        if "$" not in text:
            accept(tomli.loads(text))


@pytest.mark.parametrize("file", ["tests/data/every-shape.toml", "examples/office.toml", "examples/textured-room.toml"])
def test_files_are_accepted(file: str):
    accept(tomli.loads((ROOT / file).read_text()))


# Every kind of thing, to be broken in one place.
SCENE: dict[str, Any] = {
    "bands": ["grey"],
    "unit": "lx",
    "variables": {"width": 2, "half": "=width/2"},
    "camera": {"eye": [0, -1, 1], "target": [0, 0, 0]},
    "planes": {"desk": {"origin": [0, 0, 0], "edges": [[1, 0, 0], [0, 1, 0]], "spacing": 0.1}},
    "materials": {"white": {"reflectance": 0.5, "emission": [1]}},
    "parts": {"lamp": {"surfaces": [{"sphere": {"center": [0, 0, 0], "radius": "=half"}}]}},
    "surfaces": [
        {
            "name": "floor",
            "material": "white",
            "order": 2,
            "subdivide": [2, 1],
            "transform": {"scale": 2, "rotate": [0, 0, 1, 90]},
            "quad": {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]},
        },
        {"material": "white", "box": {"origin": [0, 0, 2], "size": [1, 1, 1], "open": ["top"]}},
    ],
    "instances": [{"part": "lamp", "array": {"count": [2, 2], "step": [[1, 0, 0], [0, 1, 0]]}}],
}
WHITE = ["materials", "white"]
FLOOR = ["surfaces", 0]
BOX = ["surfaces", 1, "box"]
CHAIR = ["instances", 0]
WRONG: list[tuple[list[Any], str, Any]] = [
    ([], "tilte", "a slip"),
    ([], "title", " "),
    ([], "bands", []),
    ([], "bands", ["a", "a"]),
    ([], "unit", "watts per square metre"),
    ([], "include", [1]),
    (["variables"], "wi-dth", 1),
    (["variables"], "width", "2"),
    (["camera"], "fov", 180),
    (["camera"], "width", 1.5),
    (["camera"], "eye", [0, 0]),
    (["planes", "desk"], "spacing", 0),
    (["planes", "desk"], "spacing", [0.1, 0.1, 0.1]),
    (WHITE, "reflectance", 1),
    (WHITE, "reflectance", [0.5, -0.1]),
    (WHITE, "emission", -1),
    (WHITE, "transmittance", 1),
    (WHITE, "reflectance", {}),
    (WHITE, "reflectance", {"image": " "}),
    (WHITE, "reflectance", {"cells": []}),
    (WHITE, "reflectance", {"cells": [[0.5]], "polynomial": []}),
    (WHITE, "emission", {"cells": [[0.5]], "wrap": "tile"}),
    (WHITE, "emission", {"cells": [[0.5]], "scale": 0}),
    (WHITE, "emission", {"polynomial": [[0, 0]]}),
    (WHITE, "emission", {"polynomial": [[0, 0, 1]], "factor": -1}),
    (WHITE, "colour", "red"),
    (FLOOR, "back_material", 3),
    (FLOOR, "order", 21),
    (FLOOR, "subdivide", [0, 1]),
    (FLOOR, "flux", "bright"),
    (FLOOR, "two_sided", "yes"),
    (FLOOR, "triangle", {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]]}),
    (FLOOR, "quad", {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0]]}),
    (FLOOR, "quad", {"vertexes": []}),
    (FLOOR, "transform", {"scale": 0}),
    (FLOOR, "transform", {"rotate": [0, 0, 1]}),
    (BOX, "size", [1, 1, 0]),
    (BOX, "corners", [[0, 0, 0], [1, 1, 1]]),
    (BOX, "open", ["ceiling"]),
    (["parts", "lamp"], "legs", 4),
    (CHAIR, "part", 3),
    ([*CHAIR, "array"], "count", 0),
    ([*CHAIR, "array"], "count", [1, 1, 1, 1]),
    ([*CHAIR, "array"], "step", [1, 0]),
]


def broken(place: list[Any]) -> tuple[dict[str, Any], Any]:
    """A copy of the scene, and the table in it that stands at a place."""
    scene = copy.deepcopy(SCENE)
    table: Any = scene
    for key in place:
        table = table[key]
    return scene, table


def read(folder: Path, scene: Any) -> Scene:
    file = folder / "scene.json"
    file.write_text(json.dumps(scene))
    return radiosity.load(file)


def test_the_scene_that_is_broken_is_one(tmp_path: Path):
    accept(SCENE)
    assert "floor" in read(tmp_path, SCENE).surfaces


@pytest.mark.parametrize(("place", "key", "value"), WRONG)
def test_the_schema_and_the_reader_refuse_wrong_values(tmp_path: Path, place: list[Any], key: str, value: Any):
    scene, table = broken(place)
    table[key] = value
    assert not validator().is_valid(scene)
    with pytest.raises(Error):
        read(tmp_path, scene)


@pytest.mark.parametrize(
    ("place", "key"), [(FLOOR, "quad"), (BOX, "size"), (WHITE, "reflectance"), (CHAIR, "part"), (["camera"], "target")]
)
def test_what_must_be_there_is_missed(place: list[Any], key: str):
    scene, table = broken(place)
    del table[key]
    assert not validator().is_valid(scene)


@pytest.mark.parametrize("other", [[[[0, 0], [1, 0], [0, 1]]], "a text"])
def test_other_things_are_no_scenes(other: Any):
    assert not validator().is_valid(other)


def lit(extent: Any) -> dict[str, Any]:
    """A scene with one luminaire of this extent: a diameter, two sides, formulas of them, or the word `file`."""
    return SCENE | {"luminaires": [{"position": [0, 0, 1], "point": {}, "flux": 1, "extent": extent}]}


@pytest.mark.parametrize("extent", [0.3, "=half", [1.2, 0], ["=half", 0.3], "file"])
def test_extents_are_lengths_or_that_of_the_file(extent: Any):
    accept(lit(extent))


@pytest.mark.parametrize("extent", [0, -1, [1], [1, -1], [1, 1, 1], "area", True])
def test_other_extents_are_refused(extent: Any):
    assert not validator().is_valid(lit(extent))
