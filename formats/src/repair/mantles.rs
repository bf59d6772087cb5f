//! Cylinders and cones of which a part lies in another one.
//!
//! The shorter one is raised before its own front by a gap that lets no light through, as a sleeve on a pipe.

use std::collections::HashMap;

use glam::DVec3;

use crate::model::{Model, Shape};
use crate::repair::record::{Kind, Repairs};

/// Gap over the radius: a hundred times what is no length. Chosen; not tuned.
const GAP: f64 = 1e-7;

/// Steps in which axes are compared. Chosen; not tuned.
const KEY: f64 = 1e-8;

/// Part of the shorter length that two have to share at the least. Chosen; not tuned.
const SHARED: f64 = 1e-3;

/// Raises cylinders and cones that lie partly in others.
pub(super) fn mend(model: &mut Model, repairs: &mut Repairs) {
    for mut line in lines(model) {
        // Longer ones first.
        line.sort_by(|a, b| b.1.length().total_cmp(&a.1.length()).then(a.0.cmp(&b.0)));
        let mut steps: Vec<f64> = Vec::with_capacity(line.len());
        for (own, (index, mantle)) in line.iter().enumerate() {
            let under = (0..own).filter(|other| mantle.overlaps(&line[*other].1));
            let Some(under) = under.max_by(|a, b| steps[*a].total_cmp(&steps[*b])) else {
                steps.push(0.0);
                continue;
            };
            steps.push(steps[under] + GAP);
            let names = [*index, line[under].0].map(|surface| model.surfaces[surface].name.clone());
            let text = format!("{:?} lies partly in {:?}; it was raised slightly", names[0], names[1]);
            repairs.say(Kind::Overlap, names.to_vec(), model.surfaces[*index].place, text);
            raise(&mut model.surfaces[*index].shape, steps[own]);
        }
    }
}

/// Groups of mantles that are parts of one, each with the index of its surface.
fn lines(model: &Model) -> Vec<Vec<(usize, Mantle)>> {
    let reach = reach(model);
    let mut lines: HashMap<[i64; 8], Vec<(usize, Mantle)>> = HashMap::new();
    for (index, surface) in model.surfaces.iter().enumerate() {
        if let Some(mantle) = Mantle::of(&surface.shape) {
            lines.entry(mantle.key(reach)).or_default().push((index, mantle));
        }
    }
    let mut lines: Vec<_> = lines.into_values().filter(|line| line.len() > 1).collect();
    lines.sort_by_key(|line| line[0].0);
    lines
}

/// The largest coordinate.
fn reach(model: &Model) -> f64 {
    let ends = model.surfaces.iter().filter_map(|surface| Mantle::of(&surface.shape));
    ends.map(|mantle| mantle.radius.max(mantle.middle.length())).fold(f64::MIN_POSITIVE, f64::max)
}

/// Changes the radii by a part of them, outwards or inwards as the front is.
fn raise(shape: &mut Shape, part: f64) {
    match shape {
        Shape::Cylinder { radius, inward, .. } => *radius *= if *inward { 1.0 - part } else { 1.0 + part },
        Shape::Cone { radii, inward, .. } => {
            let largest = radii[0].max(radii[1]);
            let by = part * if *inward { -largest } else { largest };
            *radii = radii.map(|radius| (radius + by).max(0.0));
        }
        _ => {}
    }
}

/// A part of an endless cylinder or cone.
struct Mantle {
    /// Unit vector along the axis, into one half of space.
    along: DVec3,
    /// Point of the axis nearest to the origin.
    middle: DVec3,
    /// Radius there, and its growth along the axis.
    radius: f64,
    growth: f64,
    /// Where it begins and ends along the axis.
    range: [f64; 2],
}

impl Mantle {
    fn of(shape: &Shape) -> Option<Mantle> {
        let (base, axis, radii) = match *shape {
            Shape::Cylinder { base, axis, radius, .. } => (base, axis, [radius, radius]),
            Shape::Cone { base, axis, radii, .. } => (base, axis, radii),
            _ => return None,
        };
        let (length, along) = (axis.length(), axis.try_normalize()?);
        let leading = along.to_array().into_iter().find(|x| x.abs() > KEY).unwrap_or(1.0);
        let along = along * leading.signum();
        let growth = (radii[1] - radii[0]) / length * leading.signum();
        let start = base.dot(along);
        let end = start + length * leading.signum();
        let (middle, radius) = (base - start * along, radii[0] - growth * start);
        Some(Mantle { along, middle, radius, growth, range: [start.min(end), start.max(end)] })
    }

    /// What mantles in one another have in common, in steps.
    fn key(&self, reach: f64) -> [i64; 8] {
        let [a, m] = [self.along, self.middle / reach].map(|x| x.to_array());
        let steps = |x: f64| (x / KEY).round() as i64;
        [a[0], a[1], a[2], self.growth, m[0], m[1], m[2], self.radius / reach].map(steps)
    }

    fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    fn overlaps(&self, other: &Mantle) -> bool {
        let least = SHARED * self.length().min(other.length());
        self.range[1].min(other.range[1]) - self.range[0].max(other.range[0]) > least
    }
}
