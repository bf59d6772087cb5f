//! The scene of a verb as it was read, solved or not.

use std::fmt::Debug;
use std::path::{Path, PathBuf};
use std::time::Instant;

use radiosity_language::Import;
use radiosity_photometry::files::Reach;
use radiosity_reading::files::solution_file::{is_solution, read};
use radiosity_request::MethodRequest;
use radiosity_request::view::{View, ViewRequest};
use radiosity_scene::Scene;
use radiosity_solve::Options;
use radiosity_solve::solved::Solved;
use radiosity_work::listed::{LONG, listed};
use radiosity_work::ranks::Ranks;

use crate::error::CliError;
use crate::options::{ReportArgs, SceneArg, borrowed};
use crate::output_file::OutputFile;

/// The scene of a verb as it was read, solved or not.
///
/// A verb that solves takes [`Loaded::lit`], one that also reads solutions [`Loaded::readable`]. It checks
/// its own arguments against [`Loaded::scene`], and then hands all of it to
/// [`Run::solve`](crate::run::Run::solve).
#[derive(Debug)]
pub(crate) struct Loaded {
    pub(crate) content: Content,
    /// The file it was read from.
    file: Option<PathBuf>,
    /// Whether the verb is strict.
    pub(crate) is_strict: bool,
    /// When its reading began.
    pub(crate) started: Instant,
}

/// Content of a file of a scene.
#[derive(Debug)]
pub(crate) enum Content {
    /// A scene.
    Scene(Box<Scene>),
    /// A solution.
    Solved(Box<Solved>),
}

impl Loaded {
    /// Reads a scene that has light.
    pub(crate) fn lit(source: &SceneArg, ranks: &Ranks) -> Result<Self, CliError> {
        let started = Instant::now();
        let scene = source.request().load_lit(ranks)?;
        Self::new(source.path(), Content::Scene(scene.into()), started).strictly(source.strict).required()
    }

    /// Reads a scene that has light, or a solution file; with a solution file the options in `fixed`, which
    /// were typed and change the method, are refused.
    pub(crate) fn readable(source: &SceneArg, fixed: &[String], ranks: &Ranks) -> Result<Self, CliError> {
        Self::dark_or_lit(source, fixed, ranks)?.required()
    }

    /// Reads a scene, dark or lit, or a solution file as [`Loaded::readable`] does.
    pub(crate) fn dark_or_lit(source: &SceneArg, fixed: &[String], ranks: &Ranks) -> Result<Self, CliError> {
        let started = Instant::now();
        let request = source.request();
        let text = request.text(ranks)?;
        if !is_solution(&text.text()) {
            let scene = request.parse(&text, ranks)?;
            let loaded = Self::new(source.path(), Content::Scene(scene.into()), started);
            return Ok(loaded.strictly(source.strict));
        }
        let tolerance = source.tolerance_length.map(|_| "--tolerance-length".to_owned());
        let frame = source.frame.map(|_| "--frame".to_owned());
        if let Some(option) = fixed.first().or(tolerance.as_ref()).or(frame.as_ref()) {
            return Err(CliError::fixed(&text.origin, option));
        }
        let solved = relit(read(&text)?, &request.later())?;
        Ok(Self::new(source.path(), Content::Solved(solved.into()), started).strictly(source.strict))
    }

    /// Reads a solution file, with its light groups at the factors that were set.
    pub(crate) fn solved(path: &str, settings: &[(String, f64)], ranks: &Ranks) -> Result<Self, CliError> {
        let started = Instant::now();
        let source = radiosity_language::source_by(path, &[], &Import::default(), Reach::Inside, ranks)?;
        if !is_solution(&source.text()) {
            return Err(CliError::refused(
                format!("{}: this is no solution", source.origin),
                "solve it first with `radiosity solve`; render, probe and grid take --set for scenes as well",
            ));
        }
        let file = (path != "-").then(|| Path::new(path));
        let solved = relit(read(&source)?, &borrowed(settings))?;
        Self::new(file, Content::Solved(solved.into()), started).required()
    }

    fn new(file: Option<&Path>, content: Content, started: Instant) -> Self {
        let file = file.map(Path::to_owned);
        Self { content, file, is_strict: false, started }
    }

    /// As of a verb that is strict, or not.
    fn strictly(self, is_strict: bool) -> Self {
        Self { is_strict, ..self }
    }

    /// Refuses a scene without light.
    pub(crate) fn required(self) -> Result<Self, CliError> {
        self.scene().require_light()?;
        Ok(self)
    }

    /// The scene.
    pub(crate) fn scene(&self) -> &Scene {
        match &self.content {
            Content::Scene(scene) => scene,
            Content::Solved(solved) => &solved.scene,
        }
    }

    /// Takes the view that was asked for, or that is chosen where the scene has no camera, as its camera;
    /// returns words on it, where it was chosen.
    pub(crate) fn look(&mut self, view: &ViewRequest) -> Result<Option<String>, CliError> {
        let View { camera, told } = view.of(self.scene())?;
        let scene = match &mut self.content {
            Content::Scene(scene) => scene,
            Content::Solved(solved) => &mut solved.scene,
        };
        scene.camera = Some(camera);
        Ok(told)
    }

    /// The options that the scene was or will be solved with.
    pub(crate) fn options(&self, method: &MethodRequest, ranks: &Ranks) -> Options {
        match &self.content {
            Content::Scene(_) => method.options(ranks),
            Content::Solved(solved) => solved.options,
        }
    }

    /// All inputs on which results depend besides the command line.
    pub(crate) fn inputs(&self) -> impl Debug {
        let solved = match &self.content {
            Content::Scene(_) => None,
            Content::Solved(solved) => Some((solved.options.neutral(), &solved.outcome, &solved.achieved)),
        };
        (self.scene(), solved)
    }

    /// Finds out, before the work, whether `output` can be written, and is neither the input nor the report.
    pub(crate) fn reserve(
        &self,
        output: &Path,
        report: &ReportArgs,
        ranks: &Ranks,
    ) -> Result<OutputFile, CliError> {
        self.apart(OutputFile::reserve(output, ranks)?)?.apart_from(report.report.as_deref(), "the report")
    }

    /// `output`, if it is not the file of the scene.
    pub(crate) fn apart(&self, output: OutputFile) -> Result<OutputFile, CliError> {
        output.apart_from(self.file.as_deref(), "the scene")
    }
}

/// The solution with its light groups at these factors.
pub(crate) fn relit(solved: Solved, factors: &[(&str, f64)]) -> Result<Solved, CliError> {
    if factors.is_empty() { Ok(solved) } else { Ok(solved.relight(factors)?) }
}

/// The files that were read outside the folder of a scene, in a sentence.
pub(crate) fn outside(scene: &Scene) -> Option<String> {
    let files = scene.source.as_ref()?.outside();
    let names: Vec<&str> = files.iter().map(String::as_str).collect();
    let told = || format!("read outside the folder of the scene: {}", listed(&names, LONG));
    (!names.is_empty()).then(told)
}

/// Most remarks on a scene of another program that a summary spells out. Chosen.
const SPELT: usize = 12;

/// Remarks on the changes to a scene when it was read.
pub(crate) fn remarks(scene: &Scene) -> Vec<String> {
    let mut all: Vec<String> =
        scene.imported().map(|imported| imported.lines().collect()).unwrap_or_default();
    let count = all.len();
    if count > SPELT {
        all.truncate(SPELT - 1);
        all.push(format!("{} more remarks: `radiosity check` and --report say them all", count - SPELT + 1));
    }
    all.extend(outside(scene));
    all.extend(scene.fitted.line());
    all
}
