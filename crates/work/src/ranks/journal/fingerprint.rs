//! A number that tells a run from others.

use std::fmt;
use std::fmt::{Debug, Write};
use std::hash::{DefaultHasher, Hasher};

/// A number that tells a run from others: of its scene and options, as they print for programmers, and of the
/// version of the program.
pub fn fingerprint(run: &dyn Debug) -> u64 {
    digest(&(env!("CARGO_PKG_VERSION"), run))
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
