"""Messages call options as arguments and verbs as functions, and leave the text of users as it is."""

from __future__ import annotations

import numpy as np
import pytest

import radiosity
from radiosity import Error, Scene

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)


def box(**options):
    return radiosity.load("empty-box").solve(progress=False, quality="quick", **options)


def dark() -> Scene:
    scene = Scene()
    scene.polygon("floor", SQUARE, scene.material("grey", 0.5))
    return scene


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: box(accuracy=0.5).irradiance([[0.5, 0.5, 0]], [0, 0, 1], read="basis"), 'add aim="solution", or take read="gather"'),
        (lambda: box(solver="lu", preconditioner="none"), 'preconditioner= does nothing with solver="lu"'),
        (lambda: box(basis="constant", order=2), 'basis="constant" has no order=2: '),
        (lambda: box(basis="constant", order=2), "take finer cells: subdivide=8"),
        (lambda: box(mask_cells=9), 'mask_cells= does nothing without shadows="mask"'),
        (lambda: box(link_rays=9), 'link_rays= does nothing without method="hierarchical"'),
        (lambda: box(ratio=0.3), "ratio= does nothing without layers="),
        (lambda: box(aim="solution"), "aim= does nothing without an accuracy"),
        (lambda: box(bounces=1).save("light.json"), "bounces=1: a solution is kept"),
        (lambda: box(solver="gauss-seidel", max_iterations=1), "raise tolerance= or max_iterations=, or take another solver=; solve keep_partial="),
        (lambda: box().grid((3, 3), read_by="rays", read_samples=(2, 2)), 'read_samples= counts points, and read_by="rays" sends rays'),
        (lambda: box().grid((9, 9), memory=1), "ask for fewer with cells=, or allow more with memory="),
        (lambda: box().render({"eye": [0.5, 0.5, 0.5], "target": [1, 1, 1]}, (99, 9), memory=1), "fewer with size=, or allow more with memory="),
        (lambda: box().plane("desk"), "or type it: plane(origin, u, v, spacing)"),
        (lambda: radiosity.load("cornell-box", one_sided=True, two_sided=True), "one_sided= does not go with two_sided="),
        (lambda: radiosity.load("cornell-box", set={"depth": 1}), "`radiosity.builtins()` lists those that have"),
        (lambda: dark().solve(), "in a file for materials=; `Scene.heat(…)` takes temperatures instead"),
    ],
)
def test_options_are_arguments(call, told: str):
    with pytest.raises(Error) as raised:
        call()
    assert told in str(raised.value)


@pytest.mark.parametrize("name", ["my--file.toml", "--eps 1e-3.toml", "`radiosity scenes`.toml"])
def test_names_of_files_stay_as_they_are(tmp_path, name: str):
    for read in (radiosity.load, radiosity.load_solution):
        with pytest.raises(FileNotFoundError) as raised:
            read(tmp_path / name)
        assert f"/{name}: cannot be read" in str(raised.value)
        assert "`radiosity.builtins()` lists" in str(raised.value)


def test_names_in_warnings_stay_as_they_are():
    scene = Scene()
    white = scene.material("white", 0.5, emission=1)
    scene.polygon("floor", SQUARE, white)
    # Under the floor, whose back is dark.
    scene.plane("--cells 3", origin=[0.2, 0.2, -1], u=[0.5, 0, 0], v=[0, 0.5, 0], spacing=0.5)
    with pytest.warns(radiosity.RadiosityWarning, match=r'plane "--cells 3" get no light'):
        scene.solve(progress=False).plane("--cells 3")


def test_the_report_is_that_of_the_command():
    with pytest.warns(radiosity.RadiosityWarning, match="raise max_iterations= or take another solver="):
        partial = box(solver="gauss-seidel", max_iterations=1, keep_partial=True)
    assert any("raise --max-iterations or take another --solver" in own["message"] for own in partial.report["warnings"])
