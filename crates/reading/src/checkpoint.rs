//! Counts of the work that a run took from its checkpoint, and of the work that it added.

use std::fmt;

use radiosity_work::ranks::Ranks;
use radiosity_work::ranks::journal::{Journal, Tally};
use serde::Serialize;

use crate::warning::Warning;

/// Counts of the work that all ranks of a run took from its checkpoint, and of the work that they added.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Checkpoint {
    /// Whether it is a file of transfers.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub are_transfers: bool,
    /// Number of pieces of work that were recorded before, and were not done again.
    pub recalled: u64,
    /// Number of pieces that were done and written.
    pub recorded: u64,
    /// Bytes written.
    pub bytes: u64,
    /// Reason why some pieces that were done were not written, if so.
    pub incomplete: Option<String>,
}

impl Checkpoint {
    /// The counts of these ranks so far; None where they record nothing. All ranks ask together.
    pub fn so_far(ranks: &Ranks) -> Option<Self> {
        let own = ranks.journal().map(Journal::tally)?;
        let all = ranks.all(own);
        let sum = |count: fn(&Tally) -> u64| all.iter().map(count).sum();
        Some(Self {
            are_transfers: all.iter().any(|rank| rank.are_transfers),
            recalled: sum(|rank| rank.recalled),
            recorded: sum(|rank| rank.recorded),
            bytes: sum(|rank| rank.bytes),
            incomplete: all.iter().find_map(|rank| rank.failed.clone()),
        })
    }

    /// A warning where the record is incomplete.
    pub fn warning(&self) -> Option<Warning> {
        let why = self.incomplete.as_ref()?;
        let message = match self.are_transfers {
            true => format!(
                "the file of transfers is incomplete, and runs find again what is missing: {why}; make room"
            ),
            false => format!(
                "the checkpoint is incomplete, and a run that resumes would do again what is missing: {why}; make room, or record \
                 in another folder"
            ),
        };
        Some(Warning::general("checkpoint-incomplete", message))
    }
}

/// One line of a summary.
impl fmt::Display for Checkpoint {
    fn fmt(&self, to: &mut fmt::Formatter) -> fmt::Result {
        let Self { are_transfers, recalled, recorded, bytes, .. } = self;
        let megabytes = *bytes as f64 / 1e6;
        let what = if *are_transfers { "transfers" } else { "checkpoint" };
        write!(to, "{what}: {recalled} pieces recalled, {recorded} recorded ({megabytes:.3} MB)")
    }
}

#[cfg(test)]
mod tests {
    use radiosity_work::ranks::PartName;
    use radiosity_work::ranks::journal::Begin;
    use radiosity_work::ranks::threads::on_ranks;

    use super::*;

    #[test]
    fn it_sums_up_what_ranks_took_and_added() {
        let folder = tempfile::tempdir().expect("a folder");
        let told = |begin| {
            on_ranks(3, |ranks| {
                let ranks = ranks.recording(folder.path(), 1, begin).expect("a folder");
                ranks.map(PartName::Points, &[1.0; 8], |piece| piece);
                Checkpoint::so_far(&ranks).expect("it is recorded")
            })
        };
        for (begin, [recalled, recorded]) in [(Begin::Anew, [0, 8]), (Begin::Resume, [8, 0])] {
            for rank in told(begin) {
                assert_eq!([rank.recalled, rank.recorded], [recalled, recorded]);
                assert_eq!((rank.bytes > 0, rank.incomplete), (recorded > 0, None));
            }
        }
        assert_eq!(Checkpoint::so_far(Ranks::alone()), None);
    }
}
