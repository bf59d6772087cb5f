"""Stages: frames against scenes solved by themselves, what is refused, and what follows after that."""

from __future__ import annotations

import math
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import radiosity
from radiosity import Error, Stage

EXACT = {"order": 1, "transport": "exact"}
RAYS = {"order": 1, "transport": "sampled", "rays": 20_000}

# A closed room with a panel that turns about its edge and slides in frame 1; two bands.
ROOM = """
bands = ["a", "b"]
frames = 2
materials.wall = { reflectance = [0.7, 0.4] }
materials.lamp = { reflectance = 0, emission = [10, 5] }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = { origin = [0.3, 0.4, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }
[[surfaces]]
name = "panel"
material = "wall"
two_sided = true
parallelogram = { origin = [0.1, 0.2, 0.6], edge1 = [0.3, 0, 0], edge2 = [0, 0.3, 0] }
[[surfaces]]
name = "shelf"
material = "wall"
two_sided = true
parallelogram = { origin = [0.6, 0.5, 0.3], edge1 = [0.3, 0, 0], edge2 = [0, 0.3, 0] }
[[motion]]
name = "panel"
surfaces = "panel"
translate = { points = [[0, 0, 0], [0.2, 0.1, 0]] }
rotate = { center = [0.1, 0.2, 0.6], axis = [0, 2, 0], angles = [0, 30] }
[[motion]]
name = "lamp"
surfaces = "lamp"
emission = { factors = [1, [0.5, 0.25]] }
"""


@pytest.fixture
def room() -> radiosity.Scene:
    return radiosity.Scene.from_toml(ROOM)


def apart(one: np.ndarray, other: np.ndarray) -> float:
    return float(np.linalg.norm(one - other) / np.linalg.norm(other))


def alone(frame: radiosity.Frame, **method) -> radiosity.Solution:
    """The light of the scene of a frame, solved by itself."""
    return frame.scene.solve(**method, progress=False)


@pytest.mark.parametrize("rotate", [
    {"center": (0.1, 0.2, 0.6), "axis": (0, 3, 0), "angle": 390},
    {"center": [0.1, 0.2, 0.6], "quaternion": [0, math.sin(math.pi / 12), 0, math.cos(math.pi / 12)]},
])
def test_poses_of_a_frame_give_its_light(tmp_path, room, rotate):
    (tmp_path / "room.toml").write_text(ROOM)
    for method in (EXACT, RAYS):
        stage = Stage(room, **method)
        assert stage.movers == ["panel", "lamp"]
        first = stage.frame()
        stage.move_to("panel", translate=(0.2, 0.1, 0), rotate=rotate)
        stage.emit("lamp", (0.5, 0.25))
        frame = stage.frame()
        for number, found in enumerate((first, frame)):
            whole = radiosity.load(tmp_path / "room.toml", frame=number).solve(**method, progress=False)
            # Rays that stand have noise of their own.
            most = found.unsolved + 4 * found.noise + 1e-6
            assert apart(found.coefficients, whole.coefficients) < most < (0.2 if found.noise else 2e-3)
            assert (found.noise > 0) == (method is RAYS)
        assert first.scene.surfaces == frame.scene.surfaces == room.surfaces
        assert apart(frame.coefficients, first.coefficients) > 0.1
        assert stage.report["frames"] == 2 and stage.report["noise"] == max(first.noise, frame.noise)


def test_frames_are_read_as_solutions_are(room):
    stage = Stage(room, **EXACT)
    frame = stage.frame()
    whole = alone(frame, **EXACT)
    points, normals = [[0.5, 0.5, 0.01], [0.2, 0.8, 0.5]], [0, 0, 1]
    assert np.allclose(frame.irradiance(points, normals), whole.irradiance(points, normals), rtol=1e-4)
    assert np.allclose(frame.grid((2, 2), read="basis")["irradiance"], whole.grid((2, 2), read="basis")["irradiance"], rtol=1e-4)
    ours, theirs = (own.plane((0.1, 0.1, 0.3), (0.8, 0, 0), (0, 0.8, 0), 0.2) for own in (frame, whole))
    assert np.allclose(ours.values, theirs.values, rtol=1e-4)
    camera = {"eye": (0.05, 0.05, 0.5), "target": (1, 1, 0.4), "fov": 80}
    ours, theirs = (own.render(camera, (12, 9), read="basis") for own in (frame, whole))
    assert np.allclose(ours, theirs, rtol=1e-4)
    assert frame.elements == whole.elements


def test_light_is_halved_with_the_only_lamp(room):
    stage = Stage(room, **EXACT)
    bright = stage.frame().coefficients
    stage.emit("lamp", 0.5)
    assert apart(stage.frame().coefficients, 0.5 * bright) < 1e-4
    stage.emit("lamp", [0, 1])
    dark, same = stage.frame().coefficients
    assert np.all(dark == 0) and apart(same, bright[1]) < 1e-3
    recalled = stage.report["rays"]
    assert recalled == {"traced": 0, "recalled": 0}, "no rays carry the pairs"


def refused(words: str, call, *given, **named) -> None:
    with pytest.raises(Error, match=words) as caught:
        call(*given, **named)
    assert "\nhelp: " in str(caught.value), "there is a cure"


def test_what_is_refused_is_told_and_the_stage_goes_on(room):
    stage = Stage(room, **EXACT)
    stage.frame()
    refused("unknown motion \"pannel\"", stage.move_to, "pannel")
    refused("unknown motion \"lmap\"", stage.emit, "lmap", 1)
    refused("factors: an array of shape \\(3,\\)", stage.emit, "lamp", [1, 1, 1])
    refused("factors: -1 is below 0", stage.emit, "lamp", [1, -1])
    refused("factors: an entry is no finite number", stage.emit, "lamp", math.nan)
    refused("translate: an array of shape", stage.move_to, "panel", (1, 2))
    refused("rotate: the keys 'axis'", stage.move_to, "panel", rotate={"axis": (0, 0, 1)})
    refused("rotate: axis = .* has no direction", stage.move_to, "panel", rotate={"center": (0, 0, 0), "axis": (0, 0, 0), "angle": 9})
    refused("length of the quaternion", stage.move_to, "panel", rotate={"center": (0, 0, 0), "quaternion": (0, 0, 0, 2)})
    # In the place of the shelf; and what does not emit.
    stage.move_to("panel", (0.5, 0.3, -0.3))
    refused("coincides with surface \"shelf\"", stage.frame)
    stage.move_to("panel", (0, 0, -0.3))
    stage.emit("panel", 0.5)
    refused("nothing that moves with it emits light", stage.frame)
    stage.emit("panel", 1)
    frame = stage.frame()
    assert apart(frame.coefficients, alone(frame, **EXACT).coefficients) < frame.unsolved + 1e-6 < 1e-4
    assert stage.report["frames"] == 2, "those that were refused do not count"


def test_stages_are_of_scenes_that_move_and_of_methods_that_frames_share(room):
    refused("nothing moves in the scene", Stage, radiosity.load("cornell-box"))
    refused("accuracy=", Stage, room, accuracy=1e-2)
    refused("links of one frame", Stage, room, method="hierarchical")
    refused("bounces=1", Stage, room, bounces=1)
    with pytest.raises(TypeError, match="colour"):
        Stage(room, colour="red")
    with pytest.raises(TypeError, match="a Scene is wanted"):
        Stage("sliding-light")
    stage = Stage(room, **EXACT)
    for thing in (stage, stage.frame()):
        with pytest.raises(TypeError, match="does not pickle"):
            pickle.dumps(thing)


def test_a_stage_is_busy_while_another_thread_waits_for_its_frame():
    stage = Stage(radiosity.load("cathedral"), order=3, eps=1e-5, transport="exact")
    heard, told = threading.Event(), []

    class Enough(Exception):
        pass

    def hear(*_: object) -> None:
        heard.set()
        if told:
            raise Enough

    def wait() -> None:
        with pytest.raises(Enough):
            stage.frame(progress=hear)

    other = threading.Thread(target=wait)
    other.start()
    assert heard.wait(30)
    with pytest.raises(Error, match="in another thread"):
        stage.emit("lamp", 1)
    told.append(True)
    other.join(30)
    assert not other.is_alive()
    assert stage.report["frames"] == 0


def test_light_is_right_after_an_interruption(room):
    stage = Stage(room, **EXACT)
    stage.frame()
    stage.move_to("panel", (0.1, 0, 0))

    def end(*_: object) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        stage.frame(progress=end)
    stage.emit("lamp", 0.5)
    frame = stage.frame()
    assert apart(frame.coefficients, alone(frame, **EXACT).coefficients) < frame.unsolved + 1e-6 < 1e-4


PROGRAM = """
import signal
signal.signal(signal.SIGINT, signal.default_int_handler)
import numpy as np
import radiosity
long = radiosity.Stage(radiosity.load("sliding-light"), order=5, eps=1e-6, transport="exact")
print("begun", flush=True)
try:
    long.frame()
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_ctrl_c_ends_a_frame():
    child = subprocess.Popen([sys.executable, "-c", PROGRAM], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        assert child.stdout.readline() == "begun\n"
        time.sleep(0.3)
        child.send_signal(signal.SIGINT)
        sent = time.monotonic()
        assert child.stdout.readline() == "interrupted\n"
        took = time.monotonic() - sent
        _, told = child.communicate(timeout=60)
    finally:
        child.kill()
    assert took < 4 and told == "" and child.returncode == 0
