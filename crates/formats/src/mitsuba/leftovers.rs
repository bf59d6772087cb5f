//! Leftovers: elements and attributes that nothing was made of.

use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use super::element::{Element, Remarks};

/// Elements that need no word: what ids are given to and nothing names, and how Mitsuba makes its picture.
const SILENT: [&str; 6] = ["bsdf", "texture", "spectrum", "film", "alias", "ref"];

/// Elements that need no word even where a name is given to them.
const PICTURE: [&str; 3] = ["integrator", "sampler", "rfilter"];

/// Names of properties that need no word, for they change neither shapes nor their diffuse reflection.
const HARMLESS: [&str; 19] = [
    "face_normals",
    "flip_tex_coords",
    "max_smooth_angle",
    "silhouette_sampling_weight",
    "nonlinear",
    "near_clip",
    "far_clip",
    "focus_distance",
    "shutter_open",
    "shutter_close",
    "srf",
    "file_format",
    "pixel_format",
    "component_format",
    "high_quality_edges",
    "sample_border",
    "banner",
    "compensate",
    "gamma",
];

/// The attributes that elements of a tag may have.
fn attributes(tag: &str) -> &'static [&'static str] {
    match tag {
        "float" | "integer" | "boolean" | "string" | "rgb" | "srgb" => &["name", "value"],
        "spectrum" => &["name", "value", "filename", "type", "id"],
        "point" | "vector" => &["name", "value", "x", "y", "z"],
        "translate" | "scale" => &["value", "x", "y", "z"],
        "rotate" => &["value", "x", "y", "z", "angle"],
        "lookat" => &["origin", "target", "up"],
        "matrix" => &["value"],
        "transform" => &["name"],
        "ref" => &["name", "id"],
        _ => &["version", "name", "type", "id"],
    }
}

/// Remarks on what nothing was made of, in what something was made of.
pub(super) fn remark(element: &Element, remarks: &mut Remarks) {
    let known = attributes(&element.tag);
    for (name, _) in element.attributes.iter().filter(|(name, _)| !known.contains(&name.as_str())) {
        let text = NoteText::from("the attribute ").quoting(format!("'{}'", short(name)));
        let text = text.then(" of ").quoting(format!("<{}>", short(&element.tag))).then(" is left out");
        remarks.add(text, element);
    }
    for child in &element.children {
        if child.is_met.get() {
            remark(child, remarks);
        } else if let Some(text) = told(child, element) {
            remarks.add(text, child);
        }
    }
}

/// Remark on an element that nothing was made of; none if it needs no word.
fn told(child: &Element, parent: &Element) -> Option<NoteText> {
    let within = match parent.kind() {
        "" => format!("<{}>", short(&parent.tag)),
        kind => format!("<{} type=\"{}\">", short(&parent.tag), short(kind)),
    };
    match child.attribute("name") {
        _ if PICTURE.contains(&child.tag.as_str()) => None,
        Some(name) if HARMLESS.contains(&name) => None,
        Some(name) => {
            let text = NoteText::default().quoting(format!("'{}'", short(name)));
            Some(text.then(" of ").quoting(within).then(" is left out"))
        }
        None if SILENT.contains(&child.tag.as_str()) => None,
        // What has such a medium tells of it.
        None if child.tag == "medium" && parent.tag == "scene" => None,
        None => {
            let text = NoteText::default().quoting(format!("<{}>", short(&child.tag)));
            Some(text.then(" in ").quoting(within).then(" is left out"))
        }
    }
}
