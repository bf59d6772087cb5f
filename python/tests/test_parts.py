"""Scenes made part by part: whatever holds their numbers, they are those of their texts; what is wrong is told by its name."""

from __future__ import annotations

import math
from fractions import Fraction
from typing import Any

import numpy as np
import pytest

from radiosity import Error, Scene

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)


def unaligned(array: np.ndarray) -> np.ndarray:
    """The same numbers at addresses that are no multiples of 8."""
    packed = np.zeros(len(array), np.dtype([("mark", "u1"), ("point", "f8", 3)]))
    packed["point"] = array
    return packed["point"]


def strided(array: np.ndarray) -> np.ndarray:
    """The same numbers, each apart from the next, backwards in memory."""
    spread = np.zeros((2 * len(array), 7))
    spread[::-2, 5::-2] = array
    return spread[::-2, 5::-2]


@pytest.mark.parametrize(
    "held",
    [
        np.asarray,
        np.asfortranarray,
        strided,
        unaligned,
        lambda array: array.astype(">f8"),
        lambda array: array.astype(np.float32),
        lambda array: array.astype(np.int8),
        lambda array: array.astype(object),
        lambda array: array.view(np.ma.MaskedArray),
        lambda array: [tuple(point) for point in array],
        lambda array: array.tolist(),
    ],
)
def test_points_are_the_same_however_they_are_held(held):
    def text(outline: Any) -> str:
        scene = Scene()
        scene.surface("square", None, polygon={"vertices": outline})
        assert scene.surfaces == ["square"]
        return scene.to_toml()

    assert text(held(SQUARE)) == text(SQUARE.tolist())


@pytest.mark.parametrize("half", [0.5, np.float64(0.5), np.float32(0.5), np.longdouble(0.5), np.array(0.5), "=1/2", np.array([0.5]), (0.5,)])
def test_numbers_are_the_same_however_they_are_held(half: Any):
    scene = Scene()
    scene.polygon("square", SQUARE, scene.material("grey", reflectance=half, emission=np.int16(2)), two_sided=np.bool_(True), order=np.uint8(1))
    other = Scene()
    other.polygon("square", SQUARE, other.material("grey", reflectance=0.5, emission=2), two_sided=True, order=1)
    assert np.array_equal(scene.solve().coefficients, other.solve().coefficients)


def test_faces_are_polygons_of_their_own():
    cubes = np.random.default_rng(1).uniform(0, 9, (20, 1, 3)) + SQUARE
    together, apart, listed = Scene(), Scene(), Scene()
    keys = {"flux": 2, "two_sided": True}
    for scene in (together, apart, listed):
        scene.material("grey", reflectance=0.5)
    together.polygons("face", cubes, "grey", **keys)
    listed.polygons("face", list(cubes), "grey", **keys)
    for index, square in enumerate(cubes, 1):
        apart.polygon(f"face-{index}", square, "grey", **keys)
    assert together.surfaces[:4] == ["face-1", "face-1:back", "face-2", "face-2:back"]
    solutions = [scene.solve().coefficients for scene in (together, apart, listed)]
    assert np.array_equal(solutions[0], solutions[1]) and np.array_equal(solutions[0], solutions[2])


def test_triangles_are_those_of_their_vertices():
    mesh, apart = Scene(), Scene()
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    mesh.triangles("half", SQUARE, faces.astype(np.uint8))
    for index, face in enumerate(faces, 1):
        apart.surface(f"half-{index}", None, triangle={"vertices": SQUARE[face]})
    assert mesh.surfaces == apart.surfaces
    assert sorted(mesh.to_toml()) == sorted(apart.to_toml())


def room(**keys: Any) -> Scene:
    scene = Scene(name="room")
    scene.surface("desk", None, polygon={"vertices": SQUARE}, **keys)
    return scene


def itself() -> list[Any]:
    own: list[Any] = []
    own.append(own)
    return own


def deep() -> list[Any]:
    inner: list[Any] = []
    for _ in range(100_000):
        inner = [inner]
    return inner


class Unnamed:
    """Its text cannot be made."""

    def __repr__(self) -> str:
        raise RuntimeError


@pytest.mark.parametrize(
    ("keys", "told"),
    [
        ({"order": object()}, 'surface "desk", order: expected a number, found an object of the class object'),
        ({"order": Unnamed()}, 'surface "desk", order: expected a number, found an object of the class Unnamed'),
        ({"order": Fraction(1, 2)}, 'surface "desk", order: expected a number, found an object of the class Fraction'),
        ({"order": 1 + 2j}, 'surface "desk", order: expected a number, found an object of the class complex'),
        ({"order": np.complex128(1)}, 'surface "desk", order: expected a number, found an object of the class complex128'),
        ({"order": np.array([1j])}, 'surface "desk", order: expected a number, found an array of complex128'),
        ({"order": np.datetime64(1, "s")}, 'surface "desk", order: expected a number, found an object of the class datetime64'),
        ({"order": np.array(1, "m8[s]")}, 'surface "desk", order: expected a number, found an array of timedelta64[s]'),
        ({"order": True}, 'surface "desk", order: expected a number, found true or false'),
        ({"order": b"1"}, 'surface "desk", order: expected a number, found an object of the class bytes'),
        ({"order": math.nan}, 'surface "desk", order: NaN is not a finite number'),
        ({"order": 10**400}, 'surface "desk", order: inf is not a finite number'),
        ({"order": -(10**400)}, 'surface "desk", order: -inf is not a finite number'),
        ({"order": 0.5}, 'surface "desk", order: 0.5 is not a whole number'),
        ({"group": "\ud800"}, 'surface "desk", group: expected a text in quotes, found a text that is no Unicode'),
        ({"transform": {"scale": None}}, 'surface "desk", transform.scale: expected a number, found None'),
        ({"transform": {1: 2}}, 'surface "desk", transform: expected a table, found a dictionary of keys that are no texts'),
        ({"transform": {"turn": 1}}, 'surface "desk", transform: unknown key "turn"'),
        ({"transform": {"translate": [0, 0, "up"]}}, 'surface "desk", transform.translate[2]: expected a number, found a text'),
        ({"transform": {"translate": np.ma.masked_array([1.0, 2, 3], [0, 1, 0])}}, 'surface "desk", transform.translate[1]: expected a number, found None'),
        ({"flux": itself()}, 'surface "desk", flux[0]: expected a number, found a list that is in itself'),
        ({"flux": deep()}, "lists and tables are nested more than 32 deep"),
        ({"disk": {}}, 'surface "desk", disk: two shapes are given'),
        ({"colour": 1}, 'surface "desk": unknown key "colour"'),
        ({"material": "oak"}, 'surface "desk", material: unknown material "oak"'),
    ],
)
def test_what_is_wrong_is_told_by_its_name(keys: dict[str, Any], told: str):
    scene = Scene(name="room")
    scene.surface("desk", keys.pop("material", None), polygon={"vertices": SQUARE}, **keys)
    with pytest.raises(Error) as raised:
        scene.surfaces
    message = str(raised.value).splitlines()[0]
    assert message.startswith(f"room: {told}")
    assert "room:1:" not in message


def test_a_point_is_told_by_its_number():
    scene = Scene()
    outline = SQUARE.copy()
    outline[2, 1] = np.inf
    scene.polygon("desk", outline)
    with pytest.raises(Error, match=r'^scene: surface "desk", polygon\.vertices\[2\]\[1\]: inf is not a finite number'):
        scene.surfaces
    mesh = Scene()
    mesh.polygons("wall", np.array([SQUARE, outline + [0, 0, 1]]))
    with pytest.raises(Error, match=r'^scene: surface "wall-2", polygon\.vertices\[2\]\[1\]: inf'):
        mesh.surfaces


def test_a_key_given_beside_that_of_the_faces_is_refused():
    scene = Scene()
    scene.polygons("wall", SQUARE[None], polygon={"vertices": SQUARE})
    with pytest.raises(Error, match=r'surfaces\[0\]: the key "polygon" stands twice'):
        scene.surfaces


def test_files_that_parts_name_are_read():
    scene = Scene()
    scene.polygon("desk", SQUARE, scene.material("wood", reflectance={"image": "missing.png"}))
    with pytest.raises(Error, match=r'^scene: materials\.wood\.reflectance\.image: "missing\.png" cannot be read'):
        scene.surfaces
