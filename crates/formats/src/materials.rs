//! Materials by name, from a file beside the scene: what formats without materials lack, and what others
//! state wrongly.
//!
//! ```toml
//! unit = "lx"              # of exitance and irradiance, where the format states none
//!
//! [materials.white]        # a material of the scene, or one that is used below
//! reflectance = 0.8        # one number, or one for each of red, green and blue; kept as it is where it is left out
//! emission = [10, 9, 7]    # exitance
//!
//! [materials."*"]          # of surfaces without a material
//! reflectance = 0.5
//!
//! [surfaces]               # which material a surface has; a * at the end stands for any ending
//! "lamp*" = "white"
//! ```

use std::collections::BTreeMap;
use std::ops::Range;

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::note_text::NoteText;
use serde::Deserialize;
use strsim::damerau_levenshtein;
use toml::Spanned;

use crate::model::{Material, Model};
use crate::tolerances::GREATEST;

/// The name of the material of surfaces without one.
const ANY: &str = "*";

/// A file of materials.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SideFile {
    /// Name of the file, for messages.
    pub name: String,
    /// Text of the file, TOML.
    pub text: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sheet {
    unit: Option<String>,
    #[serde(default)]
    materials: BTreeMap<Spanned<String>, Entry>,
    #[serde(default)]
    surfaces: BTreeMap<Spanned<String>, Spanned<String>>,
}

#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    reflectance: Option<Spanned<Values>>,
    emission: Option<Spanned<Values>>,
}

/// One number for all bands, or one for each.
#[derive(Clone, Debug, Deserialize)]
#[serde(untagged, expecting = "expected a number or a list of numbers")]
enum Values {
    One(f64),
    Each(Vec<f64>),
}

impl Values {
    fn all(&self) -> &[f64] {
        match self {
            Values::One(value) => std::slice::from_ref(value),
            Values::Each(values) => values,
        }
    }
}

/// Puts the materials of `side` in place of those of the model. Returns what was done, in lines. Names of the model in
/// cures are `shown` so.
///
/// # Errors
/// Text that is no TOML or has other keys; materials and surfaces that the model does not have; numbers out
/// of range, and lists whose length is not that of the bands.
pub fn apply(
    side: &SideFile,
    model: &mut Model,
    shown: &dyn Fn(&NoteText) -> String,
) -> Result<Vec<String>, Refusal> {
    let sheet: Sheet = toml::from_str(&side.text).map_err(|error| {
        let fault =
            Refusal::new(error.message().trim(), "write such as [materials.white] with reflectance = 0.8");
        side.refusal(fault, error.span().unwrap_or(0..0))
    })?;
    for (name, entry) in &sheet.materials {
        if !sheet.uses(name.get_ref(), model) {
            return Err(side.refusal(unknown_material(name.get_ref(), model, shown), name.span()));
        }
        for values in entry.values() {
            check(values.get_ref(), model).map_err(|fault| side.refusal(fault, values.span()))?;
        }
    }
    if sheet.materials.values().flat_map(Entry::values).any(|values| values.get_ref().all().len() == 3) {
        widen(model);
    }
    sheet.materials.iter().for_each(|(name, entry)| put(name.get_ref(), entry, model));
    let mut lines = vec![format!("{}: materials given: {}", side.name, sheet.names())];
    for (pattern, material) in &sheet.surfaces {
        let count = assign(pattern.get_ref(), material, model, shown).map_err(|(fault, is_material)| {
            side.refusal(fault, if is_material { material.span() } else { pattern.span() })
        })?;
        lines.push(format!(
            "{}: material {:?} for {:?}, {count} found",
            side.name,
            material.get_ref(),
            pattern.get_ref()
        ));
    }
    fill(model);
    if let Some(unit) = sheet.unit {
        model.unit = Some(unit);
    }
    Ok(lines)
}

impl Sheet {
    /// Whether the material `name` is one of the model, or is given to surfaces.
    fn uses(&self, name: &str, model: &Model) -> bool {
        name == ANY
            || model.materials.iter().any(|own| own.name == name)
            || self.surfaces.values().any(|own| own.get_ref() == name)
    }

    fn names(&self) -> String {
        let names: Vec<&str> = self.materials.keys().map(|name| name.get_ref().as_str()).collect();
        if names.is_empty() { "none".to_owned() } else { names.join(", ") }
    }
}

impl Entry {
    fn values(&self) -> impl Iterator<Item = &Spanned<Values>> {
        [&self.reflectance, &self.emission].into_iter().flatten()
    }
}

impl SideFile {
    /// The refusal for a fault at these bytes.
    fn refusal(&self, fault: Refusal, span: Range<usize>) -> Refusal {
        let before = self.text.get(..span.start).unwrap_or(&self.text);
        fault.in_line(&self.name, 1 + before.matches('\n').count())
    }
}

/// Refuses numbers that are no reflectance or exitance, and lists of other lengths than 1, 3 and that of the
/// bands.
fn check(values: &Values, model: &Model) -> Result<(), Refusal> {
    let (count, bands) = (values.all().len(), model.bands.len());
    let fits = [1, bands].contains(&count) || bands == 1 && count == 3;
    if !fits {
        let bands = model.bands.join(", ");
        return refuse(
            format!("there are {count} numbers, the bands are {bands}"),
            "give one number, or one per band",
        );
    }
    match values.all().iter().find(|value| !(0.0..=GREATEST).contains(*value)) {
        Some(value) => {
            refuse(format!("{value} is no reflectance or exitance"), "give a finite number, 0 or above")
        }
        None => Ok(()),
    }
}

/// Red, green and blue instead of one band.
fn widen(model: &mut Model) {
    if model.bands.len() != 1 {
        return;
    }
    model.bands = ["r", "g", "b"].map(str::to_owned).to_vec();
    model.values_mut().for_each(|values| *values = vec![values[0]; 3]);
}

/// Replaces what an entry states of the material `name`, or adds the material.
fn put(name: &str, entry: &Entry, model: &mut Model) {
    let bands = model.bands.len();
    let index = model.materials.iter().position(|own| own.name == name).unwrap_or_else(|| {
        let black = || vec![0.0; bands];
        model.materials.push(Material { name: name.to_owned(), reflectance: black(), emission: black() });
        model.materials.len() - 1
    });
    let material = &mut model.materials[index];
    let own = [&mut material.reflectance, &mut material.emission];
    for (own, given) in own.into_iter().zip([&entry.reflectance, &entry.emission]) {
        if let Some(given) = given {
            *own = match given.get_ref().all() {
                [value] => vec![*value; bands],
                values => values.to_vec(),
            };
        }
    }
}

/// Gives surfaces a material; returns how many. An error says whether it is one of the material.
fn assign(
    pattern: &str,
    material: &Spanned<String>,
    model: &mut Model,
    shown: &dyn Fn(&NoteText) -> String,
) -> Result<usize, (Refusal, bool)> {
    let name = material.get_ref();
    let Some(index) = model.materials.iter().position(|own| own.name == *name) else {
        return Err((unknown_material(name, model, shown), true));
    };
    let mut count = 0;
    for surface in model.surfaces.iter_mut().filter(|own| is_match(pattern, &own.name)) {
        surface.material = Some(index);
        count += 1;
    }
    match count {
        0 => {
            let names = model.surfaces.iter().map(|own| own.name.as_str());
            let cure = shown(&meant(pattern, names, "surfaces"));
            Err((Refusal::new(format!("no surface is called {pattern:?}"), cure), false))
        }
        count => Ok(count),
    }
}

/// Gives the material `*` to surfaces without one.
fn fill(model: &mut Model) {
    let Some(index) = model.materials.iter().position(|own| own.name == ANY) else { return };
    model.surfaces.iter_mut().for_each(|own| own.material = own.material.or(Some(index)));
}

fn is_match(pattern: &str, name: &str) -> bool {
    match pattern.strip_suffix('*') {
        Some(start) => name.starts_with(start),
        None => name == pattern,
    }
}

fn unknown_material(name: &str, model: &Model, shown: &dyn Fn(&NoteText) -> String) -> Refusal {
    let names = model.materials.iter().map(|own| own.name.as_str());
    Refusal::new(format!("the scene has no material {name:?}"), shown(&meant(name, names, "materials")))
}

/// The nearest of the names there are, or a few of them.
fn meant<'a>(name: &str, known: impl Iterator<Item = &'a str>, what: &str) -> NoteText {
    let known: Vec<&str> = known.collect();
    let near = known.iter().map(|own| (damerau_levenshtein(name, own), own)).min();
    match near {
        None => NoteText::own(format!(
            "the file has no {what}: give surfaces one below [surfaces], such as \"*\" = {name:?}"
        )),
        Some((edits, near)) if edits <= 1 + name.chars().count() / 3 => {
            NoteText::from("did you mean ").naming(near).then("?")
        }
        Some(_) => NoteText::own(format!("{what} of the scene: ")).naming_all(&known),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Shape, Sides, Surface};

    /// Two lamps and a wall; the wall is white, the lamps have no material.
    fn model() -> Model {
        let surface = |name: &str, material| Surface {
            name: name.to_owned(),
            material,
            shape: Shape::Sphere { center: glam::DVec3::ZERO, radius: 1.0, inward: false },
            sides: Sides::Front,
            file: None,
            place: None,
        };
        Model {
            bands: vec!["grey".to_owned()],
            materials: vec![Material {
                name: "white".to_owned(),
                reflectance: vec![0.5],
                emission: vec![0.0],
            }],
            surfaces: vec![surface("lamp-1", None), surface("lamp-2", None), surface("wall", Some(0))],
            ..Model::default()
        }
    }

    fn applied(text: &str) -> Result<Model, Refusal> {
        let mut model = model();
        apply(
            &SideFile { name: "m.toml".to_owned(), text: text.to_owned() },
            &mut model,
            &NoteText::to_string,
        )?;
        Ok(model)
    }

    #[test]
    fn what_is_left_out_stays() {
        let white = &applied("[materials.white]\nemission = 3").unwrap().materials[0];
        assert_eq!((&white.reflectance, &white.emission), (&vec![0.5], &vec![3.0]));
    }

    #[test]
    fn the_unit_of_the_file_is_that_of_the_scene() {
        assert_eq!(applied("unit = \"lx\"").unwrap().unit.as_deref(), Some("lx"));
        assert_eq!(applied("").unwrap().unit, None);
    }

    #[test]
    fn three_numbers_make_a_grey_scene_coloured() {
        let model = applied("[materials.\"*\"]\nreflectance = [0.1, 0.2, 0.3]").unwrap();
        assert_eq!(model.bands, ["r", "g", "b"]);
        assert_eq!(model.materials[0].reflectance, [0.5; 3]);
        assert_eq!(model.materials[1].reflectance, [0.1, 0.2, 0.3]);
        assert_eq!(
            model.surfaces.iter().map(|own| own.material).collect::<Vec<_>>(),
            [Some(1), Some(1), Some(0)]
        );
    }

    #[test]
    fn surfaces_get_materials_by_the_start_of_their_names() {
        let text = "[materials.glow]\nemission = 10\n[surfaces]\n\"lamp*\" = \"glow\"";
        let model = applied(text).unwrap();
        assert_eq!(
            model.surfaces.iter().map(|own| own.material).collect::<Vec<_>>(),
            [Some(1), Some(1), Some(0)]
        );
    }

    #[test]
    fn refusals_have_a_line_and_a_cure() {
        for (text, line, cause, cure) in [
            ("[materials.white]\nreflectance = nan", 2, "NaN is no", "finite"),
            ("[materials.white]\nreflectance = -1", 2, "-1 is no", "finite"),
            ("[materials.white]\nreflectance = [1, 2]", 2, "2 numbers", "one per band"),
            ("[materials.white]\nreflectance = \"a\"", 2, "a number or a list", "write such as"),
            ("[materials.white]\ncolour = 1", 2, "unknown field", "write such as"),
            ("\n[materials.whte]\nreflectance = 1", 2, "no material \"whte\"", "did you mean \"white\"?"),
            ("[surfaces]\nlamp-3 = \"white\"", 2, "no surface is called \"lamp-3\"", "did you mean"),
            ("[surfaces]\nwall = \"black\"", 2, "no material \"black\"", "white"),
            ("[", 1, "", "write such as"),
        ] {
            let refusal = applied(text).unwrap_err();
            assert_eq!(
                refusal.place,
                Some(radiosity_photometry::file_place::FilePlace::Line(line)),
                "{text}: {refusal}"
            );
            assert!(refusal.cause.contains(cause) && refusal.cure.contains(cure), "{text}: {refusal:?}");
        }
    }
}
