//! Bodies: which points they hold, and the surfaces around them.

use std::f64::consts::TAU;

use radiosity_geom::DVec3;

use crate::interiors::surface::{Shape, Surface};
use radiosity_test_support::random::Random;

/// A body that no sensor may stand in.
#[derive(Clone, Debug)]
pub(crate) enum Solid {
    /// Upright over a convex outline, counterclockwise, from one height to another.
    Prism {
        outline: Vec<[f64; 2]>,
        low: f64,
        high: f64,
    },
    Ball {
        center: DVec3,
        radius: f64,
    },
    Can {
        base: DVec3,
        axis: DVec3,
        radius: f64,
    },
}

impl Solid {
    /// Whether the point lies inside or on the body.
    pub(crate) fn holds(&self, x: DVec3) -> bool {
        match self {
            Self::Prism { outline, low, high } => {
                let left = |k: usize| {
                    let ([a, b], [c, d]) = (outline[k], outline[(k + 1) % outline.len()]);
                    (c - a) * (x.y - b) - (d - b) * (x.x - a) >= 0.0
                };
                (*low..=*high).contains(&x.z) && (0..outline.len()).all(left)
            }
            Self::Ball { center, radius } => x.distance(*center) <= *radius,
            Self::Can { base, axis, radius } => {
                let along = (x - base).dot(*axis) / axis.length_squared();
                (0.0..=1.0).contains(&along) && x.distance(base + along * axis) <= *radius
            }
        }
    }
}

/// An upright box: its surfaces, fronts outside, without the sides named in `open`.
pub(crate) fn prism(name: &str, outline: &[[f64; 2]], low: f64, high: f64, open: &[usize]) -> Vec<Surface> {
    let count = outline.len();
    let corner = |k: usize, z: f64| DVec3::new(outline[k % count][0], outline[k % count][1], z);
    let mut surfaces =
        vec![Surface::polygon(format!("{name} top"), (0..count).map(|k| corner(k, high)).collect())];
    if !open.contains(&count) {
        let bottom = (0..count).rev().map(|k| corner(k, low)).collect();
        surfaces.push(Surface::polygon(format!("{name} bottom"), bottom));
    }
    for k in (0..count).filter(|k| !open.contains(k)) {
        let corners = vec![corner(k, low), corner(k + 1, low), corner(k + 1, high), corner(k, high)];
        surfaces.push(Surface::polygon(format!("{name} side {k}"), corners));
    }
    surfaces
}

/// A quadrilateral on a circle, turned at random.
pub(crate) fn footprint(random: &mut Random, [x, y]: [f64; 2], radius: f64) -> Vec<[f64; 2]> {
    let choices = [0.0, random.between(0.0, TAU)];
    let angle = random.pick(&choices);
    let squeeze = random.between(0.3, TAU / 4.0 - 0.3);
    let corner = |turn: f64| [x + radius * (angle + turn).cos(), y + radius * (angle + turn).sin()];
    [-squeeze, squeeze, TAU / 2.0 - squeeze, TAU / 2.0 + squeeze].map(corner).to_vec()
}

/// A closed can: the pipe and its two ends.
pub(crate) fn can(name: &str, base: DVec3, axis: DVec3, radius: f64) -> Vec<Surface> {
    let normal = axis.normalize();
    let disk = |end: &str, center: DVec3, normal: DVec3| Surface {
        name: format!("{name} {end}"),
        shape: Shape::Disk { center, normal, radius },
    };
    vec![
        Surface { name: format!("{name} side"), shape: Shape::Pipe { base, axis, radius } },
        disk("top", base + axis, normal),
        disk("bottom", base, -normal),
    ]
}
