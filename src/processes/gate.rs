//! A gate that all ranks pass together, or not at all.
//!
//! Each rank states the call that it is about to make by a number c, the same for all that make the same
//! call, or states that it has failed. Two maxima over the ranks, of c and of its complement, tell whether
//! all state the same. A rank that waits sleeps: others may need its processor.

use std::thread;
use std::time::{Duration, Instant};

use mpi::collective::SystemOperation;
use mpi::request::scope;
use mpi::topology::SimpleCommunicator;
use mpi::traits::CommunicatorCollectives;

/// A call that a rank is about to make.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u64)]
pub(super) enum Call {
    Meet,
    Gather,
    Exchange,
    End,
}

/// Number of different [`Call`]s, or more.
const CALLS: u64 = 4;

/// The result of the gate, the same for all ranks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum GateResult {
    /// All ranks are about to make the same call.
    Together,
    /// A rank has failed.
    Failed,
    /// The ranks are about to make different calls.
    Apart,
}

/// Time up to which a rank waits busily, and time up to which it then yields its processor to others. Chosen.
const BUSY: Duration = Duration::from_micros(50);
const YIELDING: Duration = Duration::from_millis(1);

/// Longest sleep of a rank that waits, and its sleep over the time waited so far. Chosen.
const LONGEST: Duration = Duration::from_millis(2);
const ASLEEP: f64 = 0.1;

/// Waits until all ranks are here, where this one is about to make `call`, its call number `before`.
pub(super) fn pass(world: &SimpleCommunicator, call: Call, before: u64) -> GateResult {
    let own = CALLS * before + call as u64;
    passed(world, [own, u64::MAX - own], &|_| ())
}

/// Waits until all ranks are here, where this one has failed; after `patience` it gives up, which ends its
/// process.
pub(super) fn fail(world: &SimpleCommunicator, patience: Duration, give_up: &dyn Fn()) {
    passed(world, [u64::MAX, 0], &|waited| {
        if waited > patience {
            give_up();
        }
    });
}

/// Waits until all ranks are here, where this one states `said`, its number c and the complement; `look` gets
/// the time waited, now and then.
fn passed(world: &SimpleCommunicator, said: [u64; 2], look: &dyn Fn(Duration)) -> GateResult {
    let mut greatest = [0; 2];
    scope(|scope| {
        let mut request =
            world.immediate_all_reduce_into(scope, &said[..], &mut greatest[..], SystemOperation::max());
        let begun = Instant::now();
        while let Err(open) = request.test() {
            request = open;
            look(begun.elapsed());
            wait(begun.elapsed());
        }
    });
    match greatest {
        [u64::MAX, _] => GateResult::Failed,
        [most, rest] if most == u64::MAX - rest => GateResult::Together,
        _ => GateResult::Apart,
    }
}

/// Waits a little, after so much waiting.
fn wait(waited: Duration) {
    if waited < BUSY {
        std::hint::spin_loop();
    } else if waited < YIELDING {
        thread::yield_now();
    } else {
        thread::sleep(LONGEST.min(waited.mul_f64(ASLEEP)));
    }
}
