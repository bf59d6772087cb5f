"""What path tracing found of printed numbers."""

from __future__ import annotations

import json
from typing import TypedDict


class Named(TypedDict):
    """A difference, printed less true."""

    of: str
    """Name of the surface or plane."""
    relative: float
    """The difference over what is true."""
    error: float
    """Its standard error."""


class Looked(TypedDict):
    """What path tracing looked at."""

    readings: int
    """Numbers that it judged."""
    left_out: int
    """Numbers that were left out because time was up."""
    rays: int
    """Rays that it traced."""
    signed_mean: Named | None
    """The mean of signed differences that exceeds chance most; None without any."""
    worst: Named | None
    """The number that differs most; None where nothing was read."""


class Checked(TypedDict):
    """What path tracing found of numbers, some of which it judged; all errors are relative, in the L2 mean."""

    error: float
    """Error of the numbers without the noise of path tracing; 0 where that is all."""
    error_sd: float
    """Its standard error."""
    visible: float
    """The least error that would have been seen."""
    own_error: float
    """Error by the method's own estimates."""
    error_factor: float
    """Factor of at least 1 that these were multiplied by."""
    audit: Looked
    """Counts, and what differs most."""
    line: str
    """All of it in a line, as the command tells it."""


def checked(told: str | None) -> Checked | None:
    """What was found, of its JSON; None where nothing was checked."""
    if told is None:
        return None
    found: Checked = json.loads(told)
    return found
