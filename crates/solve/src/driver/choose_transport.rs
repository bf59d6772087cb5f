//! Whether rays or exact blocks carry the pairs of a scene.
//!
//! Exact blocks cost about the square of the number of elements, and most where things are curved or hide
//! each other; rays cost about that number, whatever stands between. Rooms of a few flat things are done
//! exactly in a fraction of a second, to an error that rays would take seconds for. An office of 430 polygons
//! took 94 s of CPU exactly, 33 000 of its 37 000 pairs partly hidden, and 1 s by rays with a smaller error
//! of the light gathered at points; a teapot of 40 curved surfaces takes 27 s, and 0.5 s with a smaller
//! error.
//!
//! What exact blocks would cost is told beforehand by some of the pairs of surfaces: whether their planes let
//! them see each other, whether they are flat, and how many surfaces reach into the hull of both.

use radiosity_elements::{CutSize, Discretization, cut_sizes};
use radiosity_scene::Scene;
use radiosity_transport::price::{ElementPair, LEAST, price};
use radiosity_visibility::{Shadows, Visibility};
use radiosity_work::Allowance;

use super::cost::seconds_of_rays;
use super::light_method::LightMethod;
use super::options::Options;
use super::outline::Outline;
use super::transport_choice::{Transport, TransportChoice, USUAL_ACCURACY, usual_rays};

/// Exact blocks are made where they cost no more than the usual rays this often at the default accuracy: to
/// their error, so many would be needed. Measured in the temple (10), the teapot (1) and the Cornell box
/// (60), whose exact blocks cost half the usual rays. Proportionally more at finer accuracies.
const AS_GOOD: f64 = 10.0;

/// Share of the pairs of elements that can see each other, at least, in scenes too large to be looked at.
const SEEING: f64 = 0.25;

/// Pairs of surfaces that are looked at.
const LOOKED_AT: usize = 2_000;

impl TransportChoice {
    /// The carrier of the pairs of `scene` by these options, with so much time `left` if that is limited; `visibility`
    /// is asked for where the price of the pairs decides.
    pub fn of<'a>(
        scene: &Scene,
        options: &Options,
        left: Option<Allowance>,
        visibility: impl FnOnce() -> &'a Visibility,
    ) -> Self {
        let exact = |why: &str| Self { sampled: false, why: why.to_owned() };
        let sampled = |why: &str| Self { sampled: true, why: why.to_owned() };
        match options.transport {
            _ if options.kernel.is_some() || options.masks.is_some() => {
                exact("the methods of 1993 know no rays")
            }
            _ if options.method == LightMethod::Collocation => {
                exact("collocation takes the light of points, which rays do not tell")
            }
            _ if !options.basis.is_polynomial() => {
                exact("the functions of this basis are held by polynomials that rays would not tell apart")
            }
            _ if options.shadows == Shadows::Off => exact("rays always meet what stands in their way"),
            Transport::Exact => exact("asked for"),
            Transport::Sampled => sampled("asked for"),
            Transport::Auto if options.rays.is_some() => sampled("a number of rays is given"),
            Transport::Auto => Self::by_price(scene, options, left, visibility),
        }
    }

    fn by_price<'a>(
        scene: &Scene,
        options: &Options,
        left: Option<Allowance>,
        visibility: impl FnOnce() -> &'a Visibility,
    ) -> Self {
        let usual = usual_rays(scene.surfaces.len(), USUAL_ACCURACY) as f64;
        let finer = (USUAL_ACCURACY / options.accuracy().shadow_eps).max(1.0);
        let rays = |left: Allowance| left.forecast(left.seconds()) / seconds_of_rays(1.0);
        let in_time = left.map_or(f64::INFINITY, rays);
        let limit = (AS_GOOD * finer * usual).min(in_time);
        let (price, about) = match exact_price_at_least(scene) {
            price if price > limit => (price, "more than"),
            _ => {
                let visibility = visibility();
                let how = elements_of(options, visibility);
                (exact_price(scene, &how, &|_, _| true, visibility).all(), "about")
            }
        };
        let why = format!("exact blocks take as long as {about} {price:.0e} rays, the limit is {limit:.0e}");
        Self { sampled: price > limit, why }
    }
}

/// A lower bound of the price of exact blocks, in rays, from the number of surfaces alone.
fn exact_price_at_least(scene: &Scene) -> f64 {
    SEEING * LEAST * 0.5 * (scene.surfaces.len() as f64).powi(2)
}

/// The elements of exact blocks.
fn elements_of(options: &Options, visibility: &Visibility) -> Discretization {
    let subdivide = options.exact_cuts(visibility.any_shadow());
    let Options { order, space, layers, .. } = *options;
    Discretization { order, space, subdivide, layers }
}

/// The price of exact blocks, in rays.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PairsPrice {
    /// Of pairs of flat surfaces.
    pub flat: f64,
    /// Of pairs of a flat and a curved surface.
    pub mixed: f64,
    /// Of pairs of curved surfaces.
    pub curved: f64,
}

impl PairsPrice {
    /// The price of all pairs.
    pub(crate) fn all(&self) -> f64 {
        self.flat + self.mixed + self.curved
    }

    fn and(self, other: Self) -> Self {
        Self {
            flat: self.flat + other.flat,
            mixed: self.mixed + other.mixed,
            curved: self.curved + other.curved,
        }
    }
}

/// The price of the exact blocks between the elements of surfaces that are cut as `how` says, in rays, from some of
/// the pairs of surfaces that are `wanted`.
pub(crate) fn exact_price(
    scene: &Scene,
    how: &Discretization,
    wanted: &dyn Fn(usize, usize) -> bool,
    visibility: &Visibility,
) -> PairsPrice {
    price_of_pairs(scene, &cut_sizes(scene, how), wanted, visibility)
}

/// The price of the exact blocks between the elements of each surface, in rays, from some of the pairs of surfaces that
/// are `wanted`.
pub(super) fn price_of_pairs(
    scene: &Scene,
    sizes: &[CutSize],
    wanted: &dyn Fn(usize, usize) -> bool,
    visibility: &Visibility,
) -> PairsPrice {
    let outlines: Vec<Outline> = scene.surfaces.iter().map(Outline::of).collect();
    let pairs = scene.surfaces.len() * (scene.surfaces.len() - 1) / 2;
    let looked_at = pairs.min(LOOKED_AT);
    let of_pair = |k: usize| {
        let [i, j] = pair(k * pairs / looked_at);
        let [a, b] = [&outlines[i], &outlines[j]];
        if !wanted(i, j) || !a.exchanges_with(b) {
            return PairsPrice::default();
        }
        let are_flat = [a.is_flat(), b.is_flat()];
        let sizes = [sizes[i], sizes[j]];
        let pair = ElementPair {
            surfaces: [i, j],
            hulls: [&a.hull, &b.hull],
            are_flat: are_flat == [true; 2],
            are_constant: sizes.iter().all(|own| own.functions == 1),
            are_whole: sizes.iter().all(CutSize::is_whole),
        };
        let price = (sizes[0].elements * sizes[1].elements) as f64 * price(&pair, visibility);
        match are_flat {
            [true, true] => PairsPrice { flat: price, ..PairsPrice::default() },
            [false, false] => PairsPrice { curved: price, ..PairsPrice::default() },
            _ => PairsPrice { mixed: price, ..PairsPrice::default() },
        }
    };
    let sum = (0..looked_at).map(of_pair).fold(PairsPrice::default(), PairsPrice::and);
    let part = pairs as f64 / looked_at.max(1) as f64;
    PairsPrice { flat: part * sum.flat, mixed: part * sum.mixed, curved: part * sum.curved }
}

/// The pair j < i that is number i (i − 1)/2 + j.
fn pair(number: usize) -> [usize; 2] {
    let i = (0.5 + (0.25 + 2.0 * number as f64).sqrt()) as usize;
    let i = if i * (i - 1) / 2 > number {
        i - 1
    } else if i * (i + 1) / 2 <= number {
        i + 1
    } else {
        i
    };
    [i, number - i * (i - 1) / 2]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pairs_are_counted_row_by_row() {
        let mut number = 0;
        for i in 1..200 {
            for j in 0..i {
                assert_eq!(pair(number), [i, j]);
                number += 1;
            }
        }
    }
}
