//! Error against time of exact blocks, of rays, and of rays beside exact blocks of the strong pairs.
//!
//! All on the same elements; the truth are exact blocks at 1e-5. The error is relative L2 of the mean
//! irradiances of the elements, the time that of blocks and solution.

use std::error::Error;
use std::path::Path;
use std::time::Instant;

use radiosity::Scene;
use radiosity::elements::coating::Coating;
use radiosity::elements::{Discretization, Elements};
use radiosity::output::drawings::diagram::Panel;
use radiosity::solve::system::{Coefficients, System};
use radiosity::solvers::Settings;
use radiosity::solvers::method::Method;
use radiosity::visibility::{Shadows, Visibility};
use radiosity::work::ranks::Ranks;
use radiosity::{
    Work,
    kernel::{Accuracy, Blocks},
    transport::{Demand, Rays, SampledTransport, assemble},
};

use crate::apart::{apart, means};
use crate::diagram::{self, Line};

const SCENES: [&str; 2] = ["cornell-box", "two-boxes"];

/// Accuracies of the exact blocks, and of the truth.
const ACCURACIES: [f64; 6] = [3e-1, 1e-1, 3e-2, 1e-2, 3e-3, 1e-3];
const TRUE: f64 = 1e-5;

/// Rays in all.
const RAYS: [u64; 7] = [6_250, 25_000, 100_000, 400_000, 1_600_000, 6_400_000, 25_600_000];

/// Share of the rays in the pilot round, and weight of brightness against area in the next: those of
/// `radiosity::solve`.
const PILOT: f64 = 0.1;
const BRIGHTNESS: f64 = 0.3;

/// Accuracy of exact pairs in multiples of n^-½ for n rays: that of `radiosity::solve`.
const EXACT: f64 = 5.0;

/// A way to carry the pairs.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    Exact,
    Rays,
    Both,
}

impl Way {
    const ALL: [Self; 3] = [Self::Exact, Self::Rays, Self::Both];

    fn label(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::Rays => "rays",
            Self::Both => "rays and exact pairs",
        }
    }
}

/// A run, its time and its error.
#[derive(Clone, Copy, Debug)]
struct Run {
    way: Way,
    /// Number of pairs that were carried exactly beside rays.
    exact_pairs: usize,
    seconds: f64,
    error: f64,
}

/// All pairs, carried.
struct Carried {
    blocks: Blocks,
    /// Number of pairs that were carried exactly beside rays.
    exact_pairs: usize,
}

/// A scene cut into elements.
struct Subject {
    elements: Elements,
    coating: Coating,
    visibility: Visibility,
    truth: Coefficients,
}

/// Prints the table, and draws it.
pub(crate) fn sooner(file: &Path) -> Result<(), Box<dyn Error>> {
    println!("| scene | way | accuracy or rays | exact pairs | seconds | error |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let mut panels = Vec::new();
    for name in SCENES {
        let subject = Subject::new(&radiosity::builtin(name)?)?;
        let mut runs = Vec::new();
        for accuracy in ACCURACIES {
            let run =
                subject.run(Way::Exact, || Carried { blocks: subject.exact(accuracy), exact_pairs: 0 })?;
            runs.push(tell(name, &format!("{accuracy:.0e}"), run));
        }
        for (way, rays) in [Way::Rays, Way::Both].iter().flat_map(|way| RAYS.map(|rays| (*way, rays))) {
            let run = subject.run(way, || subject.sampled(way, rays))?;
            runs.push(tell(name, &rays.to_string(), run));
        }
        panels.push(panel(name, &runs));
    }
    diagram::write(file, "errors of mean irradiances", panels)
}

/// A line for each way.
fn panel(name: &str, runs: &[Run]) -> Panel {
    let line = |way: Way| {
        let own = runs.iter().filter(|run| run.way == way);
        Line { label: way.label().to_owned(), places: own.map(|run| (run.seconds, run.error)).collect() }
    };
    diagram::panel(name, "relative error", Way::ALL.map(line))
}

fn tell(name: &str, what: &str, run: Run) -> Run {
    let Run { way, exact_pairs, seconds, error } = run;
    println!("| {name} | {} | {what} | {exact_pairs} | {seconds:.3} | {:.3} % |", way.label(), 100.0 * error);
    run
}

impl Subject {
    fn new(scene: &Scene) -> Result<Self, Box<dyn Error>> {
        let visibility = Visibility::new(scene, Shadows::Auto, TRUE);
        let elements = Elements::new(scene, &Discretization::uniform(2, 2))?;
        let coating = Coating::of(scene, elements.list(), 0);
        let blocks = assemble(
            Demand::all(&elements, &visibility, Accuracy { eps: TRUE, shadow_eps: TRUE }),
            None,
            &Work::alone(),
        );
        let truth = solved(&elements, &coating, &blocks)?;
        Ok(Self { elements, coating, visibility, truth })
    }

    /// A run with the blocks that `carry` gives.
    fn run(&self, way: Way, carry: impl FnOnce() -> Carried) -> Result<Run, Box<dyn Error>> {
        let start = Instant::now();
        let Carried { blocks, exact_pairs } = carry();
        let found = solved(&self.elements, &self.coating, &blocks)?;
        let seconds = start.elapsed().as_secs_f64();
        let list = self.elements.list();
        let [found, truth] = [&found, &self.truth].map(|of| means(list, &of.irradiance));
        Ok(Run { way, exact_pairs, seconds, error: apart(list, &found, &truth) })
    }

    fn exact(&self, accuracy: f64) -> Blocks {
        let accuracy = Accuracy { eps: accuracy, shadow_eps: accuracy };
        assemble(Demand::all(&self.elements, &self.visibility, accuracy), None, &Work::alone())
    }

    fn sampled(&self, way: Way, rays: u64) -> Carried {
        let list = self.elements.list();
        let bright = means(list, &self.truth.radiosity);
        let area: f64 = list.iter().map(|element| element.area).sum();
        let power: f64 = list.iter().zip(&bright).map(|(element, b)| element.area * b).sum();
        let weights: Vec<f64> = list
            .iter()
            .zip(&bright)
            .map(|(element, b)| element.area / area + BRIGHTNESS * element.area * b / power)
            .collect();
        let plan = |rays: f64| -> Vec<u64> {
            weights.iter().map(|weight| (rays * weight / (1.0 + BRIGHTNESS)).ceil() as u64).collect()
        };
        let mut transport = SampledTransport::new(&self.elements, &self.visibility, Ranks::alone());
        transport.send(&plan(PILOT * rays as f64), &mut |_| true);
        let planned = plan((1.0 - PILOT) * rays as f64);
        if way == Way::Both {
            let accuracy = EXACT / (rays as f64).sqrt();
            let accuracy = Accuracy { eps: accuracy, shadow_eps: accuracy };
            transport.settle(&planned, accuracy, &Work::alone());
        }
        transport.send(&planned, &mut |_| true);
        Carried { blocks: transport.blocks(Rays::All), exact_pairs: transport.exact_pairs() }
    }
}

fn solved(elements: &Elements, coating: &Coating, blocks: &Blocks) -> Result<Coefficients, Box<dyn Error>> {
    let system = System::new(elements.list(), blocks, coating);
    let right = system.right_hand_side();
    let mut unknowns = vec![0.0; right.len()];
    let settings = Settings::default();
    let operator = system.operator(&Method::AUTO, 1, settings.threads)?;
    Method::AUTO.solver.solve(&*operator, &right, &mut unknowns, &settings, &mut |_| ())?;
    Ok(system.coefficients(&unknowns))
}
