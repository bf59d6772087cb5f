//! A scene with its solution, from which pictures, probes and grids are read.

use std::sync::OnceLock;

use radiosity_geom::DVec3;

use crate::gather::Gather;
use crate::light::receiver_point::ReceiverPoint;
use crate::scene::Scene;
use crate::solution::Place;
use crate::solve::{Failure, Options, Outcome, Progress, solve};
use crate::studies::adaptation::{Achieved, Adapted, Goal, adapt};
use crate::visibility::Visibility;

/// Relative accuracy of light gathered at a point. Chosen; not tuned.
const AT_A_POINT: f64 = 1e-3;

/// A solved scene: just solved, or read from a file.
#[derive(Debug)]
#[non_exhaustive]
pub struct Solved {
    /// The scene.
    pub scene: Scene,
    /// How it was solved.
    pub options: Options,
    /// The solution with its cost and self-checks.
    pub outcome: Outcome,
    /// The accuracy that was reached, where one was wanted.
    pub achieved: Option<Achieved>,
    /// Made when first needed.
    visibility: OnceLock<Visibility>,
}

impl Solved {
    /// A scene with a solution that was computed, or read, before.
    pub fn of(scene: Scene, options: Options, outcome: Outcome, achieved: Option<Achieved>) -> Self {
        Self { scene, options, outcome, achieved, visibility: OnceLock::new() }
    }

    /// Solves `scene`; see [`solve`].
    ///
    /// # Errors
    /// As for [`solve`].
    pub fn new(
        scene: Scene,
        options: Options,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Self, Failure> {
        let outcome = solve(&scene, &options, progress)?;
        Ok(Self::of(scene, options, outcome, None))
    }

    /// Solves `scene` to a wanted accuracy; see [`adapt`].
    ///
    /// # Errors
    /// As for [`adapt`].
    pub fn to_accuracy(
        scene: Scene,
        options: &Options,
        goal: Goal,
        progress: &(dyn Fn(Progress) + Sync),
    ) -> Result<Self, Failure> {
        let Adapted { outcome, options, achieved } = adapt(&scene, options, goal, progress)?;
        Ok(Self::of(scene, options, outcome, Some(achieved)))
    }

    /// The scene as obstacles, with the shadows it was solved with.
    pub fn visibility(&self) -> &Visibility {
        self.visibility.get_or_init(|| Visibility::new(&self.scene, (&self.options).into()))
    }

    /// Irradiance per band at a point in the open, for the unit normal `normal`: in W m⁻² where exitance is in W m⁻²,
    /// in lux where it is in lm m⁻². Direct light and its shadows are computed there, the rest is gathered from all
    /// surfaces. For many points make one [`Gather`].
    pub fn irradiance_at(&self, position: DVec3, normal: DVec3) -> Vec<f64> {
        let gather = Gather::new(&self.outcome.solution, self.visibility(), AT_A_POINT);
        gather.at(&ReceiverPoint::free(position, normal))
    }

    /// Radiosity per band (unit of exitance) of the polynomials at (u, v) on a surface; None inside its holes.
    pub fn radiosity_at(&self, surface: usize, [u, v]: [f64; 2]) -> Option<Vec<f64>> {
        let solution = &self.outcome.solution;
        let element = solution.elements().at(surface, [u, v])?;
        let position = solution.elements().shape(surface).jet(u, v).position;
        let place = Place { surface, parameters: [u, v], position };
        Some((0..solution.bands().len()).map(|band| solution.radiosity(band, element, &place)).collect())
    }
}
