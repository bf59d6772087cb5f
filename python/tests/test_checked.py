"""Errors that are told of light, and what path tracing finds of it."""

from __future__ import annotations

import pickle
import warnings

import numpy as np
import pytest

import radiosity

# A closed room of reflectance ½ that emits 1 everywhere: 2 arrives at every point.
FURNACE = "furnace-cube"
CENTRES = np.array([[x, y, 0.5] for x in (0.2, 0.4, 0.6, 0.8) for y in (0.3, 0.7)])
UP = [0, 0, 1]

# Light that is even over surfaces is off near their edges, by more than its method tells.
FINDS_MORE = "path tracing finds more"


@pytest.fixture(scope="module")
def furnace() -> radiosity.Solution:
    return radiosity.load(FURNACE).solve()


@pytest.fixture(scope="module")
def even() -> radiosity.Solution:
    return radiosity.load("empty-box").solve(order=0, subdivide=1)


def test_light_of_a_furnace_errs_by_less_than_is_told(furnace):
    values, errors, checked = furnace.irradiance(CENTRES, UP, errors=True)
    assert (abs(values[:, 0] - 2) < 3 * errors).all() and (errors < 0.02).all()
    assert checked["error_factor"] == 1 and checked["error"] < 3 * checked["error_sd"] + 1e-12
    assert checked["audit"]["readings"] == len(CENTRES) and checked["audit"]["rays"] > 1000
    assert checked["line"].startswith("checked at 8 readings by path tracing: no ")


def test_light_that_is_off_errs_by_as_much_as_is_told(even):
    with pytest.warns(radiosity.RadiosityWarning, match=FINDS_MORE):
        rough = even.grid((8, 8), read="basis")
    right = radiosity.load("empty-box").solve(quality="fine").grid((8, 8))["irradiance"]
    true = np.sqrt(((rough["irradiance"] - right) ** 2).mean())
    told = np.sqrt((rough["error"] ** 2).mean())
    assert 0.5 < told / true < 2 and rough["checked"]["error_factor"] > 3
    assert rough["checked"]["error"] == pytest.approx(true / np.sqrt((right**2).mean()), rel=0.5)


def test_arrays_alone_are_checked_where_that_is_asked_for(even):
    places = radiosity.audit(even, readings=12, seconds=0.01)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        alone = even.irradiance(places.positions, places.normals, read="basis")
    looked = []
    for asked in ({"errors": True}, {"errors": True, "audit": 0.4}, {"audit": 0.4}):
        with pytest.warns(radiosity.RadiosityWarning, match=FINDS_MORE):
            looked.append(even.irradiance(places.positions, places.normals, read="basis", **asked))
    assert np.array_equal(looked[0].values, alone) and np.array_equal(looked[2], alone)
    rays = [found.checked["audit"]["rays"] for found in looked[:2]]
    assert rays[1] > 2 * rays[0]


def test_no_time_to_look_is_refused(furnace):
    with pytest.raises(radiosity.Error, match="audit=0 cannot be(.|\n)*expected seconds, above 0"):
        furnace.irradiance(CENTRES, UP, audit=0)


def test_pictures_are_checked_where_that_is_asked_for(even):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        alone = even.render(size=(24, 24), read="basis")
    with pytest.warns(radiosity.RadiosityWarning, match=FINDS_MORE):
        checked = even.render(size=(24, 24), read="basis", audit=0.3)
    assert np.array_equal(alone, checked)
    with pytest.raises(radiosity.Error, match="audit= checks pictures of radiosity"):
        even.render(size=(24, 24), show="irradiance", audit=0.3)


def test_solutions_are_checked_when_they_are_asked(furnace):
    report = furnace.report
    assert furnace.checked["error_factor"] == report["error_factor"] == 1
    assert furnace.checked["audit"] == report["audit"] and report["audit"]["readings"] > 32
    with pytest.warns(radiosity.RadiosityWarning, match=FINDS_MORE):
        radiosity.load("hinge-squares").solve(order=0, subdivide=1, eps=1e-4, audit=0.3).report


def test_planes_pickle_with_their_check(furnace):
    plane = furnace.plane([0.2, 0.2, 0.5], [0.6, 0, 0], [0, 0.5, 0], 0.2)
    kept = pickle.loads(pickle.dumps(plane))
    assert kept.checked == plane.checked is not None
    assert np.array_equal(kept.error, plane.error) and kept.mean_error == plane.mean_error
    assert (kept.to_pandas()["error"] == plane.error.ravel()).all()
    assert abs(plane.mean[0] - 2) < 3 * plane.mean_error < 0.06


def test_frames_are_checked_where_that_is_asked_for():
    stage = radiosity.Stage(radiosity.load("sliding-light"))
    frame = stage.frame()
    edges = [0.5, 0.5, 0.3], [1, 0, 0], [0, 1, 0], 0.5
    silent, looked = frame.plane(*edges), frame.plane(*edges, audit=0.2)
    assert silent.checked is None and (silent.error > 0).all()
    assert looked.checked["audit"]["readings"] == 4
    assert np.array_equal(looked.values, silent.values)
    assert (looked.error >= silent.error).all()


def test_other_light_than_that_of_path_tracing_is_not_checked():
    with pytest.warns(radiosity.RadiosityWarning, match="more power is absorbed than emitted"):
        bare = radiosity.load("two-boxes").solve(shadows="off", quality="quick")
    assert bare.checked is None and "audit" not in bare.report
    assert bare.grid((2, 2))["checked"] is None
    for ask in (lambda: bare.grid((2, 2), audit=1), lambda: radiosity.load("two-boxes").solve(shadows="off", audit=1)):
        with pytest.raises(radiosity.Error, match="finds other light than path tracing, which audit= asks for"):
            ask()
