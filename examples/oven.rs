//! Heat of an oven: which temperatures its walls take, and how many watts its load draws.
//!
//! ```text
//! cargo run --release --example oven
//! ```

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::error::Error;

use radiosity::Work;
use radiosity::heat::{Heat, HeatOptions};
use radiosity::language;
use radiosity::scene::Source;

/// A plate at 1200 K over a ball at 400 K in a box of bricks, which send back what they receive. Metres.
const OVEN: &str = r#"
materials.heater = { emissivity = 0.9, temperature = 1200 }
materials.steel = { emissivity = 0.8, temperature = 400 }
materials.brick = { emissivity = 0.7, adiabatic = true }
[[surfaces]]
name = "heater"
material = "heater"
quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }
[[surfaces]]
name = "wall"
material = "brick"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true, open = ["top"] }
[[surfaces]]
name = "load"
material = "steel"
sphere = { center = [0.5, 0.5, 0.4], radius = 0.2 }
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let scene = language::read(&Source::new("oven.toml", OVEN))?;
    let heat = Heat::of(&scene, &HeatOptions::default(), &Work::alone())?;
    for own in &heat.surfaces {
        let (kelvin, watts) = (own.temperature, own.flow);
        println!("{:12} {kelvin:6.1} ± {:.1} K {watts:9.1} W", own.name, own.temperature_error);
    }
    // In a closed oven as much heat arrives as leaves.
    println!("out of balance by {:.2} W", heat.lost);
    Ok(())
}
