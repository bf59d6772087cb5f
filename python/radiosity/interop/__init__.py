"""Meshes of meshio, PyVista and trimesh → scenes; solutions → PyVista; tables for pandas and xarray.

    import meshio
    from radiosity import interop

    materials = {"wall": {"reflectance": 0.6}, "lamp": {"reflectance": 0, "emission": 900}}
    scene = interop.from_meshio(meshio.read("room.msh"), materials)
    scene.solve(accuracy=1e-2).plot()

None of these packages is needed to import this one; each is imported where it is used.
"""

from ..pictures import plot, to_pyvista
from .meshes import from_meshio, from_pyvista, from_trimesh

__all__ = ["from_meshio", "from_pyvista", "from_trimesh", "plot", "to_pyvista"]
