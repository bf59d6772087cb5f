//! The data from which masks are made.

use std::borrow::Cow;

use radiosity_elements::Elements;
use radiosity_elements::coating::Coating;
use radiosity_kernel::{Accuracy, Blocks};
use radiosity_scene::MaskedPair;
use radiosity_transport as transport;
use radiosity_visibility::Visibility;
use radiosity_work::Work;

use crate::zatz1993::transfers::{self, PaperRules};

/// The data from which masks are made.
#[derive(Clone, Copy)]
pub struct Setting<'a> {
    /// The elements.
    pub elements: &'a Elements,
    /// The coatings of each emission, band by band.
    pub coatings: &'a [&'a Coating],
    /// The pairs of surfaces that are masked; empty to find them.
    pub chosen: &'a [MaskedPair],
    /// The scene with all obstacles.
    pub visibility: &'a Visibility,
    /// The scene without obstacles.
    pub open: &'a Visibility,
    /// Accuracy of the blocks.
    pub accuracy: Accuracy,
    /// The rules of 1993 instead of those that keep the accuracy.
    pub rules: Option<PaperRules>,
}

impl<'a> Setting<'a> {
    /// The blocks between the elements as far as they are wanted.
    pub(super) fn blocks(
        &self,
        visibility: &Visibility,
        wanted: &(dyn Fn(usize, usize) -> bool + Sync),
        work: &Work<'_>,
    ) -> Blocks {
        let demand = transport::Demand::all(self.elements, visibility, self.accuracy).of(wanted);
        match self.rules {
            Some(rules) => transfers::assemble(demand, rules, rules.extra_points(), work),
            None => transport::assemble(demand, None, work),
        }
    }

    /// Whether an element emits.
    pub(super) fn emits(&self, element: usize) -> bool {
        self.coatings.iter().any(|coating| coating.exitance[element] > 0.0)
    }

    /// Whether an element reflects, or lets light through.
    pub(super) fn reflects(&self, element: usize) -> bool {
        self.coatings.iter().any(|coating| coating.scatters(element))
    }

    /// The coatings whose emitters may be masked: those of the scene, or one by which the chosen emitters
    /// alone emit.
    pub(super) fn emitters(&self) -> Vec<Cow<'a, Coating>> {
        if self.chosen.is_empty() {
            return self.coatings.iter().map(|coating| Cow::Borrowed(*coating)).collect();
        }
        let list = self.elements.list();
        let has = |surface: usize| self.chosen.iter().any(|pair| pair.emitters.contains(&surface));
        let exitance = list.iter().map(|element| f64::from(u8::from(has(element.surface))));
        vec![Cow::Owned(Coating::constant(vec![0.0; list.len()], exitance.collect()))]
    }
}
