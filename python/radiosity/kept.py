"""Results that pickle: by what they hold, without the library that computed it."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any, ClassVar


class Kept:
    """A result that is pickled, or copied, with what `_native` holds under the names in `_KEPT`."""

    _KEPT: ClassVar[tuple[str, ...]]
    _native: Any

    def __getstate__(self) -> dict[str, Any]:
        held = SimpleNamespace(**{name: getattr(self._native, name) for name in self._KEPT})
        return {**self.__dict__, "_native": held}
