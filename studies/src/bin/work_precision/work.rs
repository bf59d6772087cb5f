//! Measures of work.

use crate::record::Record;

/// A measure of work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    /// CPU time (s).
    Seconds,
    /// Terms of the kernel's quadrature rules.
    Samples,
    /// Coefficients per band.
    Unknowns,
}

impl Work {
    /// All measures, each with the diagram that has it as abscissa.
    pub(crate) const ALL: [(Self, &str); 3] = [
        (Self::Seconds, "docs/work-precision.svg"),
        (Self::Samples, "docs/work-precision-samples.svg"),
        (Self::Unknowns, "docs/work-precision-unknowns.svg"),
    ];

    /// Work of a run in this measure.
    pub(crate) fn of(self, record: &Record) -> f64 {
        match self {
            Self::Seconds => record.seconds,
            Self::Samples => record.samples as f64,
            Self::Unknowns => record.unknowns as f64,
        }
    }

    /// Name of an axis.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Seconds => "CPU time, s",
            Self::Samples => "kernel samples",
            Self::Unknowns => "unknowns",
        }
    }
}
