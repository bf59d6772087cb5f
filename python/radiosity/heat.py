"""Balances of radiant heat."""

from __future__ import annotations

from functools import cached_property
from typing import Any

from . import _radiosity
from .arguments import Array
from .checked import Checked, checked
from .kept import Kept
from .tables import surfaces_frame


class Heat(Kept):
    """Temperatures and flows of radiant heat of n surfaces; arrays are of shape (n,). It pickles."""

    _FOUND = ("temperature", "temperature_error", "flux", "power", "power_error", "radiosity", "irradiance")
    _KEPT = ("names", "areas", "emissivity", *_FOUND, "lost", "is_closed", "conductances", "surroundings", "checked", "remarks")

    def __init__(self, native: _radiosity.Heat) -> None:
        self._native: _radiosity.Heat = native

    @property
    def names(self) -> list[str]:
        """Names of the surfaces."""
        return self._native.names

    @property
    def areas(self) -> Array:
        """Areas (m²)."""
        return self._native.areas

    @property
    def emissivity(self) -> Array:
        """Emissivities; nan where none is known."""
        return self._native.emissivity

    @property
    def temperature(self) -> Array:
        """Temperatures (K), given or found; of a surface of known flux that of its mean σT⁴; nan where nothing sets them."""
        return self._native.temperature

    @property
    def temperature_error(self) -> Array:
        """By how much the temperatures may be off (K), by the balance's own estimate and by `checked`; 0 where they are given."""
        return self._native.temperature_error

    @property
    def flux(self) -> Array:
        """Net fluxes (W/m²): heat that leaves a surface as radiation, over its area."""
        return self._native.flux

    @property
    def power(self) -> Array:
        """Net flows (W): flux times area."""
        return self._native.power

    @property
    def power_error(self) -> Array:
        """By how much the flows may be off (W), by the balance's own estimate and by `checked`; 0 where they are given."""
        return self._native.power_error

    @property
    def radiosity(self) -> Array:
        """What leaves each surface (W/m²)."""
        return self._native.radiosity

    @property
    def irradiance(self) -> Array:
        """What arrives at each surface (W/m²)."""
        return self._native.irradiance

    @property
    def lost(self) -> float:
        """Flow (W) that leaves the scene, to surroundings at 0 K; in a closed scene how well the balance closes."""
        return self._native.lost

    @property
    def is_closed(self) -> bool:
        """Whether hardly any heat leaves the scene."""
        return self._native.is_closed

    @cached_property
    def conductances(self) -> Array | None:
        """C (m²), an array (n, n), with `conductances=True`: from i to j flow C_ij σ (T_i⁴ − T_j⁴) watts."""
        return self._native.conductances

    @property
    def surroundings(self) -> Array | None:
        """Conductances to the surroundings (m²), with `conductances=True`."""
        return self._native.surroundings

    @property
    def checked(self) -> Checked | None:
        """What path tracing found of the flows and temperatures; None where it cannot read the surfaces."""
        return checked(self._native.checked)

    @property
    def remarks(self) -> list[str]:
        """What was done to the scene before, as `Scene.remarks` tells it, and to the transfers."""
        return self._native.remarks

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each surface, in the units of the properties whose names its columns have."""
        columns = ("areas", "emissivity", *self._FOUND)
        return surfaces_frame(self.names, {column: getattr(self, column) for column in columns})

    def __repr__(self) -> str:
        return f"<Heat of {len(self.names)} surfaces>"
