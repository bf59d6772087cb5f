//! Options of `--shadows mask`.

use std::num::NonZeroUsize;

use clap::{Args, ValueEnum};
use radiosity::zatz1993::masked_light::{Average, Masking};

/// How masks are made.
#[derive(Debug, Args)]
pub(crate) struct MaskArgs {
    /// Cells of a shadow mask along each side, with --shadows mask
    #[arg(long, value_name = "M", default_value = "40", value_parser = cells)]
    pub(crate) mask_cells: NonZeroUsize,

    /// What a mask tells
    #[arg(long, value_name = "MODE", default_value = "weighted")]
    pub(crate) mask_average: MaskAverage,
}

/// `--mask-average`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum MaskAverage {
    /// The part of the emitter's light that arrives
    Weighted,
    /// The part of the emitter's area that is seen, as in Zatz 1993
    Plain,
}

impl MaskArgs {
    /// As the library has it.
    pub(crate) fn masking(&self) -> Masking {
        Masking {
            cells: self.mask_cells,
            average: match self.mask_average {
                MaskAverage::Weighted => Average::Weighted,
                MaskAverage::Plain => Average::Plain,
            },
        }
    }
}

fn cells(text: &str) -> Result<NonZeroUsize, String> {
    const MOST: usize = 1000;
    let number = text.parse::<usize>().ok().filter(|number| *number <= MOST);
    number.and_then(NonZeroUsize::new).ok_or_else(|| format!("expected a number from 1 to {MOST}"))
}
