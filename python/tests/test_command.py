"""The package computes what the command computes, to the last bit."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
import scipy.sparse

import radiosity

OPTIONS = [
    ("cornell-box", {"quality": "quick"}, ["--quality", "quick"]),
    ("cornell-box", {"order": 1, "eps": 1e-2, "shadow_eps": 0.1}, ["--order", "1", "--eps", "1e-2", "--shadow-eps", "0.1"]),
    ("empty-box", {"tensor": True, "order": 2, "layers": 1, "ratio": 0.3}, ["--tensor", "--order", "2", "--layers", "1", "--ratio", "0.3"]),
    ("two-boxes", {"method": "hierarchical", "eps": 3e-2}, ["--method", "hierarchical", "--eps", "3e-2"]),
    ("empty-box", {"method": "hierarchical", "eps": 0.1, "link_measure": "form-factor", "least_area": 1e-2, "link_rays": 4}, ["--method", "hierarchical", "--eps", "0.1", "--link-measure", "form-factor", "--least-area", "1e-2", "--link-rays", "4"]),
    ("two-boxes", {"transport": "sampled", "rays": 100_000}, ["--transport", "sampled", "--rays", "100000"]),
    ("empty-box", {"basis": "linear", "subdivide": 4}, ["--basis", "linear", "--subdivide", "4"]),
    ("occluder-box", {"shadows": "mask", "mask_cells": 9, "order": 1}, ["--shadows", "mask", "--mask-cells", "9", "--order", "1"]),
    ("parallel-squares", {"accuracy": 3e-2, "aim": "solution"}, ["--accuracy", "3e-2", "--for", "solution"]),
    ("empty-box", {"solver": "gmres", "preconditioner": "none", "tolerance": 1e-5}, ["--solver", "gmres", "--preconditioner", "none", "--tolerance", "1e-5"]),
]


def times_left_out(document: dict) -> dict:
    """A report or a solution without what differs between two runs: times and memory."""
    document = {key: value for key, value in document.items() if key not in ("seconds", "peak_bytes")}
    return document


@pytest.mark.filterwarnings("ignore::radiosity.RadiosityWarning")
@pytest.mark.parametrize(("scene", "given", "typed"), OPTIONS)
def test_solutions_and_reports_are_those_of_the_command(command, tmp_path: Path, scene, given, typed):
    command("solve", scene, *typed, "-o", "a.json", "--report", "r.json", "-q")
    solution = radiosity.load(scene).solve(**given, progress=False)
    solution.save(tmp_path / "b.json")
    theirs, ours = (json.loads((tmp_path / name).read_text()) for name in ("a.json", "b.json"))
    assert times_left_out(ours) == times_left_out(theirs)
    report = json.loads((tmp_path / "r.json").read_text())
    assert times_left_out(solution.report) == times_left_out(report)
    assert solution.error == report["accuracy_estimate"]
    assert (solution.error is not None) == ("accuracy" in given)
    assert solution.coefficients.shape == (len(report["bands"]), sum(count for _, count in solution.elements))


POINTS = np.array([[278.0, 100.0, 200.0], [50.0, 300.0, 400.0], [278.0, 0.0, 279.0]])
NORMALS = np.array([[0.0, 1.0, 0.0], [1.0, 2.0, -3.0], [0.0, 5.0, 0.0]])


def check_of(report: dict) -> dict:
    """What a report of the command says of its check, beside which Python has the line."""
    return {key: report[key] for key in ("error", "error_sd", "visible", "own_error", "error_factor", "audit")}


def without_line(checked: dict) -> dict:
    return {key: value for key, value in checked.items() if key != "line"}


@pytest.mark.parametrize(
    ("given", "typed"),
    [
        ({}, []),
        ({"read_by": "rays", "read_eps": 1e-2}, ["--read-by", "rays", "--read-eps", "1e-2"]),
        ({"read": "gather-twice"}, ["--read", "gather-twice"]),
    ],
)
def test_readings_at_points_are_those_of_the_command(command, tmp_path: Path, given, typed):
    lines = [",".join(map(repr, [*point, *normal])) for point, normal in zip(POINTS.tolist(), NORMALS.tolist())]
    (tmp_path / "points.csv").write_text("\n".join(lines))
    quick = ["--quality", "quick"]
    options = ["--format", "json", "--report", "r.json", "-q", *quick, *typed]
    table = json.loads(command("probe", "cornell-box", "--points", "points.csv", *options))
    solution = radiosity.load("cornell-box").solve(quality="quick", progress=False)
    irradiance, errors, checked = solution.irradiance(POINTS, NORMALS, errors=True, **given)
    assert irradiance.tolist() == [row["irradiance"] for row in table["points"]]
    assert errors.tolist() == [row["error"] for row in table["points"]]
    assert without_line(checked) == check_of(json.loads((tmp_path / "r.json").read_text()))
    assert solution.irradiance(POINTS, NORMALS, **given).tolist() == irradiance.tolist()


def test_polynomials_are_read_as_by_the_command(command, tmp_path: Path):
    (tmp_path / "points.csv").write_text("0.25,0.5,0,0,0,1")
    table = json.loads(command("probe", "furnace-cube", "--points", "points.csv", "--format", "json", "-q", "--read", "basis"))
    solution = radiosity.load("furnace-cube").solve()
    assert solution.irradiance([[0.25, 0.5, 0]], [0, 0, 1], read="basis").tolist() == [table["points"][0]["irradiance"]]
    with pytest.raises(radiosity.Error, match=r"points\[0\]: the point lies on no surface(.|\n)*read=\"gather\""):
        solution.irradiance([[0.25, 0.5, 0.5]], [0, 0, 1], read="basis")


def test_planes_are_those_of_the_command(command, tmp_path: Path):
    typed = "50,170,50; 0,0,450; 450,0,0; 90"
    quick = ["--quality", "quick"]
    table = command("probe", "cornell-box", "--plane", typed, "--format", "json", "--report", "r.json", "-q", *quick)
    rows = json.loads(table)["points"]
    solution = radiosity.load("cornell-box").solve(quality="quick")
    plane = solution.plane((50, 170, 50), (0, 0, 450), (450, 0, 0), 90)
    assert plane.values.reshape(-1, 3).tolist() == [row["irradiance"] for row in rows]
    assert plane.points.reshape(-1, 3).tolist() == [row["position"] for row in rows]
    (figures,) = json.loads((tmp_path / "r.json").read_text())["planes"]
    for key in ("mean", "min", "max", "u0", "ud"):
        assert getattr(plane, key).tolist() == [band[key] for band in figures["bands"]]
    # Those within the taller block.
    assert (plane.left_out, plane.dark) == (figures["left_out"], figures["dark"])
    assert plane.left_out > 0
    assert plane.error.ravel().tolist() == [row["error"] for row in rows]
    assert plane.mean_error == figures["error"]
    told, theirs = without_line(plane.checked), check_of(json.loads((tmp_path / "r.json").read_text()))
    assert told == theirs


@pytest.mark.parametrize(
    ("given", "typed"),
    [
        ({}, []),
        ({"read_samples": (3, 1), "memory": "1G"}, ["--read-samples", "3,1", "--memory", "1G"]),
        ({"read_by": "rays"}, ["--read-by", "rays"]),
    ],
)
def test_cells_are_those_of_the_command(command, tmp_path: Path, given, typed):
    typed = ["--cells", "3x2", "--format", "json", "-q", "--quality", "quick", "--report", "r.json", *typed]
    rows = json.loads(command("grid", "occluder-box", *typed))["cells"]
    grid = radiosity.load("occluder-box").solve(quality="quick").grid((3, 2), **given)
    assert grid["error"].tolist() == [row["error"] for row in rows]
    assert without_line(grid["checked"]) == check_of(json.loads((tmp_path / "r.json").read_text()))
    for key in ("irradiance", "radiosity", "area", "position"):
        assert grid[key].tolist() == [row[key] for row in rows]
    assert grid["surface"].tolist() == [row["surface"] for row in rows]
    assert grid["index"].tolist() == [[row["i"], row["j"]] for row in rows]


@pytest.mark.parametrize(("given", "typed"), [({}, []), ({"read": "direct", "samples": 2}, ["--read", "direct", "--samples", "2"])])
def test_pictures_are_those_of_the_command(command, tmp_path: Path, given, typed):
    command("render", "cornell-box", "-o", "box.exr", "--size", "40x30", "-q", "--quality", "quick", *typed)
    picture = radiosity.load("cornell-box").solve(quality="quick").render(size=(40, 30), **given)
    assert picture.shape == (30, 40, 3)
    with OpenEXR.File(str(tmp_path / "box.exr"), separate_channels=True) as file:
        channels = [file.channels()[name].pixels for name in "RGB"]
    assert np.array_equal(picture.astype(np.float32), np.stack(channels, axis=-1))


def test_view_factors_are_those_of_the_command(command, tmp_path: Path):
    command("view-factors", "cornell-box", "--eps", "1e-2", "-o", "F.npz", "-q")
    factors = radiosity.view_factors(radiosity.load("cornell-box"), eps=1e-2)
    theirs = np.load(tmp_path / "F.npz")
    assert np.array_equal(factors.matrix, theirs["F"])
    assert np.array_equal(factors.areas, theirs["areas"])
    assert factors.names == theirs["names"].tolist()
    command("view-factors", "cornell-box", "--eps", "1e-2", "--sparse", "csr", "-o", "S.npz", "-q")
    sparse = radiosity.view_factors(radiosity.load("cornell-box"), eps=1e-2, sparse=True).matrix
    theirs = scipy.sparse.load_npz(tmp_path / "S.npz")
    for part in ("data", "indices", "indptr"):
        assert np.array_equal(getattr(sparse, part), getattr(theirs, part))


def test_view_factors_of_polygons_are_those_of_a_list(command, tmp_path: Path):
    polygons = np.random.default_rng(7).uniform(-1, 1, (12, 3, 3))
    (tmp_path / "faces.json").write_text(json.dumps(polygons.tolist()))
    command("view-factors", "faces.json", "-o", "F.npy", "-q")
    factors = radiosity.view_factors(polygons)
    assert np.array_equal(factors.matrix, np.load(tmp_path / "F.npy"))
    assert factors.names[:2] == ["surface-1", "surface-2"]
    blocked = radiosity.view_factor(polygons[3], polygons[5], blockers=[*polygons[:3], polygons[4], *polygons[6:]])
    assert blocked == pytest.approx(factors.matrix[3, 5], rel=1e-2, abs=1e-6)


def test_heat_is_that_of_the_command(command, tmp_path: Path):
    command("heat", "oven", "--order", "2", "-o", "heat.csv", "--conductances", "C.npz", "-q")
    rows = list(csv.DictReader(io.StringIO((tmp_path / "heat.csv").read_text())))
    heat = radiosity.load("oven").heat(order=2, conductances=True)
    assert heat.names == [row["surface"] for row in rows]
    columns = {
        "area": heat.areas, "emissivity": heat.emissivity, "T": heat.temperature, "T_error": heat.temperature_error, "q": heat.flux,
        "Q": heat.power, "Q_error": heat.power_error, "J": heat.radiosity, "H": heat.irradiance,
    }
    for name, values in columns.items():
        assert values.tolist() == [float(row[name]) for row in rows], name
    theirs = np.load(tmp_path / "C.npz")
    assert np.array_equal(heat.conductances, theirs["C"])
    assert np.array_equal(heat.surroundings, theirs["surroundings"])


def test_the_check_of_heat_is_that_of_the_command(command, tmp_path: Path):
    command("heat", "oven", "--order", "2", "-o", "heat.json", "--audit", "0.2", "-q")
    theirs = json.loads((tmp_path / "heat.json").read_text())
    heat = radiosity.load("oven").heat(order=2, audit=0.2)
    assert without_line(heat.checked) == check_of(theirs)
    assert heat.checked["line"].startswith("checked at 7 surfaces by path tracing")


def test_solutions_are_dimmed_and_kept_as_by_the_command(command, tmp_path: Path):
    scene = radiosity.Scene(bands=["red", "blue"])
    wall = scene.material("wall", reflectance=[0.5, 0.2])
    lamp = scene.material("lamp", reflectance=0, emission=[2, 3], group="lamps")
    sun = scene.material("sun", reflectance=0, emission=[5, 1])
    scene.disk("floor", wall, center=[0, 0, 0], normal=[0, 0, 1], radius=1)
    scene.disk("lamp", lamp, center=[0, 0, 1], normal=[0, 0, -1], radius=0.3)
    scene.disk("sun", sun, center=[0.8, 0, 1], normal=[0, 0, -1], radius=0.3)
    solution = scene.solve(progress=False)
    solution.save(tmp_path / "day.json")
    command("relight", "day.json", "--set", "lamps=0.25", "-o", "dim.json", "-q")
    dim = solution.relight({"lamps": 0.25})
    dim.save(tmp_path / "ours.json")
    assert (tmp_path / "ours.json").read_bytes() == (tmp_path / "dim.json").read_bytes()
    read = [radiosity.load_solution(tmp_path / "dim.json"), radiosity.load_solution(tmp_path / "day.json", set={"lamps": 0.25})]
    assert all(np.array_equal(own.coefficients, dim.coefficients) for own in read)
    assert read[1].scene.light_groups == {"lamps": 0.25}


def test_settings_and_options_of_scenes_are_those_of_the_command(command, tmp_path: Path):
    (tmp_path / "tent.obj").write_text(
        "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nv 100 0 100\nv 0 100 100\nf 1 2 3\nf 6 5 4\n"
    )
    command("view-factors", "tent.obj", "--unit", "mm", "--one-sided", "-o", "F.npz", "-q")
    factors = radiosity.view_factors(radiosity.load(tmp_path / "tent.obj", unit="mm", one_sided=True))
    theirs = np.load(tmp_path / "F.npz")
    assert np.array_equal(factors.matrix, theirs["F"])
    assert factors.areas.tolist() == theirs["areas"].tolist() == pytest.approx([0.005, 0.005])
    command("solve", "parallel-squares", "--set", "distance=0.5", "-o", "a.json", "-q")
    radiosity.load("parallel-squares", set={"distance": 0.5}).solve().save(tmp_path / "b.json")
    theirs, ours = (json.loads((tmp_path / name).read_text()) for name in ("a.json", "b.json"))
    assert times_left_out(ours) == times_left_out(theirs)


def test_transfers_in_a_file_serve_other_temperatures(tmp_path: Path):
    oven, kept = radiosity.load("oven"), tmp_path / "oven.transfers"
    oven.heat(transfers=kept)
    size = kept.stat().st_size
    [warm] = oven.heat_sweep("brick.emissivity", [0.5], transfers=kept)
    assert kept.stat().st_size == size, "all transfers were there"
    [alone] = oven.heat_sweep("brick.emissivity", [0.5])
    np.testing.assert_array_equal(warm.power, alone.power)
    with pytest.raises(radiosity.Error, match="no transfers between the surfaces"):
        radiosity.view_factors(radiosity.load("empty-box"), transfers=kept)
    with pytest.raises(FileNotFoundError):
        oven.heat(transfers=tmp_path / "nowhere" / "kept")
