//! Errors of the constructors of shapes.

use thiserror::Error;

/// Why a shape cannot be built: each message names the field, as the scene file spells it, and the cure.
///
/// Lengths are in the scene's unit. [`ShapeError::field`] returns the name of the field at fault.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ShapeError {
    /// A coordinate or number is NaN or infinite.
    #[error("`{field}` holds a number that is not finite; give finite numbers")]
    NotFinite {
        /// The field at fault.
        field: String,
    },
    /// A vector has no length.
    #[error("`{field}` has no length; give a vector that does not vanish")]
    ZeroLength {
        /// The field at fault.
        field: String,
    },
    /// Two edges span no area.
    #[error("`{field}` is parallel to `{other}`; the two must span an area")]
    Parallel {
        /// The second edge.
        field: String,
        /// The first edge.
        other: String,
    },
    /// A length or weight that must be above zero is not.
    #[error("`{field}` is {value}; it must be greater than zero")]
    NotPositive {
        /// The field at fault.
        field: String,
        /// The number given.
        value: f64,
    },
    /// A quantity that must not be negative is.
    #[error("`{field}` is {value}; it must not be negative")]
    Negative {
        /// The field at fault.
        field: String,
        /// The number given.
        value: f64,
    },
    /// Of two numbers the smaller is not below the larger.
    #[error("`{field}` ({low}) must be less than {limit} ({high})")]
    OutOfOrder {
        /// The field at fault.
        field: String,
        /// The number that `field` is compared with, such as "`radius`" or "its second number".
        limit: String,
        /// The number that should be the lower one.
        low: f64,
        /// The number that should be the higher one.
        high: f64,
    },
    /// A range does not fit into the range it must lie in.
    #[error("`{field}` = [{low}, {high}] leaves [{least}, {most}]; choose numbers inside")]
    OutOfRange {
        /// The field at fault.
        field: String,
        /// Lower number given.
        low: f64,
        /// Higher number given.
        high: f64,
        /// Lowest number possible.
        least: f64,
        /// Highest number possible.
        most: f64,
    },
    /// A ring of a polygon has too few vertices.
    #[error("`{field}` has {count} vertices; a polygon needs at least three")]
    TooFewVertices {
        /// The ring at fault.
        field: String,
        /// Number of its vertices.
        count: usize,
    },
    /// Two successive vertices coincide.
    #[error("`{field}` repeats its vertex {index}; remove the second copy")]
    RepeatedVertex {
        /// The ring at fault.
        field: String,
        /// Zero-based index of the first of the two.
        index: usize,
    },
    /// A vertex lies off the plane of the others.
    #[error(
        "`{field}`: vertex {index} lies {deviation:.3e} off the plane of the outline; move it into the plane, \
         or use a `quad` or several triangles"
    )]
    NotPlanar {
        /// The ring at fault.
        field: String,
        /// Zero-based index of the vertex farthest off.
        index: usize,
        /// Distance of that vertex from the plane (length).
        deviation: f64,
    },
    /// Two edges of a ring cross or touch.
    #[error("`{field}` crosses itself: edges {first} and {second} meet; reorder or split it")]
    SelfCrossing {
        /// The ring at fault.
        field: String,
        /// Zero-based index of one edge (from vertex `first` to the next).
        first: usize,
        /// Zero-based index of the other edge.
        second: usize,
    },
    /// A hole is not inside the outline.
    #[error("`{field}` reaches outside the outline; shrink or move the hole")]
    HoleOutside {
        /// The hole at fault.
        field: String,
    },
    /// Two holes overlap.
    #[error("`{field}` overlaps `{other}`; merge the two holes into one")]
    HolesOverlap {
        /// The later hole.
        field: String,
        /// The earlier hole.
        other: String,
    },
    /// Holes were asked for on a surface that is not a planar polygon.
    #[error("`{field}`: only planar polygons can have holes; remove them or make the surface planar")]
    HolesOnCurved {
        /// The field at fault.
        field: String,
    },
    /// The shape has no area, or a patch is degenerate beyond a collapsed edge.
    #[error("`{field}` spans no area; spread the points out")]
    NoArea {
        /// The field at fault.
        field: String,
    },
    /// The curve of a surface of revolution is not in one half-plane bounded by the axis.
    #[error(
        "`{field}`: point {index} lies {deviation:.3e} off the half-plane of the axis and the farthest point; move it there"
    )]
    OffMeridian {
        /// The curve at fault.
        field: String,
        /// Zero-based index of the point farthest off.
        index: usize,
        /// Distance of that point from the half-plane (length).
        deviation: f64,
    },
    /// The curve of a surface of revolution crosses the axis.
    #[error("`{field}` crosses the axis by {depth:.3e}; keep the curve on one side")]
    CrossesAxis {
        /// The curve at fault.
        field: String,
        /// Largest distance of the curve beyond the axis (length).
        depth: f64,
    },
    /// The front of the surface turns over inside it.
    #[error(
        "`{field}` folds over: its normal changes side; give the corners in order around a convex outline"
    )]
    Folded {
        /// The field at fault.
        field: String,
    },
    /// A flat sheet or straight profile lies in itself.
    #[error("`{field}` turns back on itself; give control points that advance from one end to the other")]
    TurnsBack {
        /// The field at fault.
        field: String,
    },
}

impl ShapeError {
    /// The name of the field at fault, as the scene file spells it; `holes[1]` for a part of a field.
    pub fn field(&self) -> &str {
        match self {
            ShapeError::NotFinite { field }
            | ShapeError::ZeroLength { field }
            | ShapeError::Parallel { field, .. }
            | ShapeError::NotPositive { field, .. }
            | ShapeError::Negative { field, .. }
            | ShapeError::OutOfOrder { field, .. }
            | ShapeError::OutOfRange { field, .. }
            | ShapeError::TooFewVertices { field, .. }
            | ShapeError::RepeatedVertex { field, .. }
            | ShapeError::NotPlanar { field, .. }
            | ShapeError::SelfCrossing { field, .. }
            | ShapeError::HoleOutside { field }
            | ShapeError::HolesOverlap { field, .. }
            | ShapeError::HolesOnCurved { field }
            | ShapeError::NoArea { field }
            | ShapeError::OffMeridian { field, .. }
            | ShapeError::CrossesAxis { field, .. }
            | ShapeError::Folded { field }
            | ShapeError::TurnsBack { field } => field,
        }
    }
}
