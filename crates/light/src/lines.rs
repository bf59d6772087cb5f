//! Visibility by scan lines: which parts of lines across a cell are hidden by blockers.

pub(crate) mod projection;
pub(crate) mod silhouette;
pub(crate) mod hidden_spans;
pub(crate) mod line_quadrature;
