//! Jumps of light across the joints at which two surfaces go on smoothly.

use radiosity::solve::Transport;
use radiosity::solve::checks::{JointJump, joint_jump};
use radiosity::{Options, Scene};
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

/// A room with a lamp in a corner of its ceiling, whose floor is made of `floors`.
fn room(floors: &str) -> Scene {
    typed(&format!(
        "materials.wall = {{ reflectance = 0.6 }}
        materials.lamp = {{ reflectance = 0, emission = 10 }}
        surfaces = [
            {{ name = \"room\", material = \"wall\",
                box = {{ origin = [0, 0, 0], size = [4, 3, 2.5], inward = true, open = [\"bottom\"] }} }},
            {{ name = \"lamp\", material = \"lamp\", disk = {{ center = [0.7, 0.6, 2.2], normal = [0, 0, -1], radius = 0.3 }} }},
            {floors}
        ]"
    ))
}

/// The largest jump at seams, and the largest across joints, of light by transfers to this accuracy.
fn jumps(scene: &Scene, order: usize, eps: f64) -> (f64, Option<JointJump>) {
    let options =
        Options { order, subdivide: Some(1), transport: Transport::Exact, eps, ..Options::default() };
    let outcome = outcome_of(scene, &options);
    (outcome.checks.seam_jump_max, joint_jump(&outcome.solution))
}

const WHOLE: &str = "{ name = \"floor\", material = \"wall\", subdivide = [2, 1], \
    parallelogram = { origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 3, 0] } }";

const HALVES: &str = "{ name = \"west\", material = \"wall\", \
        parallelogram = { origin = [0, 0, 0], edge1 = [2, 0, 0], edge2 = [0, 3, 0] } }, \
    { name = \"east\", material = \"wall\", \
        parallelogram = { origin = [2, 0, 0], edge1 = [2, 0, 0], edge2 = [0, 3, 0] } }";

/// A floor of two elements jumps at its seam; a floor of two surfaces by as much at their joint.
#[test]
fn a_joint_jumps_as_a_seam_in_its_place() {
    let (whole, halves) = (room(WHOLE), room(HALVES));
    for order in [0, 2] {
        let (seam, none) = jumps(&whole, order, 1e-4);
        assert!(none.is_none(), "walls meet at right angles");
        let (uncut, joint) = jumps(&halves, order, 1e-4);
        assert_eq!(uncut, 0.0, "surfaces are not cut");
        let found = joint.expect("the halves of the floor lie in one plane");
        let names = found.surfaces.map(|surface| halves.surfaces[surface].name.as_str());
        assert_eq!(names, ["west", "east"]);
        assert!(found.jump > 1e-4 && (found.jump - seam).abs() < 1e-3 * found.jump, "{found:?}");
    }
}

/// Two halves of a column go on smoothly where they meet, as its lid does not: the jump falls with the order.
#[test]
fn curved_surfaces_go_on_smoothly() {
    let half = |name: &str, angles: [f64; 2]| {
        format!(
            "{{ name = \"{name}\", material = \"wall\", \
            cylinder = {{ base = [2.5, 1.5, 0], axis = [0, 0, 1.5], radius = 0.4, angle = {angles:?} }} }}"
        )
    };
    let lid = "{ name = \"lid\", material = \"wall\", disk = { center = [2.5, 1.5, 1.5], normal = [0, 0, 1], radius = 0.4 } }";
    let scene = room(&[WHOLE, &half("near", [90.0, 270.0]), &half("far", [-90.0, 90.0]), lid].join(", "));
    let [low, high] = [1, 4].map(|order| jumps(&scene, order, 1e-3).1.expect("there are joints"));
    for found in [low, high] {
        assert_eq!(found.surfaces.map(|surface| scene.surfaces[surface].name.as_str()), ["near", "far"]);
    }
    assert!(high.jump < 0.5 * low.jump, "{low:?} {high:?}");
}

/// A floor of two halves, on whose joint a screen stands, is lit on one side of it alone: that is no jump.
#[test]
fn a_wall_on_a_joint_parts_it() {
    let screen = "{ name = \"screen\", material = \"wall\", two_sided = true, \
        parallelogram = { origin = [2, 0, 0], edge1 = [0, 3, 0], edge2 = [0, 0, 2.5] } }";
    assert_eq!(jumps(&room(&[HALVES, screen].join(", ")), 2, 1e-3).1, None);
}
