//! MTL: the diffuse part of materials.

use std::collections::HashMap;
use std::collections::hash_map::Entry;
use std::sync::Arc;

use radiosity_photometry::error::{Refusal, refuse, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::{number, short};

use super::statements::{split, statements};
use crate::colour::{TEXTURED, TEXTURED_EMISSION, UNKNOWN};
use crate::tolerances::GREATEST;

const TEXTURES: &str = "textures are left out";
const SPECULAR: &str = "specular reflection is left out";
const AMBIENT: &str = "a Ka above 1 is left out: a lamp has Ke";
const TRANSPARENCY: &str = "transparency is left out";

/// Something that a line states to be there, or not.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Stated {
    is_there: bool,
    line: usize,
}

/// Reflection that `illum` chooses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Illumination {
    /// Whatever the other statements say.
    #[default]
    Stated,
    /// Matte surfaces: `Ks` does not apply.
    Matte,
    /// Mirrors, stated in this line.
    Mirror(usize),
}

/// A material of an MTL.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mtl {
    /// Name of its file.
    file: Arc<str>,
    /// Line at which it begins.
    line: usize,
    /// `Kd` and `Ke`, red, green and blue.
    diffuse: Option<[f64; 3]>,
    radiance: [f64; 3],
    /// The first colour that is none, which counts where the material is used.
    pub(super) fault: Option<Refusal>,
    /// Notes on properties that are left out, each kind once.
    pub(super) left_out: Vec<Note>,
    /// `Ks`, and what `illum` makes of it.
    specular: Option<Stated>,
    illumination: Illumination,
    /// `Pc`, and a roughness of such a coat.
    coat: Option<Stated>,
    rough_coat: Option<Stated>,
}

/// Adds the materials of a text, that of `file`, to those that are known.
pub(super) fn read(text: &str, file: &str, known: &mut HashMap<String, Mtl>) -> Result<(), Refusal> {
    let file: Arc<str> = file.into();
    let mut current: Option<(String, Mtl)> = None;
    for (line, statement) in statements(text) {
        let (keyword, rest) = split(&statement);
        if keyword.eq_ignore_ascii_case("newmtl") {
            let next = (rest.to_owned(), Mtl::begun(&file, line));
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
        if let Err(fault) = mtl.statement(keyword, rest, line) {
            mtl.fault.get_or_insert(fault.in_line(&file, line));
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
                first.put(Note {
                    text: again,
                    file: Some(mtl.file),
                    place: Some(FilePlace::Line(mtl.line)),
                    count: 1,
                });
            }
        }
    }
}

impl Mtl {
    /// A black material that begins in a line.
    fn begun(file: &Arc<str>, line: usize) -> Self {
        Self {
            file: Arc::clone(file),
            line,
            diffuse: None,
            radiance: [0.0; 3],
            fault: None,
            left_out: Vec::new(),
            specular: None,
            illumination: Illumination::default(),
            coat: None,
            rough_coat: None,
        }
    }

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

    fn statement(&mut self, keyword: &str, rest: &str, line: usize) -> Result<(), Refusal> {
        let stated = |is_there| Stated { is_there, line };
        match keyword.to_ascii_lowercase().as_str() {
            "kd" => self.diffuse = Some(colour(rest, "Kd")?),
            "ke" => self.radiance = colour(rest, "Ke")?,
            "ka" if colour(rest, "Ka").is_ok_and(|colour| colour.iter().any(|value| *value > 1.0)) => {
                self.leave_out(AMBIENT, line);
            }
            "ks" => {
                let reflects = is_any(rest, "Ks", |colour| *colour != [0.0; 3]);
                self.specular = reflects.map(stated);
            }
            "illum" => {
                self.illumination = match rest {
                    "0" | "1" => Illumination::Matte,
                    // By rays or by a map.
                    "3" | "5" | "8" => Illumination::Mirror(line),
                    _ => Illumination::Stated,
                };
                // Glass and refraction.
                if ["4", "6", "7", "9"].contains(&rest) {
                    self.leave_out(TRANSPARENCY, line);
                }
            }
            // All of the light or nothing is what programs write for opaque materials.
            "tf" if is_any(rest, "Tf", |colour| ![[0.0; 3], [1.0; 3]].contains(colour)) == Some(true) => {
                self.leave_out(TRANSPARENCY, line);
            }
            "d" if last(rest).is_some_and(|d| d < 1.0) => self.leave_out(TRANSPARENCY, line),
            // Programs write 0 for opaque, as transparency, or 1, as its opposite.
            "tr" if last(rest).is_some_and(|tr| tr > 0.0 && tr < 1.0) => self.leave_out(TRANSPARENCY, line),
            "pc" => self.coat = last(rest).map(|share| stated(share > 0.0)),
            "pcr" => self.rough_coat = last(rest).map(|share| stated(share > 0.0)),
            "pm" | "ps" | "aniso" if last(rest).is_some_and(|share| share != 0.0) => {
                self.leave_out(SPECULAR, line);
            }
            "map_kd" => self.leave_out(TEXTURED, line),
            "map_ke" => self.leave_out(TEXTURED_EMISSION, line),
            "bump" | "disp" | "decal" | "refl" | "norm" => self.leave_out(TEXTURES, line),
            map if map.starts_with("map_") => self.leave_out(TEXTURES, line),
            _ => {}
        }
        Ok(())
    }

    /// Takes what several statements say together: a mirror of which no part reflects is none, nor is a coat, and
    /// matte surfaces have none.
    fn settle(&mut self) {
        let specular = match self.illumination {
            Illumination::Matte => None,
            Illumination::Stated => self.specular,
            Illumination::Mirror(line) => self.specular.or(Some(Stated { is_there: true, line })),
        };
        let coat = self.coat.or(self.rough_coat);
        for Stated { line, .. } in [specular, coat].into_iter().flatten().filter(|own| own.is_there) {
            self.leave_out(SPECULAR, line);
        }
    }

    fn has(&self, what: &str) -> bool {
        self.left_out.iter().any(|own| own.text.as_str() == what)
    }

    fn leave_out(&mut self, what: &'static str, line: usize) {
        let (file, place) = (Some(Arc::clone(&self.file)), Some(FilePlace::Line(line)));
        self.put(Note { text: what.into(), file, place, count: 1 });
    }

    fn put(&mut self, note: Note) {
        if !self.has(&note.text) {
            self.left_out.push(note);
        }
    }
}

/// Whether a colour of any space is one of those that `is_meant` tells, as is one whose spectrum a file holds; none
/// where it is no colour.
fn is_any(rest: &str, what: &str, is_meant: impl Fn(&[f64; 3]) -> bool) -> Option<bool> {
    match rest.split_once(char::is_whitespace) {
        Some(("spectral", _)) => Some(true),
        Some(("xyz", numbers)) => colour(numbers, what).ok().as_ref().map(is_meant),
        _ => colour(rest, what).ok().as_ref().map(is_meant),
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
