"""Arrays of points as they are given: messages name the shape wanted."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._radiosity import Error
from .arguments import Array, finite, numbers, real

Whole = NDArray[np.int64]


def vector(what: str, given: ArrayLike) -> tuple[float, float, float]:
    """Three finite numbers."""
    x, y, z = finite(what, numbers(what, given, (3,))).tolist()
    return x, y, z


def directions(what: str, given: ArrayLike) -> Array:
    """Directions (n, 3), or one (3,) as an array (1, 3)."""
    return numbers(what, np.atleast_2d(real(what, given)), ("n", 3))


def polygons(given: ArrayLike | Iterable[ArrayLike], what: str = "polygons") -> list[Array]:
    """An array (n, k, 3), or several arrays (k, 3), as a list of arrays (k, 3)."""
    if isinstance(given, np.ndarray) and given.dtype != object:
        return list(numbers(what, given, ("n", "k", 3)))
    if isinstance(given, (str, bytes)) or not isinstance(given, Iterable) or getattr(given, "ndim", 1) == 0:
        raise Error(f"{what}: no array\nhelp: give an array of shape (n, k, 3), or a list of arrays of shape (k, 3)")
    return [numbers(f"{what}[{index}]", polygon, ("k", 3)) for index, polygon in enumerate(given)]
