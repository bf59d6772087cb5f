"""Net radiant flows of a closed room by paths: what a surface receives is what paths from it meet,

    q = ε σ (T⁴ − Σ_k w_k ε_k T_k⁴) ,     w_k = Π_{l<k} (1 − ε_l) ,

over the hits k of a path whose ways follow the cosine law. What is adiabatic sends back all that it receives, point by point: ε = 0.
Paths between two parallel things that are both adiabatic go on by leaps of `gaps.py`; those of more than `MOST` hits end, and add the half of
what they could yet bring to the noise. Paths of all surfaces advance together. Needs numpy and scipy.
"""

import math

import numpy as np
from scipy.stats import qmc

from behind import across, hits, unit
from gaps import Gaps

SIGMA = 5.670374419e-8
# Sequences of starts, by whose means noise is told.
SEQUENCES = 8
# Weight below which a path goes on by chance.
SMALL = 0.05
# Least way to a hit, over the size of rooms of about one.
NEAREST = 1e-9
# Hits of a path.
MOST = 5000
# Rays that are cut with surfaces at once.
AT_ONCE = 1 << 14


def frames(normal):
    """Two unit vectors across each normal (C. Duff and others, J. Comput. Graph. Tech. 6 (2017) 1-8)."""
    x, y, z = normal.T
    sign = np.where(z < 0, -1.0, 1.0)
    a = -1 / (sign + z)
    b = x * y * a
    return np.stack([1 + sign * x * x * a, sign * b, -sign * x], 1), np.stack([b, sign + y * y * a, -y], 1)


def scattered(normal, draws):
    """Ways by the cosine law about each normal."""
    one, other = frames(normal)
    r, turn = np.sqrt(draws[:, :1]), math.tau * draws[:, 1:2]
    return r * (np.cos(turn) * one + np.sin(turn) * other) + np.sqrt(1 - r * r) * normal


def normals(own, points):
    """The normals of a surface at points of it."""
    if "parallelogram" in own:
        normal = unit(np.cross(own["parallelogram"]["edge1"], own["parallelogram"]["edge2"]))
    elif "disk" in own:
        normal = unit(own["disk"]["normal"])
    elif "sphere" in own:
        away = points - np.asarray(own["sphere"]["center"], float)
        return away / np.linalg.norm(away, axis=1, keepdims=True)
    else:
        along = unit(own["cylinder"]["axis"])
        away = points - np.asarray(own["cylinder"]["base"], float)
        away = away - (away @ along)[:, None] * along
        return away / np.linalg.norm(away, axis=1, keepdims=True)
    return np.broadcast_to(normal, points.shape)


def starts(own, x):
    """Points spread evenly over a plate, a disk, a ball or the side of a can."""
    if "parallelogram" in own:
        o, a, b = [np.asarray(own["parallelogram"][key], float) for key in ("origin", "edge1", "edge2")]
        return o + x[:, :1] * a + x[:, 1:2] * b
    turn = math.tau * x[:, 1:2]
    if "disk" in own:
        u, v = across(unit(own["disk"]["normal"]))
        r = own["disk"]["radius"] * np.sqrt(x[:, :1])
        return np.asarray(own["disk"]["center"], float) + r * (np.cos(turn) * u + np.sin(turn) * v)
    if "sphere" in own:
        z = 2 * x[:, :1] - 1
        ring = np.sqrt(1 - z * z)
        at = np.concatenate([ring * np.cos(turn), ring * np.sin(turn), z], 1)
        return np.asarray(own["sphere"]["center"], float) + own["sphere"]["radius"] * at
    axis = np.asarray(own["cylinder"]["axis"], float)
    u, v = across(unit(axis))
    return np.asarray(own["cylinder"]["base"], float) + x[:, :1] * axis + own["cylinder"]["radius"] * (np.cos(turn) * u + np.sin(turn) * v)


def area(own):
    if "parallelogram" in own:
        return np.linalg.norm(np.cross(own["parallelogram"]["edge1"], own["parallelogram"]["edge2"]))
    if "disk" in own:
        return math.pi * own["disk"]["radius"] ** 2
    if "sphere" in own:
        return 4 * math.pi * own["sphere"]["radius"] ** 2
    return math.tau * own["cylinder"]["radius"] * np.linalg.norm(own["cylinder"]["axis"])


def first_hits(surfaces, points, ways):
    """The distance of the first front that each ray meets, and its surface; −1 for none."""
    nearest, met = np.full(len(points), np.inf), np.full(len(points), -1)
    for first in range(0, len(points), AT_ONCE):
        part = slice(first, first + AT_ONCE)
        own_nearest, own_met = nearest[part], met[part]
        for j, other in enumerate(surfaces):
            for t, facing in hits(other, points[part], ways[part]):
                is_nearer = (t > NEAREST) & (t < own_nearest) & (facing < 0)
                own_nearest[is_nearer], own_met[is_nearer] = t[is_nearer], j
    return nearest, met


def received(surfaces, emissivity, emitted, points, ways, draw):
    """What arrives along rays, one path each (W/m²), and the half of what paths that were ended could yet bring."""
    gaps = Gaps(surfaces, emissivity)
    total, rest = np.zeros(len(points)), np.zeros(len(points))
    weight, paths = np.ones(len(points)), np.arange(len(points))
    of_bodies = emitted[emissivity > 0]
    for _ in range(MOST):
        nearest, met = first_hits(surfaces, points, ways)
        is_met = met >= 0
        points, ways, nearest, met, paths, weight = (of[is_met] for of in (points, ways, nearest, met, paths, weight))
        points = points + nearest[:, None] * ways
        total[paths] += weight * emissivity[met] * emitted[met]
        weight = weight * (1 - emissivity[met])
        chance = np.minimum(weight / SMALL, 1)
        goes_on = draw.random(len(paths)) < chance
        weight = np.where(chance < 1, SMALL, weight)
        points, met, paths, weight = (of[goes_on] for of in (points, met, paths, weight))
        if not len(paths):
            break
        normal = np.empty((len(paths), 3))
        for j, other in enumerate(surfaces):
            own = met == j
            normal[own] = normals(other, points[own])
        ways = scattered(normal, draw.random((len(paths), 2)))
        gaps.leap(met, points, ways, draw)
    total[paths] += weight * 0.5 * (of_bodies.max() + of_bodies.min())
    rest[paths] = weight * 0.5 * (of_bodies.max() - of_bodies.min())
    return total, rest


def balance(surfaces, materials, power=18):
    """The flow (W) of each surface, the temperature (K) of what is adiabatic, and the standard deviation of either."""
    emissivity = np.array([0.0 if own.get("adiabatic") else materials[own["material"]]["emissivity"] for own in surfaces])
    emitted = SIGMA * np.array([own.get("temperature", 0.0) for own in surfaces]) ** 4
    points, ways = [], []
    for row, own in enumerate(surfaces):
        for sequence in range(SEQUENCES):
            x = qmc.Sobol(4, seed=1000 * row + sequence).random_base2(power - 3)
            points.append(starts(own, x))
            ways.append(scattered(normals(own, points[-1]), x[:, 2:4]))
    found = received(surfaces, emissivity, emitted, np.concatenate(points), np.concatenate(ways), np.random.default_rng(0))
    means, rests = (own.reshape(len(surfaces), SEQUENCES, -1).mean(2) for own in found)
    rows = []
    for row, own in enumerate(surfaces):
        mean, noise = means[row].mean(), means[row].std(ddof=1) / math.sqrt(SEQUENCES) + rests[row].mean()
        if own.get("adiabatic"):
            temperature = (mean / SIGMA) ** 0.25
            rows.append(("temperature", temperature, 0.25 * temperature * noise / mean))
        else:
            scale = area(own) * emissivity[row]
            rows.append(("flow", scale * (emitted[row] - mean), scale * noise))
    return rows
