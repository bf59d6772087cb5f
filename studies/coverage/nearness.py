"""Errors told beside true ones where things are near to each other. See README.md.

    python nearness.py pairs -n 200 [--seed 1] [--command radiosity] [--eps 1e-3,1e-6] [--fine 1e-9] [-o pairs.csv]
    python nearness.py heat -n 100 [--seed 1] [--kinds box] [--power 17] [--longest 60] [--command radiosity] [-o heat.csv]
    python nearness.py sweeps [--command radiosity] [--eps 1e-6]
    python nearness.py show pairs 17 [--seed 1]

`pairs`: two surfaces, one of them curved at least, at a gap of 1e-3 to 1 of their size. Factors at `--eps` stand beside those at `--fine`; cases
whose fine run takes longer than a minute, as those that go to rays, are left out and counted.
`heat`: closed rooms with one or two boxes, cans and balls at gaps of 1e-4 to 0.1 from walls and from each other, beside paths of `paths.py`.
`sweeps`: plates, balls over a disk, tubes in tubes and boxes in recesses, at gaps of 1 to 1e-12, beside closed forms.

Case N of a seed is always the same. Needs numpy and scipy.
"""

import argparse
import csv
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.spatial import cKDTree

import paths
from behind import across, body, box, cone, disk, plate, unit

CURVED = ["ball", "cylinder", "cone", "tube"]
FLAT = ["disk", "rectangle"]
BODIES = ["box", "can", "ball"]
# A true error is seen where it is this many times what the finer run tells, or the noise of paths.
SEEN = 5.0
# Told over true has to lie between these for 95 % of what is seen.
RANGE = [0.5, 3.0]
# Longest run (s).
LONGEST = 60.0


# Surfaces.

def shape(draw, kind, name):
    """A surface about the origin, and points on it."""
    axis, size = unit([draw.gauss(0, 1) for _ in range(3)]), 10 ** draw.uniform(-0.7, 0)
    one, other = across(axis)
    u, v = np.meshgrid(np.linspace(0, math.tau, 181), np.linspace(0, 1, 91))
    ring = np.cos(u)[..., None] * one + np.sin(u)[..., None] * other
    if kind == "ball":
        at = np.sin(math.pi * v)[..., None] * ring + np.cos(math.pi * v)[..., None] * axis
        return {"name": name, "sphere": {"center": [0, 0, 0], "radius": 0.5 * size}}, (0.5 * size * at).reshape(-1, 3)
    if kind == "rectangle":
        a, b = size * one, size * draw.uniform(0.3, 2) * other
        at = (np.linspace(0, 1, 91)[:, None, None] * a + np.linspace(0, 1, 91)[None, :, None] * b) - 0.5 * (a + b)
        return plate(name, -0.5 * (a + b), a, b), at.reshape(-1, 3)
    if kind == "disk":
        return disk(name, np.zeros(3), axis, 0.5 * size), (0.5 * size * v[..., None] * ring).reshape(-1, 3)
    radius, length = 0.5 * size, size * 10 ** draw.uniform(-0.4, 0.4)
    end = {"cylinder": radius, "tube": radius, "cone": 0.0}[kind]
    made = cone(name, -0.5 * length * axis, length * axis, radius, end)
    made["flip"] = kind == "tube"
    at = (v - 0.5)[..., None] * length * axis + ((1 - v) * radius + v * end)[..., None] * ring
    return made, at.reshape(-1, 3)


def moved(made, way):
    """The surface at another place."""
    made = json.loads(json.dumps(made, default=list))
    for kind, keys in made.items():
        if isinstance(keys, dict):
            for key in ("center", "base", "origin"):
                if key in keys:
                    keys[key] = [float(x) for x in np.asarray(keys[key]) + way]
    return made


def pair(number, seed):
    """The title and the surfaces of two at a gap, one of them curved at least."""
    draw = random.Random(f"pairs/{seed}/{number}")
    kinds = [draw.choice(CURVED), draw.choice(CURVED + FLAT)]
    made = [shape(draw, kind, f"{kind}-{k}") for k, kind in enumerate(kinds)]
    way, gap = unit([draw.gauss(0, 1) for _ in range(3)]), 10 ** draw.uniform(-3, 0)
    # The second comes from far along a way until it is as near as the gap.
    tree, near, far = cKDTree(made[0][1]), 0.0, 8.0
    for _ in range(40):
        middle = 0.5 * (near + far)
        is_clear = tree.query(made[1][1] + middle * way)[0].min() > gap
        near, far = (near, middle) if is_clear and all_clear(tree, made[1][1], way, middle, far, gap) else (middle, far)
    title = f"{kinds[0]} and {kinds[1]}, gap {gap:.1e}"
    return title, [made[0][0], moved(made[1][0], far * way)]


def all_clear(tree, points, way, low, high, gap):
    """Whether the second is clear of the first on a part of its way."""
    return all(tree.query(points + step * way)[0].min() > gap for step in np.linspace(low, high, 12))


def enclosure(number, seed, kinds=BODIES):
    """The title, the surfaces and the materials of a closed room with bodies at narrow gaps."""
    draw = random.Random(f"heat/{seed}/{number}")
    size = np.array([draw.uniform(0.8, 1.6) for _ in range(3)])
    surfaces = box("wall", [0, 0, 0], np.diag(size), inward=True)
    titles, cursor = [], 0.0
    for k in range(draw.randint(1, 2)):
        kind, gap = draw.choice(kinds), 10 ** draw.uniform(-4, -1)
        wide = draw.uniform(0.15, 0.35) * size[0]
        # One after the other along x, the gap between them, and over the floor.
        low = np.array([cursor + gap, draw.uniform(0.1, 0.3) * size[1], gap * draw.choice([1.0, 3.0])])
        if kind == "box":
            edges = np.diag([wide, draw.uniform(0.2, 0.5) * size[1], draw.uniform(0.1, 0.6) * size[2]])
            surfaces += box(f"box{k}", low, edges)
        elif kind == "ball":
            surfaces.append({"name": f"ball{k}", "sphere": {"center": list(low + 0.5 * wide), "radius": 0.5 * wide}})
        else:
            base = low + [0.5 * wide, 0.5 * wide, 0]
            surfaces += body(f"can{k}", "can", base, [0, 0, draw.uniform(0.1, 0.6) * size[2]], 0.5 * wide, 1.0)[0]
        titles.append(f"{kind} at {gap:.0e}")
        cursor = low[0] + wide
    bodies = {}
    for surface in surfaces:
        name = surface["name"].split("-")[0] if "wall" not in surface["name"] else surface["name"]
        bodies.setdefault(name, []).append(surface)
    materials = {}
    for name, parts in bodies.items():
        material = {"emissivity": round(draw.uniform(0.1, 0.9), 3)}
        is_floating = draw.random() < 0.25 and name != "wall-left"
        for part in parts:
            part["material"] = name
            part.update({"adiabatic": True} if is_floating else {"temperature": 300})
        if not is_floating:
            temperature = round(draw.uniform(250, 600))
            for part in parts:
                part["temperature"] = temperature
        materials[name] = material
    return ", ".join(titles), surfaces, materials


# Runs.

def written(folder, surfaces, materials=None):
    file = pathlib.Path(folder) / "scene.json"
    file.write_text(json.dumps({"surfaces": surfaces, "materials": materials or {}}, default=lambda x: np.asarray(x).tolist()))
    return file


def run(command, verb, file, *options, longest=LONGEST):
    words = [command, verb, file, "--format", "json", "--threads", "1", *options]
    done = subprocess.run(words, capture_output=True, text=True, timeout=longest)
    if done.returncode not in (0, 3):
        raise RuntimeError(f"{verb} {' '.join(options)}: {done.stderr.strip().splitlines()[-1]}")
    return json.loads(done.stdout)


def rows_of_cases(typed, of_case):
    """The rows of all cases; says which took too long."""
    for number in range(typed.start, typed.start + typed.n):
        try:
            yield from list(of_case(typed, number))
        except subprocess.TimeoutExpired as late:
            print(f"{number:4} left out: longer than {late.timeout:.0f} s", flush=True)


def rows_of_pair(typed, number):
    title, surfaces = pair(number, typed.seed)
    with tempfile.TemporaryDirectory() as folder:
        file = written(folder, surfaces)
        fine = run(typed.command, "view-factors", file, "--eps", typed.fine)
        for eps in typed.eps.split(","):
            found = run(typed.command, "view-factors", file, "--eps", eps)
            for i in range(2):
                largest = max(fine["factors"][i])
                if largest == 0:
                    continue
                off = max(abs(a - b) for a, b in zip(found["factors"][i], fine["factors"][i]))
                yield {
                    "case": number, "title": title, "what": f"row {i}", "eps": eps, "off": off / largest,
                    "told": found["errors"][i] / largest, "fine": fine["errors"][i] / largest, "seconds": found["seconds"],
                }


def rows_of_room(typed, number):
    title, surfaces, materials = enclosure(number, typed.seed, typed.kinds.split(","))
    with tempfile.TemporaryDirectory() as folder:
        begun = time.monotonic()
        found = run(typed.command, "heat", written(folder, surfaces, materials), longest=typed.longest)
        seconds = round(time.monotonic() - begun, 1)
    right = paths.balance(surfaces, materials, typed.power)
    largest = max(abs(value) for key, value, _ in right if key == "flow")
    for own, (key, value, noise) in zip(found["surfaces"], right):
        unit_ = value if key == "temperature" else largest
        yield {
            "case": number, "title": title, "what": f"{own['name']} {key}", "eps": "", "off": abs(own[key] - value) / unit_,
            "told": own[f"{key}_error"] / unit_, "fine": noise / unit_, "seconds": seconds,
        }


# Closed forms of sweeps.

def plates(gap):
    """Two squares of side 1 at a gap, and their factor."""
    lower = plate("lower", [0, 0, 0], [1, 0, 0], [0, 1, 0])
    upper = plate("upper", [0, 0, gap], [0, 1, 0], [1, 0, 0])
    x = 1 / gap
    # Howell C-11 for squares. Below 1e-2 its terms cancel: there the loss is that of a strip along four sides.
    s = 1 + x * x
    terms = 0.5 * math.log(s * s / (1 + 2 * x * x)) + 2 * x * math.sqrt(s) * math.atan(x / math.sqrt(s)) - 2 * x * math.atan(x)
    right = 2 / (math.pi * x * x) * terms
    if gap < 1e-4:
        right = 1 - 2 * gap + gap * gap * (2 / math.pi) * (math.log(1 / gap) - 0.5 * math.log(2) + math.pi / 4 + 1.5)
    return [lower, upper], 0, 1, right


def ball(gap):
    """A unit ball over a disk of radius 2, seen by the ball."""
    surfaces = [{"name": "ball", "sphere": {"center": [0, 0, 1 + gap], "radius": 1}}, disk("floor", [0, 0, 0], [0, 0, 1], 2)]
    return surfaces, 0, 1, 0.5 * (1 - 1 / math.hypot(1, 2 / (1 + gap)))


def tubes(gap):
    """A cylinder in a closed can of length 2, at a gap to the wall about it and at both ends none: what it sees of all is 1."""
    wall = cone("wall", [0, 0, 0], [0, 0, 2], 1 + gap, 1 + gap) | {"flip": True}
    rings = [disk("low", [0, 0, 0], [0, 0, 1], 1 + gap), disk("high", [0, 0, 2], [0, 0, -1], 1 + gap)]
    for ring in rings:
        ring["disk"]["inner_radius"] = 1.0
    return [cone("core", [0, 0, 0], [0, 0, 2], 1, 1), wall, *rings], 0, None, 1.0


def eccentric(gap):
    """A cylinder out of the middle of a closed can, nearest to its wall at a gap: what it sees of all is 1."""
    wall = cone("wall", [0, 0, 0], [0, 0, 2], 2, 2) | {"flip": True}
    core = cone("core", [1 - gap, 0, 0.5], [0, 0, 1], 1, 1)
    lids = [disk("core-low", [1 - gap, 0, 0.5], [0, 0, -1], 1), disk("core-high", [1 - gap, 0, 1.5], [0, 0, 1], 1)]
    ends = [disk("low", [0, 0, 0], [0, 0, 1], 2), disk("high", [0, 0, 2], [0, 0, -1], 2)]
    return [core, wall, *lids, *ends], 0, None, 1.0


def recess(gap):
    """A box in a recess, at a gap on all sides: what its bottom sees of all is 1."""
    walls = box("recess", [0, 0, 0], np.diag([1, 1, 1]), inward=True)
    thing = box("box", [gap, gap, gap], np.diag([1 - 2 * gap, 1 - 2 * gap, 0.5]))
    return [*thing, *walls], 4, None, 1.0


SWEEPS = {"plates": plates, "ball over a disk": ball, "tube in a tube": tubes, "tube out of the middle": eccentric, "box in a recess": recess}


def sweeps(typed):
    gaps = [g for k in range(12, -1, -1) for g in (10.0 ** -k, 3 * 10.0 ** -k) if g < 1]
    print(f"{'sweep':24} {'gap':>8} {'off':>9} {'told':>9} {'off/told':>9} {'s':>6}")
    for name, make in SWEEPS.items():
        for gap in gaps:
            if name == "box in a recess" and gap >= 0.3 or name == "tube out of the middle" and gap >= 1:
                continue
            surfaces, i, j, right = make(gap)
            with tempfile.TemporaryDirectory() as folder:
                try:
                    found = run(typed.command, "view-factors", written(folder, surfaces), "--eps", typed.eps)
                except RuntimeError as error:
                    print(f"{name:24} {gap:8.0e} {error}")
                    continue
            value = found["factors"][i][j] if j is not None else sum(found["factors"][i])
            off, told = abs(value - right), found["errors"][i]
            mark = " beyond" if off > 3 * told + 1e-14 else ""
            print(f"{name:24} {gap:8.0e} {off:9.1e} {told:9.1e} {off / told:9.2f} {found['seconds']:6.2f}{mark}", flush=True)


# Tables.

def scan(typed, rows):
    kept = []
    with open(typed.output, "w", newline="") if typed.output else open("/dev/null", "w") as file:
        writer = None
        for row in rows:
            kept.append(row)
            writer = writer or csv.DictWriter(file, row.keys())
            if len(kept) == 1:
                writer.writeheader()
            writer.writerow(row)
            if row["off"] > 3 * row["told"] and row["off"] > SEEN * row["fine"]:
                print(f"{row['case']:4} {row['title']}, {row['what']} {row['eps']}: off {row['off']:.1e}, told {row['told']:.1e}", flush=True)
    for eps in sorted({row["eps"] for row in kept}, reverse=True):
        own = [row for row in kept if row["eps"] == eps]
        seen = [row for row in own if row["off"] > SEEN * row["fine"]]
        ratio = np.array([row["told"] / row["off"] for row in seen])
        if len(ratio) == 0:
            print(f"{eps}: {len(own)} figures, no error seen")
            continue
        within = np.mean((ratio >= RANGE[0]) & (ratio <= RANGE[1]))
        print(
            f"{eps or 'all'}: {len(own)} figures, {len(seen)} errors seen; told over true: 5 % {np.quantile(ratio, .05):.2g}, median "
            f"{np.median(ratio):.2g}, 95 % {np.quantile(ratio, .95):.2g}; {within:.0%} within {RANGE[0]} to {RANGE[1]:.0f}, "
            f"{np.mean(ratio < 1 / 3):.1%} beyond three times what is told, at the most {1 / ratio.min():.1f} times; largest error "
            f"{max(row['off'] for row in own):.1e}"
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    for name in ("pairs", "heat", "sweeps"):
        own = verbs.add_parser(name)
        own.add_argument("--command", default="radiosity")
        if name != "sweeps":
            own.add_argument("-n", type=int, default=100)
            own.add_argument("--start", type=int, default=0)
            own.add_argument("--seed", type=int, default=1)
            own.add_argument("-o", "--output")
        if name == "heat":
            own.add_argument("--kinds", default=",".join(BODIES))
            own.add_argument("--power", type=int, default=17)
            own.add_argument("--longest", type=float, default=LONGEST)
        else:
            own.add_argument("--eps", default="1e-3,1e-6" if name == "pairs" else "1e-6")
        if name == "pairs":
            own.add_argument("--fine", default="1e-9")
    own = verbs.add_parser("show")
    own.add_argument("of", choices=["pairs", "heat"])
    own.add_argument("number", type=int)
    own.add_argument("--seed", type=int, default=1)
    typed = parser.parse_args()
    if typed.verb == "show":
        made = pair(typed.number, typed.seed) if typed.of == "pairs" else enclosure(typed.number, typed.seed)
        print(json.dumps({"title": made[0], "surfaces": made[1], "materials": made[2] if len(made) > 2 else {}}, indent=1, default=lambda x: np.asarray(x).tolist()))
    elif typed.verb == "sweeps":
        sweeps(typed)
    else:
        scan(typed, rows_of_cases(typed, rows_of_pair if typed.verb == "pairs" else rows_of_room))
    return 0


if __name__ == "__main__":
    sys.exit(main())
