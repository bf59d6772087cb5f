"""Orthonormal polynomials on the square and on the triangle."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal, SupportsIndex, overload

import numpy as np
from numpy.typing import ArrayLike

from .._radiosity import _core
from ..arguments import Array, refusal, whole
from .arguments import interval_points

_LARGEST_ORDER = {"square": 63, "triangle": 200}


@overload
def orthonormal_square(order: SupportsIndex, points: ArrayLike, gradients: Literal[False] = False) -> Array: ...
@overload
def orthonormal_square(order: SupportsIndex, points: ArrayLike, gradients: Literal[True]) -> tuple[Array, Array]: ...
def orthonormal_square(order: SupportsIndex, points: ArrayLike, gradients: bool = False) -> Array | tuple[Array, Array]:
    """φ_k(s, t) = p_i(s) p_j(t), i + j ≤ order, orthonormal on the square [−1, 1]².

    Parameters
    ----------
    order : int
        Largest total degree N, 0 … 63.
    points : array_like of shape (..., 2)
        (s, t) in [−1, 1]².
    gradients : bool
        Return partial derivatives too.

    Returns
    -------
    phi : ndarray of shape (..., (N + 1)(N + 2)/2)
        Values, k along the last axis: by total degree d = i + j, within d by j.
    slopes : ndarray of shape (..., 2, (N + 1)(N + 2)/2)
        ∂φ_k/∂s and ∂φ_k/∂t, if asked for.

    Raises
    ------
    Error
        If the order is out of range, or a point lies outside the square.
    """
    return _basis(_core.square_basis, "square", order, points, gradients)


@overload
def orthonormal_triangle(order: SupportsIndex, points: ArrayLike, gradients: Literal[False] = False) -> Array: ...
@overload
def orthonormal_triangle(order: SupportsIndex, points: ArrayLike, gradients: Literal[True]) -> tuple[Array, Array]: ...
def orthonormal_triangle(order: SupportsIndex, points: ArrayLike, gradients: bool = False) -> Array | tuple[Array, Array]:
    """Dubiner's polynomials of total degree ≤ order, orthonormal on the triangle (−1, −1), (1, −1), (−1, 1).

    Parameters
    ----------
    order : int
        Largest total degree N, 0 … 200.
    points : array_like of shape (..., 2)
        (s, t) in the triangle: s, t ≥ −1 and s + t ≤ 0.
    gradients : bool
        Return partial derivatives too.

    Returns
    -------
    psi, slopes
        As :func:`orthonormal_square` returns them, in the same order of k.

    Raises
    ------
    Error
        If the order is out of range, or a point lies outside the triangle.
    """
    return _basis(_core.triangle_basis, "triangle", order, points, gradients)


def _basis(
    write: Callable[..., None], domain: str, order: SupportsIndex, points: ArrayLike, gradients: bool
) -> Array | tuple[Array, Array]:
    order = whole("order", order, 0, _LARGEST_ORDER[domain], f"divide the {domain} and take a lower order")
    places = interval_points("points", points)
    if places.ndim == 0 or places.shape[-1] != 2:
        raise refusal(f"points: an array of shape {places.shape} instead of (..., 2)", "give s and t of each point")
    if domain == "triangle" and (places.sum(axis=-1) > 4e-16).any():
        raise refusal("points: one lies outside the triangle (−1, −1), (1, −1), (−1, 1)", "give points with s + t ≤ 0")
    count, ahead = (order + 1) * (order + 2) // 2, places.shape[:-1]
    out = np.empty((*ahead, count))
    if not gradients:
        write(order, places.reshape(-1), out.reshape(-1))
        return out
    slopes = np.empty((*ahead, 2, count))
    write(order, places.reshape(-1), out.reshape(-1), slopes.reshape(-1))
    return out, slopes
