"""OpenEXR of one part in scan lines: a column is a channel.

Reference: Academy Software Foundation, "OpenEXR File Layout"; ZIP compression as `ImfZip.cpp` describes it: bytes of even
places, then of odd ones, each as its difference from the one before, + 128.
"""

import struct
import zlib

from content import Content
from formats.npy import unpacked
from formats.opaque import masked

__all__ = ["content", "masked"]

MAGIC = 20000630
# Letter of `struct`, by the kind of a channel.
KINDS = {0: "I", 1: "e", 2: "f"}
# Lines of a block, by the compression: none, ZIPS, ZIP.
LINES = {0: 1, 2: 1, 3: 16}


def content(file: str, data: bytes, masks: object) -> Content:
    magic, version = struct.unpack_from("<II", data)
    if (magic, version & ~0x400) != (MAGIC, 2):
        raise ValueError("only OpenEXR of one part in scan lines is read")
    header, place = attributes(data, 8)
    found = Content(texts=[f"{name}: {value.hex()}" for name, value in header.items()])
    left, top, right, bottom = struct.unpack("<4i", header["dataWindow"])
    width, height = right - left + 1, bottom - top + 1
    channels = _channels(header["channels"])
    lines = LINES[header["compression"][0]]
    blocks = -(-height // lines)
    for offset in struct.unpack_from(f"<{blocks}Q", data, place):
        first, size = struct.unpack_from("<iI", data, offset)
        rows = min(lines, bottom + 1 - first)
        _add_block(found, channels, width, rows, data[offset + 8 : offset + 8 + size])
    return found


def attributes(data: bytes, place: int) -> tuple[dict[str, bytes], int]:
    """The attributes of the header by name, and where it ends."""
    found = {}
    while data[place]:
        name, kind = data[place:].split(b"\0", 2)[:2]
        place += len(name) + len(kind) + 2
        (size,) = struct.unpack_from("<I", data, place)
        found[name.decode()] = data[place + 4 : place + 4 + size]
        place += 4 + size
    return found, place + 1


def _channels(data: bytes) -> list[tuple[str, str]]:
    """Name and letter of each channel."""
    found = []
    while data[0]:
        name, rest = data.split(b"\0", 1)
        found.append((name.decode("latin-1"), KINDS[struct.unpack_from("<I", rest)[0]]))
        data = rest[16:]
    return found


def _add_block(to: Content, channels: list[tuple[str, str]], width: int, rows: int, packed: bytes) -> None:
    """Adds the numbers of some lines, channel by channel in each."""
    full = rows * width * sum(struct.calcsize("<" + letter) for _, letter in channels)
    data, place = packed if len(packed) == full else inflated(packed), 0
    for _ in range(rows):
        for name, letter in channels:
            size = width * struct.calcsize("<" + letter)
            to.column(f"channel {name}").extend(unpacked(letter, data[place : place + size]))
            place += size


def inflated(packed: bytes) -> bytes:
    """The numbers of a block of ZIP compression."""
    coded = bytearray(zlib.decompress(packed))
    for i in range(1, len(coded)):
        coded[i] = (coded[i - 1] + coded[i] - 128) & 255
    half = (len(coded) + 1) // 2
    data = bytearray(len(coded))
    data[0::2], data[1::2] = coded[:half], coded[half:]
    return bytes(data)
