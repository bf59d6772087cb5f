//! Collocation: at its points the light is that of closed forms; everywhere it converges to Galerkin's.

use radiosity::Options;
use radiosity::elements::rule::UnitRule;
use radiosity::elements::space::Space;
use radiosity::scene::Scene;
use radiosity::solve::studies::error_norm::distance;
use radiosity::solve::{Direct, LightMethod, Outcome, Transport};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::outcome_of;

const ORDER: usize = 3;

fn collocated(scene: &Scene, options: Options) -> Outcome {
    let shared = Options { direct: Direct::Projected, subdivide: Some(1), ..options };
    outcome_of(scene, &Options { method: LightMethod::Collocation, ..shared })
}

/// Irradiance at the origin of a plane, from a rectangle of exitance 1 at the height `h`, parallel to it: the
/// four corners of the closed form (Howell, configuration factors of a plane element to a parallel rectangle).
fn from_rectangle([x0, x1]: [f64; 2], [y0, y1]: [f64; 2], h: f64) -> f64 {
    let corner = |x: f64, y: f64| {
        let [a, b] = [x, y].map(|side| (h * h + side * side).sqrt());
        (x / a * (y / a).atan() + y / b * (x / b).atan()) / std::f64::consts::TAU
    };
    corner(x1, y1) - corner(x0, y1) - corner(x1, y0) + corner(x0, y0)
}

/// Irradiance at (x, y) of the floor of `occluder-box` from the lamp of exitance 10 in its ceiling: the lamp
/// less what the panel halfway up hides, both of them squares about the middle axis.
fn lamp_over_panel([x, y]: [f64; 2]) -> f64 {
    let lamp = |from: f64| [0.35 - from, 0.65 - from];
    // The panel as seen from the floor, twice as far off.
    let shadow = |from: f64| [2.0 * (0.3 - from), 2.0 * (0.7 - from)];
    let within = |from: f64| {
        let [[a, b], [c, d]] = [lamp(from), shadow(from)];
        let low = a.max(c).min(b);
        [low, b.min(d).max(low)]
    };
    10.0 * (from_rectangle(lamp(x), lamp(y), 1.0) - from_rectangle(within(x), within(y), 1.0))
}

/// With polynomials of a degree in each coordinate the light passes through all values at the Gauss points,
/// shadows and all.
#[test]
fn light_is_that_of_closed_forms_at_the_points() {
    let mut scene = builtin("occluder-box");
    for surface in &mut scene.surfaces {
        surface.material.reflectance.fill(0.0);
    }
    let options =
        Options { order: ORDER, space: Space::Tensor, shadow_eps: 1e-5, eps: 1e-5, ..Options::default() };
    let solution = collocated(&scene, options).solution;
    let floor = scene.surface_named("floor").expect("it is there");
    let element = solution.elements().of_surface(floor).start;
    let receiver = &solution.elements().list()[element];
    let raw = receiver.basis.to_raw(
        &solution.bands()[0].coefficients.irradiance[solution.elements().starts()[element]..]
            [..receiver.basis.len()],
    );
    let (rule, mut half_shadows) = (UnitRule::of(ORDER + 1), 0);
    for (x, y) in rule.iter().flat_map(|(x, _)| rule.iter().map(move |(y, _)| (x, y))) {
        let value = receiver.evaluate(&raw, DVec3::new(x, y, 0.0), [0.0; 2]);
        let exact = lamp_over_panel([x, y]);
        let whole = 10.0 * from_rectangle([0.35 - x, 0.65 - x], [0.35 - y, 0.65 - y], 1.0);
        assert!((value - exact).abs() < 1e-4 * whole, "({x}, {y}): {value}, exactly {exact}");
        half_shadows += u32::from(exact > 0.01 * whole && exact < 0.99 * whole);
    }
    assert!(half_shadows > 0, "no point in half-shadow");
}

/// Order 0 is the form factor from the middle of each square: 0.2395 to a parallel unit square at distance 1,
/// where the mean is 0.1998.
#[test]
fn order_0_takes_the_middle() {
    let square = |z: f64, turned: bool| {
        let [a, b] = if turned { ["[0,1,0]", "[1,0,0]"] } else { ["[1,0,0]", "[0,1,0]"] };
        format!("parallelogram = {{ origin = [0,0,{z}], edge1 = {a}, edge2 = {b} }}")
    };
    let scene = typed(&format!(
        "materials.black = {{ reflectance = 0 }}\nmaterials.lamp = {{ reflectance = 0, emission = 1 }}\n\
         [[surfaces]]\nmaterial = \"black\"\n{}\n[[surfaces]]\nmaterial = \"lamp\"\n{}",
        square(0.0, false),
        square(1.0, true)
    ));
    let outcome = collocated(&scene, Options { order: 0, ..Options::default() });
    let middle = from_rectangle([-0.5, 0.5], [-0.5, 0.5], 1.0);
    assert!((middle - 0.2395).abs() < 1e-4, "{middle}");
    // The function of a unit square is 1.
    let found = outcome.solution.bands()[0].coefficients.irradiance[0];
    assert!((found - middle).abs() < 1e-3 * middle, "{found} {middle}");
}

/// Both methods have one limit, on flat and on curved surfaces.
#[test]
fn higher_orders_meet_those_of_galerkin() {
    let can = typed(
        "materials.grey = { reflectance = 0.5 }\nmaterials.lamp = { reflectance = 0.5, emission = 1 }\n\
         [[surfaces]]\nmaterial = \"lamp\"\ndisk = { center = [0,0,0], normal = [0,0,1], radius = 1 }\n\
         [[surfaces]]\nmaterial = \"grey\"\ndisk = { center = [0,0,2], normal = [0,0,-1], radius = 1 }\n\
         [[surfaces]]\nmaterial = \"grey\"\nflip = true\ncylinder = { base = [0,0,0], axis = [0,0,2], radius = 1 }",
    );
    for (name, scene) in [("empty-box", builtin("empty-box")), ("can", can)] {
        let options = |order| Options {
            order,
            transport: Transport::Exact,
            direct: Direct::Projected,
            subdivide: Some(1),
            eps: 1e-5,
            ..Options::default()
        };
        let exact = outcome_of(&scene, &options(7)).solution;
        let off = |order| distance(&collocated(&scene, options(order)).solution, &exact).expect("one scene");
        let [coarse, fine] = [off(1), off(5)];
        assert!(fine < 0.3 * coarse && fine < 0.02, "{name}: {coarse:.1e} at order 1, {fine:.1e} at order 5");
    }
}
