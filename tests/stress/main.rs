//! Stability: how far the numbers hold where they are strained. Each test prints a row of a table.
//!
//! `cargo test --release --test stress -- --nocapture` tries some cases of each kind,
//! `cargo test --release --test stress -- --ignored --nocapture` many. Random shapes are hunted in
//! `theorems/transport`, polynomials and rules are held against 320 binary digits in `core/tests`, solvers
//! against exact residuals in `solvers/tests`.

#![expect(clippy::print_stdout, reason = "each test prints its row of the table")]

mod double;
mod row;

mod convex;
mod estimate;
mod exchange;
mod lambert;
mod orders;
mod polynomials;
mod rooms;
mod scales;
mod solvers;
