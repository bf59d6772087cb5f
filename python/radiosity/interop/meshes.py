"""Meshes of other packages → scenes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from .._radiosity import mesh_polygons
from ..arguments import Array, array_of, refusal, text, texts
from ..optional import optional
from ..scene import Scene
from .faces import Faces, whole_numbers

Materials = Mapping[str, Any]

_FLAT_CELLS = ("triangle", "quad", "polygon")
_CELLS_WITHOUT_AREA = ("vertex", "line", "line3")
_MATERIAL_KEYS = {"reflectance", "emission", "transmittance", "group", "emissivity", "temperature", "heat_flux", "adiabatic"}


def from_meshio(
    mesh: Any,
    materials: Materials,
    *,
    by: str | None = None,
    flip: bool = False,
    two_sided: bool = False,
    bands: Sequence[str] = ("grey",),
    unit: str | None = None,
    name: str = "mesh",
) -> Scene:
    """The scene of a mesh of meshio.

    Coplanar neighbours of one label become one polygon, so a wall of thousands of triangles is one surface.

    Parameters
    ----------
    mesh : meshio.Mesh
        Triangles, quadrilaterals and polygons; points and lines are passed over. Vertices in scene length; corners run
        counter-clockwise seen from the front, which alone emits and receives.
    materials : mapping
        The material of each label, ``{"wall": {"reflectance": 0.5}, "lamp": {"reflectance": 0.1, "emission": 1000}}``, or
        one for all faces, ``{"reflectance": 0.5}``. Keys are those of materials in scene files: ``reflectance``,
        ``emission`` (W/m² or lm/m²; a number or one per band), ``transmittance``, ``group``, ``emissivity``, ``temperature``
        (K), ``heat_flux`` (W/m²), ``adiabatic``.
    by : str, optional
        The cell data whose entries are the labels; without it the physical groups of Gmsh, else the cell sets, else
        ``"surface"`` for all faces.
    flip : bool
        Turn all faces over: a closed mesh whose normals point outwards is a room then.
    two_sided : bool
        Let the backs emit and receive too.
    bands : sequence of str
        Names of the bands.
    unit : str, optional
        Unit of exitance, irradiance and radiosity, ``"lx"``; printed, never computed with. W/m² by default.
    name : str
        Name of the scene, which stands before messages.

    Returns
    -------
    Scene
        Its surfaces are called after the labels: ``wall``, or ``wall-1``, ``wall-2``, … where a label has several.

    Raises
    ------
    Error
        If cells have a volume or curved sides, if a label has no material, and what scenes refuse.
    """
    blocks = [(index, block) for index, block in enumerate(mesh.cells) if block.type not in _CELLS_WITHOUT_AREA]
    for _, block in blocks:
        if block.type not in _FLAT_CELLS:
            raise refusal(
                f"the mesh has cells of type {block.type}; {', '.join(_FLAT_CELLS)} are wanted",
                "take the boundary of the mesh, with straight sides",
            )
    faces = [whole_numbers("faces", block.data) for _, block in blocks]
    labels = [label for (index, _), own in zip(blocks, faces, strict=True) for label in _meshio_labels(mesh, index, len(own), by)]
    own = Faces.of(mesh.points, faces, labels)
    return _scene(own, materials, flip=flip, two_sided=two_sided, bands=bands, unit=unit, name=name)


def from_pyvista(
    mesh: Any,
    materials: Materials,
    *,
    by: str | None = None,
    flip: bool = False,
    two_sided: bool = False,
    bands: Sequence[str] = ("grey",),
    unit: str | None = None,
    name: str = "mesh",
) -> Scene:
    """The scene of a surface mesh of PyVista.

    Parameters
    ----------
    mesh : pyvista.PolyData
        Faces of any number of corners; `by` names an array of its cell data. Other grids by ``grid.extract_surface()``.
    materials, by, flip, two_sided, bands, unit, name
        As for :func:`from_meshio`; without `by` the label of all faces is ``"surface"``.

    Returns
    -------
    Scene

    Raises
    ------
    Error
        If the mesh is no PolyData or has strips, if a label has no material, and what scenes refuse.
    """
    if not isinstance(mesh, optional("pyvista", "from_pyvista").PolyData) or mesh.n_strips:
        raise refusal(
            f"mesh: a pyvista.PolyData of faces is wanted, not {type(mesh).__name__}",
            "give mesh.extract_surface().triangulate()",
        )
    sizes, corners = _padded(np.asarray(mesh.faces))
    labels = ["surface"] * len(sizes) if by is None else _face_labels(mesh.cell_data, by, mesh.n_cells - len(sizes))
    faces = Faces.ragged(mesh.points, corners, sizes, labels)
    return _scene(faces, materials, flip=flip, two_sided=two_sided, bands=bands, unit=unit, name=name)


def from_trimesh(
    mesh: Any,
    materials: Materials,
    *,
    by: str | None = None,
    flip: bool = False,
    two_sided: bool = False,
    bands: Sequence[str] = ("grey",),
    unit: str | None = None,
    name: str = "mesh",
) -> Scene:
    """The scene of a mesh, or of a scene of meshes, of trimesh.

    Parameters
    ----------
    mesh : trimesh.Trimesh or trimesh.Scene
        Triangles. `by` names an array of ``mesh.face_attributes``. Without it the label of all faces of a mesh is
        ``"surface"``; in a scene the labels are the names of its geometries.
    materials, by, flip, two_sided, bands, unit, name
        As for :func:`from_meshio`.

    Returns
    -------
    Scene

    Raises
    ------
    Error
        If the mesh has no faces, if a label has no material, and what scenes refuse.
    """
    parts = _trimesh_parts(mesh)
    offsets = np.cumsum([0] + [len(vertices) for vertices, _, _, _ in parts])
    vertices = np.concatenate([np.asarray(own, np.float64).reshape(-1, 3) for own, _, _, _ in parts])
    triangles = [np.asarray(own) + offset for (_, own, _, _), offset in zip(parts, offsets)]
    labels: list[Any] = []
    for _, own, label, attributes in parts:
        labels.extend([label] * len(own) if by is None else _face_labels(attributes, by, 0))
    faces = Faces.of(vertices, triangles, labels)
    return _scene(faces, materials, flip=flip, two_sided=two_sided, bands=bands, unit=unit, name=name)


def _meshio_labels(mesh: Any, index: int, count: int, by: str | None) -> Iterable[Any]:
    """The labels of the faces of one block."""
    if by is None and "gmsh:physical" in mesh.cell_data:
        names = {int(tag): name for name, (tag, dimension) in mesh.field_data.items() if dimension == 2}
        tags = mesh.cell_data["gmsh:physical"][index]
        return [names.get(int(tag), str(int(tag))) for tag in tags]
    if by is None and mesh.cell_sets:
        return _set_labels(mesh.cell_sets, index, count)
    if by is None:
        return ["surface"] * count
    return list(_named(mesh.cell_data, by)[index])


def _set_labels(sets: Mapping[str, Any], index: int, count: int) -> list[str]:
    labels = ["surface"] * count
    for name, members in sets.items():
        # Sets of these names hold numbers of Gmsh's entities, not of faces.
        if members[index] is None or name.startswith("gmsh:"):
            continue
        faces = array_of(f"cell set {name!r}", members[index])
        if faces.size and not (faces.dtype.kind in "iu" and 0 <= faces.min() and faces.max() < count):
            raise refusal(f"cell set {name!r}: its entries are no indices of the {count} faces", "count faces from 0")
        for face in faces:
            labels[face] = name
    return labels


def _face_labels(data: Any, by: str, skipped: int) -> list[Any]:
    """Labels of faces, behind `skipped` cells without area."""
    return list(np.asarray(_named(data, by))[skipped:])


def _named(data: Any, by: str) -> Any:
    try:
        return data[text("by", by)]
    except KeyError:
        there = ", ".join(sorted(data.keys())) or "nothing"
        raise refusal(f"by = {by!r}: the mesh has no data of that name for its faces", f"it has {there}") from None


def _padded(faces: Any) -> tuple[Any, Any]:
    """Sizes and corners of faces that VTK lists as k, corner 1 … corner k."""
    sizes, kept, at = [], np.ones(len(faces), bool), 0
    while at < len(faces):
        sizes.append(int(faces[at]))
        kept[at] = False
        at += 1 + sizes[-1]
    return np.array(sizes, np.int64), faces[kept]


def _trimesh_parts(mesh: Any) -> list[tuple[Any, Any, str, Any]]:
    """Vertices, triangles, label and attributes of each part."""
    if hasattr(mesh, "geometry"):
        return [part for node in mesh.graph.nodes_geometry for part in [_trimesh_node(mesh, node)] if part]
    if not hasattr(mesh, "faces"):
        raise refusal(
            f"mesh: a trimesh.Trimesh or trimesh.Scene is wanted, not {type(mesh).__name__}", "load it with trimesh.load_scene"
        )
    return [(mesh.vertices, mesh.faces, "surface", mesh.face_attributes)]


def _trimesh_node(scene: Any, node: str) -> tuple[Any, Any, str, Any] | None:
    """One geometry, where it stands in the scene; None for what has no faces."""
    motion, name = scene.graph[node]
    geometry = scene.geometry[name]
    if not hasattr(geometry, "faces"):
        return None
    moved = geometry.copy().apply_transform(motion)
    return moved.vertices, moved.faces, name, moved.face_attributes


def _scene(
    faces: Faces,
    materials: Materials,
    *,
    flip: bool,
    two_sided: bool,
    bands: Sequence[str],
    unit: str | None,
    name: str,
) -> Scene:
    """Merges faces and names their materials; the rest is what scene files say."""
    if not len(faces.ends):
        raise refusal("the mesh has no faces", "give triangles, quadrilaterals or polygons")
    scene = Scene(texts("bands", bands), name=text("name", name), unit=None if unit is None else text("unit", unit))
    for label, keys in _materials(faces.names, materials).items():
        scene.material(label, **keys)
    faces = faces.turned_over() if flip else faces
    sides = {"two_sided": True} if two_sided else {}
    merged = mesh_polygons(faces.vertices, faces.corners, faces.ends, faces.labels, faces.names)
    for title, index, rings, is_patch in merged:
        scene.surface(title, faces.names[index], **sides, **_shape(rings, is_patch))
    return scene


def _shape(rings: list[Array], is_patch: bool) -> dict[str, Any]:
    if is_patch:
        return {"quad": {"vertices": rings[0]}}
    holes = {"holes": rings[1:]} if len(rings) > 1 else {}
    return {"polygon": {"vertices": rings[0], **holes}}


def _materials(labels: list[str], materials: Materials) -> dict[str, Any]:
    """The material of each label that faces have."""
    if not isinstance(materials, Mapping):
        raise TypeError(f"materials: a mapping is wanted, not {type(materials).__name__}")
    given = {str(label): material for label, material in materials.items()}
    if given and _is_one_material(given, labels):
        given = dict.fromkeys(labels, given)
    missing = [label for label in labels if label not in given]
    if missing:
        raise refusal(f"materials: none for the label {missing[0]!r}", f"the labels of the faces are {', '.join(labels)}")
    for label in labels:
        if not isinstance(given[label], Mapping):
            raise TypeError(f"materials[{label!r}]: a mapping is wanted, not {type(given[label]).__name__}")
    return {label: dict(given[label]) for label in labels}


def _is_one_material(given: dict[str, Any], labels: list[str]) -> bool:
    """Whether keys are those of one material, whose values may be tables of textures, and not labels."""
    has_tables = any(isinstance(value, Mapping) for value in given.values())
    return not has_tables or (set(given) <= _MATERIAL_KEYS and not set(labels) <= set(given))
