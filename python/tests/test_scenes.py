"""Scenes that are read and scenes of arrays: what they hold, and what is refused with which words."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import radiosity
from radiosity import Error, RadiosityWarning, Scene

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)


def lit(**lamp) -> Scene:
    scene = Scene(bands=["lm"], unit="lx", name="desk")
    wood = scene.material("wood", reflectance=0.4)
    glow = scene.material("glow", reflectance=0, emission=np.float64(1000), **lamp)
    scene.polygon("desk", SQUARE, wood)
    scene.disk("lamp", glow, center=[0.5, 0.5, 1], normal=[0, 0, -1], radius=0.2)
    return scene


def test_scenes_of_arrays_are_those_of_files(tmp_path: Path):
    text = """
        bands = ["lm"]
        unit = "lx"
        materials.wood = { reflectance = 0.4 }
        materials.glow = { reflectance = 0, emission = 1000 }
        surfaces = [
            { name = "desk", material = "wood", polygon = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] } },
            { name = "lamp", material = "glow", disk = { center = [0.5, 0.5, 1], normal = [0, 0, -1], radius = 0.2 } },
        ]
    """
    scene = lit()
    solution = scene.solve()
    assert np.array_equal(solution.coefficients, Scene.from_toml(text).solve().coefficients)
    assert np.array_equal(solution.coefficients, Scene.from_toml(scene.to_toml()).solve().coefficients)
    solution.save(tmp_path / "desk.json")
    assert np.array_equal(radiosity.load_solution(tmp_path / "desk.json").coefficients, solution.coefficients)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["desk.json"], "nothing else is left"
    assert (scene.bands, scene.unit, scene.surfaces) == (["lm"], "lx", ["desk", "lamp"])
    assert solution.scene.surfaces == scene.surfaces
    assert [name for name, _ in solution.elements][0] == "desk"


def test_light_groups_are_dimmed_in_proportion():
    solution = lit(group="lamps").solve()
    dim = solution.relight({"lamps": 0.5})
    assert np.array_equal(dim.coefficients, 0.5 * solution.coefficients)
    assert dim.scene.light_groups == {"lamps": 0.5}
    with pytest.raises(Error, match="lamp"):
        solution.relight({"lamp": 1})


def test_meshes_are_triangles():
    mesh = Scene()
    mesh.triangles("mesh", SQUARE, np.array([[0, 1, 2], [0, 2, 3]]))
    assert mesh.surfaces == ["mesh-1", "mesh-2"]
    assert radiosity.view_factors(mesh).areas == pytest.approx([0.5, 0.5])
    for faces, told in [([[0, 1, 4]], "indices from 0 to 4, of 4"), ([[0, 1]], r"\(f, 3\)"), ([[0.5, 1, 2]], "whole")]:
        with pytest.raises(Error, match=told):
            Scene().triangles("mesh", SQUARE, faces)


def test_built_in_scenes_have_parameters():
    assert radiosity.builtins()["parallel-squares"]["distance"] == 1
    assert radiosity.load("parallel-squares", set={"distance": 2}).surfaces


@pytest.mark.parametrize(
    ("work", "told"),
    [
        (lambda: radiosity.load("nowhere"), r'unknown scene "nowhere"\nhelp: built-in scenes'),
        (lambda: radiosity.load("cornell-box", set={"depth": 2}), "depth"),
        (lambda: radiosity.load("cornell-box", unit="mm"), "unit=: cornell-box is not known for a scene of another program"),
        (lambda: Scene.from_toml('bands = ["a"]\nmaterials.a = { reflectance = 1.2 }\nsurfaces = []'), r"2 \| .*1.2"),
        (lambda: lit().solve(eps=2), r"eps=2 cannot be\nhelp: expected a number from 1e-14"),
        (lambda: lit().solve(order=99), "order=99 cannot be\nhelp: expected a whole number from 0 to 20, or auto"),
        (lambda: lit().solve(solver="luck"), 'no method is called "luck"'),
        (lambda: lit().solve(shadows="long"), "expected one of `auto`, `off`, `rays`, `exact`, `mask`"),
        (lambda: lit().solve(rays=100, transport="exact"), r'rays= does not go with transport="exact"'),
        (lambda: lit().solve(method="hierarchical", order=3), r'method="hierarchical" knows no order= above 0'),
        (lambda: lit().solve(memory=1000), "not enough memory(.|\n)*memory="),
        (lambda: lit().solve(aim="luck", accuracy=0.1), "aim="),
        (lambda: lit().solve(threads=0), "threads=0"),
        (lambda: radiosity.load("cornell-box").solve(solver="gauss-seidel", max_iterations=1), "max_iterations="),
        (lambda: lit().solve().irradiance([[0, 0, 0]], [[0, 0, 0]]), r"normals\[0\]: the normal is zero"),
        (lambda: lit().solve().irradiance([0, 0, 0], [0, 0, 1]), r"points: an array of shape \(3,\) instead of \(n, 3\)"),
        (lambda: lit().solve().irradiance([[0, 0]], [0, 0, 1]), r"points: an array of shape \(1, 2\) instead of \(n, 3\)"),
        (lambda: lit().solve().irradiance([[0, 0, np.nan]], [0, 0, 1]), r"points\[0\]: not finite"),
        (lambda: lit().solve().plane("desk"), r'"desk"(.|\n)*or type it: plane\(origin, u, v, spacing\)'),
        (lambda: lit().solve(solver="lu", preconditioner="none"), r'take solver="cg" or "gmres", or leave preconditioner= out'),
        (lambda: lit().solve().plane([0, 0, 0], [1, 0, 0], [2, 0, 0], 0.1), "parallel"),
        (lambda: lit().heat(), "heat"),
        (lambda: Scene().solve(), "surface"),
        (lambda: radiosity.view_factors(np.zeros((3, 4))), r"polygons: an array of shape \(3, 4\) instead of \(n, k, 3\)"),
        (lambda: radiosity.view_factors([SQUARE, SQUARE[:2]]), r"polygons\[1\]"),
        (lambda: radiosity.view_factor(SQUARE, SQUARE + [0, 0, 1], shadows="mask"), "mask"),
        (lambda: radiosity.load_solution("cornell-box"), "this is no solution"),
    ],
)
def test_what_is_wrong_is_told_with_its_cure(work, told: str):
    with pytest.raises(Error, match=told):
        work()
    assert issubclass(Error, ValueError)


@pytest.mark.parametrize(
    "work",
    [
        lambda: lit().solve(colour="red"),
        lambda: lit().solve(eps="small"),
        lambda: lit().solve(threads=1.5),
        lambda: lit().solve().irradiance([[0, 0, 1]], [0, 0, 1], samples=3),
        lambda: radiosity.view_factors(lit(), order=3),
        lambda: radiosity.load("oven").heat(accuracy=1e-2),
        lambda: radiosity.load("cornell-box", units="mm"),
    ],
)
def test_unknown_arguments_and_other_types_are_type_errors(work):
    with pytest.raises(TypeError):
        work()


def test_files_that_cannot_be_read_are_told_as_python_tells_them(tmp_path: Path):
    for read in (radiosity.load, radiosity.load_solution):
        with pytest.raises(FileNotFoundError, match="missing.toml: cannot be read(.|\n)*help: check the path"):
            read(tmp_path / "missing.toml")
        with pytest.raises(IsADirectoryError):
            read(tmp_path)


def test_files_that_cannot_be_written_leave_nothing(tmp_path: Path):
    solution = lit().solve()
    with pytest.raises(OSError):
        solution.save(tmp_path / "missing" / "desk.json")
    with pytest.raises(Error, match="bounces="):
        lit().solve(bounces=1).save(tmp_path / "desk.json")
    assert not list(tmp_path.iterdir())


def test_what_was_not_reached_is_told():
    with pytest.warns(RadiosityWarning, match="more than asked for"):
        radiosity.load("cornell-box").solve(accuracy=1e-9, time_limit=1e-3)


def test_scenes_in_use_take_no_more_parts():
    scene = lit()
    scene.surfaces
    with pytest.raises(Error, match="takes no more materials"):
        scene.material("late", reflectance=0)
    with pytest.raises(Error, match="given twice"):
        twice = Scene()
        twice.material("a", reflectance=0)
        twice.material("a", reflectance=0)


def test_files_outside_the_folder_of_a_scene_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    room = tmp_path / "room"
    room.mkdir()
    (tmp_path / "white.toml").write_text("materials.white = { reflectance = 0.5, emission = 1 }")
    surface = 'surfaces = [{ name = "a", material = "white", sphere = { center = [0, 0, 0], radius = 1 } }]'
    monkeypatch.chdir(room)
    for path in ["../white.toml", str(tmp_path / "white.toml")]:
        text = f'include = "{path}"\n{surface}'
        (room / "room.toml").write_text(text)
        for read in [lambda: radiosity.load("room.toml"), lambda text=text: Scene.from_toml(text)]:
            with pytest.raises(Error, match="outside the folder of the scene") as refused:
                read()
            assert f'include: "{path}"' in str(refused.value)
            assert "put a copy of it into the folder of the scene" in str(refused.value)
    (room / "white.toml").write_text((tmp_path / "white.toml").read_text())
    assert Scene.from_toml(f'include = "white.toml"\n{surface}').surfaces == ["a"]
