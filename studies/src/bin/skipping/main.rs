//! Work that is not done: pairs of elements by class, and rays cast against one ray per kernel sample.
//!
//! `cargo run --release -p radiosity-studies --bin skipping -- [SCENE[:NAME=VALUE] ...]` prints all tables of
//! the scenes named; unless any is, of cornell-box, two-boxes, teapot and a temple of three bays.
//!
//! The first table counts unordered pairs, at the defaults of `radiosity solve`: those that face away, lie in
//! one plane, are hidden wholly or send nothing are skipped; of the others some equal an earlier pair up to
//! similarity. "naive" is one ray per kernel sample of a run without shadows, as a program casts that finds
//! out by rays alone what is between (Zatz 1993): counted, not cast, and of large scenes counted from one
//! pair in 16.
//!
//! The second compares visibility at equal error, and the third sums it up. The naive program multiplies each
//! sample of an n⁴ tensor Gauss rule over two patches by its visibility; n grows until its shadows are within
//! 1 % of those of a converged run:
//!
//! ```text
//! √Σ ‖S_naive − S‖²_F ≤ 1 % · √Σ ‖G‖²_F     over all pairs that anything is hidden of,
//! ```
//!
//! S = G⁰ − G what blockers take from a block, of our runs with the same kernel eps in G⁰ and in G: shadows
//! alone are judged. The converged run is one of the library at 1e-5 where everything is planar, at 3e-4
//! otherwise. Where most elements bend or pairs are many, S is summed instead over 2¹⁹ points of a Kronecker
//! sequence for each pair of patches, each with a ray: this shares with our runs and the naive program
//! nothing but the surfaces. There one pair in so many is judged, taken at random, of those whose boxes do
//! not overlap: in contacts the rules for the kernel itself would be judged. Our kernel eps is 1e-4 there.
//!
//! Its rays are those of these pairs alone, as if the others were known to be free; they are traced one by
//! one through the hierarchy over all surfaces. Ours are by outlines and by rays, with `--shadow-eps` about
//! the default, all pairs that are judged; their seconds of visibility are those of the blocks less those
//! without shadows, which where they are less than a tenth of these are lost in the noise. Seconds are CPU
//! seconds of one thread, the least of three runs where they are short.

#![expect(clippy::print_stdout, reason = "tables for people")]

mod counts;
mod judged;
mod naive;
mod race;
mod subject;

use std::error::Error;

use radiosity::solve::in_threads;

use race::Race;
use subject::Subject;

/// The scenes unless others are named.
const SCENES: [&str; 4] = ["cornell-box", "two-boxes", "teapot", "temple:bays=3"];

fn main() -> Result<(), Box<dyn Error>> {
    let named: Vec<String> = std::env::args().skip(1).collect();
    let names = if named.is_empty() { SCENES.map(str::to_owned).to_vec() } else { named };
    let subjects: Vec<Subject> = names.iter().map(|name| Subject::named(name)).collect::<Result<_, _>>()?;
    counts::print(&subjects)?;
    println!("\n| scene | visibility | error, % | rays | seconds |");
    println!("|{}", " --- |".repeat(5));
    let races: Vec<Race> =
        subjects.iter().map(|subject| in_threads(1, || Race::run(subject))).collect::<Result<_, _>>()?;
    race::print(&races);
    Ok(())
}
