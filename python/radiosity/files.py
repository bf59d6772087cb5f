"""Scenes and solutions that files hold."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import TYPE_CHECKING

from . import _radiosity
from .arguments import file_path, named_numbers
from .scene import Scene
from .solution import Solution

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from .options import Import


def load(source: str | os.PathLike[str], *, set: Mapping[str, float] | None = None, **options: Unpack[Import]) -> Scene:
    """The scene in a file, or the built-in one of that name (`radiosity.builtins()`).

    `set` gives values to parameters of a built-in scene, to variables of a file, and factors to light groups. Files are .toml and .json,
    or of another program: .mgf, .obj, .gltf, .glb, .stl, .ply, .xml of Mitsuba, .rad of Radiance, .vs3 of View3D. All options are listed
    in `radiosity.options.Import`. A file that cannot be read raises `OSError`: `FileNotFoundError`, `PermissionError` and so on.
    """
    settings = named_numbers("set", {} if set is None else set)
    return Scene._of(_radiosity.load(file_path("source", source), settings, options))


def load_solution(path: str | os.PathLike[str], *, set: Mapping[str, float] | None = None) -> Solution:
    """The solution in a file that `Solution.save` or `radiosity solve` wrote; `set` gives factors to light groups."""
    factors = named_numbers("set", {} if set is None else set)
    return Solution(_radiosity.load_solution(file_path("path", path), factors), Scene._of)
