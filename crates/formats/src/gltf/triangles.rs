//! Triangles of primitives (section 3.7.2.1): of lists, strips and fans.

use std::rc::Rc;

use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;

use super::accessor::Data;

/// Topology of a primitive: the rule by which corners form triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    List,
    Strip,
    Fan,
}

impl Mode {
    /// The mode of a number; none for points and lines, and for numbers that stand for nothing.
    pub(super) fn of(number: u32) -> Option<Mode> {
        match number {
            4 => Some(Mode::List),
            5 => Some(Mode::Strip),
            6 => Some(Mode::Fan),
            _ => None,
        }
    }

    /// Number of triangles that so many corners form.
    pub(super) fn count(self, corners: usize) -> usize {
        match self {
            Mode::List => corners / 3,
            Mode::Strip | Mode::Fan => corners.saturating_sub(2),
        }
    }

    /// Corners of the triangle of a number, counter-clockwise.
    pub(super) fn corners(self, triangle: usize) -> [usize; 3] {
        let k = triangle;
        match self {
            Mode::List => [3 * k, 3 * k + 1, 3 * k + 2],
            // Every other triangle of a strip runs the other way.
            Mode::Strip => [k, k + 1 + k % 2, k + 2 - k % 2],
            Mode::Fan => [k + 1, k + 2, 0],
        }
    }
}

/// The triangles of a primitive.
#[derive(Debug)]
pub(super) struct Triangles<'b> {
    pub(super) mode: Mode,
    pub(super) points: Rc<Data<'b>>,
    /// Numbers of the points, if they are not taken in their order.
    pub(super) indices: Option<Rc<Data<'b>>>,
}

impl Triangles<'_> {
    /// Number of triangles.
    pub(super) fn count(&self) -> usize {
        self.mode.count(self.vertices())
    }

    /// Number of vertices, in the order of the triangles.
    fn vertices(&self) -> usize {
        self.indices.as_ref().unwrap_or(&self.points).count
    }

    /// Numbers of the points of a triangle; None where one is repeated, as by triangles that join strips.
    pub(super) fn corners(&self, triangle: usize) -> Option<[usize; 3]> {
        let vertex = |number: usize| match &self.indices {
            Some(indices) => indices.index(number).unwrap_or(usize::MAX),
            None => number,
        };
        let [a, b, c] = self.mode.corners(triangle).map(vertex);
        let joins = self.mode != Mode::List && (a == b || b == c || c == a);
        (!joins).then_some([a, b, c])
    }

    /// Refuses triangles that lack corners.
    pub(super) fn require_whole(&self, place: FilePlace) -> Result<(), Refusal> {
        let corners = self.vertices();
        if self.mode != Mode::List || corners.is_multiple_of(3) {
            return Ok(());
        }
        refuse_at(
            place,
            format!("triangles have {corners} corners, no multiple of 3"),
            "correct the count, or export the model again",
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_and_fans_keep_their_fronts() {
        let all = |mode: Mode| (0..mode.count(5)).map(|k| mode.corners(k)).collect::<Vec<_>>();
        assert_eq!(all(Mode::Strip), [[0, 1, 2], [1, 3, 2], [2, 3, 4]]);
        assert_eq!(all(Mode::Fan), [[1, 2, 0], [2, 3, 0], [3, 4, 0]]);
        assert_eq!(all(Mode::List), [[0, 1, 2]]);
    }
}
