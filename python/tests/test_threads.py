"""Work leaves no threads behind: a process may fork after it, and other threads run beside it."""

from __future__ import annotations

import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import radiosity

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="threads are counted in /proc, and forks are usual there")

# The Cornell box is open, so that a report looks for what is wrong with it.
AFTER = {
    "solve": "solution()",
    "load_solution": "radiosity.load_solution(saved)",
    "relight": "solution().relight({})",
    "stage": "radiosity.Stage(radiosity.load('sliding-light'), order=0, threads=1).frame()",
    "read": "solution().irradiance([[278, 100, 200]], [0, 1, 0])",
    "factors": "radiosity.view_factors(radiosity.load('cornell-box'), eps=1e-2, threads=1)",
    "heat": "radiosity.load('oven').heat(order=0, conductances=True, threads=1)",
    "accuracy": "radiosity.load('cornell-box').solve(accuracy=0.3, aim='picture', threads=1)",
}

PROGRAM = """
import os, sys, time, warnings
import numpy as np
import radiosity

warnings.simplefilter("ignore")
saved = sys.argv[1]

def solution():
    return radiosity.load("cornell-box").solve(quality="quick", threads=1)

def threads():
    return len(os.listdir("/proc/self/task"))

before = threads()
{work}
end = time.monotonic() + 10
while threads() > before and time.monotonic() < end:
    time.sleep(0.01)
assert threads() <= before, (before, threads())
"""


@pytest.fixture(scope="module")
def saved(tmp_path_factory) -> Path:
    path = tmp_path_factory.mktemp("saved") / "light.json"
    radiosity.load("cornell-box").solve(quality="quick").save(path)
    return path


def run(program: str, saved: Path) -> None:
    done = subprocess.run([sys.executable, "-c", program, str(saved)], capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("work", AFTER.values(), ids=AFTER)
def test_no_threads_are_left(saved: Path, work: str):
    run(PROGRAM.replace("{work}", work), saved)


def test_forked_processes_work_after_their_parent_did(saved: Path):
    fork = "import multiprocessing\nwith multiprocessing.get_context('fork').Pool(1) as pool:\n    pool.apply_async(solution_of).get(60)"
    solve = "def solution_of():\n    return solution().coefficients\nsolution_of()\nradiosity.load_solution(saved)\n"
    run(PROGRAM.replace("{work}", solve + fork), saved)


def test_other_threads_run_while_a_scene_is_read(tmp_path: Path):
    side = 120
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(side), np.arange(side), indexing="ij"))
    # Corners at random heights: no two triangles are merged.
    z = np.random.default_rng(1).uniform(0, 1, side * side)
    corner = (np.arange(side - 1)[:, None] * side + np.arange(side - 1) + 1).ravel()
    faces = np.concatenate([[corner, corner + side, corner + side + 1], [corner, corner + side + 1, corner + 1]], axis=1).T
    lines = [f"v {a} {b} {c}" for a, b, c in zip(x, y, z)] + [f"f {a} {b} {c}" for a, b, c in faces]
    (tmp_path / "ground.obj").write_text("\n".join(lines))
    longest, stop = [0.0], threading.Event()

    def wait() -> None:
        last = time.monotonic()
        while not stop.wait(0.001):
            now = time.monotonic()
            longest[0], last = max(longest[0], now - last), now

    other = threading.Thread(target=wait)
    other.start()
    began = time.monotonic()
    assert len(radiosity.load(tmp_path / "ground.obj").surfaces) > 2 * (side - 1) ** 2 * 0.9
    took = time.monotonic() - began
    stop.set()
    other.join()
    # With the lock held the other thread would wait for all of it.
    assert longest[0] < max(0.1, 0.5 * took)
