"""View factors: the share of what leaves each surface that reaches each other."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _radiosity
from .progress import Observer, Shown
from .scene import Scene


class ViewFactors:
    """The view factors F_ij between n surfaces."""

    def __init__(self, native: _radiosity.ViewFactors) -> None:
        self._native = native
        self.matrix: NDArray[np.float64] = native.matrix
        """F, an array (n, n); A_i F_ij = A_j F_ji."""

    @property
    def names(self) -> list[str]:
        """Names of the surfaces."""
        return self._native.names

    @property
    def areas(self) -> NDArray[np.float64]:
        """Areas of the surfaces (scene length²), an array (n,)."""
        return self._native.areas

    @property
    def row_sums(self) -> NDArray[np.float64]:
        """Σ_j F_ij, an array (n,): 1 for each surface of a closed scene."""
        return self._native.row_sums


def view_factors(
    of: Scene | ArrayLike | Sequence[ArrayLike], *, progress: bool | Observer | None = None
) -> ViewFactors:
    """The view factors between the surfaces of a scene, or between polygons.

    `of` is a scene, an array (n, k, 3) or a list of arrays (k, 3): the vertices of each polygon, counterclockwise as seen from its
    front. Only fronts send and receive; all sides block.
    """
    with Shown(progress) as observer:
        if isinstance(of, Scene):
            return ViewFactors(_radiosity.view_factors_of_scene(of._native, observer))
        polygons = [np.asarray(polygon, np.float64) for polygon in of]
        return ViewFactors(_radiosity.view_factors_of_polygons(polygons, observer))


def view_factor(a: ArrayLike, b: ArrayLike, blockers: Sequence[ArrayLike] = ()) -> float:
    """The share of what leaves the polygon `a` (k, 3) that reaches the polygon `b` (k, 3), past `blockers`."""
    return float(view_factors([a, b, *blockers], progress=False).matrix[0, 1])
