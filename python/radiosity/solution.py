"""Solutions: light, read at points, on planes and through cameras."""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _radiosity
from .progress import Observer, Shown


class Solution:
    """A scene with the light in it."""

    def __init__(self, native: _radiosity.Solution) -> None:
        self._native = native

    def irradiance(
        self, points: ArrayLike, normals: ArrayLike, *, progress: bool | Observer | None = None
    ) -> NDArray[np.float64]:
        """Irradiance (the scene's unit) at `points` (n, 3) along unit `normals` (n, 3): an array (n, bands)."""
        points, normals = np.asarray(points, np.float64), np.asarray(normals, np.float64)
        with Shown(progress) as observer:
            return self._native.irradiance(points, normals, observer)


def load_solution(path: str | os.PathLike[str]) -> Solution:
    """The solution in a file that `Solution.save` or `radiosity solve` wrote."""
    return Solution(_radiosity.load_solution(os.fspath(path)))
