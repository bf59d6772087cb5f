//! Flat surfaces and the scenes, elements and blocks made of them.

use std::fmt::Write;

use radiosity::elements::{Discretization, ElementError, Elements};
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::scene::{Scene, SceneError, Source};
use radiosity::visibility::Visibility;
use radiosity_geom::DVec3;
use radiosity_test_support::solved::blocks_of;

/// A flat surface: its outline as a scene file has it, and the side that is its front.
#[derive(Clone, Debug)]
pub(crate) struct Flat {
    pub(crate) outline: Outline,
    /// Normal of the front, of any length.
    pub(crate) front: DVec3,
    /// Elements along u and v.
    pub(crate) cells: [usize; 2],
}

/// The shapes that a scene file offers.
#[derive(Clone, Debug)]
pub(crate) enum Outline {
    Parallelogram { origin: DVec3, edges: [DVec3; 2] },
    Quad([DVec3; 4]),
    Triangle([DVec3; 3]),
    Polygon { outer: Vec<DVec3>, holes: Vec<Vec<DVec3>> },
}

impl Outline {
    /// All loops, the outer one first.
    pub(crate) fn loops(&self) -> Vec<Vec<DVec3>> {
        match self {
            Self::Parallelogram { origin, edges: [a, b] } => {
                vec![vec![*origin, origin + a, origin + a + b, origin + b]]
            }
            Self::Quad(corners) => vec![corners.to_vec()],
            Self::Triangle(corners) => vec![corners.to_vec()],
            Self::Polygon { outer, holes } => std::iter::once(outer).chain(holes).cloned().collect(),
        }
    }

    /// The outline under a map that keeps straight lines.
    pub(crate) fn map(&self, f: impl Fn(DVec3) -> DVec3) -> Self {
        match self {
            Self::Parallelogram { origin, edges } => {
                Self::Parallelogram { origin: f(*origin), edges: edges.map(|e| f(origin + e) - f(*origin)) }
            }
            Self::Quad(corners) => Self::Quad(corners.map(f)),
            Self::Triangle(corners) => Self::Triangle(corners.map(f)),
            Self::Polygon { outer, holes } => Self::Polygon {
                outer: outer.iter().map(|p| f(*p)).collect(),
                holes: holes.iter().map(|hole| hole.iter().map(|p| f(*p)).collect()).collect(),
            },
        }
    }

    /// Twice the vector area of the outer loop.
    pub(crate) fn normal(&self) -> DVec3 {
        let outer = &self.loops()[0];
        let next = outer.iter().cycle().skip(1);
        outer.iter().zip(next).map(|(p, q)| (p - outer[0]).cross(q - outer[0])).sum()
    }

    fn text(&self) -> String {
        let list =
            |points: &[DVec3]| format!("{:?}", points.iter().map(|p| p.to_array()).collect::<Vec<_>>());
        match self {
            Self::Parallelogram { origin, edges: [a, b] } => format!(
                "parallelogram = {{ origin = {:?}, edge1 = {:?}, edge2 = {:?} }}",
                origin.to_array(),
                a.to_array(),
                b.to_array()
            ),
            Self::Quad(corners) => format!("quad = {{ vertices = {} }}", list(corners)),
            Self::Triangle(corners) => format!("triangle = {{ vertices = {} }}", list(corners)),
            Self::Polygon { outer, holes } => {
                let holes: Vec<String> = holes.iter().map(|hole| list(hole)).collect();
                format!("polygon = {{ vertices = {}, holes = [{}] }}", list(outer), holes.join(", "))
            }
        }
    }
}

impl Flat {
    /// The whole outline as one element, its front where the outline runs counter-clockwise.
    pub(crate) fn new(outline: Outline) -> Self {
        Self { front: outline.normal(), outline, cells: [1, 1] }
    }

    /// The surface of an outline with its front on the side of `front`.
    pub(crate) fn facing(outline: Outline, front: DVec3) -> Self {
        Self { front, ..Self::new(outline) }
    }

    /// The surface under a similarity that keeps orientation.
    pub(crate) fn map(&self, f: impl Fn(DVec3) -> DVec3) -> Self {
        let tip = f(self.front) - f(DVec3::ZERO);
        Self { outline: self.outline.map(f), front: tip, cells: self.cells }
    }
}

/// The scene of some surfaces; they are black, coatings are the test's affair.
pub(crate) fn scene(surfaces: &[Flat]) -> Result<Scene, SceneError> {
    let mut text = String::from("bands = [\"grey\"]\n");
    for Flat { outline, front, cells } in surfaces {
        let flip = outline.normal().dot(*front) < 0.0;
        writeln!(text, "[[surfaces]]\nflip = {flip}\nsubdivide = {cells:?}\n{}", outline.text())
            .expect("a string takes all");
    }
    radiosity::language::read(&Source::new("test", &text))
}

/// The elements of a scene at one order.
pub(crate) fn elements(scene: &Scene, order: usize) -> Result<Elements, ElementError> {
    Elements::new(scene, &Discretization::uniform(order, 1))
}

/// Blocks without shadows.
pub(crate) fn blocks(scene: &Scene, elements: &Elements, eps: f64) -> Blocks {
    let visibility = Visibility::open(scene);
    blocks_of(elements, &visibility, Accuracy { eps, shadow_eps: 3e-3 })
}

/// G from element `row` to element `column`, row-major; None where it is left out as zero.
pub(crate) fn block(blocks: &Blocks, row: usize, column: usize) -> Option<Vec<f64>> {
    let stored = |i, j| {
        let found = blocks.iter().find(|block| (block.row, block.column) == (i, j));
        found.map(|block| block.values)
    };
    if row <= column {
        return stored(row, column).map(|values| values.into_owned());
    }
    let values = stored(column, row)?;
    let columns = blocks.starts()[row + 1] - blocks.starts()[row];
    Some((0..columns).flat_map(|k| values.iter().skip(k).step_by(columns).copied()).collect())
}
