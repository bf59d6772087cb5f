"""Results pickle and copy: what they hold is the same without the library that computed it."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import radiosity


def again(result):
    """The result, pickled and read, and copied."""
    read = pickle.loads(pickle.dumps(result))
    return [read, copy.deepcopy(result), pickle.loads(pickle.dumps(read))]


def same(one, other) -> bool:
    return one == other if not isinstance(one, np.ndarray) else np.array_equal(one, other, equal_nan=True)


def held(result) -> list[str]:
    """Names of all properties of a result."""
    return [name for name in dir(type(result)) if not name.startswith("_") and not callable(getattr(type(result), name))]


@pytest.mark.parametrize("conductances", [False, True])
def test_heat_pickles(conductances: bool):
    heat = radiosity.load("oven").heat(order=1, conductances=conductances)
    for read in again(heat):
        assert len(held(heat)) > 12
        assert all(same(getattr(heat, name), getattr(read, name)) for name in held(heat))
        assert repr(read) == repr(heat)
    assert (heat.conductances is None) != conductances


@pytest.mark.parametrize("options", [{}, {"pairs": [("floor", "ceiling")]}])
def test_view_factors_pickle(options):
    factors = radiosity.view_factors(radiosity.load("empty-box"), **options)
    for read in again(factors):
        assert len(held(factors)) > 7
        assert all(same(getattr(factors, name), getattr(read, name)) for name in held(factors))


def test_sparse_view_factors_pickle():
    factors = radiosity.view_factors(radiosity.load("two-boxes"), sparse=True)
    for read in again(factors):
        assert (read.matrix != factors.matrix).nnz == 0 and read.matrix.shape == factors.matrix.shape


def test_a_plane_pickles():
    plane = radiosity.load("empty-box").solve().plane([0.2, 0.2, 0.1], [0.6, 0, 0], [0, 0.6, 0], 0.2)
    for read in again(plane):
        assert all(same(getattr(plane, name), getattr(read, name)) for name in [*held(plane), "name", "bands", "unit"])
