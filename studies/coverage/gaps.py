"""Leaps of paths between two parallel things that send all back by the cosine law, over many hits at once.

Between planes at the distance 1 the place of a path walks by steps of any direction and of the length tan θ, sin² θ spread evenly over 0 to 1.
Walks are drawn once for each of the radii 4, 16, 64, …: where they were before the first step that ends beyond the radius, on which plane, and
that step. As no direction is preferred, a walk from any place takes one of these, turned at random, as long as the circle of the radius about it
lies within both things; its last step is a ray that is cut with the room as any other. Walks for a radius are made of those for smaller ones.
"""

import functools
import math

import numpy as np

from behind import unit

# Walks of each radius; radii are powers of 4.
WALKS = 1 << 15
RADII = 7
# Widest gap: bodies are wider, so that none is in a gap.
WIDEST = 0.1


@functools.cache
def walks():
    """For each radius the last places within it, whether these are on the other plane, and the steps from there."""
    draw = np.random.default_rng(1993)
    known = []
    for power in range(1, RADII + 1):
        at, is_over, step = np.zeros((WALKS, 2)), np.zeros(WALKS, bool), np.zeros((WALKS, 2))
        going = np.arange(WALKS)
        while len(going):
            place, over, way = stepped(known, 4.0**power - np.linalg.norm(at[going], axis=1), draw)
            at[going] += place
            is_over[going] ^= over
            step[going] = way
            is_in = np.linalg.norm(at[going] + way, axis=1) < 4.0**power
            going = going[is_in]
            at[going] += step[going]
            is_over[going] ^= True
        known.append((at, is_over, step))
    return known


def stepped(known, clear, draw):
    """The walks from places that are so far from a border by the largest radii that fit, or single steps: the last places within, whether on the
    other plane, and the steps from there."""
    place, over = np.zeros((len(clear), 2)), np.zeros(len(clear), bool)
    u, turn = draw.random(len(clear)), draw.random(len(clear)) * math.tau
    length = np.sqrt(u / (1 - u))
    step = np.stack([length * np.cos(turn), length * np.sin(turn)], 1)
    for power, (places, overs, steps) in enumerate(known, 1):
        own = np.flatnonzero((clear >= 4.0**power) & ((clear < 4.0 ** (power + 1)) | (power == len(known))))
        drawn = draw.integers(0, WALKS, len(own))
        place[own], over[own], step[own] = turned(places[drawn], turn[own]), overs[drawn], turned(steps[drawn], turn[own])
    return place, over, step


def turned(vectors, turn):
    cosine, sine = np.cos(turn), np.sin(turn)
    x, y = vectors.T
    return np.stack([cosine * x - sine * y, sine * x + cosine * y], 1)


class Flat:
    """A plate or a disk."""

    def __init__(self, own):
        if "disk" in own:
            shape = own["disk"]
            self.center, self.normal, self.radius = np.asarray(shape["center"], float), unit(shape["normal"]), shape["radius"]
            return
        origin, a, b = (np.asarray(own["parallelogram"][key], float) for key in ("origin", "edge1", "edge2"))
        self.center, self.normal, self.radius = origin + 0.5 * (a + b), unit(np.cross(a, b)), None
        # Unit vectors across the sides, and how far these are from the center.
        self.sides = [(own, 0.5 * abs(edge @ own)) for own, edge in ((unit(np.cross(self.normal, b)), a), (unit(np.cross(self.normal, a)), b))]

    def clear(self, points):
        """How far the feet of points are from the border; below 0 beyond it."""
        away = points - self.center
        if self.radius is not None:
            return self.radius - np.linalg.norm(away - (away @ self.normal)[:, None] * self.normal, axis=1)
        return np.min([reach - np.abs(away @ across) for across, reach in self.sides], axis=0)


class Gaps:
    """Narrow gaps between parallel things that send all back."""

    def __init__(self, surfaces, emissivity):
        flat = {k: Flat(own) for k, own in enumerate(surfaces) if emissivity[k] == 0 and ("disk" in own or "parallelogram" in own)}
        self.pairs = []
        for i, one in flat.items():
            for j, other in flat.items():
                width = (other.center - one.center) @ one.normal
                if one.normal @ other.normal < -1 + 1e-12 and 0 < width < WIDEST:
                    self.pairs.append((i, one, other, width))

    def leap(self, met, points, ways, draw):
        """Moves paths that are about to leave these surfaces to the last place before they may leave the gap, in place."""
        for i, one, other, width in self.pairs:
            own = np.flatnonzero(met == i)
            clear = np.minimum(one.clear(points[own]), other.clear(points[own])) / width
            own, clear = own[clear >= 4], clear[clear >= 4]
            u = unit(np.cross(one.normal, [1, 0, 0] if abs(one.normal[0]) < 0.7 else [0, 1, 0]))
            v = np.cross(one.normal, u)
            place, is_over, step = stepped(walks(), clear, draw)
            points[own] += width * (place @ [u, v] + is_over[:, None] * one.normal)
            way = step @ [u, v] + np.where(is_over, -1, 1)[:, None] * one.normal
            ways[own] = way / np.linalg.norm(way, axis=1, keepdims=True)
            met[own] = -2
