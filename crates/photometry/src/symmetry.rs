//! Symmetries of photometric tables: which planes stand for which.

/// Planes that a table leaves out because they repeat others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// No planes: the table has all around.
    None,
    /// All planes but one.
    Axial,
    /// Planes from C180 to C360, which mirror those from C0 to C180.
    AboutC0,
    /// Planes from C90 to C270, which mirror those from C270 over C0 to C90 (EULUMDAT); or the latter, which
    /// mirror the former (LM-63).
    AboutC90,
    /// All but the planes from C0 to C90.
    Quadrant,
}

impl Symmetry {
    /// All planes that have the intensities of the plane at `c`, in degrees.
    fn images(self, c: f64) -> Vec<f64> {
        match self {
            Symmetry::None | Symmetry::Axial => vec![c],
            Symmetry::AboutC0 => vec![c, -c],
            Symmetry::AboutC90 => vec![c, 180.0 - c],
            Symmetry::Quadrant => vec![c, 180.0 - c, 180.0 + c, -c],
        }
    }

    /// Planes all around for the `stated` ones: angles in [0°, 360°), which increase, and for each the index
    /// of the stated plane that it repeats.
    pub(super) fn expand(self, stated: &[f64]) -> (Vec<f64>, Vec<usize>) {
        let images = |(row, c): (usize, &f64)| {
            self.images(*c).into_iter().map(move |image| (image.rem_euclid(360.0), row))
        };
        let mut planes: Vec<(f64, usize)> = stated.iter().enumerate().flat_map(images).collect();
        // Of planes that meet, the one stated first stays.
        planes.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        planes.dedup_by_key(|(c, _)| *c);
        planes.into_iter().unzip()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_are_repeated_around_the_axis() {
        let around = |symmetry: Symmetry, stated: &[f64]| symmetry.expand(stated);
        assert_eq!(around(Symmetry::Axial, &[0.0]), (vec![0.0], vec![0]));
        assert_eq!(
            around(Symmetry::Quadrant, &[0.0, 30.0, 90.0]),
            (vec![0.0, 30.0, 90.0, 150.0, 180.0, 210.0, 270.0, 330.0], vec![0, 1, 2, 1, 0, 1, 2, 1])
        );
        assert_eq!(
            around(Symmetry::AboutC0, &[0.0, 60.0, 180.0]),
            (vec![0.0, 60.0, 180.0, 300.0], vec![0, 1, 2, 1])
        );
        assert_eq!(
            around(Symmetry::AboutC90, &[90.0, 180.0, 250.0, 270.0]),
            (vec![0.0, 90.0, 180.0, 250.0, 270.0, 290.0], vec![1, 0, 1, 2, 3, 2])
        );
        assert_eq!(around(Symmetry::None, &[0.0, 90.0, 360.0]), (vec![0.0, 90.0], vec![0, 1]));
    }
}
