//! Ranks: processes, each with threads of its own, that share the work of one run.
//!
//! Every rank runs the same program on the same scene: whatever is decided follows from data that all of them have. Only the
//! heavy parts are shared: of a list of pieces, each rank makes those that are its own, and then sends them to the ranks that
//! need them ([`Ranks::map`], [`Ranks::exchange`]). A piece is the same whoever makes it, and sums are taken in an order that
//! does not depend on how the pieces were shared, so that the number of ranks changes no bit of a result.
//!
//! As with a pool of threads, work runs within ranks ([`Ranks::within`]) and finds them ([`current`]) where it has something to
//! share. Threads that a rank starts for its own pieces are alone: nothing is shared within a piece.

pub mod place;
pub mod comm;
pub mod journal;
pub mod shares;
pub mod threads;
mod traffic;
pub mod failure;
pub mod vector;
#[cfg(any(test, feature = "mpi"))]
mod rounds;
#[cfg(feature = "mpi")]
pub mod processes;

use std::cell::RefCell;
use std::sync::Arc;

use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use comm::Comm;
use journal::{Journal, RecordedPart};
use place::Place;
use traffic::Counter;
pub use traffic::Traffic;

thread_local! {
    /// The ranks within which this thread works.
    static CURRENT: RefCell<Option<Ranks>> = const { RefCell::new(None) };
}

/// The ranks of a run, as one of them sees them.
#[derive(Clone, Debug)]
pub struct Ranks {
    shared: Option<Arc<Shared>>,
    journal: Option<Arc<Journal>>,
}

/// Two ranks or more.
#[derive(Debug)]
struct Shared {
    comm: Box<dyn Comm>,
    sent: Counter,
}

/// The ranks within which the current thread works; it is alone unless [`Ranks::within`] says otherwise.
pub fn current() -> Ranks {
    CURRENT.with_borrow(|current| current.clone().unwrap_or_else(Ranks::alone))
}

/// Sets back the ranks of a thread, whatever happens.
struct Before(Option<Ranks>);

impl Drop for Before {
    fn drop(&mut self) {
        CURRENT.set(self.0.take());
    }
}

impl Ranks {
    /// One rank, which shares nothing.
    pub fn alone() -> Self {
        Self { shared: None, journal: None }
    }

    /// The ranks that `comm` connects.
    pub fn of(comm: impl Comm + 'static) -> Self {
        let shared =
            (comm.size() > 1).then(|| Arc::new(Shared { comm: Box::new(comm), sent: Counter::default() }));
        Self { shared, journal: None }
    }

    /// The same, which write the pieces of work that they make into a journal, and make none again that it knows.
    #[must_use]
    pub fn recording(&self, journal: Journal) -> Self {
        Self { journal: Some(Arc::new(journal)), ..self.clone() }
    }

    /// Where the pieces of work are written, if they are.
    pub fn journal(&self) -> Option<&Journal> {
        self.journal.as_deref()
    }

    /// Does `work` within these ranks: each of them does it, and all of them share the same things in the same order.
    pub fn within<T>(&self, work: impl FnOnce() -> T) -> T {
        let _before = Before(CURRENT.replace(Some(self.clone())));
        work()
    }

    /// The number of this rank, from 0.
    pub fn number(&self) -> usize {
        self.shared.as_ref().map_or(0, |shared| shared.comm.rank())
    }

    /// How many there are.
    pub fn count(&self) -> usize {
        self.shared.as_ref().map_or(1, |shared| shared.comm.size())
    }

    /// Whether this is the only one.
    pub fn are_alone(&self) -> bool {
        self.shared.is_none()
    }

    /// Whether this is the one that writes.
    pub fn is_first(&self) -> bool {
        self.number() == 0
    }

    /// What of its machine this rank may use.
    pub fn place(&self) -> Place {
        self.shared.as_ref().map_or_else(Place::alone, |shared| shared.comm.place())
    }

    /// Waits for all of them.
    pub fn meet(&self) {
        if let Some(shared) = &self.shared {
            shared.comm.meet();
        }
    }

    /// What this rank has done for all, and sent to others, so far; nothing is counted where it is alone.
    pub fn traffic(&self) -> Traffic {
        self.shared.as_ref().map_or_else(Traffic::default, |shared| shared.sent.read())
    }

    /// Counts kernel samples and rays that this rank has computed for all.
    pub fn count_work(&self, samples: u64, rays: u64) {
        if let Some(shared) = &self.shared {
            shared.sent.count_work(samples, rays);
        }
    }

    /// What each rank has, in their order.
    ///
    /// # Panics
    /// If the ranks do not share the same things in the same order.
    pub fn all<T: Serialize + DeserializeOwned>(&self, own: T) -> Vec<T> {
        let Some(shared) = &self.shared else { return vec![own] };
        let bytes = encoded(&own);
        shared.sent.count(bytes.len() * (self.count() - 1));
        shared.comm.all_gather(bytes).iter().map(|bytes| decoded(bytes)).collect()
    }

    /// Whether any rank says yes.
    pub fn any(&self, own: bool) -> bool {
        if self.are_alone() { own } else { self.all(own).contains(&true) }
    }

    /// What the first of them has: for what may differ from rank to rank, such as the time.
    pub fn of_first<T: Serialize + DeserializeOwned>(&self, own: T) -> T {
        if self.are_alone() {
            return own;
        }
        let all = self.all(self.is_first().then_some(own));
        all.into_iter().flatten().next().expect("there is a first rank")
    }

    /// What each rank has for this one, in their order; `to[k]` is what this one has for rank k.
    ///
    /// # Panics
    /// As [`Ranks::all`].
    pub fn exchange<T: Serialize + DeserializeOwned>(&self, to: Vec<T>) -> Vec<T> {
        let Some(shared) = &self.shared else { return to };
        let bytes: Vec<Vec<u8>> = to.iter().map(encoded).collect();
        let others = bytes.iter().enumerate().filter(|(rank, _)| *rank != self.number());
        shared.sent.count(others.map(|(_, bytes)| bytes.len()).sum());
        shared.comm.exchange(bytes).iter().map(|bytes| decoded(bytes)).collect()
    }

    /// Fills `values`, of which rank k has the part that ends at `ends[k]` and begins where that of the rank before ends.
    pub fn complete(&self, values: &mut [f64], ends: &[usize]) {
        let Some(shared) = &self.shared else { return };
        let own = shares::range(ends, self.number());
        shared.sent.count_numbers(own.len() * (self.count() - 1));
        shared.comm.complete(values, ends);
    }

    /// All `make(k)` for the pieces k of these costs, in order. Each rank makes some of them, in parallel.
    pub fn map<T>(&self, costs: &[f64], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        self.map_by(&shares::by_cost(costs, self.count()), make)
    }

    /// All `make(k)`, in order; that of piece k is made by the rank `makers[k]`.
    pub fn map_by<T>(&self, makers: &[usize], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        self.merged(makers, self.made(makers, make))
    }

    /// All pieces in order, of which each rank has `own`.
    pub fn merged<T: Serialize + DeserializeOwned>(&self, makers: &[usize], own: Vec<T>) -> Vec<T> {
        if self.are_alone() {
            return own;
        }
        let mut parts: Vec<_> = self.all(own).into_iter().map(Vec::into_iter).collect();
        makers.iter().map(|maker| parts[*maker].next().expect("each rank made its pieces")).collect()
    }

    /// Those that this rank makes.
    pub fn made<T>(&self, makers: &[usize], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        let own: Vec<usize> = (0..makers.len()).filter(|piece| makers[*piece] == self.number()).collect();
        self.part(makers.len()).made(&own, make)
    }

    /// The next part of the run, of so many pieces.
    pub fn part(&self, pieces: usize) -> Part<'_> {
        Part { recorded: self.journal.as_ref().map(|journal| journal.part(pieces)) }
    }

    /// All `make(k)` for k below `count`, in order, where each costs about the same: as [`Ranks::map`], with `together` of them as one
    /// piece.
    pub fn map_even<T>(&self, count: usize, together: usize, make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        let piece = |piece: usize| -> Vec<T> {
            (piece * together..((piece + 1) * together).min(count)).map(&make).collect()
        };
        self.map(&vec![1.0; count.div_ceil(together)], piece).into_iter().flatten().collect()
    }

    /// What `make` makes of every item, where that may share things between ranks: in parallel if this rank is alone, else one after
    /// the other.
    pub fn each<I: Sync, T: Send>(&self, items: &[I], make: impl Fn(&I) -> T + Sync) -> Vec<T> {
        if self.are_alone() {
            items.par_iter().map(&make).collect()
        } else {
            items.iter().map(make).collect()
        }
    }
}

/// A part of a run, of which ranks make the pieces.
#[derive(Debug)]
pub struct Part<'a> {
    recorded: Option<RecordedPart<'a>>,
}

impl Part<'_> {
    /// These pieces of it; a few may cost as much as all others together, so that each is scheduled by itself.
    pub fn made<T>(&self, pieces: &[usize], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        let known = |piece: &usize| match &self.recorded {
            Some(part) => part.known_or(*piece, &make),
            None => make(*piece),
        };
        Ranks::alone().within(|| pieces.par_iter().with_max_len(1).map(&known).collect())
    }
}

/// A value as bytes.
fn encoded<T: Serialize>(value: &T) -> Vec<u8> {
    postcard::to_allocvec(value).expect("what ranks share has a length and no maps of unknown size")
}

/// The value of these bytes.
fn decoded<T: DeserializeOwned>(bytes: &[u8]) -> T {
    postcard::from_bytes(bytes).expect("all ranks share the same things in the same order")
}
