//! The failure of a rank.

use std::any::Any;

use serde::{Deserialize, Serialize};

/// The failure of a rank: exit code and message.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// The exit code of its process, not 0.
    pub code: u8,
    /// Text of the message, with the end of its last line; empty where all is said.
    pub message: String,
}

/// The exit code of a process that panicked, as Rust's own.
const PANICKED: u8 = 101;

impl Failure {
    /// The failure of a panic with this payload, of which a hook noted `noted`.
    pub fn of_panic(payload: &(dyn Any + Send), noted: Option<String>) -> Self {
        let text = payload.downcast_ref::<String>().map(String::as_str);
        let text = text.or_else(|| payload.downcast_ref::<&str>().copied());
        let message = noted.or_else(|| text.map(str::to_owned)).unwrap_or_else(|| "panicked".to_owned());
        Self { code: PANICKED, message: message + "\n" }
    }

    /// The failure that all ranks end with, given the failure of each, if it failed: that of all where they
    /// are equal, else that of the first rank that failed, named by its number.
    pub fn of_all(failures: Vec<Option<Self>>) -> Option<Self> {
        let is_same = failures.windows(2).all(|two| two[0] == two[1]);
        let (rank, failure) =
            failures.into_iter().enumerate().find_map(|(rank, failure)| Some((rank, failure?)))?;
        Some(if is_same { failure } else { failure.on(rank) })
    }

    /// The failure, told as that of rank `rank`. The first rank, which writes, says no more than if it were
    /// alone.
    pub fn on(self, rank: usize) -> Self {
        if rank == 0 || self.message.is_empty() {
            return self;
        }
        Self { message: format!("rank {rank}: {}", self.message), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_all_ranks_say_is_said_once_and_what_one_says_with_its_number() {
        let failure = |message: &str| Failure { code: 2, message: message.to_owned() };
        let full = failure("error: full\n");
        assert_eq!(Failure::of_all(vec![None, None]), None);
        assert_eq!(Failure::of_all(vec![Some(full.clone()); 3]), Some(full.clone()));
        assert_eq!(Failure::of_all(vec![None, Some(full.clone())]), Some(failure("rank 1: error: full\n")));
        assert_eq!(Failure::of_all(vec![Some(full.clone()), None]), Some(full));
    }
}
