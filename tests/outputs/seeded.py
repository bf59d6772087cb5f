"""Faults that are seeded in copies of single outputs, to see that each is found, and that only what was measured is not."""

import base64
import io
import math
import pathlib
import re
import struct
import zipfile
import zlib
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import difference
from formats import exr, format_of, png
from formats.text import NUMBER
from formats.vtu import ARRAY
from masks import Masks

# Relative, beyond the tolerance of 1e-12 and within it.
BEYOND, WITHIN = 1e-11, 1e-13

Edit = Callable[[bytes], bytes]


@dataclass(frozen=True)
class Fault:
    """A fault in a file: the largest difference that was found, and whether checksums change; each with what is expected."""

    file: str
    what: str
    size: float
    tolerance: float
    is_to_differ: bool
    has_new_checksum: bool
    is_to_have_new_checksum: bool

    @property
    def is_as_expected(self) -> bool:
        differs = self.size > self.tolerance
        return differs == self.is_to_differ and self.has_new_checksum == self.is_to_have_new_checksum

    def __str__(self) -> str:
        mark = "ok  " if self.is_as_expected else "FAIL"
        new = "new checksum" if self.has_new_checksum else "same checksum"
        return f"{mark} {self.file}: {self.what}: difference {self.size:.1e}, {new}"


def faults(folder: pathlib.Path, tolerance: float, masks: Masks) -> Iterator[Fault]:
    """One fault after the other, in files of a recording."""

    def seed(file: str, what: str, edit: Edit, differs: bool = True, new_checksum: bool = True) -> Fault:
        name, data = file.rpartition("/")[2], (folder / file).read_bytes()
        edited = edit(data)
        if edited == data:
            raise ValueError(f"{file}: {what} changes nothing")
        form = format_of(name)
        found = difference.of_file(name, form.content(name, data, masks), form.content(name, edited, masks), masks)
        size = max((each.size for each in found), default=0.0)
        changed = form.masked(name, data, masks) != form.masked(name, edited, masks)
        return Fault(file, what, size, tolerance, differs, changed, new_checksum)

    for file in ["cornell-box-lu/box.json", "sky/cells.csv", "curved-txt/F.txt"]:
        yield seed(file, f"{BEYOND} of a number", _scaled_literal(BEYOND))
        yield seed(file, f"{WITHIN} of a number", _scaled_literal(WITHIN), differs=False)
    report = "cornell-box-lu/report.json"
    yield seed(report, "another time", _replaced(r'"total": \d\.', b'"total": 9.'), differs=False, new_checksum=False)
    yield seed(report, "another residual", _replaced(r'"residual": \d', b'"residual": 9'), differs=False)
    yield seed(report, "another absorbed power", _replaced(r'("energy_absorbed": \d+\.\d{4})\d', rb"\g<1>0"))
    yield seed(report, "another solver", _replaced('"lu"', b'"qr"'))
    yield seed(report, "a key less", _replaced(r'"converged": true,', b""))
    summary = "cornell-box-lu/stderr"
    yield seed(summary, "another time", _replaced(r"\d\.\d+ s", b"9.999 s"), differs=False, new_checksum=False)
    yield seed(summary, "another count", _replaced(r"\d kernel samples", b"x kernel samples"))
    yield seed("hinge-squares/runs.csv", "another error", _replaced(r"0\.5194867824", b"0.5194867825"))
    yield seed("hinge-squares/runs.csv", "another time", _seconds_of_runs, differs=False, new_checksum=False)
    yield seed("hinge-squares/study.svg", "another place", _replaced(r'cx="(\d)', rb'cx="1\1'))
    yield seed("view3d-csr/F.npz", f"{BEYOND} of a number", _in_archive("data.npy", _scaled_double(BEYOND)))
    yield seed("shield/C.npy", f"{BEYOND} of a number", _scaled_double(BEYOND))
    yield seed("groups-dimmed/dimmed.vtu", f"{BEYOND} of a number", _in_grid("irradiance lm", _scaled_double(BEYOND)))
    yield seed("teapot-png/teapot.png", "a code of a pixel", _in_picture)
    yield seed("sliding-light-series/light-01.exr", "the last bit of a number", _in_raster)
    yield seed("every-shape-glb/shapes.glb", "the last bit of a number", _in_geometry)
    yield seed("groups-html/groups.html", "a bit of the light", _in_page)
    yield seed("office-html/office.html", "a code of a pixel", _in_pictures_of_page)
    yield seed("office-html/office.html", "a digit of a table", _replaced(r">279\.6<", b">279.7<"))
    yield seed("blue-panel-gif/panel.gif", "a byte", lambda data: data[:-9] + bytes([data[-9] ^ 1]) + data[-8:])


def _replaced(pattern: str, by: bytes) -> Edit:
    return lambda data: re.sub(pattern.encode(), by, data, count=1)


def _scaled_literal(part: float) -> Edit:
    """Makes the largest number of 15 digits or more, which is the largest of its column, larger by this part of itself."""

    def edit(data: bytes) -> bytes:
        text = data.decode()
        longest = [each for each in NUMBER.finditer(text) if len(each[0]) >= 16]
        largest = max(longest, key=lambda each: abs(float(each[0])))
        return (text[: largest.start()] + repr(float(largest[0]) * (1 + part)) + text[largest.end() :]).encode()

    return edit


def _scaled_double(part: float) -> Edit:
    """That change in the largest 64-bit number among the last ones of the data."""

    def edit(data: bytes) -> bytes:
        begin = len(data) % 8 if not data.startswith(b"\x93NUMPY") else 10 + int.from_bytes(data[8:10], "little")
        numbers = struct.unpack(f"<{(len(data) - begin) // 8}d", data[begin:])
        index = max(range(len(numbers)), key=lambda i: abs(numbers[i]))
        place = begin + 8 * index
        return data[:place] + struct.pack("<d", numbers[index] * (1 + part)) + data[place + 8 :]

    return edit


def _seconds_of_runs(data: bytes) -> bytes:
    """Another time in the first row, whose eighth cell it is."""
    header, first, rest = data.split(b"\n", 2)
    cells = first.split(b",")
    cells[7] = b"9.5"
    return b"\n".join([header, b",".join(cells), rest])


def _in_archive(member: str, edit: Edit) -> Edit:
    def edited(data: bytes) -> bytes:
        out = io.BytesIO()
        with zipfile.ZipFile(io.BytesIO(data)) as archive, zipfile.ZipFile(out, "w") as copy:
            for name in archive.namelist():
                own = archive.read(name)
                copy.writestr(name, edit(own) if name == member else own)
        return out.getvalue()

    return edited


def _in_grid(array: str, edit: Edit) -> Edit:
    def edited(data: bytes) -> bytes:
        own = next(each for each in ARRAY.finditer(data.decode()) if each[3] == array)
        packed = base64.b64decode(own[4])
        anew = base64.b64encode(packed[:8] + edit(packed[8:])).decode()
        return data.decode().replace(own[4], anew).encode()

    return edited


def _in_picture(data: bytes) -> bytes:
    """The picture with the last code of its last row larger by one."""
    begin, end = data.index(b"IDAT") - 4, data.rindex(b"IEND") - 4
    filtered = bytearray(zlib.decompress(b"".join(body for kind, body in png.chunks(data) if kind == b"IDAT")))
    filtered[-1] = (filtered[-1] + 1) & 255
    body = b"IDAT" + zlib.compress(bytes(filtered))
    return data[:begin] + struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body)) + data[end:]


def _in_raster(data: bytes) -> bytes:
    """The raster with the last bit changed of the last number that is not 0; its last block stands uncompressed."""
    attributes, place = exr.attributes(data, 8)
    _, _, right, bottom = struct.unpack("<4i", attributes["dataWindow"])
    (offset,) = struct.unpack_from("<Q", data, place + 8 * (math.ceil((bottom + 1) / 16) - 1))
    first, size = struct.unpack_from("<iI", data, offset)
    numbers = bytearray(exr.inflated(data[offset + 8 : offset + 8 + size]))
    numbers[-4] ^= 1
    return data[:offset] + struct.pack("<iI", first, len(numbers)) + bytes(numbers)


def _in_geometry(data: bytes) -> bytes:
    """The last bit of the first number of the first mesh that is not 0, which is a place."""
    (length,) = struct.unpack_from("<I", data, 12)
    place = 28 + length
    while data[place : place + 4] == bytes(4):
        place += 4
    return data[:place] + bytes([data[place] ^ 1]) + data[place + 1 :]


def _in_page(data: bytes) -> bytes:
    own = re.search(rb'id="light">([^<]*)', data)
    numbers = bytearray(zlib.decompress(base64.b64decode(own[1]), -zlib.MAX_WBITS))
    numbers[len(numbers) // 3] ^= 1
    packer = zlib.compressobj(wbits=-zlib.MAX_WBITS)
    return data.replace(own[1], base64.b64encode(packer.compress(numbers) + packer.flush()))


def _in_pictures_of_page(data: bytes) -> bytes:
    own = re.search(rb"(?<=base64,)[A-Za-z0-9+/=]+", data)
    return data.replace(own[0], base64.b64encode(_in_picture(base64.b64decode(own[0]))))
