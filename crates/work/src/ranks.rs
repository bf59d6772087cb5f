//! Ranks: processes, each with threads of its own, that share the work of one run.
//!
//! Every rank runs the same program on the same scene: whatever is decided follows from data that all of them
//! have. Only the heavy parts are shared: of a list of pieces, each rank makes those that are its own, and
//! then sends them to the ranks that need them ([`Ranks::map`], [`Ranks::exchange`]). A piece is the same
//! whoever makes it, and sums are taken in an order that does not depend on how the pieces were shared, so
//! that the number of ranks changes no bit of a result.
//!
//! Ranks are handed down to whatever has something to share ([`Work`](crate::Work)). Nothing is shared within
//! a piece: what makes it, and would share something by itself, is given [`Ranks::alone`].

pub mod machine_share;
mod bytes;
pub mod comm;
mod part_name;
pub mod journal;
pub mod shares;
pub mod threads;
mod traffic;
pub mod failure;
pub mod vector;

use std::fmt::Debug;
use std::path::Path;
use std::sync::Arc;

use rayon::prelude::*;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::interruption::check_interrupt;
use bytes::{decoded, encoded};
use comm::Comm;
use journal::{Begin, Journal, JournalError, RecordedPart};
use machine_share::MachineShare;
pub use part_name::PartName;
use traffic::Counter;
pub use traffic::Traffic;

/// A rank that is alone and shares nothing.
static ALONE: Ranks = Ranks { shared: None, journal: None };

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

impl Ranks {
    /// A rank that is alone: it shares nothing and records nothing.
    pub fn alone() -> &'static Self {
        &ALONE
    }

    /// The ranks that `comm` connects.
    pub fn of(comm: impl Comm + 'static) -> Self {
        let shared =
            (comm.size() > 1).then(|| Arc::new(Shared { comm: Box::new(comm), sent: Counter::default() }));
        Self { shared, journal: None }
    }

    /// These ranks, with a journal in `folder`, of the run with this fingerprint: they write each piece of
    /// work that they make into it, and make none again that it knows.
    ///
    /// # Errors
    /// A folder that cannot be written, or that holds what `begin` does not say.
    pub fn recording(&self, folder: &Path, fingerprint: u64, begin: Begin) -> Result<Self, JournalError> {
        let journal = Journal::open(folder, fingerprint, begin, self.number(), &|own| self.any(own))?;
        Ok(Self { journal: Some(Arc::new(journal)), ..self.clone() })
    }

    /// This rank, which is alone, with the transfers between the surfaces of this fingerprint that the file at `path`
    /// keeps: it makes none again, and adds what it makes.
    ///
    /// # Errors
    /// A file that cannot be read and written, or that holds something else.
    pub fn keeping_transfers(&self, path: &Path, surfaces: u64) -> Result<Self, JournalError> {
        let journal = Journal::of_transfers(path, surfaces)?;
        Ok(Self { journal: Some(Arc::new(journal)), ..self.clone() })
    }

    /// Where the pieces of work are written, if they are.
    pub fn journal(&self) -> Option<&Journal> {
        self.journal.as_deref()
    }

    /// Whether all work is recorded, for a run that goes on.
    pub fn record_all(&self) -> bool {
        self.journal().is_some_and(|journal| !journal.is_of_transfers())
    }

    /// Notes all that the pairs, blocks and rays to come follow from: elements, who sends, and how accurate they are.
    /// A file of transfers knows them by that alone.
    pub fn note_assembly(&self, assembly: &dyn Debug) {
        if let Some(journal) = &self.journal {
            journal.note_assembly(assembly);
        }
    }

    /// Notes what was chosen for the work to come where that does not follow from the fingerprint of the run
    /// alone, but from time or memory too: a journal takes none of its pieces for those of another choice.
    pub fn note_choice(&self, choice: &dyn Debug) {
        if let Some(journal) = &self.journal {
            journal.note_choice(choice);
        }
    }

    /// The number of this rank, from 0.
    pub fn number(&self) -> usize {
        self.shared.as_ref().map_or(0, |shared| shared.comm.rank())
    }

    /// Number of ranks.
    pub fn count(&self) -> usize {
        self.shared.as_ref().map_or(1, |shared| shared.comm.size())
    }

    /// Whether this rank is the only one.
    pub fn are_alone(&self) -> bool {
        self.shared.is_none()
    }

    /// Whether this rank is the first, which writes.
    pub fn is_first(&self) -> bool {
        self.number() == 0
    }

    /// The share of its machine that this rank may use.
    pub fn machine_share(&self) -> MachineShare {
        self.shared.as_ref().map_or_else(MachineShare::alone, |shared| shared.comm.machine_share())
    }

    /// The threads to run where so many are `asked` for; 0 asks for all that this rank may use.
    pub fn threads(&self, asked: usize) -> usize {
        if asked == 0 { self.machine_share().threads } else { asked }
    }

    /// Waits for all ranks.
    pub fn meet(&self) {
        if let Some(shared) = &self.shared {
            shared.comm.meet();
        }
    }

    /// Work that this rank has done for all, and bytes sent to others, so far; nothing is counted where it is
    /// alone.
    pub fn traffic(&self) -> Traffic {
        self.shared.as_ref().map_or_else(Traffic::default, |shared| shared.sent.read())
    }

    /// Counts kernel samples and rays that this rank has computed for all.
    pub fn count_work(&self, samples: u64, rays: u64) {
        if let Some(shared) = &self.shared {
            shared.sent.count_work(samples, rays);
        }
    }

    /// The value of each rank, in their order.
    ///
    /// # Panics
    /// If the ranks do not share the same things in the same order.
    pub fn all<T: Serialize + DeserializeOwned>(&self, own: T) -> Vec<T> {
        let Some(shared) = &self.shared else { return vec![own] };
        let bytes = encoded(&own);
        shared.sent.count(bytes.len() * (self.count() - 1));
        shared.comm.all_gather(bytes).iter().map(|bytes| decoded(bytes)).collect()
    }

    /// The sums over all ranks of each of these counts.
    pub fn sums(&self, own: Vec<u64>) -> Vec<u64> {
        let mut all = self.all(own).into_iter();
        let first = all.next().expect("there is a first rank");
        all.fold(first, |sums, more| sums.iter().zip(more).map(|(sum, more)| sum + more).collect())
    }

    /// Whether any rank says yes.
    pub fn any(&self, own: bool) -> bool {
        if self.are_alone() { own } else { self.all(own).contains(&true) }
    }

    /// The first rank that has something else than rank 0, if there is one.
    ///
    /// # Panics
    /// As [`Ranks::all`].
    pub fn differing<T: Serialize + DeserializeOwned + PartialEq>(&self, own: T) -> Option<usize> {
        let all = self.all(own);
        all.iter().position(|other| *other != all[0])
    }

    /// The value of the first rank: for what may differ from rank to rank, such as the time.
    pub fn of_first<T: Serialize + DeserializeOwned>(&self, own: T) -> T {
        if self.are_alone() {
            return own;
        }
        let all = self.all(self.is_first().then_some(own));
        all.into_iter().flatten().next().expect("there is a first rank")
    }

    /// The value of each rank for this one, in their order; `to[k]` is the value of this one for rank k.
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

    /// Fills `values`, of which rank k has the part that ends at `ends[k]` and begins where that of the rank
    /// before ends.
    pub fn complete(&self, values: &mut [f64], ends: &[usize]) {
        let Some(shared) = &self.shared else { return };
        let own = shares::range(ends, self.number());
        shared.sent.count_numbers(own.len() * (self.count() - 1));
        shared.comm.complete(values, ends);
    }

    /// All `make(k)` for the pieces k of a part, of these costs, in order. Each rank makes some of them, in
    /// parallel. What a piece would share by itself it has to share with [`Ranks::alone`]: others are at
    /// other pieces.
    pub fn map<T>(&self, part: PartName, costs: &[f64], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        self.map_by(part, &shares::by_cost(costs, self.count()), make)
    }

    /// All `make(k)` of a part, in order; that of piece k is made by the rank `makers[k]`.
    pub fn map_by<T>(&self, part: PartName, makers: &[usize], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        self.merged(makers, self.made(part, makers, make))
    }

    /// All pieces in order, of which each rank has `own`.
    pub fn merged<T: Serialize + DeserializeOwned>(&self, makers: &[usize], own: Vec<T>) -> Vec<T> {
        if self.are_alone() {
            return own;
        }
        let mut parts: Vec<_> = self.all(own).into_iter().map(Vec::into_iter).collect();
        makers.iter().map(|maker| parts[*maker].next().expect("each rank made its pieces")).collect()
    }

    /// The pieces that this rank makes, in their order.
    pub fn made<T>(&self, part: PartName, makers: &[usize], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        let own: Vec<usize> = (0..makers.len()).filter(|piece| makers[*piece] == self.number()).collect();
        self.part(part, makers.len()).made(&own, make)
    }

    /// The next part of the run, of so many pieces.
    pub fn part(&self, name: PartName, pieces: usize) -> Part<'_> {
        Part { recorded: self.journal.as_ref().and_then(|journal| journal.part(name, pieces)) }
    }

    /// All `make(k)` for k below `count`, in order, where each costs about the same: as [`Ranks::map`], with
    /// `together` of them as one piece.
    pub fn map_even<T>(
        &self,
        part: PartName,
        count: usize,
        together: usize,
        make: impl Fn(usize) -> T + Sync,
    ) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        let piece = |piece: usize| -> Vec<T> {
            let make = |k: usize| {
                check_interrupt();
                make(k)
            };
            (piece * together..((piece + 1) * together).min(count)).map(make).collect()
        };
        self.map(part, &vec![1.0; count.div_ceil(together)], piece).into_iter().flatten().collect()
    }

    /// The result of `make` for every item, where that may share things between the ranks that it is given:
    /// in parallel if this rank is alone, else one after the other. They record nothing, as parts that follow
    /// each other in any order have no numbers.
    pub fn each<I: Sync, T: Send>(&self, items: &[I], make: impl Fn(&I, &Self) -> T + Sync) -> Vec<T> {
        let unrecorded = Self { journal: None, ..self.clone() };
        let make = |item: &I| {
            check_interrupt();
            make(item, &unrecorded)
        };
        if self.are_alone() { items.par_iter().map(make).collect() } else { items.iter().map(make).collect() }
    }
}

/// A part of a run, of which ranks make the pieces.
#[derive(Debug)]
pub struct Part<'a> {
    recorded: Option<RecordedPart<'a>>,
}

impl Part<'_> {
    /// A part that no journal keeps.
    pub fn unrecorded() -> Self {
        Self { recorded: None }
    }

    /// Pieces of this part by their numbers; a few may cost as much as all others together, so that each is
    /// scheduled by itself.
    pub fn made<T>(&self, pieces: &[usize], make: impl Fn(usize) -> T + Sync) -> Vec<T>
    where
        T: Serialize + DeserializeOwned + Send,
    {
        let known = |piece: &usize| {
            check_interrupt();
            match &self.recorded {
                Some(part) => part.known_or(*piece, &make),
                None => make(*piece),
            }
        };
        pieces.par_iter().with_max_len(1).map(known).collect()
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::threads::on_ranks;
    use super::*;

    /// Squares of 20 numbers, twice, on so many ranks; how many were made.
    fn run(folder: &Path, begin: Begin, ranks: usize, made: &AtomicUsize) -> Vec<Vec<f64>> {
        let found = on_ranks(ranks, |ranks| {
            let ranks = ranks.recording(folder, 7, begin).expect("a folder that can be written");
            let square = |piece: usize| {
                made.fetch_add(1, Ordering::Relaxed);
                (piece as f64 / 7.0).powi(2)
            };
            [(); 2].map(|()| ranks.map(PartName::Points, &[1.0; 20], square)).concat()
        });
        let all: Vec<f64> = (0..40).map(|k| (f64::from(k % 20) / 7.0).powi(2)).collect();
        assert!(found.iter().all(|found| *found == all));
        found
    }

    #[test]
    fn a_run_goes_on_where_it_was_torn_on_any_number_of_ranks() {
        let folder = tempfile::tempdir().expect("a folder");
        let (folder, made) = (folder.path(), AtomicUsize::new(0));
        run(folder, Begin::Anew, 3, &made);
        assert_eq!(made.swap(0, Ordering::Relaxed), 40);
        run(folder, Begin::Resume, 2, &made);
        assert_eq!(made.swap(0, Ordering::Relaxed), 0, "all is known");
        // One of the files loses its last bytes, and with them one piece.
        let torn = folder.join("000000-000001.journal");
        let bytes = fs::read(&torn).expect("it was written");
        fs::write(&torn, &bytes[..bytes.len() - 3]).expect("it can be written");
        run(folder, Begin::Resume, 1, &made);
        assert_eq!(made.swap(0, Ordering::Relaxed), 1);
    }

    #[test]
    fn ranks_that_differ_are_named() {
        for (rank, differing) in [(2, Some(2)), (0, Some(1)), (9, None)] {
            let found = on_ranks(3, |ranks| ranks.differing(ranks.number() == rank));
            assert_eq!(found, [differing; 3], "{rank}");
        }
    }

    #[test]
    fn what_does_not_belong_together_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        let folder = folder.path();
        let open = |fingerprint, begin| Ranks::alone().recording(folder, fingerprint, begin).map(drop);
        open(1, Begin::Resume).expect("a run that was ended before its first record begins anew");
        open(1, Begin::Anew).expect("nothing is there");
        let recording = Ranks::alone().recording(folder, 1, Begin::Anew).expect("nothing is there");
        recording.map(PartName::Points, &[1.0; 2], |piece| piece);
        drop(recording);
        assert!(matches!(open(1, Begin::Anew), Err(JournalError::Used { .. })));
        assert!(matches!(open(2, Begin::Resume), Err(JournalError::Other { .. })));
        open(1, Begin::Resume).expect("it is the same run");
    }

    #[test]
    fn a_run_that_did_nothing_leaves_nothing() {
        let parent = tempfile::tempdir().expect("a folder");
        let folder = parent.path().join("of-the-run");
        on_ranks(3, |ranks| drop(ranks.recording(&folder, 1, Begin::Anew).expect("it can be made")));
        assert!(!folder.exists());
        fs::create_dir(&folder).expect("it can be made");
        drop(Ranks::alone().recording(&folder, 1, Begin::Anew).expect("it is there"));
        assert_eq!(fs::read_dir(&folder).expect("it was there before").count(), 0);
    }

    /// Pieces of transfers of an assembly of this number, and of a part that is none; how many were made.
    fn transfers(path: &Path, assembly: u64) -> [usize; 2] {
        let ranks = Ranks::alone().keeping_transfers(path, 7).expect("a file that can be written");
        let made = AtomicUsize::new(0);
        let mut counts = [0; 2];
        ranks.note_assembly(&assembly);
        for (count, part) in counts.iter_mut().zip([PartName::Points, PartName::Blocks]) {
            let product = |piece: usize| {
                made.fetch_add(1, Ordering::Relaxed);
                assembly * piece as u64
            };
            let found = ranks.map(part, &[1.0; 5], product);
            assert_eq!(found, [0, 1, 2, 3, 4].map(|piece| assembly * piece));
            *count = made.swap(0, Ordering::Relaxed);
        }
        counts
    }

    #[test]
    fn transfers_are_kept_by_their_assembly_in_whatever_order() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("kept.transfers");
        assert_eq!(transfers(&path, 2), [5, 5], "nothing is kept yet");
        assert_eq!(transfers(&path, 3), [5, 5], "another assembly");
        assert_eq!([2, 3].map(|assembly| transfers(&path, assembly)), [[5, 0]; 2]);
        // The last record is torn, and written anew.
        let bytes = fs::read(&path).expect("it was written");
        fs::write(&path, &bytes[..bytes.len() - 3]).expect("it can be written");
        assert_eq!(transfers(&path, 3), [5, 1]);
        assert_eq!(fs::read(&path).expect("it is there"), bytes);
        let other = Ranks::alone().keeping_transfers(&path, 8).map(drop);
        assert!(matches!(other, Err(JournalError::OtherGeometry { .. })));
        let zeros = folder.path().join("zeros");
        fs::write(&zeros, [0; 4096]).expect("it can be written");
        let other = Ranks::alone().keeping_transfers(&zeros, 7).map(drop);
        assert!(matches!(other, Err(JournalError::OtherGeometry { .. })), "{other:?}");
        assert_eq!(fs::read(&zeros).expect("it is there"), [0; 4096]);
        let first = Ranks::alone().keeping_transfers(&path, 7).expect("nobody holds it");
        let second = Ranks::alone().keeping_transfers(&path, 7).map(drop);
        assert!(cfg!(windows) || matches!(second, Err(JournalError::Held { .. })), "{second:?}");
        drop(first);
        assert_eq!(transfers(&path, 3), [5, 0]);
        drop(Ranks::alone().keeping_transfers(&folder.path().join("unused"), 7).expect("it can be made"));
        assert!(!folder.path().join("unused").exists());
    }

    #[test]
    fn ranks_that_were_killed_as_they_began_are_no_other_run() {
        let folder = tempfile::tempdir().expect("a folder");
        let (folder, made) = (folder.path(), AtomicUsize::new(0));
        run(folder, Begin::Anew, 2, &made);
        let header = fs::read(folder.join("000000-000000.journal")).expect("it was written")[..20].to_vec();
        for (rank, begun) in [&[][..], &header[..7], &header[..12], &[0; 40]].into_iter().enumerate() {
            fs::write(folder.join(format!("000004-{rank:06}.journal")), begun).expect("it can be written");
        }
        // Numbers go on behind the largest, whatever files were removed.
        fs::remove_file(folder.join("000000-000000.journal")).expect("it is there");
        made.store(0, Ordering::Relaxed);
        run(folder, Begin::Resume, 2, &made);
        assert!((1..40).contains(&made.load(Ordering::Relaxed)));
        assert!(folder.join("000005-000000.journal").exists());
        let other = folder.join("000004-000000.journal");
        fs::write(&other, [&header[..8], &[1; 4]].concat()).expect("it can be written");
        let opened = Ranks::alone().recording(folder, 7, Begin::Resume).map(drop);
        assert!(matches!(opened, Err(JournalError::Other { path }) if path == other));
    }

    #[test]
    fn what_an_earlier_version_recorded_is_refused_by_name() {
        let folder = tempfile::tempdir().expect("a folder");
        let old = folder.path().join("000000-000000.journal");
        fs::write(&old, [&b"RADJRNL1"[..], &7u64.to_le_bytes(), &[0; 40]].concat())
            .expect("it can be written");
        let opened = Ranks::alone().recording(folder.path(), 7, Begin::Resume).map(drop);
        let refused = opened.expect_err("its pieces are of no use");
        assert!(matches!(&refused, JournalError::Earlier { path } if *path == old), "{refused}");
        assert!(refused.cure().contains("another folder"), "{}", refused.cure());
    }

    /// The results of three parts whose pieces are as many and of one name, where something is chosen before
    /// the second.
    fn chosen(folder: &Path, begin: Begin, choice: u64) -> Vec<u64> {
        let ranks = Ranks::alone().recording(folder, 1, begin).expect("a folder");
        let part = |of: u64| ranks.map(PartName::Points, &[1.0; 4], |piece| 100 * of + piece as u64);
        let first = part(0);
        ranks.note_choice(&choice);
        [first, part(choice), part(choice + 1)].concat()
    }

    #[test]
    fn a_run_that_takes_another_way_finds_no_foreign_pieces() {
        let [folder, other] = [(); 2].map(|()| tempfile::tempdir().expect("a folder"));
        chosen(folder.path(), Begin::Anew, 1);
        assert_eq!(chosen(folder.path(), Begin::Resume, 2), chosen(other.path(), Begin::Anew, 2));
    }

    #[test]
    fn pieces_that_ranks_share_within_others_are_not_recorded() {
        let folder = tempfile::tempdir().expect("a folder");
        for ranks in [1, 2] {
            let begin = if ranks == 1 { Begin::Anew } else { Begin::Resume };
            let found = on_ranks(ranks, |ranks| {
                let ranks = ranks.recording(folder.path(), 1, begin).expect("a folder");
                let inner = |item: &u64, ranks: &Ranks| {
                    ranks.map(PartName::Points, &[1.0; 3], |piece| item + piece as u64)
                };
                (ranks.each(&[10, 20], inner).concat(), ranks.map(PartName::Cells, &[1.0], |piece| piece))
            });
            assert_eq!(found, vec![(vec![10, 11, 12, 20, 21, 22], vec![0]); ranks]);
        }
    }
}
