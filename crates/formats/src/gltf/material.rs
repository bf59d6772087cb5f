//! Materials (section 3.9): their diffuse part.

use std::f64::consts::PI;

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use serde_json::value::RawValue;

use super::json::Json;
use super::scheme;
use crate::colour::{TEXTURED, TEXTURED_EMISSION, UNKNOWN};
use crate::model::{Material, Model, Sides};
use crate::names::UniqueNames;
use crate::tolerances::GREATEST;

/// Adds all materials to the model, under their names or numbers. Returns the sides of the surfaces of each.
pub(super) fn add_all<'a>(
    json: &Json<'a>,
    materials: &[&'a RawValue],
    model: &mut Model,
) -> Result<Vec<Sides>, Refusal> {
    let mut names = UniqueNames::default();
    let mut all = Vec::with_capacity(materials.len());
    for (index, text) in materials.iter().enumerate() {
        let (mut material, sides) = read(json, text.get(), index, model)?;
        material.name = names.take(&material.name);
        model.materials.push(material);
        all.push(sides);
    }
    Ok(all)
}

/// A material and the sides of its surfaces. What is left out is noted.
fn read<'a>(
    json: &Json<'a>,
    text: &'a str,
    index: usize,
    model: &mut Model,
) -> Result<(Material, Sides), Refusal> {
    let material: scheme::Material = json.parse(text, &format!("the material {index}"))?;
    let place = json.place(text);
    note(&material, place, model);
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

/// Diffuse reflectance of red, green and blue.
fn reflectance(material: &scheme::Material, place: FilePlace, model: &mut Model) -> [f64; 3] {
    let pbr = &material.pbr_metallic_roughness;
    let metallic = match (pbr.metallic_roughness_texture, pbr.metallic_factor) {
        (Some(_), _) => 0.0,
        (None, factor) => factor.unwrap_or(1.0),
    };
    let (mut base, mut texture) = (pbr.base_color_factor, pbr.base_color_texture);
    let mut diffuse = 1.0 - metallic;
    if let Some(glossiness) = &material.extensions.glossiness {
        (base, texture) = (glossiness.diffuse_factor, glossiness.diffuse_texture);
        diffuse = 1.0;
    } else if metallic > 0.0 {
        model.note("specular reflection is left out", Some(place));
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

/// Says what of a material is left out.
fn note(material: &scheme::Material, place: FilePlace, model: &mut Model) {
    let pbr = &material.pbr_metallic_roughness;
    if pbr.metallic_roughness_texture.or(material.normal_texture).is_some() {
        model.note("textures are left out", Some(place));
    }
    let is_transparent = material.alpha_mode.as_deref().is_some_and(|mode| mode != "OPAQUE");
    if is_transparent || material.extensions.transmission.is_some() {
        model.note("transparency is left out", Some(place));
    }
}
