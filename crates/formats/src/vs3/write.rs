//! Writes a model as View3D input. Polygons of more than four corners, with holes or with a notch become
//! convex pieces `name#1`, `name#2`, …, which View3D combines into one again.

use radiosity_fit::sides::back_of;
use std::collections::HashMap;
use std::fmt::Write;

use glam::DVec3;

use super::statements::OBSTRUCTION;
use crate::colour::luminance;
use crate::model::{Material, Model, Shape, Sides, Surface};
use crate::tolerances::STEPS_OF_EMITTANCE;
use radiosity_photometry::error::{Refusal, refuse};

/// The text of a model. View3D has one band and no emission: the emittance is 1 − ρ, with ρ the luminance of
/// three bands and the mean of others; emission is left out. A surface of two sides becomes two surfaces, the
/// second `name:back`; [`Sides::Open`] is written as the front. Surfaces of a material `obstruction` become
/// obstructions.
///
/// # Errors
/// A curved surface, or an outline that crosses itself.
pub fn write(model: &Model) -> Result<String, Refusal> {
    let mut sheet = Sheet::default();
    let is_obstruction =
        |surface: &&Surface| material(model, surface).is_some_and(|material| material.name == OBSTRUCTION);
    // View3D wants obstructions behind all else.
    for surface in model.surfaces.iter().filter(|surface| !is_obstruction(surface)) {
        let ending = format!("{:?}", emittance(material(model, surface)));
        sheet.add(surface, 'S', &ending)?;
    }
    for surface in model.surfaces.iter().filter(is_obstruction) {
        sheet.add(surface, 'O', "1.0")?;
    }
    let title = model.title.as_deref().unwrap_or("radiosity");
    let title: String = title.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    Ok(format!(
        "T {title}\nC encl=0 list=1 eps=1.0e-4 emit=1 out=1\nF 3\n! number x y z\n{}! number v1 v2 v3 v4 base cmb \
         emit name\n{}End of data\n",
        sheet.vertices, sheet.surfaces
    ))
}

fn material<'a>(model: &'a Model, surface: &Surface) -> Option<&'a Material> {
    model.materials.get(surface.material?)
}

fn emittance(material: Option<&Material>) -> f64 {
    let reflectance = match material.map(|material| material.reflectance.as_slice()) {
        None | Some([]) => 0.0,
        Some([r, g, b]) => luminance([*r, *g, *b]),
        Some(values) => values.iter().sum::<f64>() / values.len() as f64,
    };
    ((1.0 - reflectance).clamp(0.0, 1.0) * STEPS_OF_EMITTANCE).round() / STEPS_OF_EMITTANCE
}

/// Lines of vertices and of surfaces.
#[derive(Default)]
struct Sheet {
    vertices: String,
    surfaces: String,
    /// Numbers of vertices by the bits of their coordinates.
    numbers: HashMap<[u64; 3], usize>,
    count: usize,
}

impl Sheet {
    /// Lines of a surface, and of its back if it has two sides.
    fn add(&mut self, surface: &Surface, letter: char, emittance: &str) -> Result<(), Refusal> {
        let Shape::Polygon { outline, holes } = &surface.shape else {
            let kind = if let Shape::Quad(_) = surface.shape { "curved patch" } else { surface.shape.kind() };
            return refuse(
                format!("surface \"{}\" is a {kind}, View3D has flat surfaces only", surface.name),
                "write it in another format, or put polygons in its place",
            );
        };
        let mut pieces = surface.pieces(outline, holes)?;
        self.add_pieces(&surface.name, &pieces, letter, emittance);
        if surface.sides == Sides::Both {
            pieces.iter_mut().for_each(|piece| piece.reverse());
            self.add_pieces(&back_of(&surface.name), &pieces, letter, emittance);
        }
        Ok(())
    }

    fn add_pieces(&mut self, name: &str, pieces: &[Vec<DVec3>], letter: char, emittance: &str) {
        let name = printable(name);
        let first = self.count + 1;
        for (index, piece) in pieces.iter().enumerate() {
            self.count += 1;
            let mut numbers: Vec<usize> = piece.iter().map(|point| self.vertex(*point)).collect();
            numbers.resize(4, 0);
            let numbers: Vec<String> = numbers.iter().map(usize::to_string).collect();
            let combined = if index > 0 && letter == 'S' { first } else { 0 };
            let part = if pieces.len() > 1 { format!("#{}", index + 1) } else { String::new() };
            line(
                &mut self.surfaces,
                format_args!(
                    "{letter} {} {} 0 {combined} {emittance} {name}{part}",
                    self.count,
                    numbers.join(" ")
                ),
            );
        }
    }

    /// Number of the vertex at `point`.
    fn vertex(&mut self, point: DVec3) -> usize {
        let next = self.numbers.len() + 1;
        // + 0: −0 and 0 are one place.
        let bits = point.to_array().map(|x| (x + 0.0).to_bits());
        let number = *self.numbers.entry(bits).or_insert(next);
        if number == next {
            line(&mut self.vertices, format_args!("V {number} {:?} {:?} {:?}", point.x, point.y, point.z));
        }
        number
    }
}

fn line(text: &mut String, words: std::fmt::Arguments<'_>) {
    // Writing to a string cannot fail.
    let _ = writeln!(text, "{words}");
}

/// A name of one word that neither begins a comment nor ends the data.
fn printable(name: &str) -> String {
    let replaced = |c: char| c.is_whitespace() || c.is_control() || matches!(c, ',' | '!');
    let word: String = name.trim().chars().map(|c| if replaced(c) { '_' } else { c }).collect();
    match word.strip_prefix(['*', '/']) {
        Some(rest) => format!("_{rest}"),
        None => word,
    }
}
