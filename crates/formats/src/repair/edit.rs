//! Changes of many surfaces, made at once: a surface stays, goes, or becomes several.

use std::collections::BTreeMap;

use radiosity_photometry::note_text::NoteText;

use crate::model::{Model, Shape, Surface};
use crate::names::UniqueNames;
use crate::repair::record::{RepairKind, Repairs};

/// Changes of surfaces, by their index.
#[derive(Default)]
pub(super) struct Edit {
    changes: BTreeMap<usize, Change>,
}

/// The shapes that take the place of a surface: none if it goes.
struct Change {
    shapes: Vec<Shape>,
    told: Option<Told>,
}

/// Kind of a fault and text of its repair, by the name of the surface and the names of those in its place.
type Text = dyn Fn(&str, &[String]) -> (RepairKind, NoteText);

/// Telling of a change: its text, and other surfaces that have the fault too.
pub(super) struct Told {
    pub(super) others: Vec<String>,
    pub(super) text: Box<Text>,
}

impl Edit {
    /// Replaces a surface by shapes, of which nothing is told.
    pub(super) fn replace(&mut self, surface: usize, shapes: Vec<Shape>) {
        self.changes.insert(surface, Change { shapes, told: None });
    }

    /// Replaces a surface by shapes, and tells it.
    pub(super) fn tell(&mut self, surface: usize, shapes: Vec<Shape>, told: Told) {
        self.changes.insert(surface, Change { shapes, told: Some(told) });
    }

    /// Makes the changes and tells them in the order of the surfaces. Of a surface that becomes several the
    /// parts are named `name-1`, `name-2`, …; returns the new indices of all changed surfaces.
    pub(super) fn apply(mut self, model: &mut Model, repairs: &mut Repairs) -> Vec<usize> {
        let mut changed = Vec::new();
        if self.changes.is_empty() {
            return changed;
        }
        let mut unique = UniqueNames::default();
        if self.changes.values().any(|change| change.shapes.len() > 1) {
            model.surfaces.iter().for_each(|surface| drop(unique.take(&surface.name)));
        }
        let mut kept = Vec::with_capacity(model.surfaces.len());
        for (index, surface) in std::mem::take(&mut model.surfaces).into_iter().enumerate() {
            let Some(Change { shapes, told }) = self.changes.remove(&index) else {
                kept.push(surface);
                continue;
            };
            let is_split = shapes.len() > 1;
            let mut names = Vec::with_capacity(shapes.len());
            for (k, shape) in shapes.into_iter().enumerate() {
                let name = match is_split {
                    true => unique.take(&format!("{}-{}", surface.name, k + 1)),
                    false => surface.name.clone(),
                };
                names.push(name.clone());
                changed.push(kept.len());
                kept.push(Surface { name, shape, ..surface.clone() });
            }
            if let Some(Told { others, text }) = told {
                let (kind, text) = text(&surface.name, &names);
                let surfaces = std::iter::once(surface.name.clone()).chain(others).collect();
                repairs.say(kind, surfaces, Some(&surface), text);
            }
        }
        model.surfaces = kept;
        changed
    }
}
