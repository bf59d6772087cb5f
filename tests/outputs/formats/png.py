"""PNG: a column is a channel, of whole numbers from 0 to 255.

Reference: W3C, "Portable Network Graphics (PNG) Specification", third edition: 9 (filtering), 11.2 (chunks).
"""

import struct
import zlib

from content import Content
from formats.opaque import masked

__all__ = ["content", "masked"]

SIGNATURE = b"\x89PNG\r\n\x1a\n"
# Channels of the colour types of 8 bits that the outputs have.
CHANNELS = {0: 1, 2: 3, 3: 1, 6: 4}


def content(file: str, data: bytes, masks: object) -> Content:
    found = Content()
    add(found, "", data)
    return found


def add(to: Content, name: str, data: bytes) -> None:
    """Adds a picture, whose channels are called `name` and by their number."""
    packed = b""
    for kind, body in chunks(data):
        if kind == b"IDAT":
            packed += body
        else:
            to.texts.append(f"{name}{kind.decode()}: {body.hex()}")
        if kind == b"IHDR":
            width, height, depth, colour, *_, interlaced = struct.unpack(">IIBBBBB", body)
    if depth != 8 or interlaced:
        raise ValueError("only pictures of 8 bits without interlacing are read")
    channels = CHANNELS[colour]
    codes = _unfiltered(zlib.decompress(packed), width * channels, height, channels)
    for channel in range(channels):
        to.column(f"{name}channel {channel}").extend(codes[channel::channels])


def chunks(data: bytes):
    """Kind and body of each chunk."""
    if not data.startswith(SIGNATURE):
        raise ValueError("this is no PNG")
    place = len(SIGNATURE)
    while place < len(data):
        length, kind = struct.unpack_from(">I4s", data, place)
        yield kind, data[place + 8 : place + 8 + length]
        place += 12 + length


def _unfiltered(filtered: bytes, stride: int, height: int, step: int) -> bytearray:
    """The codes of all rows; `step` is the bytes of a pixel."""
    codes, above = bytearray(), bytearray(stride)
    for row in range(height):
        begin = row * (stride + 1)
        kind, line = filtered[begin], bytearray(filtered[begin + 1 : begin + 1 + stride])
        if kind:
            for i in range(stride):
                left, corner = (line[i - step], above[i - step]) if i >= step else (0, 0)
                line[i] = (line[i] + _predicted(kind, left, above[i], corner)) & 255
        codes += line
        above = line
    return codes


def _predicted(kind: int, left: int, up: int, corner: int) -> int:
    """Prediction of a code from its neighbours by the filter `kind`."""
    match kind:
        case 1:
            return left
        case 2:
            return up
        case 3:
            return (left + up) // 2
        case _:
            p = left + up - corner
            return min((left, up, corner), key=lambda near: abs(p - near))
