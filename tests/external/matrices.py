"""NumPy and SciPy read the matrices of `radiosity`: dense, sparse, as View3D writes them."""

import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy
import scipy.sparse

RADIOSITY = sys.argv[1:] or ["radiosity"]


def write(folder, name, *options):
    """A matrix of the Cornell box in the form of the file's ending."""
    path = folder / name
    subprocess.run([*RADIOSITY, "view-factors", "cornell-box", "-q", "-o", str(path), *options], check=True)
    return path


def table(path):
    """Names and factors of the CSV, which has all digits."""
    rows = list(csv.reader(open(path)))
    return rows[0][1:], numpy.array([[float(x) for x in row[1:]] for row in rows[1:]])


def check_factors(folder):
    names, factors = table(write(folder, "F.csv"))
    dense = numpy.load(write(folder, "F.npz"))
    assert list(dense["names"]) == names
    assert (dense["F"] == factors).all()
    exchanges = dense["areas"][:, None] * dense["F"]
    # A_i F_ij = A_j F_ji
    assert abs(exchanges - exchanges.T).max() <= 1e-12 * exchanges.max()
    assert (numpy.load(write(folder, "F.npy")) == factors).all()
    for form in ["csr", "coo"]:
        path = write(folder, f"{form}.npz", "--sparse", form)
        matrix = scipy.sparse.load_npz(path)
        assert matrix.format == form and matrix.nnz == (factors != 0).sum()
        assert (matrix.toarray() == factors).all()
        with numpy.load(path) as beside:
            assert list(beside["names"]) == names and (beside["areas"] == dense["areas"]).all()
    return dense


def check_view3d(folder, dense):
    """Line by line, as the manual of View3D describes its format 0."""
    first, *lines = write(folder, "F.txt").read_text().splitlines()
    program, _, form, enclosure, emittance, count = first.split()
    assert (program, form, enclosure, emittance) == ("radiosity", "0", "0", "0")
    assert int(count) == len(dense["names"]) == len(lines) - 2
    numbers = [[float(word) for word in line.split()] for line in lines]
    assert (numpy.array(numbers[0]) == dense["areas"]).all()
    assert (numpy.array(numbers[1:-1]) == dense["F"]).all()
    assert all(0 < emittance <= 1 for emittance in numbers[-1])


def check_conductances(folder):
    for name in ["C.npz", "C.npy"]:
        command = [*RADIOSITY, "heat", "oven", "-q", "-o", str(folder / "heat.csv")]
        subprocess.run([*command, "--conductances", str(folder / name)], check=True)
    npz, rows = numpy.load(folder / "C.npz"), list(csv.DictReader(open(folder / "heat.csv")))
    assert (npz["C"] == numpy.load(folder / "C.npy")).all()
    assert list(npz["names"]) == [row["surface"] for row in rows]
    emitted = [float(row["area"]) * float(row["emissivity"] or "nan") for row in rows]
    sums = npz["C"].sum(axis=1) + npz["surroundings"]
    # Σ_j C_ij + C_i0 = ε_i A_i
    numpy.testing.assert_allclose(sums, emitted, rtol=1e-12)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        dense = check_factors(folder)
        check_view3d(folder, dense)
        check_conductances(folder)
        print(f"NumPy {numpy.__version__}, SciPy {scipy.__version__}: {len(dense['names'])} surfaces, {dense.files}")
