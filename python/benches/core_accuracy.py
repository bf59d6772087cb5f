"""How many digits do the rules and polynomials of radiosity.core keep, beside those of SciPy?

    python python/benches/core_accuracy.py

Prints a table in Markdown. Exact numbers are those of mpmath in 60 digits. Nodes and weights: worst error in units in the last
place; 0.5 is correct rounding. Values: worst error in ε of √(p_n² + p_{n−1}²), n ≤ 32, at points that are dense towards both ends.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterable

import mpmath as mp
import numpy as np
import scipy
from scipy import special

from radiosity import core

mp.mp.dps = 60

FEW = range(1, 34)
SOME = (50, 64, 100, 101)
MANY = (256, 1000)
WHOLE = [(0, 2), (2, 0), (2, 2), (0, 30), (30, 17)]
BROKEN = [(0.5, 0.5), (1.5, 0.25), (0.3, -0.3), (-0.3, -0.6), (-0.9, -0.9), (-0.95, 8.5)]
NODES_LOOKED_AT = 12


def jacobi(n: int, a: mp.mpf, b: mp.mpf, x: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """P_n and P_{n−1} by the recurrence 18.9.2 of DLMF."""
    before, last = mp.mpf(0), mp.mpf(1)
    for k in range(n):
        if k == 0:
            before, last = last, (a + b + 2) / 2 * x + (a - b) / 2
            continue
        s = 2 * k + a + b
        below = 2 * (k + 1) * (k + a + b + 1) * s
        rise = (s + 1) * (s * (s + 2) * x + a * a - b * b)
        before, last = last, (rise * last - 2 * (k + a) * (k + b) * (s + 2) * before) / below
    return last, before


def slope(n: int, a: mp.mpf, b: mp.mpf, x: mp.mpf) -> tuple[mp.mpf, mp.mpf]:
    """P_n and P_n′ by 18.9.17 of DLMF."""
    last, before = jacobi(n, a, b, x)
    s = 2 * n + a + b
    return last, (n * (a - b - s * x) * last + 2 * (n + a) * (n + b) * before) / (s * (1 - x * x))


def exact_node(n: int, a: mp.mpf, b: mp.mpf, near: float) -> tuple[mp.mpf, mp.mpf]:
    """The root near a float, and its weight."""
    x = mp.mpf(near)
    for _ in range(3):
        value, rate = slope(n, a, b, x)
        x -= value / rate
    _, rate = slope(n, a, b, x)
    gammas = mp.gammaprod([n + a + 1, n + b + 1], [n + a + b + 1, n + 1]) if n + a + b + 1 else mp.mpf(1)
    return x, gammas * mp.power(2, a + b + 1) / ((1 - x * x) * rate**2)


def ulps(value: float, exact: mp.mpf) -> float:
    return float(abs(mp.mpf(value) - exact) / mp.mpf(math.ulp(float(exact))))


def worst_of_rules(
    rule: Callable[[int, float, float], tuple[np.ndarray, np.ndarray]],
    exponents: Iterable[tuple[float, float]],
    sizes: Iterable[int],
) -> tuple[float, float]:
    """The worst errors of nodes and weights in ulp."""
    nodes = weights = 0.0
    for alpha, beta in exponents:
        for n in sizes:
            x, w = rule(n, alpha, beta)
            for i in range(0, n, -(-n // NODES_LOOKED_AT)):
                if not (math.isfinite(x[i]) and abs(x[i]) < 1):
                    nodes = weights = math.inf
                    continue
                node, weight = exact_node(n, mp.mpf(alpha), mp.mpf(beta), float(x[i]))
                # A node that is 0 has no last place.
                nodes = max(nodes, ulps(x[i], node)) if abs(node) > 1e-30 else nodes
                weights = max(weights, ulps(w[i], weight))
    return nodes, weights


def worst_of_values(values: Callable[[int, float, float, float], float], alpha: float, beta: float) -> float:
    """The worst error of p_n in ε of √(p_n² + p_{n−1}²)."""
    inside = [-0.98 + 0.14 * i for i in range(15)]
    ends = [turn * (1 - 0.5**i) for i in (8, 20, 35, 52) for turn in (1, -1)]
    a, b = mp.mpf(alpha), mp.mpf(beta)
    worst = 0.0
    for n in (1, 2, 3, 5, 8, 13, 20, 32):
        for x in inside + ends:
            last, before = (p / norm(k, a, b) for k, p in zip((n, n - 1), jacobi(n, a, b, mp.mpf(x))))
            error = abs(mp.mpf(values(n, alpha, beta, x)) - last) / mp.sqrt(last**2 + before**2)
            worst = max(worst, float(error / mp.mpf(2) ** -52))
    return worst


def norm(n: int, a: mp.mpf, b: mp.mpf) -> mp.mpf:
    """‖P_n‖, 18.3.1 of DLMF."""
    if n == 0:
        return mp.sqrt(mp.power(2, a + b + 1) * mp.beta(a + 1, b + 1))
    gammas = mp.gammaprod([n + a + 1, n + b + 1], [n + a + b + 1, n + 1])
    return mp.sqrt(mp.power(2, a + b + 1) / (2 * n + a + b + 1) * gammas)


def ours(n: int, alpha: float, beta: float) -> tuple[np.ndarray, np.ndarray]:
    return core.roots_legendre(n) if alpha == beta == 0 else core.roots_jacobi(n, alpha, beta)


def theirs(n: int, alpha: float, beta: float) -> tuple[np.ndarray, np.ndarray]:
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return special.roots_legendre(n) if alpha == beta == 0 else special.roots_jacobi(n, alpha, beta)


def fast(n: int, alpha: float, beta: float) -> tuple[np.ndarray, np.ndarray]:
    return core.legendre_asymptotic(n)


def our_value(n: int, alpha: float, beta: float, x: float) -> float:
    return core.orthonormal_jacobi(n, alpha, beta, x)[n]


def their_value(n: int, alpha: float, beta: float, x: float) -> float:
    return special.eval_jacobi(n, alpha, beta, x) / float(norm(n, mp.mpf(alpha), mp.mpf(beta)))


def shown(value: float) -> str:
    return "none" if math.isinf(value) else f"{value:.3f}" if value < 1 else f"{value:.2g}"


def main() -> None:
    print(f"| worst error in ulp | radiosity: nodes, weights | SciPy {scipy.__version__}: nodes, weights |")
    print("| --- | --- | --- |")
    rules = [
        ("Legendre, n ≤ 33", ours, [(0, 0)], FEW),
        ("Legendre, n = 50 … 101", ours, [(0, 0)], SOME),
        ("Legendre, n = 256, 1000", ours, [(0, 0)], MANY),
        ("`legendre_asymptotic`, n = 101, 256, 1000", fast, [(0, 0)], (101, *MANY)),
        ("Jacobi, whole exponents to 30, n ≤ 33", ours, WHOLE, FEW),
        ("Jacobi, whole exponents to 30, n = 50 … 101", ours, WHOLE, SOME),
        ("Jacobi, broken exponents, n ≤ 33", ours, BROKEN, FEW),
        ("Jacobi, broken exponents, n = 50 … 101", ours, BROKEN, SOME),
    ]
    for name, rule, exponents, sizes in rules:
        row = [worst_of_rules(made, exponents, sizes) for made in (rule, theirs)]
        print(f"| {name} | {' | '.join(', '.join(map(shown, errors)) for errors in row)} |", flush=True)
    print("\n| worst error of p_n, n ≤ 32, in ε of √(p_n² + p_{n−1}²) | radiosity | SciPy |")
    print("| --- | --- | --- |")
    for alpha, beta in [(0, 0), (0, 2), (2, 2), (1.5, 0.25), (-0.9, -0.9)]:
        errors = [worst_of_values(values, alpha, beta) for values in (our_value, their_value)]
        print(f"| α = {alpha}, β = {beta} | {' | '.join(map(shown, errors))} |", flush=True)


if __name__ == "__main__":
    main()
