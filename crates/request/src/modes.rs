//! Modes that options may be set to by name, and their translation to options of the library.

use std::str::FromStr;

use radiosity_published::zatz1993::transfers::{HybridReading, PaperRules};
use radiosity_scene::MAX_ORDER;
use radiosity_visibility::Hiding;
use serde::Deserialize;

/// Degree of the polynomials on elements, as `--order` states it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The degree that the wanted accuracy needs.
    Auto,
    /// This degree; with `--accuracy`, the least degree.
    Degree(usize),
}

impl FromStr for Order {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let degree = || text.parse().ok().filter(|degree| *degree <= MAX_ORDER).map(Order::Degree);
        let order = if text == "auto" { Some(Order::Auto) } else { degree() };
        order.ok_or_else(|| format!("expected a whole number from 0 to {MAX_ORDER}, or auto"))
    }
}

/// `--shadows`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Shadows {
    /// Planar surfaces behind planar ones by their outlines, all else by rays
    #[default]
    Auto,
    /// Nothing hides anything
    Off,
    /// Rays where something can stand between
    Rays,
    /// As auto, but to the accuracy --eps
    Exact,
    /// Rays, and direct light as polynomials times shadow masks, as in Zatz 1993; --read basis shows them
    Mask,
}

impl Shadows {
    /// The library's mode of shadows.
    pub(crate) fn hiding(self) -> Hiding {
        match self {
            Shadows::Auto | Shadows::Mask => Hiding::Auto,
            Shadows::Off => Hiding::Off,
            Shadows::Rays => Hiding::Rays,
            Shadows::Exact => Hiding::Exact,
        }
    }
}

/// `--kernel`. The paper's rules take N + 2 points a direction, which fits the numbers it prints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Kernel {
    /// As accurate as --eps says
    #[default]
    Default,
    /// Zatz 1993: N + 2 Gauss-Legendre points a direction for every pair
    PaperLegendre,
    /// Zatz 1993: the same, with Gauss-Jacobi points on the receiver where two surfaces share an edge
    PaperHybrid,
}

impl Kernel {
    /// The rules of 1993 that the mode names. Of the readings of the hybrid, H1 fits the numbers the paper
    /// prints best.
    pub fn rules(self) -> Option<PaperRules> {
        match self {
            Kernel::Default => None,
            Kernel::PaperLegendre => Some(PaperRules::Legendre),
            Kernel::PaperHybrid => Some(PaperRules::Hybrid(HybridReading::H1)),
        }
    }
}
