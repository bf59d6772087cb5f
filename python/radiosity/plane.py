"""What planes of sensors read."""

from __future__ import annotations

from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _radiosity
from .arguments import Array
from .checked import Checked, checked
from .kept import Kept
from .tables import plane_array, points_frame


class Plane(Kept):
    """The irradiance (the scene's unit) on a plane of sensors, rows along its first edge and columns along its second."""

    _KEPT = ("name", "values", "errors", "mean_error", "checked", "points", "normal", "figures", "left_out", "dark")

    def __init__(self, native: _radiosity.Plane, scene: _radiosity.Scene) -> None:
        self._native: _radiosity.Plane = native
        self.name: str = native.name
        """Its name."""
        self.bands: list[str] = scene.bands
        """Names of the bands."""
        self.unit: str = scene.unit
        """Unit of the values."""

    @cached_property
    def values(self) -> Array:
        """Irradiance, an array (rows, columns, bands)."""
        return self._native.values

    @cached_property
    def error(self) -> Array:
        """By how much each reading may be off, in its unit, root mean square over the bands: an array (rows, columns).

        It is the method's own estimate times `checked["error_factor"]`, and at least what path tracing found where it looked.
        """
        return self._native.errors

    @property
    def mean_error(self) -> float | None:
        """By how much the mean may be off, at the most, in its unit, root mean square over the bands."""
        return self._native.mean_error

    @property
    def checked(self) -> Checked | None:
        """What path tracing found of the readings; None where it does not know such light, and of frames without `audit=`."""
        return checked(self._native.checked)

    @cached_property
    def points(self) -> Array:
        """Where the sensors are, an array (rows, columns, 3)."""
        return self._native.points

    @property
    def normal(self) -> Array:
        """The unit normal along which they receive, an array (3,)."""
        return np.array(self._native.normal)

    @cached_property
    def _figures(self) -> Array:
        return np.array(self._native.figures)

    @property
    def mean(self) -> Array:
        """Mean of each band, an array (bands,)."""
        return self._figures[:, 0]

    @property
    def min(self) -> Array:
        """Least value of each band, an array (bands,)."""
        return self._figures[:, 1]

    @property
    def max(self) -> Array:
        """Greatest value of each band, an array (bands,)."""
        return self._figures[:, 2]

    @property
    def u0(self) -> Array:
        """Overall uniformity, least over mean (EN 12464-1), of each band, an array (bands,); nan in the dark."""
        return self._figures[:, 3]

    @property
    def ud(self) -> Array:
        """Least over greatest, of each band, an array (bands,); nan in the dark."""
        return self._figures[:, 4]

    @property
    def left_out(self) -> int:
        """How many sensors lie outside of the room or in solids: the figures leave them out."""
        return self._native.left_out

    @property
    def dark(self) -> int:
        """How many of the other sensors get no light."""
        return self._native.dark

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.values, dtype, copy=True if copy is None else copy)

    def __len__(self) -> int:
        return len(self.values)

    def to_pandas(self) -> Any:
        """A pandas.DataFrame with a row for each sensor: x, y, z (scene length), the irradiance of each band and its error."""
        return points_frame(self.points, self.values, self.bands, self.error)

    def to_xarray(self) -> Any:
        """An xarray.DataArray with the axes row, column and band, and the coordinates x, y and z (scene length)."""
        return plane_array(self.points, self.values, self.bands, name=self.name, unit=self.unit)

    def __repr__(self) -> str:
        rows, columns, _ = self.values.shape
        return f"<Plane {self.name!r}: {rows} × {columns} sensors, mean {self.mean} {self.unit}, U0 {self.u0}>"
