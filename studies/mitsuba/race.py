"""Error against time of irradiance at points: this program beside the path tracer of Mitsuba 3. See README.md.

Tables are CSV. Errors are L2, relative: √(Σ ((E − M)² − s²) / Σ M²), M ± s being the truth.
"""

import argparse
import csv
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

# Launches before times count: kernels are compiled, memory is taken.
WARM_UP = 2


def numbers(path, keys):
    """Columns of a table: one for each key, which may be the beginning of a name."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    names = [next(name for name in rows[0] if name.startswith(key)) for key in keys]
    return numpy.array([[float(row[name]) for name in names] for row in rows]).T


def points(path):
    return numbers(path, ["x", "y", "z"]).T, numbers(path, ["nx", "ny", "nz"]).T


def truth(path):
    return numbers(path, ["E", "sd"])


def error(found, right):
    mean, noise = right
    square = ((found - mean) ** 2 - noise**2).sum() / (mean**2).sum()
    return max(square, 0.0) ** 0.5


def meter(args, lit=True):
    """Points in a scene of Mitsuba."""
    mi.set_variant("llvm_ad_mono")
    dr.set_thread_count(args.threads)
    # They import what only a chosen variant has.
    from irradiance import Meter
    from scene import converted

    start = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        loaded = mi.load_dict(converted(args.scene, folder))
    print(f"{args.scene}: read in {time.perf_counter() - start:.1f} s", file=sys.stderr)
    start = time.perf_counter()
    own = Meter(loaded, *points(args.points), lit)
    for k in range(WARM_UP):
        own.irradiance(16, 1000 + k)
    print(f"compiled in {time.perf_counter() - start:.1f} s", file=sys.stderr)
    return own


def measure_truth(args):
    """The truth at points, by very many paths."""
    own = meter(args)
    start = time.perf_counter()
    mean, noise = own.irradiance(args.paths, args.seed)
    seconds = time.perf_counter() - start
    with open(args.output, "w") as file:
        file.write("E,sd\n" + "".join(f"{e!r},{s!r}\n" for e, s in zip(mean.tolist(), noise.tolist())))
    whole = numpy.sqrt((noise**2).sum() / (mean**2).sum())
    print(f"{args.paths} paths a point in {seconds:.1f} s: {args.paths * own.count / seconds / 1e6:.2f} M paths/s, "
          f"L2 noise {100 * whole:.3f} %, {whole * args.paths**0.5:.2f} a path", file=sys.stderr)


def run_mitsuba(args):
    """Error and time for each number of paths, of several runs the mean square and the median."""
    own, right = meter(args, not args.meter), truth(args.truth)
    program = "Mitsuba 3, irradiance meter" if args.meter else "Mitsuba 3"
    for paths in args.paths:
        seconds, squares = [], []
        for run in range(args.runs):
            start = time.perf_counter()
            found, _ = own.irradiance(paths, 1 + run)
            seconds.append(time.perf_counter() - start)
            squares.append(error(found, right) ** 2)
        row(args, program, f"{paths} paths", statistics.median(seconds), statistics.fmean(squares) ** 0.5)


def run_radiosity(args):
    """Error and time of `probe` for each wanted accuracy, 0 for none."""
    right = truth(args.truth)
    for accuracy in args.accuracy:
        seconds = []
        with tempfile.TemporaryDirectory() as folder:
            table = pathlib.Path(folder) / "table.csv"
            command = [args.command, "probe", args.scene, "--points", args.points, "-q", "-o", str(table)]
            command += ["--threads", str(args.threads)]
            command += ["--accuracy", accuracy] if float(accuracy) > 0 else []
            for _ in range(args.runs):
                start = time.perf_counter()
                done = subprocess.run(command, check=False)
                seconds.append(time.perf_counter() - start)
                if done.returncode not in (0, 3):
                    sys.exit(f"{' '.join(command)} ended with {done.returncode}")
            [own] = numbers(table, ["E_"])
            name = f"accuracy {accuracy}" if float(accuracy) > 0 else "default"
            name += " missed" if done.returncode == 3 else ""
            row(args, args.name, name, statistics.median(seconds), error(own, right))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parts = parser.add_subparsers(required=True)

    def part(name, run, described):
        own = parts.add_parser(name, help=described)
        own.set_defaults(run=run)
        own.add_argument("scene")
        own.add_argument("points")
        own.add_argument("--threads", type=int, default=2)
        own.add_argument("-o", "--output", required=True)
        return own

    own = part("truth", measure_truth, "writes E and its standard error at the points")
    own.add_argument("--paths", type=int, default=2**20)
    own.add_argument("--seed", type=int, default=777)
    own = part("mitsuba", run_mitsuba, "adds rows of Mitsuba to a table")
    own.add_argument("--truth", required=True)
    own.add_argument("--paths", type=integers, default=[4**k for k in range(3, 9)])
    own.add_argument("--meter", action="store_true", help="cosine rays alone, without emitter sampling at the points")
    own.add_argument("--runs", type=int, default=3)
    own = part("radiosity", run_radiosity, "adds rows of this program to a table")
    own.add_argument("--truth", required=True)
    own.add_argument("--command", default="target/release/radiosity")
    own.add_argument("--name", default="radiosity")
    own.add_argument("--accuracy", type=lambda text: text.split(","), default=["0", "3e-2", "1e-2", "5e-3"])
    own.add_argument("--runs", type=int, default=1)
    return parser.parse_args()


if __name__ == "__main__":
    chosen = arguments()
    chosen.run(chosen)
