"""Writes an office of 430 polygons, `office.json`, and 200 points on its surfaces, `office.csv`, into a folder.

    python office.py FOLDER [GAP]

GAP is the distance of the cabinets from the wall (0.1: it is dark behind them, on a wall that is one large polygon, and they have
backs: 436 polygons); without it they stand against the wall. Twelve workplaces with a desk and a chair, 36 luminaires below the ceiling, partitions, cabinets, columns; the points are
uniform on the area of what reflects, with a fixed seed.
"""

import json
import pathlib
import random
import sys

SIZE = [14.4, 9.6, 2.8]
POINTS = 200
SEED = 62

MATERIALS = {
    "wall": {"reflectance": 0.6}, "ceiling": {"reflectance": 0.8}, "floor": {"reflectance": 0.25},
    "wood": {"reflectance": 0.45}, "metal": {"reflectance": 0.35}, "cloth": {"reflectance": 0.15},
    "lamp": {"reflectance": 0.5, "emission": 9000},
}


class Office:
    def __init__(self):
        self.surfaces, self.faces, self.solids = [], [], []

    def box(self, name, material, origin, size, opened=()):
        shape = {"origin": [round(x, 6) for x in origin], "size": [round(x, 6) for x in size]}
        if opened:
            shape["open"] = list(opened)
        self.surfaces.append({"name": name, "material": material, "box": shape})
        self.solids.append((shape["origin"], [o + s for o, s in zip(shape["origin"], shape["size"])]))
        for axis in range(3):
            for side, word in enumerate((("left", "right"), ("front", "back"), ("bottom", "top"))[axis]):
                if word not in opened:
                    self.face(shape["origin"], shape["size"], axis, side, 1 if side else -1)

    def room(self):
        walls = {"floor": (2, 0), "ceiling": (2, 1), "left": (0, 0), "right": (0, 1), "front": (1, 0), "back": (1, 1)}
        for name, (axis, side) in walls.items():
            opened = [word for word in ("left", "right", "front", "back", "bottom", "top")
                      if word != {"floor": "bottom", "ceiling": "top"}.get(name, name)]
            material = name if name in MATERIALS else "wall"
            shape = {"origin": [0, 0, 0], "size": SIZE, "inward": True, "open": opened}
            self.surfaces.append({"name": name, "material": material, "box": shape})
            self.face([0, 0, 0], SIZE, axis, side, -1 if side else 1)

    def face(self, origin, size, axis, side, sign):
        """Keeps a face for points: its lowest corner, its sides, its normal."""
        corner, sides, normal = list(origin), list(size), [0.0, 0.0, 0.0]
        corner[axis] += side * size[axis]
        sides[axis] = 0.0
        normal[axis] = float(sign)
        self.faces.append((corner, sides, normal))

    def lamp(self, name, x, y):
        shape = {"origin": [x, y, SIZE[2] - 0.02], "edge1": [0, 0.3, 0], "edge2": [1.2, 0, 0]}
        self.surfaces.append({"name": name, "material": "lamp", "parallelogram": shape})

    def workplace(self, name, x, y, turned):
        """A desk along x, 1.6 m by 0.8 m, with a chair before it or, turned, behind it."""
        self.box(f"{name}-top", "wood", [x, y, 0.7], [1.6, 0.8, 0.03])
        for k, at in enumerate((x + 0.05, x + 1.51)):
            self.box(f"{name}-panel{k}", "metal", [at, y + 0.1, 0], [0.04, 0.6, 0.7], ["bottom", "top"])
        seat = [x + 0.55, y + 0.9 if turned else y - 0.6]
        self.box(f"{name}-seat", "cloth", [*seat, 0.42], [0.5, 0.5, 0.06])
        rest = seat[1] + 0.5 if turned else seat[1] - 0.06
        self.box(f"{name}-rest", "cloth", [seat[0], rest, 0.5], [0.5, 0.06, 0.45])

    def furnish(self, gap):
        self.room()
        for k in range(12):
            turned = k % 2 == 1
            x, y = 1.2 + 2.2 * (k // 2), 4.0 if not turned else 4.9
            self.workplace(f"desk{k}", x, y, turned)
        for k in range(6):
            self.box(f"screen{k}", "cloth", [1.2 + 2.2 * k, 4.83, 0.0], [1.6, 0.04, 1.2], ["bottom"])
        for k in range(6):
            self.box(f"cabinet{k}", "wood", [0.6 + 2.4 * k, SIZE[1] - 0.5 - gap, 0.0], [1.2, 0.5, 1.9],
                     ["bottom"] if gap > 0 else ["bottom", "back"])
        self.box("sign", "metal", [5.9, 2.0, 2.1], [0.8, 0.05, 0.3])
        for k in range(4):
            self.box(f"column{k}", "wall", [2.9 + 2.2 * k, 2.0, 0.0], [0.3, 0.3, SIZE[2]], ["bottom", "top"])
        for k in range(36):
            self.lamp(f"lamp{k}", 0.6 + 1.5 * (k % 9), 0.9 + 2.5 * (k // 9))

    def scene(self):
        return {"title": "An office", "bands": ["lm"], "unit": "lx", "materials": MATERIALS, "surfaces": self.surfaces}

    def count(self):
        return sum(6 - len(own["box"].get("open", [])) if "box" in own else 1 for own in self.surfaces)

    def points(self, count, seed):
        """Points on faces that are in no box, and their normals."""
        draw = random.Random(seed)
        areas = [sides[0] * sides[1] + sides[1] * sides[2] + sides[2] * sides[0] for _, sides, _ in self.faces]
        while count > 0:
            corner, sides, normal = draw.choices(self.faces, areas)[0]
            point = [round(c + s * draw.uniform(0.002, 0.998), 6) for c, s in zip(corner, sides)]
            before = [p + 1e-3 * n for p, n in zip(point, normal)]
            inside = (all(a < x < b for a, x, b in zip(low, before, high)) for low, high in self.solids)
            if not any(inside):
                yield [*point, *normal]
                count -= 1


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[1])
    office = Office()
    office.furnish(float(sys.argv[2]) if len(sys.argv) > 2 else 0.0)
    (folder / "office.json").write_text(json.dumps(office.scene()))
    rows = (",".join(map(str, row)) for row in office.points(POINTS, SEED))
    (folder / "office.csv").write_text("\n".join(["x,y,z,nx,ny,nz", *rows]) + "\n")
    print(office.count(), "polygons")
