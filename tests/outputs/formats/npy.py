"""NPY, an array of NumPy: a column is all of it.

Reference: NumPy, "NPY format", version 1.0.
"""

import ast
import struct

from content import Content
from formats.opaque import masked

__all__ = ["content", "masked"]

MAGIC = b"\x93NUMPY\x01\x00"
# Letters of `struct` for the kinds of numbers.
KINDS = {"<f8": "d", "<f4": "f", "<i8": "q", "<i4": "i", "|u1": "B"}


def content(file: str, data: bytes, masks: object) -> Content:
    found = Content()
    add(found, "array", data)
    return found


def add(to: Content, name: str, data: bytes) -> None:
    """Adds the array of a file or of a member of an archive."""
    if not data.startswith(MAGIC):
        raise ValueError(f"{name} is no NPY of version 1.0")
    begin = len(MAGIC) + 2
    (length,) = struct.unpack_from("<H", data, len(MAGIC))
    header = ast.literal_eval(data[begin : begin + length].decode("latin-1"))
    values, kind = data[begin + length :], header["descr"]
    to.texts.append(f"{name}: {sorted(header.items())}")
    if kind in KINDS:
        to.column(name).extend(unpacked(KINDS[kind], values))
    else:
        to.texts.append(f"{name}: {values!r}")


def unpacked(letter: str, data: bytes) -> list[float]:
    """The little-endian numbers of a kind of `struct`."""
    count = len(data) // struct.calcsize("<" + letter)
    return list(struct.unpack(f"<{count}{letter}", data))
