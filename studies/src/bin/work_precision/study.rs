//! The scenes, the runs that are tried on each, and what their errors are measured against.

use radiosity::elements::cells::Layers;
use radiosity::published::zatz1993::transfers::{HybridReading, PaperRules};
use radiosity::scene::{Scene, Source};
use radiosity::solve::{Direct, Options};

/// A unit sphere under a square lamp that reflects nothing: the irradiance of the sphere is Lambert's form.
const LIT_SPHERE: &str = "bands = [\"grey\"]
materials = { white = { reflectance = 0.5 }, lamp = { reflectance = 0, emission = 1 } }
[[surfaces]]
name = \"sphere\"
material = \"white\"
sphere = { center = [0, 0, 0], radius = 1 }
[[surfaces]]
name = \"lamp\"
material = \"lamp\"
order = 0
subdivide = [1, 1]
quad = { vertices = [[-2, -2, 3], [-2, 2, 3], [2, 2, 3], [2, -2, 3]] }
";

/// The kernel rules of the transfers, and the light that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kernel {
    /// This library's rules; the polynomials alone are read.
    Default,
    /// This library's rules; light gathered anew is read.
    Gathered,
    /// Gauss rules for all pairs, as in 1993.
    Legendre,
    /// The hybrid of 1993 at common edges.
    Hybrid,
}

impl Kernel {
    /// Name of the kernel in the CSV.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Default => "default",
            Self::Gathered => "gathered",
            Self::Legendre => "paper-legendre",
            Self::Hybrid => "paper-hybrid",
        }
    }

    fn rules(self) -> Option<PaperRules> {
        match self {
            Self::Default | Self::Gathered => None,
            Self::Legendre => Some(PaperRules::Legendre),
            Self::Hybrid => Some(PaperRules::Hybrid(HybridReading::H1)),
        }
    }
}

/// A run to be made.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    /// Rules of the transfers.
    pub(crate) kernel: Kernel,
    /// Degree of the polynomials.
    pub(crate) order: usize,
    /// Layers of graded elements.
    pub(crate) layers: usize,
    /// Cuts along each side of a surface; 0 where the scene chooses.
    pub(crate) cells: usize,
    /// Accuracy of the transfers.
    pub(crate) eps: f64,
}

impl Trial {
    /// Options of the run, on one thread. Direct light is projected on the polynomials unless light is
    /// gathered.
    pub(crate) fn options(&self) -> Options {
        Options {
            order: self.order,
            layers: Layers { count: self.layers, ..Layers::NONE },
            subdivide: (self.cells > 0).then_some(self.cells),
            eps: self.eps,
            kernel: self.kernel.rules(),
            direct: if self.kernel == Kernel::Gathered { Direct::Auto } else { Direct::Projected },
            threads: 1,
            ..Options::default()
        }
    }
}

/// The truth that errors are measured against.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Judge {
    /// A finer run; all surfaces.
    Finest(Trial),
    /// Lambert's form on the first surface under the second.
    ClosedForm,
    /// Path-traced means over 16 × 16 cells of floor and back wall.
    PathTracing,
}

/// A scene with its runs.
pub(crate) struct Study {
    /// Name of the study in the CSV.
    pub(crate) name: &'static str,
    /// Name of the study in the diagram.
    pub(crate) title: &'static str,
    /// The scene that is solved.
    pub(crate) scene: Scene,
    /// The truth that errors are measured against.
    pub(crate) judge: Judge,
    /// The runs to be made.
    pub(crate) trials: Vec<Trial>,
}

/// All of them.
pub(crate) fn studies() -> Vec<Study> {
    let study = |name, title, scene, judge, trials| Study { name, title, scene, judge, trials };
    let builtin = |name| radiosity::builtin(name).expect("it is built in");
    let bright = radiosity::language::source("empty-box", &[("reflectance", 0.8)])
        .and_then(|source| radiosity::language::read(&source))
        .expect("it is built in");
    let sphere = radiosity::language::read(&Source::new("lit-sphere", LIT_SPHERE)).expect("it is valid");
    let closed = Judge::Finest(Trial { layers: 2, ..run(8, 1, 1e-7) });
    // Sharper than the runs it judges, as far as minutes go.
    let shadowed = |order, cells, eps| Judge::Finest(run(order, cells, eps));
    vec![
        study("box-a", "empty box, ρ = 0.5", builtin("empty-box"), closed, empty_box()),
        study("box-b", "empty box, ρ = 0.8", bright, closed, empty_box()),
        study("lit-sphere", "sphere under a square lamp", sphere, Judge::ClosedForm, curved()),
        study("two-boxes", "room with two boxes", builtin("two-boxes"), shadowed(6, 4, 1e-4), room()),
        study(
            "cornell-box",
            "Cornell box, polynomials",
            builtin("cornell-box"),
            shadowed(6, 4, 1e-4),
            room(),
        ),
        study("cornell-cells", "Cornell box, cells", builtin("cornell-box"), Judge::PathTracing, cells()),
        study("teapot", "teapot", builtin("teapot"), shadowed(4, 1, 3e-4), teapot()),
    ]
}

fn run(order: usize, cells: usize, eps: f64) -> Trial {
    Trial { kernel: Kernel::Default, order, layers: 0, cells, eps }
}

/// Constant elements on ever finer cuts: classical radiosity.
fn constants(cuts: &[usize]) -> impl Iterator<Item = Trial> {
    cuts.iter().map(|cells| run(0, *cells, 1e-3))
}

/// The rules of 1993 on whole surfaces and on quarters.
fn paper(highest: usize) -> impl Iterator<Item = Trial> {
    let kernels = [Kernel::Legendre, Kernel::Hybrid];
    kernels.into_iter().flat_map(move |kernel| {
        [1, 2].into_iter().flat_map(move |cells| {
            (0..=highest).map(move |order| Trial { kernel, ..run(order, cells, 1e-3) })
        })
    })
}

fn empty_box() -> Vec<Trial> {
    let layers = |layers, orders: std::ops::RangeInclusive<usize>, eps| {
        orders.map(move |order| Trial { layers, ..run(order, 1, eps) })
    };
    constants(&[1, 2, 4, 8, 16, 24])
        .chain((1..=5).map(|order| run(order, 1, 1e-2)))
        .chain(layers(0, 1..=10, 1e-3))
        .chain(layers(1, 1..=8, 1e-3))
        .chain(layers(2, 2..=7, 1e-4))
        .chain((1..=5).map(|order| run(order, 2, 1e-3)))
        .chain((1..=4).map(|order| run(order, 4, 1e-3)))
        .chain((1..=2).map(|order| run(order, 8, 1e-3)))
        .chain(paper(7))
        .collect()
}

fn curved() -> Vec<Trial> {
    let both = |cells, orders: std::ops::RangeInclusive<usize>| {
        [1e-4, 1e-6].into_iter().flat_map(move |eps| orders.clone().map(move |order| run(order, cells, eps)))
    };
    constants(&[1, 2, 4, 8, 16, 24])
        .chain((1..=10).map(|order| run(order, 1, 1e-3)))
        .chain(both(2, 1..=8))
        .chain(both(4, 1..=6))
        .chain(paper(7))
        .collect()
}

fn room() -> Vec<Trial> {
    constants(&[1, 2, 4, 8])
        .chain((1..=4).map(|order| run(order, 1, 1e-2)))
        .chain((1..=6).map(|order| run(order, 1, 1e-3)))
        .chain((1..=4).map(|order| run(order, 2, 1e-3)))
        .chain((1..=3).map(|order| run(order, 4, 1e-3)))
        .chain((2..=3).map(|order| Trial { layers: 1, ..run(order, 1, 1e-3) }))
        .collect()
}

fn cells() -> Vec<Trial> {
    let gathered = |order, eps| Trial { kernel: Kernel::Gathered, ..run(order, 0, eps) };
    constants(&[1, 2, 4, 8])
        .chain((1..=4).map(|order| run(order, 2, 1e-3)))
        .chain([gathered(1, 3e-2), gathered(2, 3e-2)])
        .chain((0..=4).map(|order| gathered(order, 1e-3)))
        .collect()
}

fn teapot() -> Vec<Trial> {
    constants(&[1]).chain((1..=3).map(|order| run(order, 1, 1e-3))).collect()
}
