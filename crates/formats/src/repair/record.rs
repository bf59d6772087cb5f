//! Record of repairs: one entry, one line, for each repair.

use std::sync::Arc;

use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note_text::NoteText;

use crate::model::Surface;

/// Kind of the fault that was repaired.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum RepairKind {
    /// Vertices that repeat their neighbours, and outlines that run somewhere and straight back.
    Vertices,
    /// Faces without area.
    Sliver,
    /// Outlines that touch or cross themselves, and holes that cross or leave them.
    Outline,
    /// Polygons whose vertices lie in no common plane.
    Plane,
    /// Surfaces that lie in the same place.
    Coincident,
    /// Surfaces that lie partly on one another.
    Overlap,
    /// Reflectances outside 0 ≤ ρ < 1.
    Reflectance,
    /// Faces whose fronts point the wrong way.
    Fronts,
    /// Faces whose fronts seem to point the wrong way, and were left as they are.
    DoubtfulFronts,
}

/// A repair: the fault, its surfaces and its text.
#[derive(Clone, Debug, PartialEq)]
pub struct Repair {
    /// Kind of the fault.
    pub kind: RepairKind,
    /// Names of the surfaces that had it, as the file names them.
    pub surfaces: Vec<String>,
    /// The fault and its repair, without a full stop: `"desk-3" and "desk-7" coincide; "desk-7" was removed`.
    pub text: NoteText,
    /// The included file of the first of the surfaces; none for the file that was read.
    pub file: Option<Arc<str>>,
    /// Place in the file of the first of the surfaces.
    pub place: Option<FilePlace>,
}

/// All repairs, in the order in which they were made.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Repairs {
    /// Repairs in the order in which they were made.
    pub list: Vec<Repair>,
}

impl Repairs {
    /// Whether the model had no fault.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// Number of repairs of a kind.
    pub fn count(&self, kind: RepairKind) -> usize {
        self.list.iter().filter(|repair| repair.kind == kind).count()
    }

    pub(super) fn say(
        &mut self,
        kind: RepairKind,
        surfaces: Vec<String>,
        at: Option<&Surface>,
        text: NoteText,
    ) {
        let (file, place) = at.map_or((None, None), |surface| (surface.file.clone(), surface.place));
        self.list.push(Repair { kind, surfaces, text, file, place });
    }
}

/// `1 spike`, `3 spikes`.
pub(super) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
