//! Codings: from the numbers of a file to linear light.

use crate::colour;

/// Relation of the numbers of a PNG to light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coding {
    /// Numbers are proportional to light.
    Linear,
    /// Numbers follow the curve of sRGB (IEC 61966-2-1).
    Srgb,
}

/// A curve from a number of a file, 0 to 1, to light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Curve {
    Of(Coding),
    /// x^(1/γ), γ that of a `gAMA` chunk (PNG, third edition, section 11.3.2.2).
    Power(f64),
}

/// γ of sRGB pictures as programs write it: 1/2.2 in five decimals (PNG, section 11.3.2.5).
const OF_SRGB: f64 = 0.45455;

impl Curve {
    /// The curve of a `gAMA` chunk.
    pub(super) fn of_gamma(gamma: f64) -> Self {
        match gamma {
            1.0 => Curve::Of(Coding::Linear),
            _ if (gamma - OF_SRGB).abs() < 1e-5 => Curve::Of(Coding::Srgb),
            _ => Curve::Power(gamma),
        }
    }

    /// Light of a number.
    pub(super) fn light(self, coded: f64) -> f64 {
        match self {
            Curve::Of(Coding::Linear) => coded,
            Curve::Of(Coding::Srgb) => colour::of_srgb(coded),
            Curve::Power(gamma) => coded.powf(1.0 / gamma),
        }
    }

    /// Remark on the curve, for people.
    pub(super) fn title(self) -> String {
        match self {
            Curve::Of(Coding::Linear) => "linear".to_owned(),
            Curve::Of(Coding::Srgb) => "sRGB made linear".to_owned(),
            Curve::Power(gamma) => format!("made linear by its gamma of {gamma}"),
        }
    }
}
