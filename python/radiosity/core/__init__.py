"""Gauss rules, orthogonal polynomials and conversions on arrays.

    >>> from radiosity.core import roots_jacobi
    >>> x, w = roots_jacobi(3, 0, 2)                 # ∫ f(x) (1 + x)² dx = Σ w f(x) on [−1, 1]
    >>> print(f"{(w * x**4).sum():.14f}")            # 2/5 + 2/7, exact because 4 ≤ 2·3 − 1
    0.68571428571429

:func:`roots_legendre`, :func:`roots_jacobi`, :func:`eval_legendre` and :func:`eval_jacobi` take the arguments of the functions
of these names in ``scipy.special`` and return arrays of the same shapes in the same order; for rules and values of whole degree
on [−1, 1] an import is all that changes.

Polynomials are *classical* (P_n, with P_n(1) = C(n + α, n), as in SciPy) or *orthonormal* (p_n = P_n/‖P_n‖, with
∫ p_m p_n (1 − x)^α (1 + x)^β dx = δ_mn and p_n(1) > 0), as the name of the function says. All points lie in [−1, 1];
−1 < α, β ≤ 256.

Accuracy (``python/benches/core_accuracy.py`` prints the table in ``python/README.md``): nodes and weights of
:func:`roots_legendre` and :func:`roots_jacobi` are correctly rounded, those of :func:`legendre_asymptotic` are right to 4 ulp;
values lose a few ε of √(p_n² + p_{n−1}²) for n ≤ 32 and are exact at ±1.

Source: NIST Digital Library of Mathematical Functions, chapter 18; the derivations stand in the sources of the crate
``radiosity-core``. Everything here has no unit. Large work runs beside other threads of Python.
"""

from .arguments import LARGEST_DEGREE, LARGEST_EXPONENT
from .bases import orthonormal_square, orthonormal_triangle
from .conversions import jacobi_to_legendre, legendre_to_jacobi
from .polynomials import eval_jacobi, eval_legendre, legendre_sum, orthonormal_jacobi, orthonormal_legendre
from .rules import legendre_asymptotic, roots_jacobi, roots_legendre, triangle_rule

__all__ = [
    "LARGEST_DEGREE",
    "LARGEST_EXPONENT",
    "eval_jacobi",
    "eval_legendre",
    "jacobi_to_legendre",
    "legendre_asymptotic",
    "legendre_sum",
    "legendre_to_jacobi",
    "orthonormal_jacobi",
    "orthonormal_legendre",
    "orthonormal_square",
    "orthonormal_triangle",
    "roots_jacobi",
    "roots_legendre",
    "triangle_rule",
]
