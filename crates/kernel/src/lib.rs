//! The kernel of radiosity integrated over pairs of elements: the hot loops.
//!
//! In order: `tolerances`, `irradiance` (closed forms at a point), `moments` (sums over pairs of points),
//! `contact` (how two patches meet), `estimates` (sizes of blocks before integration), `blocks` (the matrix),
//! `block_columns` (the matrix as light is shot), `rules` (quadrature for each kind of contact) and `terms`
//! (kernels that are sums of terms).
//!
//! Imports `core`, `geom`, `work`, `visibility` and `elements`.

pub mod tolerances;
pub mod irradiance;
pub mod moments;
pub mod contact;
pub mod estimates;
pub mod blocks;
pub mod block_columns;
pub mod rules;
pub mod terms;

pub use blocks::Blocks;
pub use blocks::block::Accuracy;
pub use blocks::block::PairKind;
pub use blocks::pair_counts::PairCounts;
pub use blocks::placed_block::PlacedBlock;
pub use blocks::remainder::Remainder;
pub use blocks::row_error::RowError;
pub use blocks::statistics::BlockStatistics;
pub use blocks::worst_error::WorstError;
pub use moments::integrand::kernel;
pub use rules::contour::polygon_exchange;
