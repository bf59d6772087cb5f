"""Diffuse light and radiant heat between curved surfaces."""

from ._radiosity import __version__

__all__ = ["__version__"]
