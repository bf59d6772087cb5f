//! The forecast of a solution, for people who choose how to solve: its elements are cut, and nothing else is made.

use radiosity_scene::Scene;
use radiosity_work::Work;

use super::cut_scene::CutScene;
use super::decisions::AssemblyPlan;
use super::direct_price::seconds_of_direct;
use super::failure::Failure;
use super::options::Options;

/// The forecast of a solution, by counts of its elements, pairs and rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunForecast {
    /// Rays that carry the light between surfaces; None where rules do.
    pub rays: Option<u64>,
    /// Elements that its surfaces are cut into.
    pub elements: usize,
    /// Unknowns of each band.
    pub unknowns: usize,
    /// The forecast of its direct light and transfers: seconds of [`radiosity_work::FORECAST_THREADS`] threads of the
    /// machine of the prices, which [`radiosity_work::Machine::seconds`] makes those of this one.
    pub seconds: f64,
    /// Bytes that it takes at the most, on each rank.
    pub bytes: u64,
}

impl RunForecast {
    /// The forecasts of solutions of `scene` in these ways, whatever memory they are allowed; its obstacles are found
    /// once.
    ///
    /// # Errors
    /// Options that the scene does not allow, or a scene that cannot be cut into elements.
    pub fn all(scene: &Scene, ways: &[Options], work: &Work<'_>) -> Result<Vec<Self>, Failure> {
        let mut visibility = None;
        let mut of = |options: &Options| {
            let options = Options { memory: None, ..*options };
            let plan = AssemblyPlan { visibility: visibility.take(), ..AssemblyPlan::default() };
            let cut =
                options.in_threads(work.ranks, || CutScene::of(scene, &options, plan, None, work))??;
            let forecast = Self::of(&cut, work);
            visibility = Some(cut.visibility);
            Ok(forecast)
        };
        ways.iter().map(&mut of).collect()
    }

    fn of(cut: &CutScene, work: &Work<'_>) -> Self {
        let emissions = cut.emissions();
        let direct = seconds_of_direct(&cut.lit_scene(work.ranks), &emissions, cut.direct_way(&emissions));
        Self {
            rays: cut.rays,
            elements: cut.elements.list().len(),
            unknowns: cut.unknowns(),
            seconds: direct + cut.seconds_of_pairs(work),
            bytes: cut.bytes.unwrap_or_default(),
        }
    }
}
