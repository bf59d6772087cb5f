//! Exchanges of two elements that are known beforehand, and those that follow from them.
//!
//! Each closed row is an equation for the exchanges X_ij = A_i F_ij that are not known. They are the edges of
//! a graph of the rows, X_ii a loop. An edge at whose end no other one is left follows from that row. What is
//! left when no such end remains follows where a part of the graph has as many edges as rows and a loop or an
//! odd cycle: its equations, those of a signless Laplacian matrix, have one solution (D. Cvetković, P.
//! Rowlinson, S. K. Simić, *Linear Algebra Appl.* 423 (2007) 155-171).

use radiosity_elements::Element;
use radiosity_geom::ROUNDING;
use radiosity_kernel::blocks::FirstEntry;
use radiosity_solve::Model;
use radiosity_visibility::Visibility;
use radiosity_visibility::inspection::Regions;
use radiosity_work::interruption::check_interrupt;

/// Most elements of which it is looked at what follows, one pair at a time: half a million pairs.
const MOST: usize = 1000;

/// The pairs of elements whose exchange has to be found by quadrature or rays that err.
#[derive(Debug)]
pub(super) struct Pairs {
    /// For each pair (i, j), i ≤ j, at its place in the triangle, whether its exchange is exact; empty if
    /// there are too many.
    exact: Vec<bool>,
    elements: usize,
}

impl Pairs {
    /// The pairs of a model whose surfaces lie in these regions, if they are known.
    pub(super) fn of(model: &Model, regions: Option<&Regions>) -> Self {
        let list = model.elements().list();
        let count = list.len();
        if count > MOST {
            return Self { exact: Vec::new(), elements: count };
        }
        let mut stored = vec![false; triangle(count)];
        for FirstEntry { row, column, .. } in model.blocks().first_entries() {
            stored[place(row, column)] = true;
        }
        // Without rays, what is not stored is zero.
        let has_rays = model.blocks().statistics.pairs.by_rays > 0;
        let exact = |i: usize, j: usize| {
            check_interrupt();
            let pair = [&list[i], &list[j]];
            let is_stored = stored[place(i, j)];
            is_integrated_exactly(model.visibility(), pair)
                || !is_stored && (!has_rays || exchanges_nothing(model.visibility(), regions, pair))
        };
        let exact = (0..count).flat_map(|j| (0..=j).map(move |i| (i, j))).map(|(i, j)| exact(i, j)).collect();
        Self { exact, elements: count }
    }

    /// Whether the exchange of a pair, i ≤ j, is exact.
    pub(super) fn is_exact(&self, i: usize, j: usize) -> bool {
        !self.exact.is_empty() && self.exact[place(i, j)]
    }

    /// Whether all exchanges are exact.
    pub(super) fn are_exact(&self) -> bool {
        !self.exact.is_empty() && self.exact.iter().all(|exact| *exact)
    }

    /// Whether all exchanges that are not exact follow from the sums of the `rows` that are known.
    pub(super) fn follow_from(&self, rows: &[bool]) -> bool {
        if self.exact.is_empty() {
            return false;
        }
        let all = (0..self.elements).flat_map(|j| (0..=j).map(move |i| [i, j]));
        let mut edges: Vec<[usize; 2]> = all.filter(|[i, j]| !self.is_exact(*i, *j)).collect();
        if edges.iter().any(|ends| ends.iter().any(|row| !rows[*row])) {
            return false;
        }
        strip_leaves(&mut edges, self.elements);
        have_one_solution(&edges, self.elements)
    }
}

/// Whether the contour integral of two elements that carry constants is their exchange: both are flat, and
/// nothing can stand between.
fn is_integrated_exactly(visibility: &Visibility, [one, other]: [&Element; 2]) -> bool {
    let is_simple = |element: &Element| element.plane.is_some() && element.basis.len() == 1;
    let surfaces = [one.surface, other.surface];
    is_simple(one) && is_simple(other) && visibility.candidates(&one.hull, &other.hull, surfaces).is_empty()
}

/// Whether two elements certainly exchange nothing.
fn exchanges_nothing(
    visibility: &Visibility,
    regions: Option<&Regions>,
    [one, other]: [&Element; 2],
) -> bool {
    let are_apart = regions.is_some_and(|regions| !regions.are_together([one.surface, other.surface]));
    let is_outward = one.surface == other.surface && !visibility.hides_itself(one.surface);
    are_apart || is_outward || lies_behind(one, other) || lies_behind(other, one)
}

/// Whether `other` lies behind the plane of `one`, or in it.
fn lies_behind(one: &Element, other: &Element) -> bool {
    one.plane.is_some_and(|plane| {
        let room = ROUNDING * (one.extent + other.extent);
        other.hull.iter().all(|x| plane.height(*x) <= room)
    })
}

/// Removes the edges that follow one after another from rows where they are the only one left.
fn strip_leaves(edges: &mut Vec<[usize; 2]>, rows: usize) {
    loop {
        check_interrupt();
        let degrees = degrees(edges, rows);
        let before = edges.len();
        edges.retain(|ends| ends.iter().all(|row| degrees[*row] > 1));
        if edges.len() == before {
            return;
        }
    }
}

/// Number of edges that end at each row, a loop once.
fn degrees(edges: &[[usize; 2]], rows: usize) -> Vec<usize> {
    let mut degrees = vec![0; rows];
    for [i, j] in edges {
        degrees[*i] += 1;
        degrees[*j] += usize::from(i != j);
    }
    degrees
}

/// Whether each part of the graph has as many edges as rows, and a loop or an odd cycle.
fn have_one_solution(edges: &[[usize; 2]], rows: usize) -> bool {
    let mut neighbours = vec![Vec::new(); rows];
    for [i, j] in edges {
        neighbours[*i].push(*j);
        if i != j {
            neighbours[*j].push(*i);
        }
    }
    let mut colours: Vec<Option<bool>> = vec![None; rows];
    (0..rows).all(|first| {
        if neighbours[first].is_empty() || colours[first].is_some() {
            return true;
        }
        colours[first] = Some(false);
        let (mut open, mut ends, mut loops, mut members, mut is_odd) = (vec![first], 0, 0, 0, false);
        while let Some(row) = open.pop() {
            members += 1;
            for other in &neighbours[row] {
                if *other == row {
                    loops += 1;
                    is_odd = true;
                    continue;
                }
                ends += 1;
                match colours[*other] {
                    None => {
                        colours[*other] = colours[row].map(|colour| !colour);
                        open.push(*other);
                    }
                    colour => is_odd |= colour == colours[row],
                }
            }
        }
        is_odd && ends / 2 + loops == members
    })
}

/// The place of the pair (i, j), i ≤ j, in a triangle.
fn place(i: usize, j: usize) -> usize {
    triangle(j) + i
}

/// n (n + 1) / 2.
fn triangle(n: usize) -> usize {
    n * (n + 1) / 2
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether all of these exchanges follow from the sums of as many rows.
    fn follow(edges: &[[usize; 2]], rows: usize) -> bool {
        let mut edges = edges.to_vec();
        strip_leaves(&mut edges, rows);
        have_one_solution(&edges, rows)
    }

    #[test]
    fn a_body_in_a_ball_is_known_from_sums() {
        assert!(follow(&[[0, 1], [1, 1]], 2));
        // Of three faces that see the ball alone.
        assert!(follow(&[[0, 3], [1, 3], [2, 3], [3, 3]], 4));
    }

    #[test]
    fn three_walls_of_a_long_duct_are_known_from_sums_and_four_are_not() {
        // F₁₂ = (A₁ + A₂ − A₃) / 2A₁ of a duct of three sides.
        assert!(follow(&[[0, 1], [0, 2], [1, 2]], 3));
        assert!(!follow(&[[0, 1], [0, 2], [0, 3], [1, 2], [1, 3], [2, 3]], 4));
    }

    #[test]
    fn two_hollows_that_see_each_other_are_not_known_from_sums() {
        assert!(!follow(&[[0, 0], [0, 1], [1, 1]], 2));
        assert!(!follow(&[[0, 1], [1, 2], [2, 3], [0, 3]], 4));
    }
}
