"""Conversions of coefficients between orthonormal Jacobi and Legendre polynomials."""

from __future__ import annotations

from typing import SupportsIndex

from numpy.typing import ArrayLike

from .._radiosity import _core
from ..arguments import Array, finite, refusal, whole


def jacobi_to_legendre(coefficients: ArrayLike, alpha: SupportsIndex, beta: SupportsIndex) -> Array:
    """Coefficients of orthonormal Jacobi polynomials → coefficients of orthonormal Legendre polynomials, of the same function.

    Parameters
    ----------
    coefficients : array_like of shape (..., m)
        c_0 … c_{m−1} along the last axis: Σ c_n p_n^(α,β) = Σ d_k p_k.
    alpha, beta : int
        Whole exponents, 0 … 255.

    Returns
    -------
    ndarray of shape (..., m)
        d_0 … d_{m−1}, d = A c, each to 12 ε Σ |A_kn c_n|. For α = β even and odd degrees stay apart, exactly.

    Raises
    ------
    Error
        If an exponent is not whole or out of range, or there is no coefficient.
    """
    return _convert(False, coefficients, alpha, beta)


def legendre_to_jacobi(coefficients: ArrayLike, alpha: SupportsIndex, beta: SupportsIndex) -> Array:
    """Coefficients of orthonormal Legendre polynomials → coefficients of orthonormal Jacobi polynomials, of the same function.

    Arguments, result and errors are those of :func:`jacobi_to_legendre`. Rounding adds as little, but errors
    that d holds already grow: there and back, c of size 1 returns to 5e-15 for (2, 2), m = 31, to 1e-8 for (10, 10), m = 61.
    """
    return _convert(True, coefficients, alpha, beta)


def _convert(backwards: bool, coefficients: ArrayLike, alpha: SupportsIndex, beta: SupportsIndex) -> Array:
    cure = "give whole exponents up to 255"
    alpha, beta = whole("alpha", alpha, 0, 255, cure), whole("beta", beta, 0, 255, cure)
    given = finite("coefficients", coefficients)
    if given.ndim == 0 or given.shape[-1] == 0:
        raise refusal(f"coefficients: an array of shape {given.shape} instead of (..., m)", "give one coefficient at least")
    out = given.copy()
    _core.convert(alpha, beta, backwards, out.shape[-1], out.reshape(-1))
    return out
