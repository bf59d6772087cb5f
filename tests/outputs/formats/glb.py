"""Binary glTF: a column is all accessors of one use, such as POSITION, or a channel of an image; the rest is its JSON.

Reference: Khronos, "glTF 2.0 Specification", 3.6.2 (accessors), 4.4 (GLB).
"""

import struct

from content import Content
from formats import json_tree, png
from formats.npy import unpacked
from formats.opaque import masked

__all__ = ["content", "masked"]

# Letters of `struct`, by the types of components that the outputs have.
KINDS = {5123: "H", 5125: "I", 5126: "f"}
COMPONENTS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3}


def content(file: str, data: bytes, masks: object) -> Content:
    (length,) = struct.unpack_from("<I", data, 12)
    tree = json_tree.parse(data[20 : 20 + length])
    binary = data[28 + length :]
    found = Content()
    json_tree.add(found, "", "", tree)
    for mesh in tree["meshes"]:
        for primitive in mesh["primitives"]:
            for use, index in (primitive["attributes"] | {"indices": primitive["indices"]}).items():
                found.column(use).extend(_numbers(tree, int(index), binary))
    for image in tree["images"]:
        view = tree["bufferViews"][int(image["bufferView"])]
        png.add(found, "image ", binary[_place(view) : _place(view) + int(view["byteLength"])])
    return found


def _numbers(tree: dict, index: int, binary: bytes) -> list[float]:
    accessor = tree["accessors"][index]
    letter = KINDS[int(accessor["componentType"])]
    view = tree["bufferViews"][int(accessor["bufferView"])]
    stride = COMPONENTS[accessor["type"]] * struct.calcsize("<" + letter)
    if int(view.get("byteStride", stride)) != stride:
        raise ValueError("only accessors without gaps are read")
    begin = _place(view) + _place(accessor)
    return unpacked(letter, binary[begin : begin + int(accessor["count"]) * stride])


def _place(of: dict) -> int:
    """Where a view or an accessor begins in what it is a part of."""
    return int(of.get("byteOffset", 0))
