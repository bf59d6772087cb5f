//! A few bands of light that walk together.

use std::ops::{Add, AddAssign, Mul};

/// Bands that one walk carries; scenes of more are walked several times.
pub(crate) const TOGETHER: usize = 4;

/// A number for each band that a walk carries, 0 in bands that are not there.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Spectrum(pub(crate) [f64; TOGETHER]);

impl Spectrum {
    /// The number in every band.
    pub(crate) fn even(value: f64) -> Self {
        Self([value; TOGETHER])
    }

    /// The numbers of the bands from `first` on.
    pub(crate) fn of(first: usize, values: &[f64]) -> Self {
        Self::from_fn(first, values.len(), |band| values[band])
    }

    /// The numbers of bands from `first` on, of so many bands in all.
    pub(crate) fn from_fn(first: usize, bands: usize, value: impl Fn(usize) -> f64) -> Self {
        Self(std::array::from_fn(|k| if first + k < bands { value(first + k) } else { 0.0 }))
    }

    /// The largest of its numbers.
    #[inline]
    pub(crate) fn largest(&self) -> f64 {
        self.0.into_iter().fold(0.0, f64::max)
    }

    /// Whether all its numbers are 0.
    pub(crate) fn is_dark(&self) -> bool {
        self.0 == [0.0; TOGETHER]
    }

    /// The sum of its numbers.
    pub(crate) fn sum(&self) -> f64 {
        self.0.iter().sum()
    }
}

impl Add for Spectrum {
    type Output = Self;

    #[inline]
    fn add(mut self, other: Self) -> Self {
        self += other;
        self
    }
}

impl AddAssign for Spectrum {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.0.iter_mut().zip(other.0).for_each(|(own, other)| *own += other);
    }
}

impl Mul for Spectrum {
    type Output = Self;

    #[inline]
    fn mul(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] * other.0[k]))
    }
}

impl Mul<Spectrum> for f64 {
    type Output = Spectrum;

    #[inline]
    fn mul(self, other: Spectrum) -> Spectrum {
        Spectrum(other.0.map(|value| self * value))
    }
}
