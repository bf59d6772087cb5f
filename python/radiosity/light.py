"""Light, read at points, on planes, over cells and through cameras."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _radiosity
from ._radiosity import Error
from .arguments import Array, finite, number, numbers, pair, refusal
from .arrays import directions, vector
from .checked import checked
from .plane import Plane
from .progress import Observer, Shown
from .readings import Readings

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Cells, Picture, Reading
    from .scene import Scene


class Light:
    """The light in a scene. Values are in the unit of the scene."""

    def __init__(self, light: _radiosity.Light, scene_of: Callable[[_radiosity.Scene], Scene]) -> None:
        self._light = light
        self._scene_of = scene_of

    @property
    def scene(self) -> Scene:
        """The scene."""
        return self._scene_of(self._light.scene)

    @property
    def coefficients(self) -> Array:
        """Coefficients of the radiosity, an array (bands, unknowns).

        They belong to the orthonormal polynomials of the elements, element by element (`elements`); ∫ B² dA over an element is the
        sum of their squares.
        """
        return self._light.coefficients

    @property
    def elements(self) -> list[tuple[str, int]]:
        """Of each element the name of its surface, and how many coefficients it has."""
        names = self._light.scene.surfaces
        return [(names[surface], count) for surface, count in self._light.elements]

    @overload
    def irradiance(
        self,
        points: ArrayLike,
        normals: ArrayLike,
        *,
        errors: Literal[False] = False,
        progress: bool | Observer | None = None,
        **reading: Unpack[Reading],
    ) -> Array: ...
    @overload
    def irradiance(
        self,
        points: ArrayLike,
        normals: ArrayLike,
        *,
        errors: Literal[True],
        progress: bool | Observer | None = None,
        **reading: Unpack[Reading],
    ) -> Readings: ...
    def irradiance(
        self,
        points: ArrayLike,
        normals: ArrayLike,
        *,
        errors: bool = False,
        progress: bool | Observer | None = None,
        **reading: Unpack[Reading],
    ) -> Array | Readings:
        """Irradiance at `points` (n, 3) along `normals` (n, 3) of any length, or along one for all: an array (n, bands).

        Points are in the coordinates of the scene. Ask for many points at once: each call prepares the solution anew, which takes some
        milliseconds. All options are listed in `radiosity.options.Reading`.

        With `errors=True` it returns (values, errors, checked): also by how much each reading may be off, in its unit, an array (n,),
        and what path tracing found of about 64 of them, which takes 0.1 s at the least in each call. An array alone is not checked, nor
        are frames, unless `audit` asks for it; more than the errors tell is then a `RadiosityWarning`.
        """
        points = numbers("points", points, ("n", 3))
        normals = directions("normals", normals)
        with Shown(progress) as observer:
            values, told, found = self._light.irradiance(points, normals, errors, reading, observer)
        return Readings(values, told, checked(found)) if errors else values

    def plane(
        self,
        name_or_origin: str | ArrayLike,
        u: ArrayLike | None = None,
        v: ArrayLike | None = None,
        spacing: float | ArrayLike | None = None,
        *,
        progress: bool | Observer | None = None,
        **reading: Unpack[Reading],
    ) -> Plane:
        """The irradiance on a plane of sensors.

        It is one of the scene, `plane("desk")`, or goes from a corner along two edges: `plane(origin, u, v, spacing)`. Cells are at most
        `spacing` long, one number or one along each edge; sensors stand in their middles and receive along u × v. Path tracing checks
        about 64 of them in each call, 0.1 s at the least; of frames only where `audit` asks for it. All options are listed in
        `radiosity.options.Reading`.
        """
        given = _plane(name_or_origin, u, v, spacing)
        with Shown(progress) as observer:
            return Plane(self._light.plane(given, reading, observer), self._light.scene)

    def grid(
        self, cells: tuple[int, int] = (16, 16), *, progress: bool | Observer | None = None, **reading: Unpack[Cells]
    ) -> dict[str, Any]:
        """Means over the cells of every surface, so many along u and v.

        The arrays are "surface" (names), "index" (n, 2), "irradiance" and "radiosity" (n, bands), "error" (n,), by how much each
        irradiance may be off, in its unit, root mean square over the bands, "area" (n,), "position" (n, 3). "checked" is what path
        tracing found of about 64 of the cells; None where it does not know such light, and of frames without `audit`. All options
        are listed in `radiosity.options.Cells`.
        """
        options: dict[str, Any] = {**reading, "cells": pair("cells", cells)}
        if options.get("read_samples") is not None:
            options["read_samples"] = pair("read_samples", options["read_samples"])
        with Shown(progress) as observer:
            grid = self._light.grid(options, observer)
        names = np.array(self._light.scene.surfaces)
        return {
            "surface": names[grid.surface],
            "index": np.array(grid.index, int).reshape(-1, 2),
            "irradiance": grid.irradiance,
            "radiosity": grid.radiosity,
            "error": grid.errors,
            "area": grid.area,
            "position": grid.position,
            "checked": checked(grid.checked),
        }

    def render(
        self,
        camera: Mapping[str, Any] | None = None,
        size: tuple[int, int] | None = None,
        *,
        progress: bool | Observer | None = None,
        **picture: Unpack[Picture],
    ) -> Array:
        """A picture of the radiosity: an array (rows, columns, bands), the first row on top. The radiance is 1/π of it.

        `camera` has eye, target and, unless they are +z and 40, up and fov (degrees, vertical); None is that of the scene, or else one
        that is chosen: from a corner of a room, from outside of other things. `size` is
        (width, height) in pixels. With `audit` path tracing checks about 64 pixels, and more than their errors tell is a
        `RadiosityWarning`. All options are listed in `radiosity.options.Picture`.
        """
        options: dict[str, Any] = dict(picture)
        if size is not None:
            options["size"] = pair("size", size)
        with Shown(progress) as observer:
            return self._light.render(_camera(camera), options, observer)


def _plane(origin: Any, u: Any, v: Any, spacing: Any) -> Any:
    """A plane as it is handed on."""
    rest = [part is None for part in (u, v, spacing)]
    if isinstance(origin, str):
        if not all(rest):
            raise Error("plane: a name, and edges or a spacing\nhelp: give a name alone, or origin, u, v and spacing")
        return origin
    if any(rest):
        raise Error("plane: no edges or no spacing\nhelp: give origin, u, v and spacing, or the name of a plane of the scene")
    both = np.broadcast_to(numbers("spacing", np.atleast_1d(finite("spacing", spacing)), ("1 or 2",)), (2,))
    return vector("origin", origin), vector("u", u), vector("v", v), tuple(both.tolist())


def _camera(camera: Mapping[str, Any] | None) -> Any:
    """A camera as it is handed on."""
    if camera is None:
        return None
    if not isinstance(camera, Mapping):
        raise TypeError(f"camera: a mapping with eye and target is wanted, not {type(camera).__name__}")
    unknown = set(camera) - {"eye", "target", "up", "fov"}
    if unknown or not {"eye", "target"} <= set(camera):
        raise refusal(
            f"camera: the keys {', '.join(map(repr, camera))}", "give eye and target and, where they differ from +z and 40, up and fov"
        )
    eye, target, up = (vector(key, camera.get(key, (0, 0, 1))) for key in ("eye", "target", "up"))
    return eye, target, up, number("fov", camera.get("fov", 40))
