//! `--from`, `--one-sided` and the other options on how files of other programs are read.

use std::path::PathBuf;

use clap::{
    Args,
    builder::{PossibleValuesParser, TypedValueParser},
};
use radiosity_formats::{format::Format, model::Sides, unit::Unit, up::Up};
use radiosity_request::ImportRequest;

/// Heading of the options. It stands at each of them: a heading for what follows would reach the options of
/// the verb too.
const HEADING: &str = "Scenes of other programs";

/// How a scene of another program is read.
#[derive(Clone, Debug, Default, Args)]
pub(crate) struct ImportArgs {
    /// Format of the scene [default: that of the ending of its name]
    #[arg(long, help_heading = HEADING, value_name = "FORMAT", value_parser = format())]
    from: Option<Format>,

    /// Only fronts reflect and emit, whatever the file says
    #[arg(long, help_heading = HEADING, conflicts_with = "two_sided")]
    one_sided: bool,

    /// Fronts and backs reflect and emit, whatever the file says
    #[arg(long, help_heading = HEADING)]
    two_sided: bool,

    /// Materials by name, of the scene and of its surfaces: [materials.NAME] with reflectance and emission,
    /// and [surfaces] with "lamp*" = "NAME"
    #[arg(long, help_heading = HEADING, value_name = "FILE.toml")]
    materials: Option<PathBuf>,

    /// Unit of the lengths in the file, which become metres: mm, cm, dm, m, in, ft or yd
    #[arg(long, help_heading = HEADING, value_name = "UNIT")]
    unit: Option<Unit>,

    /// Axis that points upwards in the file, y or z; z will [default: y in glTF, else z]
    #[arg(long, help_heading = HEADING, value_name = "AXIS")]
    up: Option<Up>,

    /// Turns fronts that seem to point the wrong way; else they are only told
    #[arg(long, help_heading = HEADING)]
    fix_fronts: bool,

    /// Red, green and blue become one band of their luminance
    #[arg(long, help_heading = HEADING)]
    grey: bool,
}

impl ImportArgs {
    /// The request for reading a scene of another program.
    pub(crate) fn request(&self) -> ImportRequest {
        let sides = match (self.one_sided, self.two_sided) {
            (true, _) => Some(Sides::Front),
            (_, true) => Some(Sides::Both),
            _ => None,
        };
        ImportRequest {
            format: self.from,
            sides,
            materials: self.materials.clone(),
            unit: self.unit,
            up: self.up,
            fix_fronts: self.fix_fronts,
            grey: self.grey,
        }
    }
}

/// The formats, by name.
fn format() -> impl TypedValueParser<Value = Format> {
    let named = |name: String| {
        Format::ALL.into_iter().find(|format| format.name() == name).ok_or("no format of this name")
    };
    PossibleValuesParser::new(Format::ALL.map(Format::name)).try_map(named)
}
