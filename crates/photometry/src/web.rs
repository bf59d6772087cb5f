//! Photometric webs: intensities at angles C and γ, and between them.
//!
//! Between its nodes the intensity is bilinear in (C, γ), periodic in C; at angles γ beyond the table it is
//! 0. With the half gaps w_k between planes (radians), and γ_i ≤ γ ≤ γ_{i+1} in steps h_i, its integral over
//! the sphere is exactly
//!
//! ```text
//! Φ = Σ_k w_k Σ_i [I_k,i (cos γ_i − s_i) + I_k,i+1 (s_i − cos γ_{i+1})] ,     s_i = (sin γ_{i+1} − sin γ_i) / h_i
//! ```
//!
//! because ∫ sin γ (γ_{i+1} − γ) dγ = h_i cos γ_i − (sin γ_{i+1} − sin γ_i), and likewise from the other end;
//! within a step from a to b it is (γ_{i+1} − a) cos a − (γ_{i+1} − b) cos b − (sin b − sin a). For a smooth
//! intensity the error of interpolation is O(h²).

use std::f64::consts::TAU;

use super::symmetry::Symmetry;
use crate::error::{Refusal, refuse};
use crate::text::told;

/// Angle in degrees beyond the last angle of the table up to which a direction still counts as lying on it:
/// rounding.
const EDGE: f64 = 1e-9;

/// Most candelas: more than any source on Earth. Chosen, so that sums stay numbers.
const MOST: f64 = 1e15;

/// Largest gap between the last plane and the first, over the widest of the others, where planes go all
/// around. Chosen: a plane at 360° may be left out, and one more.
const WIDER: f64 = 2.0;

/// Difference of intensities of one direction by plane, over the greatest intensity, beyond which it is
/// noted. Chosen.
const OFF_POLE: f64 = 0.01;

/// Intensities in cd at angles in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Web {
    symmetry: Symmetry,
    planes: Vec<f64>,
    rows: Vec<usize>,
    gammas: Vec<f64>,
    table: Vec<f64>,
}

/// The planes of a table on either side of an angle.
struct Neighbours {
    /// Indices of the planes.
    planes: [usize; 2],
    /// Part of the way from the first one to the other, 0 to 1.
    part: f64,
}

impl Web {
    /// The web of a table that states some planes, and repeats them by a `symmetry`. `table` has the
    /// intensities ≥ 0 of one stated plane after another, at each of the `gammas`; all angles increase.
    ///
    /// # Errors
    /// Angles γ outside 0° … 180°, or that begin neither at 0° nor at 90°; planes that do not go around; no
    /// intensity above 0, or one beyond all lamps.
    pub(crate) fn new(
        symmetry: Symmetry,
        stated: &[f64],
        gammas: Vec<f64>,
        table: Vec<f64>,
    ) -> Result<Self, Refusal> {
        debug_assert_eq!(table.len(), stated.len() * gammas.len());
        let [first, .., last] = gammas[..] else {
            return refuse("there are fewer than two vertical angles", "give at least 0 and 90");
        };
        if !(first == 0.0 || first == 90.0) || last > 180.0 {
            return refuse(
                format!("the vertical angles run from {} to {}", told(first), told(last)),
                "let them begin at 0 (straight down) or 90, and end at 180 or before; beyond their end it is dark",
            );
        }
        let largest = table.iter().copied().fold(0.0, f64::max);
        if !(largest > 0.0 && largest <= MOST) {
            return refuse(
                format!("the greatest luminous intensity is {} cd", told(largest)),
                "check lumens and factors, or leave the luminaire out",
            );
        }
        let (planes, rows) = symmetry.expand(stated);
        goes_around(&planes)?;
        Ok(Self { symmetry, planes, rows, gammas, table })
    }

    /// The symmetry that its file states.
    pub fn symmetry(&self) -> Symmetry {
        self.symmetry
    }

    /// Angles C of its planes all around, in [0°, 360°), which increase; one alone where intensity is the
    /// same all around.
    pub fn planes(&self) -> &[f64] {
        &self.planes
    }

    /// Angles γ, which increase, from 0° or 90° to 180° at the most.
    pub fn gammas(&self) -> &[f64] {
        &self.gammas
    }

    /// Intensities of a plane, counted as in [`Self::planes`], at each of [`Self::gammas`], in cd.
    pub fn candelas(&self, plane: usize) -> &[f64] {
        let count = self.gammas.len();
        let row = self.rows[plane];
        &self.table[row * count..(row + 1) * count]
    }

    /// Intensity at angles in degrees, cd. `c` may be any number, `gamma` is from 0 to 180.
    pub fn at(&self, c: f64, gamma: f64) -> f64 {
        let last = self.gammas.len() - 1;
        if gamma < self.gammas[0] - EDGE || gamma > self.gammas[last] + EDGE {
            return 0.0;
        }
        let upper = self.gammas.partition_point(|angle| *angle <= gamma).clamp(1, last);
        let along = between(self.gammas[upper - 1], self.gammas[upper], gamma);
        let Neighbours { planes: [one, other], part } = self.neighbours(c);
        let of = |plane: usize| {
            let values = self.candelas(plane);
            mix(values[upper - 1], values[upper], along)
        };
        mix(of(one), of(other), part)
    }

    /// The planes on either side of an angle.
    fn neighbours(&self, c: f64) -> Neighbours {
        let c = c.rem_euclid(360.0);
        let count = self.planes.len();
        let upper = self.planes.partition_point(|angle| *angle <= c);
        let (one, other) = ((upper + count - 1) % count, upper % count);
        if one == other {
            return Neighbours { planes: [one; 2], part: 0.0 };
        }
        let start = self.planes[one];
        let gap = (self.planes[other] - start).rem_euclid(360.0);
        let part = ((c - start).rem_euclid(360.0) / gap).clamp(0.0, 1.0);
        Neighbours { planes: [one, other], part }
    }

    /// Half the gaps to both neighbours of a plane, in radians. They add up to 2π.
    fn share(&self, plane: usize) -> f64 {
        let count = self.planes.len();
        if count == 1 {
            return TAU;
        }
        let (before, after) = (self.planes[(plane + count - 1) % count], self.planes[(plane + 1) % count]);
        match (after - before).rem_euclid(360.0).to_radians() {
            // Of two planes each is the other's neighbour on both sides.
            0.0 => TAU / 2.0,
            gaps => gaps / 2.0,
        }
    }

    /// Luminous flux, lm: the exact integral of [`Self::at`] over the sphere.
    pub(crate) fn flux(&self) -> f64 {
        self.flux_between(0.0, 180.0)
    }

    /// The part of [`Self::flux`] at angles γ from `least` to `most`, degrees.
    pub(crate) fn flux_between(&self, least: f64, most: f64) -> f64 {
        let weights = self.zone_weights(least, most);
        let of = |plane: usize| -> f64 {
            self.candelas(plane).iter().zip(&weights).map(|(value, weight)| value * weight).sum()
        };
        (0..self.planes.len()).map(|plane| self.share(plane) * of(plane)).sum()
    }

    /// The integral ∫ sin γ dγ of each node's hat function over γ from `least` to `most`, degrees.
    fn zone_weights(&self, least: f64, most: f64) -> Vec<f64> {
        let mut weights = vec![0.0; self.gammas.len()];
        for (lower, pair) in self.gammas.windows(2).enumerate() {
            let ends = [pair[0].max(least), pair[1].min(most)];
            if ends[0] >= ends[1] {
                continue;
            }
            let [low, high, start, end] = [pair[0], pair[1], ends[0], ends[1]].map(f64::to_radians);
            let sines = end.sin() - start.sin();
            weights[lower] +=
                ((high - start) * start.cos() - (high - end) * end.cos() - sines) / (high - low);
            weights[lower + 1] +=
                ((start - low) * start.cos() - (end - low) * end.cos() + sines) / (high - low);
        }
        weights
    }

    /// Least and greatest intensity at angles γ from `least` to `most`, degrees, in any plane; a bound where
    /// γ leaves the table.
    pub fn range(&self, least: f64, most: f64) -> [f64; 2] {
        let last = self.gammas.len() - 1;
        let leaves = least < self.gammas[0] - EDGE || most > self.gammas[last] + EDGE;
        let from = self.gammas.partition_point(|angle| *angle <= least).saturating_sub(1);
        let to = self.gammas.partition_point(|angle| *angle < most).min(last);
        let values = || self.table.chunks_exact(last + 1).flat_map(|row| &row[from.min(to)..=to]).copied();
        [if leaves { 0.0 } else { values().fold(f64::INFINITY, f64::min) }, values().fold(0.0, f64::max)]
    }

    /// The angle, degrees, over which the greatest intensity would fall to nothing as steeply as it changes
    /// anywhere at angles γ from `least` to `most`, degrees; 0 where the table is cut off between them.
    pub fn scale(&self, least: f64, most: f64) -> f64 {
        let last = self.gammas.len() - 1;
        let end = self.gammas[last];
        if end < most && self.range(end, end)[1] > 0.0 {
            return 0.0;
        }
        let within = (0..=last).filter(|index| (least..=most).contains(&self.gammas[*index]));
        let all = within.flat_map(|index| (0..self.planes.len()).map(move |plane| (plane, index)));
        let slope = |(plane, index)| f64::max(self.slope_down(plane, index), self.slope_across(plane, index));
        self.largest() / all.map(slope).fold(0.0, f64::max)
    }

    /// Change of intensity from a node to the next of its plane (cd per degree).
    fn slope_down(&self, plane: usize, index: usize) -> f64 {
        let [own, next] = [index, (index + 1).min(self.gammas.len() - 1)];
        let values = self.candelas(plane);
        let step = self.gammas[next] - self.gammas[own];
        if step > 0.0 { (values[next] - values[own]).abs() / step } else { 0.0 }
    }

    /// Change of intensity from a node to that of the next plane (cd per degree); 0 at the poles, where all
    /// planes are one.
    fn slope_across(&self, plane: usize, index: usize) -> f64 {
        let next = (plane + 1) % self.planes.len();
        let gap = (self.planes[next] - self.planes[plane]).rem_euclid(360.0);
        let step = gap * self.gammas[index].to_radians().sin();
        let change = (self.candelas(next)[index] - self.candelas(plane)[index]).abs();
        if step > EDGE { change / step } else { 0.0 }
    }

    /// Greatest intensity, cd.
    pub(crate) fn largest(&self) -> f64 {
        self.table.iter().copied().fold(0.0, f64::max)
    }

    /// Remarks on what looks wrong in the table: planes that differ at γ = 0°, γ = 180° or C = 360°, and an
    /// end of γ at neither 90° nor 180°.
    pub(super) fn remarks(&self) -> Vec<String> {
        let mut remarks = Vec::new();
        for (index, angle) in [(0, 0.0), (self.gammas.len() - 1, 180.0)] {
            let (least, most) = self.spread(index);
            if self.gammas[index] == angle && most - least > OFF_POLE * self.largest() {
                remarks.push(format!("at γ = {angle}° the planes differ, from {least:.0} to {most:.0} cd"));
            }
        }
        if self.differs_at_360() {
            remarks.push("the planes C0 and C360 differ; C0 is taken for both".to_owned());
        }
        let last = self.gammas[self.gammas.len() - 1];
        if last != 90.0 && last != 180.0 {
            remarks.push(format!("the table ends at γ = {last}°; beyond it is dark"));
        }
        remarks
    }

    /// Whether a plane at C360 was stated whose intensities differ from those at C0.
    fn differs_at_360(&self) -> bool {
        let count = self.gammas.len();
        let last = self.table.len() / count - 1;
        let stated = &self.table[last * count..];
        let is_off = |(a, b): (&f64, &f64)| (a - b).abs() > OFF_POLE * self.largest();
        !self.rows.contains(&last) && stated.iter().zip(self.candelas(0)).any(is_off)
    }

    /// Least and greatest intensity of all planes at one γ, by its index (cd).
    fn spread(&self, gamma: usize) -> (f64, f64) {
        (0..self.planes.len())
            .map(|plane| self.candelas(plane)[gamma])
            .fold((f64::INFINITY, 0.0), |(least, most), value| (least.min(value), f64::max(most, value)))
    }
}

/// Checks that the last plane is about as far from the first as planes are from one another.
fn goes_around(planes: &[f64]) -> Result<(), Refusal> {
    let [first, .., last] = planes else { return Ok(()) };
    let widest = planes.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
    match 360.0 + first - last <= WIDER * widest {
        true => Ok(()),
        false => refuse(
            format!("the planes go from C = {first}° to {last}° without a symmetry that gives the rest"),
            "give planes all around, or the symmetry",
        ),
    }
}

/// Position of `x` between `start` (0) and `end` (1).
fn between(start: f64, end: f64, x: f64) -> f64 {
    ((x - start) / (end - start)).clamp(0.0, 1.0)
}

fn mix(start: f64, end: f64, part: f64) -> f64 {
    start * (1.0 - part) + end * part
}
