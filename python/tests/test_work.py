"""Long work: other threads run meanwhile, Ctrl-C ends it, and its results do not depend on the number of threads."""

from __future__ import annotations

import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import radiosity

# Each takes much longer than it is given; {progress} stands where an observer may be asked for.
LONG = {
    "exact": "radiosity.load('cornell-box').solve(transport='exact', order=6, eps=1e-4, shadow_eps=1e-4, {progress})",
    "dear pairs": "radiosity.load('cornell-box').solve(transport='exact', order=8, subdivide=4, eps=1e-6, {progress})",
    "many pairs": "radiosity.load('cornell-box').solve(transport='exact', order=0, subdivide=24, {progress})",
    "rays": "radiosity.load('cornell-box').solve(transport='sampled', rays=4_000_000_000, {progress})",
    "links": "radiosity.load('cornell-box').solve(method='hierarchical', eps=1e-9, {progress})",
    "accuracy": "radiosity.load('cornell-box').solve(accuracy=1e-6, {progress})",
    "factors": "radiosity.view_factors(radiosity.load('cornell-box'), transport='exact', eps=1e-6, subdivide=24, {progress})",
    "heat": "radiosity.load('oven').heat(order=7, eps=1e-6, subdivide=12, {progress})",
    "picture": "box.render(size=(4000, 4000), read='gather', samples=8, {progress})",
    "picture gathered twice": "box.render(size=(4000, 4000), read='gather-twice', samples=8, {progress})",
    "rule": "radiosity.core.roots_legendre(1_000_000)",
    "polynomials": "radiosity.core.eval_legendre(20_000, points)",
}

# How soon it ends (s): half of it is for the machine, which may do other things.
SOON = 4

# What the works above begin with, and how Ctrl-C is answered: the process goes on, and what it finds is as before.
PROGRAM = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)  # It is ignored in what a shell runs in the background.
import sys
import numpy as np
import radiosity.core
points = np.linspace(-1, 1, 1_000_000)
box = radiosity.load('cornell-box').solve(quality='quick')
print('begun', flush=True)
try:
    {work}
except KeyboardInterrupt:
    print('interrupted', flush=True)
again = radiosity.load('cornell-box').solve(quality='quick')
assert np.array_equal(again.coefficients, box.coefficients)
x, w = radiosity.core.roots_legendre(100)
assert abs(w.sum() - 2) < 1e-14
"""


@pytest.mark.parametrize("before", [0.02, 1.5])
@pytest.mark.parametrize("name", LONG)
def test_ctrl_c_ends_the_work_and_later_work_is_as_before(name: str, before: float):
    program = PROGRAM.format(work=LONG[name].format(progress="progress=False"))
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert child.stdout.readline() == "begun\n"
        time.sleep(before)
        child.send_signal(signal.SIGINT)
        sent = time.monotonic()
        assert child.stdout.readline() == "interrupted\n"
        took = time.monotonic() - sent
        _, told = child.communicate(timeout=60)
    finally:
        child.kill()
    assert took < SOON
    assert told == "", "no panic is told"
    assert child.returncode == 0


def test_ctrl_c_ends_the_program_that_does_not_expect_it():
    listen = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)\n"
    program = f"{listen}import radiosity\nprint('begun', flush=True)\n{LONG['exact'].format(progress='')}"
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        child.stdout.readline()
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        _, told = child.communicate(timeout=60)
    finally:
        child.kill()
    assert told.strip().splitlines()[-1] == "KeyboardInterrupt"
    assert child.returncode == -signal.SIGINT


# Dear pairs, and many of them, tell nothing for long.
@pytest.mark.parametrize("name", ["exact", "rays", "picture", "picture gathered twice"])
def test_observers_that_raise_end_the_work(name: str):
    class Enough(Exception):
        pass

    raised = []

    def end(*_: object) -> None:
        raised.append(time.monotonic())
        raise Enough

    names = {"radiosity": radiosity, "end": end, "box": radiosity.load("cornell-box").solve(quality="quick")}
    with pytest.raises(Enough):
        exec(LONG[name].format(progress="progress=end"), names)
    assert time.monotonic() - raised[0] < SOON
    assert len(raised) == 1, "it is told nothing more"


def test_other_threads_run_meanwhile():
    counts, stop = [], threading.Event()

    def count() -> None:
        ticks = 0
        while not stop.wait(0.001):
            ticks += 1
        counts.append(ticks)

    other = threading.Thread(target=count)
    other.start()
    began = time.monotonic()
    radiosity.load("cornell-box").solve(order=4, eps=1e-4, threads=1, progress=False)
    took = time.monotonic() - began
    stop.set()
    other.join()
    # With the lock held there would be a tick before and one behind the work.
    assert counts[0] > 0.1 * took / 0.001


def test_observers_hear_how_far_it_is():
    heard, threads = [], set()

    def hear(*step: object) -> None:
        heard.append(step)
        threads.add(threading.current_thread())

    radiosity.load("cornell-box").solve(order=4, eps=1e-4, progress=hear)
    assert {stage for stage, _, _ in heard} >= {"blocks"}
    assert all(0 <= done <= total for _, done, total in heard)
    assert threads == {threading.current_thread()}, "it is called by the thread that asked for the work"


def test_a_bar_is_drawn_where_it_is_wanted(capfd):
    scene = radiosity.load("cornell-box")
    scene.solve(order=4, eps=1e-4)
    assert capfd.readouterr().err == "", "stderr is no terminal"
    scene.solve(order=4, eps=1e-4, progress=True)
    assert "blocks" in capfd.readouterr().err


def test_results_do_not_depend_on_threads():
    scene = radiosity.load("cornell-box")
    one, two = (scene.solve(quality="quick", threads=threads) for threads in (1, 2))
    assert np.array_equal(one.coefficients, two.coefficients)
    point, normal = [[278, 100, 200]], [0, 1, 0]
    assert np.array_equal(one.irradiance(point, normal, threads=2), two.irradiance(point, normal, threads=1))
    factors = [radiosity.view_factors(scene, eps=1e-2, threads=threads).matrix for threads in (1, 2)]
    assert np.array_equal(*factors)
    heat = [radiosity.load("oven").heat(order=1, threads=threads).power for threads in (1, 2)]
    assert np.array_equal(*heat)
