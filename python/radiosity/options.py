"""Options by name: those of the command, with `_` for `-`; see `radiosity solve --help`.

Each function says which of these it takes: `radiosity.load("room.toml").solve(order=5, eps=1e-4)` takes those of `Method`.

Made by `WRITE_DOCUMENTS=1 cargo test --release -p radiosity-cli documented`.
"""

from __future__ import annotations

import os
from typing import Literal, TypedDict


class Import(TypedDict, total=False):
    """How a scene is read.

    frame: float
        Takes this frame of a scene in which something moves, counted from 0, or what is between two: 12.5 [default: the scene at
        rest].

    tolerance_length: float
        Corners and planes nearer than this length are made to agree; 0 for none [default: the rounding of the coordinates].

    strict: bool
        Refuses a scene of another program that needs repairs.

    format: "mgf", "obj", "gltf", "stl", "ply", "mitsuba", "rad" or "vs3"
        Format of the scene [default: that of the ending of its name].

    one_sided: bool
        Only fronts reflect and emit, whatever the file says.

    two_sided: bool
        Fronts and backs reflect and emit, whatever the file says.

    materials: str or a path
        Materials by name, of the scene and of its surfaces: `[materials.NAME]` with reflectance and emission, and `[surfaces]` with
        "lamp*" = "NAME".

    unit: "mm", "cm", "dm", "m", "in", "ft" or "yd"
        Unit of the lengths in the file, which become metres: mm, cm, dm, m, in, ft or yd.

    up: "y" or "z"
        Axis that points upwards in the file, y or z; z will [default: y in glTF, else z].

    fix_fronts: bool
        Turns fronts that seem to point the wrong way; else they are only told.

    grey: bool
        Red, green and blue become one band of their luminance.
    """

    frame: float
    tolerance_length: float
    strict: bool
    format: Literal["mgf", "obj", "gltf", "stl", "ply", "mitsuba", "rad", "vs3"]
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
        Preset of order and accuracies, and of how finely points, planes and cells are read; single options go before it [default:
        "default"].

    method: "galerkin", "collocation" or "hierarchical"
        Which algorithm finds the light [default: galerkin].

    basis: "legendre", "constant", "linear" or "harmonic"
        Functions whose sums the light on surfaces is; those other than legendre are for comparison [default: legendre].

    order: int or "auto"
        Degree of the polynomials on each element; 0 is classical radiosity, auto is accuracy=1e-2 [default: 3; as `quality` says].

    accuracy: float
        Wanted relative error: raises order, layers, cuts and accuracies until it is reached.

    time_limit: float
        Seconds after which rays end, and no finer run begins.

    tensor: bool
        Polynomials of that degree in each coordinate, not in both together.

    subdivide: int or "auto"
        Cuts each surface into K × K elements; auto looks at what the scene needs [default: auto].

    layers: int
        Layers of elements graded towards the sides of every surface [default: 0].

    ratio: float
        Size of each layer against the next, between 0 and 1 [default: 0.25].

    eps: float
        Accuracy of the transfers between elements, between 0 and 1; of hierarchical radiosity the greatest power of a link, in
        parts of all that is emitted, or form factor [default: 1e-3; as `quality` says].

    link_measure: "power" or "form-factor"
        The measure of a link that `eps` bounds, of hierarchical radiosity [default: power].

    link_rays: int
        Rays that find what is hidden of a link of hierarchical radiosity [default: 16].

    least_area: float
        Part of the area of all surfaces up to which hierarchical radiosity does not cut faces [default: 1e-6; 1e-3 by form
        factors].

    kernel: "default", "paper-legendre", "paper-hybrid", "paper-hybrid-h2", "paper-hybrid-h3" or "paper-printed"
        Rules of the transfers between elements; those of 1993 ignore `eps` [default: default].

    transport: "auto", "exact" or "sampled"
        How the pairs of elements are carried [default: auto].

    rays: int
        Rays of the sampled transport [default: by the number of surfaces and `shadow_eps`].

    solver: str
        Solver of the linear system [default: auto].

    preconditioner: "block" or "none"
        How cg and gmres precondition [default: block].

    columns: "shot" or "all"
        With solver="southwell", when a block column of the transfers is integrated [default: "shot"; "all" where rays carry the
        light, and wherever else the report says so].

    shots: int
        Stops after so many shots of solver="southwell" in each band and light group: the polynomials then hold what was shot and
        what has arrived [default: as many as `tolerance` takes].

    ambient: bool
        Adds to the light of `shots` the ambient term of Cohen 1988: what all further shots would bring, if it were the same
        everywhere.

    at_once: "block" or "coefficient"
        Unknowns that jacobi, gauss-seidel and southwell relax at a time [default: block].

    sweep: "forward" or "symmetric"
        The order in which gauss-seidel visits the elements [default: forward].

    relaxation: float
        Factor of every correction of jacobi, richardson, gauss-seidel and southwell, between 0 and 2: above 1 overshoots [default:
        1].

    restart: int
        Vectors that gmres keeps before it restarts [default: 50].

    bounces: int
        Light that was reflected so many times at the most before it arrives: 0 for light straight from emitters [default: all].

    tolerance: float
        Relative residual at which an iterative solver stops [default: 1e-8].

    max_iterations: int
        Iterations after which an iterative solver gives up [default: 1000].

    shadows: "auto", "off", "rays", "exact" or "mask"
        How it is found out what surfaces hide from each other [default: auto].

    direct: "auto", "split" or "projected"
        How light straight from emitters enters the solution [default: auto].

    shadow_eps: float
        Part of the light between two elements that may be in or out of shadow unnoticed, between 0 and 1 [default: `eps` where that
        is given, else 3e-3, as `quality` says].

    mask_cells: int
        Cells of a shadow mask along each side, at the finest, with shadows="mask" [default: 40].

    mask_average: "weighted" or "plain"
        Values of a mask [default: weighted].

    memory: int or str
        Most memory to use, such as 500M, 2G or 2GiB [default: 80 % of what is free].

    threads: int
        Threads to use, all by default; results do not depend on it.

    keep_partial: bool
        Takes the best there is where the solver does not converge, with a warning.
    """

    quality: Literal["quick", "default", "fine", "finest"]
    method: Literal["galerkin", "collocation", "hierarchical"]
    basis: Literal["legendre", "constant", "linear", "harmonic"]
    order: int | Literal["auto"]
    accuracy: float
    time_limit: float
    tensor: bool
    subdivide: int | Literal["auto"]
    layers: int
    ratio: float
    eps: float
    link_measure: Literal["power", "form-factor"]
    link_rays: int
    least_area: float
    kernel: Literal["default", "paper-legendre", "paper-hybrid", "paper-hybrid-h2", "paper-hybrid-h3", "paper-printed"]
    transport: Literal["auto", "exact", "sampled"]
    rays: int
    solver: str
    preconditioner: Literal["block", "none"]
    columns: Literal["shot", "all"]
    shots: int
    ambient: bool
    at_once: Literal["block", "coefficient"]
    sweep: Literal["forward", "symmetric"]
    relaxation: float
    restart: int
    bounces: int
    tolerance: float
    max_iterations: int
    shadows: Literal["auto", "off", "rays", "exact", "mask"]
    direct: Literal["auto", "split", "projected"]
    shadow_eps: float
    mask_cells: int
    mask_average: Literal["weighted", "plain"]
    memory: int | str
    threads: int
    keep_partial: bool


class Solving(Method, total=False):
    """How a scene is solved: the options of `Method`, and this.

    audit: float
        Seconds that about two threads take to check what is printed by path tracing; the number of rays follows from this and from
        counts of the scene [default: a twentieth of the run, 0.1 to 5].

    transfers: str or a path
        File of the transfers between the surfaces, which is made where there is none: runs on the same surfaces, with other
        materials, temperatures or lamps, find none of them again; those of other options are added.
    """

    audit: float
    transfers: str | os.PathLike[str]


class Reading(TypedDict, total=False):
    """How light is read.

    read: "basis", "direct", "gather" or "gather-twice"
        Light that is read [default: gather; with `quality` finest gather-twice].

    read_by: "auto", "cells", "rays" or "walks"
        By what light is gathered [default: auto].

    read_eps: float
        Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3, as `quality` says; 5e-3 of a solution by rays;
        less for a wanted accuracy below 4e-3: 0.3 of that].

    threads: int
        Threads to use (as the solution did); results do not depend on it.

    audit: float
        Seconds that about two threads take to check what is printed by path tracing; the number of rays follows from this and from
        counts of the scene [default: a twentieth of the run, 0.1 to 5].
    """

    read: Literal["basis", "direct", "gather", "gather-twice"]
    read_by: Literal["auto", "cells", "rays", "walks"]
    read_eps: float
    threads: int
    audit: float


class Cells(Reading, total=False):
    """How means over cells are read: the options of `Reading`, and these.

    read_samples: two int
        Points along each side of a cell at which direct and gathered light are computed [default: (4, 2); as `quality` says]; light
        is then gathered by cells.

    memory: int or str
        Most bytes to use (as the solution did), a number or a text such as "2G".
    """

    read_samples: tuple[int, int]
    memory: int | str


class Auditing(TypedDict, total=False):
    """How light is read and judged.

    read: "basis", "direct", "gather" or "gather-twice"
        Light that is read [default: gather; with `quality` finest gather-twice].

    read_by: "auto", "cells", "rays" or "walks"
        By what light is gathered [default: auto].

    read_eps: float
        Accuracy of recomputed light, relative, between 0 and 1 [default: 1.25e-3, as `quality` says; 5e-3 of a solution by rays;
        less for a wanted accuracy below 4e-3: 0.3 of that].

    threads: int
        Threads to use (as the solution did); results do not depend on it.

    seconds: float
        Seconds that about two threads take for its rays; their number follows from this and from counts of the scene, and is
        printed [default: 2].

    readings: int
        About the number of readings that are judged, of heat and view factors of surfaces at the most [default: 64].

    seed: int
        Chooses other places and other rays [default: 0].
    """

    read: Literal["basis", "direct", "gather", "gather-twice"]
    read_by: Literal["auto", "cells", "rays", "walks"]
    read_eps: float
    threads: int
    seconds: float
    readings: int
    seed: int


class Picture(TypedDict, total=False):
    """How a picture is taken.

    samples: int
        Camera rays along each side of a pixel, about: S² + 1 in all, on a square grid that is turned [default: 3].

    read: "basis", "direct", "gather" or "gather-twice"
        Light that the picture shows [default: gather; of .html and .glb direct where that would take two threads more than some ten
        seconds].

    show: "radiosity" or "irradiance"
        The quantity that is shown.

    memory: int or str
        Most bytes to use (as the solution did), a number or a text such as "2G".

    threads: int
        Threads to use (as the solution did); results do not depend on it.

    audit: float
        Seconds that about two threads take to check the pixels by path tracing, which warns of more than their errors tell
        [default: not checked].
    """

    samples: int
    read: Literal["basis", "direct", "gather", "gather-twice"]
    show: Literal["radiosity", "irradiance"]
    memory: int | str
    threads: int
    audit: float


class Transfers(TypedDict, total=False):
    """How transfers are integrated.

    subdivide: int or "auto"
        Cuts each surface into K × K elements, which are summed: sharper shadows; auto looks at what the scene needs [default:
        auto].

    eps: float
        Accuracy of each factor, relative to itself or a hundredth of the largest of its row; to the largest of its row where rays
        carry it [default: 1e-3].

    shadow_eps: float
        Accuracy of shadows [default: as `eps`].

    shadows: "auto", "off", "rays" or "exact"
        How it is found out what surfaces hide from each other [default: auto].

    transport: "auto", "exact" or "sampled"
        How the pairs of elements are carried [default: auto].

    rays: int
        Rays of the sampled transport [default: by the number of surfaces and the accuracy].

    memory: int or str
        Most memory to use, such as 500M, 2G or 2GiB [default: as much as it takes].

    threads: int
        Threads to use, all by default; results do not depend on it.

    audit: float
        Seconds that about two threads take to check what is printed by path tracing; the number of rays follows from this and from
        counts of the scene [default: a twentieth of the run, 0.1 to 5].

    transfers: str or a path
        File of the transfers between the surfaces, which is made where there is none: runs on the same surfaces, with other
        materials, temperatures or lamps, find none of them again; those of other options are added.
    """

    subdivide: int | Literal["auto"]
    eps: float
    shadow_eps: float
    shadows: Literal["auto", "off", "rays", "exact"]
    transport: Literal["auto", "exact", "sampled"]
    rays: int
    memory: int | str
    threads: int
    audit: float
    transfers: str | os.PathLike[str]


class HeatMethod(Transfers, total=False):
    """How a balance of heat is computed: the options of `Transfers`, whose `eps` is then 1e-4, and these.

    order: int
        Degree of the polynomials on each element; 0 takes all fluxes as even over it, as thermal networks do, and as is done where
        rays carry the pairs [default: 3].

    solver: str
        Solver of the linear system [default: auto].

    conductances: bool
        Whether the conductances between all surfaces are wanted.
    """

    order: int
    solver: str
    conductances: bool
