"""How long do all view factors of a closed box take: radiosity from Python, its command, and pyviewfactor?

    python python/benches/view_factors.py --command target/release/radiosity
    python python/benches/view_factors.py --cells 8        # 384 faces

The walls of the unit cube are cut into squares, 16 × 16 each, so 1536 faces, normals inwards. In a closed box the factors of a face
sum to 1. Each time is the best of --repeat runs in this process, and of as many runs of the command, which reads its polygons
and writes its matrix to files. Factors of whole walls are summed from those of their squares and compared with the closed form
of opposite squares (C-11 of Howell's catalogue), from which those of neighbours follow.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import subprocess
import tempfile
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import radiosity


def box(cells: int) -> np.ndarray:
    """The walls of the unit cube, cut into squares: vertices (6 cells², 4, 3), counter-clockwise seen from inside."""
    steps = np.arange(cells + 1) / cells
    a, b = (edge.ravel() for edge in np.meshgrid(steps[:-1], steps[:-1], indexing="ij"))
    step = 1 / cells
    square = np.stack([np.stack([a + s, b + t], axis=-1) for s, t in [(0, 0), (step, 0), (step, step), (0, step)]], axis=1)
    walls = []
    for axis in range(3):
        for side in (0.0, 1.0):
            wall = np.insert(square, 0, side, axis=2)
            wall = np.roll(wall, axis, axis=2)
            walls.append(wall if side == 0.0 else wall[:, ::-1])
    return np.concatenate(walls)


def best(repeat: int, work: Callable[[], Any]) -> tuple[float, Any]:
    """The shortest time (s) and the last result."""
    times, result = [], None
    for _ in range(repeat):
        start = time.perf_counter()
        result = work()
        times.append(time.perf_counter() - start)
    return min(times), result


def told(name: str, seconds: float, factors: np.ndarray | None) -> None:
    """One row of the table; `factors[i, j]` goes from i to j."""
    if factors is None:
        print(f"| {name} | {seconds:.2f} | | |")
        return
    missing = abs(factors.sum(axis=1) - 1)
    print(f"| {name} | {seconds:.2f} | {missing.max():.1e} | {error_of_pairs(factors):.1e} |", flush=True)


def error_of_pairs(factors: np.ndarray) -> float:
    """The worst error of the factors between whole opposite walls and between neighbouring ones, summed from their squares."""
    count = len(factors) // 6
    walls = factors.reshape(6, count, 6, count).sum(axis=3).mean(axis=1)
    opposite = opposite_squares()
    neighbour = (1 - opposite) / 4
    exact = np.full((6, 6), neighbour)
    for wall in range(6):
        exact[wall, wall], exact[wall, wall ^ 1] = 0.0, opposite
    return float(abs(walls - exact).max())


def opposite_squares() -> float:
    """C-11 with X = Y = 1."""
    inside = math.log(math.sqrt(4 / 3)) + 2 * math.sqrt(2) * math.atan(1 / math.sqrt(2)) - 2 * math.atan(1.0)
    return 2 / math.pi * inside


def command(path: str, polygons: np.ndarray, folder: str, threads: int) -> list[str]:
    """The call that writes the same factors to a file."""
    source = os.path.join(folder, "box.json")
    with open(source, "w") as file:
        json.dump(polygons.tolist(), file)
    target = os.path.join(folder, "factors.npz")
    return [path, "view-factors", source, "-o", target, "--quiet", "--threads", str(threads)]


def peer(polygons: np.ndarray) -> tuple[Callable[[], np.ndarray], float]:
    """The call of pyviewfactor, compiled, and the time that took (s)."""
    import pyvista
    from pyviewfactor import compute_viewfactor_matrix

    def mesh(squares: np.ndarray) -> Any:
        corners = np.arange(4 * len(squares)).reshape(-1, 4)
        faces = np.column_stack([np.full(len(squares), 4), corners])
        return pyvista.PolyData(squares.reshape(-1, 3), faces.ravel())

    start = time.perf_counter()
    compute_viewfactor_matrix(mesh(box(2)))
    compiled = time.perf_counter() - start
    # Its matrix goes from column to row.
    return lambda: compute_viewfactor_matrix(mesh(polygons)).T, compiled


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--cells", type=int, default=16, help="squares along each edge of the cube")
    arguments.add_argument("--repeat", type=int, default=3, help="runs of which the best counts")
    arguments.add_argument("--threads", type=int, default=os.cpu_count(), help="threads of radiosity")
    arguments.add_argument("--command", metavar="PATH", help="the binary `radiosity`; left out without it")
    given = arguments.parse_args()
    polygons = box(given.cells)
    print(f"{len(polygons)} faces, {given.threads} threads, best of {given.repeat}\n")
    print("| | time (s) | worst row sum − 1 | worst factor of whole walls |")
    print("| --- | --- | --- | --- |")
    own, factors = best(given.repeat, lambda: radiosity.view_factors(polygons, threads=given.threads, progress=False).matrix)
    told("radiosity.view_factors", own, factors)
    if given.command:
        with tempfile.TemporaryDirectory() as folder:
            call = command(given.command, polygons, folder, given.threads)
            binary, _ = best(given.repeat, lambda: subprocess.run(call, check=True))
            with np.load(os.path.join(folder, "factors.npz")) as file:
                theirs = file["F"]
        told("the command `radiosity view-factors`", binary, theirs)
        print(f"| Python over the command | {own / binary:.3f} | equal to the bit: {np.array_equal(factors, theirs)} | |")
    try:
        work, compiled = peer(polygons)
    except ImportError as error:
        print(f"\npyviewfactor is left out: {error} (pip install pyviewfactor)")
        return
    seconds, theirs = best(given.repeat, work)
    told("pyviewfactor", seconds, theirs)
    told("pyviewfactor, to compile it", compiled, None)


if __name__ == "__main__":
    main()
