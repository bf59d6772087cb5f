//! Command line: the verbs, and what each does with the library.

mod check;
mod error;
mod grid;
mod options;
mod output_file;
mod progress;
mod render;
mod run;
mod scenes;
mod solve;
mod table;
mod view_factors;

use clap::{Parser, Subcommand};

use error::CliError;
use run::Loaded;

const EXAMPLES: &str = "\
Examples:
  radiosity render                            a picture of the Cornell box: cornell-box.png
  radiosity solve room.toml --report r.json   coefficients and a report of your own scene
  radiosity grid empty-box --cells 8x8        mean irradiance of every cell, as CSV
  radiosity view-factors room.toml            the share of each surface's light that reaches each other, as CSV
  radiosity check room.toml                   what is in a scene, and what looks wrong

SCENE is a path (.toml or .json), the name of a built-in scene, or - for standard input.";

/// Diffuse light and radiant heat between curved surfaces, by high-order Galerkin radiosity.
#[derive(Debug, Parser)]
#[command(version, after_help = EXAMPLES, propagate_version = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    verb: Verb,
}

#[derive(Debug, Subcommand)]
enum Verb {
    Solve(solve::SolveArgs),
    Render(render::RenderArgs),
    Grid(grid::GridArgs),
    ViewFactors(view_factors::ViewFactorsArgs),
    Check(check::CheckArgs),
    Scenes(scenes::ScenesArgs),
}

impl Cli {
    /// Does what was asked.
    pub(crate) fn run(&self) -> Result<(), CliError> {
        match &self.verb {
            Verb::Solve(args) => solve::run(args, &Loaded::lit(&args.scene)?),
            Verb::Render(args) => render::run(args, &Loaded::lit(&args.scene)?),
            Verb::Grid(args) => grid::run(args, &Loaded::lit(&args.scene)?),
            Verb::ViewFactors(args) => view_factors::run(args),
            Verb::Check(args) => check::run(args, &args.scene.load()?),
            Verb::Scenes(args) => scenes::run(args),
        }
    }
}
