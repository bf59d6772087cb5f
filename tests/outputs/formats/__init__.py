"""The formats of the outputs, by the endings of files.

Each module has `masked`, the bytes of a file without what was measured, of which checksums are made, and `content`, its texts
and columns of numbers.
"""

import pathlib
import types

from formats import csv_table, exr, glb, html, json_tree, npy, npz, opaque, png, text, vtu

BY_ENDING: dict[str, types.ModuleType] = {
    ".csv": csv_table,
    ".exr": exr,
    ".gif": opaque,
    ".glb": glb,
    ".html": html,
    ".json": json_tree,
    ".npy": npy,
    ".npz": npz,
    ".png": png,
    ".vtu": vtu,
}


def format_of(file: str) -> types.ModuleType:
    """The format of a file of this name: text, where its ending names none."""
    return BY_ENDING.get(pathlib.PurePath(file).suffix, text)
