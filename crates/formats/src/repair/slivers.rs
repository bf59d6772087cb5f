//! Faces without area.

use radiosity_fit::outline::length_and_width;
use radiosity_geom::COINCIDENT;
use radiosity_geom::area_vector;
use radiosity_photometry::note_text::NoteText;

use crate::model::{Mantle, Model, Shape};
use crate::repair::edit::Edit;
use crate::repair::record::{RepairKind, Repairs};

/// Width over length of a face without area: rounding of single precision leaves 6·10⁻⁸. With a larger value
/// narrow faces that were meant, such as gaps between boards, would vanish.
const NARROW: f64 = 1e-7;

/// Removes faces without area.
pub(super) fn remove(model: &mut Model, repairs: &mut Repairs) {
    let mut edit = Edit::default();
    for (index, surface) in model.surfaces.iter().enumerate().filter(|(_, surface)| is_sliver(&surface.shape))
    {
        edit.replace(index, Vec::new());
        let text = NoteText::default().naming(&surface.name).then(" has no area; it was removed");
        repairs.say(RepairKind::Sliver, vec![surface.name.clone()], Some(surface), text);
    }
    edit.apply(model, repairs);
}

fn is_sliver(shape: &Shape) -> bool {
    match shape {
        Shape::Polygon { outline, .. } => outline.len() < 3 || is_narrow(outline),
        Shape::Quad(corners) => is_narrow(corners),
        Shape::Disk { radius, inner, normal, .. } => {
            radius - inner <= NARROW * radius || normal.length_squared() == 0.0
        }
        Shape::Sphere { radius, .. } => *radius <= 0.0,
        Shape::Torus { minor, axis, .. } => *minor <= 0.0 || axis.length_squared() == 0.0,
        Shape::Cylinder { .. } | Shape::Cone { .. } => {
            shape.mantle().is_some_and(|Mantle { axis, radii, .. }| {
                radii[0].max(radii[1]) <= 0.0 || axis.length_squared() == 0.0
            })
        }
    }
}

/// Whether a ring is a line but for rounding. The net area alone does not tell: that of a bow tie may be 0.
fn is_narrow(ring: &[glam::DVec3]) -> bool {
    let [length, width] = length_and_width(ring);
    let is_triangle_of_no_area =
        ring.len() == 3 && area_vector(ring).length() <= COINCIDENT * length * length;
    width <= NARROW * length || is_triangle_of_no_area
}
