//! Settings of heat: a copy of a scene with another temperature, flux or emissivity of some of its surfaces.

use std::fmt;

use radiosity_fit::sides::front_of;
use radiosity_work::wording::{command, words};

use crate::{
    Scene,
    error::{Located, SceneError},
    fault::{Fault, FaultKind},
    ranges::check_number,
    surface::SceneSurface,
    thermal::{Condition, Thermal, check_emissivity, check_temperature},
};

/// The mark behind which the name of a surface may end in any way.
const ANY_ENDING: char = '*';

/// A quantity of heat that is set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum HeatQuantity {
    /// Temperature (K).
    Temperature,
    /// Flux (W m⁻²) that is given and sent out as radiation.
    HeatFlux,
    /// Emissivity.
    Emissivity,
}

/// A quantity of heat of the surfaces that a name means: a surface with both sides, where these have one material; all
/// surfaces whose names begin alike, for a name that ends in `*`; or the surfaces of a material.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HeatSetting {
    name: String,
    quantity: HeatQuantity,
}

impl HeatQuantity {
    const ALL: [Self; 3] = [Self::Temperature, Self::HeatFlux, Self::Emissivity];

    /// The key of the quantity in files of scenes.
    fn key(self) -> &'static str {
        match self {
            Self::Temperature => "temperature",
            Self::HeatFlux => "heat_flux",
            Self::Emissivity => "emissivity",
        }
    }

    fn check(self, value: f64) -> Result<(), Fault> {
        match self {
            Self::Temperature => check_temperature(value),
            Self::HeatFlux => check_number(value),
            Self::Emissivity => check_emissivity(value),
        }
    }

    fn put(self, thermal: &mut Thermal, value: f64) {
        match self {
            Self::Temperature => thermal.condition = Some(Condition::Temperature(value)),
            Self::HeatFlux => thermal.condition = Some(Condition::HeatFlux(value)),
            Self::Emissivity => thermal.emissivity = Some(value),
        }
    }
}

impl HeatSetting {
    /// The setting that a text names, such as `panel.emissivity`.
    ///
    /// # Errors
    /// [`FaultKind::UnknownKey`] for another key,
    /// [`FaultKind::MissingKey`] where there is none.
    pub fn named(text: &str) -> Result<Self, Fault> {
        let known = HeatQuantity::ALL.map(HeatQuantity::key);
        let Some((name, key)) = text.rsplit_once('.') else {
            let cause = format!("{text:?} has no key behind a point");
            let cure = format!("write {text}.KEY with one of {} as KEY", known.join(", "));
            return Err(Fault::new(FaultKind::MissingKey, cause, cure));
        };
        let quantity = HeatQuantity::ALL.into_iter().find(|quantity| quantity.key() == key);
        let quantity = quantity.ok_or_else(|| Fault::unknown_key(key, &known))?;
        Ok(Self { name: name.to_owned(), quantity })
    }

    /// The fault of a quantity of heat that is set where only light groups or variables are; None for other names.
    pub fn misplaced(text: &str) -> Option<Fault> {
        Self::named(text).ok()?;
        let cause = format!("{text:?} is a quantity of heat, which is not set here");
        Some(Fault::conflict(cause, words("only ") + command("heat") + " takes it"))
    }

    /// Whether it is the emissivity that is set, on which what is reflected depends.
    pub fn is_of_emissivity(&self) -> bool {
        self.quantity == HeatQuantity::Emissivity
    }

    /// Whether a surface has the name.
    fn means(&self, surface: &SceneSurface) -> bool {
        match self.name.strip_suffix(ANY_ENDING) {
            Some(stem) => surface.name.starts_with(stem),
            None => surface.name == self.name,
        }
    }
}

impl fmt::Display for HeatSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.name, self.quantity.key())
    }
}

impl Scene {
    /// Copy of the scene with a quantity of heat at this value. The copy has no `source`.
    ///
    /// # Errors
    /// [`FaultKind::UnknownName`], which lists the surfaces and materials; a number out
    /// of range; [`FaultKind::Conflict`] where a surface and a material of others have that
    /// name.
    pub fn with_heat(&self, setting: &HeatSetting, value: f64) -> Result<Self, SceneError> {
        let refused = |fault| {
            let located = Located::nowhere(fault).within(|| setting.to_string());
            self.error(located)
        };
        setting.quantity.check(value).map_err(refused)?;
        let meant = self.meant(setting).map_err(refused)?;
        let mut scene = Self { source: None, ..self.clone() };
        for surface in meant {
            setting.quantity.put(&mut scene.surfaces[surface].thermal, value);
        }
        Ok(scene)
    }

    /// The surfaces that a setting means.
    fn meant(&self, setting: &HeatSetting) -> Result<Vec<usize>, Fault> {
        let chosen = |is_meant: &dyn Fn(&SceneSurface) -> bool| -> Vec<usize> {
            let all = self.surfaces.iter().enumerate();
            all.filter(|(_, surface)| is_meant(surface)).map(|(index, _)| index).collect()
        };
        let by_name = chosen(&|surface| setting.means(surface) || self.is_back_of_meant(surface, setting));
        let by_material = chosen(&|surface| surface.material_name.as_ref() == Some(&setting.name));
        let name = &setting.name;
        match (by_name.is_empty(), by_material.is_empty()) {
            (false, true) => Ok(by_name),
            (true, false) => Ok(by_material),
            (false, false) if by_name == by_material => Ok(by_name),
            (false, false) => Err(Fault::conflict(
                format!("{name:?} is a surface, and a material of others, too"),
                "give one of them another name in the scene",
            )),
            (true, true) => Err(self.unknown_holder(name)),
        }
    }

    /// Whether it is the back, of one material with the front, of a surface that a setting means.
    fn is_back_of_meant(&self, surface: &SceneSurface, setting: &HeatSetting) -> bool {
        let front = surface.other_side.map(|other| &self.surfaces[other]);
        front.is_some_and(|front| {
            front_of(&surface.name) == Some(front.name.as_str())
                && setting.means(front)
                && front.material_name == surface.material_name
        })
    }

    /// The fault of a name that nothing with heat has.
    fn unknown_holder(&self, name: &str) -> Fault {
        let cause = format!("no surface and no material is called {name:?}");
        let is_any = |is_meant: &dyn Fn(&str) -> bool| self.surfaces.iter().any(|own| is_meant(&own.name));
        let front = front_of(name).filter(|front| is_any(&|own| own == *front));
        if front.is_some() {
            let cure =
                "the back of a surface of one side is set in the file: back = \"front\" or back = … (K)";
            return Fault::new(FaultKind::UnknownName, cause, cure);
        }
        let stem = format!("{name}-");
        if is_any(&|own| own.starts_with(&stem)) {
            let cure = format!("write \"{stem}*\" for all surfaces whose names begin with \"{stem}\"");
            return Fault::new(FaultKind::UnknownName, cause, cure);
        }
        let materials = self.surfaces.iter().filter_map(|surface| surface.material_name.clone());
        let mut known: Vec<String> = self.surfaces.iter().map(|surface| surface.name.clone()).collect();
        known.extend(materials);
        known.sort_unstable();
        known.dedup();
        Fault::unknown_name(cause, name, known, "surfaces and materials of this scene")
    }
}
