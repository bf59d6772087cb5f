//! A room made in code: walls, a lamp under the ceiling and a ball on the floor.
//!
//! Prints the mean irradiance of the floor and the irradiance on a desk:
//!
//! ```text
//! cargo run --release --example room
//! ```

#![expect(clippy::print_stdout, reason = "two numbers for people")]

use std::error::Error;

use radiosity::geom::DVec3;
use radiosity::geom::shapes::{Disk, FULL_TURN, Parallelogram, Sphere};
use radiosity::{Material, Options, SceneBuilder, Solved, Work};

fn main() -> Result<(), Box<dyn Error>> {
    // Metres; fronts face inwards: a front is on the side that edge1 × edge2 points to.
    let (o, x, y, z) = (DVec3::ZERO, 4.0 * DVec3::X, 3.0 * DVec3::Y, 2.5 * DVec3::Z);
    let mut room = SceneBuilder::new("room", ["grey"]);
    let white = room.material("white", Material::new(vec![0.7], vec![0.0])?);
    let glow = room.material("glow", Material::new(vec![0.0], vec![1000.0])?);
    let sides = [("floor", o, x, y), ("ceiling", z, y, x), ("west", o, y, z), ("east", x, z, y)];
    for (name, origin, edge1, edge2) in sides.into_iter().chain([("south", o, z, x), ("north", y, x, z)]) {
        room.surface(name, Parallelogram::new(origin, edge1, edge2)?, &white);
    }
    let below_the_ceiling = DVec3::new(2.0, 1.5, 2.4);
    room.surface("lamp", Disk::new(below_the_ceiling, -DVec3::Z, 0.3, 0.0, FULL_TURN)?, &glow);
    let on_the_floor = DVec3::new(1.0, 1.5, 0.4);
    room.surface("ball", Sphere::new(on_the_floor, 0.4, DVec3::Z, [-0.4, 0.4], FULL_TURN)?, &white).order(4);

    let solved = Solved::new(room.build()?, Options::default(), &Work::alone())?;
    let (floor, solution) = (solved.scene.surface_named("floor")?, &solved.outcome.solution);
    println!("floor: {:.1} W/m² on average", solution.mean_irradiance(0, floor));
    let desk = solved.irradiance_at(DVec3::new(3.0, 1.5, 0.75), DVec3::Z);
    println!("desk: {:.1} W/m²", desk[0]);
    Ok(())
}
