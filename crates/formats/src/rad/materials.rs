//! Meanings of modifiers: the diffuse part of materials, and the materials behind patterns and aliases.
//!
//! Source: Radiance reference manual, "Materials", "Textures", "Patterns", "Mixtures".

use std::collections::HashMap;
use std::f64::consts::PI;
use std::rc::Rc;

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::note::Note;
use radiosity_photometry::text::short;

use crate::builder::Coat;
use crate::model::Sides;
use crate::rad::scanner::Primitive;

/// Effect of a modifier on a surface.
#[derive(Clone, Debug)]
pub(super) enum Meaning {
    /// The surface has this material.
    Coat(Rc<Coat>),
    /// The surface is left out; the text is the note on it.
    Absent(&'static str),
}

/// A modifier: its effect, and what is left out of it, told where a surface has it.
#[derive(Clone, Debug)]
pub(super) struct Modifier {
    pub(super) meaning: Meaning,
    pub(super) left_out: Vec<Note>,
}

/// The modifiers that were defined.
#[derive(Debug)]
pub(super) struct Materials {
    modifiers: HashMap<String, Modifier>,
}

impl Default for Materials {
    fn default() -> Self {
        let meaning = Meaning::Absent("surfaces without a material (void) are left out");
        let void = Modifier { meaning, left_out: Vec::new() };
        Self { modifiers: HashMap::from([("void".to_owned(), void)]) }
    }
}

impl Materials {
    /// The modifier `name`.
    ///
    /// # Errors
    /// A name that was not defined.
    pub(super) fn get(&self, name: &str) -> Result<&Modifier, Refusal> {
        self.modifiers.get(name).ok_or_else(|| {
            Refusal::new(
                format!("the modifier '{}' is not defined", short(name)),
                "define it above, or join the file of the materials and this one: !xform materials.rad",
            )
        })
    }

    /// Defines the modifier that a primitive is, where `note` makes notes on it; returns whether it is one.
    ///
    /// # Errors
    /// Unknown modifiers, too few numbers, numbers below 0.
    pub(super) fn define(
        &mut self,
        primitive: &Primitive,
        note: impl Fn(&'static str) -> Note,
    ) -> Result<bool, Refusal> {
        let nothing = |meaning| Modifier { meaning, left_out: Vec::new() };
        let (behind, own) = match primitive.kind.as_str() {
            "alias" => (self.named(primitive)?, Vec::new()),
            "texfunc" | "texdata" | "colorfunc" | "brightfunc" | "colordata" | "brightdata" | "colorpict"
            | "colortext" | "brighttext" | "spectrum" | "specfile" | "specfunc" | "specdata" | "specpict" => {
                (self.get(&primitive.modifier)?.clone(), vec!["patterns and textures are left out"])
            }
            "mixfunc" | "mixdata" | "mixpict" | "mixtext" => {
                (self.named(primitive)?, vec!["mixtures of materials are left out: the first of them counts"])
            }
            "antimatter" => {
                (nothing(Meaning::Absent("antimatter is left out: what it cuts stays whole")), Vec::new())
            }
            "mist" => (nothing(Meaning::Absent("mist is left out")), Vec::new()),
            _ => match coat(primitive)? {
                Some((coat, own)) => (nothing(Meaning::Coat(Rc::new(coat))), own),
                None => return Ok(false),
            },
        };
        let before = self.modifiers.get(&primitive.modifier).map(|own| own.left_out.as_slice());
        let all = behind.left_out.iter().chain(before.unwrap_or_default()).cloned();
        let left_out = each_once(all.chain(own.into_iter().map(note)));
        self.modifiers.insert(primitive.name.clone(), Modifier { meaning: behind.meaning, left_out });
        Ok(true)
    }

    /// The modifier that the first text names.
    fn named(&self, primitive: &Primitive) -> Result<Modifier, Refusal> {
        match primitive.strings.first() {
            Some(name) => self.get(name).cloned(),
            None => refuse(
                format!("the {} '{}' names no material", primitive.kind, short(&primitive.name)),
                "name one as its first text",
            ),
        }
    }
}

/// The first note of each text.
fn each_once(notes: impl Iterator<Item = Note>) -> Vec<Note> {
    let mut all: Vec<Note> = Vec::new();
    for note in notes {
        if all.iter().all(|own| own.text != note.text) {
            all.push(note);
        }
    }
    all
}

/// The diffuse part of a material and what is left out of it; none if it is no material.
fn coat(primitive: &Primitive) -> Result<Option<(Coat, Vec<&'static str>)>, Refusal> {
    let specular = "specular reflection is left out";
    let coat = match primitive.kind.as_str() {
        "light" | "illum" => return Ok(Some((lamp(primitive)?, Vec::new()))),
        "glow" => {
            // Manual, "Glow": 0 is none, and below 0 the surface lights nothing.
            let is_limited = primitive.reals.get(3).is_some_and(|radius| *radius != 0.0);
            let note = "the limit of how far glow shines (maxrad) is left out: it lights all that it faces";
            return Ok(Some((lamp(primitive)?, is_limited.then_some(note).into_iter().collect())));
        }
        "spotlight" => {
            return Ok(Some((lamp(primitive)?, vec!["spotlights shine in all directions of their front"])));
        }
        "plastic" | "metal" | "plastic2" | "metal2" | "plasfunc" | "metfunc" | "plasdata" | "metdata" => {
            let [.., part] = leading::<4>(primitive)?;
            reflecting(primitive, 1.0 - part, [(part != 0.0).then_some(specular)])?
        }
        "trans" => translucent(primitive, leading::<6>(primitive)?)?,
        "trans2" => {
            let [r, g, b, part, _, _, transmitted, _] = leading::<8>(primitive)?;
            translucent(primitive, [r, g, b, part, 0.0, transmitted])?
        }
        "transfunc" | "transdata" => {
            let [r, g, b, part, transmitted, _] = leading::<6>(primitive)?;
            translucent(primitive, [r, g, b, part, 0.0, transmitted])?
        }
        "BRTDfunc" | "ashik2" => reflecting(primitive, 1.0, [Some(specular)])?,
        "glass" | "dielectric" | "interface" => {
            black(primitive, "transmission through glass is left out: glass is black")
        }
        "mirror" | "prism1" | "prism2" => black(primitive, "mirrors and prisms are black"),
        "BSDF" | "aBSDF" | "WGMDfunc" => {
            black(primitive, "materials with measured reflection (BSDF) are black")
        }
        _ => return Ok(None),
    };
    Ok(Some(coat))
}

/// The first `N` numbers of a material, all ≥ 0.
fn leading<const N: usize>(primitive: &Primitive) -> Result<[f64; N], Refusal> {
    let Primitive { kind, name, reals, .. } = primitive;
    let values: [f64; N] = reals.get(..N).and_then(|values| values.try_into().ok()).ok_or_else(|| {
        Refusal::new(
            format!("the {kind} '{}' has {} numbers, {N} are the least", short(name), reals.len()),
            "write them all, and their count before them",
        )
    })?;
    match values.iter().find(|value| **value < 0.0) {
        None => Ok(values),
        Some(value) => {
            refuse(format!("the {kind} '{}' has {value}, below 0", short(name)), "write 0 or more")
        }
    }
}

/// A material that reflects `part` of its colour diffusely, and the notes that there are.
fn reflecting(
    primitive: &Primitive,
    part: f64,
    notes: impl IntoIterator<Item = Option<&'static str>>,
) -> Result<(Coat, Vec<&'static str>), Refusal> {
    let reflectance = leading::<3>(primitive)?.map(|band| band * part.max(0.0));
    let coat = Coat { name: primitive.name.clone(), reflectance, ..Coat::default() };
    Ok((coat, notes.into_iter().flatten().collect()))
}

/// A material whose numbers are colour, specular part, roughness, transmitted part.
fn translucent(
    primitive: &Primitive,
    [_, _, _, specular, _, transmitted]: [f64; 6],
) -> Result<(Coat, Vec<&'static str>), Refusal> {
    let notes = [
        (specular != 0.0).then_some("specular reflection is left out"),
        (transmitted != 0.0).then_some("transmission of trans materials is left out"),
    ];
    reflecting(primitive, (1.0 - specular) * (1.0 - transmitted), notes)
}

fn black(primitive: &Primitive, note: &'static str) -> (Coat, Vec<&'static str>) {
    (Coat { name: primitive.name.clone(), ..Coat::default() }, vec![note])
}

/// A lamp: its exitance is π times its radiance, and its front alone emits.
fn lamp(primitive: &Primitive) -> Result<Coat, Refusal> {
    let emission = leading::<3>(primitive)?.map(|radiance| PI * radiance);
    Ok(Coat { name: primitive.name.clone(), emission, sides: Sides::Front, ..Coat::default() })
}
