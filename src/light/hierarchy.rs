//! Elements as trees of cells.

pub(crate) mod cell;
pub(crate) mod tree;
