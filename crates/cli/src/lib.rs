//! The command line `radiosity`: its verbs, and what each writes, and where.
//!
//! In order: what is typed and told (`console`, `interrupt`, `numbers`, `error`, `given`); options that verbs
//! share (`checkpoint` to `options`, the masks, planes and colours among them); `forecast`, `destination`,
//! `ledger` and `progress` of long work; `loaded` (a scene as it was read) and `run` (the scene solved, for
//! every verb that needs light), and what verbs read from and print to (`read` to `plan`); the verbs, from
//! `grid`, `probe`, `audit`, `solve` and `relight` over `render`, `animate`, `convergence`, `check`,
//! `scenes`, `schema` and `convert` to `view_factors`, `heat` and `report`; `rounds` (of messages between
//! processes), and `launch` (one process, or several ranks).
//!
//! The binary calls [`launch::launch`], and connects processes by MPI, with [`rounds`]: so a program with MPI
//! has this crate as one without it.
//!
//! Imports `geom`, `solvers`, `work`, `photometry`, `formats`, `scene`, `language`, `audit`, `visibility`,
//! `elements`, `kernel`, `transport`, `published`, `solve`, `reading`, `heat`, `output` and `request`.

mod console;
mod interrupt;
mod numbers;
mod exposure;
mod error;
mod points;
mod typed_options;
mod checkpoint;
mod colours;
mod planes;
mod aim;
mod sensors;
mod completions;
mod format;
mod output_file;
mod options;
mod forecast;
mod destination;
mod ledger;
mod progress;
mod loaded;
mod run;
mod read;
mod reference;
mod solution_format;
mod data;
mod plan;
mod grid;
mod probe;
mod audit;
mod solve;
mod relight;
mod style;
mod page;
mod bake;
mod render;
mod animate;
mod convergence;
mod materials;
mod check;
mod scenes;
mod schema;
mod convert;
mod transfers;
mod view_factors;
mod heat;
mod report;
pub mod rounds;
pub mod launch;
#[cfg(test)]
mod documented;

use aim::joined;
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

pub(crate) use error::CliError;
use loaded::Loaded;
use options::fixing;
use radiosity_work::ranks::Ranks;
use typed_options::TypedOptions;

const EXAMPLES: &str = "\
Examples:
  radiosity render                            a picture of the Cornell box: cornell-box.png
  radiosity animate billiard -o frame-####.png   pictures of a scene in which things move
  radiosity render room.toml -o room.glb      the room with its light in textures, for Blender and viewers
  radiosity render room.toml -o room.html     one file to walk through in a browser
  radiosity solve room.toml --report r.json   coefficients and a report of your own scene
  radiosity relight room.solution.json --set lamps=0.3   its light groups dimmed, without solving again
  radiosity probe room.toml --points p.csv    irradiance at your points x,y,z,nx,ny,nz
  radiosity probe room.toml --plane desk      irradiance on a plane of sensors, with mean, least and uniformity U0
  radiosity grid empty-box --cells 8x8        mean irradiance of every cell, as CSV
  radiosity audit room.toml                   its light judged by path tracing: off by how much, and where
  radiosity view-factors room.toml            the share of each surface's light that reaches each other, as CSV
  radiosity heat oven                         temperatures and flows of radiant heat
  radiosity report room.toml -o room.html     a report for people: picture, planes, surfaces, checks, settings
  radiosity solve room.toml -o room.vtu       its light as polynomials on curved cells, for ParaView
  radiosity convert room.mgf room.toml        a scene of another program, repaired and told, as one of radiosity
  radiosity check room.toml --set width=5     what is in a scene, and what looks wrong; its variable `width` set

SCENE is a path (.toml, .json, or a scene of another program: .mgf, .obj, .gltf, .glb, .stl, .ply, .xml of Mitsuba, .rad of
Radiance, .vs3 of View3D), the name of a built-in scene, or - for standard input.";

/// Diffuse light and radiant heat between curved surfaces, by high-order Galerkin radiosity.
#[derive(Debug, Parser)]
#[command(name = "radiosity", version, after_help = EXAMPLES, propagate_version = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    verb: Verb,

    /// Options of the method that were typed: a solution file has fixed them.
    #[arg(skip)]
    fixing: Vec<String>,

    /// Options and arguments that change results.
    #[arg(skip)]
    given: TypedOptions,
}

#[derive(Debug, Subcommand)]
enum Verb {
    Solve(solve::SolveArgs),
    Relight(relight::RelightArgs),
    Render(render::RenderArgs),
    Animate(animate::AnimateArgs),
    Probe(probe::ProbeArgs),
    Grid(grid::GridArgs),
    Audit(audit::AuditArgs),
    Convergence(convergence::ConvergenceArgs),
    ViewFactors(view_factors::ViewFactorsArgs),
    Heat(heat::HeatArgs),
    Report(report::ReportPageArgs),
    Check(check::CheckArgs),
    Convert(convert::ConvertArgs),
    Scenes(scenes::ScenesArgs),
    Schema(schema::SchemaArgs),
    Completions(completions::CompletionsArgs),
}

impl Cli {
    /// The command line as it was typed.
    ///
    /// # Errors
    /// [`CliError::Typed`] where it makes no sense, or asks for help.
    pub(crate) fn typed() -> Result<Self, CliError> {
        let mut command = Self::command();
        let matches = command.try_get_matches_from_mut(joined(std::env::args_os()))?;
        let mut cli = Self::from_arg_matches(&matches)?;
        cli.fixing = matches.subcommand().map(|(_, typed)| fixing(typed)).unwrap_or_default();
        cli.given = TypedOptions::of(&command, &matches);
        if let Verb::Render(args) = &mut cli.verb {
            args.set_preview();
        }
        Ok(cli)
    }

    /// Runs the verb, on these ranks.
    pub(crate) fn run(&self, ranks: &Ranks) -> Result<(), CliError> {
        interrupt::watch(ranks);
        let given = &self.given;
        match &self.verb {
            Verb::Solve(args) => {
                let loaded = Loaded::lit(&args.scene, ranks)?;
                let ranks = args.run.recording(given, &loaded.inputs(), loaded.scene(), None, ranks)?;
                solve::run(args, loaded, &ranks)
            }
            Verb::Relight(args) => relight::run(args, ranks),
            Verb::Render(args) => {
                let fixing = self.fixing.iter().filter(|option| !(args.importance && *option == "--for"));
                let mut loaded = Loaded::readable(&args.scene, &fixing.cloned().collect::<Vec<_>>(), ranks)?;
                let view = loaded.look(&args.view)?;
                let other = args.style.difference.as_deref();
                let ranks = args.run.recording(given, &loaded.inputs(), loaded.scene(), other, ranks)?;
                render::run(args, loaded, view, &ranks)
            }
            Verb::Animate(args) => animate::run(args, Loaded::lit(&args.scene, ranks)?, ranks),
            Verb::Probe(args) => {
                let points = args.load_points(ranks)?;
                let loaded = Loaded::readable(&args.scene, &self.fixing, ranks)?;
                let ranks =
                    args.run.recording(given, &(loaded.inputs(), &points), loaded.scene(), None, ranks)?;
                probe::run(args, points, loaded, &ranks)
            }
            Verb::Grid(args) => {
                let loaded = Loaded::readable(&args.scene, &self.fixing, ranks)?;
                let ranks = args.run.recording(given, &loaded.inputs(), loaded.scene(), None, ranks)?;
                grid::run(args, loaded, &ranks)
            }
            Verb::Audit(args) => audit::run(args, &self.fixing, given, ranks),
            Verb::Convergence(args) => convergence::run(args, &Loaded::lit(&args.scene, ranks)?, ranks),
            Verb::ViewFactors(args) => view_factors::run(args, given, ranks),
            Verb::Heat(args) => heat::run(args, given, ranks),
            Verb::Report(args) => {
                let loaded = Loaded::dark_or_lit(&args.scene, &self.fixing, ranks)?;
                let ranks = args.run.recording(given, &loaded.inputs(), loaded.scene(), None, ranks)?;
                report::run(args, loaded, &ranks)
            }
            Verb::Check(args) => check::run(args, &args.scene.request().load_repaired(ranks)?, ranks),
            Verb::Convert(args) => convert::run(args, ranks),
            Verb::Scenes(args) => scenes::run(args, ranks),
            Verb::Schema(args) => schema::run(args, ranks),
            Verb::Completions(args) => completions::run(args, Self::command(), ranks),
        }
    }
}
