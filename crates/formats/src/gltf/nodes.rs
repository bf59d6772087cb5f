//! Nodes: meshes and cameras placed in the scene (sections 3.5 and 3.10).

use std::collections::HashMap;
use std::rc::Rc;

use glam::{DMat3, DMat4, DQuat, DVec3};
use radiosity_photometry::error::{Refusal, refuse, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use serde_json::value::RawValue;

use super::accessor::{Accessors, Data, NumberUse};
use super::extensions;
use super::json::{Json, unlisted};
use super::material::Finish;
use super::scheme::{self, Node, Primitive, Root};
use super::triangles::{Mode, Triangles};
use crate::face_normals::FaceNormals;
use crate::mesh::{Coat, Mesh};
use crate::model::{Camera, Sides};
use crate::names::UniqueNames;

/// Most triangles, primitives and nodes that are visited, repetitions counted: a bound of time, since a file
/// of few bytes may repeat a node without end.
const MOST: usize = 50_000_000;

/// The nodes of a file, and the mesh that they add to.
pub(super) struct Nodes<'a, 'b> {
    json: &'b Json<'a>,
    root: &'b Root<'a>,
    accessors: Accessors<'a, 'b>,
    mesh: &'b mut Mesh,
    names: UniqueNames,
    /// Sides and losses of each material.
    finishes: Vec<Finish>,
    /// The meshes that were parsed, by index.
    meshes: HashMap<usize, Rc<Parts>>,
    visits: usize,
}

/// A mesh that was parsed.
struct Parts {
    name: Option<String>,
    primitives: Vec<(Primitive, FilePlace)>,
}

/// A node in the world.
struct Placed {
    node: Node,
    world: DMat4,
    place: FilePlace,
}

impl<'a, 'b> Nodes<'a, 'b> {
    /// The nodes of a file.
    pub(super) fn new(
        json: &'b Json<'a>,
        root: &'b Root<'a>,
        accessors: Accessors<'a, 'b>,
        finishes: Vec<Finish>,
        mesh: &'b mut Mesh,
    ) -> Self {
        Nodes {
            json,
            root,
            accessors,
            mesh,
            names: UniqueNames::default(),
            finishes,
            meshes: HashMap::new(),
            visits: 0,
        }
    }

    /// Adds the scene that the file names, or its first one; without scenes, all nodes that are nobody's
    /// children.
    pub(super) fn add_scene(mut self) -> Result<(), Refusal> {
        let top = self.json.place(self.json.text());
        let roots = match self.root.scenes.is_empty() {
            true => self.parentless()?,
            false => {
                let index = self.root.scene.unwrap_or(0);
                let (scene, _): (scheme::Scene, FilePlace) =
                    self.json.item(&self.root.scenes, index, "scene", top)?;
                self.mesh.model.title = scene.name.filter(|name| !name.trim().is_empty());
                scene.nodes
            }
        };
        let mut is_met = vec![false; self.root.nodes.len()];
        let mut open: Vec<(usize, DMat4, FilePlace)> =
            roots.into_iter().rev().map(|node| (node, DMat4::IDENTITY, top)).collect();
        while let Some((index, parent, from)) = open.pop() {
            self.visit(1, from)?;
            let (node, place): (Node, FilePlace) = self.json.item(&self.root.nodes, index, "node", from)?;
            if std::mem::replace(&mut is_met[index], true) {
                return refuse_at(
                    place,
                    format!("the node {index} has two parents, or is below itself"),
                    "correct the lists of children, or export the model again",
                );
            }
            let world = parent * matrix(&node).map_err(|fault| fault.at(place))?;
            open.extend(node.children.iter().rev().map(|child| (*child, world, place)));
            self.add_node(&Placed { node, world, place })?;
        }
        Ok(())
    }

    /// Nodes that no node has as a child.
    fn parentless(&self) -> Result<Vec<usize>, Refusal> {
        let mut is_child = vec![false; self.root.nodes.len()];
        for text in &self.root.nodes {
            let node: Node = self.json.parse(text.get(), "a node")?;
            for child in node.children {
                if let Some(is_child) = is_child.get_mut(child) {
                    *is_child = true;
                }
            }
        }
        Ok((0..is_child.len()).filter(|index| !is_child[*index]).collect())
    }

    fn visit(&mut self, count: usize, place: FilePlace) -> Result<(), Refusal> {
        self.visits = self.visits.saturating_add(count);
        match self.visits > MOST {
            true => refuse_at(
                place,
                format!("more than {MOST} triangles, primitives and nodes"),
                "split the model",
            ),
            false => Ok(()),
        }
    }

    fn add_node(&mut self, placed: &Placed) -> Result<(), Refusal> {
        let Placed { node, place, .. } = placed;
        let lost = [
            (node.extensions.light.is_some(), "point lights, spots and directed light are left out"),
            (node.extensions.instances.is_some(), "instances of EXT_mesh_gpu_instancing are left out"),
            (node.skin.is_some(), "skins are left out: meshes stand as they were modelled"),
        ];
        for (_, what) in lost.iter().filter(|lost| lost.0) {
            self.mesh.model.note(*what, Some(*place));
        }
        extensions::note(&node.extensions.others, self.root, *place, &mut self.mesh.model);
        if let Some(camera) = node.camera {
            self.add_camera(camera, placed)?;
        }
        match node.mesh {
            Some(mesh) => self.add_mesh(mesh, placed),
            None => Ok(()),
        }
    }

    fn add_camera(&mut self, index: usize, placed: &Placed) -> Result<(), Refusal> {
        let (camera, place): (scheme::Camera, FilePlace) =
            self.json.item(&self.root.cameras, index, "camera", placed.place)?;
        let Some(perspective) = camera.perspective else {
            self.mesh.model.note("cameras without perspective are left out", Some(place));
            return Ok(());
        };
        if self.mesh.model.camera.is_some() {
            self.mesh.model.note("cameras behind the first are left out", Some(place));
            return Ok(());
        }
        let fov = perspective.yfov.to_degrees();
        let eye = placed.world.transform_point3(DVec3::ZERO);
        // A camera looks along −z, y up (section 3.10.2).
        let [forward, up] =
            [DVec3::NEG_Z, DVec3::Y].map(|axis| placed.world.transform_vector3(axis).try_normalize());
        let (Some(forward), Some(up), true) = (forward, up, fov > 0.0 && fov < 180.0 && eye.is_finite())
        else {
            return refuse_at(
                place,
                format!("the camera {index} has an angle of {fov} degrees, or no direction"),
                "give it a yfov between 0 and π, and scale its node by other than 0",
            );
        };
        self.mesh.model.camera = Some(Camera { eye, target: eye + forward, up, fov, size: None });
        Ok(())
    }

    fn add_mesh(&mut self, index: usize, placed: &Placed) -> Result<(), Refusal> {
        let mesh = self.mesh(index, placed.place)?;
        let named = |name: &Option<String>| name.clone().filter(|name| !name.trim().is_empty());
        let name = named(&placed.node.name).or_else(|| named(&mesh.name));
        let name = name.map(|name| self.names.take(&name));
        let object = self.mesh.object(name.as_deref());
        for (primitive, place) in &mesh.primitives {
            self.visit(1, *place)?;
            self.add_primitive(primitive, object, &placed.world, *place)?;
        }
        Ok(())
    }

    /// The mesh of an index, which is parsed once however many nodes place it.
    fn mesh(&mut self, index: usize, from: FilePlace) -> Result<Rc<Parts>, Refusal> {
        if let Some(known) = self.meshes.get(&index) {
            return Ok(Rc::clone(known));
        }
        let (mesh, _): (scheme::Mesh, FilePlace) = self.json.item(&self.root.meshes, index, "mesh", from)?;
        let primitive = |text: &&RawValue| -> Result<(Primitive, FilePlace), Refusal> {
            Ok((self.json.parse(text.get(), "the primitive")?, self.json.place(text.get())))
        };
        let primitives = mesh.primitives.iter().map(primitive).collect::<Result<_, _>>()?;
        let parts = Rc::new(Parts { name: mesh.name, primitives });
        self.meshes.insert(index, Rc::clone(&parts));
        Ok(parts)
    }

    fn add_primitive(
        &mut self,
        primitive: &Primitive,
        object: usize,
        world: &DMat4,
        place: FilePlace,
    ) -> Result<(), Refusal> {
        let Some(mode) = Mode::of(primitive.mode.unwrap_or(4)) else {
            self.mesh.model.note("points and lines are left out", Some(place));
            return Ok(());
        };
        self.note_lost(primitive, place);
        let Some(position) = primitive.attributes.position else {
            self.mesh.model.note("primitives without positions are left out", Some(place));
            return Ok(());
        };
        let points = self.accessors.data(position, NumberUse::Points, place)?;
        let indices =
            primitive.indices.map(|indices| self.accessors.data(indices, NumberUse::Indices, place));
        let triangles = Triangles { mode, points, indices: indices.transpose()? };
        let normal = primitive.attributes.normal;
        // Normals that cannot be read are of no use, and refuse no file.
        let normals = normal.and_then(|own| self.accessors.data(own, NumberUse::Points, place).ok());
        let coat = self.coat(primitive.material, object, place)?;
        triangles.require_whole(place)?;
        self.visit(triangles.count(), place)?;
        let linear = DMat3::from_mat4(*world);
        let is_mirrored = linear.determinant() < 0.0;
        // Normals go by the inverse transpose.
        let turned = linear.inverse().transpose();
        for [a, b, c] in (0..triangles.count()).filter_map(|number| triangles.corners(number)) {
            let vertices = if is_mirrored { [c, b, a] } else { [a, b, c] };
            let corners = corners_of(vertices, &triangles.points, world);
            if let (Some(normals), Ok(corners)) = (&normals, &corners) {
                let own = vertices.iter().filter_map(|vertex| normals.point(*vertex));
                let normals = own.map(|normal| turned * normal).collect();
                self.mesh.note_normals(&FaceNormals { corners, normals }, coat.sides, place);
            }
            let added = corners.and_then(|corners| self.mesh.face(corners, coat, place));
            added.map_err(|refusal| refusal.at(place))?;
        }
        Ok(())
    }

    /// Notes what of a primitive is left out.
    fn note_lost(&mut self, primitive: &Primitive, place: FilePlace) {
        let lost = [
            (primitive.targets.is_some(), "morph targets are left out"),
            (primitive.attributes.colour.is_some(), "colours of vertices are left out"),
        ];
        for (_, what) in lost.iter().filter(|lost| lost.0) {
            self.mesh.model.note(*what, Some(place));
        }
        extensions::note(&primitive.extensions, self.root, place, &mut self.mesh.model);
    }

    /// Object, material and sides that all faces of a primitive have; the first one tells what of the material is left
    /// out. Without a material, surfaces have none.
    fn coat(&mut self, material: Option<usize>, object: usize, place: FilePlace) -> Result<Coat, Refusal> {
        let Some(index) = material else {
            return Ok(Coat { object, material, sides: Sides::Front });
        };
        let count = self.finishes.len();
        let Some(finish) = self.finishes.get_mut(index) else {
            return Err(unlisted("material", index, count).at(place));
        };
        let left_out = std::mem::take(&mut finish.left_out);
        left_out.into_iter().for_each(|note| note.put(&mut self.mesh.model.notes));
        Ok(Coat { object, material, sides: finish.sides })
    }
}

/// The corners of a triangle in the world.
fn corners_of(vertices: [usize; 3], points: &Data, world: &DMat4) -> Result<Vec<DVec3>, Refusal> {
    let corner = |vertex: &usize| {
        let point = points.point(*vertex).ok_or_else(|| {
            Refusal::new(
                // The index is not told: a buffer may be any file.
                format!("a triangle has a vertex beyond the {} that are listed", points.count),
                "correct the index, or export the model again",
            )
        })?;
        Ok(world.transform_point3(point))
    };
    vertices.iter().map(corner).collect()
}

/// The matrix of a node: its own, or of its scale, rotation and translation, in this order (section 3.5.3).
fn matrix(node: &Node) -> Result<DMat4, Refusal> {
    if let Some(matrix) = &node.matrix {
        return Ok(DMat4::from_cols_array(matrix));
    }
    let [x, y, z, w] = node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0]);
    let rotation = DQuat::from_xyzw(x, y, z, w);
    let length = rotation.length();
    if !(length > 0.0 && length.is_finite()) {
        return refuse(
            "the rotation of the node has no direction",
            "give it a quaternion of length 1, or take it out",
        );
    }
    let scale = DVec3::from_array(node.scale.unwrap_or([1.0; 3]));
    let translation = DVec3::from_array(node.translation.unwrap_or([0.0; 3]));
    Ok(DMat4::from_scale_rotation_translation(scale, rotation.normalize(), translation))
}
