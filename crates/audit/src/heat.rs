//! Heat by walks: what surfaces of known temperature or flux exchange, with errors.
//!
//! With the level σ T⁴ and the emissivity ε the walks are those of light, of which
//!
//! ```text
//! T known:   M = ε σ T⁴ ,   ρ = 1 − ε ;        flux q known:   M = q ,   ρ = 1 ;
//! sheet of two sides, its flux known:   M = ε (level of the flux alone) ,   ρ = 1 − ε ,   ε leaves anywhere .
//! ```
//!
//! The backs of surfaces of one side are sides with conditions of their own
//! ([`BackCondition`](radiosity_scene::BackCondition)). What leaves the scene is lost to 0 K. Beside them the same
//! walks carry light by which all of known temperature and the surroundings have the level 1, so that its irradiance U
//! has the mean 1. With a level L₀ chosen beforehand
//!
//! ```text
//! H̄ = L₀ + ⟨ H − L₀ U ⟩
//! ```
//!
//! is unbiased, and without noise where all have the level L₀. It is the level of the surface that is judged,
//! or else the mean of the known ones by absorbing area. Then
//!
//! ```text
//! T known:   q = ε (σ T⁴ − H̄) ;     q known:   σ T⁴ = H̄ + q/ε ;     flow  Q = q A ,
//! ```
//!
//! with A of what nothing stands on. T is that of the mean of σ T⁴, its error that of the level over 4 σ T³.
//!
//! Reference: Modest, Radiative Heat Transfer, chapters 5 and 8 (Monte Carlo).

mod fault;
mod roles;
mod parts;
mod figures;

use std::collections::{BTreeMap, BTreeSet};

use radiosity_geom::Rect;
use radiosity_scene::Scene;
use radiosity_work::Work;

use crate::effort::Effort;
use crate::groups::Groups;
use crate::lamps::Lamps;
use crate::rays::Rays;
use crate::referee::{Shift, read};
use crate::sheets::Sheet;
use crate::skin::{Absorbed, Skin};
use crate::spectrum::Spectrum;
use crate::spot::Spot;
use crate::suns::Suns;
use crate::walk::Ground;

pub use fault::HeatFault;
pub use figures::HeatEstimate;
use figures::{Irradiance, estimate, flow};
use parts::floating;
use roles::{Role, Roles};

/// Kinds of light that walks of heat carry: of the levels, and of the level 1.
const KINDS: usize = 2;

/// Width of both long margins of a surface together, over the distance within which others touch it. Chosen: walls at
/// an angle of 14° rise to that within four such distances.
const MARGIN: f64 = 8.0;

/// A scene, whose heat is read by walks.
#[derive(Debug)]
pub struct HeatReferee {
    rays: Rays,
    groups: Groups,
    roles: Roles,
    sheets: Vec<Sheet>,
    /// Surfaces that heat neither gets to nor leaves, of which nothing is told.
    without_level: BTreeSet<usize>,
    /// Mean of the known levels by absorbing area (W m⁻²); 0 where none is known.
    mean_level: f64,
}

impl HeatReferee {
    /// The referee of the heat of a scene.
    ///
    /// # Errors
    /// Surfaces that transmit, without a temperature or a flux, without an emissivity that is needed, or
    /// whose heat is given and can end nowhere.
    pub fn of(scene: &Scene) -> Result<Self, HeatFault> {
        let given = scene.surfaces.len();
        let scene = &scene.with_backs(&scene.one_sided());
        let mut roles = Roles::of(scene)?;
        let rays = Rays::of(scene);
        let mean_level = mean_level(&rays, &roles);
        let without_level: BTreeSet<usize> = floating(&rays, &roles).into_iter().collect();
        let is_given = |surface: &&usize| **surface < given && !roles.is_adiabatic(**surface);
        let name = |surface: &usize| scene.shown_name(*surface).to_owned();
        let surfaces: Vec<String> = without_level.iter().filter(is_given).map(name).collect();
        if !surfaces.is_empty() {
            return Err(HeatFault::NoLevel { surfaces });
        }
        // No heat gets to what is adiabatic and sees its like alone, as backs within a body; a walk that slips in ends
        // there.
        for surface in &without_level {
            roles.list[*surface] = Role::Temperature { emissivity: 1.0, level: mean_level };
        }
        let sheet = |own: &roles::Pair| Sheet::new(&rays, own.sides, own.emissivities, own.flux);
        let sheets = roles.pairs.iter().map(sheet).collect();
        Ok(Self { groups: Groups::of(scene), mean_level, sheets, rays, roles, without_level })
    }

    /// The heat of these surfaces, by their indices in the scene, in order: the same on any number of threads
    /// and ranks. Of those whose walks were not done when time was up there is none.
    pub fn estimates(&self, surfaces: &[usize], effort: &Effort, work: &Work<'_>) -> Vec<HeatEstimate> {
        let mut asked: Vec<usize> = surfaces.iter().flat_map(|own| self.asked_for(*own)).collect();
        asked.sort_unstable();
        asked.dedup();
        let spots: Vec<Spot> = asked.iter().map(|surface| Spot::Surface(*surface)).collect();
        let shifts = read(&self.rays, &[self.ground()], KINDS, &spots, effort, work);
        let done =
            asked.into_iter().zip(&shifts).filter_map(|(surface, own)| Some((surface, own.as_deref()?)));
        let read: BTreeMap<usize, &[Shift]> = done.collect();
        let is_read = |surface: &usize| self.asked_for(*surface).iter().all(|own| read.contains_key(own));
        let estimate = |surface: &usize| match is_read(surface) && !self.without_level.contains(surface) {
            true => self.estimate(*surface, &read),
            false => HeatEstimate::of_nothing(*surface),
        };
        surfaces.iter().map(estimate).collect()
    }

    /// The surfaces whose irradiance tells the heat of this one.
    fn asked_for(&self, surface: usize) -> Vec<usize> {
        match self.roles.list[surface] {
            Role::Sheet { sheet, .. } => self.sheets[sheet].sides.to_vec(),
            Role::Temperature { .. } | Role::Flux { .. } => vec![surface],
        }
    }

    fn ground(&self) -> Ground<'_> {
        let skin = |role: &Role| match *role {
            Role::Temperature { emissivity, level } => {
                Skin::grey([emissivity * level, emissivity], 1.0 - emissivity, Absorbed::Kept)
            }
            Role::Flux { flux, .. } => Skin::grey([flux, 0.0], 1.0, Absorbed::Kept),
            Role::Sheet { emissivity, sheet } => {
                let exitance = emissivity * self.sheets[sheet].level;
                Skin::grey([exitance, 0.0], 1.0 - emissivity, Absorbed::Sheet { sheet, emissivity })
            }
        };
        Ground {
            rays: &self.rays,
            groups: &self.groups,
            skins: self.roles.list.iter().map(skin).collect(),
            lamps: Lamps::none(self.rays.count()),
            suns: Suns::none(),
            sheets: &self.sheets,
            surroundings: Spectrum::of(0, &[0.0, 1.0]),
            going_on: 1.0,
        }
    }

    /// Part of a surface that lies beside what touches it.
    fn margin(&self, surface: usize) -> f64 {
        let bounds = self.rays.shape(surface).bounds(&Rect::FULL);
        let length = (bounds.max - bounds.min).max_element();
        MARGIN * self.rays.touching(surface) * length / self.rays.area(surface)
    }

    fn estimate(&self, surface: usize, read: &BTreeMap<usize, &[Shift]>) -> HeatEstimate {
        let role = &self.roles.list[surface];
        let reference = match *role {
            Role::Temperature { level, .. } => level,
            Role::Flux { .. } | Role::Sheet { .. } => self.mean_level,
        };
        let above = |surface: usize, k: usize| {
            let own = &read[&surface][k];
            own.mean(0) - reference * own.mean(1)
        };
        let irradiance = |k: usize| Irradiance {
            reference,
            above: above(surface, k),
            sheet: match *role {
                Role::Sheet { sheet, .. } => {
                    let Sheet { level, first, sides: [front, back], .. } = self.sheets[sheet];
                    level + first * above(front, k) + (1.0 - first) * above(back, k)
                }
                Role::Temperature { .. } | Role::Flux { .. } => 0.0,
            },
            bare: read[&surface][k].bare,
        };
        let all: Vec<Irradiance> = (0..Effort::SHIFTS).map(irradiance).collect();
        let rays = self.asked_for(surface).iter().flat_map(|own| read[own]).map(|own| own.rays).sum();
        let flow = flow(role, &all, self.rays.area(surface), self.margin(surface));
        HeatEstimate { rays, flow, ..estimate(surface, role, &all) }
    }
}

/// The mean of the known levels by absorbing area.
fn mean_level(rays: &Rays, roles: &Roles) -> f64 {
    let (mut sum, mut weights) = (0.0, 0.0);
    for (surface, role) in roles.list.iter().enumerate() {
        if let Role::Temperature { emissivity, level } = role {
            let weight = emissivity * rays.area(surface);
            sum += weight * level;
            weights += weight;
        }
    }
    if weights > 0.0 { sum / weights } else { 0.0 }
}
