//! Visibility by scan lines: what of lines across a cell blockers hide.

pub(crate) mod projection;
pub(crate) mod silhouette;
pub(crate) mod hidden_spans;
pub(crate) mod line_quadrature;
