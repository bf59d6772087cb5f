//! The error of light that is interpolated in time.

use std::fmt;

use radiosity_work::digits::significant;

/// Squares of differences between light that was interpolated and the same, gathered, at some spots; and counts.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FilmError {
    /// Spots that were gathered, and spots that were interpolated.
    spots: [usize; 2],
    /// Sum of the squares of differences, and of all light there.
    squares: [f64; 2],
}

impl FilmError {
    /// Takes note of spots that were `gathered` and others that were `interpolated`.
    pub(super) fn count(&mut self, gathered: usize, interpolated: usize) {
        self.spots[0] += gathered;
        self.spots[1] += interpolated;
    }

    /// Number of spots that were interpolated.
    pub(super) fn interpolated(&self) -> usize {
        self.spots[1]
    }

    /// Takes note of a difference at a spot with so much light in all (W m⁻²).
    pub(super) fn take(&mut self, difference: f64, all: f64) {
        self.squares[0] += difference * difference;
        self.squares[1] += all * all;
    }

    /// Takes all that another one took note of.
    pub(super) fn add(&mut self, other: &Self) {
        let pairs = self.spots.iter_mut().zip(other.spots);
        pairs.for_each(|(sum, more)| *sum += more);
        let pairs = self.squares.iter_mut().zip(other.squares);
        pairs.for_each(|(sum, more)| *sum += more);
    }

    /// Relative error of all light where its reflected part is interpolated, L2; that of gathered light itself counts
    /// too. None where nothing was.
    pub fn told(&self) -> Option<f64> {
        let [differences, all] = self.squares;
        (all > 0.0).then(|| (differences / all).sqrt())
    }
}

/// A line of a summary; nothing where no light was interpolated.
impl fmt::Display for FilmError {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let [gathered, interpolated] = self.spots;
        let Some(error) = self.told() else { return Ok(()) };
        let part = 100.0 * interpolated as f64 / (gathered + interpolated) as f64;
        let percent = significant(100.0 * error, 2);
        write!(
            to,
            "reflected light of pictures: {gathered} places gathered, {part:.0} % interpolated between frames to \
             {percent} %"
        )
    }
}
