"""Seconds, memory and errors of the view factors of a dented ball by pyviewfactor (PyPI).

    python ball.py 8 --scene ball.json
    NUMBA_NUM_THREADS=1 python ball.py 8 [--beside ball.npz]

8 is the frequency of the ball of `studies/coverage/facets.py`: 20 f² triangles. With --scene the ball is written for this program;
with --beside its matrix is compared with that of `radiosity view-factors`. Obstructions are looked for as pyviewfactor does by default, between centroids.
"""

import argparse
import json
import pathlib
import resource
import sys
import time

import pyviewfactor
import pyvista

sys.path.append(str(pathlib.Path(__file__).parents[1] / "coverage"))
import facets
import numpy


def mesh(triangles):
    """The triangles as a mesh whose normals point inwards, as fronts do."""
    points, places = numpy.unique(numpy.round(triangles.reshape(-1, 3), 12), axis=0, return_inverse=True)
    faces = numpy.column_stack([numpy.full(len(triangles), 3), places.reshape(-1, 3)])
    return pyvista.PolyData(points, faces.ravel())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frequency", type=int)
    parser.add_argument("--beside", help="matrix of radiosity, NPZ")
    parser.add_argument("--scene", type=pathlib.Path, help="scene file to write")
    asked = parser.parse_args()
    if asked.scene:
        return asked.scene.write_text(json.dumps(facets.scene(facets.ball(asked.frequency))))
    # Compiled before it is timed.
    pyviewfactor.compute_viewfactor_matrix(mesh(facets.ball(1)))
    ball = mesh(facets.ball(asked.frequency))
    begun = time.process_time(), time.monotonic()
    # Entry [i, j] is the factor from j to i.
    found = pyviewfactor.compute_viewfactor_matrix(ball).T
    cpu, wall = time.process_time() - begun[0], time.monotonic() - begun[1]
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss // 1024
    sums = found.sum(axis=1)
    print(f"{ball.n_cells} facets: {cpu:.1f} CPU s, {wall:.1f} s, {memory} MB, rows from {sums.min():.4f} to {sums.max():.4f}")
    if asked.beside:
        ours = facets.rows_of(asked.beside)
        off = numpy.abs(found - ours).max(axis=1) / ours.max(axis=1)
        print(f"rows differ by {numpy.median(off):.2%} of their largest entry in the median, {off.max():.2%} at most")


if __name__ == "__main__":
    main()
