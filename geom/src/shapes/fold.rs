//! Sheets that turn back on themselves within their own plane: light from one layer to the other would be
//! undefined.
//!
//! A flat sheet has one normal ± n, and turns back exactly where the sign changes. A sheet that is not flat
//! may have a fold, like the lip of the teapot's spout: its two layers then lie apart.

use glam::DVec3;

use crate::tolerances::PARALLEL_DIRECTIONS;

/// Places per parameter at which normals are compared. An arbitrary choice: a fold between two places,
/// narrower than a sixteenth of the parameters, is not seen; more places take longer when a shape is made.
const PLACES: u32 = 15;

/// The places, inside [0, 1].
pub(super) fn places() -> impl Iterator<Item = f64> + Clone {
    (1..=PLACES).map(|k| f64::from(k) / f64::from(PLACES + 1))
}

/// Whether all `normals`, of any length, are parallel, and some opposite to others.
pub(super) fn turns_back(normals: &[DVec3]) -> bool {
    let longest = normals.iter().map(|n| n.length()).fold(0.0, f64::max);
    let clear = || normals.iter().filter(|n| n.length() > 1e-9 * longest).map(|n| n.normalize());
    let Some(first) = clear().next() else { return false };
    clear().all(|n| n.cross(first).length() < PARALLEL_DIRECTIONS) && clear().any(|n| n.dot(first) < 0.0)
}

#[cfg(test)]
mod tests {
    use super::super::{Bezier, Extrusion, FULL_TURN, Revolution};
    use crate::{DVec3, ShapeError, Surface};

    fn point(x: f64, y: f64, z: f64) -> DVec3 {
        DVec3::new(x, y, z)
    }

    fn back(field: &str) -> ShapeError {
        ShapeError::TurnsBack { field: field.into() }
    }

    #[test]
    fn flat_nets_that_turn_back_are_refused() {
        let net = |x: [f64; 4], lift: f64| {
            std::array::from_fn(|i| std::array::from_fn(|j| point(x[i], j as f64, lift * (i * i) as f64)))
        };
        assert!(Bezier::new(net([0.0, 1.0, 2.0, 3.0], 0.0)).is_ok());
        // x′ = 6 (1 − 5 s + 5 s²) is negative about s = ½.
        assert_eq!(Bezier::new(net([0.0, 2.0, -1.0, 1.0], 0.0)).unwrap_err(), back("points"));
        assert!(Bezier::new(net([0.0, 2.0, -1.0, 1.0], 0.1)).is_ok(), "its layers lie apart");
    }

    #[test]
    fn straight_curves_that_turn_back_are_refused() {
        let line = [0.0, 2.0, -1.0, 1.0].map(|x| point(x + 2.0, 0.0, x));
        assert_eq!(Extrusion::new(line, DVec3::Y).unwrap_err(), back("curve"));
        let cone = Revolution::new(line, DVec3::ZERO, DVec3::Z, FULL_TURN);
        assert_eq!(cone.unwrap_err(), back("curve"));
        let bent = [0.0, 2.0, -1.0, 1.0].map(|x| point(x, 0.0, 0.0));
        let bent = [0, 1, 2, 3].map(|k| bent[k] + (k * k) as f64 * DVec3::Z);
        assert!(Extrusion::new(bent, DVec3::Y).is_ok(), "its layers lie apart");
        let onward = [0.0, 0.1, 0.9, 1.0].map(|x| point(x, 0.0, x));
        assert!(
            Extrusion::new(onward, DVec3::Y).is_ok_and(|sheet| (sheet.area() - 2.0_f64.sqrt()).abs() < 1e-12)
        );
    }
}
