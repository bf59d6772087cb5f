"""VTK reads the grids of `radiosity`, and its cells have the values of `probe --read basis` to 1e-11.

For every case: solve, convert, read by vtkXMLUnstructuredGridReader, evaluate 1000 random places by the cells' own
interpolation, and compare with the command's polynomials at the same places of the true surfaces. A place of a curved
surface follows from its parameters, which the grid has at its points: they are linear in the cell, so exact.
"""

import csv
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

PLACES = 1000
TOLERANCE = 1e-11
HERE = pathlib.Path(__file__).parent

# Elements of the order that is asked for, quickly: what the light is does not matter here.
EXACT = ["--transport", "exact", "--eps", "1e-2", "--shadows", "off"]

# Scene, options of solve.
CASES = [
    ("cornell-box", ["--order", "3"]),
    ("cornell-box", ["--order", "7", "--subdivide", "1"]),
    ("cornell-box", ["--order", "0"]),
    ("teapot", ["--order", "3"]),
    ("teapot", ["--order", "7", "--subdivide", "1", *EXACT]),
    (str(HERE / "curved.toml"), ["--order", "3", *EXACT]),
    (str(HERE / "curved.toml"), ["--order", "2", "--tensor", *EXACT]),
    (str(HERE / "curved.toml"), ["--order", "7", *EXACT]),
    (str(HERE / "curved.toml"), ["--order", "12", *EXACT]),
    # Elements as rays choose them.
    (str(HERE / "curved.toml"), ["--transport", "sampled"]),
]


def column(u, v):
    """X(u, v) of the column, as docs/scene.md describes cylinders."""
    angle = math.pi * (u + 1)
    return [-0.8 + 0.4 * math.cos(angle), 0.4 * math.sin(angle), 0.75 * (v + 1)]


def ball(u, v):
    """X(u, v) of the ball: longitude along u, latitude along v."""
    longitude, latitude = math.pi * (u + 1), 0.5 * math.pi * v
    ring = 0.5 * math.cos(latitude)
    return [0.8 + ring * math.cos(longitude), ring * math.sin(longitude), 0.7 + 0.5 * math.sin(latitude)]


SURFACES = {"column": column, "ball": ball}


def run(*words):
    """Standard output of a command that has to succeed."""
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def strings(grid, name):
    array = grid.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())]


def read(path):
    errors = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("the reader complains"))
    reader.SetFileName(str(path))
    reader.Update()
    assert not errors, errors
    return reader.GetOutput()


def evaluated(grid, cell, place):
    """Position and arrays at a place of a cell, and the normal of the cell there."""
    count = cell.GetNumberOfPoints()
    weights, position, slopes = [0.0] * count, [0.0] * 3, [0.0] * (2 * count)
    cell.EvaluateLocation(vtk.reference(0), place, position, weights)
    cell.InterpolateDerivs(place, slopes)
    points = [cell.GetPointId(k) for k in range(count)]
    nodes = vtk_to_numpy(grid.GetPoints().GetData())[points]
    # Triangles have all slopes by s first, quadrilaterals both of a node together.
    is_triangle = cell.GetCellType() == vtk.VTK_LAGRANGE_TRIANGLE
    slopes = numpy.reshape(slopes, (2, count)) if is_triangle else numpy.reshape(slopes, (count, 2)).T
    normal = numpy.cross(*(slopes @ nodes))
    data = grid.GetPointData()
    arrays = {}
    for k in range(data.GetNumberOfArrays()):
        values = vtk_to_numpy(data.GetArray(k))[points]
        arrays[data.GetArrayName(k)] = numpy.asarray(weights) @ values
    arrays["cell normal"] = normal / numpy.linalg.norm(normal)
    return position, arrays


def sampled(grid):
    """Random places: name of the surface, position on it, and the arrays there."""
    random = numpy.random.default_rng(28)
    surfaces = strings(grid, "surfaces")
    of_cell = vtk_to_numpy(grid.GetCellData().GetArray("surface"))
    for _ in range(PLACES):
        index = int(random.integers(grid.GetNumberOfCells()))
        cell = grid.GetCell(index)
        # Not on the sides, where elements of two surfaces meet.
        s, t = random.uniform(0.02, 0.98, 2)
        if cell.GetCellType() == vtk.VTK_LAGRANGE_TRIANGLE and s + t > 0.98:
            s, t = 0.98 * (1 - s), 0.98 * (1 - t)
        position, arrays = evaluated(grid, cell, [s, t, 0.0])
        name = surfaces[of_cell[index]]
        if name in SURFACES:
            exact = SURFACES[name](*arrays["parameters"])
            deviation = grid.GetFieldData().GetArray("geometric deviation").GetValue(0)
            assert math.dist(exact, position) <= 2 * deviation, (name, exact, position)
            position = exact
        yield name, position, arrays


def compare(scene, options, folder):
    solution, path, points = folder / "solution.json", folder / "room.vtu", folder / "points.csv"
    run(*RADIOSITY, "solve", scene, *options, "-q", "-o", str(solution))
    run(*RADIOSITY, "convert", str(solution), str(path))
    grid = read(path)
    places = list(sampled(grid))
    with open(points, "w") as out:
        out.write("x,y,z,nx,ny,nz\n")
        for _, position, arrays in places:
            normal = arrays["cell normal"]
            assert normal @ arrays["normal"] > 0, "cells are counter-clockwise as seen from the front"
            out.write(",".join(repr(float(x)) for x in [*position, *normal]) + "\n")
    table = run(*RADIOSITY, "probe", str(solution), "--points", str(points), "--read", "basis", "-q")
    rows = list(csv.DictReader(table.splitlines()))
    assert len(rows) == len(places)
    worst = 0.0
    for quantity, short in [("irradiance", "E"), ("radiosity", "B")]:
        for band in strings(grid, "bands"):
            ours = numpy.array([float(row[f"{short}_{band}"]) for row in rows])
            theirs = numpy.array([arrays[f"{quantity} {band}"] for _, _, arrays in places])
            assert abs(ours).max() > 0, "there is light"
            # Relative to the light at the place, or a thousandth of the scene's.
            scale = numpy.maximum(abs(ours), 1e-3 * abs(ours).max())
            worst = max(worst, float((abs(ours - theirs) / scale).max()))
    assert all(row["surface"] == name for row, (name, _, _) in zip(rows, places))
    deviation = grid.GetFieldData().GetArray("geometric deviation").GetValue(0)
    print(
        f"{pathlib.Path(scene).stem} {' '.join(options)}: {grid.GetNumberOfCells()} cells, "
        f"largest relative difference {worst:.1e}, geometric deviation {deviation:.1e}"
    )
    assert worst <= TOLERANCE, worst


RADIOSITY = sys.argv[1:] or ["radiosity"]

if __name__ == "__main__":
    print("VTK", vtk.vtkVersion().GetVTKVersion())
    for scene, options in CASES:
        with tempfile.TemporaryDirectory() as folder:
            compare(scene, options, pathlib.Path(folder))
