"""What this package accepts: whole numbers, exponents, points and coefficients, checked and made arrays of floats."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..arguments import Array, real, refusal

LARGEST_EXPONENT = 256.0
"""The largest exponent α or β."""

LARGEST_DEGREE = 100_000
"""The largest degree of polynomials."""


def exponents(alpha: float, beta: float) -> tuple[float, float]:
    """α and β of one weight."""
    return _exponent("alpha", alpha), _exponent("beta", beta)


def _exponent(name: str, value: float) -> float:
    array = real(name, value)
    if array.ndim:
        raise refusal(f"{name}: an array of shape {array.shape} instead of one number", "call once for each weight")
    check_exponents(name, array)
    return float(array)


def check_exponents(name: str, array: Array) -> None:
    """Refuses what no weight has."""
    wrong = ~((array > -1.0) & (array <= LARGEST_EXPONENT))
    if wrong.any():
        first = array[wrong].flat[0]
        raise refusal(f"{name} = {first} is no exponent", f"give a number above −1 and at most {LARGEST_EXPONENT:g}")


def interval_points(name: str, value: ArrayLike) -> Array:
    """Points in [−1, 1]."""
    array = real(name, value)
    wrong = ~(np.abs(array) <= 1.0)
    if wrong.any():
        raise refusal(f"{name}: the entry {array[wrong].flat[0]} is not in [−1, 1]", "map your interval to [−1, 1]")
    return array


def whole_degrees(n: ArrayLike) -> NDArray[np.uintp]:
    """Degrees as an array of whole numbers."""
    array = real("n", n)
    wrong = ~((array >= 0) & (array <= LARGEST_DEGREE) & (array == np.floor(array)))
    if wrong.any():
        raise refusal(f"n: the entry {array[wrong].flat[0]:g} is no degree", f"give whole numbers, 0 … {LARGEST_DEGREE}")
    return array.astype(np.uintp)


def common_shape(**arrays: NDArray[Any]) -> tuple[int, ...]:
    """The shape that arrays broadcast to."""
    try:
        return np.broadcast_shapes(*(array.shape for array in arrays.values()))
    except ValueError:
        shapes = ", ".join(f"{name} {array.shape}" for name, array in arrays.items())
        raise refusal(f"shapes that do not go together: {shapes}", "give shapes that NumPy broadcasts") from None
