//! Planes of sensors: points at the middles of equal cells of a parallelogram.
//!
//! With the origin o, the edges a and b, and the wanted spacings s and t, there are
//!
//! ```text
//! n = ⌈|a| / s⌉ ,   m = ⌈|b| / t⌉   cells,   x_ij = o + (i + ½) a / n + (j + ½) b / m ,
//! ```
//!
//! so that cells are no longer than wanted (EN 12464-1 gives the largest spacing) and fill the plane. Sensors
//! receive along a × b.

use radiosity_geom::{DVec3, PARALLEL_DIRECTIONS};

use crate::{
    fault::{Fault, FaultKind},
    ranges::{check_number, check_range},
};

/// Most sensors of a plane: some gigabytes of readings. Chosen.
const MOST: f64 = 1e7;

/// Part of a cell by which an edge may be longer than a whole number of spacings: 3 / 0.1 is not 30 in
/// floating point.
const ROUNDING: f64 = 1e-9;

/// A parallelogram with a sensor in the middle of each of its cells, in the coordinates that the scene was
/// given in.
///
/// ```
/// use radiosity_geom::DVec3;
/// use radiosity_scene::SensorPlane;
///
/// let edges = [1.6 * DVec3::X, 0.8 * DVec3::Y];
/// let desk = SensorPlane::new("desk", DVec3::new(2.0, 1.0, 0.75), edges, [0.25, 0.25])?;
/// assert_eq!((desk.counts(), desk.normal()), ([7, 4], DVec3::Z));
/// # Ok::<(), radiosity_scene::Fault>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct SensorPlane {
    name: String,
    origin: DVec3,
    edges: [DVec3; 2],
    counts: [usize; 2],
}

impl SensorPlane {
    /// The plane `name` from the corner `origin` along two `edges` (scene length), with cells at most
    /// `spacing` long along either edge.
    ///
    /// # Errors
    /// [`FaultKind::NotFinite`] or [`FaultKind::OutOfRange`] for a number, [`FaultKind::NoDirection`] for edges
    /// that span no plane, [`FaultKind::TooMany`] for more than 10⁷ cells.
    pub fn new(
        name: impl Into<String>,
        origin: DVec3,
        edges: [DVec3; 2],
        spacing: [f64; 2],
    ) -> Result<Self, Fault> {
        let coordinates = [origin, edges[0], edges[1]].into_iter().flat_map(|point| point.to_array());
        coordinates.into_iter().try_for_each(check_number)?;
        check_edges(edges)?;
        spacing.into_iter().try_for_each(check_spacing)?;
        Ok(Self { name: name.into(), origin, edges, counts: counts(edges, spacing)? })
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The corner from which the edges run (scene length).
    pub fn origin(&self) -> DVec3 {
        self.origin
    }

    /// The edges (scene length).
    pub fn edges(&self) -> [DVec3; 2] {
        self.edges
    }

    /// Cells along the first and the second edge, at least one each.
    pub fn counts(&self) -> [usize; 2] {
        self.counts
    }

    /// Unit normal of the plane, a × b, along which sensors receive.
    pub fn normal(&self) -> DVec3 {
        let [a, b] = self.edges.map(DVec3::normalize);
        a.cross(b).normalize()
    }

    /// Positions of the sensors (scene length), those along the second edge fastest.
    pub fn sensors(&self) -> impl Iterator<Item = DVec3> {
        let [n, m] = self.counts;
        let middle = |k: usize, count: usize| (k as f64 + 0.5) / count as f64;
        let at = move |i: usize, j: usize| {
            self.origin + middle(i, n) * self.edges[0] + middle(j, m) * self.edges[1]
        };
        (0..n).flat_map(move |i| (0..m).map(move |j| at(i, j)))
    }
}

fn check_edges(edges: [DVec3; 2]) -> Result<(), Fault> {
    let problem = match edges.map(DVec3::try_normalize) {
        [None, _] => "the first edge has no length",
        [_, None] => "the second edge has no length",
        [Some(a), Some(b)] if a.cross(b).length() < PARALLEL_DIRECTIONS => "the edges are parallel",
        _ => return Ok(()),
    };
    let cure = "give two edges, vectors along two sides of the plane, each with a length and not parallel to the other";
    Err(Fault::new(FaultKind::NoDirection, problem, cure))
}

fn check_spacing(value: f64) -> Result<(), Fault> {
    check_range(value, value > 0.0, "the spacing", "spacing > 0")
}

fn counts(edges: [DVec3; 2], spacing: [f64; 2]) -> Result<[usize; 2], Fault> {
    let cells = |k: usize| (edges[k].length() / spacing[k] - ROUNDING).ceil().max(1.0);
    let counts = [cells(0), cells(1)];
    let count = counts[0] * counts[1];
    if count <= MOST {
        return Ok(counts.map(|cells| cells as usize));
    }
    let least = (edges[0].length() / MOST.sqrt() * edges[1].length() / MOST.sqrt()).sqrt();
    let cause = format!("there are {count:.1e} sensors, more than 10⁷");
    let cure = format!("choose a larger spacing: {:.1e} for both edges makes few enough", 1.01 * least);
    Err(Fault::new(FaultKind::TooMany, cause, cure))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(edges: [DVec3; 2], spacing: [f64; 2]) -> Result<SensorPlane, Fault> {
        SensorPlane::new("desk", DVec3::new(1.0, 2.0, 3.0), edges, spacing)
    }

    #[test]
    fn sensors_stand_in_the_middles_of_cells_that_fill_the_plane() {
        let plane = plane([2.0 * DVec3::X, DVec3::Y], [0.75, 1.0]).unwrap();
        assert_eq!((plane.counts(), plane.normal()), ([3, 1], DVec3::Z));
        let sensors: Vec<DVec3> = plane.sensors().collect();
        for (k, x) in [1.0 + 1.0 / 3.0, 2.0, 3.0 - 1.0 / 3.0].into_iter().enumerate() {
            assert!((sensors[k] - DVec3::new(x, 2.5, 3.0)).length() < 1e-14, "{k}: {}", sensors[k]);
        }
    }

    #[test]
    fn rounding_adds_no_cell() {
        // 3 / 0.1 = 30.000000000000004 for a length of 0.1 + 0.2 in tenths.
        let plane = plane([(0.1 + 0.2) * DVec3::X, 3.0 * DVec3::Y], [0.1, 0.1]).unwrap();
        assert_eq!(plane.counts(), [3, 30]);
    }

    #[test]
    fn planes_that_cannot_be_are_refused() {
        let (x, y) = (DVec3::X, DVec3::Y);
        for (edges, spacing) in [
            ([x, -2.0 * x], [1.0, 1.0]),
            ([x, DVec3::ZERO], [1.0, 1.0]),
            ([x, f64::NAN * y], [1.0, 1.0]),
            ([x, 1e31 * y], [1.0, 1.0]),
            ([x, y], [1.0, 0.0]),
            ([x, y], [-1.0, 1.0]),
            ([x, y], [f64::NAN, 1.0]),
            ([x, y], [1e-4, 1e-4]),
            ([x, y], [1e-300, 1e-300]),
        ] {
            assert!(plane(edges, spacing).is_err(), "{edges:?} {spacing:?}");
        }
        let cure = plane([x, y], [1e-9, 1e-9]).unwrap_err().cure().expect("there is a cure");
        let least = cure.split(' ').find_map(|word| word.parse::<f64>().ok()).expect("it tells a spacing");
        assert!(plane([x, y], [least, least]).is_ok(), "the spacing that is told serves");
    }
}
