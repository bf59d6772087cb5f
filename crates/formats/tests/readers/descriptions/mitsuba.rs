//! Mitsuba scenes read.

mod scenes;
mod shapes;
mod materials;
mod cameras;
mod texts;
mod broken;

use radiosity_formats::mitsuba;
use radiosity_formats::model::Model;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::files::NoFiles;

use crate::memory::Memory;

/// Reads a scene that names no files.
fn read(text: &str) -> Result<Model, Refusal> {
    mitsuba::read("room.xml", text.as_bytes(), &NoFiles)
}

/// Reads what stands in a scene from its second line on.
fn inside(text: &str) -> Result<Model, Refusal> {
    read(&format!("<scene version=\"3.0.0\">\n{text}\n</scene>"))
}

/// Reads what stands in a scene that is right.
fn right(text: &str) -> Model {
    inside(text).unwrap_or_else(|refusal| panic!("{refusal}\n{text}"))
}

/// Reads a scene with files beside it.
fn beside(text: &str, files: &[(&'static str, &str)]) -> Result<Model, Refusal> {
    mitsuba::read(
        "room.xml",
        format!("<scene version=\"3.0.0\">\n{text}\n</scene>").as_bytes(),
        &Memory::of(files.iter().copied()),
    )
}

/// A shape of a type with what is in it.
fn shape(kind: &str, content: &str) -> String {
    format!("<shape type=\"{kind}\">{content}</shape>")
}

/// A transform of steps.
fn to_world(steps: &str) -> String {
    format!("<transform name=\"to_world\">{steps}</transform>")
}

/// The texts of the notes, each with its count.
fn notes(model: &Model) -> Vec<(&str, usize)> {
    model.notes.iter().map(|note| (note.text.as_str(), note.count)).collect()
}

/// Asserts that the scene is refused in line `line`, for a cause that contains `cause`, with a cure.
fn is_refused(found: Result<Model, Refusal>, line: usize, cause: &str) {
    match found {
        Ok(model) => panic!("{model:?} instead of {cause}"),
        Err(refusal) => {
            assert!(refusal.cause.contains(cause), "{refusal} instead of {cause}");
            assert_eq!(refusal.place, Some(FilePlace::Line(line)), "{refusal}");
            assert!(!refusal.cure.is_empty() && refusal.file == "room.xml", "{refusal}");
        }
    }
}
