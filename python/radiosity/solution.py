"""Solutions of scenes: their light, their reports; dimmed and written."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from . import _radiosity
from .arguments import named_numbers, refusal
from .arguments import path as checked_path
from .checked import Checked, checked
from .light import Light
from .pictures import plot

if TYPE_CHECKING:
    from .scene import Scene


class Solution(Light):
    """A scene with the light in it. Values are in the unit of the scene."""

    def __init__(self, native: _radiosity.Solution, scene_of: Callable[[_radiosity.Scene], Scene]) -> None:
        super().__init__(native.light, scene_of)
        self._native = native

    @property
    def report(self) -> dict[str, Any]:
        """Counts, times, self-checks and warnings, as `radiosity solve --report` writes them."""
        report: dict[str, Any] = json.loads(self._native.report)
        return report

    @property
    def error(self) -> float | None:
        """Estimated relative error of what an accuracy was wanted of; None where none was wanted, or it is not known."""
        return self._native.error

    @property
    def checked(self) -> Checked | None:
        """What path tracing found at about 64 places of the surfaces and planes; None where it does not know such light.

        It looks when this or the report is first asked for, or as soon as the scene is solved with `audit=`: for as long as that says,
        else for a twentieth of the run, 0.1 to 5 s. More than the method tells is a `RadiosityWarning`.
        """
        return checked(self._native.checked)

    def relight(self, factors: Mapping[str, float]) -> Solution:
        """The same with light groups at other factors (≥ 0) of the emission that the scene states; nothing is solved again."""
        return Solution(self._native.relight(named_numbers("factors", factors)), self._scene_of)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the solution: .json, which `load_solution` and `radiosity render` read, or .vtu for ParaView."""
        path = checked_path("path", path)
        ending = os.path.splitext(path)[1].lower()
        if ending not in ("", ".json", ".vtu"):
            raise refusal(f"{path}: the ending {ending} is none of .json and .vtu", "end the name in .json or .vtu")
        folder = os.path.dirname(path) or "."
        handle, beside = tempfile.mkstemp(dir=folder, prefix=".radiosity-")
        os.close(handle)
        try:
            self._native.save(beside, ending == ".vtu")
            os.chmod(beside, 0o666 & ~_mask())
            os.replace(beside, path)
        except BaseException:
            os.unlink(beside)
            raise

    def __reduce__(self) -> Any:
        raise TypeError("a Solution does not pickle: write it with save(path), and read it with radiosity.load_solution(path)")

    def __repr__(self) -> str:
        return f"<Solution of {self._light.scene.name!r}>"

    def plot(self, **options: Any) -> Any:
        """Plots the light with PyVista: :func:`radiosity.interop.plot`, whose arguments it takes."""
        return plot(self, **options)


def _mask() -> int:
    """Permissions that new files do not get."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
