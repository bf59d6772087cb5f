//! Elements as trees of cells.

mod border;
pub(crate) mod moments;
pub(crate) mod cell;
pub(crate) mod tree;
