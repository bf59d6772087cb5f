//! Row sums in closed rooms: all that leaves a lamp reaches something, whatever curved things stand around
//! it; and nothing reaches the room next door.

use std::fmt::Write;

use radiosity::Work;
use radiosity::kernel::Accuracy;
use radiosity::solve::{Options, Transport};
use radiosity::transport;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_core::dot;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::{elements_of, outcome_of};

/// Row sum Σ_j F_ij of the surface `name`, which is one element, at the default accuracies.
fn row_sum(text: &str, name: &str, order: usize) -> f64 {
    let scene = typed(text);
    let accuracy = Accuracy { eps: 1e-3, shadow_eps: 3e-3 };
    let visibility = Visibility::new(&scene, Shadows::Auto, accuracy.shadow_eps);
    let elements = elements_of(&scene, order, 1);
    let row = elements.of_surface(scene.surface_named(name).expect("it is there")).start;
    let wanted = |i: usize, j: usize| i == row || j == row;
    let blocks = transport::assemble(
        transport::Demand::all(&elements, &visibility, accuracy).of(&wanted),
        None,
        &Work::alone(),
    );
    let transported = blocks.apply(&elements.constant());
    let element = &elements.list()[row];
    let own = &transported[blocks.starts()[row]..];
    element.constant.iter().zip(own).map(|(c, gc)| c * gc).sum::<f64>() / element.area
}

fn surface(text: &mut String, name: &str, shape: &str) {
    write!(text, "[[surfaces]]\nname = {name:?}\n{shape}\n").expect("a String takes all text");
}

/// A room with a pilaster before a wall, which is two pieces, and a cylinder between disks that hangs in the
/// room.
fn pilaster() -> String {
    let mut text = String::new();
    let mut rectangle = |name: &str, [origin, edge1, edge2]: [[f64; 3]; 3]| {
        let shape =
            format!("parallelogram = {{ origin = {origin:?}, edge1 = {edge1:?}, edge2 = {edge2:?} }}");
        surface(&mut text, name, &shape);
    };
    let [x, y, z] = [[4.0, 0.0, 0.0], [0.0, 4.0, 0.0], [0.0, 0.0, 4.0]];
    rectangle("floor", [[0.0; 3], x, y]);
    rectangle("ceiling", [z, y, x]);
    rectangle("x0", [[0.0; 3], y, z]);
    rectangle("y0", [[0.0; 3], z, x]);
    rectangle("y1", [y, x, z]);
    let [piece, width, depth] = [[0.0, 1.7, 0.0], [0.0, 0.6, 0.0], [0.18, 0.0, 0.0]];
    rectangle("near", [x, z, piece]);
    rectangle("far", [[4.0, 2.3, 0.0], z, piece]);
    rectangle("front", [[3.82, 1.7, 0.0], z, width]);
    rectangle("low-side", [[3.82, 1.7, 0.0], depth, z]);
    rectangle("high-side", [[3.82, 2.3, 0.0], z, depth]);
    surface(&mut text, "lamp", "cylinder = { base = [1.6, 3.2, 1.7], axis = [0, 0, 0.6], radius = 0.11 }");
    surface(&mut text, "foot", "disk = { center = [1.6, 3.2, 1.7], normal = [0, 0, -1], radius = 0.11 }");
    surface(&mut text, "top", "disk = { center = [1.6, 3.2, 2.3], normal = [0, 0, 1], radius = 0.11 }");
    text
}

/// The pilaster hides a narrow strip along an edge of the wall, between the points of coarse grids.
#[test]
fn a_strip_behind_a_pilaster_is_not_lit() {
    for order in [0, 3] {
        let sum = row_sum(&pilaster(), "lamp", order);
        assert!((sum - 1.0).abs() < 2e-3, "order {order}: {sum}");
    }
}

/// Two rooms under one ceiling, on one floor, parted by a wall from side to side at x = `wall`; one end of the first
/// shines. Of the other no element receives light, those of the first all:
///
/// ```text
/// Σ ∫ E dA = M A / (1 − ρ) .
/// ```
#[test]
fn a_wall_from_floor_to_ceiling_keeps_all_light_in_its_room() {
    for wall in [2.6, 3.0] {
        let scene = typed(&format!(
            r#"
bands = ["lm"]
materials.grey = {{ reflectance = 0.5 }}
materials.shining = {{ reflectance = 0.5, emission = 1 }}
[[surfaces]]
name = "house"
material = "grey"
box = {{ origin = [0, 0, 0], size = [4, 2, 2], inward = true, open = ["left"] }}
[[surfaces]]
name = "end"
material = "shining"
parallelogram = {{ origin = [0, 0, 0], edge1 = [0, 2, 0], edge2 = [0, 0, 2] }}
[[surfaces]]
name = "wall"
material = "grey"
two_sided = true
parallelogram = {{ origin = [{wall}, 0, 0], edge1 = [0, 2, 0], edge2 = [0, 0, 2] }}
"#
        ));
        let outcome = outcome_of(&scene, &Options::default());
        let elements = outcome.solution.elements();
        let irradiance = &outcome.solution.bands()[0].coefficients.irradiance;
        let starts = elements.starts();
        let mut received = 0.0;
        for (index, element) in elements.list().iter().enumerate() {
            let own = &irradiance[starts[index]..starts[index + 1]];
            let [u, v] = element.rect.center();
            let middle = elements.shape(element.surface).jet(u, v);
            if middle.position.x > wall || (middle.position.x == wall && middle.normal.x > 0.0) {
                let most = own.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
                assert!(most < 1e-9, "{}: {most}", scene.surfaces[element.surface].name);
            } else {
                received += dot(&element.constant, own);
            }
        }
        assert!((received / 8.0 - 1.0).abs() < 2e-3, "{received}");
    }
}

/// A lamp of one side hangs h = 5 mm below the middle of the ceiling of a cube. What is lost at its black back came
/// into the gap through the four openings of length 1 and height h, in at most the light of the brightest place: less
/// than 4 h E of the power M. The ceiling sees what reflects half of at most 0.3 M, so E < 0.15 M.
#[test]
fn what_is_close_to_a_ceiling_takes_no_light_of_it() {
    let scene = typed(
        r#"
bands = ["lm"]
materials.grey = { reflectance = 0.5 }
materials.shining = { reflectance = 0.5, emission = 1 }
[[surfaces]]
name = "room"
material = "grey"
box = { origin = [0, 0, 0], size = [2, 2, 2], inward = true }
[[surfaces]]
name = "lamp"
material = "shining"
parallelogram = { origin = [0.5, 0.5, 1.995], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }
"#,
    );
    for transport in [Transport::Exact, Transport::Sampled] {
        let outcome = outcome_of(&scene, &Options { transport, ..Options::default() });
        let lost = outcome.checks.energy_lost / outcome.checks.energy_in;
        assert!(lost.abs() < 3e-3, "{transport:?}: {lost}");
    }
}
