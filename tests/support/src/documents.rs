//! Documents whose figures are made by the commands that they name.
//!
//! A mark stands below its command, which is in back-quotes, or alone in an indented line, and begins with
//! `cargo` or `radiosity`:
//!
//! ```text
//! … Error against time: `cargo run --release -p radiosity-studies --bin read_off`
//! <!-- output -->
//!
//! | way | error, % | s |
//! | --- | --- | ---: |
//! | quick | 0.40 | 0.11 |
//!
//! *Made at d767ce26, 2026-11-27, on 2 × Intel Xeon Processor.*
//!
//! <!-- end -->
//! ```
//!
//! * `<!-- output, shown -->` indents what is printed by four blanks, so that it stays as it is.
//! * `<!-- output, once -->` is made only where a part of its command is asked for: it takes long, or needs
//!   what does not come with the sources.
//! * `<!-- output; a part: COMMAND -->` names a command that prints a part of the rows soon.
//! * `<!-- run -->`, without an end, runs the command for the files it writes; `<!-- drawn -->` does so where
//!   pages are written, not where they are checked.
//! * A block below `<!-- file NAME -->` is a file that the page has its reader write.
//!
//! What is printed is compared with what stands there cell by cell ([`comparison`]). Text repeats a number of
//! a table in front of `<!-- COMMAND → CELLS → COLUMN -->`, which says where it is from ([`quotes`]).

pub mod number;
pub mod block;
pub mod comparison;
pub mod stamp;
pub mod steps;
pub mod shell;
pub mod quotes;
