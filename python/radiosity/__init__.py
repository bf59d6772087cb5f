"""Diffuse light and radiant heat between curved surfaces.

    import numpy as np
    import radiosity

    solution = radiosity.load("cornell-box").solve(accuracy=1e-2)
    solution.irradiance(np.array([[278.0, 100.0, 200.0]]), np.array([[0.0, 1.0, 0.0]]))   # (1, bands)

`help(radiosity.options)` lists all options of these functions. Lengths are those of the scene; exitance, irradiance and radiosity are in the scene's unit: W/m², or lux where exitance is in
lm/m². Arrays are of NumPy's float64.
"""

from . import options
from ._radiosity import Error, RadiosityWarning, __version__, builtins
from .audit import Audit, audit
from .checked import Checked
from .files import load, load_solution
from .heat import Heat
from .light import Light
from .plane import Plane
from .readings import Readings
from .scene import Scene
from .solution import Solution
from .stage import Frame, Stage
from .view_factors import ViewFactors, view_factor, view_factors

__all__ = [
    "Audit",
    "Checked",
    "Error",
    "Frame",
    "Heat",
    "Light",
    "Plane",
    "RadiosityWarning",
    "Readings",
    "Scene",
    "Solution",
    "Stage",
    "ViewFactors",
    "__version__",
    "audit",
    "builtins",
    "load",
    "load_solution",
    "options",
    "view_factor",
    "view_factors",
]
