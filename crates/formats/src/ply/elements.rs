//! Vertices and faces of a PLY.

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::short;

use super::header::{Element, Header, Property};
use super::numbers::Numbers;
use crate::face_normals::FaceNormals;
use crate::mesh::{Coat, Mesh};
use crate::model::{Model, Sides};
use crate::tolerances::MOST_ROWS;

/// Names that lists of corners have.
const LISTS: [&str; 2] = ["vertex_indices", "vertex_index"];

/// Names that texture coordinates have.
const TEXTURES: [&str; 7] = ["s", "t", "u", "v", "texture_u", "texture_v", "texcoord"];

/// Vertices, and faces as numbers of vertices.
#[derive(Debug, Default)]
pub(super) struct Elements {
    vertices: Vec<DVec3>,
    /// Normals of the vertices, if they have any.
    normals: Vec<DVec3>,
    corners: Vec<f64>,
    faces: Vec<Face>,
}

/// A face of the file.
#[derive(Debug)]
struct Face {
    /// Index among all corners of its first one.
    start: usize,
    place: FilePlace,
}

impl Elements {
    /// Reads all elements that the header announces.
    pub(super) fn read(
        &mut self,
        header: &Header,
        numbers: &mut dyn Numbers,
        mesh: &mut Mesh,
    ) -> Result<(), Refusal> {
        if let Some(line) = header.texture {
            mesh.model.note("textures are left out", Some(FilePlace::Line(line)));
        }
        for element in &header.elements {
            note(element, &mut mesh.model);
            if element.properties.is_empty() {
                continue;
            }
            let bytes = element.properties.iter().map(Property::least).sum();
            let most = numbers.most_rows(bytes, element.properties.len());
            if element.count > most.min(MOST_ROWS) {
                return refuse_at(
                    FilePlace::Line(element.line),
                    format!(
                        "{} elements are announced, {} at the most are there",
                        element.count,
                        most.min(MOST_ROWS)
                    ),
                    "export the file again, or correct the count",
                );
            }
            match element.name.as_str() {
                "vertex" => self.read_vertices(element, numbers)?,
                "face" => self.read_faces(element, numbers)?,
                "tristrips" => self.read_strips(element, numbers)?,
                _ => {
                    for _ in 0..element.count {
                        row(&element.properties, numbers, &[], &mut |_, _| Ok(()))?;
                    }
                }
            }
        }
        Ok(())
    }

    fn read_vertices(&mut self, element: &Element, numbers: &mut dyn Numbers) -> Result<(), Refusal> {
        let axis = |name: &str| {
            let is_axis = |property: &Property| property.name == name && property.count.is_none();
            element.properties.iter().position(is_axis).ok_or_else(|| {
                let cause = format!("the vertices have no property {name}");
                Refusal::new(cause, "give them x, y and z as numbers").at(FilePlace::Line(element.line))
            })
        };
        let axes = [axis("x")?, axis("y")?, axis("z")?];
        let normal = ["nx", "ny", "nz"].map(|name| axis(name).ok());
        let normal = match normal {
            [Some(x), Some(y), Some(z)] => Some([x, y, z]),
            _ => None,
        };
        let wanted: Vec<usize> = axes.into_iter().chain(normal.into_iter().flatten()).collect();
        for _ in 0..element.count {
            let place = numbers.place();
            let mut vectors = [DVec3::ZERO; 2];
            row(&element.properties, numbers, &wanted, &mut |property, value| {
                let place = wanted.iter().position(|own| *own == property);
                place.into_iter().for_each(|place| vectors[place / 3][place % 3] = value);
                Ok(())
            })?;
            let [point, own_normal] = vectors;
            if !point.is_finite() {
                return refuse_at(
                    place,
                    "a coordinate of this vertex is not finite",
                    "correct it, or export the model again",
                );
            }
            self.vertices.push(point);
            self.normals.extend(normal.map(|_| own_normal));
        }
        Ok(())
    }

    fn read_faces(&mut self, element: &Element, numbers: &mut dyn Numbers) -> Result<(), Refusal> {
        let list = list_of_corners(element)?;
        for _ in 0..element.count {
            let place = numbers.place();
            self.faces.push(Face { start: self.corners.len(), place });
            let corners = &mut self.corners;
            row(&element.properties, numbers, &[list], &mut |_, corner| add_corner(corners, corner, place))?;
        }
        Ok(())
    }

    /// Reads strips of triangles: each corner from the third one on makes one with the two before it, those of odd
    /// places turned over; −1 begins another strip.
    fn read_strips(&mut self, element: &Element, numbers: &mut dyn Numbers) -> Result<(), Refusal> {
        let list = list_of_corners(element)?;
        for _ in 0..element.count {
            let place = numbers.place();
            let mut strip: Vec<f64> = Vec::new();
            row(&element.properties, numbers, &[list], &mut |_, corner| {
                if corner == -1.0 {
                    strip.clear();
                    return Ok(());
                }
                strip.push(corner);
                let [.., a, b, c] = strip[..] else { return Ok(()) };
                // A corner that is repeated turns the strip, and makes no triangle.
                if a == b || b == c || c == a {
                    return Ok(());
                }
                self.faces.push(Face { start: self.corners.len(), place });
                let is_turned = strip.len().is_multiple_of(2);
                let triangle = if is_turned { [b, a, c] } else { [a, b, c] };
                triangle.into_iter().try_for_each(|corner| add_corner(&mut self.corners, corner, place))
            })?;
        }
        Ok(())
    }

    /// Adds the faces to a mesh.
    pub(super) fn add_faces(&self, mesh: &mut Mesh) -> Result<(), Refusal> {
        let object = mesh.object(None);
        let ends = self.faces.iter().skip(1).map(|face| face.start).chain([self.corners.len()]);
        for (Face { start, place }, end) in self.faces.iter().zip(ends) {
            let corners: Result<Vec<DVec3>, Refusal> =
                self.corners[*start..end].iter().map(|number| self.vertex(*number, *place)).collect();
            let coat = Coat { object, material: None, sides: Sides::Open };
            let corners = corners?;
            let numbers = self.corners[*start..end].iter();
            let normals = numbers.filter_map(|number| self.normals.get(*number as usize).copied()).collect();
            mesh.note_normals(&FaceNormals { corners: &corners, normals }, coat.sides, *place);
            mesh.face(corners, coat, *place).map_err(|fault| fault.at(*place))?;
        }
        Ok(())
    }

    fn vertex(&self, number: f64, place: FilePlace) -> Result<DVec3, Refusal> {
        // The cast of what is below 0 or no number is 0, which then differs.
        let index = number as usize;
        match self.vertices.get(index).filter(|_| index as f64 == number) {
            Some(vertex) => Ok(*vertex),
            None => refuse_at(
                place,
                format!("the face has the vertex {number}; {} are listed, from 0 on", self.vertices.len()),
                "correct the number, or list the vertex",
            ),
        }
    }
}

/// Index of the property of an element that lists corners.
fn list_of_corners(element: &Element) -> Result<usize, Refusal> {
    let is_list = |property: &Property| property.count.is_some() && LISTS.contains(&property.name.as_str());
    element.properties.iter().position(is_list).ok_or_else(|| {
        let cause = format!("the elements '{}' have no list vertex_indices", short(&element.name));
        let cure = "add 'property list uchar int vertex_indices', or export the model with faces";
        Refusal::new(cause, cure).at(FilePlace::Line(element.line))
    })
}

/// Adds a corner to those of all faces.
fn add_corner(corners: &mut Vec<f64>, corner: f64, place: FilePlace) -> Result<(), Refusal> {
    corners.push(corner);
    match corners.len() <= MOST_ROWS {
        true => Ok(()),
        false => refuse_at(place, format!("the faces have more than {MOST_ROWS} corners"), "split the model"),
    }
}

/// Reads one element. `take` is given the index and each value of the properties that are `wanted`.
fn row(
    properties: &[Property],
    numbers: &mut dyn Numbers,
    wanted: &[usize],
    take: &mut dyn FnMut(usize, f64) -> Result<(), Refusal>,
) -> Result<(), Refusal> {
    for (index, property) in properties.iter().enumerate() {
        let count = match property.count {
            Some(scalar) => {
                let place = numbers.place();
                let count = numbers.number(scalar)?;
                length(count).ok_or_else(|| {
                    let cause = format!("the list '{}' has the length {count}", short(&property.name));
                    Refusal::new(cause, "correct its length, or export the model again").at(place)
                })?
            }
            None => 1,
        };
        match wanted.contains(&index) {
            true => (0..count).try_for_each(|_| take(index, numbers.number(property.item)?))?,
            false => numbers.skip(property.item, count)?,
        }
    }
    Ok(())
}

/// The length of a list.
fn length(count: f64) -> Option<usize> {
    let length = count as usize;
    (length as f64 == count && length <= MOST_ROWS).then_some(length)
}

/// Says what of an element is left out.
fn note(element: &Element, model: &mut Model) {
    let place = Some(FilePlace::Line(element.line));
    let is_colour = |property: &Property| property.name.ends_with("red") || property.name == "r";
    if element.count > 0 && element.properties.iter().any(is_colour) {
        model.note("colours are left out", place);
    }
    let is_material = |property: &Property| property.name == "material_index";
    if element.count > 0 && element.properties.iter().any(is_material) {
        model.note("materials by number are left out", place);
    }
    let is_texture = |property: &Property| TEXTURES.contains(&property.name.as_str());
    if element.count > 0 && element.properties.iter().any(is_texture) {
        model.note("texture coordinates are left out, and what textures they are of", place);
    }
    match element.name.as_str() {
        "vertex" | "face" | "tristrips" => {}
        "edge" => model.note("edges are left out", place),
        _ => model.note("elements other than vertices and faces are left out", place),
    }
}
