//! Options that several verbs share.

use std::path::{Path, PathBuf};

use clap::{
    ArgMatches, Args, Command,
    builder::{PossibleValue, PossibleValuesParser, RangedU64ValueParser, TypedValueParser},
    parser::ValueSource,
};
use radiosity_elements::cells::Layers;
use radiosity_published::bases::Basis;
use radiosity_reading::quality::Quality;
use radiosity_request::{Kernel, MethodRequest, Order, SceneRequest, Shadows, ranges};
use radiosity_scene::Scene;
use radiosity_solve::studies::adaptation::Goal;
use radiosity_solve::{Direct, LightMethod, MOST_RAYS, Preconditioning, Transport};
use radiosity_solvers::method::Method;
use radiosity_work::Deadline;
use radiosity_work::ranks::Ranks;

use crate::{
    aim::AimOption,
    error::CliError,
    import::ImportArgs,
    masks::MaskArgs,
    numbers::{accuracy, at_least_one, fraction, not_negative, positive, seconds, threads},
    output_file::OutputFile,
    subdivide::Subdivide,
};

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
    #[arg(long, value_name = "LENGTH", value_parser = not_negative, allow_negative_numbers = true)]
    pub(crate) tolerance_length: Option<f64>,

    /// Refuses a scene of another program that needs repairs; check fails (exit code 1) where anything looks
    /// wrong, missing light, materials and camera apart
    #[arg(long)]
    pub(crate) strict: bool,

    #[command(flatten)]
    pub(crate) import: ImportArgs,
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
            import: self.import.request(),
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

/// How the radiosity is computed.
#[derive(Debug, Args)]
#[command(next_help_heading = "Method")]
pub(crate) struct MethodArgs {
    /// Preset of order and accuracies, and of how finely probe, grid and report read; single options go
    /// before it
    #[arg(long, value_name = "Q", default_value = "default")]
    pub(crate) quality: Quality,

    /// Which algorithm finds the light
    #[arg(long, value_name = "NAME", default_value = "galerkin")]
    pub(crate) method: LightMethod,

    /// Functions whose sums the light on surfaces is; those other than legendre are for comparison
    #[arg(long, value_name = "NAME", default_value = "legendre")]
    pub(crate) basis: Basis,

    /// Degree of the polynomials on each element; 0 is classical radiosity, auto is --accuracy 1e-2 [default:
    /// 3; as --quality says]
    #[arg(long, value_name = "N|auto")]
    pub(crate) order: Option<Order>,

    /// Wanted relative error: raises order, layers, cuts and accuracies until it is reached
    #[arg(long, value_name = "A", value_parser = fraction)]
    pub(crate) accuracy: Option<f64>,

    /// Of what the accuracy is wanted: gathered (light on all surfaces, as sensors and pictures read it),
    /// solution (the polynomials), picture (what the scene's camera sees), points FILE.csv, or plane NAME
    /// [default: gathered; the sensors that probe reads]
    #[arg(long = "for", id = "for", value_name = "WHAT")]
    pub(crate) aim: Option<AimOption>,

    /// Seconds after which no finer run begins, and rays end, where an accuracy is wanted; what there is is
    /// written, with exit code 3
    #[arg(long, value_name = "SECONDS", value_parser = seconds)]
    pub(crate) time_limit: Option<f64>,

    /// Polynomials of that degree in each coordinate, not in both together
    #[arg(long)]
    pub(crate) tensor: bool,

    /// Cuts each surface into K × K elements; auto looks at what the scene needs
    #[arg(long, value_name = "auto|K", default_value = "auto")]
    pub(crate) subdivide: Subdivide,

    /// Layers of elements graded towards the sides of every surface
    #[arg(long, value_name = "L", default_value = "0", value_parser = layers())]
    pub(crate) layers: usize,

    /// Size of each layer against the next, between 0 and 1
    #[arg(long, value_name = "Q", default_value = "0.25", value_parser = fraction)]
    pub(crate) ratio: f64,

    /// Accuracy of the transfers between elements, between 0 and 1 [default: 1e-3; as --quality says]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    pub(crate) eps: Option<f64>,

    /// Rules of the transfers between elements; those of 1993 ignore --eps
    #[arg(long, value_name = "MODE", default_value = "default")]
    pub(crate) kernel: Kernel,

    /// How the pairs of elements are carried
    #[arg(long, value_name = "MODE", default_value = "auto")]
    pub(crate) transport: Transport,

    /// Rays of the sampled transport [default: by the number of surfaces and --shadow-eps]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..=MOST_RAYS))]
    pub(crate) rays: Option<u64>,

    /// Solver of the linear system
    #[arg(long, value_name = "NAME", default_value = "auto", value_parser = solver())]
    pub(crate) solver: &'static Method,

    /// How cg and gmres precondition
    #[arg(long, value_name = "NAME", default_value = "block")]
    pub(crate) preconditioner: Preconditioning,

    /// Light that was reflected K times at the most before it arrives: 0 for light straight from emitters
    /// [default: all]
    #[arg(long, value_name = "K", value_parser = bounces(), allow_negative_numbers = true)]
    pub(crate) bounces: Option<u16>,

    /// Relative residual at which an iterative solver stops
    #[arg(long, value_name = "T", default_value = "1e-8", value_parser = positive)]
    pub(crate) tolerance: f64,

    /// Iterations after which an iterative solver gives up
    #[arg(long, value_name = "K", default_value = "1000", value_parser = at_least_one())]
    pub(crate) max_iterations: usize,

    /// How it is found out what surfaces hide from each other
    #[arg(long, value_name = "MODE", default_value = "auto")]
    pub(crate) shadows: Shadows,

    /// How light straight from emitters enters the solution
    #[arg(long, value_name = "MODE", default_value = "auto")]
    pub(crate) direct: Direct,

    /// Part of the light between two elements that may be in or out of shadow unnoticed, between 0 and 1
    /// [default: --eps where that is given, else 3e-3, as --quality says]
    #[arg(long, value_name = "E", value_parser = accuracy)]
    pub(crate) shadow_eps: Option<f64>,

    #[command(flatten)]
    pub(crate) masks: MaskArgs,

    /// Most memory to use, such as 500M, 2G or 2GiB [default: 80 % of what is free]
    #[arg(long, value_name = "BYTES", value_parser = ranges::bytes)]
    pub(crate) memory: Option<u64>,

    /// Threads to use, all by default; results do not depend on it
    #[arg(long, value_name = "N", value_parser = threads)]
    pub(crate) threads: Option<usize>,
}

impl MethodArgs {
    /// The request of these options.
    pub(crate) fn request(&self) -> MethodRequest {
        MethodRequest {
            quality: self.quality,
            method: self.method,
            basis: self.basis,
            order: self.order,
            accuracy: self.accuracy,
            aim: self.aim.as_ref().map(AimOption::aim),
            time_limit: self.time_limit,
            tensor: self.tensor,
            subdivide: self.subdivide.0,
            layers: Layers { count: self.layers, ratio: self.ratio },
            eps: self.eps,
            kernel: self.kernel,
            transport: self.transport,
            rays: self.rays,
            solver: self.solver,
            preconditioner: self.preconditioner,
            bounces: self.bounces.map(usize::from),
            tolerance: self.tolerance,
            max_iterations: self.max_iterations,
            shadows: self.shadows,
            direct: self.direct,
            shadow_eps: self.shadow_eps,
            masks: self.masks.masking(),
            memory: self.memory,
            threads: self.threads,
        }
    }

    /// The file of points where light is to be accurate, if there is one.
    pub(crate) fn points_file(&self) -> Option<&Path> {
        match &self.aim {
            Some(AimOption::Points(file)) => Some(Path::new(file)),
            _ => None,
        }
    }

    /// The deadline of the time limit, if there is one; the time counts from now.
    pub(crate) fn deadline(&self) -> Option<Deadline> {
        self.request().deadline().map(|at| Deadline::at(Some(at)))
    }

    /// The accuracy that is wanted in a scene, and its aim, if one is wanted.
    pub(crate) fn goal(&self, scene: &Scene, ranks: &Ranks) -> Result<Option<Goal>, CliError> {
        let aim = self.aim.as_ref().unwrap_or(&AimOption::Gathered);
        self.request().wanted_accuracy().map(|accuracy| aim.goal(accuracy, scene, ranks)).transpose()
    }
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

impl MethodArgs {
    /// The typed options of the method that change the solution, e.g. `--order`; `typed` are the arguments of
    /// a verb.
    pub(crate) fn fixing(typed: &ArgMatches) -> Vec<String> {
        let method = Self::augment_args(Command::new("method"));
        let is_typed = |id: &str| {
            let known = typed.try_contains_id(id).is_ok();
            known && typed.value_source(id) == Some(ValueSource::CommandLine)
        };
        let ids = method.get_arguments().map(|arg| arg.get_id().as_str());
        ids.filter(|id| !FREE.contains(id) && is_typed(id))
            .map(|id| format!("--{}", id.replace('_', "-")))
            .collect()
    }
}

fn layers() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(ranges::LAYERS)
}

fn bounces() -> RangedU64ValueParser<u16> {
    RangedU64ValueParser::new().range(ranges::BOUNCES)
}

pub(crate) fn solver() -> impl TypedValueParser<Value = &'static Method> {
    let summary = |method: &Method| {
        PossibleValue::new(method.name).aliases(method.aliases).help(method.summary_with_aliases())
    };
    PossibleValuesParser::new(Method::ALL.iter().map(summary))
        .map(|name| Method::named(&name).expect("the parser lets only listed names pass"))
}
