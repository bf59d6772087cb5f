"""Meshes of other packages become scenes whose surfaces are merged; solutions become grids."""

import sys

import numpy as np
import pytest

import radiosity
from radiosity import interop

WHITE = {"reflectance": 0.5, "emission": 1.0}


def grid(n):
    """The unit square at z = 0, front up, cut into 2 n² triangles: vertices (v, 3) and triangles (f, 3)."""
    side = np.arange(n + 1) / n
    vertices = np.stack([*np.meshgrid(side, side, indexing="ij"), np.zeros((n + 1, n + 1))], axis=-1).reshape(-1, 3)
    index = np.arange((n + 1) ** 2).reshape(n + 1, n + 1)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    lower, upper = np.stack([a, b, c], axis=-1), np.stack([a, c, d], axis=-1)
    return vertices, np.concatenate([lower.reshape(-1, 3), upper.reshape(-1, 3)])


def closed_cube(scene):
    """Whether the fronts of a scene of six squares see one another and nothing else."""
    factors = radiosity.view_factors(scene)
    np.testing.assert_allclose(factors.row_sums, 1, atol=1e-3)
    np.testing.assert_allclose(factors.areas, 1)
    # Opposite squares of a cube: 0.1998; the share of neighbours follows from the sum.
    matrix = factors.matrix
    assert np.sort(matrix, axis=1)[:, 0] == pytest.approx(0)
    np.testing.assert_allclose(np.sort(matrix, axis=1)[:, 1], 0.1998, atol=2e-4)


def test_the_triangles_of_a_wall_become_the_wall():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(20)
    mesh = meshio.Mesh(vertices, [("triangle", triangles), ("line", triangles[:3, :2])])
    scene = interop.from_meshio(mesh, WHITE)
    assert scene.surfaces == ["surface"]
    assert radiosity.view_factors(scene).areas[0] == pytest.approx(1, rel=1e-15)


def test_physical_groups_of_gmsh_are_labels():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(4)
    right = vertices[triangles].mean(axis=1)[:, 0] > 0.5
    mesh = meshio.Mesh(
        vertices,
        [("triangle", triangles)],
        cell_data={"gmsh:physical": [np.where(right, 7, 3)], "side": [np.where(right, "r", "l")]},
        field_data={"lamp": np.array([7, 2]), "wall": np.array([3, 2])},
    )
    materials = {"lamp": {"reflectance": 0, "emission": 5}, "wall": {"reflectance": 0.5}}
    scene = interop.from_meshio(mesh, materials)
    assert sorted(scene.surfaces) == ["lamp", "wall"]
    assert sorted(interop.from_meshio(mesh, {"l": WHITE, "r": WHITE}, by="side").surfaces) == ["l", "r"]
    with pytest.raises(radiosity.Error, match="none for the label 'wall'"):
        interop.from_meshio(mesh, {"lamp": {"reflectance": 0}})
    with pytest.raises(radiosity.Error, match="it has gmsh:physical, side"):
        interop.from_meshio(mesh, materials, by="colour")


def test_cell_sets_are_labels():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(1)
    mesh = meshio.Mesh(vertices, [("triangle", triangles)], cell_sets={"lower": [[0]], "upper": [[1]]})
    assert interop.from_meshio(mesh, WHITE).surfaces == ["lower", "upper"]


def test_sets_of_boundary_entities_are_no_labels():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(1)
    bounding = [np.array([-3, 5, 9, 1])]
    mesh = meshio.Mesh(vertices, [("triangle", triangles)], cell_sets={"gmsh:bounding_entities": bounding, "lid": [[1]]})
    assert sorted(interop.from_meshio(mesh, WHITE).surfaces) == ["lid", "surface"]
    for wrong in ([2], [-1], [0.5]):
        mesh = meshio.Mesh(vertices, [("triangle", triangles)], cell_sets={"lid": [np.array(wrong)]})
        with pytest.raises(radiosity.Error, match="cell set 'lid': its entries are no indices of the 2 faces"):
            interop.from_meshio(mesh, WHITE)


def test_one_material_may_have_tables():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(1)
    mesh = meshio.Mesh(vertices, [("triangle", triangles)])
    shaded = {"reflectance": {"polynomial": [[0, 0, 0.5], [1, 0, 0.1]]}, "emission": 1}
    assert interop.from_meshio(mesh, shaded).surfaces == ["surface"]
    with pytest.raises(radiosity.Error, match="materials: none for the label 'surface'"):
        interop.from_meshio(mesh, {"wall": shaded})
    lamp = meshio.Mesh(vertices, [("triangle", triangles)], cell_sets={"emission": [[0, 1]]})
    assert interop.from_meshio(lamp, {"emission": {"reflectance": 0.5}}).surfaces == ["emission"]


def test_holes_stay_holes():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(3)
    middle = np.abs(vertices[triangles].mean(axis=1)[:, :2] - 0.5).max(axis=1) < 1 / 6
    scene = interop.from_meshio(meshio.Mesh(vertices, [("triangle", triangles[~middle])]), WHITE)
    assert scene.surfaces == ["surface"]
    assert radiosity.view_factors(scene).areas[0] == pytest.approx(8 / 9)


def test_volumes_are_refused():
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(np.eye(4, 3), [("tetra", np.array([[0, 1, 2, 3]]))])
    with pytest.raises(radiosity.Error, match="take the boundary of the mesh"):
        interop.from_meshio(mesh, WHITE)


def test_faces_that_have_no_vertices_are_named():
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(np.eye(3), [("triangle", np.array([[0, 1, 2], [0, 1, 3]]))])
    with pytest.raises(radiosity.Error, match=r"faces\[1\]: a corner is none of the 3 vertices"):
        interop.from_meshio(mesh, WHITE)


def test_a_box_of_trimesh_is_a_room_when_it_is_turned_over():
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box((1, 1, 1)).subdivide().subdivide()
    scene = interop.from_trimesh(box, WHITE, flip=True)
    assert len(scene.surfaces) == 6
    closed_cube(scene)
    # In a closed room of reflectance ½ that emits 1 everywhere, 2 arrives at every point.
    arrived = scene.solve(progress=False).irradiance([[0.1, 0.2, -0.1]], [[0.0, 0.6, 0.8]])
    np.testing.assert_allclose(arrived, 2, rtol=1e-2)


def test_the_names_of_a_scene_of_trimesh_are_labels():
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    up = trimesh.transformations.translation_matrix([0, 0, 3])
    scene.add_geometry(trimesh.creation.box((1, 1, 1)), geom_name="plinth")
    scene.add_geometry(trimesh.creation.box((1, 1, 1)), geom_name="lamp", transform=up)
    made = interop.from_trimesh(scene, {"plinth": WHITE, "lamp": WHITE})
    assert sorted(made.surfaces) == sorted(f"{name}-{k}" for name in ("plinth", "lamp") for k in range(1, 7))
    with pytest.raises(radiosity.Error, match="not dict"):
        interop.from_trimesh({}, WHITE)


def test_faces_of_pyvista_keep_their_corners():
    pyvista = pytest.importorskip("pyvista")
    scene = interop.from_pyvista(pyvista.Cube(), WHITE, flip=True)
    assert len(scene.surfaces) == 6
    closed_cube(scene)
    cube = pyvista.Cube().triangulate()
    cube.cell_data["part"] = ["a"] * 6 + ["b"] * 6
    materials = {"a": WHITE, "b": {"reflectance": 0.2}}
    assert {name[0] for name in interop.from_pyvista(cube, materials, by="part").surfaces} == {"a", "b"}
    with pytest.raises(radiosity.Error, match="extract_surface"):
        interop.from_pyvista(pyvista.ImageData(dimensions=(2, 2, 2)), WHITE)


def test_a_solution_becomes_a_grid_that_holds_its_light():
    pytest.importorskip("pyvista")
    solution = radiosity.load("furnace-cube").solve(progress=False)
    light = interop.to_pyvista(solution)
    fields = [name for name in light.point_data if name.startswith("irradiance")]
    assert fields
    for name in fields:
        np.testing.assert_allclose(light.point_data[name], 2, rtol=1e-3)
    assert light.compute_cell_sizes()["Area"].sum() == pytest.approx(light.cell_data["element area"].sum())


def test_a_plot_is_a_picture(tmp_path):
    pyvista = pytest.importorskip("pyvista")
    solution = radiosity.load("cornell-box").solve(progress=False)
    path = tmp_path / "light.png"
    solution.plot(off_screen=True, screenshot=str(path), window_size=(160, 120))
    picture = pyvista.read(path)
    assert picture.dimensions[:2] == (160, 120)
    assert np.ptp(np.asarray(picture.active_scalars, float)) > 100
    with pytest.raises(radiosity.Error, match="there are irradiance"):
        solution.plot(band="ultraviolet")


def test_missing_packages_are_named_with_their_cure(monkeypatch):
    solution = radiosity.load("furnace-cube").solve(progress=False)
    monkeypatch.setitem(sys.modules, "pyvista", None)
    with pytest.raises(ImportError, match="pip install pyvista"):
        solution.plot()


def test_a_mesh_takes_more_parts():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(3)
    scene = interop.from_meshio(meshio.Mesh(vertices, [("triangle", triangles)]), {"reflectance": 0.5}, name="desk")
    lamp = scene.material("lamp", reflectance=0, emission=100)
    scene.disk("lamp", lamp, center=[0.5, 0.5, 1], normal=[0, 0, -1], radius=0.2)
    assert scene.surfaces == ["surface", "lamp"]


def test_materials_are_checked_as_in_scene_files():
    meshio = pytest.importorskip("meshio")
    vertices, triangles = grid(1)
    mesh = meshio.Mesh(vertices, [("triangle", triangles)])
    for material, text in [
        ({"reflectance": 1.5}, "reflectance"),
        ({"reflectanse": 0.5}, "reflectanse"),
        ({"reflectance": float("nan")}, "NaN"),
    ]:
        with pytest.raises(radiosity.Error, match=text):
            _ = interop.from_meshio(mesh, material).surfaces
    with pytest.raises(TypeError, match="a mapping is wanted"):
        interop.from_meshio(mesh, [0.5])
