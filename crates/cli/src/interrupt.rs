//! Ctrl-C ends the program at once and leaves no temporary file, or lets it finish with what it has.
//!
//! Only the sending of rays is asked to stop, where what was sent is wanted: other work, such as a
//! factorisation, would not notice. The handler runs in a thread of its own. It takes the lock under which
//! temporary files are made, named and removed, so that none is half done, and never releases it.

use std::collections::BTreeSet;
use std::io::{Write, stderr};
use std::path::PathBuf;
use std::process::Child;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};
use std::time::Instant;

use radiosity_work::Deadline;
use radiosity_work::ranks::Ranks;

/// The exit code of a program that Ctrl-C ended, by convention of shells: 128 plus the number of the signal,
/// 2.
const EXIT_CODE: i32 = 130;

static TEMPORARY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A program that works for this one.
static EMPLOYED: Mutex<Option<Child>> = Mutex::new(None);

/// Whether messages are left to another rank.
static IS_QUIET: AtomicBool = AtomicBool::new(false);

/// The deadline of work that the first Ctrl-C asks to finish; None where Ctrl-C ends the program at once.
static DEADLINE: OnceLock<Arc<Deadline>> = OnceLock::new();

/// The deadline at the instant `at`, if there is one, made once in a process; from now on Ctrl-C lets work that
/// has this deadline finish with its results so far.
pub(crate) fn soften(at: Option<Instant>) -> Arc<Deadline> {
    Arc::clone(DEADLINE.get_or_init(|| Arc::new(Deadline::at(at))))
}

/// All temporary files; the set has to be locked while one is made, renamed or removed.
pub(crate) fn temporary_files() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Lets Ctrl-C end `program` as well, before it removes the files that this program may be writing.
pub(crate) fn employ(program: Child) {
    *employed() = Some(program);
}

/// The program that was employed; Ctrl-C leaves it alone from now on.
pub(crate) fn dismiss() -> Option<Child> {
    employed().take()
}

fn employed() -> MutexGuard<'static, Option<Child>> {
    EMPLOYED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Lets Ctrl-C from now on remove the temporary files and end the program; the first of these ranks tells of
/// it.
pub(crate) fn watch(ranks: &Ranks) {
    IS_QUIET.store(!ranks.is_first(), Ordering::Relaxed);
    // Where signals cannot be watched Ctrl-C still ends the program, as it always does.
    let _ = ctrlc::set_handler(|| {
        if DEADLINE.get().is_some_and(|deadline| deadline.wish()) {
            tell("\nfinishing with the rays sent so far; Ctrl-C again ends at once\n");
            return;
        }
        let files = temporary_files();
        if let Some(mut program) = dismiss() {
            let _ = program.kill();
            let _ = program.wait();
        }
        for file in files.iter() {
            let _ = std::fs::remove_file(file);
        }
        tell("\ninterrupted\n");
        std::process::exit(EXIT_CODE);
    });
}

/// Writes to stderr, from a thread that belongs to no ranks.
fn tell(text: &str) {
    if !IS_QUIET.load(Ordering::Relaxed) {
        drop(stderr().write_all(text.as_bytes()));
    }
}
