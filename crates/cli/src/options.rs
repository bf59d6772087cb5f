//! Options that several verbs share.

use std::path::{Path, PathBuf};

use clap::{ArgMatches, Args, Command, parser::ValueSource};
use radiosity_photometry::files::Reach;
use radiosity_request::ranges::Length;
use radiosity_request::{ImportRequest, MethodRequest, SceneRequest};
use radiosity_work::ranks::Ranks;

use crate::{error::CliError, numbers::number, output_file::OutputFile};

/// Help on the scene of verbs that read solutions as well.
pub(crate) const SCENE_OR_SOLUTION: &str = "Path of a scene (.toml, .json, or of another program, such as .mgf, .obj) or of a solution, name of a built-in scene, or - for standard input";

/// Help on `--set` of verbs that compute or read light.
pub(crate) const PARAMETER_OR_GROUP: &str = "Sets a parameter of a built-in scene (`radiosity scenes` lists them) or a variable of a scene file, or multiplies the \
     light of a group of a scene file or solution by a factor; as often as needed";

/// The scene a verb works on.
#[derive(Debug, Args)]
pub(crate) struct SceneArg {
    /// Path of a scene (.toml, .json, or of another program: .mgf, .obj, .gltf, .glb, .stl, .ply, .xml, .rad,
    /// .vs3), name of a built-in scene, or - for standard input
    #[arg(value_name = "SCENE", default_value = "cornell-box")]
    pub(crate) scene: String,

    /// Sets a parameter of a built-in scene (`radiosity scenes` lists them) or a variable of a scene file, as
    /// often as needed
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub(crate) settings: Vec<(String, f64)>,

    /// Takes this frame of a scene in which something moves, counted from 0, or what is between two: 12.5
    /// [default: the scene at rest]
    #[arg(long, value_name = "K", allow_negative_numbers = true)]
    pub(crate) frame: Option<f64>,

    /// Corners and planes nearer than this length are made to agree; 0 for none [default: the rounding of the
    /// coordinates]
    #[arg(long, value_name = "LENGTH", value_parser = number::<Length>, allow_negative_numbers = true)]
    pub(crate) tolerance_length: Option<f64>,

    /// Ends with exit code 3 where path tracing finds light, heat or view factors to be off by more than is
    /// told; refuses a scene of another program that needs repairs; check fails (exit code 1) where anything
    /// looks wrong, missing light, materials and camera apart
    #[arg(long)]
    pub(crate) strict: bool,

    /// Refuses files outside the folder of the scene that it names; else they are read, and the summary lists
    /// them
    #[arg(long)]
    pub(crate) inside: bool,

    #[command(flatten)]
    pub(crate) import: ImportRequest,
}

impl SceneArg {
    /// The request of these options.
    pub(crate) fn request(&self) -> SceneRequest {
        SceneRequest {
            source: self.scene.clone(),
            settings: self.settings.clone(),
            frame: self.frame,
            tolerance: self.tolerance_length,
            strict: self.strict,
            reach: if self.inside { Reach::Inside } else { Reach::Anywhere },
            import: self.import.clone(),
        }
    }

    /// The file of the scene, if it comes from one.
    pub(crate) fn path(&self) -> Option<&Path> {
        (self.scene != "-" && !self.request().is_builtin()).then(|| Path::new(&self.scene))
    }

    /// An output, which must not take the place of the scene; finds out whether it can be written.
    pub(crate) fn reserve(&self, output: &Path, ranks: &Ranks) -> Result<OutputFile, CliError> {
        OutputFile::reserve(output, ranks)?.apart_from(self.path(), "the scene")
    }
}

/// Settings as the library takes them.
pub(crate) fn borrowed(settings: &[(String, f64)]) -> Vec<(&str, f64)> {
    settings.iter().map(|(name, value)| (name.as_str(), *value)).collect()
}

/// A name and a finite number with a `=` between.
pub(crate) fn setting(text: &str) -> Result<(String, f64), String> {
    let expected = || "expected a name and a finite number, such as distance=0.1".to_owned();
    let (name, value) = text.rsplit_once('=').ok_or_else(expected)?;
    let value: f64 = value.trim().parse().map_err(|_| expected())?;
    if value.is_finite() { Ok((name.trim().to_owned(), value)) } else { Err(expected()) }
}

/// Options of the messages during the work and after it.
#[derive(Debug, Args)]
#[command(next_help_heading = "Messages")]
pub(crate) struct ReportArgs {
    /// Writes counts, times and self-checks to a JSON file
    #[arg(long, value_name = "FILE.json")]
    pub(crate) report: Option<PathBuf>,

    /// Prints no progress and no summary
    #[arg(long, short)]
    pub(crate) quiet: bool,

    /// Prints more about each stage
    #[arg(short, long, conflicts_with = "quiet")]
    pub(crate) verbose: bool,
}

impl ReportArgs {
    /// Finds out, before the work, whether the report can be written.
    pub(crate) fn reserve(&self, ranks: &Ranks) -> Result<Option<OutputFile>, CliError> {
        self.report.as_deref().map(|path| OutputFile::reserve(path, ranks)).transpose()
    }
}

/// The options that are allowed with a solution file: they change no solution (or change reading too, as
/// `quality`).
const FREE: [&str; 3] = ["memory", "quality", "threads"];

/// The typed options of the method that change the solution, e.g. `--order`; `typed` are the arguments of a
/// verb.
pub(crate) fn fixing(typed: &ArgMatches) -> Vec<String> {
    let method = MethodRequest::augment_args(Command::new("method"));
    let is_typed = |id: &str| {
        let known = typed.try_contains_id(id).is_ok();
        known && typed.value_source(id) == Some(ValueSource::CommandLine)
    };
    let ids = method.get_arguments().map(|arg| arg.get_id().as_str());
    ids.filter(|id| !FREE.contains(id) && is_typed(id))
        .map(|id| format!("--{}", id.replace('_', "-")))
        .collect()
}
