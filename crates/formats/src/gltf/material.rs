//! Materials (section 3.9): their diffuse part.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::note::Note;
use radiosity_photometry::note_text::NoteText;

use super::extensions::{self, SPECULAR, TRANSPARENCY};
use super::json::Json;
use super::scheme::{self, Glossiness, Root};
use crate::colour::{TEXTURED, TEXTURED_EMISSION, UNKNOWN};
use crate::model::{Material, Model, Sides};
use crate::names::UniqueNames;
use crate::tolerances::GREATEST;

/// Reflection of all materials as mirrors that needs no word (section 3.9.2).
const OF_DIELECTRICS: f64 = 0.04;

/// Note on mirrors whose part of the light a texture tells.
const TEXTURED_GLOSS: &str = "the part that a specularGlossinessTexture reflects as a mirror does is taken for 0, and all of the diffuse colour is kept";

/// Sides of the surfaces of a material, and notes on what is left out of it, which are told where a surface has it.
#[derive(Debug)]
pub(super) struct Finish {
    pub(super) sides: Sides,
    pub(super) left_out: Vec<Note>,
}

/// Adds all materials to the model, under their names or numbers. Returns the finish of each.
pub(super) fn add_all<'a>(
    json: &Json<'a>,
    root: &Root<'a>,
    model: &mut Model,
) -> Result<Vec<Finish>, Refusal> {
    let mut names = UniqueNames::default();
    let mut all = Vec::with_capacity(root.materials.len());
    for (index, text) in root.materials.iter().enumerate() {
        let (mut material, finish) = read(json, root, text.get(), index)?;
        material.name = names.take(&material.name);
        model.materials.push(material);
        all.push(finish);
    }
    Ok(all)
}

/// A material and its finish.
fn read<'a>(
    json: &Json<'a>,
    root: &Root<'a>,
    text: &'a str,
    index: usize,
) -> Result<(Material, Finish), Refusal> {
    let material: scheme::Material = json.parse(text, &format!("the material {index}"))?;
    let place = json.place(text);
    let unknown = extensions::unlisted(&material.extensions.others, root).map(extensions::left_out);
    let told = losses(&material).into_iter().map(NoteText::from).chain(unknown);
    let note = |text| Note { text, file: None, place: Some(place), count: 1 };
    let left_out = told.map(note).collect();
    let (reflectance, emission) = (reflectance(&material), emission(&material));
    if !reflectance.iter().chain(&emission).all(|value| (0.0..=GREATEST).contains(value)) {
        return refuse_at(
            place,
            format!(
                "the material {index} has a factor below 0 or beyond measure, or a metallic factor above 1"
            ),
            "correct its colours; factors are from 0 to 1",
        );
    }
    let name = material.name.filter(|name| !name.trim().is_empty());
    let read = Material {
        name: name.unwrap_or_else(|| format!("material-{index}")),
        reflectance: reflectance.to_vec(),
        emission: emission.to_vec(),
    };
    let sides = if material.double_sided { Sides::Both } else { Sides::Front };
    Ok((read, Finish { sides, left_out }))
}

/// The part that reflects as a metal; none where a texture tells it.
fn metallic(pbr: &scheme::Pbr) -> f64 {
    match (pbr.metallic_roughness_texture, pbr.metallic_factor) {
        (Some(_), _) => 0.0,
        (None, factor) => factor.unwrap_or(1.0),
    }
}

/// The largest part that reflects as a mirror does; none where a texture tells it.
fn specular(glossiness: &Glossiness) -> Option<f64> {
    let factor = glossiness.specular_factor.unwrap_or([1.0; 3]);
    glossiness.specular_glossiness_texture.is_none().then(|| factor.into_iter().fold(0.0, f64::max))
}

/// Diffuse reflectance of red, green and blue.
fn reflectance(material: &scheme::Material) -> [f64; 3] {
    let pbr = &material.pbr_metallic_roughness;
    let (base, diffuse) = match &material.extensions.glossiness {
        Some(glossiness) => (glossiness.diffuse_factor, 1.0 - specular(glossiness).unwrap_or(0.0)),
        None => (pbr.base_color_factor, 1.0 - metallic(pbr)),
    };
    let mean = if is_textured(material) { UNKNOWN } else { 1.0 };
    let [r, g, b, _] = base.unwrap_or([1.0; 4]);
    [r, g, b].map(|value| value * diffuse * mean)
}

/// Whether a texture colours what reflects.
fn is_textured(material: &scheme::Material) -> bool {
    match &material.extensions.glossiness {
        Some(glossiness) => glossiness.diffuse_texture.is_some(),
        None => material.pbr_metallic_roughness.base_color_texture.is_some(),
    }
}

/// Exitance of red, green and blue, whatever a texture makes of it.
fn stated_emission(material: &scheme::Material) -> [f64; 3] {
    let strength = material.extensions.strength.as_ref().and_then(|strength| strength.emissive_strength);
    material.emissive_factor.map(|value| PI * value * strength.unwrap_or(1.0))
}

/// Whether a texture tells what shines.
fn is_textured_lamp(material: &scheme::Material) -> bool {
    material.emissive_texture.is_some() && stated_emission(material) != [0.0; 3]
}

/// Exitance of red, green and blue: 0 where a texture tells what shines.
fn emission(material: &scheme::Material) -> [f64; 3] {
    if is_textured_lamp(material) { [0.0; 3] } else { stated_emission(material) }
}

/// Losses of a material, each kind once.
fn losses(material: &scheme::Material) -> BTreeSet<&'static str> {
    let pbr = &material.pbr_metallic_roughness;
    let glossiness = material.extensions.glossiness.as_ref();
    let of_metal = pbr.metallic_roughness_texture.filter(|_| glossiness.is_none());
    let of_gloss = glossiness.and_then(|own| own.specular_glossiness_texture);
    let has_textures = of_metal.or(of_gloss).or(material.normal_texture).is_some();
    let is_transparent = material.alpha_mode.as_deref().is_some_and(|mode| mode != "OPAQUE");
    let is_mirror = match glossiness {
        Some(own) => specular(own).is_none_or(|part| part > OF_DIELECTRICS),
        None => metallic(pbr) > 0.0,
    };
    let own = [
        has_textures.then_some("textures are left out"),
        is_transparent.then_some(TRANSPARENCY),
        is_mirror.then_some(SPECULAR),
        of_gloss.map(|_| TEXTURED_GLOSS),
        is_textured(material).then_some(TEXTURED),
        is_textured_lamp(material).then_some(TEXTURED_EMISSION),
    ];
    own.into_iter().flatten().chain(extensions::told(&material.extensions.others)).collect()
}
