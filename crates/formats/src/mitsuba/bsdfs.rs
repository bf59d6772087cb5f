//! Bsdfs: the diffuse part of what surfaces do with light.

use std::collections::HashMap;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use super::colours::{Colour, Colours};
use super::element::Element;
use crate::colour::UNKNOWN;
use crate::model::Sides;

/// Reflectance where the scene states none: Mitsuba's own.
pub(super) const USUAL: f64 = 0.5;

/// Most bsdfs in one another: two sides, a mask and a blend are four. Bsdfs that hold themselves end here.
const DEEPEST: usize = 16;

/// The part of a bsdf that radiosity carries.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Finish {
    /// Id of the bsdf, or its type.
    pub(super) name: String,
    /// Diffuse reflectance of red, green and blue.
    pub(super) reflectance: [f64; 3],
    /// Sides that reflect.
    pub(super) sides: Sides,
    /// Whether light passes as if the surface were not there.
    pub(super) is_void: bool,
}

/// Finishes of bsdfs, by the numbers of their elements; none yet for a bsdf that is being read.
#[derive(Debug, Default)]
pub(super) struct Bsdfs {
    known: HashMap<usize, Option<Finish>>,
    /// Number of bsdfs in one another that are being read.
    depth: usize,
}

impl Bsdfs {
    /// The finish of a bsdf.
    ///
    /// # Errors
    /// Values that are no numbers, ids that nothing has, bsdfs inside themselves.
    pub(super) fn finish<'a>(
        &mut self,
        bsdf: &'a Element,
        colours: &mut Colours<'a, '_>,
    ) -> Result<Finish, Refusal> {
        match self.known.get(&bsdf.number) {
            Some(Some(known)) => return Ok(known.clone()),
            None if self.depth < DEEPEST => {}
            _ => {
                return Err(bsdf.refusal(
                    format!("bsdfs are in one another more than {DEEPEST} deep, or in a circle"),
                    "take some out",
                ));
            }
        }
        self.known.insert(bsdf.number, None);
        self.depth += 1;
        let mut finish = self.of(bsdf, colours)?;
        self.depth -= 1;
        if let Some(id) = bsdf.attribute("id") {
            finish.name = id.to_owned();
        }
        self.known.insert(bsdf.number, Some(finish.clone()));
        Ok(finish)
    }

    fn of<'a>(&mut self, bsdf: &'a Element, colours: &mut Colours<'a, '_>) -> Result<Finish, Refusal> {
        let kind = bsdf.kind();
        match kind {
            "diffuse" => {
                // What Mitsuba 0 calls it.
                let is_old = bsdf.property("reflectance").is_none();
                front(bsdf, if is_old { "diffuse_reflectance" } else { "reflectance" }, colours)
            }
            "roughdiffuse" => {
                note(bsdf, "roughness is left out", colours);
                front(bsdf, "reflectance", colours)
            }
            "plastic" | "roughplastic" | "pplastic" => {
                note(bsdf, "specular reflection is left out", colours);
                front(bsdf, "diffuse_reflectance", colours)
            }
            "principled" | "principledthin" => principled(bsdf, colours),
            "twosided" => self.twosided(bsdf, colours),
            "mask" | "bumpmap" | "normalmap" => {
                let what = if kind == "mask" { "opacity is left out" } else { "the relief is left out" };
                note(bsdf, what, colours);
                self.nested(bsdf, colours).map(|mut nested| nested.remove(0))
            }
            "blendbsdf" => self.blend(bsdf, colours),
            "null" => Ok(Finish { is_void: true, ..black(bsdf) }),
            _ => {
                note(bsdf, "they are black", colours);
                Ok(black(bsdf))
            }
        }
    }

    /// The bsdfs in a bsdf, at least one.
    fn nested<'a>(
        &mut self,
        bsdf: &'a Element,
        colours: &mut Colours<'a, '_>,
    ) -> Result<Vec<Finish>, Refusal> {
        let mut nested = Vec::new();
        for child in bsdf.children.iter().filter(|child| matches!(child.tag.as_str(), "bsdf" | "ref")) {
            let meant = colours.ids.meant(child)?;
            if meant.tag == "bsdf" {
                nested.push(self.finish(meant, colours)?);
            }
        }
        match nested.is_empty() {
            false => Ok(nested),
            true => Err(bsdf.refusal(
                format!("the bsdf of type '{}' has no bsdf in it", short(bsdf.kind())),
                "write one in it, or a <ref> to one",
            )),
        }
    }

    /// Finish of a `twosided` bsdf, alike on both sides: that of the first bsdf in it, which is of the front.
    fn twosided<'a>(&mut self, bsdf: &'a Element, colours: &mut Colours<'a, '_>) -> Result<Finish, Refusal> {
        let mut nested = self.nested(bsdf, colours)?;
        if nested.len() > 1 {
            note(bsdf, "the back is as the front", colours);
        }
        Ok(Finish { sides: Sides::Both, ..nested.remove(0) })
    }

    /// The mean of two bsdfs, `weight` of it the second.
    fn blend<'a>(&mut self, bsdf: &'a Element, colours: &mut Colours<'a, '_>) -> Result<Finish, Refusal> {
        let nested = self.nested(bsdf, colours)?;
        let weight = match colours.property(bsdf, "weight")? {
            Some(Colour::Known([weight, ..])) => weight.min(1.0),
            _ => {
                note(bsdf, "half of each is taken", colours);
                0.5
            }
        };
        let [first, second, ..] = &nested[..] else {
            return Err(bsdf.refusal("the blend has one bsdf", "write two bsdfs in it"));
        };
        let mut finish = first.clone();
        for (own, other) in finish.reflectance.iter_mut().zip(second.reflectance) {
            *own += weight * (other - *own);
        }
        Ok(finish)
    }
}

/// The front with the reflectance that `name` is given.
fn front<'a>(bsdf: &'a Element, name: &str, colours: &mut Colours<'a, '_>) -> Result<Finish, Refusal> {
    let reflectance = match colours.property(bsdf, name)? {
        Some(Colour::Known(reflectance)) => reflectance,
        Some(Colour::Unknown(kind)) => {
            let text = NoteText::from("reflectances of type ").quoting(format!("'{kind}'"));
            colours.remarks.add(text.then(format!(" become {UNKNOWN}: their mean is not known")), bsdf);
            [UNKNOWN; 3]
        }
        None => [USUAL; 3],
    };
    Ok(Finish { reflectance, ..black(bsdf) })
}

/// The base colour less the metallic and the transmitting part.
fn principled<'a>(bsdf: &'a Element, colours: &mut Colours<'a, '_>) -> Result<Finish, Refusal> {
    note(bsdf, "specular reflection and transmission are left out", colours);
    let mut finish = front(bsdf, "base_color", colours)?;
    for name in ["metallic", "spec_trans"] {
        if let Some(Colour::Known([part, ..])) = colours.property(bsdf, name)? {
            finish.reflectance = finish.reflectance.map(|value| value * (1.0 - part.min(1.0)));
        }
    }
    if bsdf.kind() == "principledthin" {
        finish.sides = Sides::Both;
    }
    Ok(finish)
}

/// Finish of a black front, named after the type of the bsdf.
fn black(bsdf: &Element) -> Finish {
    let kind = short(bsdf.kind());
    let name = if kind.is_empty() { "bsdf".to_owned() } else { kind };
    Finish { name, reflectance: [0.0; 3], sides: Sides::Front, is_void: false }
}

/// Says what of bsdfs of a type is left out. What else is in it needs no word.
fn note(bsdf: &Element, what: &str, colours: &mut Colours<'_, '_>) {
    bsdf.pass_over();
    let text = NoteText::from("of bsdfs of type ").quoting(format!("'{}'", short(bsdf.kind())));
    colours.remarks.add(text.then(format!(": {what}")), bsdf);
}
