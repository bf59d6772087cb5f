//! Unknowns of the systems of a scene, from which those of a similar one start.

/// Unknowns of the systems of all bands, in each band those of each emission; of no band where none are known.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Unknowns(Vec<Vec<Vec<f64>>>);

impl Unknowns {
    /// The unknowns of each emission, band by band.
    pub(crate) fn of(bands: Vec<Vec<Vec<f64>>>) -> Self {
        Self(bands)
    }

    /// The unknowns of each emission in a band.
    pub(super) fn band(&self, band: usize) -> Option<&[Vec<f64>]> {
        self.0.get(band).map(Vec::as_slice)
    }

    /// 2 y − x for these y and the unknowns x `before` them; None where those have other sizes.
    pub(crate) fn extrapolated(&self, before: &Self) -> Option<Self> {
        let are_alike = self.0.len() == before.0.len()
            && self.0.iter().zip(&before.0).all(|(own, other)| has_sizes_of(own, other));
        let next = |(y, x): (&Vec<f64>, &Vec<f64>)| y.iter().zip(x).map(|(y, x)| 2.0 * y - x).collect();
        let bands = self.0.iter().zip(&before.0);
        are_alike.then(|| Self(bands.map(|(y, x)| y.iter().zip(x).map(next).collect()).collect()))
    }
}

/// Whether there are as many vectors in both, of the same sizes.
pub(super) fn has_sizes_of(own: &[Vec<f64>], other: &[Vec<f64>]) -> bool {
    own.len() == other.len() && own.iter().zip(other).all(|(own, other)| own.len() == other.len())
}
