"""How long does a scene of many faces take from arrays, and how much memory?

    python python/benches/scenes.py

A wavy sheet of triangles (`Scene.triangles`) and squares scattered in a cube (`Scene.polygons`): the CPU time in which they are added, the
time of the first use, in which the library reads and checks them, and the most memory of the process above what it took before. Each
case runs in a process of its own; the memory is that which the system reports (Linux: kB).
"""

from __future__ import annotations

import argparse
import multiprocessing
import resource
import time

import numpy as np

import radiosity


def sheet(count: int) -> tuple[np.ndarray, np.ndarray]:
    """About `count` triangles: vertices (v, 3) and faces (f, 3)."""
    cells = round(np.sqrt(count / 2))
    x, y = np.meshgrid(*2 * [np.linspace(0, 1, cells + 1)], indexing="ij")
    vertices = np.stack([x, y, 0.1 * np.sin(7 * x) * np.cos(5 * y)], axis=-1).reshape(-1, 3)
    corner = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    right, above = corner + cells + 1, corner + 1
    return vertices, np.concatenate([np.stack([corner, right, above], 1), np.stack([right, right + 1, above], 1)])


def squares(count: int) -> np.ndarray:
    """Squares of side 0.1 in a cube of side 100: vertices (count, 4, 3)."""
    square = 0.1 * np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    return np.random.default_rng(1).uniform(0, 100, (count, 1, 3)) + square


def megabytes() -> float:
    """The most memory that this process ever took."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def measure(name: str, count: int) -> None:
    """Prints a row of the table."""
    arrays = sheet(count) if name == "triangles" else (squares(count),)
    scene = radiosity.Scene()
    grey = scene.material("grey", reflectance=0.5, emission=1)
    before, start = megabytes(), time.process_time()
    getattr(scene, name)("face", *arrays, grey)
    added = time.process_time()
    surfaces = len(scene.surfaces)
    read = time.process_time()
    print(f"| `{name}` | {surfaces} | {added - start:.3f} | {read - added:.2f} | {megabytes() - before:.0f} |", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--triangles", type=int, default=100_000)
    parser.add_argument("--polygons", type=int, default=10_000)
    given = parser.parse_args()
    print("| part | surfaces | adding, CPU s | first use, CPU s | memory, MB |")
    print("| --- | --- | --- | --- | --- |")
    for case in [("triangles", given.triangles), ("polygons", given.polygons)]:
        own = multiprocessing.get_context("spawn").Process(target=measure, args=case)
        own.start()
        own.join()


if __name__ == "__main__":
    main()
