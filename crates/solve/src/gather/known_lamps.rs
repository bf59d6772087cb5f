//! Direct light over a patch of diffuse emitters that are far from it: what they send without shadows, times the
//! part of it that rays find visible.
//!
//! Definition. With points x of the patch P, spread evenly over it, and points y of the emitters l, of the exitance E₀
//! and of the density q(y) in the rays (`light::lamps`),
//!
//! ```text
//! D = W v ,     W = 1/|P| Σ_l ∫_P E₀ U_l(x) dA_x ,     v ≈ Σ_k E₀ V κ/q / Σ_k E₀ κ/q        W m⁻² ,
//! ```
//!
//! U_l(x) the form factor of the emitter, a polygon by Lambert's formula or a whole ball by its own
//! (`kernel::irradiance::ball`), and κ its kernel. W is found by a Gauss rule. Where nothing hides anything, or
//! everything, D is exact; in shadow v alone has to be found.
//!
//! Range of use. An emitter is far where the diagonal of the patch is less than twice its distance, and no corner of
//! the patch is behind it: where its plane cuts the patch U_l has a kink, which no rule follows.
//!
//! Error. Gauss rules of 2 and 4 points each way err by 8e-5 of W where the diagonal is up to a quarter of the
//! distance, and by 1e-4 elsewhere; one of 8 on curved patches by some 1e-3 where they turn away from the emitter.

use std::ops::Range;

use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_elements::{Element, Elements};
use radiosity_geom::{Aabb, DVec3, Plane};
use radiosity_kernel::irradiance::ball::ball;
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

/// Part of the area of a ball that may be covered, where it hangs or stands on something: light that is counted of it
/// is hidden by what covers it, but from nearby. Chosen: less than what rays err by.
const COVERED: f64 = 1e-3;

/// Gauss points each way where all emitters are very far, elsewhere, and on curved patches, part of which may turn away
/// from an emitter.
const FEW_POINTS: usize = 2;
const POINTS: usize = 4;
const CURVED_POINTS: usize = 8;

/// The diffuse emitters of a scene whose light without shadows has a closed form.
#[derive(Debug)]
pub(super) struct KnownLamps {
    list: Vec<KnownLamp>,
    /// For each element the place in the list of the emitter that it belongs to, if any.
    places: Vec<Option<u32>>,
}

#[derive(Debug)]
struct KnownLamp {
    /// Its elements: one if it is flat, all of a ball.
    elements: Range<usize>,
    form: LampForm,
    /// Exitance per band (W m⁻²).
    exitance: Vec<f64>,
}

#[derive(Debug)]
enum LampForm {
    Flat { plane: Plane, polygons: Vec<Vec<DVec3>>, bounds: Aabb },
    Ball { center: DVec3, radius: f64 },
}

/// Emitters that are far from a patch.
pub(super) struct FarLamps<'s> {
    lamps: &'s KnownLamps,
    /// Their places in the list, ascending.
    held: Vec<u32>,
    shares: Shares<'s>,
    /// Irradiance per band without shadows, in the mean over the patch (W m⁻²).
    pub(super) whole: Vec<f64>,
}

impl LampForm {
    /// Distance from a box (scene length).
    fn gap(&self, own: &Aabb) -> f64 {
        match self {
            Self::Flat { bounds, .. } => gap(own, bounds),
            Self::Ball { center, radius } => (own.distance_squared(*center).sqrt() - radius).max(0.0),
        }
    }

    /// Whether all of these points are before it.
    fn is_before(&self, points: &[DVec3]) -> bool {
        match self {
            Self::Flat { plane, .. } => points.iter().all(|point| plane.height(*point) > 0.0),
            Self::Ball { .. } => true,
        }
    }

    /// Irradiance at a point for exitance 1, without shadows.
    fn factor(&self, receiver: &ReceiverPoint) -> f64 {
        match self {
            Self::Flat { polygons, .. } => {
                polygons.iter().map(|polygon| receiver.factor(polygon, [].iter())).sum()
            }
            Self::Ball { center, radius } => {
                ball(receiver.position, receiver.normal, *center, *radius).unwrap_or(1.0)
            }
        }
    }
}

impl KnownLamps {
    /// Those among these emitters.
    pub(super) fn of(elements: &Elements, sources: &Emitters) -> Self {
        let list: Vec<KnownLamp> =
            (0..elements.surfaces()).flat_map(|surface| lamps_of(elements, sources, surface)).collect();
        let mut places = vec![None; elements.list().len()];
        for (place, lamp) in list.iter().enumerate() {
            places[lamp.elements.clone()].fill(Some(place as u32));
        }
        Self { list, places }
    }

    /// The emitter that an element belongs to, if to any.
    fn at(&self, element: usize) -> Option<&KnownLamp> {
        self.places[element].map(|place| &self.list[place as usize])
    }

    /// Those that are far from a receiver; None if it is no patch, or they send nothing to it.
    pub(super) fn far_from<'s>(&'s self, rays: &'s SentRays, receiver: &Receiver) -> Option<FarLamps<'s>> {
        let Receiver::Patch(own) = receiver else { return None };
        let hull = own.patch.hull();
        let bounds = Aabb::around(hull.iter().copied());
        let relative = |lamp: &KnownLamp| bounds.diagonal() / lamp.form.gap(&bounds);
        let is_far = |lamp: &KnownLamp| relative(lamp) < FAR && lamp.form.is_before(&hull);
        let are_far: Vec<bool> = self.list.iter().map(is_far).collect();
        let place = |element: usize| self.places[element].filter(|place| are_far[*place as usize]);
        let shares = rays.lamps.seen_among(&receiver.witnesses(), |element| place(element).is_some());
        let sends = |lamp: &KnownLamp| lamp.elements.clone().any(|element| shares.density(element) > 0.0);
        let held: Vec<u32> =
            (0..).zip(&self.list).filter(|(_, lamp)| sends(lamp)).map(|(place, _)| place).collect();
        if held.is_empty() {
            return None;
        }
        let lamps: Vec<&KnownLamp> = held.iter().map(|place| &self.list[*place as usize]).collect();
        let points = match own.patch.is_flat() {
            false => CURVED_POINTS,
            true if lamps.iter().all(|lamp| relative(lamp) < VERY_FAR) => FEW_POINTS,
            true => POINTS,
        };
        let whole = without_shadows(own, &lamps, points);
        whole.iter().any(|light| *light > 0.0).then_some(FarLamps { lamps: self, held, shares, whole })
    }
}

/// The emitters with a closed form that a surface is: its flat elements, or all of it if it is a ball.
fn lamps_of(elements: &Elements, sources: &Emitters, surface: usize) -> Vec<KnownLamp> {
    let own = elements.of_surface(surface);
    let exitance = |element: usize| -> Vec<f64> {
        sources.coatings.iter().map(|coating| coating.exitance[element]).collect()
    };
    let is_lamp = |element: &usize| {
        let is_open = elements.list()[*element].contact.is_none();
        is_open && exitance(*element).iter().any(|exitance| *exitance > 0.0)
    };
    if own.is_empty() || sources.radiances.is_directed(surface) {
        return Vec::new();
    }
    let flat = |element: usize| {
        let Element { plane, patches, hull, .. } = &elements.list()[element];
        let form = LampForm::Flat {
            plane: (*plane)?,
            polygons: patches.iter().map(Patch::polygon).collect(),
            bounds: Aabb::around(hull.iter().copied()),
        };
        Some(KnownLamp { elements: element..element + 1, form, exitance: exitance(element) })
    };
    let shape = elements.shape(surface);
    match shape.ball() {
        None => own.filter(is_lamp).filter_map(flat).collect(),
        Some((center, radius)) => {
            let jet = shape.jet(0.0, 0.0);
            let (open, covered): (Vec<usize>, Vec<usize>) = own.clone().partition(is_lamp);
            let area =
                |some: &[usize]| some.iter().map(|element| elements.list()[*element].area).sum::<f64>();
            let Some(first) = open.first().map(|element| exitance(*element)) else { return Vec::new() };
            let is_even = area(&covered) <= COVERED * area(&open)
                && open.iter().all(|element| exitance(*element) == first);
            let shines_out = (jet.position - center).dot(jet.normal) > 0.0;
            let form = LampForm::Ball { center, radius };
            let lamp = KnownLamp { elements: own, form, exitance: first };
            if is_even && shines_out { vec![lamp] } else { Vec::new() }
        }
    }
}

impl FarLamps<'_> {
    /// Whether an element is one of them.
    pub(super) fn hold(&self, element: usize) -> bool {
        self.lamps.places[element].is_some_and(|place| self.held.binary_search(&place).is_ok())
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
fn without_shadows(own: &ReceiverPatch, lamps: &[&KnownLamp], points: usize) -> Vec<f64> {
    let rule = UnitRule::of(points);
    let (mut sums, mut area) = (vec![0.0; lamps[0].exitance.len()], 0.0);
    for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
        let node = own.patch.node(s, t);
        let weight = ws * wt * node.area;
        let receiver = ReceiverPoint::on(own.surface, node.position, node.normal);
        area += weight;
        for lamp in lamps {
            let factor = lamp.form.factor(&receiver);
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
