//! Numbers of materials and surfaces that bands may share.

use crate::scene::{
    error::Located,
    fields::number,
    place::{At, Span},
    tree::Node,
};

/// One number for all bands, or a list with one per band.
#[derive(Debug)]
pub(in crate::scene) enum PerBand {
    All(At<f64>),
    Each(At<Vec<At<f64>>>),
}

impl PerBand {
    /// Where it stands.
    pub(in crate::scene) fn span(&self) -> &Span {
        match self {
            PerBand::All(number) => &number.span,
            PerBand::Each(list) => &list.span,
        }
    }

    /// Whether it is a single number.
    pub(in crate::scene) fn is_one_number(&self) -> bool {
        matches!(self, PerBand::All(_))
    }
}

/// Reads either.
pub(in crate::scene) fn per_band(node: &Node) -> Result<PerBand, Located> {
    match node.items() {
        Some(items) => {
            let values = items.iter().map(number).collect::<Result<_, _>>()?;
            Ok(PerBand::Each(At::new(values, &node.span)))
        }
        None => Ok(PerBand::All(number(node)?)),
    }
}
