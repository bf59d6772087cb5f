//! Vertices and faces of an OBJ.

use std::collections::HashMap;
use std::num::NonZeroU32;
use std::ops::Range;

use glam::DVec3;
use radiosity_geom::area_vector;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;
use radiosity_photometry::text::{number, short};

use super::statements::split;
use crate::face_normals::{FaceNormals, is_bent};
use crate::mesh::{Coat, Mesh};
use crate::model::Sides;
use crate::tolerances::MOST_VERTICES;

/// Names of material files in a statement `mtllib`, and its line.
#[derive(Debug)]
pub(super) struct Library {
    pub(super) names: String,
    pub(super) line: usize,
}

/// A face: where its corners begin, its object and its material.
#[derive(Debug)]
struct Face {
    start: usize,
    object: usize,
    material: Option<usize>,
    smoothing: Option<Smoothing>,
    line: usize,
}

/// A smoothing group by its number among them, and the line in which faces are put into it.
#[derive(Clone, Copy, Debug)]
struct Smoothing {
    group: usize,
    line: usize,
}

/// The normals of the first faces at the corners of smoothing groups.
#[derive(Debug, Default)]
struct SmoothCorners {
    first: HashMap<(usize, usize), DVec3>,
    /// Whether faces of a group are known to meet at an angle.
    is_told: bool,
}

impl SmoothCorners {
    /// Whether a face of a group meets another one of it at an angle, for the first time.
    fn bend(&mut self, group: usize, corners: impl Iterator<Item = usize>, normal: DVec3) -> bool {
        if self.is_told {
            return false;
        }
        for corner in corners {
            let first = *self.first.entry((group, corner)).or_insert(normal);
            self.is_told |= is_bent(first, normal);
        }
        self.is_told
    }
}

/// Vertices, faces, objects and materials of the statements read so far.
#[derive(Debug, Default)]
pub(super) struct Faces {
    vertices: Vec<DVec3>,
    /// Indices of the vertices at the corners of all faces, from 0 on; a vertex may be defined further down
    /// in the text.
    corners: Vec<usize>,
    faces: Vec<Face>,
    /// Names of objects, none for faces before the first; the current one.
    objects: Names,
    object: String,
    /// Materials that faces have, by their first uses; the current one.
    pub(super) materials: Vec<MaterialUse>,
    material_numbers: Names,
    material: Option<MaterialUse>,
    pub(super) libraries: Vec<Library>,
    /// Normals of vertices; 0 where they are none.
    normals: Vec<DVec3>,
    /// The numbers of the normals at the corners of all faces, from 1 on.
    corner_normals: Vec<Option<NonZeroU32>>,
    /// Smoothing groups by name; the one that faces are put into.
    smoothing_numbers: Names,
    smoothing: Option<Smoothing>,
    notes: Vec<Note>,
}

/// A material that a line names.
#[derive(Clone, Debug)]
pub(super) struct MaterialUse {
    pub(super) name: String,
    pub(super) line: usize,
}

/// Numbers of names, in the order of their first use.
type Names = HashMap<String, usize>;

/// The normal of a statement, 0 if it is none.
fn normal(rest: &str) -> DVec3 {
    let numbers: Vec<f64> = rest.split_whitespace().map_while(|word| word.parse().ok()).collect();
    match numbers[..] {
        [x, y, z, ..] => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    }
}

impl Faces {
    /// Takes a statement of a line.
    pub(super) fn statement(&mut self, statement: &str, line: usize) -> Result<(), Refusal> {
        let (keyword, rest) = split(statement);
        match keyword.to_ascii_lowercase().as_str() {
            "v" => self.vertex(rest, line)?,
            "f" | "fo" => self.face(rest, line)?,
            "o" | "g" => self.object = rest.to_owned(),
            "usemtl" => {
                self.material = (!rest.is_empty()).then(|| MaterialUse { name: rest.to_owned(), line });
            }
            "mtllib" => self.libraries.push(Library { names: rest.to_owned(), line }),
            "p" => self.note("points are left out", line),
            "l" => self.note("lines are left out", line),
            "curv" | "curv2" | "surf" | "bzp" | "bsp" | "cdc" | "cdp" | "res" => {
                self.note("free-form curves and surfaces are left out", line);
            }
            "call" | "csh" => self.note("calls of other files and commands are left out", line),
            "vn" => self.normals.push(normal(rest)),
            "s" => {
                let name = rest.to_ascii_lowercase();
                let is_off = ["", "0", "off"].contains(&name.as_str());
                let next = self.smoothing_numbers.len();
                self.smoothing = (!is_off)
                    .then(|| Smoothing { group: *self.smoothing_numbers.entry(name).or_insert(next), line });
            }
            "usemap" if !rest.eq_ignore_ascii_case("off") => self.note("textures are left out", line),
            "shadow_obj" | "trace_obj" => {
                self.note("objects for shadows and reflections are left out", line);
            }
            "vt" | "vp" | "lod" | "mg" | "bevel" | "c_interp" | "d_interp" | "usemap" | "maplib"
            | "cstype" | "deg" | "bmat" | "step" | "parm" | "trim" | "hole" | "scrv" | "sp" | "end"
            | "con" | "ctech" | "stech" => {}
            _ => {
                return refuse(
                    format!("'{}' is no statement of OBJ", short(keyword)),
                    "take the line out, put '#' before it, or name the format that the file has",
                );
            }
        }
        Ok(())
    }

    fn note(&mut self, text: &'static str, line: usize) {
        Note::add(&mut self.notes, text, Some(FilePlace::Line(line)));
    }

    fn vertex(&mut self, rest: &str, line: usize) -> Result<(), Refusal> {
        let words: Vec<&str> = rest.split_whitespace().collect();
        let [x, y, z, more @ ..] = words.as_slice() else {
            return refuse(
                format!("the vertex has {} coordinates, it takes 3", words.len()),
                "give it x, y and z",
            );
        };
        if more.len() >= 3 {
            self.note("colours of vertices are left out", line);
        }
        if self.vertices.len() >= MOST_VERTICES {
            return refuse(format!("more than {MOST_VERTICES} vertices"), "split the model");
        }
        self.vertices.push(DVec3::new(number(x, "x")?, number(y, "y")?, number(z, "z")?));
        Ok(())
    }

    fn face(&mut self, rest: &str, line: usize) -> Result<(), Refusal> {
        let start = self.corners.len();
        for word in rest.split_whitespace() {
            let corner = self.corner(word)?;
            self.corners.push(corner);
            self.corner_normals.push(self.normal_of(word));
        }
        let next = self.objects.len();
        let object = match self.objects.get(&self.object) {
            Some(object) => *object,
            None => *self.objects.entry(self.object.clone()).or_insert(next),
        };
        let material = self.material_number();
        self.faces.push(Face { start, object, material, smoothing: self.smoothing, line });
        Ok(())
    }

    /// The number of a vertex that a corner `v`, `v/vt`, `v//vn` or `v/vt/vn` has: from 1 on, or below 0
    /// backwards from the last vertex.
    fn corner(&self, word: &str) -> Result<usize, Refusal> {
        let first = word.split('/').next().unwrap_or(word);
        let count = self.vertices.len();
        match first.parse::<isize>() {
            Ok(index @ 1..) => Ok(index.unsigned_abs() - 1),
            Ok(index @ ..=-1) => count.checked_sub(index.unsigned_abs()).ok_or_else(|| {
                Refusal::new(
                    format!("the face has the vertex {index}; {count} are listed above it"),
                    "correct the number, or list the vertex",
                )
            }),
            Ok(0) => refuse("the face has the vertex 0", "count vertices from 1 on"),
            Err(_) => refuse(
                format!("the corner '{}' has no number of a vertex", short(word)),
                "write it as v, v/vt, v//vn or v/vt/vn",
            ),
        }
    }

    /// The number of the normal that a corner `v//vn` or `v/vt/vn` names, if it names one.
    fn normal_of(&self, word: &str) -> Option<NonZeroU32> {
        let index: isize = word.split('/').nth(2)?.parse().ok()?;
        let number =
            if index < 0 { self.normals.len().checked_add_signed(index + 1)? } else { index.unsigned_abs() };
        NonZeroU32::new(number.try_into().ok()?)
    }

    /// The number of the current material.
    fn material_number(&mut self) -> Option<usize> {
        let material = self.material.as_ref()?;
        if let Some(number) = self.material_numbers.get(&material.name) {
            return Some(*number);
        }
        let next = self.materials.len();
        self.materials.push(material.clone());
        self.material_numbers.insert(material.name.clone(), next);
        Some(next)
    }

    /// The faces without their materials.
    pub(super) fn without_materials(mut self) -> Self {
        self.faces.iter_mut().for_each(|face| face.material = None);
        self
    }

    /// Adds all faces to a mesh that has the materials.
    pub(super) fn add_to(&self, mesh: &mut Mesh) -> Result<(), Refusal> {
        mesh.has_normals = !self.normals.is_empty();
        mesh.model.notes.extend_from_slice(&self.notes);
        let mut names: Vec<(&String, &usize)> = self.objects.iter().collect();
        names.sort_by_key(|(_, number)| **number);
        let objects: Vec<usize> = names.iter().map(|(name, _)| mesh.object(Some(name))).collect();
        let mut smooth = SmoothCorners::default();
        let ends = self.faces.iter().skip(1).map(|face| face.start).chain([self.corners.len()]);
        for (face, end) in self.faces.iter().zip(ends) {
            let place = FilePlace::Line(face.line);
            let corners: Result<Vec<DVec3>, Refusal> =
                self.corners[face.start..end].iter().map(|corner| self.point(*corner)).collect();
            let coat = Coat { object: objects[face.object], material: face.material, sides: Sides::Open };
            let corners = corners.map_err(|fault| fault.at(place))?;
            if let Some(line) = self.bent_line(face, face.start..end, &corners, &mut smooth) {
                mesh.note_smoothed(line);
            }
            let normals = self.corner_normals[face.start..end].iter().flatten();
            let normals = normals.filter_map(|number| self.normal(*number)).collect();
            mesh.note_normals(&FaceNormals { corners: &corners, normals }, coat.sides, place);
            mesh.face(corners, coat, place).map_err(|fault| fault.at(place))?;
        }
        Ok(())
    }

    /// The line of the smoothing group of a face, if it meets another face of it at an angle where neither states
    /// a normal.
    fn bent_line(
        &self,
        face: &Face,
        range: Range<usize>,
        corners: &[DVec3],
        smooth: &mut SmoothCorners,
    ) -> Option<usize> {
        let Smoothing { group, line } = face.smoothing?;
        let normal = area_vector(corners).try_normalize()?;
        let is_bare = |at: &usize| self.corner_normals[*at].is_none();
        let vertices = range.filter(is_bare).map(|at| self.corners[at]);
        smooth.bend(group, vertices, normal).then_some(line)
    }

    fn normal(&self, number: NonZeroU32) -> Option<DVec3> {
        self.normals.get(number.get() as usize - 1).copied()
    }

    fn point(&self, corner: usize) -> Result<DVec3, Refusal> {
        self.vertices.get(corner).copied().ok_or_else(|| {
            Refusal::new(
                format!("the face has the vertex {}; {} are listed", corner + 1, self.vertices.len()),
                "correct the number, or list the vertex",
            )
        })
    }
}
