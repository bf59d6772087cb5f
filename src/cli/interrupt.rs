//! Ctrl-C ends the program at once and leaves no temporary file.
//!
//! Work is not asked to stop, it is stopped: a factorisation would not hear. The handler runs in a thread of its own. It takes
//! the lock under which temporary files are made, named and removed, so that none is half-way, and never gives it back.

use std::collections::BTreeSet;
use std::io::{Write, stderr};
use std::path::PathBuf;
use std::sync::{Mutex, MutexGuard, PoisonError};

/// What a shell reports of a program that Ctrl-C ended: 128 and the number of the signal.
const EXIT_CODE: i32 = 130;

static TEMPORARY: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The temporary files there are; the set has to be locked while one is made, renamed or removed.
pub(crate) fn temporary_files() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    TEMPORARY.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on Ctrl-C removes the temporary files and ends the program.
pub(crate) fn watch() {
    // Where signals cannot be watched Ctrl-C still ends the program, as it always does.
    let _ = ctrlc::set_handler(|| {
        let files = temporary_files();
        for file in files.iter() {
            let _ = std::fs::remove_file(file);
        }
        let _ = stderr().write_all(b"\ninterrupted\n");
        std::process::exit(EXIT_CODE);
    });
}
