//! Normals that a file states at the corners of a face.

use glam::DVec3;
use radiosity_geom::area_vector;

use crate::model::Sides;

/// Remark on normals of vertices that are left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Remark {
    /// They are not those of the faces there.
    Rounded,
    /// They point to the backs of the faces there.
    Opposed,
}

impl Remark {
    /// The text of a note.
    pub(crate) const fn text(self) -> &'static str {
        match self {
            Self::Rounded => "normals of vertices are left out: faces are flat",
            Self::Opposed => {
                "normals of vertices that point to the back of their face are left out: the order of corners tells the front"
            }
        }
    }
}

/// Sine of the angle between the normal of a vertex and that of a face from which on they differ. Chosen: half a
/// degree, beyond what normals written with two digits err by.
const ROUNDED_FROM: f64 = 1e-2;

/// Whether planes with these normals of length 1 meet at an angle.
pub(crate) fn is_bent(one: DVec3, other: DVec3) -> bool {
    one.cross(other).length() > ROUNDED_FROM
}

/// The corners of a face and the normals stated there; 0 states none.
pub(crate) struct FaceNormals<'a> {
    pub(crate) corners: &'a [DVec3],
    pub(crate) normals: Vec<DVec3>,
}

impl FaceNormals<'_> {
    /// Note on normals that are not those of the face: light that is interpolated between them makes flat faces look
    /// round, and where they point to the back of a face of one side the front is another one.
    pub(crate) fn remark(&self, sides: Sides) -> Option<Remark> {
        let own = area_vector(self.corners).try_normalize()?;
        let is_opposed = |normal: &DVec3| sides != Sides::Both && normal.dot(own) < 0.0;
        let stated = self.normals.iter().filter_map(|normal| normal.try_normalize());
        let mut others = stated.filter(|normal| is_bent(*normal, own) || is_opposed(normal));
        let first = others.next()?;
        let are_opposed = is_opposed(&first) && others.all(|normal| is_opposed(&normal));
        Some(if are_opposed { Remark::Opposed } else { Remark::Rounded })
    }
}
