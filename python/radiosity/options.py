"""Options by name: those of the command, with `_` for `-`; see `radiosity solve --help`."""

from __future__ import annotations

import os
from typing import Literal, TypedDict


class Import(TypedDict, total=False):
    """How a scene is read."""

    frame: float
    """The frame of a scene in which something moves, counted from 0, or what is between two."""
    tolerance_length: float
    """Corners and planes nearer than this length are made to agree; 0 for none."""
    strict: bool
    """Refuses a scene of another program that needs repairs."""
    format: str
    """Format of a scene of another program, instead of that of the ending of its name."""
    one_sided: bool
    """Only fronts reflect and emit, whatever the file says."""
    two_sided: bool
    """Fronts and backs reflect and emit, whatever the file says."""
    materials: str | os.PathLike[str]
    """A file of materials by name."""
    unit: Literal["mm", "cm", "dm", "m", "in", "ft", "yd"]
    """Unit of the lengths in the file, which become metres."""
    up: Literal["y", "z"]
    """Axis that points upwards in the file; z will."""
    fix_fronts: bool
    """Turns fronts that seem to point the wrong way."""
    grey: bool
    """Red, green and blue become one band of their luminance."""


class Method(TypedDict, total=False):
    """How light is computed."""

    quality: Literal["quick", "default", "fine", "finest"]
    """Preset of order, accuracies and points read."""
    method: Literal["galerkin", "hierarchical"]
    """Which algorithm finds the light."""
    basis: Literal["legendre", "constant", "linear", "harmonic"]
    """Functions whose sums the light on surfaces is."""
    order: int | Literal["auto"]
    """Degree of the polynomials on each element (3); 0 is classical radiosity, "auto" is accuracy=1e-2."""
    accuracy: float
    """Wanted relative error: raises order, layers, cuts and accuracies until it is reached."""
    time_limit: float
    """Seconds after which no finer run begins, and rays end, where an accuracy is wanted."""
    tensor: bool
    """Polynomials of that degree in each coordinate, not in both together."""
    subdivide: int | Literal["auto"]
    """Cuts each surface into K × K elements."""
    layers: int
    """Layers of elements graded towards the sides of every surface, 0 to 8."""
    ratio: float
    """Size of each layer against the next (0.25)."""
    eps: float
    """Accuracy of the transfers between elements (1e-3)."""
    kernel: Literal["default", "paper-legendre", "paper-hybrid"]
    """Rules of the transfers: as `eps` says, or those of Zatz 1993."""
    transport: Literal["auto", "exact", "sampled"]
    """What carries the pairs of elements."""
    rays: int
    """Rays of the sampled transport."""
    solver: str
    """Solver of the linear system."""
    preconditioner: Literal["block", "none"]
    """What cg and gmres multiply residuals by."""
    bounces: int
    """Light that was reflected so many times at the most before it arrives (all)."""
    tolerance: float
    """Relative residual at which an iterative solver stops (1e-8)."""
    max_iterations: int
    """Iterations after which an iterative solver gives up (1000)."""
    keep_partial: bool
    """Takes the best there is where the solver does not converge, with a warning."""
    shadows: Literal["auto", "off", "rays", "exact", "mask"]
    """How it is found out what surfaces hide from each other."""
    direct: Literal["auto", "split", "projected"]
    """How light straight from emitters enters the solution."""
    shadow_eps: float
    """Part of the light between two elements that may be in or out of shadow unnoticed (`eps`, else 3e-3)."""
    mask_cells: int
    """Cells of a shadow mask along each side, with shadows="mask" (40)."""
    mask_average: Literal["weighted", "plain"]
    """What a mask tells."""
    memory: int | str
    """Most bytes to use (80 % of what is free), a number or a text such as "2G"."""
    threads: int
    """Threads to use (all); results do not depend on it."""


class Reading(TypedDict, total=False):
    """How light is read."""

    read: Literal["basis", "direct", "gather", "gather-twice"]
    """Polynomials alone; direct light recomputed; or all light gathered anew (usual), once or twice."""
    read_by: Literal["auto", "cells", "rays"]
    """By what light is gathered."""
    read_eps: float
    """Relative accuracy of recomputed light (1.25e-3, or finer as the accuracy of the solution says)."""
    threads: int
    """Threads to use (as the solution did); results do not depend on it."""


class Cells(Reading, total=False):
    """How means over cells are read."""

    read_samples: tuple[int, int]
    """Points along each side of a cell at which direct and gathered light are computed (4, 2; as `quality` says); light is then
    gathered by cells."""
    memory: int | str
    """Most bytes to use (as the solution did), a number or a text such as "2G"."""


class Picture(TypedDict, total=False):
    """How a picture is taken."""

    read: Literal["basis", "direct", "gather", "gather-twice"]
    """As for points; usually gathered, or direct where that would take two threads more than some ten seconds."""
    show: Literal["radiosity", "irradiance"]
    """What leaves surfaces (usual), or what arrives at them."""
    samples: int
    """Camera rays along each side of a pixel (3)."""
    memory: int | str
    """Most bytes to use (as the solution did), a number or a text such as "2G"."""
    threads: int
    """Threads to use (as the solution did); results do not depend on it."""


class Transfers(TypedDict, total=False):
    """How transfers are integrated."""

    subdivide: int | Literal["auto"]
    """Cuts each surface into K × K elements, which are summed."""
    eps: float
    """Accuracy of each factor (1e-3; of heat 1e-4)."""
    shadow_eps: float
    """Accuracy of shadows (`eps`)."""
    shadows: Literal["auto", "off", "rays", "exact"]
    """How it is found out what surfaces hide from each other."""
    threads: int
    """Threads to use (all); results do not depend on it."""


class HeatMethod(Transfers, total=False):
    """How a balance of heat is computed."""

    order: int
    """Degree of the polynomials on each element (3); 0 takes all fluxes as even over it, as thermal networks do."""
    transport: Literal["auto", "exact", "sampled"]
    """What carries the pairs of elements ("exact")."""
    solver: str
    """Solver of the linear system."""
    memory: int | str
    """Most bytes to use (80 % of what is free), a number or a text such as "2G"."""
    conductances: bool
    """Whether the conductances between all surfaces are wanted."""
