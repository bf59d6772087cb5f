//! Writes a model as MGF. Names of objects are those of the surfaces; holes are written by `fh`.

use std::collections::HashMap;
use std::fmt::Write;

use glam::DVec3;

use crate::colour::{chromaticity, luminance};
use crate::model::{Material, Model, Shape, Sides, Surface};
use crate::names::UniqueNames;
use radiosity_photometry::error::{Refusal, refuse};

/// The text of a model; reading it gives the model back but for rounding, the title, the unit, the camera,
/// the names of bands other than red, green and blue, and blanks in names. MGF's materials have two sides
/// unless they are one-sided: [`Sides::Open`] is written as both, and surfaces without a material are black.
///
/// # Errors
/// Models that MGF has no words for: bands that are neither one nor three, a torus that overlaps itself.
pub fn write(model: &Model) -> Result<String, Refusal> {
    if !matches!(model.bands.len(), 1 | 3) {
        return refuse(
            format!("MGF has no words for {} bands", model.bands.len()),
            "write another format, or a model of one band or of red, green and blue",
        );
    }
    let mut text = String::new();
    if let Some(title) = &model.title {
        line(&mut text, &format!("# {}", printable(title, " ")));
    }
    let mut names = UniqueNames::default();
    let names: Vec<String> =
        model.materials.iter().map(|material| names.take(&printable(&material.name, "_"))).collect();
    for (material, name) in model.materials.iter().zip(&names) {
        write_material(&mut text, material, name);
    }
    let (mut states, mut current) = (HashMap::new(), None);
    let mut surface_names = UniqueNames::default();
    for surface in &model.surfaces {
        choose(&mut text, surface, &names, &mut states, &mut current);
        let name = surface_names.take(&printable(&surface.name, "_"));
        line(&mut text, &format!("o {name}"));
        write_shape(&mut text, surface)?;
        line(&mut text, "o");
    }
    Ok(text)
}

fn line(text: &mut String, words: &str) {
    text.push_str(words);
    text.push('\n');
}

/// `name` without blanks, control characters and backslashes, which end words or join lines.
fn printable(name: &str, instead: &str) -> String {
    let replaced = |c: char| c.is_whitespace() || c.is_control() || c == '\\';
    name.trim().chars().map(|c| if replaced(c) { instead.to_owned() } else { c.to_string() }).collect()
}

fn write_material(text: &mut String, material: &Material, name: &str) {
    line(text, &format!("m {name} ="));
    for (entity, values) in [("rd", &material.reflectance), ("ed", &material.emission)] {
        if values.iter().all(|value| *value == 0.0) {
            continue;
        }
        line(text, "\tc");
        let value = match values[..] {
            [r, g, b] if r == g && g == b => r,
            [r, g, b] => {
                let [x, y] = chromaticity([r, g, b]);
                line(text, &format!("\t\tcxy {x:?} {y:?}"));
                luminance([r, g, b])
            }
            _ => values[0],
        };
        line(text, &format!("\t{entity} {value:?}"));
    }
}

/// The material that is current.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Choice {
    /// Its index; None for the unnamed one.
    material: Option<usize>,
    /// Whether its front alone counts.
    is_single: bool,
}

/// Makes the material of a surface the current one, with the sides of this surface.
fn choose(
    text: &mut String,
    surface: &Surface,
    names: &[String],
    states: &mut HashMap<Option<usize>, bool>,
    current: &mut Option<Choice>,
) {
    let is_single = surface.sides == Sides::Front;
    let choice = Choice { material: surface.material, is_single };
    if *current == Some(choice) {
        return;
    }
    match surface.material.and_then(|index| names.get(index)) {
        Some(name) => line(text, &format!("m {name}")),
        // The unnamed material forgets its sides.
        None => {
            line(text, "m");
            states.remove(&surface.material);
        }
    }
    if states.get(&surface.material).copied().unwrap_or(false) != is_single {
        line(text, if is_single { "\tsides 1" } else { "\tsides 2" });
        states.insert(surface.material, is_single);
    }
    *current = Some(choice);
}

/// Defines a vertex anew.
fn vertex(text: &mut String, id: &str, point: DVec3, normal: Option<DVec3>) {
    line(text, &format!("v {id} ="));
    line(text, &format!("\tp {:?} {:?} {:?}", point.x, point.y, point.z));
    if let Some(normal) = normal {
        line(text, &format!("\tn {:?} {:?} {:?}", normal.x, normal.y, normal.z));
    }
}

fn write_shape(text: &mut String, surface: &Surface) -> Result<(), Refusal> {
    let sign = |inward: bool| if inward { -1.0 } else { 1.0 };
    // A zero keeps no sign.
    let signed = |inward: bool, radius: f64| if radius == 0.0 { 0.0 } else { sign(inward) * radius };
    match surface.shape {
        Shape::Polygon { ref outline, ref holes } => write_face(text, outline, holes),
        Shape::Quad(ref corners) => write_face(text, corners, &[]),
        Shape::Disk { center, normal, radius, inner } => {
            vertex(text, "a", center, Some(normal));
            line(text, &format!("ring a {inner:?} {radius:?}"));
        }
        Shape::Cylinder { base, axis, radius, inward } => {
            vertex(text, "a", base, None);
            vertex(text, "b", base + axis, None);
            line(text, &format!("cyl a {:?} b", signed(inward, radius)));
        }
        Shape::Cone { base, axis, radii, inward } => {
            vertex(text, "a", base, None);
            vertex(text, "b", base + axis, None);
            let [first, second] = radii.map(|radius| signed(inward, radius));
            line(text, &format!("cone a {first:?} b {second:?}"));
        }
        Shape::Sphere { center, radius, inward } => {
            vertex(text, "a", center, None);
            line(text, &format!("sph a {:?}", signed(inward, radius)));
        }
        Shape::Torus { center, axis, major, minor, inward } => {
            if major < minor {
                return refuse(
                    format!("MGF has no words for a torus that overlaps itself: {}", surface.name),
                    "write another format, or make its tube thinner",
                );
            }
            vertex(text, "a", center, Some(axis));
            let [least, most] = [major - minor, major + minor].map(|radius| signed(inward, radius));
            line(text, &format!("torus a {least:?} {most:?}"));
        }
    }
    Ok(())
}

fn write_face(text: &mut String, outline: &[DVec3], holes: &[Vec<DVec3>]) {
    let mut words = String::from(if holes.is_empty() { "f" } else { "fh" });
    let mut count = 0;
    for (index, points) in std::iter::once(outline).chain(holes.iter().map(Vec::as_slice)).enumerate() {
        words.push_str(if index > 0 { " -" } else { "" });
        for point in points {
            count += 1;
            vertex(text, &format!("v{count}"), *point, None);
            // Writing to a text does not fail.
            let _ = write!(words, " v{count}");
        }
    }
    line(text, &words);
}
