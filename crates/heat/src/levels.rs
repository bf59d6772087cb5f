//! Whether temperatures set the level of all parts of a scene.
//!
//! In a part of a scene whose surfaces exchange heat with one another alone, all of known flux, any constant
//! may be added to σ T⁴: there is no balance, or there are many. Where all are adiabatic, nothing flows at any
//! level, and none of the others takes part: the flows of the rest are as without them.

use std::collections::BTreeMap;

use radiosity_kernel::PlacedBlock;
use radiosity_scene::Scene;
use radiosity_solve::{Model, Options};
use radiosity_work::ranks::Ranks;

use super::error::HeatError;
use super::figures::{areas, received};
use super::roles::{Role, Roles, named};

/// Share of its heat that a part has to lose to count as open, over the accuracy of the blocks: what it seems
/// to lose by their errors alone is less. With a smaller value a closed part would pass, and its temperature
/// be anything.
const OPEN: f64 = 10.0;

/// Exchange between surfaces where all emit 1, whatever they are.
#[derive(Debug)]
pub(super) struct Exchange {
    surfaces: Vec<Exchanged>,
    /// Surfaces that exchange heat with one another.
    joined: Joined,
    /// Largest error of transfers over what is exchanged.
    error: f64,
}

/// Exchange of one surface.
#[derive(Clone, Copy, Debug, Default)]
struct Exchanged {
    area: f64,
    /// Power that reaches it.
    received: f64,
}

impl Exchange {
    /// The exchange by the transfers of a model.
    pub(super) fn of(model: &Model) -> Self {
        let (elements, list) = (model.elements(), model.elements().list());
        let received = received(elements, &model.blocks().apply(&elements.constant()));
        let surfaces = areas(elements).into_iter().zip(received);
        let surfaces = surfaces.map(|(area, received)| Exchanged { area, received }).collect();
        let mut joined = Joined::none(elements.surfaces());
        for PlacedBlock { row, column, .. } in model.blocks().iter() {
            joined.join([row, column].map(|element| list[element].surface));
        }
        let joined = joined.of_all(model.blocks().held().ranks());
        Self { surfaces, joined, error: model.blocks().statistics.accuracy_reached }
    }

    /// Makes surfaces idle that neither gain nor lose heat and whose part has neither a temperature nor an opening.
    ///
    /// # Errors
    /// Such a part in which heat is given.
    pub(super) fn settle(
        &self,
        scene: &Scene,
        roles: &mut Roles,
        options: &Options,
    ) -> Result<(), HeatError> {
        let open = OPEN * options.eps.max(options.shadow_eps).max(self.error);
        let parts = self.parts(roles);
        let mut sums: BTreeMap<usize, Part> = BTreeMap::new();
        for (surface, own) in self.surfaces.iter().enumerate().filter(|(_, own)| own.area > 0.0) {
            let part = sums.entry(parts[surface]).or_default();
            part.area += own.area;
            part.kept += own.received;
            part.has_temperature |= matches!(roles.list[surface], Role::Temperature { .. });
            part.is_given |= !roles.is_adiabatic(surface);
        }
        let floats = |part: &Part| !part.has_temperature && part.kept > (1.0 - open) * part.area;
        sums.retain(|_, part| floats(part));
        match sums.iter().find(|(_, part)| part.is_given) {
            None => {
                roles.idle(|surface| sums.contains_key(&parts[surface]));
                Ok(())
            }
            Some((floating, _)) => {
                Err(HeatError::NoLevel { surfaces: named(scene, |surface, _| parts[surface] == *floating) })
            }
        }
    }

    /// For each surface the first surface of its part: surfaces that exchange heat, and sides of one shield.
    fn parts(&self, roles: &Roles) -> Vec<usize> {
        let mut joined = self.joined.clone();
        roles.shields.iter().for_each(|shield| joined.join(shield.sides));
        joined.firsts()
    }
}

/// Surfaces in parts, each a tree whose root is its first surface (R. E. Tarjan, *J. ACM* 22 (1975) 215-225).
#[derive(Clone, Debug)]
struct Joined {
    parents: Vec<usize>,
}

impl Joined {
    /// So many surfaces, each a part of its own.
    fn none(surfaces: usize) -> Self {
        Self { parents: (0..surfaces).collect() }
    }

    /// Makes the parts of two surfaces one.
    fn join(&mut self, pair: [usize; 2]) {
        let [a, b] = pair.map(|surface| self.root(surface));
        self.parents[a.max(b)] = a.min(b);
    }

    /// The parts that the pairs of all ranks make.
    fn of_all(mut self, ranks: &Ranks) -> Self {
        for own in ranks.all(self.firsts()) {
            own.into_iter().enumerate().for_each(|(surface, first)| self.join([surface, first]));
        }
        self
    }

    /// The first surface of the part of each.
    fn firsts(&mut self) -> Vec<usize> {
        (0..self.parents.len()).map(|surface| self.root(surface)).collect()
    }

    fn root(&mut self, mut surface: usize) -> usize {
        while self.parents[surface] != surface {
            self.parents[surface] = self.parents[self.parents[surface]];
            surface = self.parents[surface];
        }
        surface
    }
}

/// Sums over the elements of a part.
#[derive(Default)]
struct Part {
    area: f64,
    /// Power that reaches other elements of the part where all emit 1.
    kept: f64,
    has_temperature: bool,
    /// Whether a temperature or a flux other than 0 is given.
    is_given: bool,
}
