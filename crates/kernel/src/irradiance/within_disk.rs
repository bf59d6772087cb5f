//! Irradiance at a point through a disk within a convex outline of arcs and segments ([`crate::irradiance::within`]).
//!
//! Let c be the centre relative to the point, m the unit normal, R the radius and h = c·m. A direction p meets the
//! plane at (h/p·m) p, so that the disk is seen within the cone
//!
//! ```text
//! q(p, p) < 0 ,   h p·m > 0 ,     q(p, r) = w(p)·w(r) − R² (p·m)(r·m) ,   w(p) = h p − (p·m) c .
//! ```
//!
//! A segment, and an arc of up to a right angle as a rational curve, have the Bernstein form Σ b_i P_i in homogeneous
//! coordinates,
//!
//! ```text
//! P = a, b   or   P = first end, cos δ · c′ + amid, last end ,     tan ½φ = tan ½δ · (2 t − 1) ,
//! ```
//!
//! with half the angle δ, the angle φ from the middle, the circle's centre c′, and `amid` the radius to the middle. On
//! them q is a polynomial of degree 2 or 4 in t, whose roots are the places where they pass the rim.

use core::f64::consts::{FRAC_PI_2, TAU};

use radiosity_geom::{DVec3, bernstein_roots};
use radiosity_visibility::round_shadow::RoundShadow;
use radiosity_visibility::shadow_volume::Corners;
use smallvec::SmallVec;

use crate::irradiance::outline::{Arc, Piece, within as irradiance_within};
use crate::irradiance::within::{MOVED, MOVES, Window, Within, by_kites, within};

/// Corners of the polygon that stands for a disk where its border is not closed: it misses 4e-7 of the disk.
const CORNERS: usize = 4096;

/// A disk, relative to the point that sees it.
#[derive(Clone, Copy, Debug)]
pub struct SeenDisk {
    /// Its centre.
    pub center: DVec3,
    /// Two radii at a right angle.
    pub axes: [DVec3; 2],
}

impl SeenDisk {
    /// Irradiance from all of it at exitance 1, above the horizon of the unit normal `n`.
    pub fn irradiance(&self, n: DVec3) -> f64 {
        irradiance_within(n, &[Piece::Arc(self.rim([0.0, TAU]))]).abs()
    }

    /// The part of it that a round thing before its plane hides, all of it above the horizon of the unit normal `n`.
    pub fn hidden(&self, n: DVec3, shadow: &RoundShadow) -> Within {
        let found = (0..=MOVES).find_map(|moves| within(n, shadow, |turn| Rim::of(self.moved(moves), turn)));
        found.unwrap_or_else(|| by_kites(n, &self.corners(), shadow))
    }

    /// The disk after so many moves.
    fn moved(&self, moves: usize) -> Self {
        let size = if moves == 0 { 0.0 } else { MOVED };
        let (sin, cos) = (2.4 * moves as f64).sin_cos();
        let step = size * (cos * self.axes[0] + sin * self.axes[1]);
        Self { center: self.center + step, axes: self.axes.map(|axis| (1.0 + 0.3 * size) * axis) }
    }

    fn corners(&self) -> Corners {
        let rim = Piece::Arc(self.rim([0.0, TAU]));
        (0..CORNERS).map(|k| rim.at(k as f64 / CORNERS as f64)).collect()
    }

    fn rim(&self, angles: [f64; 2]) -> Arc {
        Arc { center: self.center, axes: self.axes, angles }
    }

    /// Unit normal.
    fn normal(&self) -> DVec3 {
        self.axes[0].cross(self.axes[1]).normalize_or_zero()
    }
}

/// The rim of a disk in the sense of an outline.
struct Rim {
    disk: SeenDisk,
    normal: DVec3,
    /// h of the header.
    height: f64,
    radius: f64,
    /// Whether it runs against the angles of the disk.
    is_reversed: bool,
    /// Angles at which it is cut, from 0 to a turn.
    cuts: SmallVec<[f64; 8]>,
}

impl Rim {
    fn of(disk: SeenDisk, turn: f64) -> Self {
        let normal = disk.normal();
        let height = disk.center.dot(normal);
        let (radius, is_reversed) = (disk.axes[0].length(), turn * height < 0.0);
        Self { disk, normal, height, radius, is_reversed, cuts: SmallVec::new() }
    }

    /// w of the header.
    fn aside(&self, p: DVec3) -> DVec3 {
        self.height * p - p.dot(self.normal) * self.disk.center
    }

    /// q of the header.
    fn form(&self, p: DVec3, r: DVec3) -> f64 {
        self.aside(p).dot(self.aside(r)) - self.radius * self.radius * p.dot(self.normal) * r.dot(self.normal)
    }

    /// Where a segment passes the cone over the rim, as parts of it.
    fn places_of_segment(&self, [a, b]: [DVec3; 2]) -> SmallVec<[f64; 8]> {
        let mut places = SmallVec::new();
        let form = [self.form(a, a), self.form(a, b), self.form(b, b)];
        bernstein_roots(form, |place| places.push(place));
        places
    }

    /// Where an arc passes the cone over the rim, as parts of it.
    fn places_of_arc(&self, arc: &Arc) -> SmallVec<[f64; 8]> {
        let mut places = SmallVec::new();
        let turn = arc.angles[1] - arc.angles[0];
        let count = (turn.abs() / FRAC_PI_2).ceil();
        let half = 0.5 * turn / count;
        for k in 0..count as usize {
            let middle = (2 * k + 1) as f64 * half;
            let [a, b, c] = arc.controls(arc.angles[0] + middle, half);
            let bowed = (self.form(a, c) + 2.0 * self.form(b, b)) / 3.0;
            let form = [self.form(a, a), self.form(a, b), bowed, self.form(b, c), self.form(c, c)];
            bernstein_roots(form, |place| {
                let angle = 2.0 * ((0.5 * half).tan() * (2.0 * place - 1.0)).atan();
                places.push((middle + angle) / turn);
            });
        }
        places
    }
}

impl Window for Rim {
    fn cut(&mut self, piece: &Piece) -> SmallVec<[f64; 8]> {
        let mut places = match piece {
            Piece::Segment(ends) => self.places_of_segment(*ends),
            Piece::Arc(arc) => self.places_of_arc(arc),
        };
        // The other half of the cone lies behind the point.
        places.retain(|place| piece.at(*place).dot(self.normal) * self.height > 0.0);
        for place in &places {
            let aside = self.height.signum() * self.aside(piece.at(*place));
            let [x, y] = self.disk.axes.map(|axis| axis.dot(aside));
            self.cuts.push(y.atan2(x).rem_euclid(TAU));
        }
        places
    }

    fn depth(&self, direction: DVec3) -> f64 {
        let along = self.height.signum() * direction.dot(self.normal);
        let aside = self.aside(direction).length();
        (self.radius * along - aside) / (self.radius + self.disk.center.length())
    }

    fn parts(&mut self) -> SmallVec<[Piece; 8]> {
        self.cuts.sort_by(f64::total_cmp);
        let first = self.cuts.first().copied().unwrap_or(0.0);
        let ends = self.cuts.iter().copied().skip(1).chain([first + TAU]);
        let mut from = first;
        let part = |to: f64| {
            let [low, high] = [std::mem::replace(&mut from, to), to];
            Piece::Arc(self.disk.rim(if self.is_reversed { [high, low] } else { [low, high] }))
        };
        ends.map(part).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use proptest::prelude::*;
    use radiosity_geom::Surface;
    use radiosity_geom::shapes::{Cone, Disk, FULL_TURN};
    use radiosity_visibility::frustum::Frustum;

    use super::*;

    /// The solid of revolution of two radii over `axis`; a disk where that has no length.
    fn frustum(base: DVec3, axis: DVec3, radii: [f64; 2]) -> Option<Frustum> {
        let disk = |axis: DVec3| Disk::new(base, axis, radii[0], 0.0, FULL_TURN).ok()?.meridian();
        if axis == DVec3::ZERO {
            return Frustum::of(&disk(DVec3::new(0.3, 0.1, 1.0))?, std::iter::empty());
        }
        let wall = Cone::new(base, axis, radii[0], radii[1], FULL_TURN).ok()?.meridian()?;
        Frustum::of(&wall, std::iter::once((1, disk(axis)?)))
    }

    /// Irradiance at the origin from what a shadow holds of a disk, by midpoints of a grid.
    fn by_midpoints(n: DVec3, disk: &SeenDisk, shadow: &RoundShadow) -> f64 {
        const STEPS: usize = 700;
        let m = disk.normal();
        let middle = |k: usize| (2 * k + 1) as f64 / STEPS as f64 - 1.0;
        let at = |i: usize, j: usize| {
            let [s, t] = [middle(i), middle(j)];
            let d = disk.center + s * disk.axes[0] + t * disk.axes[1];
            if s * s + t * t > 1.0 || !shadow.holds(d) {
                return 0.0;
            }
            n.dot(d) * m.dot(d).abs() / (PI * d.length_squared().powi(2))
        };
        let cell = 4.0 * disk.axes[0].length_squared() / (STEPS * STEPS) as f64;
        (0..STEPS * STEPS).map(|k| cell * at(k / STEPS, k % STEPS)).sum()
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(80))]

        /// Cans, cones and disks of any axis above the unit disk, as points over it and beside it see them.
        #[test]
        fn what_is_hidden_of_a_disk_is_its_integral(
            eye in prop::array::uniform2(-12..12i32),
            base in prop::array::uniform2(-6..6i32),
            height in 2..6i32,
            axis in prop::sample::select(vec![
                DVec3::ZERO, DVec3::Z, 0.3 * DVec3::Z, DVec3::X, DVec3::new(0.4, 0.2, 0.3),
            ]),
            radius in prop::sample::select(vec![0.2, 0.25, 0.5]),
            share in prop::sample::select(vec![0.0, 0.5, 1.0]),
        ) {
            let [eye, base] = [eye, base].map(|[x, y]| 0.125 * DVec3::new(f64::from(x), f64::from(y), 0.0));
            let (eye, base) = (eye + 3.0 * DVec3::Z, base + 0.25 * f64::from(height) * DVec3::Z);
            let Some(body) = frustum(base, axis, [radius, share * radius]) else { return Ok(()) };
            let Some(shadow) = RoundShadow::of_frustum(&body, eye) else { return Ok(()) };
            let disk = SeenDisk { center: -eye, axes: [DVec3::X, DVec3::Y] };
            let found = disk.hidden(-DVec3::Z, &shadow).irradiance;
            let right = by_midpoints(-DVec3::Z, &disk, &shadow);
            prop_assert!((found - right).abs() < 5e-4 * disk.irradiance(-DVec3::Z), "{found} for {right}");
        }
    }

    /// The outline of a can that stands on a disk touches its rim, passes it, or is it.
    #[test]
    fn outlines_may_touch_the_rim() {
        let disk = |eye: DVec3| SeenDisk { center: -eye, axes: [DVec3::X, DVec3::Y] };
        for (base, radius) in [(0.5, 0.5), (0.0, 1.0), (1.0, 0.25), (0.75, 0.25), (1.5, 0.5)] {
            let body = frustum(base * DVec3::X, 0.5 * DVec3::Z, [radius, radius]).expect("a can");
            for eye in [[0.0, 0.0], [0.5, 0.0], [-0.75, 0.25], [1.5, 1.0]].map(|[x, y]| DVec3::new(x, y, 2.0))
            {
                let shadow = RoundShadow::of_frustum(&body, eye).expect("the point lies outside");
                let found = disk(eye).hidden(-DVec3::Z, &shadow).irradiance;
                let right = by_midpoints(-DVec3::Z, &disk(eye), &shadow);
                assert!((found - right).abs() < 2e-4, "{base} {radius} {eye}: {found} for {right}");
            }
        }
    }
}
