//! Luminous openings: points, faces or bodies that the light of a luminaire comes out of.

/// The form of an opening within its extent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// A point: no extent.
    Point,
    /// A rectangle, level or upright; with three extents a box.
    Box,
    /// An ellipse in the xy plane; with a height an upright cylinder on it.
    Upright,
    /// A cylinder that lies along x.
    AlongX,
    /// A cylinder that lies along y.
    AlongY,
    /// An upright ellipse that faces x.
    FacingX,
    /// An ellipsoid.
    Ellipsoid,
}

/// An opening around the photometric centre of a luminaire.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// Its form.
    pub form: Form,
    /// Its extents along x, y and z, m, ≥ 0.
    pub extent: [f64; 3],
}
