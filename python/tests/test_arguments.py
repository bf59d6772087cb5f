"""What is given is checked before the work: names, kinds of numbers, shapes; arrays of any layout are read alike."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import radiosity
from radiosity import Error, RadiosityWarning, Scene

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
ABOVE = SQUARE[::-1] + [0, 0, 1]
POINTS = np.array([[0.5, 0.5, 0.5], [0.2, 0.7, 0.1], [0.9, 0.1, 0.3]])


@pytest.fixture(scope="module")
def light() -> radiosity.Solution:
    return radiosity.load("furnace-cube").solve(progress=False)


@pytest.mark.parametrize(
    ("function", "call"),
    [
        ("render", lambda light: light.render(size=(4, 4), smaples=9)),
        ("grid", lambda light: light.grid((2, 2), smaples=9)),
        ("plane", lambda light: light.plane([0.2, 0.2, 0.5], [0.5, 0, 0], [0, 0.5, 0], 0.5, smaples=9)),
        ("irradiance", lambda light: light.irradiance(POINTS, [0, 0, 1], smaples=9)),
        ("^view_factors", lambda light: radiosity.view_factors([SQUARE, ABOVE], smaples=9)),
        ("^view_factor", lambda light: radiosity.view_factor(SQUARE, ABOVE, smaples=9)),
    ],
)
def test_unknown_arguments_are_told_with_their_function(light, function: str, call):
    with pytest.raises(TypeError, match=rf"{function}\(\) got an unexpected keyword argument 'smaples'"):
        call(light)


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda light: light.render(size=(None, 4)), r"size\[0\]=None: expected a whole number"),
        (lambda light: light.grid((None, 2)), r"cells\[0\]=None: expected a whole number"),
        (lambda light: light.irradiance(POINTS.astype(str), [0, 0, 1]), "points: real numbers are wanted, not <U"),
        (lambda light: light.irradiance(POINTS, ["0", "0", "1"]), "normals: real numbers are wanted, not <U"),
        (lambda light: light.irradiance(POINTS + 1j, [0, 0, 1]), "points: real numbers are wanted, not complex"),
        (lambda light: light.plane(["0", "0", "1"], [1, 0, 0], [0, 1, 0], 0.5), "origin: real numbers are wanted"),
        (lambda light: radiosity.view_factors([SQUARE.astype("U8"), ABOVE]), r"polygons\[0\]: real numbers are wanted"),
        (lambda light: radiosity.view_factor(SQUARE, ABOVE, blockers="abc"), "blockers: no array"),
        (lambda light: radiosity.view_factor(SQUARE, ABOVE, blockers=SQUARE), r"blockers: an array of shape \(4, 3\)"),
        (lambda light: radiosity.view_factor(SQUARE, ABOVE[:2]), "^b: "),
        (lambda light: radiosity.view_factors([]), "polygons: there are none"),
        (lambda light: radiosity.load("parallel-squares", set={"distance": "0.5"}), r"set\['distance'\]: a number is wanted, not str"),
        (lambda light: light.render({"eye": [0, 0, 0], "target": [1, 1, 1], "fov": "40"}), "fov: a number is wanted, not str"),
        (lambda light: light.render({"eye": [0, 0, 0]}), "camera: the keys 'eye'\nhelp: give eye and target"),
        (lambda light: radiosity.load("room.obj", materials=5), "materials=5: expected a path"),
        (lambda light: radiosity.load("-"), "source: '-' is no file"),
        (lambda light: radiosity.load_solution("-"), "path: '-' is no file"),
        (lambda light: light.grid((2, 2), memory="much"), "memory='much' cannot be\nhelp: expected a number of bytes"),
        (lambda light: light.save("light.csv"), "the ending .csv is none of .json and .vtu"),
        (lambda light: radiosity.view_factors(light.scene, pairs=["floor"]), r"pairs\[0\]: the names of two surfaces are wanted"),
        (lambda light: radiosity.view_factors(light.scene, pairs=[("flor", "roof")]), 'unknown surface "flor"'),
        (lambda light: pickle.dumps(light), r"write it with save\(path\)"),
    ],
)
def test_other_kinds_and_shapes_are_refused(light, call, told: str):
    with pytest.raises((Error, TypeError), match=told):
        call(light)


def test_progress_is_checked_before_the_work():
    with pytest.raises(TypeError, match="progress=1: True, False, None or a function"):
        radiosity.load("furnace-cube").solve(progress=1, colour="red")


@pytest.mark.parametrize(
    "other",
    [
        lambda array: array.astype(">f8"),
        lambda array: array.astype(np.float32).astype(">f4"),
        lambda array: np.asfortranarray(array),
        lambda array: np.repeat(array, 2, axis=0)[::2],
        lambda array: array[::-1][::-1],
        lambda array: array.tolist(),
        lambda array: np.ma.masked_array(array),
    ],
)
def test_arrays_of_any_layout_are_read_alike(light, other):
    points = POINTS.astype(np.float32).astype(float)
    given = other(points)
    assert np.array_equal(light.irradiance(given, [0, 0, 1]), light.irradiance(points, [0, 0, 1]))
    corners = other(np.stack([SQUARE, ABOVE]))
    assert np.array_equal(radiosity.view_factors(corners).matrix, radiosity.view_factors([SQUARE, ABOVE]).matrix)


def test_arrays_that_are_read_only_are_taken_and_stay(light):
    points = POINTS.copy()
    points.flags.writeable = False
    light.irradiance(points, [0, 0, 1])
    assert np.array_equal(points, POINTS)


def test_masked_entries_are_refused(light):
    masked = np.ma.masked_array(POINTS, mask=POINTS > 0.8)
    with pytest.raises(Error, match="points: entries are masked"):
        light.irradiance(masked, [0, 0, 1])
    with pytest.raises(Error, match="polygons.*: entries are masked"):
        radiosity.view_factors(np.ma.masked_array(np.stack([SQUARE, ABOVE]), mask=np.stack([SQUARE, ABOVE]) > 0.8))


def test_whole_numbers_may_be_floats_and_bytes_may_be_texts(light):
    assert light.grid((2.0, np.int64(2)), memory="1G")["area"].shape == (24,)
    assert light.grid((2, 2), memory=8e9)["area"].shape == (24,)
    with pytest.raises(TypeError, match="expected a whole number"):
        light.grid((2.5, 2))


def test_one_normal_serves_for_all_points():
    scene = radiosity.load("furnace-cube")
    one, all_of_them = (
        scene.solve(accuracy=0.1, aim=("points", POINTS, normals), progress=False) for normals in ([0, 0, 1], [[0, 0, 1]] * 3)
    )
    assert np.array_equal(one.coefficients, all_of_them.coefficients)


def test_parts_that_a_scene_has_one_of_are_given_once():
    scene = Scene(bands=np.array(["red", "blue"]))
    edges = {"origin": [0, 0, 0], "u": [1, 0, 0], "v": [0, 1, 0], "spacing": 0.5}
    scene.plane("desk", **edges)
    with pytest.raises(Error, match="plane 'desk' is given twice"):
        scene.plane("desk", **{**edges, "spacing": 0.1})
    with pytest.raises(TypeError, match="plane: a text is wanted, not int"):
        scene.plane(5, **edges)
    scene.camera(eye=[0, 0, 9], target=[0, 0, 0])
    with pytest.raises(Error, match="a second camera"):
        scene.camera(eye=[0, 0, 5], target=[0, 0, 0])
    scene.sky(model="overcast", illuminance=10000)
    with pytest.raises(Error, match="a second sky"):
        scene.sky(model="clear", illuminance=10000)


def test_scenes_are_copied_by_their_text(light):
    for copied in (copy.deepcopy(light.scene), pickle.loads(pickle.dumps(light.scene))):
        assert np.array_equal(copied.solve(progress=False).coefficients, light.coefficients)
    open_scene = Scene(name="room", title="A room")
    copied = copy.deepcopy(open_scene)
    for scene in (open_scene, copied):
        scene.polygon("floor", SQUARE, scene.material("grey", 0.5, emission=1))
        assert (scene.name, scene.title, scene.surfaces) == ("room", "A room", ["floor"])


def test_planes_are_arrays(light):
    plane = light.plane([0.2, 0.2, 0.5], [0.5, 0, 0], [0, 0.5, 0], 0.25)
    assert np.array_equal(np.asarray(plane), plane.values)
    assert len(plane) == len(plane.values)


def test_row_sums_above_one_are_told():
    roofs = [ABOVE + [0, 0, height - 1] for height in (0.1, 0.2)]
    # Without shadows the floor sees the roof behind the other one: 0.83 + 0.69 in closed form.
    with pytest.warns(RadiosityWarning, match="sends .* % more than it has: lower eps=; .* leave shadows=\"off\" out"):
        factors = radiosity.view_factors([SQUARE, *roofs], shadows="off")
    assert factors.row_sums[0] == pytest.approx(1.517, abs=2e-3)
    assert radiosity.view_factors(radiosity.load("oven")).is_closed
    assert radiosity.view_factors([SQUARE, ABOVE]).is_closed is False
    assert radiosity.view_factors([SQUARE, ABOVE], eps=0.9).is_closed is None


def test_pairs_are_computed_alone():
    oven = radiosity.load("oven")
    every, some = radiosity.view_factors(oven), radiosity.view_factors(oven, pairs=[("slab", "panel"), ("roof", "slab")])
    index = every.names.index
    wanted = np.zeros_like(every.matrix, bool)
    wanted[index("slab"), index("panel")] = wanted[index("roof"), index("slab")] = True
    assert np.array_equal(some.matrix[wanted], every.matrix[wanted])
    assert np.isnan(some.matrix[~wanted]).all()
    assert np.isnan(some.row_sums).all() and some.is_closed is None


def test_corners_that_nearly_meet_are_told():
    polygons = [SQUARE, SQUARE[:, [0, 2, 1]][::-1] + [0, 1e-9, 0]]
    assert any("welded" in remark for remark in radiosity.view_factors(polygons).remarks)
    scene = Scene()
    scene.polygons("wall", polygons, scene.material("grey", 0.5, emission=1))
    assert scene.remarks == radiosity.view_factors(polygons).remarks


def test_a_loaded_solution_that_did_not_converge_is_told(tmp_path):
    told = pytest.warns(RadiosityWarning, match="did not converge")
    with told:
        partial = radiosity.load("empty-box").solve(solver="gauss-seidel", max_iterations=1, keep_partial=True, progress=False)
    partial.save(tmp_path / "partial.json")
    with pytest.warns(RadiosityWarning, match="did not converge"):
        radiosity.load_solution(tmp_path / "partial.json")
    with pytest.warns(RadiosityWarning, match="did not converge"):
        partial.relight({})
