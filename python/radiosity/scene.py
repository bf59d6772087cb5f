"""Scenes, made of arrays or read, and solved."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, SupportsIndex

import numpy as np
from numpy.typing import ArrayLike

from . import _radiosity
from ._radiosity import Error
from .arguments import Array, array_of, numbers, refusal, texts
from .arguments import text as checked_text
from .arrays import Whole, directions, polygons, vector
from .heat import Heat
from .progress import Observer, Shown
from .solution import Solution

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import HeatMethod, Solving


class Scene:
    """Surfaces with their materials, luminaires, a camera and planes of sensors.

    A scene is read (`radiosity.load`), or made part by part; what parts there are and what they mean says docs/scene.md of the
    project, whose keys are the arguments here::

        scene = Scene(bands=["lm"], unit="lx")
        wood = scene.material("wood", reflectance=0.4)
        lamp = scene.material("lamp", reflectance=0, emission=8000)
        scene.polygon("desk", [[0, 0, 0.75], [1.6, 0, 0.75], [1.6, 0.8, 0.75], [0, 0.8, 0.75]], wood)
        scene.disk("lamp", lamp, center=[0.8, 0.4, 1.5], normal=[0, 0, -1], radius=0.2)
        solution = scene.solve(accuracy=1e-2)

    Parts are checked together, and arrays are copied, when the scene is first used; nothing can be added from then on.
    """

    def __init__(
        self,
        bands: Sequence[str] = ("grey",),
        *,
        name: str = "scene",
        title: str | None = None,
        unit: str | None = None,
    ) -> None:
        """A scene of these bands with nothing in it.

        `name` stands before messages; `unit` is that of exitance, irradiance and radiosity, W/m² unless it is told.
        """
        self._label = checked_text("name", name)
        self._parts: dict[str, Any] = {"bands": texts("bands", bands), "materials": {}, "surfaces": []}
        self._parts |= _known(title=title, unit=unit)
        self._valid: _radiosity.Scene | None = None

    @classmethod
    def _of(cls, valid: _radiosity.Scene) -> Scene:
        scene = cls(valid.bands, name=valid.name)
        scene._valid = valid
        return scene

    @classmethod
    def from_toml(cls, text: str, name: str = "scene") -> Scene:
        """The scene in a text in TOML or JSON, as docs/scene.md describes it; `name` stands before messages.

        Files that it names are read from the current folder and below.
        """
        return cls._of(_radiosity.parse(checked_text("text", text), checked_text("name", name)))

    @property
    def _native(self) -> _radiosity.Scene:
        """The valid scene; everything is checked the first time."""
        if self._valid is None:
            self._valid = _radiosity.made(self._parts, self._label)
            self._parts.clear()
        return self._valid

    def _add(self, part: str) -> Any:
        if self._valid is not None:
            raise Error(f"{self._label}: the scene is read or used, and takes no more {part}\nhelp: make another Scene")
        return self._parts

    def material(self, name: str, reflectance: Any = None, emission: Any = None, **keys: Any) -> str:
        """Adds a material, and returns its name.

        `reflectance` (0 ≤ ρ < 1) and `emission` (exitance, W/m² or lm/m²) are numbers, or have one for each band. Further keys:
        `transmittance`, `group`, and for heat `emissivity`, `temperature` (K), `heat_flux` (W/m²), `adiabatic`, `back`.
        """
        name = checked_text("material", name)
        materials = self._add("materials")["materials"]
        if name in materials:
            raise Error(f"material {name!r} is given twice\nhelp: give each its own name")
        materials[name] = _known(reflectance=reflectance, emission=emission, **keys)
        return name

    def surface(self, name: str, material: str | None, **keys: Any) -> None:
        """Adds a surface: its shape is a keyword with a dictionary, such as `disk={"center": …, "normal": …, "radius": …}`.

        Further keys: `two_sided`, `flip`, `back_material`, `group`, `flux`, `opening`, `order`, `subdivide`, `transform`, and those of
        heat.
        """
        self._add("surfaces")["surfaces"].append(_known(name=name, material=material, **keys))

    def polygon(self, name: str, vertices: ArrayLike, material: str | None = None, **keys: Any) -> None:
        """Adds a flat polygon of `vertices` (k, 3), counterclockwise as seen from its front."""
        outline = numbers("vertices", vertices, ("k", 3))
        self.surface(name, material, polygon={"vertices": outline}, **keys)

    def polygons(self, name: str, vertices: ArrayLike, material: str | None = None, **keys: Any) -> None:
        """Adds flat polygons, an array (n, k, 3) or a list of arrays (k, 3), as `name-1`, `name-2` and so on."""
        if not isinstance(vertices, np.ndarray) or vertices.dtype == object:
            for index, outline in enumerate(polygons(vertices), 1):
                self.polygon(f"{name}-{index}", outline, material, **keys)
        else:
            outlines = numbers("polygons", vertices, ("n", "k", 3))
            count, corners, _ = outlines.shape
            indices = np.arange(count * corners, dtype=np.int64).reshape(count, corners)
            self._faces(name, "polygon", outlines.reshape(-1, 3), indices, material, keys)

    def triangles(
        self, name: str, vertices: ArrayLike, faces: ArrayLike, material: str | None = None, **keys: Any
    ) -> None:
        """Adds a mesh of triangles: `vertices` (v, 3) and their indices in `faces` (f, 3), as `name-1`, `name-2` and so on."""
        corners = numbers("vertices", vertices, ("v", 3))
        indices = array_of("faces", faces)
        if indices.ndim != 2 or indices.shape[1] != 3 or indices.dtype.kind not in "iu":
            raise refusal(
                f"faces: an array of shape {indices.shape} of {indices.dtype} instead of (f, 3) of whole numbers",
                "give a row of three indices of vertices for each triangle",
            )
        if indices.size and not (0 <= indices.min() and indices.max() < len(corners)):
            raise refusal(
                f"faces: indices from {indices.min()} to {indices.max()}, of {len(corners)} vertices",
                "count the rows of vertices from 0",
            )
        self._faces(name, "triangle", corners, np.asarray(indices, np.int64), material, keys)

    def _faces(
        self, name: str, shape: str, vertices: Array, corners: Whole, material: str | None, keys: dict[str, Any]
    ) -> None:
        faces = _radiosity.Faces(name, shape, vertices, corners, _known(material=material, **keys))
        self._add("surfaces")["surfaces"].append(faces)

    def parallelogram(
        self, name: str, material: str | None, *, origin: ArrayLike, edge1: ArrayLike, edge2: ArrayLike, **keys: Any
    ) -> None:
        """Adds a parallelogram from a corner along two edges; its front is that of edge1 × edge2."""
        shape = {"origin": vector("origin", origin), "edge1": vector("edge1", edge1), "edge2": vector("edge2", edge2)}
        self.surface(name, material, parallelogram=shape, **keys)

    def disk(
        self, name: str, material: str | None, *, center: ArrayLike, normal: ArrayLike, radius: float, **keys: Any
    ) -> None:
        """Adds a disk, whose front is that of the normal; with `surface(…, disk={…})` also a ring or a sector."""
        shape = {"center": vector("center", center), "normal": vector("normal", normal), "radius": radius}
        self.surface(name, material, disk=shape, **keys)

    def sphere(self, name: str, material: str | None, *, center: ArrayLike, radius: float, **keys: Any) -> None:
        """Adds a sphere, whose front is outside."""
        self.surface(name, material, sphere={"center": vector("center", center), "radius": radius}, **keys)

    def cylinder(
        self, name: str, material: str | None, *, base: ArrayLike, axis: ArrayLike, radius: float, **keys: Any
    ) -> None:
        """Adds the wall of a cylinder from the middle of its base along its axis; its front is outside."""
        shape = {"base": vector("base", base), "axis": vector("axis", axis), "radius": radius}
        self.surface(name, material, cylinder=shape, **keys)

    def luminaire(self, name: str, **keys: Any) -> None:
        """Adds a luminaire: `position`, `aim`, one of `point`, `spot` and `photometry`, `flux` or `intensity`, and so on."""
        self._add("luminaires").setdefault("luminaires", []).append(_known(name=name, **keys))

    def sky(self, **keys: Any) -> None:
        """Gives the scene a sky, which openings let in."""
        self._once("sky", _known(**keys))

    def camera(self, *, eye: ArrayLike, target: ArrayLike, **keys: Any) -> None:
        """Gives the scene a camera; further keys: `up`, `fov` (degrees, vertical), `width`, `height` (pixels)."""
        self._once("camera", _known(eye=vector("eye", eye), target=vector("target", target), **keys))

    def _once(self, part: str, keys: dict[str, Any]) -> None:
        """Adds what a scene has one of."""
        parts = self._add(part)
        if part in parts:
            raise refusal(f"{self._label}: a second {part}", f"give one {part} alone")
        parts[part] = keys

    def plane(self, name: str, *, origin: ArrayLike, u: ArrayLike, v: ArrayLike, spacing: float | ArrayLike) -> None:
        """Adds a plane of sensors from a corner along the edges `u` and `v`; sensors receive along u × v."""
        edges = [vector("u", u), vector("v", v)]
        plane = {"origin": vector("origin", origin), "edges": edges, "spacing": spacing}
        planes = self._add("planes").setdefault("planes", {})
        if checked_text("plane", name) in planes:
            raise refusal(f"plane {name!r} is given twice", "give each its own name")
        planes[name] = plane

    @property
    def name(self) -> str:
        """Its name."""
        return self._label

    @property
    def title(self) -> str | None:
        """Its title, which stands above pictures and reports, if it has one."""
        return self._native.title

    @property
    def bands(self) -> list[str]:
        """Names of its bands: colours or ranges of wavelengths."""
        return self._native.bands

    @property
    def unit(self) -> str:
        """Unit of exitance, irradiance and radiosity."""
        return self._native.unit

    @property
    def surfaces(self) -> list[str]:
        """Names of its surfaces, in order; the back of a two-sided one follows its front."""
        return self._native.surfaces

    @property
    def planes(self) -> list[str]:
        """Names of its planes of sensors."""
        return self._native.planes

    @property
    def light_groups(self) -> dict[str, float]:
        """Factor of each light group on the emission that the scene states."""
        return self._native.light_groups

    @property
    def remarks(self) -> list[str]:
        """What was done to the file of another program that it was read from, and to corners and surfaces that nearly meet."""
        return self._native.remarks

    def to_toml(self) -> str:
        """The text of the scene."""
        return self._native.to_toml()

    def solve(
        self, *, aim: str | tuple[Any, ...] | None = None, progress: bool | Observer | None = None, **method: Unpack[Solving]
    ) -> Solution:
        """The light in it, as `radiosity solve` computes it.

        `accuracy=1e-2` is the wanted relative error, `aim` of what: "gathered" (light as sensors and pictures read it, on all surfaces),
        "solution" (the polynomials), "picture" (what the scene's camera sees), ("plane", name) or ("points", points, normals). All
        options are listed in `radiosity.options.Solving`; results are those of the command to the last bit.

        `progress`: True for a bar, False for none, None for a bar on a terminal, or observer(stage, done, total). Other threads run
        meanwhile, and Ctrl-C ends the work. What is less accurate than asked for is told by a `RadiosityWarning`.
        """
        kind, sensors = self._aim(aim)
        with Shown(progress) as observer:
            return Solution(_radiosity.solution_of(self._native, method, kind, sensors, observer), Scene._of)

    def _aim(self, aim: str | tuple[Any, ...] | None) -> tuple[str | None, tuple[Any, Any] | None]:
        """The kind of an aim, and its points with their normals."""
        match aim:
            case ("points", points, normals):
                return "points", (numbers("points", points, ("n", 3)), directions("normals", normals))
            case ("plane", str(name)):
                return "points", self._native.sensors(name)
            case None | str():
                return aim, None
            case _:
                return repr(aim), None

    def heat(self, *, progress: bool | Observer | None = None, **method: Unpack[HeatMethod]) -> Heat:
        """The balance of radiant heat: temperatures (K) and flows (W), as `radiosity heat` computes it.

        Every surface, or its material, has an emissivity and one of temperature, heat_flux and adiabatic; lengths are metres. All options
        are listed in `radiosity.options.HeatMethod`.
        """
        with Shown(progress) as observer:
            return Heat(_radiosity.heat_of(self._native, method, observer))

    def heat_sweep(
        self,
        quantity: str,
        values: ArrayLike,
        *,
        progress: bool | Observer | None = None,
        **method: Unpack[HeatMethod],
    ) -> list[Heat]:
        """The balances of radiant heat for some values of a quantity, by transfers that are found once.

        `quantity` is a surface (or "wall-*", all whose names begin so) or a material, and one of temperature, heat_flux and emissivity:
        "panel.emissivity". Path tracing checks the balance of the largest flows, which alone has `checked`; the errors of all others are as many times larger. Options are those of `heat`, without conductances.
        """
        points = [float(value) for value in numbers("values", values, ("n",))]
        with Shown(progress) as observer:
            name = checked_text("quantity", quantity)
            return [Heat(native) for native in _radiosity.heats_of(self._native, name, points, method, observer)]

    def __reduce_ex__(self, protocol: SupportsIndex) -> Any:
        """A scene that was read or used is copied by its text."""
        if self._valid is None:
            return super().__reduce_ex__(protocol)
        return Scene.from_toml, (self.to_toml(), self._label)

    def __repr__(self) -> str:
        return f"<Scene {self._label!r}>"


def _known(**keys: Any) -> dict[str, Any]:
    """What is not None."""
    return {key: value for key, value in keys.items() if value is not None}
