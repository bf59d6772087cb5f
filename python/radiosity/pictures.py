"""Solutions in PyVista: grids and plots."""

from __future__ import annotations

import os
import tempfile
from typing import Any, Protocol

from .arguments import refusal
from .optional import optional


class Saved(Protocol):
    """A solution, which writes itself as a grid of VTK to a path that ends in .vtu."""

    def save(self, path: str) -> None: ...


def to_pyvista(solution: Saved) -> Any:
    """The light of a solution as a grid of VTK.

    Cells are Lagrange polynomials of the degree of the solution: the grid holds the polynomials themselves, on curved surfaces
    too, not samples of them. They are those that ``read="basis"`` reads: without the parts that gathering adds.

    Parameters
    ----------
    solution : Solution

    Returns
    -------
    pyvista.UnstructuredGrid
        With the point data ``"irradiance BAND"`` and ``"radiosity BAND"`` (the scene's unit: W/m² or lux).

    Raises
    ------
    ImportError
        If PyVista is not installed.
    Error
        If light goes through shadow masks, or polynomials are of a higher total degree than 20.
    """
    pyvista = optional("pyvista", "to_pyvista")
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "solution.vtu")
        solution.save(path)
        return pyvista.read(path)


def plot(
    solution: Saved,
    *,
    quantity: str = "irradiance",
    band: str | None = None,
    subdivide: int = 2,
    **options: Any,
) -> Any:
    """Plots the light of a solution with PyVista, fronts only: a room is looked into from outside.

    Parameters
    ----------
    solution : Solution
    quantity : str
        ``"irradiance"`` or ``"radiosity"``, in the scene's unit.
    band : str, optional
        The band shown, the first without it.
    subdivide : int
        How often the cells are halved to be drawn, 0 … 4.
    **options
        Arguments of ``pyvista.plot``: ``cmap``, ``clim``, ``off_screen``, ``screenshot``, ``show_edges``, ….

    Returns
    -------
    object
        What ``pyvista.plot`` returns.

    Raises
    ------
    ImportError
        If PyVista is not installed.
    Error
        As :func:`to_pyvista`, and for an unknown quantity or band.
    """
    grid = to_pyvista(solution)
    shown = _field(grid, quantity, band)
    if subdivide not in range(5):
        raise refusal(f"subdivide = {subdivide!r} is not in 0 … 4", "give 2, or more for smoother pictures")
    usual = {
        "scalars": shown,
        "clim": (0.0, float(grid.point_data[shown].max()) or 1.0),
        "cmap": "inferno",
        "lighting": False,
        "culling": "back",
        "background": "white",
        "scalar_bar_args": {"title": shown, "color": "black"},
    }
    return _surface(grid, subdivide).plot(**{**usual, **options})


def _surface(grid: Any, subdivide: int) -> Any:
    """Straight triangles in place of the grid's cells, each of which is halved that often."""
    pyvista = optional("pyvista", "plot")
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

    cut = vtkDataSetSurfaceFilter()
    cut.SetInputData(grid)
    cut.SetNonlinearSubdivisionLevel(subdivide)
    cut.Update()
    return pyvista.wrap(cut.GetOutput())


def _field(grid: Any, quantity: str, band: str | None) -> str:
    """The name of a field of the grid."""
    fields = [name for name in grid.point_data if name.startswith(("irradiance", "radiosity"))]
    wanted = [name for name in fields if name == quantity or name.startswith(f"{quantity} ")]
    if band is not None:
        wanted = [name for name in wanted if name == f"{quantity} {band}"]
    if not wanted:
        raise refusal(f"no {quantity!r} of band {band!r} is known", f"there are {', '.join(fields)}")
    return str(wanted[0])
