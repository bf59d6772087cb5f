//! A scene with its solution: what pictures, probes and grids are read from.

use crate::adaptation::{Achieved, Adapted, Goal, adapt};
use crate::scene::Scene;
use crate::solve::{Failure, Options, Outcome, Progress, solve};
use crate::visibility::Visibility;

/// A solved scene; just solved, or read back from a file.
#[derive(Debug)]
pub struct Solved {
    /// The scene.
    pub scene: Scene,
    /// How it was solved.
    pub options: Options,
    /// The solution and what it cost.
    pub outcome: Outcome,
    /// How far it came, where an accuracy was wanted.
    pub achieved: Option<Achieved>,
}

impl Solved {
    /// Solves `scene`; see [`solve`].
    ///
    /// # Errors
    /// Those of [`solve`].
    pub fn new(
        scene: Scene,
        options: Options,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Self, Failure> {
        let outcome = solve(&scene, &options, progress)?;
        Ok(Self { scene, options, outcome, achieved: None })
    }

    /// Solves `scene` to a wanted accuracy; see [`adapt`].
    ///
    /// # Errors
    /// Those of [`adapt`].
    pub fn to_accuracy(
        scene: Scene,
        options: &Options,
        goal: Goal,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Self, Failure> {
        let Adapted { outcome, options, achieved } = adapt(&scene, options, goal, progress)?;
        Ok(Self { scene, options, outcome, achieved: Some(achieved) })
    }

    /// The scene as obstacles, with the shadows it was solved with.
    pub fn visibility(&self) -> Visibility {
        Visibility::new(&self.scene, (&self.options).into())
    }
}
