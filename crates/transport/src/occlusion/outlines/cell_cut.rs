//! Cuts of cells of the outer element, and the points of the rules on their parts.

use radiosity_elements::patch::{Direction, Patch};

/// Ratio of sides above which a cell is halved across the longer one only. At 1.5 its halves are as slender
/// the other way as a cell of 1.33; with a larger value slender cells are quartered, and their quarters are
/// as slender.
const SLENDER: f64 = 1.5;
/// Ways to cut a cell: into quarters, or across the longer side of a slender one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CellCut {
    Halves(Direction),
    Quarters,
}

impl CellCut {
    pub(super) fn of(cell: &Patch) -> Self {
        let [along, across] = cell.extents();
        if along > SLENDER * across {
            Self::Halves(Direction::Along)
        } else if across > SLENDER * along {
            Self::Halves(Direction::Across)
        } else {
            Self::Quarters
        }
    }

    pub(super) fn parts(self, cell: &Patch) -> Vec<Patch> {
        match self {
            Self::Halves(direction) => cell.halves(direction).to_vec(),
            Self::Quarters => {
                let halves = cell.halves(Direction::Along);
                halves.iter().flat_map(|half| half.halves(Direction::Across)).collect()
            }
        }
    }

    /// Points of the rule on the parts, of `usual` points per direction, along and across, after a rule of
    /// `coarse` points on the whole. Halves lie beside the same points as the whole in the direction that is
    /// not cut: another number of points there tells whether these suffice.
    pub(super) fn points(self, usual: usize, coarse: [usize; 2]) -> [usize; 2] {
        let other = |points: usize| if points == usual { usual + 1 } else { usual };
        match self {
            Self::Halves(Direction::Along) => [usual, other(coarse[1])],
            Self::Halves(Direction::Across) => [other(coarse[0]), usual],
            Self::Quarters => [usual; 2],
        }
    }
}
