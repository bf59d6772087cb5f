//! Scenes that are solved, cut and carried: work that succeeds.

use radiosity::elements::{Discretization, Elements};
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::reading::files::solution_file::SolutionFile;
use radiosity::solve::{Transport, view_factors};
use radiosity::visibility::{Shadows, Visibility};
use radiosity::{Options, Outcome, Scene, Solved, ViewFactors, Work, solve, transport};

/// The outcome of a scene.
#[track_caller]
pub fn outcome_of(scene: &Scene, options: &Options) -> Outcome {
    solve(scene, options, &Work::alone()).unwrap_or_else(|error| panic!("{error}"))
}

/// A scene with its outcome.
#[track_caller]
pub fn solved_of(scene: Scene, options: Options) -> Solved {
    Solved::new(scene, options, &Work::alone()).unwrap_or_else(|error| panic!("{error}"))
}

/// The elements of a scene at one order, so many times cut along each parameter.
#[track_caller]
pub fn elements_of(scene: &Scene, order: usize, parts: usize) -> Elements {
    let how = Discretization::uniform(order, parts);
    Elements::new(scene, &how).unwrap_or_else(|error| panic!("{error}"))
}

/// All blocks between elements.
pub fn blocks_of(elements: &Elements, visibility: &Visibility, accuracy: Accuracy) -> Blocks {
    transport::assemble(transport::Demand::all(elements, visibility, accuracy), None, &Work::alone())
}

/// The view factors of a scene, its surfaces cut as they are by default.
#[track_caller]
pub fn factors_of(scene: &Scene, shadows: Shadows, eps: f64, shadow_eps: f64) -> ViewFactors {
    let accuracy = Accuracy { eps, shadow_eps };
    let (transport, usual) = (Transport::Exact, view_factors::Options::default());
    let options = view_factors::Options { accuracy, shadows, transport, threads: 2, ..usual };
    ViewFactors::new(scene, &options, &Work::alone()).unwrap_or_else(|error| panic!("{error}"))
}

/// The view factors of a scene at the accuracies that are usual: of blocks 1e-3, of shadows 3e-3.
#[track_caller]
pub fn usual_factors(scene: &Scene) -> ViewFactors {
    factors_of(scene, Shadows::Auto, 1e-3, 3e-3)
}

/// A changed solution file with the checksum of its content, as one writes it who knows the format; the text itself
/// where it is no such file.
pub fn sealed(text: &str) -> String {
    let file = serde_json::from_str::<SolutionFile>(text).ok();
    let sealed = file.and_then(|file| serde_json::to_string(&file.sealed()).ok());
    sealed.unwrap_or_else(|| text.to_owned())
}
