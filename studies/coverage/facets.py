"""View factors and heat of many surfaces: seconds, memory, row sums and errors. See README.md.

    python facets.py SHARED [--command radiosity] [--only 1280,soda] [--limit 600] [--exact 600]

The scenes are closed dented balls of 20 f² triangles, seen from within, for the frequencies f of an icosphere, and the soda
shop and the classroom of SHARED/scenes/mgf. The corners of a ball are moved inwards smoothly,

    r = 1 - a (1 + sin 3x sin 4y sin 5z) / 2 ,     a = 0.15 .

Errors are those of factors against `--transport exact`, where that ends in so many seconds, over the largest factor of their
row.
"""

import argparse
import json
import math
import pathlib
import sys
import tempfile

import measured
import numpy

FREQUENCIES = [8, 23, 32]
DENT = 0.15
GOLDEN = (1 + math.sqrt(5)) / 2


def icosahedron():
    """Corners and faces, fronts outside."""
    corners = numpy.array([numpy.roll([0, s, t * GOLDEN], k) for k in range(3) for s in (1, -1) for t in (1, -1)], float)
    near = lambda a, b: numpy.isclose(numpy.linalg.norm(corners[a] - corners[b]), 2.0)
    faces = [(a, b, c) for a in range(12) for b in range(a) for c in range(b) if near(a, b) and near(b, c) and near(a, c)]
    is_out = lambda face: numpy.linalg.det(corners[list(face)]) > 0
    return corners, [face if is_out(face) else face[::-1] for face in faces]


def dented(point):
    """A point of the unit sphere, moved inwards."""
    x, y, z = point
    return point * (1 - DENT * (1 + math.sin(3 * x) * math.sin(4 * y) * math.sin(5 * z)) / 2)


def ball(frequency):
    """The triangles of a dented ball, fronts inside."""
    corners, faces = icosahedron()
    triangles = []
    for a, b, c in faces:
        def place(i, j):
            raw = corners[a] + (corners[b] - corners[a]) * i / frequency + (corners[c] - corners[a]) * j / frequency
            return dented(raw / numpy.linalg.norm(raw))
        for i in range(frequency):
            for j in range(frequency - i):
                triangles.append([place(i, j), place(i, j + 1), place(i + 1, j)])
                if i + j < frequency - 1:
                    triangles.append([place(i + 1, j), place(i, j + 1), place(i + 1, j + 1)])
    return numpy.array(triangles)


def scene(triangles):
    """The scene of triangles: those above the middle are hot, the others cold."""
    surfaces = [
        {"name": f"t{k}", "material": "hot" if corners[:, 2].mean() > 0 else "cold", "triangle": {"vertices": corners.tolist()}}
        for k, corners in enumerate(triangles)
    ]
    materials = {"hot": {"emissivity": 0.8, "temperature": 400}, "cold": {"emissivity": 0.6, "temperature": 300}}
    return {"materials": materials, "surfaces": surfaces}


def rows_of(path):
    """The matrix of an NPZ file, as it is or from its compressed rows."""
    found = numpy.load(path, allow_pickle=False)
    if "indptr" not in found:
        return found[next(key for key in ("factors", "F") if key in found)].astype(float)
    indptr, indices, data = found["indptr"], found["indices"], found["data"]
    matrix = numpy.zeros((len(indptr) - 1,) * 2, numpy.float32)
    rows = numpy.repeat(numpy.arange(len(indptr) - 1), numpy.diff(indptr))
    matrix[rows, indices] = data
    return matrix


def apart(found, right):
    """Errors over the largest factor of their row: the largest of a row in the median, and of all rows."""
    worst = (numpy.abs(found - right)).max(axis=1) / right.max(axis=1)
    return f"{100 * numpy.median(worst):.2g}", f"{100 * worst.max():.2g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("shared", type=pathlib.Path)
    parser.add_argument("--command", default="radiosity")
    parser.add_argument("--only", help="parts of names, separated by commas")
    parser.add_argument("--limit", type=float, default=600.0)
    parser.add_argument("--exact", type=float, default=600.0, help="seconds for rules")
    args = parser.parse_args()
    only = args.only.split(",") if args.only else [""]
    mgf = args.shared.resolve() / "scenes" / "mgf"
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        here = pathlib.Path(folder)
        scenes = [mgf / "soda.mgf", mgf / "classroom.mgf"]
        for frequency in FREQUENCIES:
            path = here / f"ball-{20 * frequency**2}.json"
            if any(part in path.name for part in only):
                path.write_text(json.dumps(scene(ball(frequency))))
            scenes.append(path)
        for path in scenes:
            if any(part in path.name for part in only):
                rows += measured_scene(args, path, here)
    head = ["scene", "run", "s", "CPU s", "MB", "exit code", "rows off 1, median %", "most %", "off rules, median %", "most %", "stages/all"]
    measured.table(head, rows)


def measured_scene(args, path, here):
    """The rows of a scene: its view factors as chosen and by rules, and its heat."""
    rows, matrices = [], {}
    for name, arguments, limit in [
        ("view-factors", ["view-factors", path, "-o", "auto.npz"], args.limit),
        ("by rules", ["view-factors", path, "--transport", "exact", "-o", "exact.npz"], args.exact),
        ("heat", ["heat", path, "-o", "heat.csv"], args.limit),
    ]:
        # Nothing is known of its temperatures.
        if name == "heat" and path.suffix == ".mgf":
            continue
        if limit <= 0:
            continue
        own = measured.run(args.command, arguments, limit=limit, here=here)
        sums, errors = ("–", "–"), ("–", "–")
        if own["code"] in (0, 3) and arguments[-1].endswith(".npz"):
            matrices[name] = rows_of(here / arguments[-1])
            off = numpy.abs(matrices[name].sum(axis=1, dtype=float) - 1)
            sums = f"{100 * numpy.median(off):.2g}", f"{100 * off.max():.2g}"
        whole = measured.share(measured.stages(own["told"]))
        rows.append([path.name, name, f"{own['wall']:.1f}", f"{own['cpu']:.1f}", f"{own['megabytes']:.0f}", own["code"], *sums, *errors,
                     "–" if whole is None else f"{whole:.3f}"])
        print(rows[-1], own["told"][-600:] if own["code"] != 0 else "", file=sys.stderr)
    if len(matrices) == 2:
        rows[0][8:10] = apart(matrices["view-factors"], matrices["by rules"])
        print(rows[0], file=sys.stderr)
    return rows


if __name__ == "__main__":
    main()
