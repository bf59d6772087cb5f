//! Elements on spheres over rectangles of longitude and latitude, and the part of one on the inside that a point
//! of its sphere sees through a plane polygon.
//!
//! Definition. The kernel between two points of the inside of a sphere is constant, 1/(4π R²). With φ the
//! longitude from the element's first meridian and σ the sine of the latitude ψ, in which the element spans 0 ≤
//! φ ≤ w and σ₀ ≤ σ ≤ σ₁, and D the part of the sphere behind the polygon,
//!
//! ```text
//! W_l = ∫_D R_l dA = R² ∬_D R_l(φ, ψ) dφ dσ .
//! ```
//!
//! Formula. With R_l = 0 outside the element, F(φ, ψ) = ∫₀^min(φ, w) R_l dφ′ for 0 ≤ φ < 2π, and D to the
//! left of its border, Stokes' theorem leaves
//!
//! ```text
//! W_l / R² = ∮_∂D F dσ ∓ Σ T(ψ) − [south pole in D] T(−π/2) ,     T(ψ) = ∫_{σ₁}^{σ} F(w, ψ′) dσ′ ,
//! ```
//!
//! one T for each place where ∂D crosses the first meridian, − eastwards and + westwards, where F jumps from F(w,
//! ψ) to 0. A side a + t (b − a) of the polygon, relative to x, lies before the arc y = x + s a, s = −2 (x −
//! c)·a/|a|², which is cut where it crosses the meridians and parallels of the element: y·m = k is a quadratic
//! equation in t.
//!
//! Range of use. Elements over rectangles of longitude and latitude, whose parameters are linear in both; x on
//! the sphere, the polygon within it or beyond, and convex.
//!
//! Error. Gauss rules for F and T are exact, but for cos ψ in T; those along arcs err by the accuracy asked,
//! as arcs are halved until they are no longer than their distance from the axis, beside which φ turns fast.
//!
//! Reference: Archimedes, *On the Sphere and Cylinder* (dA = R² dφ dσ).

use std::f64::consts::{FRAC_PI_2, TAU};

use radiosity_elements::Element;
use radiosity_elements::basis::AreaBasis;
use radiosity_elements::patch::Patch;
use radiosity_elements::rule::UnitRule;
use radiosity_geom::{ConvexSolid, DVec2, DVec3, ROUNDING, Surface, area_vector, quadratic, sides};
use smallvec::SmallVec;

use crate::rules::far;

/// Halvings of an arc that passes the axis: what is left there is 10⁻⁴ of it long.
const MOST_HALVINGS: usize = 13;
/// Longest arc, in radii, however far it is from the axis.
const LONGEST_ARC: f64 = 0.7;
/// Rate of convergence on arcs as long as their distance from the axis, whose ends φ is singular beside.
const RATE: f64 = 3.0;
/// Points for cos ψ on any range of latitudes, to 1e-15.
const COSINE_POINTS: usize = 10;
/// Points along each direction of a patch that tell its distance.
const DISTANCE_LOOKS: usize = 5;
/// Places, along each parameter, at which the chart is checked to be linear.
const LOOKS: [f64; 4] = [-0.83, -0.31, 0.47, 0.91];

/// An element on a sphere, over a rectangle of longitude and latitude.
#[derive(Debug)]
pub struct Zone<'a> {
    basis: &'a AreaBasis,
    chart: Chart,
    /// Whether its front is inside of the sphere.
    is_hollow: bool,
    /// Range of longitudes from the first meridian: from 0 to this.
    width: f64,
    /// Latitudes from south to north.
    latitudes: [f64; 2],
    /// Points of the rules for F, along arcs, and for T.
    points: [usize; 3],
}

/// Longitude and latitude, as the parameters of a surface give them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chart {
    pub(super) center: DVec3,
    pub(super) radius: f64,
    pub(super) axis: DVec3,
    /// Directions of the longitudes 0 and π/2.
    pub(super) meridians: [DVec3; 2],
    /// Parameters at longitude 0 and latitude 0, and their change per radian of either.
    origin: DVec2,
    slope: DVec2,
}

/// A point of an arc, with the change of the sine of its latitude along it.
struct ArcPoint {
    position: DVec3,
    climb: f64,
}

/// A crossing of the plane of the first meridian.
struct Crossing {
    /// Its place along the side of the polygon, from 0 to 1.
    at: f64,
    /// Whether it leads to greater longitudes, where it is on that meridian.
    is_eastward: bool,
}

impl Chart {
    /// The chart of a surface, longitudes counted from the meridian of least longitude among `u`.
    fn of(surface: &dyn Surface, u: [f64; 2]) -> Option<Self> {
        let Some(ConvexSolid::Ball { center, radius }) = surface.solid() else { return None };
        let offset = |u: f64, v: f64| surface.jet(u, v).position - center;
        let [a, b, c] = [-0.8, -0.3, 0.4].map(|u| offset(u, 0.1));
        let normal = (b - a).cross(c - a).normalize_or_zero();
        let axis = normal * (offset(0.0, 0.6) - offset(0.0, -0.6)).dot(normal).signum();
        let latitude = |v: f64| (offset(0.0, v).dot(axis) / radius).asin();
        let climb = (latitude(0.6) - latitude(-0.6)) / 1.2;
        let level = latitude(0.6) - 0.6 * climb;
        let east = |u: f64, from: DVec3| {
            let p = offset(u, 0.1);
            p.dot(axis.cross(from)).atan2(p.dot(from))
        };
        let across = |u: f64| (offset(u, 0.1) - offset(u, 0.1).dot(axis) * axis).normalize_or_zero();
        let turn = east(0.25, across(0.0)) / 0.25;
        let first = if turn > 0.0 { u[0] } else { u[1] };
        let meridians = [across(first), axis.cross(across(first))];
        let chart = Self {
            center,
            radius,
            axis,
            meridians,
            origin: DVec2::new(first, -level / climb),
            slope: DVec2::new(1.0 / turn, 1.0 / climb),
        };
        let is_met = |u: f64, v: f64| {
            let [longitude, latitude] = [(u - first) * turn, level + v * climb];
            chart.position(longitude, latitude).distance(surface.jet(u, v).position)
                <= f64::sqrt(ROUNDING) * radius
        };
        let is_linear = LOOKS.iter().all(|u| LOOKS.iter().all(|v| is_met(*u, *v)));
        (axis != DVec3::ZERO && is_linear).then_some(chart)
    }

    pub(super) fn position(&self, longitude: f64, latitude: f64) -> DVec3 {
        let [(sin, cos), (rise, reach)] = [longitude, latitude].map(f64::sin_cos);
        let [first, second] = self.meridians;
        self.center + self.radius * (reach * (cos * first + sin * second) + rise * self.axis)
    }

    pub(super) fn parameters(&self, longitude: f64, latitude: f64) -> DVec2 {
        self.origin + DVec2::new(longitude, latitude) * self.slope
    }

    /// Latitude of a point of the sphere, relative to its centre.
    pub(super) fn latitude(&self, offset: DVec3) -> f64 {
        (offset.dot(self.axis) / self.radius).clamp(-1.0, 1.0).asin()
    }

    /// Longitude from 0 to 2π.
    fn longitude(&self, offset: DVec3) -> f64 {
        let [first, second] = self.meridians.map(|meridian| offset.dot(meridian));
        second.atan2(first).rem_euclid(TAU)
    }
}

impl<'a> Zone<'a> {
    /// The element as a zone, for integrals of this relative `accuracy`; None where it is none.
    pub fn of(element: &'a Element, accuracy: f64) -> Option<Self> {
        let [Patch::Curved { surface, .. }] = &element.patches[..] else { return None };
        let (u, v) = (element.rect.u, element.rect.v);
        let chart = Chart::of(&**surface, u)?;
        let middle = surface.jet(0.5 * (u[0] + u[1]), 0.5 * (v[0] + v[1]));
        let latitudes = v.map(|v| (v - chart.origin.y) / chart.slope.y);
        let degree = element.basis.order();
        let along = far::points(degree, accuracy, RATE);
        Some(Self {
            basis: &element.basis,
            chart,
            is_hollow: middle.normal.dot(middle.position - chart.center) < 0.0,
            width: ((u[1] - u[0]) / chart.slope.x).abs(),
            latitudes: [latitudes[0].min(latitudes[1]), latitudes[0].max(latitudes[1])],
            points: [degree / 2 + 1, along, degree / 2 + COSINE_POINTS],
        })
    }

    /// Distance of a patch from the sphere (scene length): of points of it, less a fifth for those between.
    pub fn distance(&self, patch: &Patch) -> f64 {
        let corners = patch.corners().into_iter();
        let points = corners.chain(patch.cell_nodes(DISTANCE_LOOKS).into_iter().map(|x| x.position));
        let distances = points.map(|x| (x.distance(self.chart.center) - self.chart.radius).abs());
        0.8 * distances.fold(f64::INFINITY, f64::min)
    }

    pub(super) fn chart(&self) -> &Chart {
        &self.chart
    }

    /// Centre of the sphere.
    pub fn center(&self) -> DVec3 {
        self.chart.center
    }

    /// Radius of the sphere (scene length).
    pub fn radius(&self) -> f64 {
        self.chart.radius
    }

    /// Whether its front is the inside of the sphere.
    pub fn is_hollow(&self) -> bool {
        self.is_hollow
    }

    /// Whether the element is the whole sphere.
    pub fn is_whole(&self) -> bool {
        let whole = |part: f64, all: f64| part >= all * (1.0 - ROUNDING);
        whole(self.width, TAU) && self.latitudes.iter().all(|latitude| whole(latitude.abs(), FRAC_PI_2))
    }

    pub(super) fn width(&self) -> f64 {
        self.width
    }

    pub(super) fn latitudes(&self) -> [f64; 2] {
        self.latitudes
    }

    /// Whether both lie on the inside of one sphere.
    pub fn shares_inside(&self, other: &Zone) -> bool {
        let [a, b] = [self.chart, other.chart];
        let tolerance = ROUNDING * (a.radius + a.center.length());
        let is_one = a.center.distance(b.center) <= tolerance && (a.radius - b.radius).abs() <= tolerance;
        self.is_hollow && other.is_hollow && is_one
    }

    /// The kernel between two points of the sphere.
    pub fn kernel(&self) -> f64 {
        1.0 / (2.0 * TAU * self.chart.radius * self.chart.radius)
    }

    /// A square that all points inside the sphere lie before, as seen from the point `x` of it, relative to
    /// x: all directions but those a thousandth over the horizon.
    pub fn view(&self, x: DVec3) -> [DVec3; 4] {
        let inward = (self.chart.center - x).normalize();
        let (a, b) = inward.any_orthonormal_pair();
        let far = 2.0 * self.chart.radius;
        [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[s, t]| far * inward + 1e3 * far * (s * a + t * b))
    }

    /// Adds W_l of what `x` sees through a polygon, given relative to x, times `factor` to `out`; returns the
    /// number of evaluations.
    pub fn seen_through(&self, x: DVec3, polygon: &[DVec3], factor: f64, out: &mut [f64]) -> u64 {
        let turn = area_vector(polygon).dot(polygon[0]).signum();
        let mut sums = Sums {
            zone: self,
            from: x - self.chart.center,
            factor: factor * turn * self.chart.radius * self.chart.radius,
            values: vec![0.0; out.len()],
            out,
            evaluations: 0,
        };
        sides(polygon).for_each(|side| sums.side(side));
        let south = -self.chart.radius * self.chart.axis - sums.from;
        if sides(polygon).all(|[a, b]| turn * a.cross(b).dot(south) > 0.0) {
            sums.factor *= turn;
            sums.seam(-FRAC_PI_2, -1.0);
        }
        sums.evaluations
    }
}

/// The sums of one polygon.
struct Sums<'a> {
    zone: &'a Zone<'a>,
    /// x relative to the centre of the sphere.
    from: DVec3,
    factor: f64,
    values: Vec<f64>,
    out: &'a mut [f64],
    evaluations: u64,
}

impl Sums<'_> {
    /// Adds one side of the polygon: its arc between the meridians and parallels of the element, and where it
    /// crosses the first meridian.
    fn side(&mut self, side: [DVec3; 2]) {
        let Zone { chart, width, latitudes, .. } = self.zone;
        let mut breaks: SmallVec<[f64; 8]> = SmallVec::new();
        breaks.extend([0.0, 1.0]);
        let crossings = self.crossings(side);
        breaks.extend(crossings.iter().map(|crossing| crossing.at));
        if *width < TAU {
            let last = chart.axis.cross(chart.position(*width, 0.0) - chart.center).normalize();
            breaks.extend(self.meets(side, last, 0.0));
        }
        for latitude in latitudes.iter().filter(|latitude| latitude.abs() < FRAC_PI_2) {
            breaks.extend(self.meets(side, chart.axis, chart.radius * latitude.sin()));
        }
        breaks.sort_by(f64::total_cmp);
        for Crossing { at, is_eastward } in crossings {
            let ArcPoint { position, .. } = self.at(side, at);
            if position.dot(chart.meridians[0]) > 0.0 {
                self.seam(chart.latitude(position), if is_eastward { -1.0 } else { 1.0 });
            }
        }
        for ends in breaks.windows(2).map(|w| [w[0], w[1]]).filter(|[low, high]| high - low > ROUNDING) {
            self.arc(side, ends, MOST_HALVINGS);
        }
    }

    /// Where the arc of a side crosses the plane of the first meridian. Its ends lie on one side or the other,
    /// the same for both sides that meet there, so that none is missed or counted twice: their number is even
    /// or odd as the ends say.
    fn crossings(&self, side: [DVec3; 2]) -> SmallVec<[Crossing; 2]> {
        let [_, north] = self.zone.chart.meridians;
        let [first, last] = side.map(|corner| self.behind(corner).dot(north) >= 0.0);
        let mut found = self.meets(side, north, 0.0);
        if (found.len() % 2 == 1) != (first != last) {
            // One lies at an end within rounding: it is too many, or missing there.
            let from_end = |t: &f64| t.min(1.0 - t);
            match found.len() {
                0 => {
                    let [off, other] = side.map(|corner| self.behind(corner).dot(north).abs());
                    found.push(if off < other { 0.0 } else { 1.0 });
                }
                1 => found.clear(),
                _ if from_end(&found[0]) < from_end(&found[1]) => _ = found.remove(0),
                _ => _ = found.pop(),
            }
        }
        found.sort_by(f64::total_cmp);
        let crossing =
            |(index, at): (usize, &f64)| Crossing { at: *at, is_eastward: first == (index % 2 == 1) };
        found.iter().enumerate().map(crossing).collect()
    }

    /// The point of the sphere in the direction `a` from x, relative to its centre.
    fn behind(&self, a: DVec3) -> DVec3 {
        self.from - 2.0 * self.from.dot(a) / a.length_squared() * a
    }

    /// The point of the sphere behind a + t (b − a), relative to its centre.
    fn at(&self, [a, b]: [DVec3; 2], t: f64) -> ArcPoint {
        let (a, step) = (a + t * (b - a), b - a);
        let square = a.length_squared();
        let s = -2.0 * self.from.dot(a) / square;
        let change = -2.0 * (self.from.dot(step) + s * a.dot(step)) / square;
        let axis = self.zone.chart.axis;
        let climb = (change * a + s * step).dot(axis) / self.zone.chart.radius;
        ArcPoint { position: self.from + s * a, climb }
    }

    /// Where, 0 < t < 1, the arc meets the plane y·m = k.
    fn meets(&self, [a, b]: [DVec3; 2], m: DVec3, k: f64) -> SmallVec<[f64; 2]> {
        let (step, d) = (b - a, self.from);
        // (m·d − k) |a|² = 2 (d·a) (m·a).
        let rest = m.dot(d) - k;
        let form = |p: DVec3, q: DVec3| rest * p.dot(q) - d.dot(p) * m.dot(q) - d.dot(q) * m.dot(p);
        let roots = quadratic(form(step, step), 2.0 * form(a, step), form(a, a));
        roots.into_iter().filter(|t| *t > 0.0 && *t < 1.0).collect()
    }

    /// Adds ∫ F dσ along a part of an arc.
    fn arc(&mut self, side: [DVec3; 2], [low, high]: [f64; 2], halvings: usize) {
        let Zone { chart, latitudes, points, .. } = self.zone;
        let middle = 0.5 * (low + high);
        let [start, amid, end] = [low, middle, high].map(|t| self.at(side, t).position);
        let latitude = chart.latitude(amid);
        if latitude < latitudes[0] || latitude > latitudes[1] {
            return;
        }
        let beside = |p: DVec3| (p - p.dot(chart.axis) * chart.axis).length();
        let clear = [start, amid, end].map(beside).into_iter().fold(LONGEST_ARC * chart.radius, f64::min);
        let length = start.distance(amid) + amid.distance(end);
        if length > clear && halvings > 0 {
            self.arc(side, [low, middle], halvings - 1);
            return self.arc(side, [middle, high], halvings - 1);
        }
        // Shorter arcs converge faster: ϱ grows like the distance over the length.
        let rate = (RATE * clear / length).max(RATE);
        let fewer = (points[1] as f64 * RATE.ln() / rate.ln()).ceil() as usize;
        let rule = UnitRule::of(fewer.max(2));
        for (t, weight) in rule.iter() {
            let ArcPoint { position, climb } = self.at(side, low + t * (high - low));
            let weight = weight * (high - low) * climb;
            self.below(chart.longitude(position), chart.latitude(position), weight);
        }
    }

    /// Adds F(φ, ψ) times `weight`.
    fn below(&mut self, longitude: f64, latitude: f64, weight: f64) {
        let Zone { basis, chart, width, points, .. } = self.zone;
        let reach = longitude.min(*width);
        let rule = UnitRule::of(points[0]);
        for (t, share) in rule.iter() {
            let place = basis.frame().locate(DVec3::ZERO, chart.parameters(t * reach, latitude));
            basis.raw(place, &mut self.values);
            let factor = self.factor * weight * share * reach;
            self.out.iter_mut().zip(&self.values).for_each(|(sum, value)| *sum += factor * value);
        }
        self.evaluations += rule.nodes.len() as u64;
    }

    /// Adds T(ψ) times `weight`.
    fn seam(&mut self, latitude: f64, weight: f64) {
        let Zone { latitudes: [south, north], points, .. } = *self.zone;
        let from = latitude.clamp(south, north);
        let rule = UnitRule::of(points[2]);
        for (t, share) in rule.iter() {
            let latitude = north + t * (from - north);
            self.below(TAU, latitude, weight * share * (from - north) * latitude.cos());
        }
    }
}

#[cfg(test)]
pub(super) mod tests {
    use std::sync::Arc;

    use proptest::prelude::*;
    use radiosity_elements::basis::Frame;
    use radiosity_geom::shapes::Sphere;
    use radiosity_geom::{Flipped, Rect};

    use super::*;

    /// A part of the unit sphere about the origin, of order 2: its outside or its inside.
    pub(in crate::rules) fn part_of_sphere(
        axis: DVec3,
        z: [f64; 2],
        angle: [f64; 2],
        is_hollow: bool,
    ) -> Element {
        let sphere = Sphere::new(DVec3::ZERO, 1.0, axis, z, angle).expect("a sphere");
        let shape: Arc<dyn Surface> =
            if is_hollow { Arc::new(Flipped::new(Box::new(sphere))) } else { Arc::new(sphere) };
        let area = shape.area();
        let patches = vec![Patch::curved(shape, &Rect::FULL)];
        let frame = Frame::Parameters { center: DVec2::ZERO, half: DVec2::ONE };
        let basis = AreaBasis::new(2, frame, &patches).expect("it has area");
        Element {
            surface: 0,
            rect: Rect::FULL,
            constant: Vec::new(),
            hull: Vec::new(),
            plane: None,
            level: None,
            extent: 2.0,
            contact: None,
            shaded_by: None,
            area,
            basis,
            patches,
        }
    }

    /// ∫ R_l dA over what `x` sees through a polygon, by midpoints.
    fn by_midpoints(element: &Element, x: DVec3, polygon: &[DVec3]) -> Vec<f64> {
        const STEPS: usize = 700;
        let turn = area_vector(polygon).dot(polygon[0]).signum();
        let mut sums = vec![0.0; element.basis.len()];
        let mut values = sums.clone();
        let place = |k: usize| (k as f64 + 0.5) / STEPS as f64;
        for (i, j) in (0..STEPS).flat_map(|i| (0..STEPS).map(move |j| (i, j))) {
            let y = element.patches[0].node(place(i), place(j));
            let direction = y.position - x;
            if sides(polygon).all(|[a, b]| turn * a.cross(b).dot(direction) > 0.0) {
                element.basis.raw(element.basis.frame().coordinates(&y), &mut values);
                let weight = y.area / (STEPS * STEPS) as f64;
                sums.iter_mut().zip(&values).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        sums
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40))]

        /// Whole spheres, half of them and pieces, seen through polygons of three to six corners, with poles and
        /// the first meridian within or not.
        #[test]
        fn what_is_seen_through_polygons_is_integrated(
            axis in prop::array::uniform3(-1.0..1.0f64),
            kind in 0..3usize,
            from in prop::array::uniform3(-1.0..1.0f64),
            aim in prop::array::uniform2(-1.2..1.2f64),
            spread in prop::collection::vec(0.2..1.5f64, 3..7),
            reversed: bool,
        ) {
            let [axis, from] = [axis, from].map(DVec3::from_array);
            prop_assume!(axis.length() > 0.1 && from.length() > 0.1);
            let (z, angle) = [
                ([-1.0, 1.0], [0.3, 0.3 + TAU]), ([0.1, 1.0], [0.0, TAU]), ([-0.6, 0.7], [1.0, 4.0]),
            ][kind];
            let element = &part_of_sphere(axis, z, angle, true);
            let zone = Zone::of(element, 1e-8).expect("it is a zone");
            let x = from.normalize();
            let inward = -from.normalize();
            let (a, b) = inward.any_orthonormal_pair();
            let turn = TAU / spread.len() as f64;
            let mut polygon: Vec<DVec3> = spread.iter().enumerate().map(|(k, reach)| {
                let (sin, cos) = (turn * k as f64).sin_cos();
                0.8 * inward + (aim[0] + reach * cos) * a + (aim[1] + reach * sin) * b
            }).collect();
            let normal = inward;
            let convex = |p: &[DVec3]| sides(p).zip(sides(p).skip(1).chain(sides(p).take(1)))
                .all(|([p, q], [_, r])| (q - p).cross(r - q).dot(normal) > 0.0);
            prop_assume!(convex(&polygon));
            if reversed {
                polygon.reverse();
            }
            let mut found = vec![0.0; element.basis.len()];
            zone.seen_through(x, &polygon, 1.0, &mut found);
            let expected = by_midpoints(element, x, &polygon);
            for (found, expected) in found.iter().zip(&expected) {
                prop_assert!((found - expected).abs() < 4e-3, "{found} for {expected}");
            }
        }
    }

    /// The circle of the polar angle θ from the point opposite to x has the area 2π (1 − cos θ); a polygon of n
    /// corners about it misses n⁻² of that.
    #[test]
    fn a_cap_about_the_pole_has_its_area() {
        let element = part_of_sphere(DVec3::Z, [-1.0, 1.0], [0.0, TAU], true);
        let zone = Zone::of(&element, 1e-12).expect("it is a zone");
        let x = -DVec3::Z;
        let tangent = 0.4f64;
        let area_of = |corners: usize| {
            let turn = TAU / corners as f64;
            let corner = |k: usize| {
                let (sin, cos) = (turn * k as f64).sin_cos();
                DVec3::new(tangent * cos, tangent * sin, 1.0)
            };
            let polygon: Vec<DVec3> = (0..corners).map(corner).collect();
            let mut found = vec![0.0; element.basis.len()];
            zone.seen_through(x, &polygon, 1.0, &mut found);
            found[0] / element.basis.constant()
        };
        let exact = TAU * (1.0 - (2.0 * tangent.atan()).cos());
        let [few, many] = [64, 128].map(area_of);
        let limit = many + (many - few) / 3.0;
        assert!((limit / exact - 1.0).abs() < 1e-6, "{limit} for {exact}");
    }
}
