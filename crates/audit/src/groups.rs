//! Light groups by number: 0 for what belongs to none.

use std::collections::HashMap;

use radiosity_scene::{LightGroup, Scene};

/// The light groups of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Groups {
    names: Vec<Option<String>>,
    of_surfaces: Vec<usize>,
    of_luminaires: Vec<usize>,
}

impl Groups {
    pub(crate) fn of(scene: &Scene) -> Self {
        let mut numbers = HashMap::new();
        let of_surfaces = scene.surfaces.iter().map(|own| number(own.group.as_ref(), &mut numbers)).collect();
        let of_luminaires =
            scene.luminaires.iter().map(|own| number(own.group.as_ref(), &mut numbers)).collect();
        let mut names = vec![None; numbers.len() + 1];
        numbers.into_iter().for_each(|(name, number)| names[number] = Some(name));
        Self { names, of_surfaces, of_luminaires }
    }

    /// The name of each group; None for what belongs to none.
    pub(crate) fn names(&self) -> &[Option<String>] {
        &self.names
    }

    /// Number of the group of a surface.
    pub(crate) fn of_surface(&self, surface: usize) -> usize {
        self.of_surfaces[surface]
    }

    /// Number of the group of a luminaire.
    pub(crate) fn of_luminaire(&self, luminaire: usize) -> usize {
        self.of_luminaires[luminaire]
    }
}

/// The number of a group, a new one where it is not known yet.
fn number(group: Option<&LightGroup>, numbers: &mut HashMap<String, usize>) -> usize {
    let Some(group) = group else { return 0 };
    let next = numbers.len() + 1;
    *numbers.entry(group.name.clone()).or_insert(next)
}
