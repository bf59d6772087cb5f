//! Numbers of materials and surfaces that bands may share.

use radiosity_scene::{
    error::Located,
    place::{At, Span},
    tree::Node,
};

use crate::{fields::number, keys::ValueKind, terms};

/// One number for all bands, or a list with one per band.
#[derive(Debug)]
pub(crate) enum PerBand {
    All(At<f64>),
    Each(At<Vec<At<f64>>>),
}

/// Numbers from 0 on.
pub(crate) const AMOUNTS: ValueKind<PerBand> =
    ValueKind::new(per_band, || terms::per_band(terms::at_least_zero(), ""));

impl PerBand {
    /// Span of the number or of the list.
    pub(crate) fn span(&self) -> &Span {
        match self {
            PerBand::All(number) => &number.span,
            PerBand::Each(list) => &list.span,
        }
    }

    /// Whether a single number stands for all bands.
    pub(crate) fn is_one_number(&self) -> bool {
        matches!(self, PerBand::All(_))
    }
}

/// Reads a number, or a list of numbers with one per band.
pub(crate) fn per_band(node: &Node) -> Result<PerBand, Located> {
    match node.items() {
        Some(items) => {
            let values = items.iter().map(number).collect::<Result<_, _>>()?;
            Ok(PerBand::Each(At::new(values, &node.span)))
        }
        None => Ok(PerBand::All(number(node)?)),
    }
}
