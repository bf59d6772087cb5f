//! About the seconds that readings take two threads, from counts alone, as those of transfers are told
//! ([`radiosity_solve::driver::cost`]):
//!
//! ```text
//! ¼ seconds to gather the light of all .
//! ```

use radiosity_scene::Scene;
use radiosity_solve::solved::Solved;
use radiosity_work::{Progress, Stage, Work};

use crate::quality::ReadSettings;
use crate::reader::ReadMode;

/// Part of the time of one core for each point: two threads share them, and points beside each other what is
/// around them. Measured: a grid and a picture of the Cornell box.
const SHARED: f64 = 0.25;

/// Readings take longer than their price by this power of the number of surfaces over those of a box, and by so
/// many times the part of them that are curved: rays are slower there, and more go on from dark places.
/// Measured on ten scenes.
const MORE_SURFACES: f64 = 0.4;
const BOX: f64 = 16.0;
const CURVED: f64 = 5.5;

/// Most curved surfaces that count, as many as were measured: of more, most stand aside.
const MOST_CURVED: usize = 32;

/// Time of a reading that has none beside it, over that of one of many.
const APART: f64 = 2.0;

/// Tells about how long so many readings of a stage take, which are beside each other or spread over the scene.
pub fn tell_readings(
    solved: &Solved,
    settings: &ReadSettings,
    readings: usize,
    are_apart: bool,
    stage: Stage,
    work: &Work<'_>,
) {
    let apart = if are_apart { APART } else { 1.0 };
    let seconds = apart * longer(&solved.scene) * seconds_to_read(solved, settings, readings as f64);
    work.report(Progress::Expected { stage, seconds });
}

/// Time of readings in a scene over their price.
fn longer(scene: &Scene) -> f64 {
    let surfaces = scene.surfaces.len() as f64;
    let curved = scene.surfaces.iter().filter(|surface| surface.shape.region().is_none()).count();
    let curved = curved.min(MOST_CURVED) as f64;
    (surfaces / BOX).max(1.0).powf(MORE_SURFACES) * (1.0 + CURVED * curved / surfaces)
}

/// Seconds to read so many points or cells with `settings`, whose points share what is found of their
/// surroundings; 0 where that takes no gathering.
pub fn seconds_to_read(solved: &Solved, settings: &ReadSettings, points: f64) -> f64 {
    match settings.read {
        ReadMode::Basis | ReadMode::Direct => 0.0,
        ReadMode::Gather | ReadMode::GatherTwice => {
            let (solution, visibility) = (&solved.outcome.solution, solved.visibility());
            let twice = settings.read == ReadMode::GatherTwice;
            let in_gaps = settings.by.seconds_in_gaps(solution, visibility, settings.eps, points);
            let usual = settings.by.seconds_of_readings(solution, visibility, settings.eps, points, twice);
            SHARED * usual + in_gaps
        }
    }
}
