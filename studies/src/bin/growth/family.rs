//! A family of scenes that grow, and what is measured of each.

use cpu_time::ProcessTime;
use radiosity::scene::{Scene, Source};
use radiosity::solve::view_factors::Options;
use radiosity::visibility::{Shadows, Visibility};
use radiosity::{ViewFactors, Work, language};

/// Shorter times count as this long (s): two clocks of a system tell less apart.
pub(crate) const LEAST: f64 = 1e-3;

/// Scenes of one kind, from small to large.
pub(crate) struct Family {
    pub(crate) name: &'static str,
    /// The parts of the work that are timed.
    pub(crate) stages: &'static [&'static str],
    /// About so many surfaces have the scenes.
    pub(crate) sizes: &'static [usize],
    /// Makes the scene of a size and times its stages.
    pub(crate) measure: fn(usize) -> Row,
}

/// The times of one scene.
pub(crate) struct Row {
    pub(crate) surfaces: usize,
    /// Processor time of each stage (s).
    pub(crate) seconds: Vec<f64>,
}

impl Row {
    /// The power of the number of surfaces by which the time of a stage grows to the row `larger`.
    pub(crate) fn exponent(&self, larger: &Self, stage: usize) -> f64 {
        let [own, other] = [self, larger].map(|row| row.seconds[stage].max(LEAST));
        (other / own).ln() / (larger.surfaces as f64 / self.surfaces as f64).ln()
    }
}

/// Makes what a stage makes; its time is appended to `seconds`.
pub(crate) fn timed<T>(seconds: &mut Vec<f64>, stage: impl FnOnce() -> T) -> T {
    let start = ProcessTime::now();
    let made = stage();
    seconds.push(start.elapsed().as_secs_f64());
    made
}

/// Reads the text of a scene; the time is appended to `seconds`.
pub(crate) fn read(seconds: &mut Vec<f64>, text: &str) -> Scene {
    timed(seconds, || language::read(&Source::new("scene", text)).expect("the scene is sound"))
}

/// The stages of [`of_factors`].
pub(crate) const FACTOR_STAGES: &[&str] = &["read", "obstacles", "view factors"];

/// Times of the view factors of a scene; "view factors" is all that follows reading, obstacles once more.
pub(crate) fn of_factors(text: &str) -> Row {
    let mut seconds = Vec::new();
    let scene = read(&mut seconds, text);
    let accuracy = radiosity::Options::default().accuracy();
    let options = Options { accuracy, threads: 1, ..Options::default() };
    timed(&mut seconds, || Visibility::new(&scene, Shadows::Auto, accuracy.shadow_eps));
    let factors = timed(&mut seconds, || ViewFactors::new(&scene, &options, &Work::alone()));
    factors.expect("all surfaces have area");
    Row { surfaces: scene.surfaces.len(), seconds }
}
