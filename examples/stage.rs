//! A stage: a lamp that is moved and dimmed from outside, each frame found from the one before.
//!
//! Reads lines such as `lamp -0.5 0 0`, where a motion of the scene takes its things, from rest, and
//! `lamp dim 0.3`, and prints after each what arrives at a point of the floor:
//!
//! ```text
//! printf 'lamp -1 0 0\nlamp dim 0.3\n' | cargo run --release --example stage
//! ```

#![expect(clippy::print_stdout, reason = "a line for each frame")]

use std::error::Error;
use std::io::{BufRead, IsTerminal, stdin};
use std::time::Instant;

use radiosity::geom::{DQuat, DVec3};
use radiosity::scene::Pose;
use radiosity::solve::Direct;
use radiosity::solve::animation::stage::Stage;
use radiosity::{Options, Work};

/// Lines where none are piped in.
const USUAL: &str = "lamp 0 0 0\nlamp -0.5 0 0\nlamp -1 0 0\nlamp dim 0.3\n";

fn main() -> Result<(), Box<dyn Error>> {
    let is_piped = !stdin().is_terminal();
    // Direct light that is split off is found anew in every frame; blocks are kept.
    let options = Options { direct: Direct::Projected, ..Options::default() };
    let mut stage = Stage::new(radiosity::builtin("sliding-light")?, &options)?;
    let typed: Box<dyn BufRead> =
        if is_piped { Box::new(stdin().lock()) } else { Box::new(USUAL.as_bytes()) };
    for line in typed.lines() {
        let line = line?;
        match line.split_whitespace().collect::<Vec<_>>()[..] {
            [mover, "dim", factor] => stage.emit(mover, &vec![factor.parse()?; stage.scene().bands.len()])?,
            [mover, x, y, z] => {
                let shift = DVec3::new(x.parse()?, y.parse()?, z.parse()?);
                stage.move_to(mover, Pose::rigid(DVec3::ZERO, DQuat::IDENTITY, shift)?)?;
            }
            _ => return Err(format!("{line:?} is neither NAME X Y Z nor NAME dim FACTOR").into()),
        }
        let began = Instant::now();
        let frame = stage.frame(&Work::alone())?;
        let milliseconds = began.elapsed().as_secs_f64() * 1e3;
        let (light, unit) = (frame.irradiance_at(DVec3::new(1.0, 1.0, 0.0), DVec3::Z)[0], &frame.scene.unit);
        println!("{line:16} {light:7.3} {unit} on the floor, in {milliseconds:.0} ms");
    }
    Ok(())
}
