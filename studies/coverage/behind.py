"""Errors that view factors tell beside their true ones, in random scenes where a second thing stands beside something round. See README.md.

    python behind.py scan -n 200 [--seed 1] [--command radiosity] [--eps 1e-3] [--fine 1e-4] [--rays 20] [--kinds can,disk] [--second tile,ball] [-o FOLDER]
    python behind.py show 17 [--seed 1]

Scene N of a seed is always the same. It has a can, a cone, a stump, a funnel or a disk, a second thing above, below, beside, before or
through it, and a floor with a wall, or a room. Its factors at `--eps` have to be those at `--fine` and those by 2^RAYS rays of this script
from one polygon, to three times what both tell and three standard deviations. In rooms without backs rows have to sum to 1.

Needs numpy and scipy.
"""

import argparse
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

import numpy as np
from scipy.stats import qmc

ROUND = ["can", "open can", "cone", "stump", "funnel", "disk", "small disk"]
SECOND = ["tile", "box", "can", "disk", "ball", "cone", "nothing"]
PLACES = ["above", "below", "beside", "before", "through"]
SIZE = [2.0, 2.5, 2.0]
SEQUENCES = 8


def unit(x):
    return np.asarray(x, float) / np.linalg.norm(x)


def across(axis):
    """Two unit vectors that complete one."""
    first = unit(np.cross(axis, [1, 0, 0] if abs(axis[0]) < 0.7 else [0, 1, 0]))
    return first, np.cross(axis, first)


# Surfaces as the scene format has them: a name, a shape, and whether they have two sides.

def plate(name, origin, edge1, edge2, two_sided=False):
    return {"name": name, "parallelogram": {"origin": origin, "edge1": edge1, "edge2": edge2}, "two_sided": two_sided}


def disk(name, center, normal, radius, two_sided=False):
    return {"name": name, "disk": {"center": center, "normal": normal, "radius": radius}, "two_sided": two_sided}


def cone(name, base, axis, radius1, radius2):
    if radius1 == radius2:
        return {"name": name, "cylinder": {"base": base, "axis": axis, "radius": radius1}}
    return {"name": name, "cone": {"base": base, "axis": axis, "radius1": radius1, "radius2": radius2}}


def box(name, origin, axes, inward=False):
    a, b, c = [np.asarray(x, float) for x in axes]
    o = np.asarray(origin, float)
    faces = [("left", o, c, b), ("right", o + a, b, c), ("front", o, a, c), ("back", o + b, c, a), ("bottom", o, b, a), ("top", o + c, a, b)]
    turned = [(part, p, v, u) if inward else (part, p, u, v) for part, p, u, v in faces]
    return [plate(f"{name}-{part}", p, u, v) for part, p, u, v in turned]


def body(name, kind, base, axis, radius, shape):
    """A can, a cone or a disk from a base on along an axis, and whether no backs are seen of it."""
    base, axis = np.asarray(base, float), np.asarray(axis, float)
    top, along = base + axis, unit(axis)
    if "disk" in kind:
        return [disk(name, base, along, radius, two_sided=True)], True
    if "can" in kind:
        lids = [disk(name + "-top", top, along, radius), disk(name + "-base", base, -along, radius)]
        return [cone(name, base, axis, radius, radius), *lids[: 1 if kind == "open can" else 2]], kind == "can"
    if kind == "cone":
        return [cone(name, base, axis, radius, 0.0), disk(name + "-base", base, -along, radius)], True
    if kind == "funnel":
        return [cone(name, base, axis, 0.0, radius), disk(name + "-top", top, along, radius)], True
    small = shape * radius
    lids = [disk(name + "-top", top, along, small), disk(name + "-base", base, -along, radius)]
    return [cone(name, base, axis, radius, small), *lids], True


def scene(number, seed, kinds, seconds):
    """The title and the surfaces of a scene, and whether rows sum to 1."""
    draw = random.Random(f"{seed}/{number}")
    kind, second, place = draw.choice(kinds), draw.choice(seconds), draw.choice(PLACES)
    is_upright = draw.random() < 0.5
    radius = 10 ** draw.uniform(-1.6, -1.1) if kind == "small disk" else draw.uniform(0.1, 0.35)
    direction = np.array([0.0, 0, 1]) if is_upright else unit([draw.gauss(0, 1) for _ in range(3)])
    height = draw.uniform(0.1, 0.5)
    base = np.array([draw.uniform(0.7, 1.3), draw.uniform(0.8, 1.7), 0.75]) - (0 if is_upright else 0.5 * height) * direction
    if kind == "open can" and is_upright and draw.random() < 0.6:
        base[2] = 0.0
    surfaces, is_closed = body("round", kind, base, height * direction, radius, draw.uniform(0.2, 0.9))
    length = 0.0 if "disk" in kind else height
    one, other = across(direction)
    turn = draw.uniform(0, math.tau)
    side = math.cos(turn) * one + math.sin(turn) * other
    gap, size = draw.choice([1e-3, draw.uniform(0.01, 0.3)]), draw.uniform(0.3, 1.5) * max(radius, 0.06)
    middle = base + 0.5 * length * direction
    slip = draw.uniform(0, 1) * radius * side
    if place == "through" and second in ("disk", "tile", "can", "cone") or place in ("beside", "before"):
        way = side if place != "through" else unit([draw.gauss(0, 1) for _ in range(3)])
        reach = {"beside": radius + gap + size, "before": radius + 0.3, "through": 0.3 * radius}[place]
        at, facing = middle + reach * way, unit(way + 0.3 * np.array([draw.gauss(0, 1) for _ in range(3)]))
    elif place == "through":
        at, facing = middle + slip, direction
    else:
        sign = 1 if place == "above" else -1
        at, facing = base + (length + gap if sign > 0 else -gap) * direction + slip, sign * direction
    extra = []
    if second == "tile":
        u, v = across(facing)
        turned = math.cos(turn) * u + math.sin(turn) * v, math.cos(turn) * v - math.sin(turn) * u
        edges = [2 * size * x for x in turned]
        extra = [plate("second", at - size * (turned[0] + turned[1]), *edges, two_sided=True)]
    elif second == "ball":
        extra = [{"name": "second", "sphere": {"center": at + size * facing, "radius": size}}]
    elif second == "box":
        u, v = across(facing)
        extra = box("second", at - 0.5 * size * (u + v), [size * u, size * v, draw.uniform(0.3, 1) * size * facing])
    elif second != "nothing":
        extra, closed = body("second", second, at, draw.uniform(0.3, 1) * size * facing, size, 0.5)
        is_closed &= closed
    is_within = not extra or all(2.2 * size <= at[k] <= SIZE[k] - 2.2 * size for k in range(3))
    is_room = draw.random() < 0.6
    room = box("room", [0, 0, 0], np.diag(SIZE), inward=True)
    borders = room if is_room else [room[4], room[draw.randrange(4)]]
    title = f"{number}: {kind}, {second} {place}, {'upright' if is_upright else 'leaning'}, {'room' if is_room else 'floor and wall'}"
    return title, borders + surfaces + extra, is_room and is_closed and (place != "through" or not extra) and is_within


def text(surfaces):
    def plain(x):
        return [float(y) for y in x] if isinstance(x, (list, np.ndarray)) else float(x)

    def of(own):
        return {key: {k: plain(x) for k, x in value.items()} if isinstance(value, dict) else value for key, value in own.items()}

    return json.dumps({"surfaces": [of(own) for own in surfaces]}, indent=1)


# Rays.

def hits(own, origin, way):
    """The distances at which rays meet a surface, and the normals of its front there, one each way in which they may."""
    with np.errstate(all="ignore"):
        if "parallelogram" in own:
            o, a, b = [np.asarray(own["parallelogram"][key], float) for key in ("origin", "edge1", "edge2")]
            normal = unit(np.cross(a, b))
            t = (o - origin) @ normal / (way @ normal)
            p = origin + t[:, None] * way - o
            inverse = np.linalg.pinv(np.stack([a, b]).T)
            u, v = p @ inverse[0], p @ inverse[1]
            return [(np.where((u >= 0) & (u <= 1) & (v >= 0) & (v <= 1), t, np.inf), way @ normal)]
        if "disk" in own:
            shape = own["disk"]
            c, normal = np.asarray(shape["center"], float), unit(shape["normal"])
            t = (c - origin) @ normal / (way @ normal)
            p = origin + t[:, None] * way - c
            return [(np.where((p * p).sum(1) <= shape["radius"] ** 2, t, np.inf), way @ normal)]
        if "sphere" in own:
            shape = own["sphere"]
            p = origin - np.asarray(shape["center"], float)
            half, rest = (p * way).sum(1), (p * p).sum(1) - shape["radius"] ** 2
            root = np.sqrt(half * half - rest)
            return [(np.nan_to_num(t, nan=np.inf), ((p + t[:, None] * way) * way).sum(1)) for t in (-half - root, -half + root)]
        shape = own.get("cylinder") or own["cone"]
        base, axis = np.asarray(shape["base"], float), np.asarray(shape["axis"], float)
        first, last = (shape["radius"],) * 2 if "cylinder" in own else (shape["radius1"], shape["radius2"])
        length = np.linalg.norm(axis)
        along, slope = axis / length, (last - first) / length
        p = origin - base
        z, dz = p @ along, way @ along
        q, dq = p - z[:, None] * along, way - dz[:, None] * along
        r, dr = first + slope * z, slope * dz
        square, half, rest = (dq * dq).sum(1) - dr * dr, (q * dq).sum(1) - r * dr, (q * q).sum(1) - r * r
        root = np.sqrt(half * half - square * rest)
        found = []
        for t in ((-half - root) / square, (-half + root) / square):
            h = z + t * dz
            outward = q + t[:, None] * dq - slope * (first + slope * h)[:, None] * along
            is_met = (h >= 0) & (h <= length) & (first + slope * h >= 0)
            found.append((np.where(is_met, np.nan_to_num(t, nan=np.inf), np.inf), (outward * way).sum(1)))
        return found


def by_rays(surfaces, names, row, power):
    """The factors from one polygon or disk, and their standard deviations."""
    name, _, back = names[row].partition(":")
    own = next(own for own in surfaces if own["name"] == name)
    parts = []
    for sequence in range(SEQUENCES):
        x = qmc.Sobol(4, seed=1000 * row + sequence).random_base2(power - 3)
        if "parallelogram" in own:
            o, a, b = [np.asarray(own["parallelogram"][key], float) for key in ("origin", "edge1", "edge2")]
            origin, normal = o + x[:, :1] * a + x[:, 1:2] * b, unit(np.cross(a, b))
        else:
            shape = own["disk"]
            normal = unit(shape["normal"])
            u, v = across(normal)
            r, turn = shape["radius"] * np.sqrt(x[:, :1]), math.tau * x[:, 1:2]
            origin = np.asarray(shape["center"], float) + r * (np.cos(turn) * u + np.sin(turn) * v)
        normal = -normal if back else normal
        u, v = across(normal)
        r, turn = np.sqrt(x[:, 2:3]), math.tau * x[:, 3:4]
        way = r * (np.cos(turn) * u + np.sin(turn) * v) + np.sqrt(1 - r * r) * normal
        nearest, met = np.full(len(x), np.inf), np.full(len(x), -1)
        for other in surfaces:
            sides = [names.index(other["name"]), names.index(other["name"] + ":back") if other.get("two_sided") else -1]
            for t, facing in hits(other, origin, way):
                is_nearer = (t > 1e-9) & (t < nearest)
                nearest[is_nearer] = t[is_nearer]
                met[is_nearer] = np.where(facing[is_nearer] < 0, sides[0], sides[1])
        parts.append(np.bincount(met[met >= 0], minlength=len(names)) / len(x))
    parts = np.array(parts)
    # A standard deviation of so few sequences may be small by chance; rays that are met once tell no more.
    noise = np.maximum(1.5 * parts.std(0, ddof=1) / math.sqrt(SEQUENCES), 2.0 / 2**power)
    return parts.mean(0), noise


def factors(command, path, eps):
    options = ["--format", "json", "--transport", "exact", "--eps", str(eps), "--shadow-eps", str(eps)]
    run = subprocess.run([command, "view-factors", str(path), *options], capture_output=True, text=True, check=False)
    if "remove one of the two" in run.stderr:
        return None
    if run.returncode != 0:
        raise SystemExit(f"{path}: {run.stderr}")
    found = json.loads(run.stdout)
    return found["surfaces"], np.array(found["factors"]), np.array(found["errors"]), found


def worst(found, told, right, noise, names, row=None):
    """The largest difference over what is told with the noise, and where."""
    ratio = np.abs(found - right) / (3 * told + noise + 1e-12)
    j = np.unravel_index(ratio.argmax(), ratio.shape)
    pair = (row, j[0]) if row is not None else j
    return ratio[j], f"{names[pair[0]]} to {names[pair[1]]}: {found[j]:.3e} for {right[j]:.3e}"


def scan(options):
    folder = pathlib.Path(options.output or tempfile.mkdtemp())
    folder.mkdir(exist_ok=True, parents=True)
    bad = looked = 0
    for number in range(options.first, options.first + options.n):
        title, surfaces, is_whole = scene(number, options.seed, options.kinds.split(","), options.second.split(","))
        path = folder / f"{number}.json"
        path.write_text(text(surfaces))
        found = factors(options.command, path, options.eps)
        if found is None:
            continue
        names, rough, told, report = found
        draw, complaints = random.Random(number), []
        polygons = [k for k, name in enumerate(names) if name.startswith("room")]
        polygons += [k for k, name in enumerate(names) if name.startswith("second") and "round" not in name]
        flat = [k for k in polygons if any({"parallelogram", "disk"} & set(own) for own in surfaces if own["name"] == names[k].partition(":")[0])]
        results = {}
        if options.rays:
            row = draw.choice(flat)
            right, noise = by_rays(surfaces, names, row, options.rays)
            results["rays"] = worst(rough[row], told[row], right, 3 * noise, names, row)
        if options.fine and (number % options.each == 0):
            _, fine, fine_told, _ = factors(options.command, path, options.fine)
            results["fine"] = worst(rough, told[:, None], fine, 3 * fine_told[:, None], names)
        if is_whole:
            off = np.abs(rough.sum(1) - 1)
            k = int((off / (3 * told + 1e-12)).argmax())
            results["sums"] = (off[k] / (3 * told[k] * math.sqrt(len(names)) + 1e-12), f"{names[k]}: {rough[k].sum():.6f}, told {told[k]:.1e}")
        complaints = [f"{which} {ratio:.2f} {where}" for which, (ratio, where) in results.items() if ratio > 1]
        bad += bool(complaints)
        looked += 1
        ratios = " ".join(f"{which} {ratio:.2f}" for which, (ratio, _) in results.items())
        print(f"{title}: {ratios}, {report['seconds']:.2f} s" + "".join(f"\n  BAD {own}" for own in complaints), flush=True)
    print(f"{bad} bad of {looked}")
    return bad


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    verbs = parser.add_subparsers(dest="verb", required=True)
    for verb in ("scan", "show"):
        own = verbs.add_parser(verb)
        own.add_argument("--seed", type=int, default=1)
        own.add_argument("--kinds", default=",".join(ROUND))
        own.add_argument("--second", default=",".join(SECOND))
        if verb == "show":
            own.add_argument("number", type=int)
            continue
        own.add_argument("-n", type=int, default=200)
        own.add_argument("--first", type=int, default=0)
        own.add_argument("--command", default="radiosity")
        own.add_argument("--eps", type=float, default=1e-3)
        own.add_argument("--fine", type=float)
        own.add_argument("--each", type=int, default=1)
        own.add_argument("--rays", type=int, default=20)
        own.add_argument("-o", "--output")
    options = parser.parse_args()
    if options.verb == "show":
        print(text(scene(options.number, options.seed, options.kinds.split(","), options.second.split(","))[1]))
        return 0
    return 1 if scan(options) else 0


if __name__ == "__main__":
    sys.exit(main())
