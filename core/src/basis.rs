//! Polynomial bases in two variables.

pub mod total;
