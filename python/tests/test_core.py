"""Gauss rules, polynomials and conversions: exactness, orthonormality, closed forms, tables of 28 digits, and SciPy beside them."""

import doctest
import json
import math
import threading
import time
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from radiosity import core

TABLES = Path(__file__).parents[2] / "core" / "tests" / "data"

sizes = st.integers(1, 60)
exponents = st.one_of(st.sampled_from([0.0, 0.5, -0.5, 1.0, 2.0]), st.floats(-0.95, 12.0))
points = st.floats(-1.0, 1.0)


def ulps(value: float, exact: str) -> float:
    """The distance of a float from a decimal number, in units of its last place."""
    return float(abs(Fraction(value) - Fraction(exact)) / Fraction(math.ulp(value)))


def integral(alpha: float, beta: float) -> float:
    """∫₋₁¹ (1 − x)^α (1 + x)^β dx = 2^(α+β+1) B(α + 1, β + 1)."""
    beta_function = math.lgamma(alpha + 1) + math.lgamma(beta + 1) - math.lgamma(alpha + beta + 2)
    return math.exp((alpha + beta + 1) * math.log(2) + beta_function)


@pytest.mark.parametrize("name", ["gauss_legendre", "gauss_jacobi"])
def test_rules_are_correctly_rounded(name):
    tables = json.loads((TABLES / f"{name}.json").read_text())["tables"]
    assert tables
    for table in tables:
        if name == "gauss_legendre":
            rule, own = core.roots_legendre(table["n"]), slice(table["n"] // 2, None)
        else:
            rule, own = core.roots_jacobi(table["n"], table["alpha"], table["beta"]), slice(None)
        for ours, exact in zip(rule, (table["x"], table["w"]), strict=True):
            errors = [ulps(float(value), text) for value, text in zip(ours[own], exact, strict=True) if value]
            assert max(errors, default=0.0) <= 0.5000001, table["n"]


@given(n=sizes, alpha=exponents, beta=exponents, power=st.integers(0, 119))
def test_rules_are_exact_to_degree_2n_minus_1(n, alpha, beta, power):
    x, w = core.roots_jacobi(n, alpha, beta)
    power %= 2 * n
    # ∫ (1 + x)^k W dx is the integral of the weight with β + k; no term cancels.
    assert (w * (1 + x) ** power).sum() == pytest.approx(integral(alpha, beta + power), rel=1e-11)
    assert (np.diff(x) > 0).all() and (w > 0).all() and abs(x).max() < 1


@given(n=sizes, alpha=exponents, beta=exponents)
def test_the_sum_of_the_weights_is_the_integral_of_the_weight(n, alpha, beta):
    x, w, mu = core.roots_jacobi(n, alpha, beta, mu=True)
    assert mu == pytest.approx(integral(alpha, beta), rel=1e-13)
    assert w.sum() == pytest.approx(mu, rel=1e-14)
    assert core.roots_legendre(n, mu=True)[2] == 2.0
    mirrored = core.roots_jacobi(n, beta, alpha)
    np.testing.assert_allclose(x, -mirrored[0][::-1], rtol=1e-15, atol=1e-23)
    np.testing.assert_allclose(w, mirrored[1][::-1], rtol=1e-15)


@given(n=st.integers(1, 200))
def test_legendre_rules_are_symmetric_to_the_last_bit(n):
    x, w = core.roots_legendre(n)
    assert (x == -x[::-1]).all() and (w == w[::-1]).all()


@pytest.mark.parametrize("n", [101, 250, 1000])
def test_the_asymptotic_rule_is_right_to_four_ulp(n):
    for ours, exact in zip(core.legendre_asymptotic(n, mu=True), core.roots_legendre(n, mu=True), strict=True):
        # The exact ones are within half an ulp.
        assert (abs(ours - exact) <= 4.5 * np.spacing(abs(exact))).all()


@settings(deadline=None)
@given(n=sizes, alpha=exponents, beta=exponents)
def test_rules_stand_beside_those_of_scipy(n, alpha, beta):
    special = pytest.importorskip("scipy.special")
    pairs = [(core.roots_legendre(n, True), special.roots_legendre(n, True))]
    if alpha + beta > -1:
        # SciPy 1.17 divides by 0 where α + β = −1, and by small numbers near it.
        pairs.append((core.roots_jacobi(n, alpha, beta, True), special.roots_jacobi(n, alpha, beta, True)))
    for ours, theirs in pairs:
        assert len(ours) == len(theirs) == 3
        np.testing.assert_allclose(ours[0], theirs[0], atol=1e-12)
        np.testing.assert_allclose(ours[1] / ours[2], theirs[1] / theirs[2], atol=1e-10)
        assert [part.shape for part in ours[:2]] == [part.shape for part in theirs[:2]]


@given(alpha=exponents, beta=exponents, n=st.integers(0, 30))
def test_orthonormal_polynomials_are_orthonormal(alpha, beta, n):
    x, w = core.roots_jacobi(n + 1, alpha, beta)
    p = core.orthonormal_jacobi(n, alpha, beta, x)
    assert p.shape == (n + 1, n + 1)
    np.testing.assert_allclose(p.T @ (w[:, None] * p), np.eye(n + 1), atol=1e-12)
    assert (core.orthonormal_jacobi(n, alpha, beta, 1.0) > 0).all()


@given(n=st.integers(0, 80), angle=st.floats(0.0, math.pi))
def test_chebyshev_polynomials_are_cosines(n, angle):
    # P_n^(−½,−½)(cos θ)/P_n(1) = cos nθ, and p_n = √(2/π) cos nθ for n > 0.
    x = math.cos(angle)
    value = core.eval_jacobi(n, -0.5, -0.5, x) / core.eval_jacobi(n, -0.5, -0.5, 1.0)
    # An error of x by half an ulp moves nθ by n ε/sin θ, and cos nθ by n² ε at the most.
    assert value == pytest.approx(math.cos(n * angle), abs=1e-14 + 2e-16 * n * n)
    p = core.orthonormal_jacobi(n, -0.5, -0.5, x)[n]
    factor = math.sqrt((2 if n else 1) / math.pi)
    assert p == pytest.approx(factor * math.cos(n * angle), abs=1e-14 + 2e-16 * n * n)


@given(n=st.integers(1, 60), x=st.lists(points, min_size=1, max_size=5))
def test_derivatives_follow_their_identity(n, x):
    # (1 − x²) P_n′ = n (P_{n−1} − x P_n), in orthonormal polynomials.
    x = np.array(x)
    p, slopes = core.orthonormal_legendre(n, x, derivatives=True)
    np.testing.assert_array_equal(p, core.orthonormal_legendre(n, x))
    norm = np.sqrt((n + 0.5) / (n - 0.5))
    right = n * (norm * p[:, n - 1] - x * p[:, n])
    np.testing.assert_allclose((1 - x**2) * slopes[:, n], right, atol=1e-13 * n**2)


@settings(deadline=None)
@given(
    n=st.lists(st.integers(0, 40), min_size=1, max_size=4),
    x=st.lists(points, min_size=1, max_size=3),
    alpha=exponents,
    beta=exponents,
)
def test_values_stand_beside_those_of_scipy(n, x, alpha, beta):
    special = pytest.importorskip("scipy.special")
    n, x = np.array(n)[:, None], np.array(x)
    ours, theirs = core.eval_legendre(n, x), special.eval_legendre(n, x)
    assert ours.shape == theirs.shape
    np.testing.assert_allclose(ours, theirs, atol=1e-11)
    ours, theirs = core.eval_jacobi(n, alpha, beta, x), special.eval_jacobi(n, alpha, beta, x)
    size = 1 + abs(special.eval_jacobi(n, alpha, beta, 1.0)) + abs(special.eval_jacobi(n, alpha, beta, -1.0))
    np.testing.assert_allclose(ours / size, theirs / size, atol=1e-10)


def test_exponents_broadcast_too():
    alpha, beta = np.array([0.0, 1.5, 0.0]), np.array([[0.0], [2.0]])
    values = core.eval_jacobi(4, alpha, beta, 0.3)
    assert values.shape == (2, 3)
    for i, j in np.ndindex(2, 3):
        assert values[i, j] == core.eval_jacobi(4, alpha[j], beta[i, 0], 0.3)
    assert isinstance(core.eval_legendre(2, 0.5), float)
    assert core.eval_legendre(2, 0.5) == -0.125


@given(
    c=st.lists(st.floats(-1, 1), min_size=1, max_size=20),
    alpha=st.integers(0, 3),
    beta=st.integers(0, 3),
    x=points,
)
def test_conversions_keep_the_function(c, alpha, beta, x):
    n = len(c) - 1
    d = core.jacobi_to_legendre(c, alpha, beta)
    value = core.orthonormal_jacobi(n, alpha, beta, x) @ np.array(c)
    assert core.legendre_sum(d, x) == pytest.approx(value, abs=1e-11 * (n + 1) ** 3)
    np.testing.assert_allclose(core.legendre_to_jacobi(d, alpha, beta), c, atol=1e-11)


def test_conversions_take_rows():
    rows = np.random.default_rng(1).normal(size=(3, 2, 7))
    together = core.jacobi_to_legendre(rows, 0, 2)
    assert together.shape == rows.shape
    np.testing.assert_array_equal(together[2, 1], core.jacobi_to_legendre(rows[2, 1], 0, 2))


def test_sums_of_nothing_are_nothing():
    assert core.legendre_sum([], 0.5) == 0.0
    assert core.orthonormal_legendre(3, []).shape == (0, 4)


@pytest.mark.parametrize("order", [0, 1, 5, 12])
def test_the_basis_of_the_triangle_is_orthonormal_and_its_rule_exact(order):
    points, weights = core.triangle_rule(order + 1)
    psi = core.orthonormal_triangle(order, points)
    np.testing.assert_allclose(psi.T @ (weights[:, None] * psi), np.eye(psi.shape[1]), atol=1e-13)
    # ∬ (1 + s)^a (1 + t)^b ds dt = 2^(a+b+2) a! b!/(a + b + 2)!
    for a in range(order + 2):
        for b in range(2 * order + 2 - a):
            exact = 2.0 ** (a + b + 2) * math.factorial(a) * math.factorial(b) / math.factorial(a + b + 2)
            assert (weights * (1 + points[:, 0]) ** a * (1 + points[:, 1]) ** b).sum() == pytest.approx(exact, rel=1e-13)


@pytest.mark.parametrize("order", [0, 1, 6])
def test_the_basis_of_the_square_is_orthonormal(order):
    x, w = core.roots_legendre(order + 1)
    places = np.stack(np.meshgrid(x, x), axis=-1)
    phi = core.orthonormal_square(order, places)
    assert phi.shape == (order + 1, order + 1, (order + 1) * (order + 2) // 2)
    gram = np.einsum("i,j,ijk,ijl->kl", w, w, phi, phi)
    np.testing.assert_allclose(gram, np.eye(phi.shape[-1]), atol=1e-13)


@pytest.mark.parametrize("basis", [core.orthonormal_square, core.orthonormal_triangle])
def test_gradients_are_limits_of_difference_quotients(basis):
    place, step = np.array([-0.35, 0.2]), 1e-5
    values, slopes = basis(5, place, gradients=True)
    np.testing.assert_array_equal(values, basis(5, place))
    for axis in range(2):
        shift = np.eye(2)[axis] * step
        quotient = (basis(5, place + shift) - basis(5, place - shift)) / (2 * step)
        np.testing.assert_allclose(slopes[axis], quotient, atol=1e-7)


@pytest.mark.parametrize(
    "turn",
    [
        lambda x: np.repeat(x, 2, axis=-1)[..., ::2],
        lambda x: np.asfortranarray(x),
        lambda x: x[::-1][::-1],
        lambda x: x.astype(">f8"),
        lambda x: x.tolist(),
    ],
)
def test_arrays_of_any_layout_are_read_and_left_as_they_are(turn):
    x = np.linspace(-1, 1, 12)
    rows = np.random.default_rng(2).normal(size=(4, 12))
    for array in (x, rows):
        array.flags.writeable = False
    np.testing.assert_array_equal(core.eval_jacobi(5, 0.5, 1.5, turn(x)), core.eval_jacobi(5, 0.5, 1.5, x))
    np.testing.assert_array_equal(core.jacobi_to_legendre(turn(rows), 0, 2), core.jacobi_to_legendre(rows, 0, 2))


def test_the_examples_of_the_documentation_run():
    assert doctest.testmod(core).attempted >= 3
    assert doctest.testmod(core).failed == 0


def test_other_threads_run_beside_a_large_rule():
    worker = threading.Thread(target=core.roots_legendre, args=(20_000,))
    worker.start()
    turns = 0
    while worker.is_alive():
        time.sleep(0.001)
        turns += 1
    assert turns > 10


REFUSED = [
    (lambda: core.roots_legendre(0), "n = 0 is not in 1 … 1000000"),
    (lambda: core.roots_legendre(10**30), "n = ±10^"),
    (lambda: core.roots_legendre(2.5), "give a whole number"),
    (lambda: core.roots_legendre(math.nan), "give a whole number"),
    (lambda: core.legendre_asymptotic(100), "take roots_legendre for fewer"),
    (lambda: core.roots_jacobi(4, -1.0, 0), "alpha = -1.0 is no exponent"),
    (lambda: core.roots_jacobi(4, 0, math.nan), "beta = nan is no exponent"),
    (lambda: core.roots_jacobi(4, 0, math.inf), "at most 256"),
    (lambda: core.roots_jacobi(4, [0, 1], 0), "shape (2,) instead of one number"),
    (lambda: core.roots_jacobi(18_000, 0.5, 0), "take fewer points"),
    (lambda: core.eval_legendre(-1, 0.0), "no degree"),
    (lambda: core.eval_legendre([1, 2], [0.1, 0.2, 0.3]), "n (2,), alpha (), beta (), x (3,)"),
    (lambda: core.eval_legendre(3, 1.5), "map your interval to [−1, 1]"),
    (lambda: core.eval_legendre(3, [[0.0], [0.1, 0.2]]), "rows of different lengths"),
    (lambda: core.eval_jacobi(10_000, 256.0, 0.0, 1.0), "orthonormal_jacobi"),
    (lambda: core.legendre_sum([[1.0]], 0.0), "shape (1, 1) instead of (m,)"),
    (lambda: core.legendre_sum([math.inf], 0.0), "finite"),
    (lambda: core.jacobi_to_legendre([], 0, 2), "instead of (..., m)"),
    (lambda: core.jacobi_to_legendre([1.0], 0.5, 2), "give a whole number"),
    (lambda: core.orthonormal_square(64, [0.0, 0.0]), "order = 64 is not in 0 … 63"),
    (lambda: core.orthonormal_triangle(2, [0.5, 0.6]), "s + t ≤ 0"),
    (lambda: core.orthonormal_triangle(2, [0.5]), "instead of (..., 2)"),
]


@pytest.mark.parametrize(("call", "text"), REFUSED)
def test_refusals_name_the_argument_and_the_cure(call, text):
    import radiosity

    with pytest.raises(radiosity.Error) as caught:
        call()
    assert text in str(caught.value)


@pytest.mark.parametrize("n", ["3", None, [3], 2 + 1j])
def test_what_is_no_number_is_a_type_error(n):
    with pytest.raises(TypeError, match="n: a whole number is wanted"):
        core.roots_legendre(n)
    with pytest.raises(TypeError, match="real numbers are wanted"):
        core.eval_legendre(2, np.array([n], dtype=object))
