//! Models as OBJ and MTL.

use radiosity_fit::sides::back_of;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::fmt::Write;

use glam::DVec3;

use super::bridge::bridged;
use crate::format::Written;
use crate::model::{Material, Model, Shape, Sides, Surface};
use crate::names::UniqueNames;
use radiosity_photometry::error::{Refusal, refuse};

/// Writes a model of polygons and bilinear patches; `mtl_name` is the name that the file of materials will
/// have. Each surface is an object; one of two sides is two, the second `name:back`, since OBJ leaves sides
/// open. Holes are joined to their outlines by bridges, which keeps the area. `Ke` is the exitance over π.
///
/// # Errors
/// A curved surface, and bands other than one, or red, green and blue.
pub fn write(model: &Model, mtl_name: &str) -> Result<Written, Refusal> {
    let mut names = UniqueNames::default();
    let materials: Vec<String> =
        model.materials.iter().map(|material| names.take(&word(&material.name))).collect();
    let mut mtl = String::new();
    for (material, name) in model.materials.iter().zip(&materials) {
        add_material(&mut mtl, material, name)?;
    }
    let mut text = Text::default();
    if let Some(title) = &model.title {
        text.line(&format!("# {}", line(title)));
    }
    if !materials.is_empty() {
        text.line(&format!("mtllib {}", line(mtl_name)));
    }
    // A material holds for all that follows: surfaces without one come first.
    let mut surfaces: Vec<&Surface> = model.surfaces.iter().collect();
    surfaces.sort_by_key(|surface| surface.material.is_some());
    let mut current = None;
    for surface in surfaces {
        let corners = corners(surface)?;
        let numbers: Vec<String> = corners.iter().map(|x| text.vertex(*x).to_string()).collect();
        text.line(&format!("o {}", line(&surface.name)));
        if current != surface.material {
            current = surface.material;
            if let Some(name) = current.and_then(|index| materials.get(index)) {
                text.line(&format!("usemtl {name}"));
            }
        }
        text.line(&format!("f {}", numbers.join(" ")));
        if surface.sides == Sides::Both {
            text.line(&format!("o {}", back_of(&line(&surface.name))));
            text.line(&format!("f {}", numbers.into_iter().rev().collect::<Vec<_>>().join(" ")));
        }
    }
    Ok(Written { text: text.text, materials: Some(mtl) })
}

/// A text that grows, with the vertices that it lists.
#[derive(Default)]
struct Text {
    text: String,
    known: HashMap<[u64; 3], usize>,
}

impl Text {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    /// The number of a vertex, which is listed if it is new.
    fn vertex(&mut self, x: DVec3) -> usize {
        let key = x.to_array().map(f64::to_bits);
        if let Some(number) = self.known.get(&key) {
            return *number;
        }
        let number = self.known.len() + 1;
        self.known.insert(key, number);
        self.line(&format!("v {:?} {:?} {:?}", x.x, x.y, x.z));
        number
    }
}

/// The corners of a face.
fn corners(surface: &Surface) -> Result<Vec<DVec3>, Refusal> {
    match &surface.shape {
        Shape::Polygon { outline, holes } => Ok(bridged(outline, holes)),
        Shape::Quad(corners) => Ok(corners.to_vec()),
        curved => refuse(
            format!("the surface '{}' is a {}, which OBJ does not have", surface.name, curved.kind()),
            "write the model as toml, json or mgf",
        ),
    }
}

fn add_material(mtl: &mut String, material: &Material, name: &str) -> Result<(), Refusal> {
    let mut text = format!("newmtl {name}\n");
    for (keyword, values, unit) in [("Kd", &material.reflectance, 1.0), ("Ke", &material.emission, PI)] {
        let [r, g, b] = match values.as_slice() {
            [grey] => [*grey; 3],
            [r, g, b] => [*r, *g, *b],
            _ => {
                return refuse(
                    format!("the material '{}' has {} bands; MTL has 1 or 3", material.name, values.len()),
                    "write the model as toml or json",
                );
            }
        }
        .map(|value| value / unit);
        if keyword == "Kd" || [r, g, b] != [0.0; 3] {
            // Writing to a string does not fail.
            let _ = writeln!(text, "{keyword} {r:?} {g:?} {b:?}");
        }
    }
    mtl.push_str(&text);
    Ok(())
}

/// A name as one line without comment or continuation.
fn line(name: &str) -> String {
    let plain: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    plain.trim().replace('#', "_").replace('\\', "/")
}

/// A name as one word: programs end names of materials at blanks.
fn word(name: &str) -> String {
    line(name).split_whitespace().collect::<Vec<_>>().join("_")
}
