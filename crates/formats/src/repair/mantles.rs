//! Cylinders and cones of which a part lies in another one.
//!
//! The shorter one is raised before its own front by a gap that lets no light through, as a sleeve on a pipe.

use glam::DVec3;
use radiosity_geom::{Aabb, Bvh};
use radiosity_photometry::note_text::NoteText;

use crate::model::{self, Model, Shape, Surface};
use crate::repair::record::{RepairKind, Repairs};
use crate::tolerances::RAISED;

/// Greatest difference of each measure of mantles in one another: a tenth of what they are raised by, so that
/// what was raised is not found again. Smaller than single precision leaves: such mantles are found where
/// they were written alike.
const STEP: f64 = 1e-8;

/// Part of the shorter length that two have to share at the least: pipes that are joined end to end share a
/// rounding. With a larger value sleeves that overlap a little would not be raised.
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
            steps.push(steps[under] + RAISED);
            let names = [*index, line[under].0].map(|surface| model.surfaces[surface].name.clone());
            let text = NoteText::default().naming(&names[0]).then(" lies partly in ").naming(&names[1]);
            let text = text.then("; it was raised slightly");
            repairs.say(RepairKind::Overlap, names.to_vec(), Some(&model.surfaces[*index]), text);
            raise(&mut model.surfaces[*index].shape, steps[own]);
        }
    }
}

/// Groups of mantles that are parts of one, each with the index of its surface: those that agree with the
/// first of a group.
fn lines(model: &Model) -> Vec<Vec<(usize, Mantle)>> {
    let of = |(index, surface): (usize, &Surface)| Some((index, Mantle::of(&surface.shape)?));
    let mut mantles: Vec<_> = model.surfaces.iter().enumerate().filter_map(of).map(Some).collect();
    let reach = |(_, mantle): &(usize, Mantle)| mantle.radius.max(mantle.middle.length());
    let reach = mantles.iter().flatten().map(reach).fold(f64::MIN_POSITIVE, f64::max);
    let measures: Vec<[f64; 8]> =
        mantles.iter().flatten().map(|(_, mantle)| mantle.measures(reach)).collect();
    let place = |[x, y, z, ..]: &[f64; 8]| DVec3::new(*x, *y, *z);
    let boxes: Vec<Aabb> = measures.iter().map(|own| Aabb { min: place(own), max: place(own) }).collect();
    let tree = Bvh::build(&boxes);
    let mut lines = Vec::new();
    for (first, own) in measures.iter().enumerate() {
        if mantles[first].is_none() {
            continue;
        }
        let mut alike = Vec::new();
        tree.overlapping(&boxes[first].inflate(STEP), |other| {
            let is_near = own.iter().zip(&measures[other]).all(|(x, y)| (x - y).abs() <= STEP);
            if is_near && mantles[other].is_some() {
                alike.push(other);
            }
        });
        alike.sort_unstable();
        let line: Vec<_> = alike.into_iter().filter_map(|other| mantles[other].take()).collect();
        if line.len() > 1 {
            lines.push(line);
        }
    }
    lines
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
    /// Coordinates of both ends along the axis (length).
    range: [f64; 2],
}

impl Mantle {
    fn of(shape: &Shape) -> Option<Mantle> {
        let model::Mantle { base, axis, radii, .. } = shape.mantle()?;
        let (length, along) = (axis.length(), axis.try_normalize()?);
        let leading = along.to_array().into_iter().find(|x| x.abs() > STEP).unwrap_or(1.0);
        let along = along * leading.signum();
        let growth = (radii[1] - radii[0]) / length * leading.signum();
        let start = base.dot(along);
        let end = start + length * leading.signum();
        let (middle, radius) = (base - start * along, radii[0] - growth * start);
        Some(Mantle { along, middle, radius, growth, range: [start.min(end), start.max(end)] })
    }

    /// Measures that mantles in one another have in common: the middle over the reach, the axis, the radius
    /// over the reach, and the growth.
    fn measures(&self, reach: f64) -> [f64; 8] {
        let [m, a] = [self.middle / reach, self.along].map(|x| x.to_array());
        [m[0], m[1], m[2], a[0], a[1], a[2], self.radius / reach, self.growth]
    }

    fn length(&self) -> f64 {
        self.range[1] - self.range[0]
    }

    fn overlaps(&self, other: &Mantle) -> bool {
        let least = SHARED * self.length().min(other.length());
        self.range[1].min(other.range[1]) - self.range[0].max(other.range[0]) > least
    }
}
