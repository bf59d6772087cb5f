"""Options by name: those of the command, with `_` for `-`; see `radiosity solve --help`.

Each function says which of these it takes: `radiosity.load("room.toml").solve(order=5, eps=1e-4)` takes those of `Method`.
"""

from __future__ import annotations

import os
from typing import Literal, TypedDict


class Import(TypedDict, total=False):
    """How a scene is read.

    frame: float
        The frame of a scene in which something moves, counted from 0, or what is between two.

    tolerance_length: float
        Corners and planes nearer than this length are made to agree; 0 for none.

    strict: bool
        Refuses a scene of another program that needs repairs.

    format: str
        Format of a scene of another program, instead of that of the ending of its name.

    one_sided: bool
        Only fronts reflect and emit, whatever the file says.

    two_sided: bool
        Fronts and backs reflect and emit, whatever the file says.

    materials: str or a path
        A file of materials by name.

    unit: "mm", "cm", "dm", "m", "in", "ft" or "yd"
        Unit of the lengths in the file, which become metres.

    up: "y" or "z"
        Axis that points upwards in the file; z will.

    fix_fronts: bool
        Turns fronts that seem to point the wrong way.

    grey: bool
        Red, green and blue become one band of their luminance.
    """

    frame: float
    tolerance_length: float
    strict: bool
    format: str
    one_sided: bool
    two_sided: bool
    materials: str | os.PathLike[str]
    unit: Literal["mm", "cm", "dm", "m", "in", "ft", "yd"]
    up: Literal["y", "z"]
    fix_fronts: bool
    grey: bool


class Method(TypedDict, total=False):
    """How light is computed.

    quality: "quick", "default", "fine" or "finest"
        Preset of order and accuracies, and of how finely points, planes and cells are read; pictures take the former alone.

    method: "galerkin" or "hierarchical"
        Which algorithm finds the light.

    basis: "legendre", "constant", "linear" or "harmonic"
        Functions whose sums the light on surfaces is.

    order: int or "auto"
        Degree of the polynomials on each element (3); 0 is classical radiosity, "auto" is accuracy=1e-2.

    accuracy: float
        Wanted relative error: raises order, layers, cuts and accuracies until it is reached.

    time_limit: float
        Seconds after which no finer run begins, and rays end, where an accuracy is wanted.

    tensor: bool
        Polynomials of that degree in each coordinate, not in both together.

    subdivide: int or "auto"
        Cuts each surface into K × K elements.

    layers: int
        Layers of elements graded towards the sides of every surface, 0 to 8.

    ratio: float
        Size of each layer against the next (0.25).

    eps: float
        Accuracy of the transfers between elements (1e-3).

    kernel: "default", "paper-legendre" or "paper-hybrid"
        Rules of the transfers: as `eps` says, or those of Zatz 1993.

    transport: "auto", "exact" or "sampled"
        What carries the pairs of elements.

    rays: int
        Rays of the sampled transport.

    solver: str
        Solver of the linear system.

    preconditioner: "block" or "none"
        What cg and gmres multiply residuals by.

    bounces: int
        Light that was reflected so many times at the most before it arrives (all).

    tolerance: float
        Relative residual at which an iterative solver stops (1e-8).

    max_iterations: int
        Iterations after which an iterative solver gives up (1000).

    keep_partial: bool
        Takes the best there is where the solver does not converge, with a warning.

    shadows: "auto", "off", "rays", "exact" or "mask"
        How it is found out what surfaces hide from each other.

    direct: "auto", "split" or "projected"
        How light straight from emitters enters the solution.

    shadow_eps: float
        Part of the light between two elements that may be in or out of shadow unnoticed (`eps`, else 3e-3).

    mask_cells: int
        Cells of a shadow mask along each side, with shadows="mask" (40).

    mask_average: "weighted" or "plain"
        What a mask tells.

    memory: int or str
        Most bytes to use (80 % of what is free), a number or a text such as "2G".

    threads: int
        Threads to use (all); results do not depend on it.
    """

    quality: Literal["quick", "default", "fine", "finest"]
    method: Literal["galerkin", "hierarchical"]
    basis: Literal["legendre", "constant", "linear", "harmonic"]
    order: int | Literal["auto"]
    accuracy: float
    time_limit: float
    tensor: bool
    subdivide: int | Literal["auto"]
    layers: int
    ratio: float
    eps: float
    kernel: Literal["default", "paper-legendre", "paper-hybrid"]
    transport: Literal["auto", "exact", "sampled"]
    rays: int
    solver: str
    preconditioner: Literal["block", "none"]
    bounces: int
    tolerance: float
    max_iterations: int
    keep_partial: bool
    shadows: Literal["auto", "off", "rays", "exact", "mask"]
    direct: Literal["auto", "split", "projected"]
    shadow_eps: float
    mask_cells: int
    mask_average: Literal["weighted", "plain"]
    memory: int | str
    threads: int


class Reading(TypedDict, total=False):
    """How light is read.

    read: "basis", "direct", "gather" or "gather-twice"
        Polynomials alone; direct light recomputed; or all light gathered anew (usual), once or twice.

    read_by: "auto", "cells" or "rays"
        By what light is gathered.

    read_eps: float
        Relative accuracy of recomputed light (1.25e-3, or finer as the accuracy of the solution says).

    threads: int
        Threads to use (as the solution did); results do not depend on it.
    """

    read: Literal["basis", "direct", "gather", "gather-twice"]
    read_by: Literal["auto", "cells", "rays"]
    read_eps: float
    threads: int


class Cells(Reading, total=False):
    """How means over cells are read: the options of `Reading`, and these.

    read_samples: two int
        Points along each side of a cell at which direct and gathered light are computed (4, 2; as `quality` says);
        light is then gathered by cells.

    memory: int or str
        Most bytes to use (as the solution did), a number or a text such as "2G".
    """

    read_samples: tuple[int, int]
    memory: int | str


class Picture(TypedDict, total=False):
    """How a picture is taken.

    read: "basis", "direct", "gather" or "gather-twice"
        As for points; usually gathered, or direct where that would take two threads more than some ten seconds.

    show: "radiosity" or "irradiance"
        What leaves surfaces (usual), or what arrives at them.

    samples: int
        Camera rays along each side of a pixel (3).

    memory: int or str
        Most bytes to use (as the solution did), a number or a text such as "2G".

    threads: int
        Threads to use (as the solution did); results do not depend on it.
    """

    read: Literal["basis", "direct", "gather", "gather-twice"]
    show: Literal["radiosity", "irradiance"]
    samples: int
    memory: int | str
    threads: int


class Transfers(TypedDict, total=False):
    """How transfers are integrated.

    subdivide: int or "auto"
        Cuts each surface into K × K elements, which are summed.

    eps: float
        Accuracy of each factor (1e-3; of heat 1e-4).

    shadow_eps: float
        Accuracy of shadows (`eps`).

    shadows: "auto", "off", "rays" or "exact"
        How it is found out what surfaces hide from each other.

    threads: int
        Threads to use (all); results do not depend on it.
    """

    subdivide: int | Literal["auto"]
    eps: float
    shadow_eps: float
    shadows: Literal["auto", "off", "rays", "exact"]
    threads: int


class HeatMethod(Transfers, total=False):
    """How a balance of heat is computed: the options of `Transfers`, and these.

    order: int
        Degree of the polynomials on each element (3); 0 takes all fluxes as even over it, as thermal networks do.

    transport: "auto", "exact" or "sampled"
        What carries the pairs of elements ("exact").

    solver: str
        Solver of the linear system.

    memory: int or str
        Most bytes to use (80 % of what is free), a number or a text such as "2G".

    conductances: bool
        Whether the conductances between all surfaces are wanted.
    """

    order: int
    transport: Literal["auto", "exact", "sampled"]
    solver: str
    memory: int | str
    conductances: bool
