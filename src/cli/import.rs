//! `--from`, `--one-sided` and the other options on how files of other programs are read.

use std::path::{Path, PathBuf};

use clap::{
    Args,
    builder::{PossibleValuesParser, TypedValueParser},
};
use radiosity::formats::{format::Format, materials::SideFile, model::Sides, unit::Unit, up::Up};
use radiosity::scene::{Import, input};

use crate::cli::error::CliError;

/// How a scene of another program is read.
#[derive(Clone, Debug, Default, Args)]
#[command(next_help_heading = "Scenes of other programs")]
pub(crate) struct ImportArgs {
    /// Format of the scene [default: that of the ending of its name]
    #[arg(long, value_name = "FORMAT", value_parser = format())]
    from: Option<Format>,

    /// Only fronts reflect and emit, whatever the file says
    #[arg(long, conflicts_with = "two_sided")]
    one_sided: bool,

    /// Fronts and backs reflect and emit, whatever the file says
    #[arg(long)]
    two_sided: bool,

    /// Materials by name, of the scene and of its surfaces: [materials.NAME] with reflectance and emission, and [surfaces]
    /// with "lamp*" = "NAME"
    #[arg(long, value_name = "FILE.toml")]
    materials: Option<PathBuf>,

    /// Unit of the lengths in the file, which become metres: mm, cm, dm, m, in, ft or yd
    #[arg(long, value_name = "UNIT")]
    unit: Option<Unit>,

    /// Axis that points upwards in the file, y or z; z will [default: y in glTF, else z]
    #[arg(long, value_name = "AXIS")]
    up: Option<Up>,

    /// Turns fronts that seem to point the wrong way; else they are only told
    #[arg(long)]
    fix_fronts: bool,

    /// Red, green and blue become one band of their luminance
    #[arg(long)]
    grey: bool,
}

impl ImportArgs {
    /// The first option that was typed.
    fn first(&self) -> Option<&'static str> {
        let typed = [
            (self.from.is_some(), "--from"),
            (self.one_sided, "--one-sided"),
            (self.two_sided, "--two-sided"),
            (self.materials.is_some(), "--materials"),
            (self.unit.is_some(), "--unit"),
            (self.up.is_some(), "--up"),
            (self.fix_fronts, "--fix-fronts"),
            (self.grey, "--grey"),
        ];
        typed.into_iter().find_map(|(is_typed, name)| is_typed.then_some(name))
    }

    /// The options for the scene `file`; `strict` refuses one that needs repairs.
    ///
    /// # Errors
    /// Options for a scene that is not of another program; a file of materials that cannot be read.
    pub(crate) fn import(
        &self,
        file: &str,
        strict: bool,
        tolerance: Option<f64>,
    ) -> Result<Import, CliError> {
        let sides = match (self.one_sided, self.two_sided) {
            (true, _) => Some(Sides::Front),
            (_, true) => Some(Sides::Both),
            _ => None,
        };
        let import = Import {
            format: self.from,
            sides,
            materials: self.materials.as_deref().map(side_file).transpose()?,
            unit: self.unit,
            up: self.up,
            tolerance,
            strict,
            fix_fronts: self.fix_fronts,
            grey: self.grey,
        };
        match self.first().filter(|_| import.format_of(file).is_none()) {
            None => Ok(import),
            Some(option) => Err(CliError::Refused {
                message: format!("{option}: {file} is not known for a scene of another program"),
                cure: "name its format with --from, or leave the option out: a scene of radiosity says this itself".to_owned(),
            }),
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

fn side_file(path: &Path) -> Result<SideFile, CliError> {
    let name = path.display().to_string();
    // A file called `-` is one, too: standard input is for the scene.
    let source = if name == "-" { "./-" } else { &name };
    match input::text(source) {
        Ok(text) => Ok(SideFile { name, text }),
        Err(error) => Err(CliError::Refused {
            message: format!("--materials {name}: cannot be read: {error}"),
            cure: "check the path and its permissions".to_owned(),
        }),
    }
}
