//! Direct light over a flat patch of flat diffuse emitters that are far from it: what they send without shadows, times
//! the part of it that rays find visible.
//!
//! Definition. With points x of the patch P, spread evenly over it, and points y of the emitters l, of the exitance E₀
//! and of the density q(y) in the rays (`light::lamps`),
//!
//! ```text
//! D = W v ,     W = 1/|P| Σ_l ∫_P E₀ U_l(x) dA_x ,     v ≈ Σ_k E₀ V κ/q / Σ_k E₀ κ/q        W m⁻² ,
//! ```
//!
//! U_l(x) the form factor of the emitter, by Lambert's formula, and κ its kernel. W is found by a Gauss rule. Where
//! nothing hides anything, or everything, D is exact; in shadow v alone has to be found.
//!
//! Range of use. An emitter is far where the diagonal of the patch is less than twice its distance, and no corner of
//! the patch is behind it: where its plane cuts the patch U_l has a kink, which no rule follows.
//!
//! Error. Gauss rules of 2 and 4 points each way err by 8e-5 of W where the diagonal is up to a quarter of the
//! distance, and by 1e-4 elsewhere.

use std::ops::Range;

use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_geom::{Aabb, DVec3, Plane};
use radiosity_light::emitters::Emitters;
use radiosity_light::lamps::Shares;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_work::interruption::check_interrupt_at;

use crate::gather::receiver::{Receiver, ReceiverPatch};
use crate::gather::sent_rays::SentRays;

/// Diagonals of a patch over its distance from an emitter up to which this is far, and up to which few points are
/// enough.
const FAR: f64 = 2.0;
const VERY_FAR: f64 = 0.25;

/// Gauss points each way where all emitters are very far, and elsewhere.
const FEW_POINTS: usize = 2;
const POINTS: usize = 4;

/// The flat diffuse emitters of a scene.
#[derive(Debug)]
pub(super) struct FlatLamps {
    list: Vec<FlatLamp>,
    /// For each element its place in the list, if it is one.
    places: Vec<Option<u32>>,
}

#[derive(Debug)]
struct FlatLamp {
    element: usize,
    plane: Plane,
    polygons: Vec<Vec<DVec3>>,
    bounds: Aabb,
    /// Exitance per band (W m⁻²).
    exitance: Vec<f64>,
}

/// Emitters that are far from a patch.
pub(super) struct FarLamps<'s> {
    lamps: &'s FlatLamps,
    shares: Shares<'s>,
    /// Irradiance per band without shadows, in the mean over the patch (W m⁻²).
    pub(super) whole: Vec<f64>,
}

impl FlatLamps {
    /// The flat diffuse emitters among these.
    pub(super) fn of(sources: &Emitters) -> Self {
        let lamp = |(element, own): (usize, &Element)| {
            let exitance: Vec<f64> =
                sources.coatings.iter().map(|coating| coating.exitance[element]).collect();
            let is_lamp = own.contact.is_none()
                && exitance.iter().any(|exitance| *exitance > 0.0)
                && !sources.radiances.is_directed(own.surface);
            let plane = own.plane.filter(|_| is_lamp)?;
            let polygons = own.patches.iter().map(Patch::polygon).collect();
            Some(FlatLamp {
                element,
                plane,
                polygons,
                bounds: Aabb::around(own.hull.iter().copied()),
                exitance,
            })
        };
        let list: Vec<FlatLamp> = sources.elements.iter().enumerate().filter_map(lamp).collect();
        let mut places = vec![None; sources.elements.len()];
        list.iter().enumerate().for_each(|(place, lamp)| places[lamp.element] = Some(place as u32));
        Self { list, places }
    }

    /// The emitter that an element is, if it is one.
    fn at(&self, element: usize) -> Option<&FlatLamp> {
        self.places[element].map(|place| &self.list[place as usize])
    }

    /// Those that are far from a receiver; None if it is no flat patch, or they send nothing to it.
    pub(super) fn far_from<'s>(&'s self, rays: &'s SentRays, receiver: &Receiver) -> Option<FarLamps<'s>> {
        let Receiver::Patch(own @ ReceiverPatch { patch: Patch::Flat { corners, .. }, .. }) = receiver else {
            return None;
        };
        let bounds = Aabb::around(corners.iter().copied());
        let relative = |lamp: &FlatLamp| bounds.diagonal() / gap(&bounds, &lamp.bounds);
        let is_before = |lamp: &FlatLamp| corners.iter().all(|corner| lamp.plane.height(*corner) > 0.0);
        let is_far = |lamp: &FlatLamp| relative(lamp) < FAR && is_before(lamp);
        let shares =
            rays.lamps.seen_among(&receiver.witnesses(), |element| self.at(element).is_some_and(is_far));
        let held: Vec<&FlatLamp> =
            self.list.iter().filter(|lamp| shares.density(lamp.element) > 0.0).collect();
        if held.is_empty() {
            return None;
        }
        let points = if held.iter().all(|lamp| relative(lamp) < VERY_FAR) { FEW_POINTS } else { POINTS };
        let whole = without_shadows(own, &held, points);
        whole.iter().any(|light| *light > 0.0).then_some(FarLamps { lamps: self, shares, whole })
    }
}

impl FarLamps<'_> {
    /// Whether an element is one of them.
    pub(super) fn hold(&self, element: usize) -> bool {
        self.shares.density(element) > 0.0
    }

    /// Adds, band by band, first what arrives by the rays of these indices of the sequence that `number` chooses, then
    /// what would without shadows (W m⁻²).
    pub(super) fn add(
        &self,
        rays: &SentRays,
        receiver: &Receiver,
        number: u64,
        indices: Range<u64>,
        sums: &mut [f64],
    ) {
        let (arriving, whole) = sums.split_at_mut(self.whole.len());
        let offset: [f64; 5] = offsets(number);
        for index in indices {
            check_interrupt_at(index);
            let [a, b, c, s, t] = shifted(kronecker::point(index), &offset);
            let (from, weight) = receiver.at([s, t]);
            let target = self.shares.target([a, b, c]);
            let (Some(kernel), Some(lamp)) =
                (from.kernel_to(&target.place.node), self.lamps.at(target.element))
            else {
                continue;
            };
            let is_free = rays.visibility.is_free(from.surface, from.position, target.place.node.position);
            let share = weight * target.place.weight * kernel / target.density;
            for ((arriving, whole), exitance) in arriving.iter_mut().zip(&mut *whole).zip(&lamp.exitance) {
                *whole += share * exitance;
                *arriving += if is_free { share * exitance } else { 0.0 };
            }
        }
    }
}

/// Distance between two boxes (scene length).
fn gap(own: &Aabb, other: &Aabb) -> f64 {
    (own.min - other.max).max(other.min - own.max).max(DVec3::ZERO).length()
}

/// Irradiance per band of lamps without shadows, in the mean over a patch, by a Gauss rule of so many points each way
/// (W m⁻²).
fn without_shadows(own: &ReceiverPatch, lamps: &[&FlatLamp], points: usize) -> Vec<f64> {
    let rule = UnitRule::of(points);
    let (mut sums, mut area) = (vec![0.0; lamps[0].exitance.len()], 0.0);
    for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
        let node = own.patch.node(s, t);
        let weight = ws * wt * node.area;
        let receiver = ReceiverPoint::on(own.surface, node.position, node.normal);
        area += weight;
        for lamp in lamps {
            let factor: f64 = lamp.polygons.iter().map(|polygon| receiver.factor(polygon, [].iter())).sum();
            sums.iter_mut()
                .zip(&lamp.exitance)
                .for_each(|(sum, exitance)| *sum += weight * factor * exitance);
        }
    }
    sums.iter_mut().for_each(|sum| *sum /= area);
    sums
}

/// Shifts of a sequence in five dimensions.
fn offsets(number: u64) -> [f64; 5] {
    let number = number_of([f64::from_bits(number), 7.0]);
    let (first, [last]): ([f64; 4], [f64; 1]) = (shift(number), shift(number_of([f64::from_bits(number)])));
    std::array::from_fn(|k| if k < 4 { first[k] } else { last })
}
