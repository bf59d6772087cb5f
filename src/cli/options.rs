//! Options that several verbs share.

use std::{
    path::{Path, PathBuf},
    str::FromStr,
};

use clap::{
    ArgMatches, Args, Command, ValueEnum,
    builder::{PossibleValue, PossibleValuesParser, RangedU64ValueParser, TypedValueParser},
    parser::ValueSource,
};
use radiosity::kernel::paper::{Reading, Rules};
use radiosity::output::quality::Quality;
use radiosity::output::solution_file::is_solution;
use radiosity::scene::{MAX_ORDER, Scene, SceneError, Source};
use radiosity::solve::Direct;
use radiosity::visibility::Hiding;
use radiosity_solvers::method::Method;

use crate::cli::{error::CliError, masks::MaskArgs, memory, output_file::OutputFile};

/// Help on the scene of verbs that read solutions as well.
pub(crate) const SCENE_OR_SOLUTION: &str =
    "Path of a scene (.toml, .json) or of a solution, name of a built-in scene, or - for standard input";

/// The scene a verb works on.
#[derive(Debug, Args)]
pub(crate) struct SceneArg {
    /// Path of a scene (.toml, .json), name of a built-in scene, or - for standard input
    #[arg(value_name = "SCENE", default_value = "cornell-box")]
    pub(crate) scene: String,

    /// Sets a parameter of a built-in scene, as often as needed; `radiosity scenes` lists them
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub(crate) settings: Vec<(String, f64)>,
}

impl SceneArg {
    /// Loads the scene; refuses a solution.
    pub(crate) fn load(&self) -> Result<Scene, CliError> {
        let text = self.text()?;
        if is_solution(&text.text) {
            return Err(CliError::AlreadySolved { origin: text.origin.to_string() });
        }
        Ok(Scene::parse(&text)?)
    }

    /// The file of the scene, if it comes from one.
    pub(crate) fn path(&self) -> Option<&Path> {
        let builtin = Scene::builtins().iter().any(|builtin| builtin.name == self.scene);
        (self.scene != "-" && !builtin).then(|| Path::new(&self.scene))
    }

    /// The text of the scene, or of a solution.
    pub(crate) fn text(&self) -> Result<Source, SceneError> {
        let settings: Vec<_> = self.settings.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        Scene::text_of(&self.scene, &settings)
    }
}

fn setting(text: &str) -> Result<(String, f64), String> {
    let expected = || "expected the name of a parameter and a number, such as distance=0.1".to_owned();
    let (name, value) = text.split_once('=').ok_or_else(expected)?;
    let value: f64 = value.trim().parse().map_err(|_| expected())?;
    if value.is_finite() { Ok((name.trim().to_owned(), value)) } else { Err(expected()) }
}

/// How the radiosity is computed.
#[derive(Debug, Args)]
#[command(next_help_heading = "Method")]
pub(crate) struct MethodArgs {
    /// Preset of order, accuracies and points read; single options go before it
    #[arg(long, value_name = "Q", default_value = "default")]
    pub(crate) quality: QualityMode,

    /// Degree of the polynomials on each element; 0 is classical radiosity, auto is --accuracy 1e-2 [default: 3; as --quality says]
    #[arg(long, value_name = "N|auto")]
    pub(crate) order: Option<Order>,

    /// Wanted relative error of the radiosity: raises order, layers, cuts and accuracies until it is reached
    #[arg(long, value_name = "A", value_parser = fraction)]
    pub(crate) accuracy: Option<f64>,

    /// Polynomials of that degree in each coordinate, not in both together
    #[arg(long)]
    pub(crate) tensor: bool,

    /// Cuts each surface into K × K elements; auto looks at what the scene needs
    #[arg(long, value_name = "auto|1|2|4", default_value = "auto", value_parser = subdivide())]
    pub(crate) subdivide: Subdivide,

    /// Layers of elements graded towards the sides of every surface
    #[arg(long, value_name = "L", default_value = "0", value_parser = layers())]
    pub(crate) layers: usize,

    /// Size of each layer against the next, between 0 and 1
    #[arg(long, value_name = "Q", default_value = "0.25", value_parser = fraction)]
    pub(crate) ratio: f64,

    /// Accuracy of the transfers between elements, between 0 and 1 [default: 1e-3; as --quality says]
    #[arg(long, value_name = "E", value_parser = fraction)]
    pub(crate) eps: Option<f64>,

    /// Rules of the transfers between elements; those of 1993 ignore --eps
    #[arg(long, value_name = "MODE", default_value = "default")]
    pub(crate) kernel: Kernel,

    /// Corrects the transfers so that they add up to 1: for closed scenes without shadows, at a loose --eps
    #[arg(long)]
    pub(crate) closure_correction: bool,

    /// Solver of the linear system
    #[arg(long, value_name = "NAME", default_value = "auto", value_parser = solver())]
    pub(crate) solver: &'static Method,

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
    pub(crate) direct: DirectMode,

    /// Part of the light between two elements that may be in or out of shadow unnoticed, between 0 and 1 [default: 3e-3; as
    /// --quality says]
    #[arg(long, value_name = "E", value_parser = fraction)]
    pub(crate) shadow_eps: Option<f64>,

    #[command(flatten)]
    pub(crate) masks: MaskArgs,

    /// Most memory to use, such as 500M, 2G or 2GiB [default: 80 % of what is free]
    #[arg(long, value_name = "BYTES", value_parser = memory::bytes)]
    pub(crate) memory: Option<u64>,

    /// Threads to use, all by default; results do not depend on it
    #[arg(long, value_name = "N", value_parser = threads)]
    pub(crate) threads: Option<usize>,
}

impl MethodArgs {
    /// The relative error wanted, if one is.
    pub(crate) fn wanted_accuracy(&self) -> Option<f64> {
        self.accuracy.or_else(|| (self.order == Some(Order::Auto)).then_some(AUTO_ACCURACY))
    }
}

/// What `--order auto` means.
const AUTO_ACCURACY: f64 = 1e-2;

/// What is told while the work is done, and after it.
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
    pub(crate) fn reserve(&self) -> Result<Option<OutputFile>, CliError> {
        self.report.as_deref().map(OutputFile::reserve).transpose()
    }
}

/// `--order`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Order {
    /// As the accuracy needs.
    Auto,
    /// This one; with `--accuracy`, at least this one.
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

/// The options that work with a solution file as well: they change no solution, or how it is read as well.
const FREE: [&str; 3] = ["memory", "quality", "threads"];

impl MethodArgs {
    /// The options of the method that were typed and change the solution, e.g. `--order`; `typed` are those of a verb.
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

/// `--subdivide`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subdivide {
    /// As the scene needs.
    Auto,
    /// This many elements along u and along v.
    Parts(usize),
}

/// `--shadows`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Shadows {
    /// Planar surfaces behind planar ones by their outlines, all else by rays
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
    /// The same, for the library.
    pub(crate) fn hiding(self) -> Hiding {
        match self {
            Shadows::Auto | Shadows::Mask => Hiding::Auto,
            Shadows::Off => Hiding::Off,
            Shadows::Rays => Hiding::Rays,
            Shadows::Exact => Hiding::Exact,
        }
    }
}

/// `--quality`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum QualityMode {
    /// A draft
    Quick,
    /// What most need
    Default,
    /// A higher order, gathered more accurately
    Fine,
    /// Light gathered twice
    Finest,
}

impl From<QualityMode> for Quality {
    fn from(mode: QualityMode) -> Self {
        match mode {
            QualityMode::Quick => Self::Quick,
            QualityMode::Default => Self::Default,
            QualityMode::Fine => Self::Fine,
            QualityMode::Finest => Self::Finest,
        }
    }
}

/// `--direct`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum DirectMode {
    /// Split where flat emitters cast shadows of flat surfaces, else projected
    Auto,
    /// An exact source at every point, with its shadows
    Split,
    /// Carried by the polynomials like all other light
    Projected,
}

impl From<DirectMode> for Direct {
    fn from(mode: DirectMode) -> Self {
        match mode {
            DirectMode::Auto => Self::Auto,
            DirectMode::Split => Self::Split,
            DirectMode::Projected => Self::Projected,
        }
    }
}

/// `--kernel`. The paper's rules take N + 2 points a direction, which fits the numbers it prints.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Kernel {
    /// As accurate as --eps says
    Default,
    /// Zatz 1993: N + 2 Gauss-Legendre points a direction for every pair
    PaperLegendre,
    /// Zatz 1993: the same, with Gauss-Jacobi points on the receiver where two surfaces share an edge
    PaperHybrid,
}

impl Kernel {
    /// The rules of 1993 that it names. Of the readings of the hybrid, H1 fits the numbers the paper prints best.
    pub(crate) fn rules(self) -> Option<Rules> {
        match self {
            Kernel::Default => None,
            Kernel::PaperLegendre => Some(Rules::Legendre),
            Kernel::PaperHybrid => Some(Rules::Hybrid(Reading::H1)),
        }
    }
}

/// Two counts written `AxB`, such as `16x16` or `800x600`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Counts(pub(crate) [u32; 2]);

impl FromStr for Counts {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        const MOST: u32 = 16384;
        let count = |part: &str| part.parse().ok().filter(|count| (1..=MOST).contains(count));
        text.split_once(['x', 'X', '×'])
            .and_then(|(first, second)| Some(Counts([count(first)?, count(second)?])))
            .ok_or_else(|| format!("expected two numbers from 1 to {MOST} with an x between, such as 16x16"))
    }
}

/// A number above 0.
pub(crate) fn positive(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0, "expected a number above 0, such as 1e-8")
}

/// A number between 0 and 1.
pub(crate) fn fraction(text: &str) -> Result<f64, String> {
    number(text, |x| x > 0.0 && x < 1.0, "expected a number above 0 and below 1, such as 1e-3")
}

fn number(text: &str, inside: fn(f64) -> bool, expected: &str) -> Result<f64, String> {
    text.parse().ok().filter(|&x: &f64| x.is_finite() && inside(x)).ok_or_else(|| expected.to_owned())
}

fn layers() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(0..=8)
}

/// A number of threads. More than any machine has use for would bring it to a standstill.
pub(crate) fn threads(text: &str) -> Result<usize, String> {
    const MOST: usize = 1024;
    let count = text.parse().ok().filter(|count| (1..=MOST).contains(count));
    count.ok_or_else(|| format!("expected a whole number from 1 to {MOST}; leave it out for one a core"))
}

/// A count from 1 on.
pub(crate) fn at_least_one() -> RangedU64ValueParser<usize> {
    RangedU64ValueParser::new().range(1..=u64::from(u32::MAX))
}

fn solver() -> impl TypedValueParser<Value = &'static Method> {
    let summary = |method: &Method| PossibleValue::new(method.name).help(method.summary);
    PossibleValuesParser::new(Method::ALL.iter().map(summary))
        .map(|name| Method::named(&name).expect("the parser lets only listed names pass"))
}

/// `auto`, or elements along u and v.
pub(crate) fn subdivide() -> impl TypedValueParser<Value = Subdivide> {
    PossibleValuesParser::new(["auto", "1", "2", "4"])
        .map(|text| text.parse().map_or(Subdivide::Auto, Subdivide::Parts))
}
