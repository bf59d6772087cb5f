//! Random interiors: plans with corners that look inwards, partitions with doors, steps, attics, furniture,
//! balls and pipes.
//!
//! Every surface reflects ½ and emits 1, so in a closed interior everything has radiosity 2 and every row of
//! view factors is 1. `cargo test --release --test theorems interiors` tries fifty;
//! `cargo test --release --test theorems interiors -- --ignored --nocapture` tries a thousand and prints what
//! was found.

#![expect(clippy::print_stdout, reason = "what was found is printed with --nocapture")]

mod plan;
mod solid;
mod surface;

mod interior;
mod sensor;

mod furnace;
