"""Calls with one bad argument: each is refused with a message that names it, or what is wanted; none panics, none ends the process.

    python python/tests/bad_inputs.py        # prints how many were refused

`test_bad_inputs.py` runs this in a process of its own, so that an abort is seen.
"""

from __future__ import annotations

import math
import os
import re
import sys
import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass, field
from types import SimpleNamespace
from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

import radiosity
from radiosity import core, interop

NUMBERS = [math.nan, math.inf, -math.inf, -1, -1.5, -(10**30), 10**30, 1e300, 2.5, 0, 1 + 2j, True]
THINGS = [None, "text", b"bytes", "", object(), {}, {1: 2}, [], [[]], set(), len, radiosity, "\0", "\ud800"]

SQUARE = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]
ABOVE = [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]


def arrays() -> st.SearchStrategy[Any]:
    """Arrays of wrong shapes, kinds and numbers."""
    shapes = st.lists(st.integers(0, 4), min_size=0, max_size=4).map(tuple)
    fills = st.sampled_from([math.nan, math.inf, -math.inf, 1e300, -1e300, 1e-300, 2.0, 0.0, 1e155, 5e-324])
    kinds = st.sampled_from([np.float64, np.float32, np.complex128, object, "U5", "datetime64[s]", bool, np.int8])

    def made(shape: tuple[int, ...], fill: float, kind: Any) -> np.ndarray:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            try:
                return np.full(shape, fill).astype(kind)
            except (ValueError, OverflowError, TypeError):
                return np.full(shape, fill)

    scattered = st.tuples(st.integers(0, 6), st.integers(2, 4), st.randoms(use_true_random=False)).map(
        lambda t: np.array([[t[2].choice([0.0, 1.0, math.nan, math.inf, 1e200, 0.5]) for _ in range(t[1])] for _ in range(t[0])])
    )
    ragged = st.sampled_from([[[0, 0, 0], [1, 0]], [[1, 2, 3], 4], [[[0]], [1]], [SQUARE, SQUARE[:2]], [SQUARE, [[0, 0]]]])
    return st.one_of(st.builds(made, shapes, fills, kinds), scattered, ragged)


ANYTHING = st.one_of(st.sampled_from(NUMBERS), st.sampled_from(THINGS), arrays())


@dataclass
class Call:
    """A function with arguments that it takes, and the words that tell of each bad one."""

    function: Callable[..., Any]
    arguments: dict[str, Any]
    words: dict[str, list[str]] = field(default_factory=dict)

    def given(self) -> dict[str, Any]:
        """Its good arguments; those that are None are left to their usual values."""
        return {name: value for name, value in self.arguments.items() if value is not None}

    def told(self, name: str, message: str) -> bool:
        """Whether a message names the argument, or what it stands for."""
        given = rf"(?<!\w){re.escape(name)}(\[\d+\]|\['.*'\])*( ?[:=]| at | is )"
        named = re.search(given, message) or any(quoted in message for quoted in (f"'{name}'", f'"{name}"'))
        return bool(named) or any(word in message for word in [*self.words.get(name, [])])


def of_faces(points: Any, faces: Any, materials: Any, bands: Any, name: Any, unit: Any = None, by: Any = None) -> list[str]:
    """The surfaces of a mesh of meshio, as that package hands it over."""
    block = SimpleNamespace(type="triangle", data=faces)
    mesh = SimpleNamespace(points=points, cells=[block], cell_data={}, cell_sets={}, field_data={})
    return interop.from_meshio(mesh, materials, bands=bands, unit=unit, name=name, by=by).surfaces


def of_parts(**bad: Any) -> list[str]:
    """A scene of all kinds of parts, one of which has a bad argument: `disk_radius` is `radius` of `disk`."""
    given = {
        "scene_bands": ["grey"],
        "scene_name": "parts",
        "material_name": "grey",
        "material_reflectance": 0.5,
        "material_emission": 1.0,
        "polygon_vertices": SQUARE,
        "polygons_vertices": [ABOVE],
        "triangles_vertices": np.add(SQUARE, [5, 0, 0]),
        "triangles_faces": [[0, 1, 2], [0, 2, 3]],
        "disk_center": [0.0, 5.0, 0.0],
        "disk_normal": [0.0, 0.0, 1.0],
        "disk_radius": 1.0,
        "sphere_center": [0.0, 9.0, 0.0],
        "cylinder_axis": [0.0, 0.0, 1.0],
        "plane_spacing": 0.1,
        "plane_u": [1.0, 0.0, 0.0],
        "camera_eye": [0.0, 0.0, 9.0],
        **bad,
    }
    scene = radiosity.Scene(given["scene_bands"], name=given["scene_name"])
    grey = scene.material(given["material_name"], given["material_reflectance"], given["material_emission"])
    scene.polygon("polygon", given["polygon_vertices"], grey)
    scene.polygons("polygons", given["polygons_vertices"], grey)
    scene.triangles("triangles", given["triangles_vertices"], given["triangles_faces"], grey)
    scene.disk("disk", grey, center=given["disk_center"], normal=given["disk_normal"], radius=given["disk_radius"])
    scene.sphere("sphere", grey, center=given["sphere_center"], radius=1.0)
    scene.cylinder("cylinder", grey, base=[0, 13, 0], axis=given["cylinder_axis"], radius=0.5)
    scene.plane("plane", origin=[0, 0, 0.5], u=given["plane_u"], v=[0, 1, 0], spacing=given["plane_spacing"])
    scene.camera(eye=given["camera_eye"], target=[0.5, 0.5, 0])
    return scene.surfaces


PARTS = {
    "scene_bands": ["band"],
    "scene_name": ["name"],
    "material_name": ["material", "name"],
    "material_reflectance": ["reflectance"],
    "material_emission": ["emission"],
    "polygon_vertices": ["vertices", "polygon"],
    "polygons_vertices": ["polygons", "vertices"],
    "triangles_vertices": ["vertices", "triangle"],
    "triangles_faces": ["faces", "triangle"],
    "disk_center": ["center", "disk"],
    "disk_normal": ["normal", "disk"],
    "disk_radius": ["radius", "disk"],
    "sphere_center": ["center", "sphere"],
    "cylinder_axis": ["axis", "cylinder"],
    "plane_spacing": ["spacing"],
    "plane_u": ["u:", "edges", "plane"],
    "camera_eye": ["eye", "camera"],
}

SMALL = radiosity.load("parallel-squares")
LIGHT = SMALL.solve(progress=False)
STAGE = radiosity.Stage(radiosity.load("sliding-light"), order=0)
FOLDER = tempfile.TemporaryDirectory()
SAVED = os.path.join(FOLDER.name, "light.json")
LIGHT.save(SAVED)
POINT = {"points": [[0.5, 0.5, 0.5]], "normals": [[0.0, 0.0, 1.0]]}
OPTIONS = {
    "quality": "quick",
    "order": 1,
    "accuracy": None,
    "time_limit": None,
    "tensor": False,
    "subdivide": 1,
    "layers": 0,
    "ratio": None,
    "eps": 1e-2,
    "kernel": None,
    "transport": None,
    "solver": "cholesky",
    "tolerance": None,
    "max_iterations": None,
    "shadows": None,
    "direct": None,
    "shadow_eps": 1e-2,
    "memory": None,
    "threads": 1,
    "aim": None,
    "no_such_option": None,
}
TRANSFERS = {"eps": 1e-2, "shadow_eps": None, "shadows": None, "threads": 1, "subdivide": None, "no_such_option": None}

CALLS = [
    Call(core.roots_legendre, {"n": 3}),
    Call(core.legendre_asymptotic, {"n": 300}),
    Call(core.roots_jacobi, {"n": 3, "alpha": 0.5, "beta": 0.0}),
    Call(core.triangle_rule, {"n": 3}),
    Call(core.eval_legendre, {"n": 3, "x": 0.5}),
    Call(
        core.eval_jacobi,
        {"n": 3, "alpha": 0.5, "beta": 0.0, "x": [0.5, 0.2]},
        {name: ["shapes", "P_n"] for name in ("n", "alpha", "beta", "x")},
    ),
    Call(core.orthonormal_legendre, {"n": 3, "x": 0.5}),
    Call(core.orthonormal_jacobi, {"n": 3, "alpha": 0.5, "beta": 0.0, "x": 0.5}),
    Call(core.legendre_sum, {"coefficients": [1.0, 2.0], "x": 0.5}),
    Call(core.jacobi_to_legendre, {"coefficients": [1.0, 2.0], "alpha": 0, "beta": 2}),
    Call(core.orthonormal_square, {"order": 3, "points": [[0.1, 0.2]]}),
    Call(core.orthonormal_triangle, {"order": 3, "points": [[-0.1, -0.2]]}),
    Call(
        radiosity.load, {"source": "furnace-cube", "set": {"reflectance": 0.5}, "frame": None, "unit": None}, {"source": ["scene"]}
    ),
    Call(radiosity.Scene.from_toml, {"text": SMALL.to_toml(), "name": "text"}, {"text": ["scene", "text"]}),
    Call(of_parts, dict.fromkeys(PARTS), PARTS),
    Call(SMALL.solve, OPTIONS, {"accuracy": ["aim"], "aim": ["points"]}),
    Call(LIGHT.irradiance, {**POINT, "read": None, "read_by": None, "read_eps": None, "threads": None}, {"points": ["normals"]}),
    Call(
        LIGHT.plane,
        {"name_or_origin": [0.2, 0.2, 0.5], "u": [0.5, 0, 0], "v": [0, 0.5, 0], "spacing": 0.25},
        {name: ["edge", "plane", "origin", "sensors"] for name in ("name_or_origin", "u", "v", "spacing")},
    ),
    Call(LIGHT.grid, {"cells": (2, 2), "read": "basis"}),
    Call(LIGHT.render, {"camera": None, "size": (4, 3), "read": "basis", "samples": 1}),
    Call(LIGHT.relight, {"factors": {}}),
    Call(STAGE.move_to, {"mover": "lamp", "translate": [0.0, 0.0, 0.0], "rotate": None}, {"mover": ["motion"], "translate": ["number"]}),
    Call(STAGE.emit, {"mover": "lamp", "factors": 0.5}, {"mover": ["motion"]}),
    Call(radiosity.view_factors, {"of": [SQUARE, ABOVE], **TRANSFERS}, {"of": ["polygons"]}),
    Call(
        radiosity.view_factor,
        {"a": SQUARE, "b": ABOVE, "blockers": [], **TRANSFERS},
        {"a": ["a[", "polygons"], "b": ["b["], "blockers": ["blockers["]},
    ),
    Call(radiosity.load("oven").heat, {**TRANSFERS, "order": 0, "transport": None, "memory": None, "conductances": False}),
    Call(radiosity.load_solution, {"path": SAVED, "set": None}, {"path": ["file", "solution", "scene"]}),
    Call(
        of_faces,
        {
            "points": SQUARE,
            "faces": [[0, 1, 2], [0, 2, 3]],
            "materials": {"reflectance": 0.5},
            "bands": ["grey"],
            "unit": None,
            "name": "mesh",
            "by": None,
        },
        {"points": ["vertices", "faces"], "materials": ["reflectance", "material"], "bands": ["band"], "faces": ["face"]},
    ),
]


@st.composite
def cases(draw: st.DrawFn) -> tuple[Call, str, Any]:
    """A call, the argument that is bad, and its value."""
    call = draw(st.sampled_from(CALLS))
    name = draw(st.sampled_from(sorted(call.arguments)))
    return call, name, draw(ANYTHING)


REFUSED: dict[str, int] = {}


def attempt(call: Call, name: str, value: Any) -> None:
    """Makes the call; what is raised has to be one of four exceptions and to tell of the argument."""
    title = getattr(call.function, "__qualname__", repr(call.function))
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            call.function(**{**call.given(), name: value})
    except (radiosity.Error, OSError, ValueError, TypeError) as error:
        REFUSED[title] = REFUSED.get(title, 0) + 1
        assert call.told(name, str(error)), f"{title}({name}={value!r}) says only: {type(error).__name__}: {error}"
    except BaseException as error:
        raise AssertionError(f"{title}({name}={value!r}) raises {type(error).__name__}: {error}") from error


def search(examples: int) -> None:
    """Makes so many calls."""
    limits = settings(
        max_examples=examples,
        deadline=None,
        database=None,
        derandomize=True,
        phases=[Phase.generate, Phase.shrink],
        suppress_health_check=list(HealthCheck),
    )

    @limits
    @given(cases())
    def run(case: tuple[Call, str, Any]) -> None:
        attempt(*case)

    run()


if __name__ == "__main__":
    search(int(sys.argv[1]) if len(sys.argv) > 1 else 2000)
    for title, count in sorted(REFUSED.items()):
        print(f"{count:5} {title}")
    print(sum(REFUSED.values()), "refused")
