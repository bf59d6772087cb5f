//! Dimming: the light groups of a scene, and copies of the scene with other factors on their emission.

use std::collections::{BTreeMap, BTreeSet};

use radiosity_work::wording::{set, words};

use crate::{
    Scene,
    error::{Located, SceneError, title},
    fault::Fault,
    heat_setting::HeatSetting,
    light_group::LightGroup,
    ranges::check_factor,
};

impl Scene {
    /// Light groups of the surfaces and the luminaires that emit, each once, in the order of the surfaces,
    /// then of the luminaires. In a frame they are those of the scene that moves, also where a motion has
    /// dimmed all of one to nothing.
    pub fn light_groups(&self) -> Vec<&LightGroup> {
        let mut seen = BTreeSet::new();
        let emitting = self.surfaces.iter().filter(|surface| surface.is_source());
        let luminaires = self.luminaires.iter().filter(|luminaire| luminaire.is_source());
        let groups = emitting.filter_map(|surface| surface.group.as_ref());
        let groups = groups.chain(luminaires.filter_map(|luminaire| luminaire.group.as_ref()));
        groups.filter(|group| seen.insert(group.name.as_str())).collect()
    }

    /// Copy of the scene with the named groups at these factors (≥ 0) of the emission that its materials
    /// state, whatever factors they had before. Groups that are not named keep theirs.
    ///
    /// # Errors
    /// An unknown group, one that is set twice, the name of a variable; a factor that is not finite or below 0.
    pub fn dimmed(&self, settings: &[(&str, f64)]) -> Result<Self, SceneError> {
        let factors = self.factors(settings).map_err(|located| self.error(located))?;
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
                return Err(Located::nowhere(unknown_group(name, &groups)));
            }
            check_factor(*factor)
                .map_err(|fault| Located::nowhere(fault).within(|| title("light group", name)))?;
            if factors.insert(*name, *factor).is_some() {
                let cause = format!("the light group {name:?} is set twice");
                return Err(Located::nowhere(Fault::conflict(cause, "keep one of them")));
            }
        }
        Ok(factors)
    }

    /// The fault of a setting that names a variable, which dims nothing.
    fn of_variable(&self, name: &str) -> Fault {
        if self.light_groups().iter().any(|group| group.name == name) {
            return Fault::variable_and_group(name);
        }
        let cause = format!("{name:?} is a variable, which is set when the scene is read");
        let cure = words("give the scene itself with ") + set("set", format!("{name}=…"));
        Fault::conflict(cause, cure + ", not a solution of it")
    }
}

/// A light group of which nothing emits.
fn unknown_group(name: &str, groups: &[&LightGroup]) -> Fault {
    let known = groups.iter().map(|group| group.name.clone()).collect();
    let cause = format!("no light comes from a group {name:?}");
    let unknown = || Fault::unknown_group(cause, name, known, ", and solve it again");
    HeatSetting::misplaced(name).unwrap_or_else(unknown)
}
