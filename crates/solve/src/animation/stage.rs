//! A stage: a scene in which somebody else says where things are, and its light, frame after frame.
//!
//! Nothing has to be known in advance of where movers go or how they shine. Each frame is found from the one
//! before ([`Sequence::incremental`]): only what has changed is integrated, traced and solved for. Direct light
//! that is split off is found anew; where frames have to be quick, [`Direct::Projected`](crate::driver::Direct)
//! leaves it to the blocks.

use radiosity_scene::{Animation, Fault, MoverState, Pose, Scene, SceneError};
use radiosity_work::Work;

use crate::driver::Options;

use super::error::AnimationError;
use super::frame::Frame;
use super::sequence::Sequence;
use super::sequence_report::SequenceReport;

/// A scene whose movers are placed by hand.
///
/// ```
/// use radiosity_geom::{DQuat, DVec3};
/// use radiosity_scene::Pose;
/// use radiosity_solve::Options;
/// use radiosity_solve::animation::stage::Stage;
/// use radiosity_work::Work;
///
/// let mut stage = Stage::new(radiosity_language::builtin("sliding-light")?, &Options::default())?;
/// let mut light = Vec::new();
/// for step in 0..3 {
///     let shift = DVec3::new(-0.4 * f64::from(step), 0.0, 0.0);
///     stage.move_to("lamp", Pose::rigid(DVec3::ZERO, DQuat::IDENTITY, shift)?)?;
///     stage.emit("lamp", &[1.0 - 0.25 * f64::from(step); 3])?;
///     let frame = stage.frame(&Work::alone())?;
///     light.push(frame.solution.mean_irradiance(0, 0));
/// }
/// assert!(light[2] < light[1] && light[1] < light[0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Stage {
    sequence: Sequence<'static>,
    states: Vec<MoverState>,
}

impl Stage {
    /// The stage of `scene`, whose motions name what may be moved or dimmed, all at rest; frames are solved
    /// with `options`.
    ///
    /// # Errors
    /// A scene without motions.
    pub fn new(scene: Scene, options: &Options) -> Result<Self, AnimationError> {
        let states = vec![MoverState::REST; animation(&scene)?.movers.len()];
        Ok(Self { sequence: Sequence::incremental_owned(scene, options), states })
    }

    /// The scene with its motions.
    pub fn scene(&self) -> &Scene {
        self.sequence.scene()
    }

    /// Puts a mover into a pose, in the coordinates of the scene's file, from the next frame on.
    ///
    /// # Errors
    /// A name of no mover.
    pub fn move_to(&mut self, mover: &str, pose: Pose) -> Result<(), AnimationError> {
        let middle = self.scene().middle;
        self.state(mover)?.pose = pose.about(middle);
        Ok(())
    }

    /// Lets the surfaces and luminaires of a mover emit, in each band, a factor ≥ 0 of what they emit at
    /// rest, from the next frame on.
    ///
    /// # Errors
    /// A name of no mover. Factors that cannot be are told by the next frame.
    pub fn emit(&mut self, mover: &str, factors: &[f64]) -> Result<(), AnimationError> {
        self.state(mover)?.factors = factors.to_vec();
        Ok(())
    }

    /// The light where all movers are now.
    ///
    /// # Errors
    /// As [`Sequence::placed`]. Movers stay where they are; once the cause is mended, the next frame is found.
    pub fn frame(&mut self, work: &Work<'_>) -> Result<Frame, AnimationError> {
        self.sequence.placed(&self.states, work)
    }

    /// Cost and error of all frames so far.
    pub fn report(&self) -> &SequenceReport {
        self.sequence.report()
    }

    fn state(&mut self, mover: &str) -> Result<&mut MoverState, AnimationError> {
        let scene = self.sequence.scene();
        let place = animation(scene)?.mover(mover).map_err(|fault| SceneError::of(&scene.origin, fault))?;
        Ok(&mut self.states[place])
    }
}

/// The animation of a scene, if anything moves in it.
fn animation(scene: &Scene) -> Result<&Animation, SceneError> {
    let nothing_moves = || {
        let cure = "add frames = 1 and a [[motion]] for each thing that is placed";
        SceneError::of(&scene.origin, Fault::absent("nothing moves in the scene", cure))
    };
    scene.animation.as_ref().ok_or_else(nothing_moves)
}
