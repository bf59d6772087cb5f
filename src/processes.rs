//! Ranks that are processes, started by `mpirun`, `srun` or the like and connected by MPI (Message Passing
//! Interface Forum, *MPI: A Message-Passing Interface Standard*, version 3.1, 2015).
//!
//! Before ranks share anything they pass a [gate](gate): it tells whether all are about to make the same
//! call, and whether one of them has failed. The completion of a vector has no gate, as iterative solvers
//! call it again and again.

mod gate;
mod messages;

use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind, set_hook};
use std::process::ExitCode;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use mpi::environment::Universe;
use mpi::topology::SimpleCommunicator;
use mpi::traits::Communicator;
use mpi::{Threading, initialize_with_threading};
use radiosity_cli::launch::{RankWork, Tell};
use radiosity_work::ranks::comm::Comm;
use radiosity_work::ranks::failure::Failure;
use radiosity_work::ranks::machine_share::{MachineShare, allowed};
use radiosity_work::ranks::{Ranks, shares};

use gate::{Call, GateResult, fail, pass};
use messages::{all_gather, complete, exchange};

/// Time that a rank that failed waits for the others before it ends them. Chosen.
const PATIENCE: Duration = Duration::from_secs(3);

/// The processes of this run, until it is dropped.
struct World {
    processes: Processes,
    /// Ends MPI when it is dropped.
    _universe: Universe,
}

/// The process of one rank.
#[derive(Clone, Debug)]
struct Processes {
    rank: usize,
    size: usize,
    machine_share: MachineShare,
    /// Number of calls so far; held during each.
    calls: Arc<Mutex<u64>>,
}

/// Unwinds a rank where another has failed.
struct Ended(Failure);

/// Does `work` on all processes that MPI connects, as [`World::run`]; None where MPI began before in this
/// process.
pub(crate) fn connect(work: &RankWork<'_>, tell: &Tell<'_>) -> Option<ExitCode> {
    World::join().map(|world| world.run(work, tell))
}

impl World {
    /// Begins MPI; None where it began before in this process.
    ///
    /// # Panics
    /// If this MPI allows calls from the main thread only.
    fn join() -> Option<Self> {
        let (universe, threading) = initialize_with_threading(Threading::Serialized)?;
        assert!(threading >= Threading::Serialized, "this MPI takes calls from the main thread only");
        let world = universe.world();
        let [rank, size] = [world.rank(), world.size()].map(|number| number as usize);
        let processes = Processes { rank, size, machine_share: machine_share(&world), calls: Arc::default() };
        Some(Self { processes, _universe: universe })
    }

    /// All ranks of the world.
    fn ranks(&self) -> Ranks {
        Ranks::of(self.processes.clone())
    }

    /// Does `work` on all ranks, and returns the exit code of all of them: where one fails, all do, within
    /// seconds. `tell` says why, on one of them. A panic counts as a failure; it is not printed where it
    /// happens.
    fn run(self, work: &RankWork<'_>, tell: &Tell<'_>) -> ExitCode {
        let noted: Arc<Mutex<Option<String>>> = Arc::default();
        let note = Arc::clone(&noted);
        set_hook(Box::new(move |panic| {
            locked(&note).get_or_insert(panic.to_string());
        }));
        let own = match catch_unwind(AssertUnwindSafe(|| work(&self.ranks()))) {
            Ok(ended) => ended,
            Err(payload) => match payload.downcast::<Ended>() {
                Ok(ended) => return self.report_failure(&ended.0, tell),
                Err(payload) => Err(Failure::of_panic(&*payload, locked(&noted).take())),
            },
        };
        match self.processes.end(own.err(), tell) {
            Some(failure) => self.report_failure(&failure, tell),
            None => ExitCode::SUCCESS,
        }
    }

    /// Says why all ranks end, on the first.
    fn report_failure(&self, failure: &Failure, tell: &Tell<'_>) -> ExitCode {
        if self.processes.rank == 0 {
            tell(&failure.message);
        }
        ExitCode::from(failure.code)
    }
}

/// The share of this process in its machine.
fn machine_share(world: &SimpleCommunicator) -> MachineShare {
    let machine = world.split_shared(world.rank());
    let own: Vec<u8> = allowed().into_iter().flat_map(|number| (number as u32).to_le_bytes()).collect();
    let numbers = |bytes: Vec<u8>| -> Vec<usize> {
        bytes.as_chunks::<4>().0.iter().map(|bytes| u32::from_le_bytes(*bytes) as usize).collect()
    };
    let all: Vec<Vec<usize>> = all_gather(&machine, &own).into_iter().map(numbers).collect();
    MachineShare::among(&all, machine.rank() as usize)
}

/// The content of a mutex, also after a panic of its holder.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Processes {
    /// Does `share` with all ranks, once all are about to make the same call.
    fn shared<T>(&self, call: Call, share: impl FnOnce(&SimpleCommunicator) -> T) -> T {
        let mut calls = locked(&self.calls);
        *calls += 1;
        let world = SimpleCommunicator::world();
        match pass(&world, call, *calls) {
            GateResult::Together => share(&world),
            GateResult::Apart => {
                panic!("the ranks do different things; they need the same arguments and files")
            }
            GateResult::Failed => {
                let failure = failed(&world, None).expect("a rank has failed");
                resume_unwind(Box::new(Ended(failure)))
            }
        }
    }

    /// Ends together with all ranks: with the failure `own`, or with that of another rank.
    fn end(&self, own: Option<Failure>, tell: &Tell<'_>) -> Option<Failure> {
        let calls = *locked(&self.calls) + 1;
        let world = SimpleCommunicator::world();
        let Some(own) = own else {
            return match pass(&world, Call::End, calls) {
                GateResult::Together => None,
                GateResult::Failed => failed(&world, None),
                GateResult::Apart => {
                    let message = "error: one rank has done less than another\n".to_owned();
                    self.end(Some(Failure { code: 1, message }), tell)
                }
            };
        };
        fail(&world, PATIENCE, &|| {
            let own = own.clone().on(self.rank);
            tell(&own.message);
            world.abort(i32::from(own.code))
        });
        failed(&world, Some(&own))
    }
}

/// The failure with which all ranks end, of which some have failed; `own` is that of this rank.
fn failed(world: &SimpleCommunicator, own: Option<&Failure>) -> Option<Failure> {
    let own = postcard::to_allocvec(&own).expect("a failure is two plain values");
    let all = all_gather(world, &own).into_iter();
    Failure::of_all(
        all.map(|bytes| postcard::from_bytes(&bytes).expect("all ranks run one program")).collect(),
    )
}

impl Comm for Processes {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn machine_share(&self) -> MachineShare {
        self.machine_share
    }

    fn meet(&self) {
        self.shared(Call::Meet, |_| ());
    }

    fn all_gather(&self, own: Vec<u8>) -> Vec<Vec<u8>> {
        self.shared(Call::Gather, |world| all_gather(world, &own))
    }

    fn exchange(&self, to: Vec<Vec<u8>>) -> Vec<Vec<u8>> {
        self.shared(Call::Exchange, |world| exchange(world, to))
    }

    fn complete(&self, values: &mut [f64], ends: &[usize]) {
        let mut calls = locked(&self.calls);
        *calls += 1;
        let own = values[shares::range(ends, self.rank)].to_vec();
        complete(&SimpleCommunicator::world(), &own, ends, values);
    }
}
