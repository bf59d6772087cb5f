//! The README: its program is the example, and its sizes are those of the types.

use radiosity_core::basis::triangle::Collapsed;
use radiosity_core::gauss::Rule;
use radiosity_core::jacobi::{Entry, Polynomials};
use radiosity_core::recurrence::Recurrence;

const README: &str = include_str!("../../README.md");

#[test]
fn the_program_is_the_example() {
    let example = include_str!("../../examples/embedded.rs");
    let (program, _) = example.split_once("\n#[cfg(test)]").expect("it tests itself");
    let program = &program[program.find("\nuse ").expect("imports") + 1..];
    assert!(README.contains(&format!("```rust\n{program}```")));
}

#[test]
fn the_sizes_are_those_of_the_types() {
    assert!(README.contains("| 16 N | 32 N | 88 N + 32 | 24 N + 16 | 64 |"));
    assert_eq!([size_of::<Rule<1>>(), size_of::<Rule<20>>()], [16, 16 * 20]);
    assert_eq!([size_of::<Collapsed<1>>(), size_of::<Collapsed<20>>()], [32, 32 * 20]);
    assert_eq!([size_of::<Polynomials<1>>(), size_of::<Polynomials<20>>()], [88 + 32, 88 * 20 + 32]);
    assert_eq!([size_of::<Recurrence<1>>(), size_of::<Recurrence<20>>()], [24 + 16, 24 * 20 + 16]);
    assert_eq!(size_of::<Entry>(), 64);
}
