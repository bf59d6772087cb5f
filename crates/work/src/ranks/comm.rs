//! Messages between ranks.

use std::fmt::Debug;

use super::machine_share::MachineShare;

/// Messages between ranks. All ranks call the same functions in the same order; a call ends when the others
/// have made theirs. Only one thread of a rank calls at a time.
pub trait Comm: Debug + Send + Sync {
    /// The number of this rank, from 0.
    fn rank(&self) -> usize;

    /// Number of ranks.
    fn size(&self) -> usize;

    /// The share of its machine that this rank may use.
    fn machine_share(&self) -> MachineShare;

    /// Waits for all ranks.
    fn meet(&self);

    /// The bytes of each rank, in their order.
    fn all_gather(&self, own: Vec<u8>) -> Vec<Vec<u8>>;

    /// The bytes that each rank has for this one, in their order; `to[k]` are those of this one for rank k.
    fn exchange(&self, to: Vec<Vec<u8>>) -> Vec<Vec<u8>>;

    /// Fills `values`, of which rank k has the part that ends at `ends[k]` and begins where that of the rank
    /// before ends.
    fn complete(&self, values: &mut [f64], ends: &[usize]);
}
