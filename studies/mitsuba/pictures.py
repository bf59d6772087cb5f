"""Error against time of whole pictures: this program beside the path tracer of Mitsuba 3. See README.md.

Tables are CSV. Errors are L2, relative: √(Σ ((B − M)² − s²) / Σ M²) over the bands of all pixels that are nowhere near an
emitter, M ± s being the truth, B and M exitance, the means over a pixel.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import drjit as dr
import mitsuba as mi
import numpy

from table import integers, row

# Samples a pixel of one launch of the truth, which bounds its memory. Chosen.
LAUNCH = 256
# Samples a pixel that look for emitters. Chosen.
SIGHT = 64


class Picture:
    """The picture of a scene by Mitsuba 3, from the camera of the scene's file."""

    def __init__(self, args):
        mi.set_variant("llvm_ad_rgb")
        dr.set_thread_count(args.threads)
        # It imports what only a chosen variant has.
        from scene import converted

        camera = json.loads(pathlib.Path(args.scene).read_text())["camera"]
        with tempfile.TemporaryDirectory() as folder:
            self.scene = mi.load_dict(converted(args.scene, folder))
        turn = mi.ScalarTransform4f().look_at(camera["eye"], camera["target"], camera["up"])
        film = {"type": "hdrfilm", "width": args.size[0], "height": args.size[1], "rfilter": {"type": "box"},
                "pixel_format": "rgb", "component_format": "float32"}
        self.sensor = mi.load_dict({"type": "perspective", "fov": camera["fov"], "fov_axis": "y", "to_world": turn,
                                    "near_clip": 1e-2, "far_clip": 1e5, "film": film})

    def exitance(self, samples, seed, depth=-1):
        """Exitance (row, column, band), the mean of so many paths a pixel."""
        integrator = mi.load_dict({"type": "path", "max_depth": depth, "rr_depth": 5})
        image = mi.render(self.scene, sensor=self.sensor, integrator=integrator, spp=samples, seed=seed)
        return numpy.pi * numpy.array(image, float)

    def shows_reflected_light(self):
        """Pixels that no pixel with an emitter touches."""
        lamps = self.exitance(SIGHT, 1, depth=1).sum(axis=2) > 0
        wide = numpy.pad(lamps, 1)
        rows, columns = lamps.shape
        near = [wide[i:i + rows, j:j + columns] for i in range(3) for j in range(3)]
        return ~numpy.any(near, axis=0)


def measure_truth(args):
    """The truth of a picture, its standard errors and the pixels that count: written after each launch, and gone on with."""
    picture = Picture(args)
    path = pathlib.Path(args.output)
    if path.exists():
        done = numpy.load(path)
        counts, launches, sums, squares = (done[key] for key in ("counts", "launches", "sums", "squares"))
    else:
        counts, launches, sums, squares = picture.shows_reflected_light(), 0, 0.0, 0.0
    for launch in range(int(launches), max(2, args.samples // LAUNCH)):
        own = picture.exitance(LAUNCH, 1000 + launch)
        sums, squares, launches = sums + own, squares + own * own, launch + 1
        mean = sums / launches
        # Of one launch nothing is known.
        noise = numpy.sqrt(numpy.maximum(squares / launches - mean**2, 0) / (launches - 1 or numpy.nan))
        numpy.savez(path, mean=mean, noise=noise, counts=counts, launches=launches, sums=sums, squares=squares)
        whole = numpy.sqrt((noise[counts] ** 2).sum() / (mean[counts] ** 2).sum())
        print(f"{launches * LAUNCH} paths a pixel: L2 noise {100 * whole:.3f} %, {100 * counts.mean():.1f} % of the "
              "pixels count", file=sys.stderr)


def error(found, path):
    right = numpy.load(path)
    mean, noise, counts = (right[key] for key in ("mean", "noise", "counts"))
    square = ((found - mean) ** 2 - noise**2)[counts].sum() / (mean[counts] ** 2).sum()
    return max(square, 0.0) ** 0.5


def run_mitsuba(args):
    """Error and time for each number of paths a pixel, of several runs the mean square and the median."""
    picture = Picture(args)
    for samples in args.samples:
        seconds, squares = [], []
        # The kernel of each number of samples is compiled by a run that does not count.
        picture.exitance(samples, 999)
        for run in range(args.runs):
            start = time.perf_counter()
            found = picture.exitance(samples, 1 + run)
            seconds.append(time.perf_counter() - start)
            squares.append(error(found, args.truth) ** 2)
        row(args, "Mitsuba 3", f"{samples} paths", statistics.median(seconds), statistics.fmean(squares) ** 0.5)


def exitance_of(picture):
    """Exitance (row, column, band) of a picture of three bands, or of one, which stands for three."""
    bitmap = mi.Bitmap(str(picture))
    names = [channel.name for channel in bitmap.struct_()]
    bands = [name for name in "RGB" if name in names] or [name for name in names if name != "A"] * 3
    return numpy.array(bitmap, float)[:, :, [names.index(name) for name in bands]]


def run_radiosity(args):
    """Error and time of `render` for each choice of options."""
    for setting in args.settings:
        seconds = []
        with tempfile.TemporaryDirectory() as folder:
            picture = pathlib.Path(folder) / "picture.exr"
            command = [args.command, "render", args.original or args.scene, "-q", "-o", str(picture),
                       "--size", "x".join(map(str, args.size)), "--threads", str(args.threads), *setting.split()]
            for _ in range(args.runs):
                start = time.perf_counter()
                subprocess.run(command, check=True)
                seconds.append(time.perf_counter() - start)
            found = exitance_of(picture)
        row(args, args.name, setting or "default", statistics.median(seconds), error(found, args.truth))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parts = parser.add_subparsers(required=True)

    def part(name, run, described):
        own = parts.add_parser(name, help=described)
        own.set_defaults(run=run)
        own.add_argument("scene", help="scene file (JSON) with a camera")
        own.add_argument("--size", type=lambda text: [int(n) for n in text.split("x")], default=[256, 256])
        own.add_argument("--threads", type=int, default=2)
        own.add_argument("-o", "--output", required=True)
        return own

    own = part("truth", measure_truth, "writes the picture by very many paths, or goes on with one")
    own.add_argument("--samples", type=int, default=2**14)
    own = part("mitsuba", run_mitsuba, "adds rows of Mitsuba to a table")
    own.add_argument("--truth", required=True)
    own.add_argument("--samples", type=integers, default=[4**k for k in range(1, 6)])
    own.add_argument("--runs", type=int, default=3)
    own = part("radiosity", run_radiosity, "adds rows of this program to a table")
    own.add_argument("--truth", required=True)
    own.add_argument("--original", help="scene that this program takes, where the other has facets for its curves")
    own.add_argument("--command", default="target/release/radiosity")
    own.add_argument("--name", default="radiosity")
    own.add_argument("--settings", type=lambda text: text.split(","), default=[""])
    own.add_argument("--runs", type=int, default=1)
    return parser.parse_args()


if __name__ == "__main__":
    chosen = arguments()
    chosen.run(chosen)
