"""What is known exactly."""

from __future__ import annotations

import math

import numpy as np
import pytest
import scipy.constants

import radiosity

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], float)


def opposite_squares(distance: float) -> float:
    """View factor of unit squares face to face (Howell, Catalogue of radiation heat transfer configuration factors, C-11)."""
    x = y = 1 / distance
    a, b = 1 + x * x, 1 + y * y
    return (2 / (math.pi * x * y)) * (
        math.log(math.sqrt(a * b / (a + y * y)))
        + x * math.sqrt(b) * math.atan(x / math.sqrt(b))
        + y * math.sqrt(a) * math.atan(y / math.sqrt(a))
        - x * math.atan(x)
        - y * math.atan(y)
    )


@pytest.mark.parametrize("distance", [0.01, 1.0, 30.0])
def test_the_view_factor_of_opposite_squares(distance: float):
    other = SQUARE[::-1] + [0, 0, distance]
    factor = radiosity.view_factor(SQUARE, other, eps=1e-9)
    assert factor == pytest.approx(opposite_squares(distance), rel=1e-9)
    assert radiosity.view_factor(SQUARE, SQUARE + [0, 0, distance]) == 0, "the back of the other one is black"
    between = np.array([[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]]) + [0, 0, distance / 2]
    assert radiosity.view_factor(SQUARE, other, blockers=[between]) == 0


def cube() -> np.ndarray:
    """The faces of the unit cube (6, 4, 3), fronts inside."""
    floor = SQUARE
    ceiling = SQUARE[::-1] + [0, 0, 1]
    turn = np.array([[0, 0, 1], [1, 0, 0], [0, 1, 0]], float)
    return np.array([face @ rotation for rotation in (np.eye(3), turn, turn @ turn) for face in (floor, ceiling)])


def test_rows_of_a_closed_room_sum_to_one():
    factors = radiosity.view_factors(cube(), eps=1e-9)
    assert factors.matrix.shape == (6, 6)
    assert np.allclose(factors.row_sums, 1, atol=1e-8)
    assert np.allclose(factors.areas, 1, atol=1e-15)
    # Adjacent walls share what the opposite one leaves.
    assert factors.matrix[0, 1] == pytest.approx(opposite_squares(1), rel=1e-9)
    assert factors.matrix[0, 2] == pytest.approx((1 - opposite_squares(1)) / 4, rel=1e-8)


def test_errors_of_view_factors_are_told_and_judged():
    exact = radiosity.view_factors(cube())
    assert exact.checked is None and (exact.errors < 1e-15).all()
    looked = radiosity.view_factors(cube(), audit=0.1)
    assert looked.checked["audit"]["rays"] > 0 and looked.checked["error_factor"] == 1
    assert np.array_equal(looked.errors, exact.errors)


@pytest.mark.parametrize("reflectance", [0.2, 0.9])
def test_a_furnace(reflectance: float):
    scene = radiosity.Scene(bands=["a", "b"])
    wall = scene.material("wall", reflectance=[reflectance, 0.5], emission=[1.0, 3.0])
    scene.polygons("wall", cube(), wall)
    solution = scene.solve(eps=1e-6, progress=False)
    expected = np.array([1 / (1 - reflectance), 3 / (1 - 0.5)])
    light = solution.irradiance([[0.5, 0.5, 0.5], [0.2, 0.3, 0.4]], [[0, 0, 1], [1, 1, 1]], read_eps=1e-6)
    assert light.shape == (2, 2)
    assert np.allclose(light, expected, rtol=1e-4)
    # ∫ B² dA over a face of area 1.
    assert solution.coefficients.shape[0] == 2
    energy = (solution.coefficients**2).sum(axis=1) / 6
    assert np.allclose(energy, expected**2, rtol=1e-5)


@pytest.mark.parametrize(("inner", "outer"), [(0.3, 0.9), (1.0, 0.2)])
def test_heat_between_two_spheres(inner: float, outer: float):
    """Q = A₁ σ (T₁⁴ − T₂⁴) / (1/ε₁ + (A₁/A₂)(1/ε₂ − 1)) for a sphere in another (Modest, Radiative Heat Transfer, 5.4)."""
    scene = radiosity.Scene()
    hot = scene.material("hot", emissivity=inner, temperature=800)
    cold = scene.material("cold", emissivity=outer, temperature=300)
    scene.sphere("inner", hot, center=[0, 0, 0], radius=0.5)
    scene.sphere("outer", cold, center=[0, 0, 0], radius=1, flip=True)
    heat = scene.heat(order=1, progress=False)
    area = math.pi
    flow = area * scipy.constants.sigma * (800**4 - 300**4) / (1 / inner + 0.25 * (1 / outer - 1))
    assert heat.names == ["inner", "outer"]
    assert heat.power == pytest.approx([flow, -flow], rel=1e-4)
    assert heat.temperature.tolist() == [800, 300]
    assert heat.is_closed


def test_a_sweep_of_heat_between_two_spheres():
    scene = radiosity.Scene()
    hot = scene.material("hot", emissivity=0.7, temperature=800)
    cold = scene.material("cold", emissivity=0.5, temperature=300)
    scene.sphere("inner", hot, center=[0, 0, 0], radius=0.5)
    scene.sphere("outer", cold, center=[0, 0, 0], radius=1, flip=True)
    emissivities = np.linspace(0.9, 0.1, 5)
    heats = scene.heat_sweep("cold.emissivity", emissivities, order=0, progress=False)
    flow = math.pi * scipy.constants.sigma * (800**4 - 300**4) / (1 / 0.7 + 0.25 * (1 / emissivities - 1))
    assert [heat.power[0] for heat in heats] == pytest.approx(flow.tolist(), rel=1e-9)
    assert [heat.checked is not None for heat in heats] == [True] + [False] * 4, "the largest flow is checked"
    assert scene.heat_sweep("hot.temperature", [], progress=False) == []
    with pytest.raises(radiosity.Error, match="warm(.|\n)*hot"):
        scene.heat_sweep("warm.temperature", [300.0], progress=False)
    with pytest.raises(radiosity.Error, match="temperature, heat_flux, emissivity"):
        scene.heat_sweep("hot.reflectance", [0.5], progress=False)


def test_a_point_light_by_the_square_of_its_distance():
    scene = radiosity.Scene(bands=["lm"], unit="lx")
    black = scene.material("black", reflectance=0)
    scene.disk("floor", black, center=[0, 0, 0], normal=[0, 0, 1], radius=5)
    scene.luminaire("bulb", position=[0, 0, 2], point={}, intensity=100)
    scene.plane("floor", origin=[-1, -1, 0], u=[2, 0, 0], v=[0, 2, 0], spacing=0.5)
    plane = scene.solve(progress=False).plane("floor")
    distance = np.linalg.norm(plane.points - [0, 0, 2], axis=-1)
    # Light on a surface is read a little before it.
    assert np.allclose(plane.values[..., 0], 100 * 2 / distance**3, rtol=1e-6)
    assert plane.u0 == pytest.approx(plane.values.min() / plane.values.mean())
