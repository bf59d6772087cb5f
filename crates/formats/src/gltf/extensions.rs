//! Extensions: what of them is followed, and what is told of the rest.

use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use super::extension_set::Extensions;
use super::scheme::Root;
use crate::model::Model;

/// Note on mirrors, lacquers and sheens, whatever extension describes them.
pub(super) const SPECULAR: &str = "specular reflection is left out";

/// Note on what lets light through.
pub(super) const TRANSPARENCY: &str = "transparency is left out";

/// Loss of an extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Loss {
    /// Nothing: it is followed, is told where it stands, or changes no light.
    Nothing,
    /// Light of a kind that this note names.
    Told(&'static str),
    /// Nobody knows what.
    Unknown,
}

/// Names of extensions, and what is lost of each.
const KNOWN: [(&str, Loss); 15] = [
    ("KHR_materials_emissive_strength", Loss::Nothing),
    ("KHR_materials_pbrSpecularGlossiness", Loss::Nothing),
    ("KHR_lights_punctual", Loss::Nothing),
    ("EXT_mesh_gpu_instancing", Loss::Nothing),
    ("KHR_mesh_quantization", Loss::Nothing),
    ("KHR_animation_pointer", Loss::Nothing),
    ("KHR_materials_transmission", Loss::Told(TRANSPARENCY)),
    ("KHR_materials_diffuse_transmission", Loss::Told(TRANSPARENCY)),
    ("KHR_materials_volume", Loss::Told(TRANSPARENCY)),
    ("KHR_materials_specular", Loss::Told(SPECULAR)),
    ("KHR_materials_ior", Loss::Told(SPECULAR)),
    ("KHR_materials_clearcoat", Loss::Told(SPECULAR)),
    ("KHR_materials_sheen", Loss::Told(SPECULAR)),
    ("KHR_materials_anisotropy", Loss::Told(SPECULAR)),
    ("KHR_materials_iridescence", Loss::Told(SPECULAR)),
];

/// Beginnings of the names of families of extensions that change no light.
const SILENT_FAMILIES: [&str; 4] = ["KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_xmp"];

/// Beginnings of the names of families that a file may require: what they add is told or needs no care.
const HARMLESS_FAMILIES: [&str; 4] = ["KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_"];

/// Names of extensions that a file may require.
const HARMLESS: [&str; 2] = ["KHR_lights_punctual", "KHR_mesh_quantization"];

/// The loss of the extension `name`.
pub(super) fn loss(name: &str) -> Loss {
    let is_silent = SILENT_FAMILIES.iter().any(|family| name.starts_with(family));
    match KNOWN.iter().find(|(known, _)| *known == name) {
        Some((_, loss)) => *loss,
        None if is_silent => Loss::Nothing,
        None => Loss::Unknown,
    }
}

/// Whether a file that requires the extension `name` can be read.
pub(super) fn is_harmless(name: &str) -> bool {
    HARMLESS.contains(&name) || HARMLESS_FAMILIES.iter().any(|family| name.starts_with(family))
}

/// The note on the extension `name`, of which nobody knows what it adds.
pub(super) fn left_out(name: &str) -> NoteText {
    NoteText::from("the extension ").quoting(short(name)).then(" is left out")
}

/// The notes of known kinds on extensions.
pub(super) fn told(extensions: &Extensions) -> impl Iterator<Item = &'static str> {
    extensions.keys().filter_map(|name| match loss(name) {
        Loss::Told(note) => Some(note),
        Loss::Nothing | Loss::Unknown => None,
    })
}

/// Notes the extensions at a place that nobody knows and that the list of the file lacks, which is told by itself.
pub(super) fn note(extensions: &Extensions, root: &Root<'_>, place: FilePlace, model: &mut Model) {
    let is_listed = |name: &String| root.extensions_used.contains(name);
    for name in extensions.keys().filter(|name| loss(name) == Loss::Unknown && !is_listed(name)) {
        model.note(left_out(name), Some(place));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_known_whole() {
        assert_eq!(loss("KHR_materials_ior"), Loss::Told(SPECULAR));
        assert_eq!(loss("KHR_materials_ior_2"), Loss::Unknown);
        assert_eq!(loss("KHR_lights_punctual_area"), Loss::Unknown);
        assert_eq!(loss("KHR_texture_basisu"), Loss::Nothing);
        assert!(is_harmless("KHR_mesh_quantization") && !is_harmless("KHR_mesh_quantization_2"));
    }
}
