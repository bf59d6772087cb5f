"""Readings with their errors."""

from __future__ import annotations

from typing import NamedTuple

from .arguments import Array
from .checked import Checked


class Readings(NamedTuple):
    """Irradiance at n points in the scene's unit, with its errors."""

    values: Array
    """Irradiance, an array (n, bands)."""
    errors: Array
    """By how much each reading may be off, in its unit, root mean square over the bands: an array (n,)."""
    checked: Checked | None
    """What path tracing found of them; None where it was not asked, or does not know such light."""
