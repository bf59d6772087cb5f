//! About the seconds that readings take two threads, from counts alone, as those of transfers are told
//! ([`radiosity_solve::driver::cost`]):
//!
//! ```text
//! ¼ seconds to gather the light of all .
//! ```

use radiosity_solve::solved::Solved;
use radiosity_work::{Progress, Stage, Work};

use crate::quality::ReadSettings;
use crate::reader::ReadMode;

/// Part of the time of one core for each point: two threads share them, and points beside each other what is
/// around them. Measured: a grid and a picture of the Cornell box.
const SHARED: f64 = 0.25;

/// Tells about how long so many readings of a stage take.
pub fn tell_readings(
    solved: &Solved,
    settings: &ReadSettings,
    readings: usize,
    stage: Stage,
    work: &Work<'_>,
) {
    let seconds = seconds_to_read(solved, settings, readings as f64);
    work.report(Progress::Expected { stage, seconds });
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
