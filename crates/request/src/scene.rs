//! Requests for a scene: its source, its settings, and the options of its import.

use std::path::{Path, PathBuf};

use radiosity_formats::{format::Format, materials::SideFile, model::Sides, unit::Unit, up::Up};
use radiosity_language::{Import, input};
use radiosity_photometry::files::Reach;
use radiosity_reading::files::solution_file::is_solution;
use radiosity_scene::{Scene, SceneError, Source};
use radiosity_work::ranks::Ranks;
use radiosity_work::ranks::journal::fingerprint;
use radiosity_work::wording::{option, set, words};
use serde::Deserialize;

use super::modes;
use super::ranges::by_text;
use super::refusal::Refusal;

/// Heading of the options in the help of the command. It stands at each of them: a heading for what follows
/// would reach the options of the verb too.
#[cfg(feature = "clap")]
const HEADING: &str = "Scenes of other programs";

/// Options of the import of a scene of another program.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default)]
#[cfg_attr(feature = "clap", derive(clap::Args))]
pub struct ImportRequest {
    /// Format of the scene [default: that of the ending of its name]
    #[serde(rename = "format", deserialize_with = "modes::format")]
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING, value_name = "FORMAT", value_parser = modes::formats()))]
    pub from: Option<Format>,

    /// Only fronts reflect and emit, whatever the file says
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING, conflicts_with = "two_sided"))]
    pub one_sided: bool,

    /// Fronts and backs reflect and emit, whatever the file says
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING))]
    pub two_sided: bool,

    /// Materials by name, of the scene and of its surfaces: `[materials.NAME]` with reflectance and emission,
    /// and `[surfaces]` with "lamp*" = "NAME"
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING, value_name = "FILE.toml"))]
    pub materials: Option<PathBuf>,

    /// Unit of the lengths in the file, which become metres: mm, cm, dm, m, in, ft or yd
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING, value_name = "UNIT"))]
    pub unit: Option<Unit>,

    /// Axis that points upwards in the file, y or z; z will [default: y in glTF, else z]
    #[serde(deserialize_with = "by_text")]
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING, value_name = "AXIS"))]
    pub up: Option<Up>,

    /// Turns fronts that seem to point the wrong way; else they are only told
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING))]
    pub fix_fronts: bool,

    /// Red, green and blue become one band of their luminance
    #[cfg_attr(feature = "clap", arg(long, help_heading = HEADING))]
    pub grey: bool,
}

/// Request for a scene: its source and its settings.
#[derive(Clone, Debug, Default)]
pub struct SceneRequest {
    /// Path of a file, name of a built-in scene, or `-` for standard input.
    pub source: String,
    /// Parameters, variables and light groups by name.
    pub settings: Vec<(String, f64)>,
    /// The frame of a scene in which something moves.
    pub frame: Option<f64>,
    /// Length within which corners and planes are made to agree.
    pub tolerance: Option<f64>,
    /// Whether a scene of another program that needs repairs is refused.
    pub strict: bool,
    /// How far it may reach for the files that it names.
    pub reach: Reach,
    /// Options for a scene of another program.
    pub import: ImportRequest,
}

/// Reasons for which a scene was not read.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    /// Fault of the scene or of its file.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The file is a solution, not a scene.
    #[error("{origin}: this is a solution already")]
    Solved {
        /// The file as typed.
        origin: String,
    },
    /// Options that do not go with the scene.
    #[error(transparent)]
    Refused(#[from] Refusal),
}

impl SceneRequest {
    /// Whether `source` names a built-in scene.
    pub fn is_builtin(&self) -> bool {
        radiosity_language::builtins().iter().any(|builtin| builtin.name == self.source)
    }

    /// The scene for commands that need no light; settings are parameters or variables.
    ///
    /// # Errors
    /// Faults of the scene or of its file, a solution in place of a scene, options that do not go with the
    /// file.
    pub fn load(&self, ranks: &Ranks) -> Result<Scene, LoadError> {
        self.parameterised(self.strict, ranks)
    }

    /// The scene as [`SceneRequest::load`] reads it, even if it needs repairs.
    ///
    /// # Errors
    /// Faults of the scene or of its file, a solution in place of a scene, options that do not go with the
    /// file.
    pub fn load_repaired(&self, ranks: &Ranks) -> Result<Scene, LoadError> {
        self.parameterised(false, ranks)
    }

    /// The scene with its light groups at the factors that were set.
    ///
    /// # Errors
    /// Faults of the scene or of its file, a solution in place of a scene, options that do not go with the
    /// file.
    pub fn load_lit(&self, ranks: &Ranks) -> Result<Scene, LoadError> {
        self.parse(&unsolved(self.text(ranks)?)?, ranks)
    }

    /// The scene of a source that [`SceneRequest::text`] gave, with its variables and light groups as they were
    /// set.
    ///
    /// # Errors
    /// Faults of the scene; ranks that have read different ones.
    pub fn parse(&self, source: &Source, ranks: &Ranks) -> Result<Scene, LoadError> {
        self.agreed(radiosity_language::read_with(source, &self.later())?, ranks)
    }

    /// The scene with its parameters or variables as they were set.
    fn parameterised(&self, strict: bool, ranks: &Ranks) -> Result<Scene, LoadError> {
        let text = unsolved(self.text_with(&self.settings, strict, ranks)?)?;
        self.agreed(radiosity_language::read(&text)?, ranks)
    }

    /// The scene, if all ranks have read the same one: they would do different things, and wait for each
    /// other.
    fn agreed(&self, scene: Scene, ranks: &Ranks) -> Result<Scene, LoadError> {
        let differing = if ranks.are_alone() { None } else { ranks.differing(fingerprint(&scene)) };
        let Some(other) = differing else { return Ok(scene) };
        Err(Refusal::new(
            words(format!("{}: rank {other} reads another scene here than rank 0", self.source)),
            "let all ranks read the same files: from a folder that their machines share, or from equal copies",
        )
        .into())
    }

    /// The text of the scene, or of a solution; settings are those of parameters where the scene is built in.
    ///
    /// # Errors
    /// A file that cannot be read.
    pub fn text(&self, ranks: &Ranks) -> Result<Source, LoadError> {
        self.text_with(if self.is_builtin() { &self.settings } else { &[] }, self.strict, ranks)
    }

    /// The settings of variables and light groups, which a scene has that is not built in.
    pub fn later(&self) -> Vec<(&str, f64)> {
        if self.is_builtin() { Vec::new() } else { borrowed(&self.settings) }
    }

    fn text_with(
        &self,
        settings: &[(String, f64)],
        strict: bool,
        ranks: &Ranks,
    ) -> Result<Source, LoadError> {
        let import = self.import(strict, ranks)?;
        let source =
            radiosity_language::source_by(&self.source, &borrowed(settings), &import, self.reach, ranks)?;
        let source = source.within(self.tolerance);
        Ok(match self.frame {
            Some(frame) => source.at(frame),
            None => source,
        })
    }

    /// Options of the import; refuses options for a file that is not of another program.
    fn import(&self, strict: bool, ranks: &Ranks) -> Result<Import, Refusal> {
        let own = &self.import;
        let import = Import {
            format: own.from,
            sides: own.sides()?,
            materials: own.materials.as_deref().map(|path| side_file(path, ranks)).transpose()?,
            unit: own.unit,
            up: own.up,
            tolerance: self.tolerance,
            strict,
            fix_fronts: own.fix_fronts,
            grey: own.grey,
        };
        match own.first().filter(|_| import.format_of(&self.source).is_none()) {
            None => Ok(import),
            Some(name) => Err(Refusal::new(
                option(name) + format!(": {} is not known for a scene of another program", self.source),
                words("name its format with ")
                    + option("from")
                    + ", or leave the option out: a scene of radiosity says this itself",
            )),
        }
    }
}

impl ImportRequest {
    /// Sides that reflect and emit, of all surfaces; None for what the file says.
    fn sides(&self) -> Result<Option<Sides>, Refusal> {
        match (self.one_sided, self.two_sided) {
            (true, true) => Err(Refusal::new(
                option("one-sided") + " does not go with " + option("two-sided"),
                "leave one of them out",
            )),
            (true, false) => Ok(Some(Sides::Front)),
            (false, true) => Ok(Some(Sides::Both)),
            (false, false) => Ok(None),
        }
    }

    /// Name of the first option of the import that was given; none if none was.
    fn first(&self) -> Option<&'static str> {
        let given = [
            (self.from.is_some(), "from"),
            (self.one_sided, "one-sided"),
            (self.two_sided, "two-sided"),
            (self.materials.is_some(), "materials"),
            (self.unit.is_some(), "unit"),
            (self.up.is_some(), "up"),
            (self.fix_fronts, "fix-fronts"),
            (self.grey, "grey"),
        ];
        given.into_iter().find_map(|(is_given, name)| is_given.then_some(name))
    }
}

/// Settings as scenes take them.
pub(super) fn borrowed(settings: &[(String, f64)]) -> Vec<(&str, f64)> {
    settings.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

/// The text of a scene; refuses a solution.
fn unsolved(text: Source) -> Result<Source, LoadError> {
    match is_solution(&text.text()) {
        true => Err(LoadError::Solved { origin: text.origin.to_string() }),
        false => Ok(text),
    }
}

fn side_file(path: &Path, ranks: &Ranks) -> Result<SideFile, Refusal> {
    let name = path.display().to_string();
    // A file called `-` is one, too: standard input is for the scene.
    let source = if name == "-" { "./-" } else { &name };
    match input::text(source, ranks) {
        Ok(text) => Ok(SideFile { name, text }),
        Err(error) => Err(Refusal::new(
            set("materials", name) + format!(": cannot be read: {error}"),
            "check the path and its permissions",
        )),
    }
}
