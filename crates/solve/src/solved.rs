//! A scene with its solution, from which pictures, probes and grids are read.

use std::sync::{Arc, OnceLock};

use radiosity_geom::DVec3;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_scene::{Scene, SceneError};
use radiosity_visibility::Visibility;
use radiosity_work::Work;

use crate::driver::{Failure, Options, Outcome, solve};
use crate::gather::Gather;
use crate::goal::Achieved;
use crate::solution::SurfacePlace;
use crate::tolerances::AT_A_POINT;

/// Why the groups of a solution could not be dimmed.
#[derive(Debug, thiserror::Error)]
pub enum RelightError {
    /// The scene has no such groups, or cannot have such factors.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The solution was made of bands in code, without the light of each group.
    #[error("the solution does not keep the light of its groups apart: solve the scene again")]
    NotApart,
}

/// A solved scene: just solved, or read from a file.
#[derive(Debug)]
#[non_exhaustive]
pub struct Solved {
    /// The scene that was solved.
    pub scene: Scene,
    /// The options with which it was solved.
    pub options: Options,
    /// The solution with its cost and self-checks.
    pub outcome: Outcome,
    /// The accuracy that was reached, where one was wanted.
    pub achieved: Option<Achieved>,
    /// Made when first needed; the same at all factors of light groups.
    visibility: Arc<OnceLock<Visibility>>,
}

impl Solved {
    /// A scene with a solution that was computed, or read, before.
    pub fn of(scene: Scene, options: Options, outcome: Outcome, achieved: Option<Achieved>) -> Self {
        Self { scene, options, outcome, achieved, visibility: Arc::default() }
    }

    /// Solves `scene`; see [`solve`].
    ///
    /// # Errors
    /// As for [`solve`].
    pub fn new(scene: Scene, options: Options, work: &Work<'_>) -> Result<Self, Failure> {
        let outcome = solve(&scene, &options, work)?;
        Ok(Self::of(scene, options, outcome, None))
    }

    /// The solved scene with its light groups at other factors (≥ 0) of the emission that its materials
    /// state, from the light that each group was solved with: nothing is solved again. Groups that are not
    /// named keep their factors.
    ///
    /// ```
    /// use radiosity_solve::{Options, solved::Solved};
    /// use radiosity_work::Work;
    ///
    /// let room = r#"
    ///     bands = ["lm"]
    ///     materials.floor = { reflectance = 0.3 }
    ///     materials.lamp = { reflectance = 0, emission = 500, group = "lamps" }
    ///     surfaces = [
    ///         { material = "floor", disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 2 } },
    ///         { material = "lamp", disk = { center = [0, 0, 1], normal = [0, 0, -1], radius = 0.2 } },
    ///     ]"#;
    /// let room = radiosity_language::read(&radiosity_scene::Source::new("room", room))?;
    /// let solved = Solved::new(room, Options::default(), &Work::alone())?;
    /// let evening = solved.relight(&[("lamps", 0.25)])?;
    /// let [day, dim] = [&solved, &evening].map(|light| light.outcome.solution.mean_irradiance(0, 0));
    /// assert!((dim - 0.25 * day).abs() < 1e-12 * day);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`RelightError::Scene`] for a group that is unknown or set twice, and a factor that is negative or not
    /// finite.
    pub fn relight(&self, settings: &[(&str, f64)]) -> Result<Self, RelightError> {
        let scene = self.scene.dimmed(settings)?;
        let outcome = self.outcome.relight(&scene).ok_or(RelightError::NotApart)?;
        let visibility = Arc::clone(&self.visibility);
        Ok(Self { scene, options: self.options, outcome, achieved: self.achieved, visibility })
    }

    /// The scene as obstacles, with the shadows it was solved with.
    pub fn visibility(&self) -> &Visibility {
        self.visibility.get_or_init(|| self.options.visibility(&self.scene))
    }

    /// Irradiance per band at a point in the open, for the unit normal `normal`: in W m⁻² where exitance is
    /// in W m⁻², in lux where it is in lm m⁻². Direct light and its shadows are computed there, the rest is
    /// gathered from all surfaces. For many points make one [`Gather`].
    pub fn irradiance_at(&self, position: DVec3, normal: DVec3) -> Vec<f64> {
        let gather = Gather::new(&self.outcome.solution, self.visibility(), AT_A_POINT);
        gather.at(&ReceiverPoint::free(position, normal))
    }

    /// Radiosity per band (unit of exitance) of the polynomials at (u, v) on a surface; None inside its
    /// holes.
    ///
    /// ```
    /// use radiosity_solve::{Options, solved::Solved};
    /// use radiosity_work::Work;
    ///
    /// let room = radiosity_language::builtin("furnace-cube")?;
    /// let solved = Solved::new(room, Options::default(), &Work::alone())?;
    /// // In a closed room of reflectance ½ that emits 1 everywhere, 1 + ½ · 2 leaves every point.
    /// let leaving = solved.radiosity_at(0, [0.3, -0.2]).expect("there is no hole")[0];
    /// assert!((leaving - 2.0).abs() < 1e-2);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn radiosity_at(&self, surface: usize, [u, v]: [f64; 2]) -> Option<Vec<f64>> {
        let solution = &self.outcome.solution;
        let element = solution.elements().at(surface, [u, v])?;
        let position = solution.elements().shape(surface).jet(u, v).position;
        let place = SurfacePlace { surface, parameters: [u, v], position };
        Some((0..solution.bands().len()).map(|band| solution.radiosity(band, element, &place)).collect())
    }
}
