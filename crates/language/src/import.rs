//! Scenes of other programs → a model that was repaired → the text of a scene.
//!
//! Flow: bytes → [`formats::read`](radiosity_formats::read) → materials, units → [`repair`] → tree → JSON,
//! one surface on a line. The text is that of any other scene from there on: solution files keep it, and need
//! no other reader.

use std::{collections::BTreeSet, fmt, path::Path, sync::Arc};

use radiosity_formats::{
    colour,
    format::Format,
    materials::{self, SideFile},
    model::{Model, Sides},
    read::read,
    repair::{Options, refusal, repair},
    unit::Unit,
    up::Up,
};
use radiosity_photometry::{
    error::Refusal,
    file_place::FilePlace,
    files::{Files, Folder, NoFiles, Reach},
    note::Note,
    note_text::NoteText,
};
use radiosity_scene::{Fault, FaultKind, Imported, Notation, SceneError, Source};
use radiosity_work::{
    ranks::Ranks,
    wording::{option, words},
};

use crate::{input, model_tree::model_text};

/// Options of the import of scenes of other programs.
#[derive(Clone, Debug, Default)]
pub struct Import {
    /// The format, instead of that which the ending of the file's name tells.
    pub format: Option<Format>,
    /// Sides that reflect and emit, of all surfaces, whatever the format says.
    pub sides: Option<Sides>,
    /// Materials by name, instead of those of the file.
    pub materials: Option<SideFile>,
    /// Unit of the lengths in the file; they become metres.
    pub unit: Option<Unit>,
    /// The axis that points upwards in the file; z will. Without it, y in glTF, whose specification says so
    /// (section 3.4), and z elsewhere.
    pub up: Option<Up>,
    /// Length up to which points are one, in metres if a unit is given.
    pub tolerance: Option<f64>,
    /// Whether a scene that needs repairs is refused.
    pub strict: bool,
    /// Whether fronts that seem to point the wrong way are turned.
    pub fix_fronts: bool,
    /// Whether red, green and blue become one band of their luminance.
    pub grey: bool,
}

impl Import {
    /// The format of `file`: that which was asked for, or that which its ending tells.
    pub fn format_of(&self, file: &str) -> Option<Format> {
        self.format.or_else(|| Format::of(file))
    }

    /// Reads and repairs the scene in `file`, or in standard input for `-`, which the first of these ranks
    /// shares; and says which files it was read from outside its folder, where it may reach for them.
    ///
    /// # Errors
    /// A file that cannot be read, or is against the rules of the format; with [`Import::strict`] what needs
    /// repairs.
    fn model(
        &self,
        file: &str,
        format: Format,
        reach: Reach,
        ranks: &Ranks,
    ) -> Result<(Model, Imported, BTreeSet<String>), SceneError> {
        let bytes = input::bytes(file, ranks);
        let bytes = bytes.map_err(|error| SceneError::of(file, input::unreadable(&error)))?;
        let folder = Folder::of_scene(Path::new(file), reach);
        let (name, files): (_, &dyn Files) =
            if file == "-" { ("<stdin>", &NoFiles) } else { (file, &folder) };
        let model = read(format, name, &bytes, files);
        let outside = folder.outside();
        let model = model.map_err(|refusal| discreet(refusal, &outside))?;
        let (model, imported) = self.repaired(model, name, format, !outside.is_empty())?;
        Ok((model, imported, outside))
    }

    /// The model in `file` with the materials, the unit and the axis that were asked for, repaired. Where
    /// files `outside` were read, what is told quotes nothing of the model.
    fn repaired(
        &self,
        mut model: Model,
        file: &str,
        format: Format,
        outside: bool,
    ) -> Result<(Model, Imported), SceneError> {
        let shown = |text: &NoteText| if outside { text.without_quotes() } else { text.to_string() };
        let replaced = match &self.materials {
            Some(side) => materials::apply(side, &mut model, &shown).map_err(refused)?,
            None => Vec::new(),
        };
        if let Some(unit) = self.unit {
            unit.to_metres(&mut model);
        }
        self.upright(&mut model, format);
        if self.grey {
            colour::to_grey(&mut model);
        }
        let options = Options { tolerance: self.tolerance, sides: self.sides, fix_fronts: self.fix_fronts };
        let repairs = repair(&mut model, &options);
        if let Some(refusal) = refusal(&repairs, file, shown).filter(|_| self.strict) {
            let cure = words("mend the file, or let repairs be made by leaving out ") + option("strict");
            let fault = Fault::new(FaultKind::Foreign, refusal.cause.clone(), cure);
            return Err(SceneError { fault, ..refused(refusal) });
        }
        let notes = std::mem::take(&mut model.notes);
        let notes = notes
            .iter()
            .map(|note| {
                format!(
                    "{}: {}{}",
                    Located::of(file, note.file.as_ref(), note.place),
                    shown(&note.text),
                    times(note)
                )
            })
            .collect();
        let repairs = repairs
            .list
            .iter()
            .map(|own| format!("{}: {}", Located::of(file, own.file.as_ref(), own.place), shown(&own.text)))
            .collect();
        let imported = Imported { file: file.to_owned(), format: format.name(), replaced, notes, repairs };
        Ok((model, imported))
    }

    fn upright(&self, model: &mut Model, format: Format) {
        let up = self.up.unwrap_or(if format == Format::Gltf { Up::Y } else { Up::Z });
        if self.up.is_none() && up == Up::Y {
            model.note(
                "y points upwards in glTF: the scene was turned so that z does (--up z leaves it)",
                None,
            );
        }
        up.to_z(model);
    }

    /// The text of the scene in `file`, or in standard input for `-`.
    ///
    /// # Errors
    /// As [`Import::model`].
    pub(super) fn source(
        &self,
        file: &str,
        format: Format,
        reach: Reach,
        ranks: &Ranks,
    ) -> Result<Source, SceneError> {
        let (model, imported, outside) = self.model(file, format, reach, ranks)?;
        let text = model_text(&model, Notation::Json);
        // Places in messages are those of this text, not of the file.
        let origin = format!("{} (as read)", imported.file);
        let mut source = Source::new(&origin, &text).made_from(imported);
        source.record_outside(outside);
        Ok(source)
    }
}

/// The error of a refusal, which shows nothing of what files `outside` say.
fn discreet(refusal: Refusal, outside: &BTreeSet<String>) -> SceneError {
    let is_hidden = [&refusal.file].into_iter().chain(&refusal.quoted).any(|file| outside.contains(file));
    let error = refused(refusal);
    match is_hidden {
        true => SceneError { fault: error.fault.discreet(), ..error },
        false => error,
    }
}

fn refused(refusal: Refusal) -> SceneError {
    let origin = Located { file: &refusal.file, place: refusal.place }.to_string();
    SceneError::of(origin, Fault::foreign(refusal.cause, refusal.cure))
}

/// The number of the occurrences of a note, if there are several.
fn times(note: &Note) -> String {
    if note.count > 1 { format!(" ({} times)", note.count) } else { String::new() }
}

/// A file and a line or byte of it: `room.mgf:12`.
struct Located<'a> {
    file: &'a str,
    place: Option<FilePlace>,
}

impl<'a> Located<'a> {
    /// A place in a file that `file` includes, or in itself.
    fn of(file: &'a str, included: Option<&'a Arc<str>>, place: Option<FilePlace>) -> Self {
        Self { file: included.map_or(file, |own| own), place }
    }
}

impl fmt::Display for Located<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.place {
            Some(FilePlace::Line(line)) => write!(f, "{}:{line}", self.file),
            Some(FilePlace::Byte(byte)) => write!(f, "{}: byte {byte}", self.file),
            None => write!(f, "{}", self.file),
        }
    }
}
