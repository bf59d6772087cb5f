//! Adaptation: solves on finer and finer discretisations until a wanted accuracy is reached.
//!
//! Each run has more polynomials or elements than the one before, and more accurate transfers. Its error is
//! estimated from light gathered at points, plus what transfers and shadows may miss: that of the polynomials
//! by what is gathered beside them (`estimate`), that of gathered light by walks (`error_estimate`). Against
//! exact answers and much finer runs the estimate of polynomials is within a factor of three of the error
//! (`cargo test --release --test stress -- --ignored`), that of gathered light within two
//! (`cargo run --release -p radiosity-studies --bin estimates`).
//!
//! Where the goal is gathered light, elements are refined where they are responsible for its error (`local`);
//! where rays carry the pairs, by more of them (`rays`); for polynomials all alike (`rungs`); for
//! hierarchical radiosity by weaker links (`links`).

mod sensor;
mod error_estimate;
mod importance;
mod estimate;
mod judge;
mod run;
mod rungs;
mod rays;
mod links;
mod smoothness;
mod local;

use std::sync::OnceLock;

use radiosity_scene::Scene;
use radiosity_work::Work;

use crate::driver::{Failure, LightMethod, Options, Transport, TransportChoice};
pub use crate::goal::{Achieved, Aim, EndReason, Goal};
use crate::solved::Solved;
pub use importance::importance;
use links::by_links;
use local::locally;
use rays::by_rays;
use run::Adaptation;
use rungs::by_rungs;

/// Most surfaces of a small scene, whose exact blocks take seconds to minutes. An arbitrary choice: with a
/// larger value scenes are refined by exact blocks for which rays are sooner at the same error.
const FEW: usize = 300;

/// Why small scenes are solved by exact blocks.
const NO_ERROR_OF_ELEMENTS: &str =
    "an accuracy of the polynomials is asked for, and rays do not tell the error of elements";

impl Solved {
    /// Solves `scene` on finer and finer discretisations until the estimated error is small enough, or the
    /// next run would be too large or end too late. A finer run that does not fit into memory, or whose
    /// solver does not converge, also ends the sequence.
    ///
    /// Order and layers in `options` are lower bounds, `eps` and `shadow_eps` upper bounds; given cuts stay.
    /// Every run is told from its beginning.
    ///
    /// # Errors
    /// Any error of the first run; of later runs those that do not end the sequence.
    pub fn to_accuracy(
        scene: Scene,
        options: &Options,
        goal: &Goal,
        work: &Work<'_>,
    ) -> Result<Self, Failure> {
        let adaptation = Adaptation::new(goal, work, None);
        if options.method == LightMethod::Hierarchical {
            return by_links(scene, options, &adaptation);
        }
        let made = OnceLock::new();
        let visibility = || made.get_or_init(|| options.visibility(&scene));
        let choose = || TransportChoice::of(&scene, options, None, visibility);
        let choice = options.in_threads(work.ranks, choose)?;
        if is_by_rays(&scene, options, goal, &choice) {
            return by_rays(scene, options, &adaptation);
        }
        let why = if choice.sampled { NO_ERROR_OF_ELEMENTS } else { &choice.why };
        let exactly = Adaptation::new(goal, work, Some(why));
        match goal.of {
            Aim::Solution => {
                let visibility = visibility();
                by_rungs(scene, options, visibility, &exactly)
            }
            Aim::Gathered | Aim::Points | Aim::Seen => locally(scene, options, &exactly),
        }
    }
}

/// Whether rays carry the pairs: where polynomials are the goal, in small scenes only if they are asked for,
/// because their own error tells nothing of that of elements.
fn is_by_rays(scene: &Scene, options: &Options, goal: &Goal, choice: &TransportChoice) -> bool {
    let is_asked_for = options.transport == Transport::Sampled || options.rays.is_some();
    choice.sampled && (goal.of != Aim::Solution || is_asked_for || scene.surfaces.len() > FEW)
}
