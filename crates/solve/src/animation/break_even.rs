//! After how many frames the set-up of a way to follow things is repaid.

/// Cost of frames, in solutions of a single frame that is solved alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BreakEven {
    frames: usize,
    repaid: Option<usize>,
}

impl BreakEven {
    /// Takes note of a frame more, after all of them together cost `spent` solutions.
    pub(super) fn add_frame(&mut self, spent: f64) {
        self.frames += 1;
        let is_repaid = spent < self.frames as f64;
        self.repaid = is_repaid.then(|| self.repaid.unwrap_or(self.frames));
    }

    /// The number of frames from which on all together cost less than if each were solved alone; None if they
    /// cost as much.
    pub(super) fn repaid(&self) -> Option<usize> {
        self.repaid
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_repaid_and_lent_again_is_repaid_later() {
        let mut break_even = BreakEven::default();
        let repaid = [5.0, 5.0, 5.0, 5.0, 5.0, 5.0, 8.0, 8.0, 8.0].map(|spent| {
            break_even.add_frame(spent);
            break_even.repaid()
        });
        assert_eq!(repaid, [None, None, None, None, None, Some(6), None, None, Some(9)]);
    }
}
