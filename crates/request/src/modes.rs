//! Modes that options may be set to by name, and their translation to options of the library.

use radiosity_formats::format::Format;
use radiosity_published::zatz1993::transfers::{HybridReading, PaperRules};
use radiosity_solvers::method::Method;
use radiosity_visibility::Shadows;
use serde::de::{Error, IntoDeserializer, value};
use serde::{Deserialize, Deserializer};

use super::ranges::parsed;

/// `--shadows` of light: a way to find shadows, or masks, with which they are found as by default.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LightShadows {
    /// Shadows found in this way.
    Found(Shadows),
    /// Direct light as polynomials times shadow masks.
    Mask,
}

impl LightShadows {
    /// The way to find shadows.
    pub(crate) fn found(self) -> Shadows {
        match self {
            Self::Found(shadows) => shadows,
            Self::Mask => Shadows::default(),
        }
    }
}

impl<'de> Deserialize<'de> for LightShadows {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        match String::deserialize(from)?.as_str() {
            "mask" => Ok(Self::Mask),
            name => Shadows::deserialize(name.into_deserializer())
                .map(Self::Found)
                .map_err(|fault: value::Error| D::Error::custom(format!("{fault}, `mask`"))),
        }
    }
}

#[cfg(feature = "clap")]
impl clap::ValueEnum for LightShadows {
    fn value_variants<'a>() -> &'a [Self] {
        const {
            &[
                Self::Found(Shadows::Auto),
                Self::Found(Shadows::Off),
                Self::Found(Shadows::Rays),
                Self::Found(Shadows::Exact),
                Self::Mask,
            ]
        }
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        let mask = "As auto, and direct light as polynomials times shadow masks, as in Zatz 1993, of the pairs that the scene lists as [[masks]] or else of all that need them; --read basis shows them";
        match self {
            Self::Found(shadows) => shadows.to_possible_value(),
            Self::Mask => Some(clap::builder::PossibleValue::new("mask").help(mask)),
        }
    }
}

/// `--kernel`. The paper's rules take as many points a direction as fit the numbers it prints.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[cfg_attr(feature = "clap", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Kernel {
    /// As accurate as --eps says
    #[default]
    Default,
    /// Zatz 1993: N + 2 Gauss-Legendre points a direction for every pair
    PaperLegendre,
    /// Zatz 1993: the same, with Gauss-Jacobi points on the receiver where two surfaces share an edge, or are
    /// cut to share one; of the readings of eq. 27 the nearest to the paper's numbers (H1)
    PaperHybrid,
    /// The reading nearest to the paper's text (H2): N + 3 points, Gauss-Jacobi on the emitter too
    PaperHybridH2,
    /// A third reading (H3): as the first, weighted across the edge only
    PaperHybridH3,
    /// Eq. 27 as printed, which is wrong however many points: for comparison
    PaperPrinted,
}

impl Kernel {
    /// The rules of 1993 that the mode names.
    pub fn rules(self) -> Option<PaperRules> {
        match self {
            Kernel::Default => None,
            Kernel::PaperLegendre => Some(PaperRules::Legendre),
            Kernel::PaperHybrid => Some(PaperRules::Hybrid(HybridReading::H1)),
            Kernel::PaperHybridH2 => Some(PaperRules::Hybrid(HybridReading::H2)),
            Kernel::PaperHybridH3 => Some(PaperRules::Hybrid(HybridReading::H3)),
            Kernel::PaperPrinted => Some(PaperRules::Hybrid(HybridReading::Literal)),
        }
    }
}

/// The solver of a name.
pub(super) fn solver<'de, D: Deserializer<'de>>(from: D) -> Result<Option<&'static Method>, D::Error> {
    parsed(from, Method::named)
}

/// The format of scenes of other programs of a name.
pub(super) fn format<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Format>, D::Error> {
    parsed(from, format_named)
}

fn format_named(name: &str) -> Result<Format, String> {
    let expected = || format!("expected one of {}", Format::ALL.map(Format::name).join(", "));
    Format::ALL.into_iter().find(|format| format.name() == name).ok_or_else(expected)
}

/// The formats by their names.
#[cfg(feature = "clap")]
pub(super) fn formats() -> impl clap::builder::TypedValueParser<Value = Format> {
    use clap::builder::{PossibleValuesParser, TypedValueParser};

    PossibleValuesParser::new(Format::ALL.map(Format::name)).try_map(|name| format_named(&name))
}

/// The solvers by their names, with what they do.
#[cfg(feature = "clap")]
pub(super) fn solvers() -> impl clap::builder::TypedValueParser<Value = &'static Method> {
    use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

    let summary = |method: &Method| {
        PossibleValue::new(method.name).aliases(method.aliases).help(method.summary_with_aliases())
    };
    PossibleValuesParser::new(Method::ALL.iter().map(summary))
        .map(|name| Method::named(&name).expect("the parser lets only listed names pass"))
}
