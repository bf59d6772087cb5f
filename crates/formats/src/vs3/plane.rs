//! Surfaces in a plane of their own: origin, azimuth, tilt, and coordinates in the plane (geometry `3a`;
//! manual of View3D 3.5, section 3.1, where it is called 3b).

use glam::{DVec2, DVec3};

use crate::xform::sin_cos;

/// The form of a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// `R`: width and height from the lower left corner.
    Rectangle,
    /// `Q`: a quadrilateral from four corners.
    Quadrilateral,
    /// `T`: a triangle from three corners.
    Triangle,
}

impl Form {
    /// The form that `word` begins the name of.
    pub(super) fn of(word: &str) -> Option<Self> {
        match word.chars().next()?.to_ascii_uppercase() {
            'R' => Some(Form::Rectangle),
            'Q' => Some(Form::Quadrilateral),
            'T' => Some(Form::Triangle),
            _ => None,
        }
    }

    /// Count of the numbers of a surface: five of its plane, and those in the plane.
    pub(super) fn count(self) -> usize {
        match self {
            Form::Rectangle => 7,
            Form::Quadrilateral => 13,
            Form::Triangle => 11,
        }
    }
}

/// The corners of a surface, counter-clockwise seen from its front, from [`Form::count`] numbers: x, y, z of
/// the origin, azimuth (clockwise from +y) and tilt (0 faces up, 90 stands) in degrees, then measures in the
/// plane, whose first axis runs to the right and whose second runs upwards as the front is seen.
pub(super) fn corners(form: Form, numbers: &[f64]) -> Vec<DVec3> {
    let (plane, inner) = numbers.split_at_checked(5).unwrap_or_default();
    let [x, y, z, azimuth, tilt] = plane else { return Vec::new() };
    let [(sa, ca), (st, ct)] = [sin_cos(*azimuth), sin_cos(*tilt)];
    let right = DVec3::new(-ca, sa, 0.0);
    let up = DVec3::new(-ct * sa, -ct * ca, st);
    let points: Vec<DVec2> = match (form, inner) {
        (Form::Rectangle, [width, height]) => {
            let [w, h] = [*width, *height];
            vec![DVec2::new(0.0, h), DVec2::ZERO, DVec2::new(w, 0.0), DVec2::new(w, h)]
        }
        _ => inner.chunks_exact(2).map(DVec2::from_slice).collect(),
    };
    points.iter().map(|p| DVec3::new(*x, *y, *z) + p.x * right + p.y * up).collect()
}
