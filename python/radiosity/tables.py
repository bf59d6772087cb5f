"""Results as tables of pandas and arrays of xarray."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from .arguments import Array
from .optional import optional


def points_frame(points: Array, values: Array, bands: Sequence[str], errors: Array | None = None) -> Any:
    """Readings at points as a pandas.DataFrame: a row for each point, with x, y, z, a column for each band, and error where it is given.

    `points` (..., 3) in scene length, `values` (..., bands) and `errors` (...) in the scene's unit.
    """
    pandas = optional("pandas", "to_pandas")
    columns = dict(zip("xyz", np.reshape(points, (-1, 3)).T, strict=True))
    columns.update(zip(bands, np.reshape(values, (-1, len(bands))).T, strict=True))
    if errors is not None:
        columns["error"] = np.ravel(errors)
    return pandas.DataFrame(columns)


def plane_array(points: Array, values: Array, bands: Sequence[str], *, name: str, unit: str) -> Any:
    """Readings of a plane as an xarray.DataArray with the axes row, column and band.

    `points` (rows, columns, 3) in scene length, which become the coordinates x, y and z; `values` (rows, columns, bands) in `unit`.
    """
    xarray = optional("xarray", "to_xarray")
    places = {axis: (("row", "column"), points[..., k]) for k, axis in enumerate("xyz")}
    return xarray.DataArray(
        values,
        dims=("row", "column", "band"),
        coords={**places, "band": list(bands)},
        name=name,
        attrs={"long_name": "irradiance", "units": unit},
    )


def surfaces_frame(names: Sequence[str], columns: Mapping[str, Any]) -> Any:
    """Numbers of surfaces as a pandas.DataFrame: a row for each, by its name."""
    pandas = optional("pandas", "to_pandas")
    return pandas.DataFrame(dict(columns), index=pandas.Index(list(names), name="surface"))


def factors_frame(names: Sequence[str], matrix: Any) -> Any:
    """View factors F_ij, an array or one of SciPy without zeros, as a pandas.DataFrame: from the surface of the row to that of the column."""
    pandas = optional("pandas", "to_pandas")
    index, columns = (pandas.Index(list(names), name=name) for name in ("from", "to"))
    if isinstance(matrix, np.ndarray):
        return pandas.DataFrame(matrix, index=index, columns=columns)
    from scipy.sparse import csr_matrix

    return pandas.DataFrame.sparse.from_spmatrix(csr_matrix(matrix), index=index, columns=columns)
