//! Meshes: for each surface of a scene a tree of cells and the order of the polynomials on each.
//!
//! A cell is a rectangle of the parameters (u, v) ∈ [−1, 1]². A [`Tree`] cuts it across u or v at some place
//! into two, or leaves it whole. Leaves are numbered in the order of the tree, the part of lower parameters
//! first.

use std::convert::Infallible;

use radiosity_geom::Rect;
use serde::{Deserialize, Serialize};

use super::basis::HIGHEST_ORDER;

/// Narrowest cell that is cut (parameters), into halves of 2.5·10⁻⁷ of the surface: refinement at a corner of
/// light ends there. Narrower cells carry nothing.
const NARROWEST: f64 = 1e-6;

/// Most cuts one within the other of a mesh that is read: more than [`NARROWEST`] allows of halves of both
/// parameters.
const DEEPEST: usize = 64;

/// The cells of a surface, each with a value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Tree<T> {
    /// A whole cell.
    Leaf(T),
    /// A cell that is cut in two.
    Cut(Box<Halves<T>>),
}

/// A cell that is cut in two.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Halves<T> {
    /// The parameter that the cut fixes.
    across: Axis,
    /// Value of that parameter at the cut.
    at: f64,
    /// The parts of lower and of higher values.
    parts: [Tree<T>; 2],
}

/// A parameter of a surface, u or v.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// The first parameter, u.
    U,
    /// The second parameter, v.
    V,
}

/// Change of a cell when a mesh is refined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CellRefinement {
    /// The cell stays as it is.
    Keep,
    /// The order of the cell rises by this, to the highest at the most.
    Raise(usize),
    /// The cell is cut at the middles of both parameters, or of this one.
    Cut(Option<Axis>),
}

impl Axis {
    fn of(self, rect: &Rect) -> [f64; 2] {
        match self {
            Self::U => rect.u,
            Self::V => rect.v,
        }
    }

    fn with(self, rect: &Rect, range: [f64; 2]) -> Rect {
        match self {
            Self::U => Rect { u: range, ..*rect },
            Self::V => Rect { v: range, ..*rect },
        }
    }
}

impl<T> Tree<T> {
    /// The leaf that holds the parameters (u, v); a cut belongs to the part above it.
    pub(crate) fn at(&self, [u, v]: [f64; 2]) -> &T {
        match self {
            Self::Leaf(value) => value,
            Self::Cut(halves) => {
                let x = match halves.across {
                    Axis::U => u,
                    Axis::V => v,
                };
                halves.parts[usize::from(x >= halves.at)].at([u, v])
            }
        }
    }

    /// The values of the leaves in order.
    pub fn values(&self) -> Vec<&T> {
        match self {
            Self::Leaf(value) => vec![value],
            Self::Cut(halves) => halves.parts.iter().flat_map(Self::values).collect(),
        }
    }

    /// These cells with other values, of each rectangle inside `rect` and its value.
    ///
    /// # Errors
    /// The first error of `value`.
    pub fn map<U, E>(
        &self,
        rect: &Rect,
        value: &mut impl FnMut(&Rect, &T) -> Result<U, E>,
    ) -> Result<Tree<U>, E> {
        self.replaced(rect, &mut |rect, own| value(rect, own).map(Tree::Leaf))
    }

    /// Each leaf replaced by a tree.
    fn replaced<U, E>(
        &self,
        rect: &Rect,
        tree: &mut impl FnMut(&Rect, &T) -> Result<Tree<U>, E>,
    ) -> Result<Tree<U>, E> {
        let halves = match self {
            Self::Leaf(value) => return tree(rect, value),
            Self::Cut(halves) => halves,
        };
        let Halves { across, at, parts: [low, high] } = halves.as_ref();
        let [start, end] = across.of(rect);
        let low = low.replaced(&across.with(rect, [start, *at]), tree)?;
        let high = high.replaced(&across.with(rect, [*at, end]), tree)?;
        Ok(Tree::Cut(Box::new(Halves { across: *across, at: *at, parts: [low, high] })))
    }

    /// Whether every cut lies inside its `rect`, and no more than `depth` within each other.
    fn is_valid(&self, rect: &Rect, depth: usize) -> bool {
        let halves = match self {
            Self::Leaf(_) => return true,
            Self::Cut(halves) => halves,
        };
        let Halves { across, at, parts: [low, high] } = halves.as_ref();
        let [start, end] = across.of(rect);
        depth > 0
            && *at > start
            && *at < end
            && low.is_valid(&across.with(rect, [start, *at]), depth - 1)
            && high.is_valid(&across.with(rect, [*at, end]), depth - 1)
    }
}

impl<T: Copy> Tree<T> {
    /// The cells between `breaks` of u and of v, which ascend from −1 to 1; those of v run fastest.
    pub(crate) fn grid([u, v]: &[Vec<f64>; 2], value: T) -> Self {
        let columns = Self::between(Axis::V, v, &Self::Leaf(value));
        Self::between(Axis::U, u, &columns)
    }

    fn between(across: Axis, breaks: &[f64], each: &Self) -> Self {
        let intervals = breaks.len() - 1;
        if intervals == 1 {
            return each.clone();
        }
        let middle = intervals / 2;
        let parts = [&breaks[..=middle], &breaks[middle..]].map(|part| Self::between(across, part, each));
        Self::Cut(Box::new(Halves { across, at: breaks[middle], parts }))
    }

    /// The cells of `rect`: cut as `cut` says of it and of what comes of that, as long as it says so.
    pub fn cut_while(rect: &Rect, value: T, cut: &dyn Fn(&Rect) -> CellRefinement) -> Self {
        let CellRefinement::Cut(across) = cut(rect) else { return Self::Leaf(value) };
        match Self::halved(rect, across, value) {
            whole @ Self::Leaf(_) => whole,
            parts => {
                let part = |rect: &Rect, value: &T| Ok::<_, Infallible>(Self::cut_while(rect, *value, cut));
                parts.replaced(rect, &mut { part }).unwrap_or_else(|never| match never {})
            }
        }
    }

    /// A cell of the rectangle `rect`, cut at the middles of both parameters or of one.
    fn halved(rect: &Rect, across: Option<Axis>, value: T) -> Self {
        let both = [Axis::U, Axis::V];
        let axes: &[Axis] = match across {
            None => &both,
            Some(Axis::U) => &both[..1],
            Some(Axis::V) => &both[1..],
        };
        axes.iter().rev().fold(Self::Leaf(value), |each, axis| {
            let [start, end] = axis.of(rect);
            if end - start < NARROWEST {
                return each;
            }
            let parts = [each.clone(), each];
            Self::Cut(Box::new(Halves { across: *axis, at: 0.5 * (start + end), parts }))
        })
    }
}

/// Cells and orders of all surfaces of a scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Mesh {
    surfaces: Vec<Tree<usize>>,
}

impl Mesh {
    /// The cells of each surface, with their orders.
    pub fn new(surfaces: Vec<Tree<usize>>) -> Self {
        Self { surfaces }
    }

    /// The cells of each surface, with their orders.
    pub fn surfaces(&self) -> &[Tree<usize>] {
        &self.surfaces
    }

    /// Whether it cuts so many surfaces, all inside their parameters, into cells of orders that are offered.
    pub fn is_valid(&self, surfaces: usize) -> bool {
        let fits = |tree: &Tree<usize>| {
            tree.is_valid(&Rect::FULL, DEEPEST) && tree.values().iter().all(|order| **order <= HIGHEST_ORDER)
        };
        self.surfaces.len() == surfaces && self.surfaces.iter().all(fits)
    }

    /// This mesh with the orders that `order` tells by the rectangle and the order of each.
    pub fn with_orders(&self, order: &dyn Fn(&Rect, usize) -> usize) -> Self {
        let surface = |tree: &Tree<usize>| {
            let changed = tree.map(&Rect::FULL, &mut |rect, own| Ok::<_, Infallible>(order(rect, *own)));
            changed.unwrap_or_else(|never| match never {})
        };
        Self { surfaces: self.surfaces.iter().map(surface).collect() }
    }

    /// The mesh after what `refinement` says of each leaf, by its surface and its number there.
    pub fn refined(&self, refinement: &dyn Fn(usize, usize) -> CellRefinement) -> Self {
        let surface = |(surface, tree): (usize, &Tree<usize>)| {
            let mut leaf = 0;
            let refined = tree.replaced(&Rect::FULL, &mut |rect, order| {
                let what = refinement(surface, leaf);
                leaf += 1;
                Ok::<_, Infallible>(match what {
                    CellRefinement::Keep => Tree::Leaf(*order),
                    CellRefinement::Raise(by) => Tree::Leaf((order + by).min(HIGHEST_ORDER)),
                    CellRefinement::Cut(across) => Tree::halved(rect, across, *order),
                })
            });
            refined.unwrap_or_else(|never| match never {})
        };
        Self { surfaces: self.surfaces.iter().enumerate().map(surface).collect() }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::cells::{Layers, cells_between, equal_parts, with_layers};

    /// The rectangles of the leaves in order.
    fn rects<T: Copy>(tree: &Tree<T>) -> Vec<Rect> {
        let mut rects = Vec::new();
        let _ = tree.map(&Rect::FULL, &mut |rect, _| {
            rects.push(*rect);
            Ok::<_, ()>(())
        });
        rects
    }

    fn numbered(mesh: &Mesh) -> Tree<usize> {
        let mut next = 0;
        let number = |_: &Rect, _: &usize| {
            next += 1;
            Ok::<_, ()>(next - 1)
        };
        mesh.surfaces[0].map(&Rect::FULL, &mut { number }).expect("it cannot fail")
    }

    #[test]
    fn a_grid_has_the_cells_between_its_breaks_in_order() {
        let layers = Layers { count: 1, ratio: 0.3 };
        let breaks = [3, 2].map(|parts| with_layers(&equal_parts(parts), [layers; 2]));
        let cells: Vec<Rect> = cells_between(&breaks).collect();
        assert_eq!(rects(&Tree::grid(&breaks, 0)), cells);
    }

    #[test]
    fn meshes_that_leave_their_surface_are_told() {
        let grid = Tree::grid(&[vec![-1.0, 0.0, 1.0], vec![-1.0, 1.0]], 2);
        assert!(Mesh::new(vec![grid.clone()]).is_valid(1));
        assert!(!Mesh::new(vec![grid]).is_valid(2));
        let beyond = Tree::grid(&[vec![-1.0, 1.5, 1.0], vec![-1.0, 1.0]], 2);
        let high = Tree::Leaf(HIGHEST_ORDER + 1);
        assert!([beyond, high].into_iter().all(|tree| !Mesh::new(vec![tree]).is_valid(1)));
    }

    proptest! {
        #[test]
        fn refined_cells_cover_the_square_and_are_found(
            choices in prop::collection::vec(0..5usize, 64), rounds in 1..4usize, place in prop::array::uniform2(-1.0..1.0),
        ) {
            let mut mesh = Mesh::new(vec![Tree::Leaf(1)]);
            for round in 0..rounds {
                mesh = mesh.refined(&|_, leaf| match choices[(17 * round + leaf) % choices.len()] {
                    0 => CellRefinement::Keep,
                    1 => CellRefinement::Raise(2),
                    2 => CellRefinement::Cut(None),
                    3 => CellRefinement::Cut(Some(Axis::U)),
                    _ => CellRefinement::Cut(Some(Axis::V)),
                });
            }
            prop_assert!(mesh.is_valid(1));
            let tree = numbered(&mesh);
            let rects = rects(&tree);
            prop_assert_eq!(rects.len(), tree.values().len());
            let area: f64 = rects.iter().map(|r| (r.u[1] - r.u[0]) * (r.v[1] - r.v[0])).sum();
            prop_assert!((area - 4.0).abs() < 1e-13);
            let rect = rects[*tree.at(place)];
            prop_assert!(rect.u[0] <= place[0] && place[0] < rect.u[1]);
            prop_assert!(rect.v[0] <= place[1] && place[1] < rect.v[1]);
        }
    }
}
