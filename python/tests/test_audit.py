"""Light judged by path tracing, against a closed form and beside the command."""

import json
import pickle

import numpy as np
import pytest

import radiosity

# A closed room of reflectance ½ that emits 1 everywhere: 2 arrives at every point.
FURNACE = "furnace-cube"


def test_furnaces_are_right():
    audit = radiosity.audit(radiosity.load(FURNACE), seconds=0.2, readings=24)
    assert audit.positions.shape == audit.normals.shape == (24, 3)
    assert audit.printed.shape == audit.found.shape == audit.found_error.shape == (24, 1)
    np.testing.assert_allclose(audit.printed, 2, rtol=2e-3)
    assert (abs(audit.found - 2) < 6 * audit.found_error + 1e-9).all()
    assert not audit.finds_more and audit.unread == 0 and audit.rays > 24 * audit.walks
    assert str(audit).startswith("checked at 24 readings by path tracing: no error above ")
    assert set(audit.names) == set(radiosity.load(FURNACE).surfaces)


def test_light_without_shadows_is_found():
    audit = radiosity.audit(radiosity.load("two-boxes").solve(shadows="off"), seconds=0.3)
    assert audit.finds_more and audit.error > 3 * audit.error_sd
    worst = audit.worst[0]
    assert abs(audit.printed - audit.found).max() == abs(worst["printed"] - worst["found"]["value"])
    assert any(mean["is_finding"] for mean in audit.signed)


def test_it_is_what_the_command_prints(command):
    told = json.loads(command("audit", FURNACE, "--seconds", "0.1", "--readings", "12", "--seed", "3", "--format", "json"))
    audit = radiosity.audit(radiosity.load(FURNACE), seconds=0.1, readings=12, seed=3)
    assert [point["found"] for point in told["points"]] == audit.found.tolist()
    assert (told["error"], told["visible"], told["rays"]) == (audit.error, audit.visible, audit.rays)
    assert told["signed"] == audit.signed and told["worst"] == audit.worst


def test_it_pickles():
    audit = radiosity.audit(radiosity.load(FURNACE), seconds=0.1, readings=8)
    kept = pickle.loads(pickle.dumps(audit))
    np.testing.assert_array_equal(kept.found, audit.found)
    assert (str(kept), kept.signed) == (str(audit), audit.signed)


@pytest.mark.parametrize(
    "given, message",
    [
        ({"seconds": -1}, "expected seconds, above 0"),
        ({"readings": 0}, "expected a whole number from 2"),
        ({"readings": 2.5}, "readings"),
        ({"rays": 3}, "unexpected keyword argument 'rays'"),
    ],
)
def test_wrong_arguments_are_refused(given, message):
    with pytest.raises((radiosity.Error, TypeError), match=message):
        radiosity.audit(radiosity.load(FURNACE), **given)


def test_what_is_no_light_is_refused():
    with pytest.raises(TypeError, match="a Scene or a Solution is wanted, not str"):
        radiosity.audit(FURNACE)
    with pytest.raises(radiosity.Error, match="the referee judges all light"):
        radiosity.audit(radiosity.load(FURNACE).solve(bounces=1))
