"""Texels of a page to walk through (`render SCENE -o PAGE.html`) beside irradiance that `probe` gathers at the same
places. See README.md.

    python pages.py SCENE PAGE.html --surface floor [--rows 3] [--eps 1e-3] [--command radiosity]

Whole rows of texels of a flat quadrilateral are read as crates/output/src/documents/viewer/data.js reads
them. It prints the rms of the relative differences, the largest, and the differences' steps from each texel to the next
one: a joint in the page is a step that the gathered light lacks. Texels whose reading is told to err by 0.5 % and more
are left out; so are those at the border, where another surface may touch.
"""

import argparse
import base64
import csv
import json
import math
import re
import struct
import subprocess
import tempfile
import zlib

# Error that is told of a reading, over itself, up to which texels are held to it.
KNOWN = 5e-3

# Part of the largest irradiance up to which something stands on a place.
DARK = 1e-3


def script(page, name):
    """Text of a script element of the page."""
    return re.search(rf'id="{name}">(.*?)</script>', page, re.S).group(1).strip()


def inflated(page, name):
    """Bytes that a script element holds, deflated and in Base64."""
    return zlib.decompress(base64.b64decode(script(page, name)), -15)


def planes(light, header):
    """Irradiance of each surface: one grid, row by row, for each pair of a part and a band."""
    count, following = len(light) // 2, 0
    for surface in header["surfaces"]:
        columns, rows = surface["texels"]
        own = []
        for _ in range(len(header["parts"]) * len(header["bands"])):
            grid, first = [], 0
            for _ in range(rows):
                row, before = [], first
                for column in range(columns):
                    before = (before + light[following] + 256 * light[count + following]) & 0xFFFF
                    first = before if column == 0 else first
                    row.append(header["scale"] * struct.unpack("<e", struct.pack("<H", before))[0])
                    following += 1
                grid.append(row)
            own.append(grid)
        yield surface, own


def corners(shape, header, name):
    """Places and parameters of the corners of a surface's triangles."""
    every = sum(surface["corners"] for surface in header["surfaces"])
    first = 0
    for surface in header["surfaces"]:
        if surface["name"] == name:
            break
        first += surface["corners"]
    indices = range(first, first + surface["corners"])
    middle = header["middle"]
    places = [struct.unpack_from("<3f", shape, 12 * k) for k in indices]
    parameters = [struct.unpack_from("<2f", shape, 12 * every + 8 * k) for k in indices]
    return [[x + m for x, m in zip(place, middle)] for place in places], parameters


def chart(places, parameters):
    """The bilinear map from parameters to places of a flat quadrilateral, by its corners."""
    ends = [next(p for p, uv in zip(places, parameters) if uv == (u, v)) for v in (-1, 1) for u in (-1, 1)]

    def place(u, v):
        weights = [(1 - u) * (1 - v), (1 + u) * (1 - v), (1 - u) * (1 + v), (1 + u) * (1 + v)]
        return [sum(weight * x for weight, x in zip(weights, axis)) / 4 for axis in zip(*ends)]

    return place


def gathered(args, place, texels):
    """Irradiance of the first band at texels of a surface, whose front its parameters turn round to the left."""
    corner, along, across = place(0, 0), place(1, 0), place(0, 1)
    u, v = ([q - p for p, q in zip(corner, other)] for other in (along, across))
    normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
    length = math.hypot(*normal)
    normal = [x / length for x in normal]
    with tempfile.TemporaryDirectory() as here:
        with open(f"{here}/points.csv", "w") as points:
            print("x,y,z,nx,ny,nz", file=points)
            for texel in texels:
                print(*place(*texel), *normal, sep=",", file=points)
        command = [args.command, "probe", args.scene, "--points", f"{here}/points.csv", "-o", f"{here}/table.json"]
        subprocess.run([*command, "--read-eps", str(args.eps), "--read-by", "cells"], check=True, capture_output=True)
        with open(f"{here}/table.json") as table:
            readings = json.load(table)["points"]
    dark = DARK * max(rms(reading["irradiance"]) for reading in readings)
    return [known(reading, dark) for reading in readings]


def known(reading, dark):
    """Irradiance of a reading in the first band, None below what stands there, or where it is not known."""
    size = rms(reading["irradiance"])
    return reading["irradiance"][0] if size > dark and reading["error"] < KNOWN * size else None


def differences(args, place, grid):
    """Relative differences of whole rows of texels from what is gathered, row by row, where
    these are known."""
    rows, columns = len(grid), len(grid[0])
    chosen = [round((k + 1) * (rows - 1) / (args.rows + 1)) for k in range(args.rows)]
    inner = range(1, columns - 1)
    texels = [(2 * i / (columns - 1) - 1, 2 * j / (rows - 1) - 1) for j in chosen for i in inner]
    right = iter(gathered(args, place, texels))
    rows = [[(grid[j][i], next(right)) for i in inner] for j in chosen]
    return [[shown / there - 1 for shown, there in row if there is not None] for row in rows]


def rms(values):
    """Root of the mean square."""
    return math.sqrt(sum(value * value for value in values) / len(values))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("page")
    parser.add_argument("--surface", default="floor")
    parser.add_argument("--rows", type=int, default=3)
    parser.add_argument("--eps", type=float, default=1e-3)
    parser.add_argument("--command", default="radiosity")
    args = parser.parse_args()
    with open(args.page, encoding="utf8") as page:
        page = page.read()
    header = json.loads(script(page, "header"))
    light = inflated(page, "light")
    grid = next(own[0] for surface, own in planes(light, header) if surface["name"] == args.surface)
    place = chart(*corners(inflated(page, "shape"), header, args.surface))
    rows = differences(args, place, grid)
    every = [value for row in rows for value in row]
    steps = [after - before for row in rows for before, after in zip(row, row[1:])]
    above = [sum(abs(value) > limit for value in every) for limit in (5e-3, 1e-2)]
    print(
        f"{args.surface}: {len(every)} of {len(grid)} x {len(grid[0])} texels, rms {100 * rms(every):.2f} %, largest "
        f"{100 * max(map(abs, every)):.2f} %, above 0.5 % {above[0]}, above 1 % {above[1]}; steps rms "
        f"{100 * rms(steps):.2f} %, largest {100 * max(map(abs, steps)):.2f} %"
    )


if __name__ == "__main__":
    main()
