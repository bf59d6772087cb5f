"""Stages: scenes whose things a program moves and dims, and their light, frame after frame."""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _radiosity
from .arguments import finite, number, numbers, refusal, text
from .arrays import vector
from .light import Light
from .progress import Observer, Shown
from .scene import Scene

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Method


class Frame(Light):
    """The light of a stage where its movers stood. Values are in the unit of the scene."""

    def __init__(
        self, light: _radiosity.Light, unsolved: float, noise: float, scene_of: Callable[[_radiosity.Scene], Scene]
    ) -> None:
        super().__init__(light, scene_of)
        self.unsolved: float = unsolved
        """Bound of the relative difference from the light of its scene solved whole (L2 of the coefficients)."""
        self.noise: float = noise
        """Estimated relative error that rays left, where they carried the pairs of elements; else 0."""

    def __reduce__(self) -> Any:
        raise TypeError("a Frame does not pickle: solve its scene, and save that: frame.scene.solve().save(path)")

    def __repr__(self) -> str:
        return f"<Frame of {self._light.scene.name!r}>"


class Stage:
    """A scene whose things are moved and dimmed by a program; nothing has to be known in advance of where they go.

    The motions of the scene (`[[motion]]` in docs/scene.md of the project) name what can be moved; where they lead is of no account
    here. All things are at rest at first::

        stage = Stage(radiosity.load("sliding-light"), direct="projected")
        stage.move_to("lamp", translate=(-0.5, 0, 0))
        stage.emit("lamp", 0.3)
        stage.frame().irradiance([[1, 1, 0]], [0, 0, 1])

    Each frame is found from the one before: only what has changed is integrated, traced and solved for. Direct light that is split off
    is found anew; where frames have to be quick, `direct="projected"` leaves it to the blocks. After an error, or Ctrl-C, things are
    where they were last put; once what is wrong is mended, the next frame is right.
    """

    def __init__(self, scene: Scene, **method: Unpack[Method]) -> None:
        """The stage of a scene. All options are listed in `radiosity.options.Method`; frames are solved to no wanted accuracy."""
        if not isinstance(scene, Scene):
            raise TypeError(f"scene: a Scene is wanted, not {type(scene).__name__}")
        self._native = _radiosity.Stage(scene._native, method)
        self._bands = len(scene.bands)

    @property
    def movers(self) -> list[str]:
        """Names of the motions, whose things are moved together."""
        return self._native.movers

    def move_to(self, mover: str, translate: ArrayLike = (0, 0, 0), rotate: Mapping[str, Any] | None = None) -> None:
        """Puts the things of a motion where they are from the next frame on: from rest, whatever came before.

        They are turned by `rotate`, then moved by `translate` (scene length). `rotate` has "center" (scene length), and either "axis",
        of any length, and "angle" (degrees, right-handed about it), or "quaternion", (x, y, z, w) of length 1.
        """
        center, rotation = _rotation(rotate)
        self._native.move_to(text("mover", mover), center, rotation, vector("translate", translate))

    def emit(self, mover: str, factors: ArrayLike) -> None:
        """Dims the surfaces and luminaires of a motion from the next frame on.

        `factors` (≥ 0) are those of what they emit at rest: a number, or one for each band.
        """
        given = finite("factors", factors)
        parts = np.full(self._bands, given) if given.ndim == 0 else numbers("factors", given, (self._bands,))
        if (parts < 0).any():
            raise refusal(f"factors: {parts.min():g} is below 0", "give 0 for dark, 1 for what is emitted at rest")
        self._native.emit(text("mover", mover), parts.tolist())

    def frame(self, *, progress: bool | Observer | None = None) -> Frame:
        """The light where all things are now. `progress` is that of `Scene.solve`, and Ctrl-C ends the work.

        Things that cannot be where they are, such as a panel in the very place of another, are refused.
        """
        with Shown(progress) as observer:
            return Frame(*self._native.frame(observer), Scene._of)

    @property
    def report(self) -> dict[str, Any]:
        """Cost and error of all frames so far.

        "frames", "rays" (traced, and recalled from frames before), "seconds" of each stage of the work, "unconverged" and "missing",
        numbers of frames in which the solver did not converge or transfers miss their accuracy, "residual", the largest of the former,
        and "unsolved" and "noise", the largest of `Frame.unsolved` and of `Frame.noise`.
        """
        report: dict[str, Any] = json.loads(self._native.report)
        return report

    def __reduce__(self) -> Any:
        raise TypeError("a Stage does not pickle: make one of the scene in each process")

    def __repr__(self) -> str:
        return f"<Stage of {', '.join(map(repr, self.movers))}>"


_Triple = tuple[float, float, float]


def _rotation(rotate: Mapping[str, Any] | None) -> tuple[_Triple, tuple[float, float, float, float]]:
    """The centre and the quaternion (x, y, z, w) of a rotation."""
    if rotate is None:
        return (0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)
    if not isinstance(rotate, Mapping):
        raise TypeError(f"rotate: a mapping with center, axis and angle is wanted, not {type(rotate).__name__}")
    if set(rotate) == {"center", "quaternion"}:
        x, y, z, w = finite("rotate: quaternion", numbers("rotate: quaternion", rotate["quaternion"], (4,))).tolist()
        return vector("rotate: center", rotate["center"]), (x, y, z, w)
    if set(rotate) != {"center", "axis", "angle"}:
        raise refusal(
            f"rotate: the keys {', '.join(map(repr, rotate))}", "give center, axis and angle (degrees), or center and quaternion"
        )
    axis = np.array(vector("rotate: axis", rotate["axis"]))
    length, angle = float(np.linalg.norm(axis)), number("rotate: angle", rotate["angle"])
    if not math.isfinite(angle):
        raise refusal(f"rotate: angle = {angle} is no finite number", "give degrees")
    if not 0 < length < math.inf:
        raise refusal(f"rotate: axis = {axis.tolist()} has no direction", "give the direction of the axis, such as (0, 0, 1)")
    half = 0.5 * math.radians(math.fmod(angle, 360))
    x, y, z = (math.sin(half) / length * axis).tolist()
    return vector("rotate: center", rotate["center"]), (x, y, z, math.cos(half))
