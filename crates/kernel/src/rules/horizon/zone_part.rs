//! W_l(x) of an element on a sphere over a rectangle of longitude and latitude: integration over the part that
//! x sees, whose border is known in closed form.
//!
//! Both conditions of sight are planes,
//!
//! ```text
//! n_x·(y − x) > 0 ,     ± (x − c)·(y − c) > ± R²        (+ outside of the sphere, − inside) ,
//! ```
//!
//! each m·(y − c) > k. With y − c = R (cos ψ (cos φ e₁ + sin φ e₂) + sin ψ a), on the parallel of latitude ψ it
//! leaves the longitudes |φ − φ_m| < arccos t, t = (k/R − m·a sin ψ)/(|m⊥| cos ψ): all where t ≤ −1, none where
//! t ≥ 1.
//!
//! The parallels are grouped in strips between the latitudes at which the number of these intervals, or what
//! bounds them, changes: where a plane touches a parallel, ψ_m ± arccos(k/(R |m|)), beyond a pole on its far
//! side; where it crosses the first or last meridian of the element; and where both planes meet. Beside the
//! former the ends of intervals move like square roots: strips are taken in s, ψ − ψ₀ ∝ s² from one such end,
//! and ∝ sin² (π s/2) between two, in which these are smooth. Gauss rules converge exponentially along and
//! across.
//!
//! Of a whole sphere of even exitance the sum is known ([`crate::irradiance::ball`], and 1 inside).
//!
//! Points: of a sector, more on longer strips and intervals, and fewer on shorter ones.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::{MOST_POINTS, UnitRule};
use radiosity_geom::{DVec3, ROUNDING};
use smallvec::SmallVec;

use crate::contact::orientation::may_face_ball;
use crate::contact::sectors::LARGEST_TURN;
use crate::irradiance::ball::ball;
use crate::moments::integrand::kernel;
use crate::rules::zone::{Chart, Zone};

/// Angle from a pole within which strips are graded towards a circle that passes it, and the ratio of their
/// distances: longitudes turn by a half over its distance from the pole.
const NEAR_POLE: f64 = 0.6;
const NEXT: f64 = 4.0;

/// A third more points than on whole sectors: the ends of intervals move with the parallel. Measured on a ball over
/// a disc, which misses 5e-8 for 1e-8 without, and 1e-8 with them.
const MORE: usize = 3;

/// Rate of convergence on a sector: an estimate, at the least distance of patches apart.
const RATE: f64 = 3.0;

/// A condition m·(y − c) > k of sight.
struct Plane {
    normal: DVec3,
    height: f64,
}

/// A latitude at which strips meet.
#[derive(Clone, Copy)]
struct Break {
    latitude: f64,
    /// Whether a plane touches the parallel, beside which the ends of intervals move like square roots.
    is_touching: bool,
}

/// The parallels between two breaks.
struct Strip {
    ends: [Break; 2],
}

impl Strip {
    fn width(&self) -> f64 {
        self.ends[1].latitude - self.ends[0].latitude
    }

    /// The latitude at 0 ≤ s ≤ 1, and its change with s.
    fn place(&self, s: f64) -> (f64, f64) {
        let [low, high] = self.ends;
        let (share, change) = match [low.is_touching, high.is_touching] {
            [true, true] => {
                let (sin, cos) = (FRAC_PI_2 * s).sin_cos();
                (sin * sin, PI * sin * cos)
            }
            [true, false] => (s * s, 2.0 * s),
            [false, true] => (s * (2.0 - s), 2.0 - 2.0 * s),
            [false, false] => (s, 1.0),
        };
        (low.latitude + self.width() * share, self.width() * change)
    }

    /// Largest change of the latitude with s, over the mean one.
    fn crowding(&self) -> f64 {
        match self.ends.map(|end| end.is_touching) {
            [true, true] => FRAC_PI_2,
            [false, false] => 1.0,
            _ => 2.0,
        }
    }
}

/// The strips between breaks in order.
fn strips(breaks: &[Break]) -> impl Iterator<Item = Strip> {
    breaks.windows(2).map(|ends| Strip { ends: [ends[0], ends[1]] })
}

/// The element, with the points of its rules.
pub(super) struct ZonePart<'a> {
    zone: &'a Zone<'a>,
    basis: &'a AreaBasis,
    /// Points of a sector along and across.
    points: [usize; 2],
    /// Angles that a sector spans in longitude and latitude.
    sector: [f64; 2],
}

/// Ranges of longitude, from 0 to 2π.
type Ranges = SmallVec<[[f64; 2]; 4]>;

impl<'a> ZonePart<'a> {
    pub(super) fn new(zone: &'a Zone<'a>, basis: &'a AreaBasis, points: [usize; 2]) -> Self {
        let [south, north] = zone.latitudes();
        Self { zone, basis, points, sector: [zone.width(), north - south].map(sector_angle) }
    }

    /// Whether some point of the whole sphere may lie before the horizon of a point of a patch.
    pub(super) fn may_be_faced_by(&self, outer: &Patch) -> bool {
        let Chart { center, radius, .. } = *self.zone.chart();
        may_face_ball(outer, center, radius)
    }

    /// Whether `x` sees some of it.
    pub(super) fn is_seen_from(&self, x: &Node) -> bool {
        let planes = self.planes(x);
        strips(&self.breaks(&planes)).any(|strip| self.shows(&strip, &planes))
    }

    /// Whether some of a strip is seen.
    fn shows(&self, strip: &Strip, planes: &[Plane; 2]) -> bool {
        strip.width() > ROUNDING && !self.seen(planes, strip.place(0.5).0).is_empty()
    }

    /// The conditions of sight from `x`.
    fn planes(&self, x: &Node) -> [Plane; 2] {
        let Chart { center, radius, .. } = self.zone.chart();
        let (offset, sign) = (x.position - center, if self.zone.is_hollow() { -1.0 } else { 1.0 });
        [
            Plane { normal: x.normal, height: x.normal.dot(offset) },
            Plane { normal: sign * offset, height: sign * radius * radius },
        ]
    }

    /// Adds W_l(x) to `out`; returns the number of evaluations.
    pub(super) fn seen_from(&self, x: &Node, out: &mut [f64]) -> u64 {
        if out.len() == 1
            && let Some(seen) = self.whole_from(x)
        {
            out[0] += seen * self.basis.constant();
            return 1;
        }
        let planes = self.planes(x);
        let mut values = vec![0.0; out.len()];
        let mut evaluations = 0;
        for strip in strips(&self.breaks(&planes)) {
            evaluations += 1;
            if !self.shows(&strip, &planes) {
                continue;
            }
            let sectors = strip.crowding() * strip.width() / self.sector[1];
            for (s, weight) in rule(self.points[1], sectors).iter() {
                let (latitude, change) = strip.place(s);
                for range in self.seen(&planes, latitude) {
                    evaluations += self.along(x, latitude, range, weight * change, &mut values, out);
                }
            }
        }
        evaluations
    }

    /// The share of the light of a point that meets a whole sphere, from outside or from inside; None where the
    /// element is no whole sphere, or the point lies on its back.
    fn whole_from(&self, x: &Node) -> Option<f64> {
        let Chart { center, radius, .. } = *self.zone.chart();
        let distance = x.position.distance(center);
        let is_inside = distance < radius;
        match self.zone.is_whole() && self.zone.is_hollow() == is_inside {
            // A surface that touches a ball sees it fill what lies on its side of their common plane.
            _ if self.is_touched_at(distance) => {
                Some(0.5 * (1.0 + x.normal.dot(center - x.position) / distance))
            }
            false => None,
            true if is_inside => Some(1.0),
            true => ball(x.position, x.normal, center, radius),
        }
    }

    /// Whether a point at this distance from the centre lies on a ball, to rounding.
    fn is_touched_at(&self, distance: f64) -> bool {
        let radius = self.zone.chart().radius;
        self.zone.is_whole() && !self.zone.is_hollow() && (distance - radius).abs() <= ROUNDING * radius
    }

    /// Adds a range of longitudes on one parallel.
    fn along(
        &self,
        x: &Node,
        latitude: f64,
        [from, to]: [f64; 2],
        weight: f64,
        values: &mut [f64],
        out: &mut [f64],
    ) -> u64 {
        let chart = self.zone.chart();
        let (rise, reach) = latitude.sin_cos();
        let area = chart.radius * chart.radius * reach * (to - from) * weight;
        let front = if self.zone.is_hollow() { -1.0 } else { 1.0 };
        let rule = rule(self.points[0], (to - from) / self.sector[0]);
        for (t, share) in rule.iter() {
            let longitude = from + t * (to - from);
            let (sin, cos) = longitude.sin_cos();
            let outward = reach * (cos * chart.meridians[0] + sin * chart.meridians[1]) + rise * chart.axis;
            let y = Node {
                position: chart.center + chart.radius * outward,
                normal: front * outward,
                area: share * area,
                parameters: chart.parameters(longitude, latitude),
            };
            self.basis.raw(self.basis.frame().coordinates(&y), values);
            let value = kernel(x, &y) * y.area;
            out.iter_mut().zip(&*values).for_each(|(sum, l)| *sum += value * l);
        }
        rule.nodes.len() as u64
    }

    /// The longitudes of the element that are seen on a parallel.
    fn seen(&self, planes: &[Plane; 2], latitude: f64) -> Ranges {
        let mut ranges = Ranges::from_slice(&[[0.0, self.zone.width()]]);
        for plane in planes {
            let Some([from, to]) = self.between(plane, latitude) else { return Ranges::new() };
            if to - from >= TAU {
                continue;
            }
            // The interval and its copies a turn off, of which some reach into the element.
            let copies = [-TAU, 0.0, TAU].map(|turn| [from + turn, to + turn]);
            let common = |[a, b]: [f64; 2]| {
                copies.into_iter().map(move |[c, d]| [a.max(c), b.min(d)]).filter(|[low, high]| low < high)
            };
            ranges = ranges.into_iter().flat_map(common).collect();
        }
        ranges
    }

    /// The longitudes before a plane on a parallel, from 0 ≤ φ_m < 2π on both ways; None where there are none.
    fn between(&self, plane: &Plane, latitude: f64) -> Option<[f64; 2]> {
        let chart = self.zone.chart();
        let (rise, reach) = latitude.sin_cos();
        let [along, beside] = chart.meridians.map(|meridian| plane.normal.dot(meridian));
        let least = plane.height / chart.radius - plane.normal.dot(chart.axis) * rise;
        let most = reach * along.hypot(beside);
        if least >= most {
            return None;
        }
        let half = if least <= -most { PI } else { (least / most).acos() };
        let middle = beside.atan2(along).rem_euclid(TAU);
        Some([middle - half, middle + half])
    }

    /// The latitudes of the element between which nothing changes, in order.
    fn breaks(&self, planes: &[Plane; 2]) -> SmallVec<[Break; 16]> {
        let chart = self.zone.chart();
        let [south, north] = self.zone.latitudes();
        let end = |latitude: f64| Break { latitude, is_touching: false };
        let mut breaks: SmallVec<[Break; 16]> = SmallVec::from_slice(&[end(south), end(north)]);
        let mut add = |latitude: f64, is_touching: bool| {
            if latitude > south && latitude < north {
                breaks.push(Break { latitude, is_touching });
            }
        };
        for Plane { normal, height } in planes {
            let k = height / chart.radius;
            let up = normal.dot(chart.axis);
            let flat = (normal - up * chart.axis).length();
            // Beyond a pole a parallel is met on its far side.
            for latitude in roots(up, flat, k) {
                let is_beyond = latitude.abs() > FRAC_PI_2;
                let latitude = if is_beyond { latitude.signum() * PI - latitude } else { latitude };
                add(latitude, true);
                let mut off_pole = NEXT * (FRAC_PI_2 - latitude.abs());
                while off_pole < NEAR_POLE && off_pole > ROUNDING {
                    add(latitude.signum() * (FRAC_PI_2 - off_pole), false);
                    off_pole *= NEXT;
                }
            }
            for longitude in [0.0, self.zone.width()] {
                let meridian = chart.position(longitude, 0.0) - chart.center;
                let crossed = roots(up, normal.dot(meridian) / chart.radius, k);
                crossed.into_iter().for_each(|latitude| add(latitude, false));
            }
        }
        both(planes, chart.radius).into_iter().for_each(|point| add(chart.latitude(point), false));
        breaks.sort_by(|a, b| a.latitude.total_cmp(&b.latitude));
        breaks
    }
}

/// The angles from −π to π at which `sine` sin ψ + `cosine` cos ψ = `value`; none where it does not get there.
fn roots(sine: f64, cosine: f64, value: f64) -> SmallVec<[f64; 2]> {
    let (middle, turn) = (sine.atan2(cosine), (value / sine.hypot(cosine)).acos());
    let found = [middle - turn, middle + turn].map(|angle| angle - TAU * (angle / TAU).round());
    found.into_iter().filter(|angle| angle.is_finite()).collect()
}

/// The points of a sphere about the origin on two planes; none where they do not meet on it.
fn both([first, second]: &[Plane; 2], radius: f64) -> SmallVec<[DVec3; 2]> {
    let along = first.normal.cross(second.normal);
    let square = along.length_squared();
    let foot =
        (second.normal.cross(along) * first.height + along.cross(first.normal) * second.height) / square;
    let reach = ((radius * radius - foot.length_squared()) / square).sqrt();
    [-reach, reach].into_iter().filter(|reach| reach.is_finite()).map(|reach| foot + reach * along).collect()
}

/// The angle of the sectors that a range of angles is halved into ([`crate::contact::sectors`]).
fn sector_angle(range: f64) -> f64 {
    let mut angle = range;
    while angle > LARGEST_TURN {
        angle *= 0.5;
    }
    angle
}

/// The rule for a range of so many sectors, of which one takes `points`: on shorter ones the rate of
/// convergence grows like their inverse length, while the polynomials, and both cosines, which vanish at the
/// ends, stay: half of them and two remain.
fn rule(points: usize, sectors: f64) -> &'static UnitRule {
    let share = if sectors < 1.0 { RATE.ln() / (RATE / sectors).ln() } else { sectors };
    let points = points + points.div_ceil(MORE);
    let count = (points as f64 * share).ceil() as usize;
    UnitRule::of(count.max(points / 2 + 2).min(MOST_POINTS))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use radiosity_elements::Element;
    use radiosity_geom::DVec2;

    use super::*;
    use crate::rules::zone::tests::part_of_sphere;

    fn by_midpoints(element: &Element, x: &Node) -> Vec<f64> {
        const STEPS: usize = 600;
        let mut sums = vec![0.0; element.basis.len()];
        let mut values = sums.clone();
        let place = |k: usize| (k as f64 + 0.5) / STEPS as f64;
        for (i, j) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| (i, j))) {
            let y = element.patches[0].node(place(i), place(j));
            let value = kernel(x, &y) * y.area / (STEPS * STEPS) as f64;
            if value > 0.0 {
                element.basis.raw(element.basis.frame().coordinates(&y), &mut values);
                sums.iter_mut().zip(&values).for_each(|(sum, l)| *sum += value * l);
            }
        }
        sums
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(60))]

        /// Whole balls, half of them and pieces, from outside and from inside, with any horizon.
        #[test]
        fn what_points_see_is_integrated(
            axis in prop::array::uniform3(-1.0..1.0f64),
            kind in 0..3usize,
            place in prop::array::uniform3(-1.0..1.0f64),
            looks in prop::array::uniform3(-1.0..1.0f64),
            far in 0.0..1.0f64,
            is_hollow: bool,
        ) {
            let [axis, place, looks] = [axis, place, looks].map(DVec3::from_array);
            prop_assume!([axis, place, looks].iter().all(|x| x.length() > 0.1));
            let (z, angle) =
                [([-1.0, 1.0], [0.3, 0.3 + TAU]), ([0.1, 1.0], [0.0, TAU]), ([-0.6, 0.7], [1.0, 4.0])][kind];
            let element = &part_of_sphere(axis, z, angle, is_hollow);
            let zone = Zone::of(element, 1e-8).expect("it is a zone");
            let distance = if is_hollow { 0.7 * far } else { 1.4 + far };
            let x = Node {
                position: distance * place.normalize(),
                normal: looks.normalize(),
                area: 1.0,
                parameters: DVec2::ZERO,
            };
            let part = ZonePart::new(&zone, &element.basis, [16, 16]);
            let mut found = vec![0.0; element.basis.len()];
            part.seen_from(&x, &mut found);
            let expected = by_midpoints(element, &x);
            for (found, expected) in found.iter().zip(&expected) {
                prop_assert!((found - expected).abs() < 2e-4, "{found} for {expected}");
            }
        }
    }

    /// The irradiance from a ball of even exitance is known (`irradiance::ball`), and that inside a sphere is 1.
    #[test]
    fn whole_balls_have_their_irradiance() {
        for is_hollow in [false, true] {
            let element = &part_of_sphere(DVec3::new(0.3, -0.5, 0.8), [-1.0, 1.0], [0.0, TAU], is_hollow);
            let zone = Zone::of(element, 1e-12).expect("it is a zone");
            for k in 0..20 {
                let (sin, cos) = (0.9 * f64::from(k)).sin_cos();
                let normal = DVec3::new(cos, sin * 0.6, sin * 0.8);
                let position = if is_hollow { 0.6 } else { 1.8 } * DVec3::new(0.48, 0.6, -0.64);
                let x = Node { position, normal, area: 1.0, parameters: DVec2::ZERO };
                let mut out = vec![0.0; element.basis.len()];
                ZonePart::new(&zone, &element.basis, [24, 24]).seen_from(&x, &mut out);
                let found = out[0] / element.basis.constant();
                let exact = if is_hollow {
                    1.0
                } else {
                    crate::irradiance::ball::ball(position, normal, DVec3::ZERO, 1.0).expect("outside")
                };
                assert!((found - exact).abs() < 1e-7, "{is_hollow} {k}: {found} for {exact}");
            }
        }
    }
}
