//! Norm of an error of moments, as an error of the block's entries:
//!
//! ```text
//! G = T_i M T_jᵀ ,     |δM_ab| counts as max_k |T_ka| max_l |T_lb| |δM_ab| ,     G_00 = T_00 M_00 T_00
//! ```
//!
//! Where the area element is constant T is diagonal, and this is the exact change of an entry. Elsewhere an
//! entry is a sum over several moments, of which the largest counts.

use radiosity_elements::basis::AreaBasis;

/// The norm of moments between two elements.
#[derive(Debug)]
pub struct EntryNorm {
    /// Largest factors max_k |T_ka| of either basis.
    factors: [Vec<f64>; 2],
    /// T_00 T_00.
    first: f64,
}

impl EntryNorm {
    /// For moments with rows in the polynomials of the first basis, columns in those of the second.
    pub fn of(bases: [&AreaBasis; 2]) -> Self {
        let first = bases.map(|basis| basis.transform()[0]).iter().product();
        Self { factors: bases.map(factors), first }
    }

    /// The block's first entry per unit of the first moment.
    pub fn first(&self) -> f64 {
        self.first
    }

    /// The first entry of the block with these moments.
    pub fn first_entry(&self, moments: &[f64]) -> f64 {
        self.first * moments[0]
    }

    /// The norm of moments.
    pub fn largest(&self, a: &[f64]) -> f64 {
        self.difference(a, &vec![0.0; a.len()])
    }

    /// The norm of the difference of two sets of moments.
    pub fn difference(&self, a: &[f64], b: &[f64]) -> f64 {
        let [rows, columns] = &self.factors;
        let pairs = a.chunks_exact(columns.len()).zip(b.chunks_exact(columns.len()));
        let row = |(a, b): (&[f64], &[f64])| {
            let terms = a.iter().zip(b).zip(columns).map(|((a, b), factor)| factor * (a - b).abs());
            terms.fold(0.0, f64::max)
        };
        rows.iter().zip(pairs).map(|(factor, pair)| factor * row(pair)).fold(0.0, f64::max)
    }
}

/// max_k |T_ka| for each raw polynomial.
fn factors(basis: &AreaBasis) -> Vec<f64> {
    let mut largest = vec![0.0f64; basis.len()];
    for row in basis.transform().chunks_exact(basis.len()) {
        largest.iter_mut().zip(row).for_each(|(most, t)| *most = most.max(t.abs()));
    }
    largest
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use radiosity_elements::basis::Frame;
    use radiosity_elements::patch::Patch;
    use radiosity_geom::{DVec2, DVec3, Rect};

    use super::*;

    /// On a square of side 3 the orthonormal polynomials are the raw ones times 2/3.
    #[test]
    fn factors_of_a_square_are_two_over_the_root_of_its_area() {
        let square = radiosity_geom::shapes::Parallelogram::new(DVec3::ZERO, 3.0 * DVec3::X, 3.0 * DVec3::Y);
        let patch = Patch::curved(Arc::new(square.expect("a square")), &Rect::FULL);
        let frame = Frame::Parameters { center: DVec2::ZERO, half: DVec2::ONE };
        let basis = AreaBasis::new(2, frame, &[patch]).expect("it has area");
        let norm = EntryNorm::of([&basis, &basis]);
        let (mut a, b) = (vec![0.0; 36], vec![0.0; 36]);
        a[7] = 0.9;
        assert!((norm.difference(&a, &b) - 0.4).abs() < 1e-12);
        a[0] = 1.8;
        assert!((norm.first_entry(&a) - 0.8).abs() < 1e-12);
    }
}
