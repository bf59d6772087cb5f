//! Planes of EULUMDAT: which of all have intensities, by the symmetry `Isym`.

use crate::error::{Refusal, refuse};
use crate::symmetry::Symmetry;
use crate::text::told;

/// The planes that have intensities, in the order of the table.
#[derive(Debug, PartialEq)]
pub(super) struct Stated {
    pub(super) symmetry: Symmetry,
    /// Angles C, which increase; those before C0 are negative.
    pub(super) planes: Vec<f64>,
}

/// The planes that have intensities by the symmetry `isym`, among `all` planes, at increasing angles C from
/// 0° on.
///
/// # Errors
/// Angles outside [0°, 360°), or without the planes where a symmetry ends.
pub(super) fn stated(isym: usize, all: &[f64]) -> Result<Stated, Refusal> {
    let last = all[all.len() - 1];
    if all[0] != 0.0 || last > 360.0 {
        return refuse(
            format!("the angles C run from {} to {}", told(all[0]), told(last)),
            "let them begin at 0 and end before 360",
        );
    }
    let upto = |end: f64| -> Vec<f64> { all.iter().copied().filter(|c| *c <= end).collect() };
    let (symmetry, ends, planes) = match isym {
        0 => (Symmetry::None, &[][..], all.to_vec()),
        1 => (Symmetry::Axial, &[][..], vec![0.0]),
        2 => (Symmetry::AboutC0, &[180.0][..], upto(180.0)),
        3 => {
            let before = all.iter().filter(|c| (270.0..360.0).contains(*c)).map(|c| c - 360.0);
            (Symmetry::AboutC90, &[90.0, 270.0][..], before.chain(upto(90.0)).collect())
        }
        _ => (Symmetry::Quadrant, &[90.0][..], upto(90.0)),
    };
    match ends.iter().find(|end| !all.contains(end)) {
        None => Ok(Stated { symmetry, planes }),
        Some(end) => refuse(
            format!(
                "the symmetry Isym = {isym} ends at C = {end}, which is none of the {} angles",
                all.len()
            ),
            "list the angles of all planes from 0 to 360, or correct Isym and Mc",
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn symmetries_choose_planes() {
        let all: Vec<f64> = (0..8).map(|index| 45.0 * f64::from(index)).collect();
        let planes = |isym: usize| stated(isym, &all).map(|stated| stated.planes);
        assert_eq!(planes(0), Ok(all.clone()));
        assert_eq!(planes(1), Ok(vec![0.0]));
        assert_eq!(planes(2), Ok(vec![0.0, 45.0, 90.0, 135.0, 180.0]));
        assert_eq!(planes(3), Ok(vec![-90.0, -45.0, 0.0, 45.0, 90.0]));
        assert_eq!(planes(4), Ok(vec![0.0, 45.0, 90.0]));
        assert!(stated(4, &[0.0, 60.0, 120.0]).is_err());
        assert!(stated(3, &all[..5]).is_err());
    }
}
