//! MTL: the diffuse part of materials.

use std::collections::HashMap;
use std::collections::hash_map::Entry;

use radiosity_photometry::error::{Refusal, refuse, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::{number, short};

use super::statements::{split, statements};
use crate::colour::{TEXTURED, TEXTURED_EMISSION, UNKNOWN};
use crate::tolerances::GREATEST;

const TEXTURES: &str = "textures are left out";
const SPECULAR: &str = "specular reflection is left out";
const AMBIENT: &str = "a Ka above 1 is left out: a lamp has Ke";
const TRANSPARENCY: &str = "transparency is left out";

/// A material of an MTL.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Mtl {
    /// `Kd` and `Ke`, red, green and blue.
    diffuse: Option<[f64; 3]>,
    radiance: [f64; 3],
    /// The first colour that is none, which counts where the material is used.
    pub(super) fault: Option<Refusal>,
    /// Remarks on properties that are left out, each kind once.
    pub(super) left_out: Vec<NoteText>,
    /// `Ks`, and whether `illum` makes a mirror of it.
    specular: Option<[f64; 3]>,
    is_mirror: bool,
    /// `Pc`, and whether a roughness of such a coat is stated.
    coat: Option<f64>,
    has_rough_coat: bool,
}

/// Adds the materials of a text, that of `file`, to those that are known.
pub(super) fn read(text: &str, file: &str, known: &mut HashMap<String, Mtl>) -> Result<(), Refusal> {
    let mut current: Option<(String, Mtl)> = None;
    for (line, statement) in statements(text) {
        let (keyword, rest) = split(&statement);
        if keyword.eq_ignore_ascii_case("newmtl") {
            let next = (rest.to_owned(), Mtl::default());
            add(current.replace(next), known);
            continue;
        }
        let Some((_, mtl)) = &mut current else {
            return refuse_at(
                FilePlace::Line(line),
                format!("'{}' stands before the first material", short(keyword)),
                "begin each material with 'newmtl NAME'",
            );
        };
        if let Err(fault) = mtl.statement(keyword, rest) {
            mtl.fault.get_or_insert(fault.at(FilePlace::Line(line)).in_file(file));
        }
    }
    add(current, known);
    Ok(())
}

/// Adds a material, if none of its name is known.
fn add(mtl: Option<(String, Mtl)>, known: &mut HashMap<String, Mtl>) {
    let Some((name, mut mtl)) = mtl else { return };
    mtl.settle();
    match known.entry(name) {
        Entry::Vacant(entry) => drop(entry.insert(mtl)),
        Entry::Occupied(mut entry) => {
            let again = NoteText::from("the material ")
                .quoting(format!("'{}'", short(entry.key())))
                .then(" is described again with other values: the first ones are taken");
            let first = entry.get_mut();
            if [first.reflectance(), first.radiance()] != [mtl.reflectance(), mtl.radiance()] {
                first.leave_out(again);
            }
        }
    }
}

impl Mtl {
    /// Reflectance of red, green and blue: `Kd`, times the mean of what `map_Kd` names. Black without both.
    pub(super) fn reflectance(&self) -> [f64; 3] {
        match (self.diffuse, self.has(TEXTURED)) {
            (stated, true) => stated.unwrap_or([1.0; 3]).map(|value| UNKNOWN * value),
            (stated, false) => stated.unwrap_or_default(),
        }
    }

    /// Radiance of red, green and blue: `Ke`, or 0 where a texture tells what shines.
    pub(super) fn radiance(&self) -> [f64; 3] {
        if self.has(TEXTURED_EMISSION) { [0.0; 3] } else { self.radiance }
    }

    fn statement(&mut self, keyword: &str, rest: &str) -> Result<(), Refusal> {
        match keyword.to_ascii_lowercase().as_str() {
            "kd" => self.diffuse = Some(colour(rest, "Kd")?),
            "ke" => self.radiance = colour(rest, "Ke")?,
            "ka" if colour(rest, "Ka").is_ok_and(|colour| colour.iter().any(|value| *value > 1.0)) => {
                self.leave_out(AMBIENT);
            }
            "ks" => self.specular = colour(rest, "Ks").ok(),
            // Mirrors by rays or by a map; then glass and refraction.
            "illum" if ["3", "5", "8"].contains(&rest) => self.is_mirror = true,
            "illum" if ["4", "6", "7", "9"].contains(&rest) => self.leave_out(TRANSPARENCY),
            // All of the light or nothing is what programs write for opaque materials.
            "tf" if colour(rest, "Tf").is_ok_and(|colour| ![[0.0; 3], [1.0; 3]].contains(&colour)) => {
                self.leave_out(TRANSPARENCY);
            }
            "d" if last(rest).is_some_and(|d| d < 1.0) => self.leave_out(TRANSPARENCY),
            // Programs write 0 for opaque, as transparency, or 1, as its opposite.
            "tr" if last(rest).is_some_and(|tr| tr > 0.0 && tr < 1.0) => self.leave_out(TRANSPARENCY),
            "pc" => self.coat = last(rest),
            "pcr" => self.has_rough_coat = last(rest).is_some_and(|share| share > 0.0),
            "pm" | "ps" | "aniso" if last(rest).is_some_and(|share| share != 0.0) => self.leave_out(SPECULAR),
            "map_kd" => self.leave_out(TEXTURED),
            "map_ke" => self.leave_out(TEXTURED_EMISSION),
            "bump" | "disp" | "decal" | "refl" | "norm" => self.leave_out(TEXTURES),
            map if map.starts_with("map_") => self.leave_out(TEXTURES),
            _ => {}
        }
        Ok(())
    }

    /// Takes what several statements say together: a mirror of which no part reflects is none, nor is a coat.
    fn settle(&mut self) {
        let reflects = self.specular.map_or(self.is_mirror, |colour| colour != [0.0; 3]);
        let is_coated = self.coat.map_or(self.has_rough_coat, |share| share > 0.0);
        if reflects || is_coated {
            self.leave_out(SPECULAR);
        }
    }

    fn has(&self, what: &str) -> bool {
        self.left_out.iter().any(|own| own.as_str() == what)
    }

    fn leave_out(&mut self, what: impl Into<NoteText>) {
        let what = what.into();
        if !self.has(&what) {
            self.left_out.push(what);
        }
    }
}

/// The last word, if it is a number: options stand before it.
fn last(rest: &str) -> Option<f64> {
    rest.split_whitespace().next_back()?.parse().ok()
}

/// Red, green and blue; one number stands for all three.
fn colour(rest: &str, what: &str) -> Result<[f64; 3], Refusal> {
    let words: Vec<&str> = rest.split_whitespace().collect();
    let values: [f64; 3] = match words.as_slice() {
        [one] => [number(one, what)?; 3],
        [kind @ ("spectral" | "xyz"), ..] => {
            return refuse(format!("{what} is given as '{kind}'"), "give it as red, green and blue");
        }
        [r, g, b] => [number(r, what)?, number(g, what)?, number(b, what)?],
        _ => {
            return refuse(
                format!("{what} has {} numbers", words.len()),
                "give it red, green and blue, or one number",
            );
        }
    };
    match values.iter().find(|value| !(0.0..=GREATEST).contains(*value)) {
        Some(value) if *value < 0.0 => refuse(format!("{what} is {value}, below 0"), "correct it"),
        Some(_) => refuse(format!("{what} is beyond {GREATEST:e}"), "correct it"),
        None => Ok(values),
    }
}
