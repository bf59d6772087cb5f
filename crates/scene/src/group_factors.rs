//! Dimming: the light groups of a scene, and copies of the scene with other factors on their emission.

use std::collections::{BTreeMap, BTreeSet};

use crate::{
    Scene,
    error::{Fault, Located, SceneError, group_title},
    light_group::LightGroup,
    ranges::check_range,
};

impl Scene {
    /// Light groups of the surfaces and the luminaires that emit, each once, in the order of the surfaces,
    /// then of the luminaires.
    pub fn light_groups(&self) -> Vec<&LightGroup> {
        let mut seen = BTreeSet::new();
        let emitting = self.surfaces.iter().filter(|surface| surface.material.emits());
        let luminaires = self.luminaires.iter().filter(|luminaire| luminaire.emits());
        let groups = emitting.filter_map(|surface| surface.group.as_ref());
        let groups = groups.chain(luminaires.filter_map(|luminaire| luminaire.group.as_ref()));
        groups.filter(|group| seen.insert(group.name.as_str())).collect()
    }

    /// Copy of the scene with the named groups at these factors (≥ 0) of the emission that its materials
    /// state, whatever factors they had before. Groups that are not named keep theirs.
    ///
    /// # Errors
    /// [`Fault::UnknownGroup`], [`Fault::GroupSetTwice`]; [`Fault::FixedVariable`] and
    /// [`Fault::VariableAndGroup`] for the name of a variable; [`Fault::NotFinite`] or [`Fault::OutOfRange`]
    /// for a factor.
    pub fn dimmed(&self, settings: &[(&str, f64)]) -> Result<Self, SceneError> {
        let factors = self.factors(settings).map_err(|located| located.in_code(&self.origin))?;
        let mut dimmed = self.clone();
        let groups = dimmed.surfaces.iter_mut().filter_map(|surface| surface.group.as_mut());
        let luminaires = dimmed.luminaires.iter_mut().filter_map(|luminaire| luminaire.group.as_mut());
        for group in groups.chain(luminaires) {
            group.factor = factors.get(group.name.as_str()).copied().unwrap_or(group.factor);
        }
        Ok(dimmed)
    }

    /// The factors by the names of their groups, all checked.
    fn factors<'a>(&self, settings: &[(&'a str, f64)]) -> Result<BTreeMap<&'a str, f64>, Located> {
        let groups = self.light_groups();
        let mut factors = BTreeMap::new();
        for (name, factor) in settings {
            let is_variable = self.variables.iter().any(|(variable, _)| variable == name);
            if is_variable {
                return Err(Located::nowhere(self.of_variable(name)));
            }
            if !groups.iter().any(|group| group.name == *name) {
                let known = groups.iter().map(|group| group.name.clone()).collect();
                return Err(Located::nowhere(Fault::UnknownGroup { name: (*name).to_owned(), known }));
            }
            check_factor(*factor).map_err(|fault| Located::nowhere(fault).within(|| group_title(name)))?;
            if factors.insert(*name, *factor).is_some() {
                return Err(Located::nowhere(Fault::GroupSetTwice { name: (*name).to_owned() }));
            }
        }
        Ok(factors)
    }

    /// The fault of a setting that names a variable, which dims nothing.
    fn of_variable(&self, name: &str) -> Fault {
        let name = name.to_owned();
        match self.light_groups().iter().any(|group| group.name == name) {
            true => Fault::VariableAndGroup { name },
            false => Fault::FixedVariable { name },
        }
    }
}

/// Checks that a factor is finite and ≥ 0.
fn check_factor(value: f64) -> Result<(), Fault> {
    check_range(value, value >= 0.0, "the factor", "factor ≥ 0")
}
