//! A block that follows a motion, expanded anew where its series ends.

use super::block::{BlockSeries, MovedBlock};
use super::error::SeriesError;
use super::pair::MovedPair;
use super::settings::Settings;

/// A block that follows a motion, expanded anew where its series ends.
#[derive(Clone, Debug)]
pub struct MovingBlock<'a> {
    pair: MovedPair<'a>,
    settings: Settings,
    series: Option<BlockSeries>,
    expansions: usize,
}

impl<'a> MovingBlock<'a> {
    /// Nothing is expanded yet.
    pub fn new(pair: MovedPair<'a>, settings: Settings) -> Self {
        Self { pair, settings, series: None, expansions: 0 }
    }

    /// The block at p: by the series if p is in its range, else by a new one about p.
    ///
    /// # Errors
    /// As for [`BlockSeries::new`].
    pub fn at(&mut self, p: f64) -> Result<MovedBlock, SeriesError> {
        let series = match self.series.take().filter(|series| series.range().contains(p)) {
            Some(series) => series,
            None => {
                self.expansions += 1;
                BlockSeries::new(&self.pair, p, self.settings)?
            }
        };
        self.series.insert(series).at(p)
    }

    /// Number of times that the block was expanded.
    pub fn expansions(&self) -> usize {
        self.expansions
    }
}
