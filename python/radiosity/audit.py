"""Light judged by path tracing."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from . import _radiosity
from .arguments import Array
from .kept import Kept
from .progress import Observer, Shown
from .scene import Scene
from .solution import Solution

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Auditing


class Audit(Kept):
    """n readings of a solution beside what walks of light find there, and what these say of it. It pickles.

    Values are in the unit of the scene; `print` shows the verdict in a line.
    """

    _KEPT = (
        *("positions", "normals", "names", "printed", "found", "found_error"),
        *("errors", "finds_more", "counts", "verdict", "line"),
    )

    def __init__(self, native: _radiosity.Audit) -> None:
        self._native: _radiosity.Audit = native

    @property
    def positions(self) -> Array:
        """Places of the readings, an array (n, 3)."""
        return self._native.positions

    @property
    def normals(self) -> Array:
        """Unit normals that they receive along, an array (n, 3)."""
        return self._native.normals

    @property
    def names(self) -> list[str]:
        """The surface or the plane of each reading."""
        return self._native.names

    @property
    def printed(self) -> Array:
        """Irradiances as the solution has them, an array (n, bands)."""
        return self._native.printed

    @property
    def found(self) -> Array:
        """Irradiances as the walks found them, an array (n, bands)."""
        return self._native.found

    @property
    def found_error(self) -> Array:
        """Standard errors of what was found, an array (n, bands)."""
        return self._native.found_error

    @property
    def error(self) -> float:
        """Relative error of the readings in the L2 mean; 0 where chance hides it."""
        return self._native.errors[0]

    @property
    def error_sd(self) -> float:
        """Standard error of `error`."""
        return self._native.errors[1]

    @property
    def visible(self) -> float:
        """The least relative error that would have been seen with so many rays."""
        return self._native.errors[2]

    @property
    def told(self) -> float:
        """The relative error that the solution and its reading tell."""
        return self._native.errors[3]

    @property
    def finds_more(self) -> bool:
        """Whether the light is off by more than chance and by more than `told`, as a whole or in a signed mean."""
        return self._native.finds_more

    @property
    def rays(self) -> int:
        """Rays that were traced."""
        return self._native.counts[0]

    @property
    def walks(self) -> int:
        """Walks for each reading."""
        return self._native.counts[1]

    @property
    def unread(self) -> int:
        """Places that could not be read: by polynomials there is light on surfaces alone."""
        return self._native.counts[2]

    @property
    def signed(self) -> list[dict[str, Any]]:
        """Means of signed differences, printed less found, those that exceed chance most first.

        Each is "of" a surface, a plane or a "group NAME", of so many "readings", "relative" to what was found, with its standard "error".
        """
        return self._told("signed")

    @property
    def worst(self) -> list[dict[str, Any]]:
        """The readings that differ most, each with its index "reading" in the arrays and the "band" that differs most."""
        return self._told("worst")

    def _told(self, key: str) -> list[dict[str, Any]]:
        told: list[dict[str, Any]] = json.loads(self._native.verdict)[key]
        return told

    def __str__(self) -> str:
        return self._native.line

    def __repr__(self) -> str:
        return f"<Audit: {self._native.line}>"


def audit(of: Scene | Solution, *, progress: bool | Observer | None = None, **auditing: Unpack[Auditing]) -> Audit:
    """Judges the light of a solution, or of a scene solved as usual, by path tracing, as `radiosity audit` does.

    The walks know the scene alone: what a ray meets, what surfaces send and reflect, points on lamps. They share its import, the
    fitting of its shapes and the models of luminaires, skies and glass with the solution, and do not judge these. `seconds` (2 unless
    it is told) becomes a number of rays by counts of the scene, never by the clock; `readings` (64) is their number, and `seed` chooses
    other places and rays. All options are listed in `radiosity.options.Auditing`.
    """
    if not isinstance(of, (Scene, Solution)):
        raise TypeError(f"audit: a Scene or a Solution is wanted, not {type(of).__name__}")
    solution = of.solve(progress=progress) if isinstance(of, Scene) else of
    with Shown(progress) as observer:
        return Audit(_radiosity.audit_of(solution._native, auditing, observer))
