"""A scene file of this project (JSON, one band or three) as a scene of Mitsuba 3, by a variant of as many channels.

Surfaces are diffuse and send light from their fronts; a back without `two_sided` is black and hides what is behind it, as
`diffuse` of Mitsuba does without `twosided`. All surfaces of one pair of paints become one mesh, so that the lamps of one
exitance are one emitter, whose points are uniform on its area. Curved shapes become facets of one angle.

Flat shapes, disks, cylinders, cones, spheres and tori are known, with `flip`, `two_sided`, `transform`; textures, skies,
luminaires, transmittance and all else are refused.
"""

import json
import math
import pathlib

import mapbox_earcut
import mitsuba as mi
import numpy

# Facets are chords; this is how far they are from the circle (in lengths of the scene). Chosen: the area of a disk of radius 0.15
# is 0.04 % too small, that of a ball of a room less than 0.1 %.
SAGITTA = 5e-5
# Each side of a lamp of two sides lies so far before its middle (metres); rays of Mitsuba begin 1e-4 and more before a surface.
APART = 1e-5

KNOWN = {"name", "material", "back_material", "two_sided", "flip", "transform", "emission", "flux"}


def unit(vector):
    return numpy.asarray(vector, float) / numpy.linalg.norm(vector)


def facets(radius, degrees):
    """Facets of an arc."""
    return max(3, math.ceil(math.radians(degrees) / math.sqrt(8 * SAGITTA / radius)))


def axes(axis):
    """A right-handed frame about an axis; angles count from the projection of +x, of +y where the axis is along x."""
    z = unit(axis)
    along = numpy.array([1.0, 0, 0]) if math.hypot(z[1], z[2]) > 1e-9 else numpy.array([0, 1.0, 0])
    x = unit(along - along.dot(z) * z)
    return x, numpy.cross(z, x), z


def flat(outlines):
    """Triangles of an outline with holes, in the plane of the outline, facing as it does by the right-hand rule."""
    outlines = [numpy.asarray(outline, float) for outline in outlines]
    first = outlines[0]
    normal = unit(sum(numpy.cross(a - first[0], b - first[0]) for a, b in zip(first, numpy.roll(first, -1, 0))))
    x, y, _ = axes(normal)
    corners = numpy.concatenate(outlines)
    plane = numpy.stack([corners @ x, corners @ y], axis=1)
    ends = numpy.cumsum([len(outline) for outline in outlines]).astype(numpy.uint32)
    faces = mapbox_earcut.triangulate_float64(plane, ends).reshape(-1, 3).astype(int)
    a, b, c = (plane[faces[:, k]] for k in range(3))
    turn = (b[:, 0] - a[:, 0]) * (c[:, 1] - a[:, 1]) - (b[:, 1] - a[:, 1]) * (c[:, 0] - a[:, 0])
    faces[turn < 0] = faces[turn < 0][:, ::-1]
    return corners, faces


def turned(center, axis, angle, profile):
    """A line of (distance from the axis, height) that is turned about the axis; its front is d/dφ × d/dline."""
    x, y, z = axes(axis)
    start, end = angle
    steps = facets(max(r for r, _ in profile), end - start)
    turns = numpy.radians(numpy.linspace(start, end, steps + 1))
    around = numpy.outer(numpy.cos(turns), x) + numpy.outer(numpy.sin(turns), y)
    rows = [numpy.asarray(center) + r * around + h * z for r, h in profile]
    wide = steps + 1
    a = (numpy.arange(len(profile) - 1)[:, None] * wide + numpy.arange(steps)).ravel()
    faces = numpy.concatenate([numpy.stack([a, a + 1, a + wide + 1], 1), numpy.stack([a, a + wide + 1, a + wide], 1)])
    on_axis = numpy.repeat([r == 0 for r, _ in profile], wide)
    apart = ~(on_axis[faces].sum(axis=1) > 1)
    return numpy.concatenate(rows), faces[apart]


def box(shape):
    """Faces of a box, seen from outside, or from inside."""
    low = numpy.minimum(*numpy.array(shape["corners"], float)) if "corners" in shape else numpy.array(shape["origin"], float)
    size = abs(numpy.subtract(*shape["corners"])) if "corners" in shape else numpy.array(shape["size"], float)
    names = {"left": (0, 0), "right": (0, 1), "front": (1, 0), "back": (1, 1), "bottom": (2, 0), "top": (2, 1)}
    for name, (axis, side) in names.items():
        if name in shape.get("open", []):
            continue
        a, b = numpy.eye(3)[(axis + 1) % 3] * size, numpy.eye(3)[(axis + 2) % 3] * size
        origin = low + side * numpy.eye(3)[axis] * size
        # a × b is along the axis.
        if bool(side) == shape.get("inward", False):
            a, b = b, a
        yield flat([[origin, origin + a, origin + a + b, origin + b]])


def pieces(kind, shape):
    """Meshes of a shape."""
    whole = [0, 360]
    if kind == "box":
        yield from box(shape)
    elif kind == "parallelogram":
        o, a, b = (numpy.array(shape[key], float) for key in ("origin", "edge1", "edge2"))
        yield flat([[o, o + a, o + a + b, o + b], *shape.get("holes", [])])
    elif kind in ("polygon", "triangle", "quad"):
        yield flat([shape["vertices"], *shape.get("holes", [])])
    elif kind == "disk":
        profile = [(shape["radius"], 0.0), (shape.get("inner_radius", 0.0), 0.0)]
        yield turned(shape["center"], shape["normal"], shape.get("angle", whole), profile)
    elif kind in ("cylinder", "cone"):
        height = float(numpy.linalg.norm(shape["axis"]))
        first = shape.get("radius1", shape.get("radius"))
        profile = [(first, 0.0), (shape.get("radius2", shape.get("radius")), height)]
        yield turned(shape["base"], shape["axis"], shape.get("angle", whole), profile)
    elif kind == "sphere":
        radius = shape["radius"]
        low, high = (math.asin(max(-1, min(1, z / radius))) for z in shape.get("z", [-radius, radius]))
        steps = facets(radius, math.degrees(high - low))
        profile = [(radius * math.cos(t), radius * math.sin(t)) for t in numpy.linspace(low, high, steps + 1)]
        profile = [(0.0 if r < 1e-9 * radius else r, z) for r, z in profile]
        yield turned(shape["center"], shape.get("axis", [0, 0, 1]), shape.get("angle", whole), profile)
    elif kind == "torus":
        start, end = shape.get("tube_angle", whole)
        steps = facets(shape["minor"], end - start)
        tube = [(shape["major"] + shape["minor"] * math.cos(t), shape["minor"] * math.sin(t))
                for t in numpy.radians(numpy.linspace(start, end, steps + 1))]
        yield turned(shape["center"], shape["axis"], shape.get("angle", whole), tube)
    else:
        raise ValueError(f"{kind} is not known here")


def placed(corners, place):
    """Corners that are scaled, turned and moved."""
    corners = corners * place.get("scale", 1)
    if "rotate" in place:
        *axis, degrees = place["rotate"]
        axis, turn = unit(axis), math.radians(degrees)
        corners = (corners * math.cos(turn) + numpy.cross(axis, corners) * math.sin(turn)
                   + numpy.outer(corners @ axis, axis) * (1 - math.cos(turn)))
    return corners + numpy.array(place.get("translate", [0, 0, 0]))


def area(corners, faces):
    a, b, c = (corners[faces[:, k]] for k in range(3))
    return numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2


def values(scene, given):
    """A value for each band, from one for all or a list."""
    own = given if isinstance(given, list) else [given] * bands(scene)
    if len(own) != bands(scene) or not all(isinstance(value, (int, float)) for value in own):
        raise ValueError(f"{given} is not one number a band: scenes without textures are known here")
    return tuple(map(float, own))


def bands(scene):
    """Number of bands: those that are named, or red, green and blue where any paint has three."""
    if "bands" in scene:
        return len(scene["bands"])
    paints = [given for paint in scene["materials"].values() for given in paint.values() if isinstance(given, list)]
    return max(map(len, paints), default=1)


def paint(scene, name):
    material = scene["materials"][name]
    if set(material) - {"reflectance", "emission", "group"}:
        raise ValueError(f"the material {name} has {set(material)}, of which not all is known here")
    return values(scene, material["reflectance"]), values(scene, material.get("emission", 0))


def surfaces(scene):
    """Meshes of all surfaces, with the reflectance of the front, that of the back or None, and the front's exitance."""
    if unknown := {"sky", "luminaires", "instances", "include", "motion"} & set(scene):
        raise ValueError(f"{unknown} is not known here")
    nothing = values(scene, 0)
    for surface in scene["surfaces"]:
        [kind] = [key for key in surface if key not in KNOWN]
        front, own = paint(scene, surface["material"])
        back, behind = None, nothing
        if surface.get("two_sided"):
            back, behind = paint(scene, surface.get("back_material", surface["material"]))
        meshes = [(placed(corners, surface.get("transform", {})), faces[:, ::-1] if surface.get("flip") else faces)
                  for corners, faces in pieces(kind, surface[kind])]
        if "flux" in surface:
            whole = sum(area(*mesh) for mesh in meshes) * (1 if back is None else 2)
            own = tuple(flux / whole for flux in values(scene, surface["flux"]))
            behind = own if back is not None else nothing
        for corners, faces in meshes:
            if behind == nothing:
                yield corners, faces, (front, back, own)
                continue
            a, b, c = corners[faces[0]]
            step = APART * unit(numpy.cross(b - a, c - a))
            yield corners + step, faces, (front, None, own)
            yield corners - step, faces[:, ::-1], (back, None, behind)


def spectrum(values):
    """The values of one band, or of three as those of red, green and blue."""
    return {"type": "uniform", "value": values[0]} if len(values) == 1 else {"type": "rgb", "value": list(values)}


def diffuse(reflectance):
    return {"type": "diffuse", "reflectance": spectrum(reflectance)}


def joined(meshes):
    """One mesh of many."""
    starts = numpy.cumsum([0] + [len(corners) for corners, _ in meshes])
    return (numpy.concatenate([corners for corners, _ in meshes]),
            numpy.concatenate([faces + start for (_, faces), start in zip(meshes, starts)]))


def written(path, corners, faces):
    """A mesh in a file."""
    mesh = mi.Mesh(path.stem, len(corners), len(faces))
    parts = mi.traverse(mesh)
    parts["vertex_positions"] = corners.astype(numpy.float32).ravel()
    parts["faces"] = faces.astype(numpy.uint32).ravel()
    parts.update()
    mesh.write_ply(str(path))


def converted(file, folder):
    """The scene of a file, as `mitsuba.load_dict` takes it; its meshes are written to a folder."""
    groups = {}
    for corners, faces, paints in surfaces(json.loads(pathlib.Path(file).read_text())):
        groups.setdefault(paints, []).append((corners, faces))
    scene = {"type": "scene"}
    for count, ((front, back, own), meshes) in enumerate(groups.items()):
        corners, faces = joined(meshes)
        path = pathlib.Path(folder) / f"mesh{count}.ply"
        written(path, corners, faces)
        bsdf = diffuse(front)
        if back is not None:
            bsdf = {"type": "twosided", "front": bsdf, "back": diffuse(back)}
        shape = {"type": "ply", "filename": str(path), "face_normals": True, "bsdf": bsdf}
        if sum(own) > 0:
            # Emitters are chosen by their power.
            shape["emitter"] = {"type": "area", "radiance": spectrum([value / math.pi for value in own]),
                                "sampling_weight": sum(own) * area(corners, faces)}
        scene[f"mesh{count}"] = shape
    return scene
