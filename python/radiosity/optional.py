"""Packages that are imported only where they are used."""

from __future__ import annotations

import importlib
from types import ModuleType


def optional(name: str, purpose: str) -> ModuleType:
    """The package `name`, or an ImportError that says what needs it and how it is installed."""
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"{purpose} needs the package {name} ({error})\nhelp: pip install {name}", name=name) from error
