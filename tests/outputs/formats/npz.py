"""NPZ, arrays of NumPy in a ZIP file: a column is an array."""

import io
import zipfile

from content import Content
from formats import npy
from formats.opaque import masked

__all__ = ["content", "masked"]


def content(file: str, data: bytes, masks: object) -> Content:
    found = Content()
    with zipfile.ZipFile(io.BytesIO(data)) as archive:
        for name in archive.namelist():
            npy.add(found, name.removesuffix(".npy"), archive.read(name))
    return found
