//! Standard output and stderr, of the rank that writes.

use std::io::{self, Write, stderr, stdout};

use radiosity_work::printable::printable_lines;
use radiosity_work::ranks::Ranks;

/// Writes to standard output.
pub(crate) fn print(text: &[u8], ranks: &Ranks) -> io::Result<()> {
    if ranks.is_first() { stdout().write_all(text) } else { Ok(()) }
}

/// Writes lines to stderr, as a terminal prints them. A closed one is no error: nobody would see a message.
pub(crate) fn tell(lines: &[String], ranks: &Ranks) {
    if ranks.is_first() {
        drop(stderr().write_all(printable_lines(&(lines.join("\n") + "\n")).as_bytes()));
    }
}
