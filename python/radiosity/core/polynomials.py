"""Classical and orthonormal polynomials on the interval."""

from __future__ import annotations

from typing import Literal, SupportsIndex, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .._radiosity import _core
from ..arguments import Array, finite, real, refusal, whole
from .arguments import LARGEST_DEGREE, check_exponents, common_shape, exponents, interval_points, whole_degrees


def eval_legendre(n: ArrayLike, x: ArrayLike) -> float | Array:
    """The classical Legendre polynomial P_n(x), with P_n(1) = 1.

    Parameters
    ----------
    n : int or array_like of int
        Degrees, 0 … 100 000.
    x : float or array_like
        Points in [−1, 1], of a shape that goes with that of `n`.

    Returns
    -------
    float or ndarray
        Values, of the common shape of `n` and `x`. The cost of each is O(n).

    Raises
    ------
    Error
        If a degree or a point is out of range, or the shapes do not go together.
    """
    return eval_jacobi(n, 0.0, 0.0, x)


def eval_jacobi(n: ArrayLike, alpha: ArrayLike, beta: ArrayLike, x: ArrayLike) -> float | Array:
    """The classical Jacobi polynomial P_n^(α,β)(x), with P_n(1) = C(n + α, n).

    Parameters
    ----------
    n : int or array_like of int
        Degrees, 0 … 100 000.
    alpha, beta : float or array_like
        Exponents of 1 − x (α) and of 1 + x (β), above −1 and ≤ 256.
    x : float or array_like
        Points in [−1, 1].

    Returns
    -------
    float or ndarray
        Values, of the common shape of all four arguments. The cost of each is O(n).

    Raises
    ------
    Error
        If an argument is out of range, if the shapes do not go together, or if a value exceeds the largest float.
    """
    degrees, points = whole_degrees(n), interval_points("x", x)
    alphas, betas = real("alpha", alpha), real("beta", beta)
    check_exponents("alpha", alphas)
    check_exponents("beta", betas)
    shape = common_shape(n=degrees, alpha=alphas, beta=betas, x=points)
    if alphas.size == betas.size == 1:
        out = _classical(degrees, alphas.item(), betas.item(), points, shape)
    else:
        out = _classical_of_many(degrees, alphas, betas, points, shape)
    if not np.isfinite(out).all():
        raise refusal("a value of P_n exceeds the largest float", "take orthonormal_jacobi, whose values are smaller")
    return out if shape else out.item()


@overload
def orthonormal_legendre(n: SupportsIndex, x: ArrayLike, derivatives: Literal[False] = False) -> Array: ...
@overload
def orthonormal_legendre(n: SupportsIndex, x: ArrayLike, derivatives: Literal[True]) -> tuple[Array, Array]: ...
def orthonormal_legendre(n: SupportsIndex, x: ArrayLike, derivatives: bool = False) -> Array | tuple[Array, Array]:
    """Orthonormal Legendre polynomials p_0(x) … p_n(x): p_k = √(k + ½) P_k.

    As :func:`orthonormal_jacobi` for α = β = 0.
    """
    return _orthonormal(n, 0.0, 0.0, x, derivatives)


@overload
def orthonormal_jacobi(n: SupportsIndex, alpha: float, beta: float, x: ArrayLike, derivatives: Literal[False] = False) -> Array: ...
@overload
def orthonormal_jacobi(
    n: SupportsIndex, alpha: float, beta: float, x: ArrayLike, derivatives: Literal[True]
) -> tuple[Array, Array]: ...
def orthonormal_jacobi(
    n: SupportsIndex, alpha: float, beta: float, x: ArrayLike, derivatives: bool = False
) -> Array | tuple[Array, Array]:
    """Orthonormal Jacobi polynomials p_0(x) … p_n(x): ∫₋₁¹ p_k p_l (1 − x)^α (1 + x)^β dx = δ_kl, p_k(1) > 0.

    Parameters
    ----------
    n : int
        Largest degree, 0 … 100 000.
    alpha, beta : float
        Exponents of 1 − x (α) and of 1 + x (β), above −1 and ≤ 256.
    x : float or array_like
        Points in [−1, 1].
    derivatives : bool
        Return p_k′(x) too.

    Returns
    -------
    p : ndarray of shape (*x.shape, n + 1)
        The value of p_k at every point, k along the last axis.
    slopes : ndarray of the same shape
        Derivatives, if asked for.

    Raises
    ------
    Error
        If an argument is out of range.
    """
    return _orthonormal(n, alpha, beta, x, derivatives)


def legendre_sum(coefficients: ArrayLike, x: ArrayLike) -> float | Array:
    """Σ f_k p_k(x) with orthonormal Legendre polynomials, by Clenshaw's recurrence.

    Parameters
    ----------
    coefficients : array_like of shape (m,)
        f_0 … f_{m−1}; the sum of none is 0.
    x : float or array_like
        Points in [−1, 1].

    Returns
    -------
    float or ndarray
        The sum at every point, of the shape of `x`.

    Raises
    ------
    Error
        If a point is out of range, or a coefficient is no finite number.
    """
    coefficients = finite("coefficients", coefficients)
    if coefficients.ndim != 1:
        raise refusal(f"coefficients: an array of shape {coefficients.shape} instead of (m,)", "give f_0, f_1, …")
    points = interval_points("x", x)
    out = np.empty(points.shape)
    _core.legendre_sum(coefficients, points.reshape(-1), out.reshape(-1))
    return out if out.shape else out.item()


def _orthonormal(n: SupportsIndex, alpha: float, beta: float, x: ArrayLike, derivatives: bool) -> Array | tuple[Array, Array]:
    count = 1 + whole("n", n, 0, LARGEST_DEGREE, "give the largest degree")
    alpha, beta = exponents(alpha, beta)
    points = interval_points("x", x)
    out = np.empty((*points.shape, count))
    if not derivatives:
        _core.orthonormal(alpha, beta, count, points.reshape(-1), out.reshape(-1))
        return out
    slopes = np.empty_like(out)
    _core.orthonormal(alpha, beta, count, points.reshape(-1), out.reshape(-1), slopes.reshape(-1))
    return out, slopes


def _classical(degrees: NDArray[np.uintp], alpha: float, beta: float, points: Array, shape: tuple[int, ...]) -> Array:
    """P_n(x) for one weight, of a common shape."""
    out = np.empty(shape)
    flat = [np.ascontiguousarray(np.broadcast_to(array, shape)).reshape(-1) for array in (degrees, points)]
    _core.classical(alpha, beta, *flat, out.reshape(-1))
    return out


def _classical_of_many(degrees: NDArray[np.uintp], alphas: Array, betas: Array, points: Array, shape: tuple[int, ...]) -> Array:
    """P_n(x) for arrays of exponents: one call for each weight that occurs."""
    degrees, points = np.broadcast_to(degrees, shape), np.broadcast_to(points, shape)
    alphas, betas = np.broadcast_to(alphas, shape), np.broadcast_to(betas, shape)
    out = np.empty(shape)
    for alpha, beta in set(zip(alphas.flat, betas.flat)):
        own = (alphas == alpha) & (betas == beta)
        out[own] = _classical(degrees[own], alpha, beta, points[own], (int(own.sum()),))
    return out
