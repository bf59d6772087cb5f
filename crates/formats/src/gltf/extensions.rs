//! Extensions: what of them is followed, and what is told of the rest.

use std::collections::HashMap;
use std::ops::RangeInclusive;

use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;
use serde::Deserialize;
use serde_json::value::RawValue;

use super::extension_set::{Extensions, extension_set};
use super::json::Json;
use super::scheme::Root;
use crate::model::Model;

/// Note on mirrors, lacquers and sheens, whatever extension describes them.
pub(super) const SPECULAR: &str = "specular reflection is left out";

/// Note on what lets light through.
pub(super) const TRANSPARENCY: &str = "transparency is left out";

/// An extension, or a family of them.
struct Known {
    name: Name,
    /// Whether a file may require it: what it adds is told or needs no care.
    may_be_required: bool,
    loss: Loss,
}

/// The name of an extension, or the beginning of the names of a family.
enum Name {
    Whole(&'static str),
    Beginning(&'static str),
}

/// Loss of an extension.
#[derive(Clone, Debug, PartialEq)]
enum Loss {
    /// Nothing: it is followed, is told where it stands, or changes no light.
    Nothing,
    /// Light of a kind that this note names, where none of the strengths is idle.
    Told(&'static str, &'static [Strength]),
    /// Nobody knows what.
    Unknown,
}

/// A number, or several, of an extension that tells how much it adds.
#[derive(Debug, PartialEq)]
struct Strength {
    member: &'static str,
    /// Its value where none is stated.
    usual: f64,
    /// Values with which it adds nothing, or no more than materials without the extension have untold.
    idle: RangeInclusive<f64>,
}

/// A strength of which 0 adds nothing, and is the usual value.
const fn above_0(member: &'static str) -> Strength {
    Strength { member, usual: 0.0, idle: 0.0..=0.0 }
}

const fn known(name: &'static str, may_be_required: bool, loss: Loss) -> Known {
    Known { name: Name::Whole(name), may_be_required, loss }
}

const fn family(beginning: &'static str, may_be_required: bool, loss: Loss) -> Known {
    Known { name: Name::Beginning(beginning), may_be_required, loss }
}

/// The extensions that are known, single ones before families.
static KNOWN: &[Known] = &[
    known("KHR_materials_emissive_strength", true, Loss::Nothing),
    known("KHR_materials_pbrSpecularGlossiness", true, Loss::Nothing),
    known("KHR_lights_punctual", true, Loss::Nothing),
    known("EXT_mesh_gpu_instancing", false, Loss::Nothing),
    known("KHR_mesh_quantization", true, Loss::Nothing),
    known("KHR_animation_pointer", false, Loss::Nothing),
    // Where they are not required, the file holds their content as it is, too.
    known("KHR_draco_mesh_compression", false, Loss::Nothing),
    known("EXT_meshopt_compression", false, Loss::Nothing),
    known("KHR_materials_transmission", true, Loss::Told(TRANSPARENCY, &[above_0("transmissionFactor")])),
    known(
        "KHR_materials_diffuse_transmission",
        true,
        Loss::Told(TRANSPARENCY, &[above_0("diffuseTransmissionFactor")]),
    ),
    // They change light that transmission lets in, and is told.
    known("KHR_materials_volume", true, Loss::Nothing),
    known("KHR_materials_dispersion", true, Loss::Nothing),
    known(
        "KHR_materials_specular",
        true,
        Loss::Told(
            SPECULAR,
            &[
                Strength { member: "specularFactor", usual: 1.0, idle: 0.0..=0.0 },
                Strength { member: "specularColorFactor", usual: 1.0, idle: 0.0..=1.0 },
            ],
        ),
    ),
    known(
        "KHR_materials_ior",
        true,
        Loss::Told(SPECULAR, &[Strength { member: "ior", usual: 1.5, idle: 1.0..=1.5 }]),
    ),
    known("KHR_materials_clearcoat", true, Loss::Told(SPECULAR, &[above_0("clearcoatFactor")])),
    known("KHR_materials_sheen", true, Loss::Told(SPECULAR, &[above_0("sheenColorFactor")])),
    known("KHR_materials_anisotropy", true, Loss::Told(SPECULAR, &[above_0("anisotropyStrength")])),
    known("KHR_materials_iridescence", true, Loss::Told(SPECULAR, &[above_0("iridescenceFactor")])),
    family("KHR_materials_", true, Loss::Unknown),
    family("KHR_texture_", true, Loss::Nothing),
    family("EXT_texture_", true, Loss::Nothing),
    family("MSFT_texture_", true, Loss::Nothing),
    family("KHR_xmp", false, Loss::Nothing),
];

impl Known {
    fn of(name: &str) -> Option<&'static Self> {
        KNOWN.iter().find(|known| match known.name {
            Name::Whole(own) => own == name,
            Name::Beginning(own) => name.starts_with(own),
        })
    }
}

impl Strength {
    /// Whether the value of the extension gives it an idle value.
    fn is_idle(&self, value: &RawValue) -> bool {
        let Ok(members) = serde_json::from_str::<HashMap<String, &RawValue>>(value.get()) else {
            return false;
        };
        let Some(stated) = members.get(self.member) else { return self.idle.contains(&self.usual) };
        let one = || serde_json::from_str(stated.get()).map(|number| vec![number]);
        let numbers: Vec<f64> = serde_json::from_str(stated.get()).or_else(|_| one()).unwrap_or_default();
        !numbers.is_empty() && numbers.iter().all(|number| self.idle.contains(number))
    }
}

/// Whether nobody knows what the extension `name` adds.
pub(super) fn is_unknown(name: &str) -> bool {
    Known::of(name).is_none_or(|known| known.loss == Loss::Unknown)
}

/// Whether a file that requires the extension `name` can be read.
pub(super) fn is_harmless(name: &str) -> bool {
    Known::of(name).is_some_and(|known| known.may_be_required)
}

/// The note on the extension `name`, of which nobody knows what it adds.
pub(super) fn left_out(name: &str) -> NoteText {
    NoteText::from("the extension ").quoting(short(name)).then(" is left out")
}

/// The notes of known kinds on extensions.
pub(super) fn told(extensions: &Extensions) -> impl Iterator<Item = &'static str> {
    extensions.iter().filter_map(|(name, value)| match Known::of(name)?.loss {
        Loss::Told(note, strengths) => {
            (!strengths.iter().any(|strength| strength.is_idle(value))).then_some(note)
        }
        Loss::Nothing | Loss::Unknown => None,
    })
}

/// Names of the extensions at a place that nobody knows and that the list of the file lacks, which is told by itself.
pub(super) fn unlisted<'e>(extensions: &'e Extensions, root: &Root<'_>) -> impl Iterator<Item = &'e str> {
    let is_told = |name: &&str| is_unknown(name) && !root.extensions_used.contains(*name);
    extensions.keys().map(String::as_str).filter(is_told)
}

/// Notes the extensions at a place that nobody knows and that the list of the file lacks.
pub(super) fn note(extensions: &Extensions, root: &Root<'_>, place: FilePlace, model: &mut Model) {
    unlisted(extensions, root).for_each(|name| model.note(left_out(name), Some(place)));
}

/// A part of a file by its extensions alone.
#[derive(Default, Deserialize)]
struct Extended {
    #[serde(default, deserialize_with = "extension_set")]
    extensions: Extensions,
}

/// Notes such extensions of the parts of a file of which nothing else is told or needed here.
pub(super) fn note_all(json: &Json<'_>, root: &Root<'_>, model: &mut Model) {
    let lists = [
        &root.scenes,
        &root.meshes,
        &root.accessors,
        &root.buffer_views,
        &root.buffers,
        &root.cameras,
        &root.textures,
        &root.images,
        &root.samplers,
    ];
    for part in lists.into_iter().flatten() {
        // A part that is none is refused where it is used.
        let Extended { extensions } = serde_json::from_str(part.get()).unwrap_or_default();
        note(&extensions, root, json.place(part.get()), model);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_known_whole() {
        let is_known = |name| Known::of(name).is_some_and(|known| known.loss != Loss::Unknown);
        assert!(is_known("KHR_materials_ior") && !is_known("KHR_materials_ior_2"));
        assert!(is_known("KHR_texture_basisu") && !is_known("KHR_lights_punctual_area"));
        assert!(is_harmless("KHR_mesh_quantization") && !is_harmless("KHR_mesh_quantization_2"));
        assert!(is_harmless("KHR_materials_unlit") && !is_harmless("KHR_draco_mesh_compression"));
    }

    /// Single extensions stand before the families that they are of: else they would not be found.
    #[test]
    fn families_stand_last() {
        for (place, Known { name, .. }) in KNOWN.iter().enumerate() {
            let Name::Whole(name) = name else { continue };
            let found = KNOWN.iter().position(|own| std::ptr::eq(own, Known::of(name).expect("it is known")));
            assert_eq!(found, Some(place), "{name}");
        }
    }

    #[test]
    fn strengths_that_add_nothing_are_idle() {
        let is_told = |name: &str, value: &str| {
            let value = RawValue::from_string(value.to_owned()).expect("JSON");
            told(&Extensions::from([(name.to_owned(), value)])).count() == 1
        };
        let idle = [
            ("KHR_materials_clearcoat", "{}"),
            ("KHR_materials_clearcoat", r#"{"clearcoatFactor": 0.0, "clearcoatRoughnessFactor": 0.3}"#),
            ("KHR_materials_transmission", r#"{"transmissionFactor": 0}"#),
            ("KHR_materials_diffuse_transmission", "{}"),
            ("KHR_materials_volume", r#"{"thicknessFactor": 1}"#),
            ("KHR_materials_ior", "{}"),
            ("KHR_materials_ior", r#"{"ior": 1.5}"#),
            ("KHR_materials_ior", r#"{"ior": 1.33}"#),
            ("KHR_materials_specular", "{}"),
            ("KHR_materials_specular", r#"{"specularFactor": 0, "specularColorFactor": [2, 1, 1]}"#),
            ("KHR_materials_specular", r#"{"specularColorFactor": [0.5, 1, 1]}"#),
            ("KHR_materials_sheen", r#"{"sheenColorFactor": [0, 0, 0]}"#),
            ("KHR_materials_emissive_strength", r#"{"emissiveStrength": 1}"#),
        ];
        for (name, value) in idle {
            assert!(!is_told(name, value), "{name}: {value}");
        }
        let strong = [
            ("KHR_materials_clearcoat", r#"{"clearcoatFactor": 0.5}"#),
            ("KHR_materials_transmission", r#"{"transmissionFactor": 1}"#),
            ("KHR_materials_ior", r#"{"ior": 2.4}"#),
            ("KHR_materials_ior", r#"{"ior": 0}"#),
            ("KHR_materials_ior", r#"{"ior": "high"}"#),
            ("KHR_materials_ior", "null"),
            ("KHR_materials_specular", r#"{"specularColorFactor": [2, 1, 1]}"#),
            ("KHR_materials_sheen", r#"{"sheenColorFactor": [0, 0.1, 0]}"#),
            ("KHR_materials_sheen", r#"{"sheenColorFactor": []}"#),
        ];
        for (name, value) in strong {
            assert!(is_told(name, value), "{name}: {value}");
        }
    }
}
