//! Runs that are drawn and compared as one.

use crate::record::Record;

/// A kind of runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Family {
    /// Constant elements: classical radiosity.
    Constant,
    /// Orders from the first to the last.
    Orders(usize, usize),
    /// Elements by the rules of 1993, without care for edges.
    Legendre,
    /// Elements by the rules of 1993, with the hybrid at edges.
    Hybrid,
    /// Light gathered anew, any order.
    Gathered,
}

impl Family {
    /// The families of the diagram.
    pub(crate) const ALL: [Self; 8] = [
        Self::Constant,
        Self::Legendre,
        Self::Hybrid,
        Self::Orders(1, 1),
        Self::Orders(2, 3),
        Self::Orders(4, 5),
        Self::Orders(6, 10),
        Self::Gathered,
    ];

    /// Name of the family in the diagram.
    pub(crate) fn label(self) -> String {
        match self {
            Self::Constant => "constant elements".to_owned(),
            Self::Orders(low, high) if low == high => format!("order {low}"),
            Self::Orders(low, high) => format!("orders {low} to {high}"),
            Self::Legendre => "1993, Legendre".to_owned(),
            Self::Hybrid => "1993, hybrid at edges".to_owned(),
            Self::Gathered => "light gathered anew".to_owned(),
        }
    }

    /// Whether a run belongs to it.
    pub(crate) fn holds(self, record: &Record) -> bool {
        let ours = record.kernel == "default";
        match self {
            Self::Constant => ours && record.order == 0,
            Self::Orders(low, high) => ours && (low..=high).contains(&record.order),
            Self::Legendre => record.kernel == "paper-legendre",
            Self::Hybrid => record.kernel == "paper-hybrid",
            Self::Gathered => record.kernel == "gathered",
        }
    }
}
