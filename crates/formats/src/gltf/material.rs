//! Materials (section 3.9): their diffuse part.

use std::collections::BTreeSet;
use std::f64::consts::PI;

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;

use super::extensions::{self, SPECULAR, TRANSPARENCY};
use super::json::Json;
use super::scheme::{self, Root};
use crate::colour::{TEXTURED, TEXTURED_EMISSION, UNKNOWN};
use crate::model::{Material, Model, Sides};
use crate::names::UniqueNames;
use crate::tolerances::GREATEST;

/// Adds all materials to the model, under their names or numbers. Returns the sides of the surfaces of each.
pub(super) fn add_all<'a>(
    json: &Json<'a>,
    root: &Root<'a>,
    model: &mut Model,
) -> Result<Vec<Sides>, Refusal> {
    let mut names = UniqueNames::default();
    let mut all = Vec::with_capacity(root.materials.len());
    for (index, text) in root.materials.iter().enumerate() {
        let (mut material, sides) = read(json, root, text.get(), index, model)?;
        material.name = names.take(&material.name);
        model.materials.push(material);
        all.push(sides);
    }
    Ok(all)
}

/// A material and the sides of its surfaces. What is left out is noted.
fn read<'a>(
    json: &Json<'a>,
    root: &Root<'a>,
    text: &'a str,
    index: usize,
    model: &mut Model,
) -> Result<(Material, Sides), Refusal> {
    let material: scheme::Material = json.parse(text, &format!("the material {index}"))?;
    let place = json.place(text);
    losses(&material).into_iter().for_each(|text| model.note(text, Some(place)));
    extensions::note(&material.extensions.others, root, place, model);
    let reflectance = reflectance(&material, place, model);
    let emission = emission(&material, place, model);
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
    Ok((read, if material.double_sided { Sides::Both } else { Sides::Front }))
}

/// The part that reflects as a metal; none where a texture tells it.
fn metallic(pbr: &scheme::Pbr) -> f64 {
    match (pbr.metallic_roughness_texture, pbr.metallic_factor) {
        (Some(_), _) => 0.0,
        (None, factor) => factor.unwrap_or(1.0),
    }
}

/// Diffuse reflectance of red, green and blue.
fn reflectance(material: &scheme::Material, place: FilePlace, model: &mut Model) -> [f64; 3] {
    let pbr = &material.pbr_metallic_roughness;
    let (mut base, mut texture) = (pbr.base_color_factor, pbr.base_color_texture);
    let mut diffuse = 1.0 - metallic(pbr);
    if let Some(glossiness) = &material.extensions.glossiness {
        (base, texture) = (glossiness.diffuse_factor, glossiness.diffuse_texture);
        diffuse = 1.0;
    }
    if texture.is_some() {
        model.note(TEXTURED, Some(place));
        diffuse *= UNKNOWN;
    }
    let [r, g, b, _] = base.unwrap_or([1.0; 4]);
    [r, g, b].map(|value| value * diffuse)
}

/// Exitance of red, green and blue: 0 where a texture tells what shines.
fn emission(material: &scheme::Material, place: FilePlace, model: &mut Model) -> [f64; 3] {
    let strength = material.extensions.strength.as_ref().and_then(|strength| strength.emissive_strength);
    let emission = material.emissive_factor.map(|value| PI * value * strength.unwrap_or(1.0));
    if material.emissive_texture.is_some() && emission != [0.0; 3] {
        model.note(TEXTURED_EMISSION, Some(place));
        return [0.0; 3];
    }
    emission
}

/// Losses of a material, each kind once.
fn losses(material: &scheme::Material) -> BTreeSet<&'static str> {
    let pbr = &material.pbr_metallic_roughness;
    let is_textured = pbr.metallic_roughness_texture.or(material.normal_texture).is_some();
    let is_transparent = material.alpha_mode.as_deref().is_some_and(|mode| mode != "OPAQUE");
    let is_metal = material.extensions.glossiness.is_none() && metallic(pbr) > 0.0;
    let own = [
        is_textured.then_some("textures are left out"),
        is_transparent.then_some(TRANSPARENCY),
        is_metal.then_some(SPECULAR),
    ];
    own.into_iter().flatten().chain(extensions::told(&material.extensions.others)).collect()
}
