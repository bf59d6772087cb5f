"""VTK's unstructured grids: a column is an array, in base64 after its number of bytes as 64 bits.

Reference: VTK, "VTK XML Format".
"""

import base64
import re

from content import Content
from formats.npy import unpacked
from formats.opaque import masked

__all__ = ["content", "masked"]

ARRAY = re.compile(r'(<DataArray type="(\w+)" Name="([^"]*)"[^>]*>)([^<]*)(?=</DataArray>)')
# Letters of `struct`, by the types of VTK; String is text.
KINDS = {"Float64": "d", "Int64": "q", "UInt8": "B"}
COUNT = 8


def content(file: str, data: bytes, masks: object) -> Content:
    text = data.decode()
    found = Content(texts=ARRAY.sub(r"\1", text).splitlines())
    for _, kind, name, packed in ARRAY.findall(text):
        values = base64.b64decode(packed)[COUNT:]
        if kind == "String":
            found.texts.append(f"{name}: {values!r}")
        else:
            found.column(name).extend(unpacked(KINDS[kind], values))
    return found
