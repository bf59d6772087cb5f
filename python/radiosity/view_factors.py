"""View factors: the share of what leaves each surface that reaches each other."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from . import _radiosity
from .arguments import Array, numbers, refusal, text
from .arrays import polygons
from .checked import Checked, checked
from .kept import Kept
from .progress import Observer, Shown
from .scene import Scene
from .tables import factors_frame

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Transfers


class ViewFactors(Kept):
    """The view factors F_ij between n surfaces. They pickle, with their matrix."""

    _KEPT = ("names", "areas", "row_sums", "errors", "accuracy_reached", "checked", "seconds", "is_partial", "is_closed", "remarks")

    def __init__(self, native: _radiosity.ViewFactors, *, sparse: bool = False) -> None:
        self._native: _radiosity.ViewFactors = native
        self._sparse = sparse

    @cached_property
    def matrix(self) -> Any:
        """F, an array (n, n), or an array of SciPy's CSR where it was asked for; A_i F_ij = A_j F_ji.

        With `pairs` all other factors are nan.
        """
        if not self._sparse:
            matrix = np.zeros((len(self.names), len(self.names)))
            self._native.fill(matrix)
            return matrix
        try:
            from scipy.sparse import csr_array
        except ImportError as error:
            raise ImportError("sparse=True needs SciPy: pip install scipy") from error
        count = len(self.names)
        return csr_array(self._native.sparse(), shape=(count, count))

    @property
    def names(self) -> list[str]:
        """Names of the surfaces; of polygons surface-1, surface-2 and so on."""
        return self._native.names

    @property
    def areas(self) -> Array:
        """Areas of the surfaces (scene length²), an array (n,)."""
        return self._native.areas

    @property
    def row_sums(self) -> Array:
        """Σ_j F_ij, an array (n,): 1 for each surface of a closed scene; nan with `pairs`."""
        return np.full(len(self.names), np.nan) if self._native.is_partial else self._native.row_sums

    @property
    def is_closed(self) -> bool | None:
        """Whether all that leaves a surface reaches another, within the error; None where that is too large, and with `pairs`."""
        return self._native.is_closed

    @property
    def remarks(self) -> list[str]:
        """What was done to the surfaces before, where corners and sides nearly meet."""
        return self._native.remarks

    @property
    def errors(self) -> Array:
        """The largest error of a factor in the row of each surface, an array (n,): the method's own estimate, made true by walks of rays."""
        return self._native.errors

    @property
    def checked(self) -> Checked | None:
        """What path tracing found of the factors; None where it did not look, as where closed forms carry all pairs and nothing blocks."""
        return checked(self._native.checked)

    @property
    def accuracy_reached(self) -> float:
        """The largest error of a factor, that of `errors`."""
        return self._native.accuracy_reached

    @property
    def seconds(self) -> float:
        """Time that they took."""
        return self._native.seconds

    def to_pandas(self) -> Any:
        """F as a pandas.DataFrame: from the surface of the row to that of the column."""
        return factors_frame(self.names, self.matrix)

    def __getstate__(self) -> dict[str, Any]:
        return {**super().__getstate__(), "matrix": self.matrix}

    def __repr__(self) -> str:
        return f"<ViewFactors of {len(self.names)} surfaces>"


def view_factors(
    of: Scene | ArrayLike | Sequence[ArrayLike],
    *,
    pairs: Sequence[tuple[str, str]] = (),
    sparse: bool = False,
    progress: bool | Observer | None = None,
    **method: Unpack[Transfers],
) -> ViewFactors:
    """The view factors between the surfaces of a scene, or between polygons, as `radiosity view-factors` computes them.

    `of` is a scene, an array (n, k, 3) or a list of arrays (k, 3): the vertices of each polygon, counterclockwise as seen from its
    front. Only fronts send and receive; all sides block. `sparse=True` leaves zeros out. `pairs` are names of surfaces, from and to,
    whose factors alone are computed. All options are listed in `radiosity.options.Transfers`.
    """
    wanted = [_pair(f"pairs[{index}]", pair) for index, pair in enumerate(pairs)]
    if sparse and wanted:
        raise refusal("sparse= does not go with pairs=: a few pairs are no matrix", "leave one of them out")
    with Shown(progress) as observer:
        if isinstance(of, Scene):
            found = _radiosity.view_factors_of_scene(of._native, wanted, method, observer)
        else:
            given = [(f"polygons[{index}]", polygon) for index, polygon in enumerate(polygons(of))]
            if not given:
                raise refusal("polygons: there are none", "give an array (n, k, 3), or a list of arrays (k, 3)")
            found = _radiosity.view_factors_of_polygons(given, wanted, "view_factors", True, method, observer)
    return ViewFactors(found, sparse=sparse)


def view_factor(
    a: ArrayLike, b: ArrayLike, blockers: Sequence[ArrayLike] | ArrayLike = (), **method: Unpack[Transfers]
) -> float:
    """The share of what leaves the polygon `a` (k, 3) that reaches the polygon `b` (k, 3), past `blockers`."""
    given = [("a", numbers("a", a, ("k", 3))), ("b", numbers("b", b, ("k", 3)))]
    given += [(f"blockers[{index}]", blocker) for index, blocker in enumerate(polygons(blockers, "blockers"))]
    found = _radiosity.view_factors_of_polygons(given, [("surface-1", "surface-2")], "view_factor", False, method, None)
    return found.factor(0, 1)


def _pair(name: str, pair: Any) -> tuple[str, str]:
    """Two names."""
    if isinstance(pair, (str, bytes)) or not isinstance(pair, Sequence) or len(pair) != 2:
        raise TypeError(f"{name}: the names of two surfaces are wanted, not {pair!r:.60}")
    return text(name, pair[0]), text(name, pair[1])
