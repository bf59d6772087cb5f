//! Changes of many surfaces, made at once: a surface stays, goes, or becomes several.

use std::collections::BTreeMap;

use crate::model::{Model, Shape, Surface};
use crate::names::UniqueNames;

/// The shapes that take the place of surfaces, by index: none if the surface goes.
#[derive(Debug, Default)]
pub(super) struct Edit {
    shapes: BTreeMap<usize, Vec<Shape>>,
}

impl Edit {
    pub(super) fn is_empty(&self) -> bool {
        self.shapes.is_empty()
    }

    pub(super) fn replace(&mut self, surface: usize, shapes: Vec<Shape>) {
        self.shapes.insert(surface, shapes);
    }

    /// Makes the changes. Of a surface that becomes several the parts are named `name-1`, `name-2`, …;
    /// returns their new names by the old index, and the new indices of all changed surfaces.
    pub(super) fn apply(mut self, model: &mut Model) -> Edited {
        let mut edited = Edited::default();
        if self.is_empty() {
            return edited;
        }
        let mut unique = UniqueNames::default();
        if self.shapes.values().any(|shapes| shapes.len() > 1) {
            model.surfaces.iter().for_each(|surface| drop(unique.take(&surface.name)));
        }
        let mut kept = Vec::with_capacity(model.surfaces.len());
        for (index, surface) in std::mem::take(&mut model.surfaces).into_iter().enumerate() {
            let Some(shapes) = self.shapes.remove(&index) else {
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
                edited.changed.push(kept.len());
                kept.push(Surface { name, shape, ..surface.clone() });
            }
            edited.names.insert(index, names);
        }
        model.surfaces = kept;
        edited
    }
}

/// New names and new indices of changed surfaces.
#[derive(Debug, Default)]
pub(super) struct Edited {
    names: BTreeMap<usize, Vec<String>>,
    /// Indices of the surfaces that take the places of changed ones, in order.
    pub(super) changed: Vec<usize>,
}

impl Edited {
    /// Names of the surfaces that take the place of a surface.
    pub(super) fn names(&self, surface: usize) -> &[String] {
        self.names.get(&surface).map_or(&[], Vec::as_slice)
    }
}
