//! Exchange of two coaxial surfaces of revolution with straight meridians, past a coaxial cylinder.
//!
//! Definition. Both surfaces go all the way round. With (r₁, z₁) and (r₂, z₂) on their meridians, s and t the
//! lengths along these, and φ the angle between two points about the axis,
//!
//! ```text
//! A₁ F₁₂ = ∬ 4 π r₁ r₂ ∫ κ(φ) dφ ds dt ,     0 ≤ φ ≤ π where both points see each other.
//! ```
//!
//! Outside of a cylinder of the radius R about the same axis that covers all heights between them, two points
//! see each other exactly where
//!
//! ```text
//! φ < acos(R/r₁) + acos(R/r₂) ,
//! ```
//!
//! and each lies in front of the other where φ is in an interval too. So the inner integral has limits, and a
//! closed form (`ring_pair`). The outer ones are smooth but where the meridians touch, and near it; there Gauss
//! rules on cells that are halved converge exponentially (`cells`). Substitutions take the rest away:
//!
//! * r = R + (r₀ − R) τ² where a meridian ends on the cylinder, as acos(R/r) ~ √(r − R);
//! * s = t + z, z ≥ 0, with twice the sum, of one surface with itself, as |s − t| counts;
//! * t = t₀ + h sinh μ of others, where t₀ ± ih are the places at no distance from s: of meridians a small gap
//!   apart each place sees those within about the gap, whatever the lengths.
//!
//! Range of use. Cylinders, cones, disks and rings of which neither hides a part of itself from the other but
//! by its horizon. Error: twice the sum over all cells of the differences between two rules, the better of
//! which is taken; where meridians are a gap apart that is small beside the radius R, rounding leaves R/gap
//! times 10⁻¹⁶.
//!
//! Reference: P. R. Johnston, D. Elliott, *Int. J. Numer. Methods Eng.* 62 (2005), for the map by sinh.

mod cells;
mod ring_pair;
mod stretch;

use radiosity_geom::{DVec2, Meridian, ROUNDING};

use cells::Cells;
pub use cells::Found;
use ring_pair::{Ring, RingPair};
use stretch::Stretch;

/// Two coaxial surfaces, and the cylinder between them.
#[derive(Clone, Copy, Debug)]
pub struct Coaxial {
    /// The meridians, along one axis from one origin.
    pub pair: [Meridian; 2],
    /// Whether both are one surface.
    pub is_same: bool,
    /// Radius of the cylinder, 0 for none.
    pub core: f64,
}

impl Coaxial {
    /// The exchange of the two, A₁ F₁₂ (length²), to the relative accuracy `eps`.
    pub fn exchange(&self, eps: f64) -> Found {
        let lines = self.pair.map(|meridian| Line::of(&meridian, self.core));
        match self.is_same {
            true => Cells::integral(eps, |y, z| {
                let base = (1.0 - z) * y;
                2.0 * (1.0 - z) * self.density([lines[0].at(base + z), lines[1].at(base)])
            }),
            false => Cells::integral(eps, |s, t| {
                let x = lines[0].at(s);
                let (place, stretch) = lines[1].stretched(x.ring.place).at(t);
                stretch * self.density([x, lines[1].at(place)])
            }),
        }
    }

    /// The exchange of two rings, over the lengths of both lines in their parameters.
    fn density(&self, [x, y]: [Place; 2]) -> f64 {
        let rings = [x.ring, y.ring];
        x.speed * y.speed * RingPair::new(rings, self.is_same).exchange(self.core)
    }
}

/// A meridian over a parameter from 0 to 1.
struct Line {
    start: DVec2,
    along: DVec2,
    normal: DVec2,
    /// Whether the parameter is squared: from the start, which lies on the cylinder.
    is_squared: bool,
}

/// A place on a line.
struct Place {
    ring: Ring,
    /// Length per parameter.
    speed: f64,
}

impl Line {
    fn of(meridian: &Meridian, core: f64) -> Self {
        let touches = |end: &DVec2| core > 0.0 && (end.x - core).abs() <= ROUNDING * core;
        let [mut start, mut end] = meridian.ends;
        if touches(&end) {
            (start, end) = (end, start);
        }
        let is_squared = touches(&start) && !touches(&end);
        Self { start, along: end - start, normal: meridian.normal, is_squared }
    }

    /// The parameter about the place nearest to another one.
    fn stretched(&self, to: DVec2) -> Stretch {
        let length = self.along.length();
        let along = self.along / length;
        let between = (to - self.start) / length;
        let pole = DVec2::new(between.dot(along), between.perp_dot(along).abs());
        Stretch::about(if self.is_squared { root(pole) } else { pole })
    }

    fn at(&self, parameter: f64) -> Place {
        let (at, speed) = match self.is_squared {
            true => (parameter * parameter, 2.0 * parameter),
            false => (parameter, 1.0),
        };
        let ring = Ring { place: self.start + at * self.along, normal: self.normal };
        Place { ring, speed: speed * self.along.length() }
    }
}

/// Square root of the complex number x + iy, y ≥ 0. The smaller part follows from the larger one, or its digits
/// would cancel.
fn root(square: DVec2) -> DVec2 {
    let larger = (0.5 * (square.length() + square.x.abs())).sqrt();
    let smaller = if larger > 0.0 { 0.5 * square.y / larger } else { 0.0 };
    if square.x >= 0.0 { DVec2::new(larger, smaller) } else { DVec2::new(smaller, larger) }
}

#[cfg(test)]
mod tests;
