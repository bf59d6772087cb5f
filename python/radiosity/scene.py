"""Scenes: read, built in, or made of arrays."""

from __future__ import annotations

import os
from collections.abc import Mapping

from . import _radiosity
from .progress import Observer, Shown
from .solution import Solution


class Scene:
    """Surfaces with their materials, luminaires, a camera and planes of sensors."""

    def __init__(self, bands: list[str] | tuple[str, ...] = ("grey",), *, name: str = "scene") -> None:
        self._bands = list(bands)
        self._name = name
        self._read: _radiosity.Scene | None = None

    @classmethod
    def _of(cls, read: _radiosity.Scene) -> Scene:
        scene = cls(read.bands, name=read.name)
        scene._read = read
        return scene

    @classmethod
    def from_toml(cls, text: str, name: str = "scene") -> Scene:
        """The scene in a text as docs/scene.md describes it; `name` stands before messages."""
        return cls._of(_radiosity.parse(text, name))

    @property
    def _native(self) -> _radiosity.Scene:
        if self._read is None:
            raise NotImplementedError("scenes of arrays")
        return self._read

    @property
    def name(self) -> str:
        """Its name."""
        return self._name

    @property
    def bands(self) -> list[str]:
        """Names of its bands: colours or ranges of wavelengths."""
        return self._bands

    @property
    def surfaces(self) -> list[str]:
        """Names of its surfaces, in order."""
        return self._native.surfaces

    def solve(self, *, progress: bool | Observer | None = None) -> Solution:
        """The light in it."""
        with Shown(progress) as observer:
            return Solution(self._native.solve(observer))


def load(source: str | os.PathLike[str], *, set: Mapping[str, float] | None = None) -> Scene:
    """The scene in a file, or the built-in one of that name."""
    return Scene._of(_radiosity.load(os.fspath(source), dict(set or {})))
