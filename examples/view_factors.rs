//! View factors of a scene that is written down: how much of what leaves one surface arrives at another.
//!
//! ```text
//! cargo run --release --example view_factors
//! ```

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;

use radiosity::Work;
use radiosity::kernel::Accuracy;
use radiosity::scene::Source;
use radiosity::{ViewFactors, language, solve::view_factors::Options};

/// A ball that hovers between two square plates.
const SCENE: &str = r#"
[[surfaces]]
name = "floor"
parallelogram = { origin = [-1, -1, 0], edge1 = [2, 0, 0], edge2 = [0, 2, 0] }
[[surfaces]]
name = "roof"
parallelogram = { origin = [-1, -1, 2], edge1 = [0, 2, 0], edge2 = [2, 0, 0] }
[[surfaces]]
name = "ball"
sphere = { center = [0, 0, 1], radius = 0.5 }
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = language::read(&Source::new("plates.toml", SCENE))?;
    let options =
        Options { accuracy: Accuracy { eps: 1e-4, shadow_eps: 1e-4 }, threads: 2, ..Options::default() };
    let factors = ViewFactors::new(&scene, &options, &Work::alone())?;
    for (i, from) in factors.names.iter().enumerate() {
        for (j, factor) in factors.nonzeros(i) {
            println!("{from:5} to {:5} {factor:.5}", factors.names[j]);
        }
    }
    // What is missing from 1 leaves between the plates.
    println!("sums of rows: {:.4?}", factors.row_sums());
    println!("left in blocks: {:.0e}", factors.left_in_blocks);
    Ok(())
}
