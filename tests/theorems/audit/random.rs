//! Random rooms: furnaces of boxes with boxes and balls in them, lamps above points.

use proptest::prelude::*;
use radiosity::Scene;
use radiosity_geom::DVec3;
use radiosity_test_support::random::seeded;
use radiosity_test_support::scenes::typed;

use super::lamps::{EXITANCE, lambert};
use super::trial::Trial;

/// |t| that one reading in 10⁵ exceeds (Student's distribution, ν = 7).
const FARTHEST: f64 = 11.2;

/// A furnace of a box of these sides and reflectances, with a crate and a ball in it: 2 arrives everywhere.
fn furnace(sides: [f64; 3], [wall, crate_, ball]: [f64; 3], place: [f64; 3]) -> Scene {
    let paint = |reflectance: f64| {
        format!("{{ reflectance = {reflectance:?}, emission = {:?} }}", 2.0 * (1.0 - reflectance))
    };
    let part = |k: usize, share: f64| share * sides[k];
    let origin = [0, 1, 2].map(|k| part(k, 0.1 + 0.3 * place[k]));
    let size = [0, 1, 2].map(|k| part(k, 0.1 + 0.1 * place[(k + 1) % 3]));
    let radius = 0.12 * sides.into_iter().fold(f64::MAX, f64::min);
    let center = [0, 1, 2].map(|k| part(k, 0.78));
    typed(&format!(
        r#"
bands = ["lm"]
materials.wall = {}
materials.crate = {}
materials.ball = {}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = {sides:?}, inward = true }}
[[surfaces]]
name = "crate"
material = "crate"
box = {{ origin = {origin:?}, size = {size:?} }}
[[surfaces]]
name = "ball"
material = "ball"
sphere = {{ center = {center:?}, radius = {radius:?} }}
"#,
        paint(wall),
        paint(crate_),
        paint(ball)
    ))
}

fn assert_right(trial: &Trial, walks: f64, seed: u64) -> Result<(), TestCaseError> {
    let quotients = trial.quotients(walks, seed);
    prop_assert!(quotients.iter().all(|own| own.abs() < FARTHEST), "{quotients:?}");
    Ok(())
}

proptest! {
    #![proptest_config(seeded(12, 61))]

    #[test]
    fn random_boxes_are_furnaces(
        sides in prop::array::uniform3(0.5_f64..20.0),
        paints in prop::array::uniform3(0.0_f64..0.9),
        place in prop::array::uniform3(0.0_f64..1.0),
        seed in 0..1000_u64,
    ) {
        let trial = Trial::of("random box", furnace(sides, paints, place)).everywhere(10, &[2.0]);
        assert_right(&trial, 256.0, seed)?;
    }

    /// A square lamp on a black tile, as seen from a point below it.
    #[test]
    fn random_lamps_give_lamberts_form(
        side in 0.01_f64..3.0,
        height in 0.05_f64..10.0,
        [x, y] in prop::array::uniform2(-5.0_f64..5.0),
        tilt in prop::array::uniform2(-0.05_f64..0.05),
        seed in 0..1000_u64,
    ) {
        let corner = DVec3::new(-0.5 * side, -0.5 * side, height);
        let (a, b) = (side * DVec3::Y, side * DVec3::X);
        let text = format!(
            "bands = [\"lm\"]\nmaterials.glow = {{ reflectance = 0, emission = {EXITANCE:?} }}\n\
             [[surfaces]]\nname = \"lamp\"\nmaterial = \"glow\"\n\
             parallelogram = {{ origin = {:?}, edge1 = {:?}, edge2 = {:?} }}\n",
            corner.to_array(), a.to_array(), b.to_array()
        );
        let corners = [corner, corner + a, corner + a + b, corner + b];
        let normal = DVec3::new(tilt[0] * height, tilt[1] * height, 1.0).normalize();
        let point = DVec3::new(x, y, 0.0);
        prop_assume!(corners.iter().all(|own| normal.dot(*own - point) > 0.0));
        let exact = lambert(&corners, point, normal).abs();
        let trial = Trial::of("random lamp", typed(&text)).point(point, normal, exact);
        assert_right(&trial, 1024.0, seed)?;
    }
}
