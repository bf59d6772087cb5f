"""Baked scenes pass the Khronos validator, and three.js shows what `render` shows.

The difference of two pictures is the mean of |a - b| over the mean of a, in linear light, of all pixels and channels. Edges are
smoothed differently by both.
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import numpy
from PIL import Image

RADIOSITY = sys.argv[1:] or ["radiosity"]
HERE = pathlib.Path(__file__).parent
TOOLS = HERE.parent.parent / "target" / "external"
LARGEST = 0.02

# Scene, options of both pictures, pixels, texels.
CASES = [
    ("cornell-box", ["--exposure", "0.9"], "400x400", "1024x1024"),
    ("teapot", ["--exposure", "1", "--read", "direct"], "600x450", "512x512"),
    # Written and validated only: two bands, a hole, curved surfaces cut into elements.
    (str(HERE / "curved.toml"), ["--show", "irradiance", "--read", "direct"], None, "128x128"),
]


def linear(path):
    """Linear light of a picture, which is sRGB."""
    codes = numpy.asarray(Image.open(path).convert("RGB")) / 255
    return numpy.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055) ** 2.4)


def photographed(folder, pixels):
    """The file room.glb in `folder` as three.js shows it."""
    for name in ["node_modules"]:
        (folder / name).symlink_to((TOOLS / name).resolve())
    shutil.copy(HERE / "glb.html", folder)
    width, height = map(int, pixels.split("x"))
    path = folder / "theirs.png"
    # Windows have a least width.
    flags = f"""--headless --no-sandbox --disable-quic --no-first-run --disable-background-networking
        --disable-component-update --disable-sync --user-data-dir={folder / "profile"} --allow-file-access-from-files
        --use-angle=swiftshader --enable-unsafe-swiftshader --hide-scrollbars --virtual-time-budget=30000
        --window-size={width + 600},{height + 200} --screenshot={path}""".split()
    page = f"file://{folder / 'glb.html'}#{pixels}"
    subprocess.run(["chromium", *flags, page], check=True, capture_output=True, timeout=300)
    return linear(path)[:height, :width]


def check(scene, options, pixels, texels, folder):
    def render(name, size):
        command = [*RADIOSITY, "render", str(folder / "s.json"), "-q", *options, "--size", size]
        subprocess.run([*command, "-o", str(folder / name)], check=True)

    subprocess.run([*RADIOSITY, "solve", scene, "-q", "-o", str(folder / "s.json")], check=True)
    render("room.glb", texels)
    environment = {**os.environ, "NODE_PATH": str((TOOLS / "node_modules").resolve())}
    subprocess.run(["node", str(HERE / "glb.js"), str(folder / "room.glb")], check=True, env=environment)
    if pixels is None or os.environ.get("PICTURES") == "off":
        return
    render("ours.png", pixels)
    ours, theirs = linear(folder / "ours.png"), photographed(folder, pixels)
    difference = abs(ours - theirs).mean() / ours.mean()
    print(f"{scene}: the pictures differ by {100 * difference:.2f} % of the light")
    assert difference <= LARGEST


if __name__ == "__main__":
    for scene, options, pixels, texels in CASES:
        with tempfile.TemporaryDirectory() as folder:
            check(scene, options, pixels, texels, pathlib.Path(folder))
