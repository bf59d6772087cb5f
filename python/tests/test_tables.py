"""Tables of pandas and arrays of xarray hold what the arrays hold."""

import subprocess
import sys

import numpy as np
import pytest

import radiosity
from radiosity import tables

POINTS = np.arange(18.0).reshape(2, 3, 3)
VALUES = np.arange(12.0).reshape(2, 3, 2)


def test_points_become_rows():
    pytest.importorskip("pandas")
    frame = tables.points_frame(POINTS, VALUES, ["r", "g"])
    assert list(frame.columns) == ["x", "y", "z", "r", "g"]
    np.testing.assert_array_equal(frame.iloc[4], [*POINTS[1, 1], *VALUES[1, 1]])
    frame = tables.points_frame(POINTS, VALUES, ["r", "g"], VALUES[..., 1])
    assert list(frame.columns) == ["x", "y", "z", "r", "g", "error"]
    np.testing.assert_array_equal(frame.iloc[4], [*POINTS[1, 1], *VALUES[1, 1], VALUES[1, 1, 1]])


def test_planes_become_arrays_with_coordinates():
    pytest.importorskip("xarray")
    array = tables.plane_array(POINTS, VALUES, ["r", "g"], name="desk", unit="lx")
    assert array.sizes == {"row": 2, "column": 3, "band": 2}
    assert array.sel(band="g")[1, 2] == VALUES[1, 2, 1]
    assert array.y[0, 1] == POINTS[0, 1, 1]
    assert array.attrs["units"] == "lx" and array.name == "desk"


def test_surfaces_and_factors_go_by_names():
    pytest.importorskip("pandas")
    assert tables.surfaces_frame(["a", "b"], {"area": [1.0, 2.0]}).loc["b", "area"] == 2.0
    assert tables.factors_frame(["a", "b"], np.array([[0.0, 0.25], [0.5, 0.0]])).loc["a", "b"] == 0.25


def test_results_make_tables_of_themselves():
    pytest.importorskip("pandas")
    pytest.importorskip("xarray")
    oven = radiosity.load("oven")
    factors, heat = radiosity.view_factors(oven), oven.heat(progress=False)
    assert factors.to_pandas().loc["slab", "panel"] == factors.matrix[heat.names.index("slab"), heat.names.index("panel")]
    assert heat.to_pandas().loc["panel", "temperature"] == 1400
    sparse = radiosity.view_factors(oven, sparse=True).to_pandas()
    assert sparse.sparse.density < 1
    assert np.array_equal(sparse.sparse.to_dense().to_numpy(), factors.matrix)
    plane = radiosity.load("furnace-cube").solve(progress=False).plane([0.2, 0.2, 0.5], [0.6, 0, 0], [0, 0.5, 0], 0.2)
    assert plane.to_xarray().shape == plane.values.shape
    assert len(plane.to_pandas()) == plane.values[..., 0].size


FEW_BYTES = """
import resource
import numpy as np
import pandas
import scipy.sparse
import radiosity

side = 60
corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)
places = np.array([[2 * i, 2 * j, 0] for i in range(side) for j in range(side)], float)
dense, sparse = (radiosity.view_factors(corners + places[:, None], sparse=sparse) for sparse in (False, True))
size = 1024 * int(next(line.split()[1] for line in open("/proc/self/status") if line.startswith("VmSize")))
resource.setrlimit(resource.RLIMIT_AS, (size + 60_000_000,) * 2)
assert sparse.to_pandas().shape == (side**2, side**2)
try:
    dense.matrix
except MemoryError:
    print("no memory")
"""


@pytest.mark.skipif(sys.platform != "linux", reason="the size of the process is read in /proc")
def test_a_matrix_for_which_there_is_no_memory_is_an_exception():
    pytest.importorskip("pandas")
    done = subprocess.run([sys.executable, "-c", FEW_BYTES], capture_output=True, text=True, timeout=120, check=False)
    assert (done.returncode, done.stdout) == (0, "no memory\n"), done.stderr


@pytest.mark.parametrize(
    ("package", "call"),
    [
        ("pandas", lambda: tables.points_frame(POINTS, VALUES, ["r", "g"])),
        ("xarray", lambda: tables.plane_array(POINTS, VALUES, ["r", "g"], name="desk", unit="lx")),
    ],
)
def test_missing_packages_are_named_with_their_cure(monkeypatch, package, call):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ImportError, match=f"pip install {package}"):
        call()
