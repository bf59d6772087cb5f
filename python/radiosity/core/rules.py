"""Gauss rules on the interval and on the triangle."""

from __future__ import annotations

from typing import Literal, SupportsIndex, overload

import numpy as np

from .._radiosity import _core
from ..arguments import Array, refusal, whole
from .arguments import exponents

# A rule of so many takes a quarter of an hour.
_MOST_LEGENDRE_POINTS = 1_000_000
# Each root is sought from those found before, all in one go: more would take more than some seconds, which Ctrl-C does not end.
# Rules of much more are refused anyway, as their nodes merge with the ends.
_MOST_JACOBI_POINTS = 20_000
# More fill memory.
_MOST_ASYMPTOTIC_POINTS = 100_000_000


@overload
def roots_legendre(n: SupportsIndex, mu: Literal[False] = False) -> tuple[Array, Array]: ...
@overload
def roots_legendre(n: SupportsIndex, mu: Literal[True]) -> tuple[Array, Array, float]: ...
def roots_legendre(n: SupportsIndex, mu: bool = False) -> tuple[Array, Array] | tuple[Array, Array, float]:
    """Nodes and weights of the Gauss–Legendre rule: ∫₋₁¹ f(x) dx = Σ w_i f(x_i) for degrees ≤ 2n − 1.

    Parameters
    ----------
    n : int
        Number of points, 1 … 1 000 000. The cost is O(n²): 0.1 s for 10 000 points. Ctrl-C ends it.
    mu : bool
        Return the sum of the weights, 2, too.

    Returns
    -------
    x, w : ndarray of shape (n,)
        Nodes, ascending, and weights, each correctly rounded; symmetric to the last bit.
    mu : float
        The sum of the weights, if asked for.

    Raises
    ------
    Error
        If `n` is out of range.

    See Also
    --------
    legendre_asymptotic : O(n) and less exact, for thousands of points.
    """
    nodes, weights = _rule_arrays(n, 1, _MOST_LEGENDRE_POINTS, "give 1 point or more; legendre_asymptotic takes many")
    _core.legendre_rule(nodes, weights)
    return (nodes, weights, 2.0) if mu else (nodes, weights)


@overload
def legendre_asymptotic(n: SupportsIndex, mu: Literal[False] = False) -> tuple[Array, Array]: ...
@overload
def legendre_asymptotic(n: SupportsIndex, mu: Literal[True]) -> tuple[Array, Array, float]: ...
def legendre_asymptotic(n: SupportsIndex, mu: bool = False) -> tuple[Array, Array] | tuple[Array, Array, float]:
    """As :func:`roots_legendre` in O(n), nodes within 3 and weights within 4 ulp.

    Parameters
    ----------
    n : int
        Number of points, 101 … 100 000 000.
    mu : bool
        Return the sum of the weights, 2, too.

    Returns
    -------
    x, w : ndarray of shape (n,)
        Nodes, ascending, and weights.
    mu : float
        The sum of the weights, if asked for.

    Raises
    ------
    Error
        If `n` is out of range: below 101 the expansion does not hold.
    """
    nodes, weights = _rule_arrays(n, 101, _MOST_ASYMPTOTIC_POINTS, "take roots_legendre for fewer points")
    _core.asymptotic_rule(nodes, weights)
    return (nodes, weights, 2.0) if mu else (nodes, weights)


@overload
def roots_jacobi(n: SupportsIndex, alpha: float, beta: float, mu: Literal[False] = False) -> tuple[Array, Array]: ...
@overload
def roots_jacobi(n: SupportsIndex, alpha: float, beta: float, mu: Literal[True]) -> tuple[Array, Array, float]: ...
def roots_jacobi(n: SupportsIndex, alpha: float, beta: float, mu: bool = False) -> tuple[Array, Array] | tuple[Array, Array, float]:
    """Nodes and weights of the Gauss–Jacobi rule: ∫₋₁¹ f(x) (1 − x)^α (1 + x)^β dx = Σ w_i f(x_i) for degrees ≤ 2n − 1.

    Parameters
    ----------
    n : int
        Number of points, 1 … 20 000. The cost is O(n²): 0.6 s for 10 000 points.
    alpha, beta : float
        Exponents at the right end (α, at +1) and at the left end (β, at −1), above −1 and ≤ 256.
    mu : bool
        Return the sum of the weights too.

    Returns
    -------
    x, w : ndarray of shape (n,)
        Nodes, ascending, and weights, each correctly rounded, but for weights of nodes within 10⁻⁷ of an end (2 ulp).
        Weights below 10⁻²⁹⁰, which exponents above 100 may have, lose digits and may be 0.
    mu : float
        ∫₋₁¹ (1 − x)^α (1 + x)^β dx, the sum of the weights, if asked for.

    Raises
    ------
    Error
        If `n` or an exponent is out of range, or an exponent is so near −1 that, for this many points, a node would merge
        with the end of the interval (never for exponents ≥ −0.99 and n ≤ 1000).
    """
    alpha, beta = exponents(alpha, beta)
    nodes, weights = _rule_arrays(n, 1, _MOST_JACOBI_POINTS, "give 1 point or more; divide the interval where many are needed")
    try:
        _core.jacobi_rule(alpha, beta, nodes, weights)
    except ValueError as error:
        raise refusal(str(error), "take fewer points, or an exponent farther from −1") from None
    return (nodes, weights, _core.integral(alpha, beta)) if mu else (nodes, weights)


def triangle_rule(n: SupportsIndex) -> tuple[Array, Array]:
    """Points and weights of the collapsed Gauss rule on the triangle (−1, −1), (1, −1), (−1, 1).

    ∬ f(s, t) ds dt = Σ w_i f(s_i, t_i) for polynomials of total degree ≤ 2n − 1.

    Parameters
    ----------
    n : int
        Points along each side of the square that collapses to the triangle, 1 … 1000.

    Returns
    -------
    points : ndarray of shape (n², 2)
        (s, t) of each point, inside the triangle.
    weights : ndarray of shape (n²,)
        Positive, of sum 2, the area of the triangle.
    """
    n = whole("n", n, 1, 1000, "give 1 point or more; divide the triangle where many are needed")
    out = np.empty((n * n, 3))
    _core.triangle_rule(*roots_legendre(n), *roots_jacobi(n, 1, 0), out.reshape(-1))
    return out[:, :2], out[:, 2]


def _rule_arrays(n: SupportsIndex, least: int, most: int, cure: str) -> tuple[Array, Array]:
    n = whole("n", n, least, most, cure)
    return np.empty(n), np.empty(n)
