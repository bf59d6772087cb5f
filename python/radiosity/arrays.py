"""Arrays as they are given: of float64, with messages that name the shape wanted."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._radiosity import Error
from .arguments import finite

Numbers = NDArray[np.float64]
Whole = NDArray[np.int64]


def numbers(what: str, given: ArrayLike, shape: tuple[int | str, ...]) -> Numbers:
    """`given` as an array of this shape, in which a name stands for any length; not copied where it is one."""
    wanted = ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "")
    try:
        array = np.asarray(given, np.float64)
    except (TypeError, ValueError) as error:
        raise Error(f"{what}: no array of numbers\nhelp: give an array of shape ({wanted})") from error
    fits = array.ndim == len(shape) and all(
        isinstance(side, str) or length == side for length, side in zip(array.shape, shape)
    )
    if not fits:
        raise Error(f"{what}: an array of shape {array.shape} instead of ({wanted})")
    return array


def vector(what: str, given: ArrayLike) -> tuple[float, float, float]:
    """Three finite numbers."""
    x, y, z = finite(what, numbers(what, given, (3,))).tolist()
    return x, y, z


def polygons(given: ArrayLike | Iterable[ArrayLike]) -> list[Numbers]:
    """An array (n, k, 3), or several arrays (k, 3), as a list of arrays (k, 3)."""
    if isinstance(given, np.ndarray) and given.dtype != object:
        return list(numbers("polygons", given, ("n", "k", 3)))
    if isinstance(given, (str, bytes)) or not isinstance(given, Iterable) or getattr(given, "ndim", 1) == 0:
        raise Error("polygons: no array\nhelp: give an array of shape (n, k, 3), or a list of arrays of shape (k, 3)")
    return [numbers(f"polygons[{index}]", polygon, ("k", 3)) for index, polygon in enumerate(given)]
