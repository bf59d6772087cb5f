//! A number that tells a run from others.

use std::fmt;
use std::fmt::{Debug, Write};
use std::hash::{DefaultHasher, Hasher};

/// Version of the pieces of runs, to be raised where those of one scene and options change their meaning, as coefficients do with
/// the order of the functions of an element, or where types of pieces move, whose paths number the parts of a run.
const PIECES: u32 = 3;

/// A number that tells a run from others: of its scene and options, as they print for programmers, and of the versions of the
/// program and of its pieces.
pub fn fingerprint(run: &dyn Debug) -> u64 {
    digest(&(env!("CARGO_PKG_VERSION"), PIECES, run))
}

/// A number of what this prints. It is the same in every process of one program.
pub(super) fn digest(value: &dyn Debug) -> u64 {
    let mut hashed = Hashed(DefaultHasher::new());
    write!(hashed, "{value:?}").expect("a hash takes all text");
    hashed.0.finish()
}

/// Text that is not kept.
struct Hashed(DefaultHasher);

impl fmt::Write for Hashed {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}
