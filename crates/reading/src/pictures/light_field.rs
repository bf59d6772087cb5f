//! One light field: reflected light on surfaces, computed at few nodes that are kept, and fitted between them.
//!
//! Every surface has lattices of nodes over its parameters, each twice as fine as the one before (`lattice`); a
//! node outside of the open part of a flat surface lies on its border. Of a place that is asked for, the four
//! nodes about it are computed, those of the coarsest lattice first, and a polynomial is fitted to the nodes
//! around (`fit`). The next lattice is asked where one of the four is missing, where the fit leaves more than
//!
//! ```text
//! r √(E max(E, Ē)) ,     E all light of the place, Ē the mean of the scene,
//! ```
//!
//! beside the nodes' own errors, where polynomials of one degree less say something else or leave much more, or where
//! it amplifies errors, until nodes are nearly as near to each other as the places are that are shown: where no fit
//! holds then, and in narrow gaps, light is gathered at the place itself. From half of that on the
//! fits of both lattices are mixed, so that light has no steps where one takes over. In the dark more is allowed, as
//! eyes and pictures do. Nodes are shared by all places, whatever shows them: pixels, their samples,
//! texels. Their number grows with the detail of the light, not with that of the places. Where a lattice of a surface
//! wants more new nodes than there are places on it, as on small parts, light is gathered at these too.
//!
//! References: G. Ward, F. Rubinstein, R. Clear, *A ray tracing solution for diffuse interreflection*, SIGGRAPH
//! 1988 (interpolation of indirect light between points that are kept; there by the distances of what is seen,
//! here by what the fit leaves).

pub(crate) mod extent;
pub(crate) mod open_part;
pub(crate) mod fit;
mod lattice;
pub(crate) mod spot;
pub(crate) mod spot_gatherer;

use std::collections::{BTreeMap, BTreeSet, HashMap};

use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::eye::SeenPlace;
use super::picture_light::PictureLight;
use super::pixel_count::PixelCount;
use fit::{Fit, FitResult};
use lattice::{Lattice, NodeIndex};
use spot::{PlaceKey, Spot};
use spot_gatherer::{SpotGatherer, SpotLight};

/// Fineness of a field.
#[derive(Clone, Copy, Debug)]
struct Fineness {
    /// Most residual r of a fit.
    rough: f64,
    /// Most residual of a fit of degree 1, over r, where one of degree 2 is taken: three rows of nodes leave nothing of
    /// this one, also at a border within whose last cell light falls.
    curved: f64,
    /// Distance of nodes over that of shown places up to which no finer ones are asked for.
    finest: f64,
}

/// Fineness by cells. Chosen: nodes take some microseconds and do not err. Curved ones measured in the Cornell box of
/// 160 × 160 pixels: without a limit and with 6, 4, 3, 2 and 1.5 pictures erred by .37, .37, .36, .34, .32 and .30 %
/// (L2) in .67, .64, .67, .74, .79 and .87 s.
const BY_CELLS: Fineness = Fineness { rough: 4e-3, curved: 4.0, finest: 1.0 };

/// Fineness by rays. Measured in an office of 200 × 150 pixels, each with one sample: with r = 5e-3, 1e-2 and 2e-2
/// pictures erred by 0.9, 1.2 and 2.2 % (L2), most at edges, with 4768, 4124 and 3041 nodes and 1700, 1000 and 100
/// places that were gathered alone; up to 2.5 times the distance of pixels with 1.2 %, 5881 and 400. Curved ones
/// measured there, 160 × 120 pixels: without a limit and with 2, 1.5 and 1 pictures erred by 1.23, 1.03, .94 and .90 %
/// in 2.2, 2.3, 2.45 and 2.6 s, and with half of r in place of a limit by 1.05 % in 2.4 s.
const BY_RAYS: Fineness = Fineness { rough: 7e-3, curved: 1.5, finest: 5.0 };

/// Trust in the fit of the finest lattice from which on it is taken. Chosen: less leaves more than is allowed.
const TRUSTED: f64 = 0.5;

/// Distance of nodes over that of shown places up to which twice the residual is allowed: such places are small.
/// Chosen.
const SMALL: f64 = 8.0;

/// Places that one thread fits after each other. Chosen: they take some microseconds each.
const TOGETHER: usize = 256;

/// A place of which the light is asked for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AskedPlace {
    /// The place.
    pub seen: SeenPlace,
    /// Distance of the places beside it that are shown (scene length).
    pub footprint: f64,
    /// Sum over the bands of other light there (W m⁻²).
    pub beside: f64,
    /// Factor on the error of light that is gathered at the place itself.
    pub error_factor: f64,
}

/// A place, by its index, whose light is not known yet but for the rest of this share.
#[derive(Clone, Copy, Debug)]
struct OpenPlace {
    place: usize,
    share: f64,
}

/// The light of a place by the nodes of one lattice.
#[derive(Clone, Debug, Serialize, Deserialize)]
enum FittedLight {
    /// Irradiance per band (W m⁻²), with the share that it gets; the rest is for a finer lattice.
    Found { bands: Vec<f64>, trust: f64 },
    /// All is for a finer one.
    Finer,
    /// It is to be gathered at the place itself.
    Alone,
}

/// Who knows the light of spots in one frame.
pub(crate) trait SpotSource: Sync {
    /// The light of these spots; None of a node where no open place is near or in a narrow gap, and of a place of which
    /// the source does not know it.
    fn spots(&mut self, wanted: &[Spot], work: &Work<'_>) -> Vec<Option<SpotLight>>;
}

/// Reflected light on the surfaces of a scene, as far as it was asked for.
pub(crate) struct LightField<'a> {
    light: &'a PictureLight<'a>,
    gatherer: SpotGatherer<'a>,
    /// Who knows the light of spots; None where all are gathered.
    source: Option<&'a mut (dyn SpotSource + 'a)>,
    /// Nodes that were asked for; None where no open place is near, and in narrow gaps.
    nodes: HashMap<NodeIndex, Option<SpotLight>>,
}

impl<'a> LightField<'a> {
    /// The reflected light of `light` in a scene of this diagonal; none is computed.
    pub(crate) fn new(light: &'a PictureLight<'a>, diagonal: f64) -> Self {
        Self { light, gatherer: SpotGatherer::new(light, diagonal), source: None, nodes: HashMap::new() }
    }

    /// The reflected light of `light`, of which `source` knows spots in a scene of this diagonal.
    pub(crate) fn known_by(
        source: &'a mut (dyn SpotSource + 'a),
        light: &'a PictureLight<'a>,
        diagonal: f64,
    ) -> Self {
        Self { source: Some(source), ..Self::new(light, diagonal) }
    }

    /// Irradiance per band (W m⁻²) of all places, bands fastest; nodes that are computed are told.
    pub(crate) fn at(&mut self, places: &[Option<AskedPlace>], work: &Work<'_>) -> Vec<f64> {
        let bands = self.light.solution().bands().len();
        let mut values = vec![0.0; places.len() * bands];
        let (in_gaps, outside) = self.by_gaps(places);
        let whole = |places: Vec<usize>| -> Vec<OpenPlace> {
            places.into_iter().map(|place| OpenPlace { place, share: 1.0 }).collect()
        };
        let (mut alone, mut open) = (whole(in_gaps), whole(outside));
        self.gatherer.prepare(places.iter().flatten().map(|asked| asked.seen.place.surface));
        let mut level = 0;
        while !open.is_empty() {
            let asked_by = |open: &OpenPlace| places[open.place].as_ref();
            let mut wanted = self.wanted(level, open.iter().filter_map(asked_by));
            let sparse = sparse(&wanted, open.iter().filter_map(asked_by));
            let is_sparse = |surface: usize| sparse.contains(&surface);
            wanted.retain(|node| !is_sparse(node.surface));
            let (few, others): (Vec<OpenPlace>, Vec<OpenPlace>) = open
                .into_iter()
                .partition(|open| asked_by(open).is_some_and(|asked| is_sparse(asked.seen.place.surface)));
            alone.extend(few);
            open = others;
            self.compute(wanted, work);
            let asked = |index: usize| asked_by(&open[index]);
            let fit =
                |index: usize| asked(index).map_or(FittedLight::Finer, |asked| self.fitted(asked, level));
            let found: Vec<FittedLight> =
                work.ranks.map_even(PartName::FittedLight, open.len(), TOGETHER, fit);
            let mut left = Vec::new();
            for (own @ OpenPlace { place, share }, found) in open.into_iter().zip(found) {
                match found {
                    FittedLight::Finer => left.push(own),
                    FittedLight::Alone => alone.push(own),
                    FittedLight::Found { bands: fitted, trust } => {
                        let own = &mut values[place * bands..(place + 1) * bands];
                        own.iter_mut().zip(fitted).for_each(|(sum, value)| *sum += share * trust * value);
                        if trust < 1.0 {
                            left.push(OpenPlace { place, share: share * (1.0 - trust) });
                        }
                    }
                }
            }
            open = left;
            level += 1;
        }
        for (OpenPlace { place, share }, light) in alone.iter().zip(self.each(places, &alone, work)) {
            let own = &mut values[place * bands..(place + 1) * bands];
            own.iter_mut().zip(light).for_each(|(sum, value)| *sum += share * value);
        }
        values
    }

    /// The places in narrow gaps, and the others.
    fn by_gaps(&self, places: &[Option<AskedPlace>]) -> (Vec<usize>, Vec<usize>) {
        let asked = (0..places.len()).into_par_iter().filter(|place| places[*place].is_some());
        asked
            .partition(|place| places[*place].as_ref().is_some_and(|asked| self.light.is_in_gap(&asked.seen)))
    }

    /// Irradiance per band (W m⁻²) of each of some places, as the source knows it or gathered there.
    fn each(&mut self, places: &[Option<AskedPlace>], some: &[OpenPlace], work: &Work<'_>) -> Vec<Vec<f64>> {
        let asked: Vec<&AskedPlace> = some.iter().filter_map(|open| places[open.place].as_ref()).collect();
        let mut known = vec![None; asked.len()];
        if let Some(source) = &mut self.source {
            let spots: Vec<Spot> = asked
                .iter()
                .map(|asked| Spot::Place(PlaceKey::of(&asked.seen, asked.error_factor)))
                .collect();
            known = source.spots(&spots, work);
        }
        let open: Vec<usize> = (0..asked.len()).filter(|index| known[*index].is_none()).collect();
        let count = PixelCount::new(open.len(), Stage::GatheredPixels, work);
        let one = |index: usize| {
            let AskedPlace { seen, error_factor, .. } = asked[open[index]];
            let light = self.gatherer.gathered(seen, *error_factor);
            count.add();
            light
        };
        let gathered = work.ranks.map_even(PartName::GatheredLight, open.len(), 1, one);
        let mut lights: Vec<Vec<f64>> =
            known.into_iter().map(|known| known.map_or_else(Vec::new, |known| known.light.bands)).collect();
        for (index, light) in open.into_iter().zip(gathered) {
            lights[index] = light.light.bands;
        }
        lights
    }

    /// The nodes of a lattice about these places that were not asked for yet, in order.
    fn wanted<'b>(&self, level: u32, places: impl Iterator<Item = &'b AskedPlace>) -> Vec<NodeIndex> {
        let about = |asked: &AskedPlace| self.lattice(asked).about(asked.seen.place.parameters, level);
        let mut wanted: Vec<NodeIndex> = places.flat_map(about).collect();
        wanted.sort_unstable();
        wanted.dedup();
        wanted.retain(|node| !self.nodes.contains_key(node));
        wanted
    }

    /// Computes the light of these nodes.
    fn compute(&mut self, wanted: Vec<NodeIndex>, work: &Work<'_>) {
        let spots: Vec<Spot> = wanted.iter().copied().map(Spot::Node).collect();
        let computed = match &mut self.source {
            Some(source) => source.spots(&spots, work),
            None => self.gatherer.spots(&spots, work),
        };
        self.nodes.extend(wanted.into_iter().zip(computed));
    }

    fn lattice(&self, asked: &AskedPlace) -> &Lattice {
        self.gatherer.lattice(asked.seen.place.surface)
    }

    /// The light of a place by the nodes of a lattice around it.
    fn fitted(&self, asked: &AskedPlace, level: u32) -> FittedLight {
        let lattice = self.lattice(asked);
        let fit = self.fit(lattice, asked, level);
        let is_enclosed = lattice
            .about(asked.seen.place.parameters, level)
            .all(|node| self.known(&node).is_some_and(|node| asked.seen.goes_with(&node.seen)));
        let apart = lattice.side(level) / asked.footprint;
        let is_last = apart < self.fineness().finest || level == Lattice::FINEST;
        let found = fit.found();
        let trust = |found: &FitResult| self.trust(found, apart <= SMALL, asked.beside);
        let trust = found.as_ref().filter(|_| is_enclosed).map_or(0.0, trust);
        match found {
            Some(found) if trust >= TRUSTED || (trust > 0.0 && !is_last) => {
                let bands = found.value.iter().map(|value| value.max(0.0)).collect();
                FittedLight::Found { bands, trust: if is_last { 1.0 } else { trust } }
            }
            _ if is_last => FittedLight::Alone,
            _ => FittedLight::Finer,
        }
    }

    fn fineness(&self) -> Fineness {
        if self.light.gathers_by_rays() { BY_RAYS } else { BY_CELLS }
    }

    /// Share, from 0 to 1, that the value of a fit gets beside `other` light, where more is allowed if it
    /// `is_small`. Light below 0 by no more than a fit may leave is none.
    fn trust(&self, found: &FitResult, is_small: bool, other: f64) -> f64 {
        let all = found.value.iter().map(|value| value.max(0.0)).sum::<f64>() + other;
        let fineness = self.fineness();
        let rough = if is_small { 2.0 } else { 1.0 } * fineness.rough * self.light.judged_by(all);
        if found.value.iter().any(|value| *value < -rough) {
            return 0.0;
        }
        (2.0 * (1.0 - found.left_on_few_lines(fineness.curved) / rough)).clamp(0.0, 1.0)
    }

    /// A node that is computed.
    fn known(&self, node: &NodeIndex) -> Option<&SpotLight> {
        self.nodes.get(node)?.as_ref()
    }

    /// The fit of the nodes around a place, on the same smooth surface.
    fn fit(&self, lattice: &Lattice, asked: &AskedPlace, level: u32) -> Fit<'_> {
        let mut fit = Fit::new();
        let seen = &asked.seen;
        for node in lattice.around(seen.place.parameters, level) {
            let Some(SpotLight { seen: there, light, .. }) = self.known(&node) else { continue };
            let weight = lattice.weight(seen.place.parameters, there.place.parameters, level);
            if weight > 0.0 && seen.goes_with(there) {
                fit.take(offset(seen, there), weight, &light.bands, light.error);
            }
        }
        fit
    }
}

/// Surfaces on which more nodes are wanted than there are places.
fn sparse<'a>(wanted: &[NodeIndex], places: impl Iterator<Item = &'a AskedPlace>) -> BTreeSet<usize> {
    let mut spare: BTreeMap<usize, isize> = BTreeMap::new();
    wanted.iter().for_each(|node| *spare.entry(node.surface).or_default() -= 1);
    places.for_each(|asked| {
        spare.entry(asked.seen.place.surface).and_modify(|spare| *spare += 1);
    });
    spare.into_iter().filter(|(_, spare)| *spare < 0).map(|(surface, _)| surface).collect()
}

/// The offset of a place in the tangent plane of another (scene length).
pub(crate) fn offset(from: &SeenPlace, to: &SeenPlace) -> [f64; 2] {
    let (along, across) = from.normal.any_orthonormal_pair();
    let step = to.place.position - from.place.position;
    [step.dot(along), step.dot(across)]
}
