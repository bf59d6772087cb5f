//! Options of `--shadows mask`.

use std::num::NonZeroUsize;

use clap::Args;
use radiosity_published::zatz1993::masked_light::{Average, Masking};
use radiosity_request::ranges::MASK_CELLS;

/// How masks are made.
#[derive(Debug, Args)]
pub(crate) struct MaskArgs {
    /// Cells of a shadow mask along each side, with --shadows mask
    #[arg(long, value_name = "M", default_value = "40", value_parser = cells)]
    pub(crate) mask_cells: NonZeroUsize,

    /// Values of a mask
    #[arg(long, value_name = "MODE", default_value = "weighted")]
    pub(crate) mask_average: Average,
}

impl MaskArgs {
    /// The masking of the library with these options.
    pub(crate) fn masking(&self) -> Masking {
        Masking { cells: self.mask_cells, average: self.mask_average }
    }
}

fn cells(text: &str) -> Result<NonZeroUsize, String> {
    let number = text.parse::<usize>().ok().filter(|number| MASK_CELLS.contains(&(*number as u64)));
    let expected = || format!("expected a number from {} to {}", MASK_CELLS.start(), MASK_CELLS.end());
    number.and_then(NonZeroUsize::new).ok_or_else(expected)
}
