//! Sides of a patch that a cell of it touches.

use radiosity_elements::patch::Direction;

/// Whether a cell touches the sides of its patch at s = 0 and s = 1, and at t = 0 and t = 1.
#[derive(Clone, Copy, Debug)]
pub(super) struct Border {
    along: [bool; 2],
    across: [bool; 2],
}

impl Border {
    /// The border of the patch itself.
    pub(super) const WHOLE: Self = Self { along: [true; 2], across: [true; 2] };

    /// The number of sides that it touches.
    pub(super) fn touched(&self) -> usize {
        self.along.into_iter().chain(self.across).filter(|touched| *touched).count()
    }

    /// Borders of the four quarters, index 2 a + b, a for the halving in the first direction and b for the
    /// second.
    pub(super) fn of_quarters(&self, [first, second]: [Direction; 2]) -> [Self; 4] {
        std::array::from_fn(|index| self.half(first, index / 2).half(second, index % 2))
    }

    /// Border of the lower (0) or upper half (1).
    fn half(&self, direction: Direction, half: usize) -> Self {
        let mut own = *self;
        let sides = match direction {
            Direction::Along => &mut own.along,
            Direction::Across => &mut own.across,
        };
        sides[1 - half] = false;
        own
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_amid_the_patch_touches_no_side() {
        let both = [Direction::Along, Direction::Across];
        let corner = Border::WHOLE.of_quarters(both)[0];
        assert_eq!(corner.touched(), 2);
        assert_eq!(corner.of_quarters(both).map(|border| border.touched()), [2, 1, 1, 0]);
        let strips = Border::WHOLE.of_quarters([Direction::Along; 2]);
        assert_eq!(strips.map(|border| border.touched()), [3, 2, 2, 3]);
    }
}
