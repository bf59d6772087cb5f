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
const MOST_CURVED: f64 = 32.0;

/// Time of readings that are spread over the scene over their price: in a box, the power of the number of surfaces over
/// those of a box, and the number of curved ones, or more, among which they take twice as long: what is read in the
/// dark is read anew by walks. Measured on ten scenes of 16 to 10 468 surfaces: 0.4 to 2 times as long.
const APART: f64 = 8.0;
const APART_AMONG_MORE: f64 = 0.25;
const MANY_CURVED: f64 = 100.0;

/// Tells about how long so many readings of a stage take, which are beside each other or spread over the scene.
pub fn tell_readings(
    solved: &Solved,
    settings: &ReadSettings,
    readings: usize,
    are_apart: bool,
    stage: Stage,
    work: &Work<'_>,
) {
    let longer = if are_apart { longer_apart } else { longer };
    let seconds = longer(&solved.scene) * seconds_to_read(solved, settings, readings as f64);
    work.report(Progress::Expected { stage, seconds });
}

/// Time of readings beside each other in a scene over their price.
fn longer(scene: &Scene) -> f64 {
    let curved = curved(scene).min(MOST_CURVED);
    boxes(scene).powf(MORE_SURFACES) * (1.0 + CURVED * curved / scene.surfaces.len() as f64)
}

/// Time of readings that are spread over a scene over their price.
fn longer_apart(scene: &Scene) -> f64 {
    APART * boxes(scene).powf(APART_AMONG_MORE) * (1.0 + (curved(scene) / MANY_CURVED).min(1.0))
}

/// Surfaces of a scene over those of a box, at least 1.
fn boxes(scene: &Scene) -> f64 {
    (scene.surfaces.len() as f64 / BOX).max(1.0)
}

/// Curved surfaces of a scene.
fn curved(scene: &Scene) -> f64 {
    scene.surfaces.iter().filter(|surface| surface.shape.region().is_none()).count() as f64
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
