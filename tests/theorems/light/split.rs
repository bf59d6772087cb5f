//! Direct light split off the polynomials: power, limits that both forms share, and where they are chosen.

use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::solve::gather::Gather;
use radiosity::solve::{Direct, Options};
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::outcome_of;

fn options(order: usize, direct: Direct) -> Options {
    Options { order, direct, threads: 2, ..Options::default() }
}

#[test]
fn what_is_emitted_is_absorbed_or_lost() {
    for name in ["cornell-box", "empty-box", "occluder-box"] {
        let outcome = outcome_of(&builtin(name), &options(3, Direct::Split));
        assert!(outcome.split && outcome.residual < 1e-7, "{name}: residual {}", outcome.residual);
        let checks = outcome.checks;
        let balance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
        assert!(balance.abs() <= 1e-7 * checks.energy_in, "{name}: {checks:?}");
        let is_closed = name != "cornell-box";
        assert!(!is_closed || checks.energy_lost.abs() < 1e-2 * checks.energy_in, "{name}: {checks:?}");
    }
}

/// With ρ = ½ and exitance 1 everywhere in a closed room E = B = 2: direct light is 1, and so is what is
/// reflected.
#[test]
fn a_furnace_is_two_with_direct_light_split_off() {
    let scene = builtin("furnace-cube");
    let outcome = outcome_of(&scene, &options(2, Direct::Split));
    for surface in 0..scene.surfaces.len() {
        let mean = outcome.solution.mean_irradiance(0, surface);
        assert!((mean - 2.0).abs() < 4e-3, "{mean}");
    }
    assert!(!outcome_of(&scene, &options(2, Direct::Auto)).split, "nothing in it casts a shadow");
}

/// One lamp over a floor, a plate between them: straight light alone, as nothing reflects.
const BLACK: &str = r#"
bands = ["grey"]
[materials.black]
reflectance = 0
[materials.lamp]
reflectance = 0
emission = 3
[[surfaces]]
name = "floor"
material = "black"
quad = { vertices = [[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]] }
[[surfaces]]
name = "plate"
material = "black"
two_sided = true
quad = { vertices = [[0,-2,0.5],[2,-2,0.5],[2,2,0.5],[0,2,0.5]] }
[[surfaces]]
name = "lamp"
material = "lamp"
quad = { vertices = [[-0.5,-0.5,1],[-0.5,0.5,1],[0.5,0.5,1],[0.5,-0.5,1]] }
"#;

/// Below the middle of the lamp half of it is seen past the plate: ½ of 4/π a/√(1+a²) atan(a/√(1+a²)) with
/// a = ½.
#[test]
fn without_reflection_there_is_direct_light_alone() {
    let scene = typed(BLACK);
    let outcome = outcome_of(&scene, &options(3, Direct::Auto));
    assert!(outcome.split, "the plate casts a shadow");
    let coefficients = &outcome.solution.bands()[0].coefficients;
    assert_eq!(coefficients.irradiance, coefficients.direct);
    let visibility = options(3, Direct::Auto).visibility(&scene);
    let gather = Gather::twice(&outcome.solution, &visibility, 1e-3);
    let floor = scene.surface_named("floor").expect("there is a floor");
    let jet = scene.surfaces[floor].shape.jet(0.0, 0.0);
    let found = gather.at(&ReceiverPoint::on(floor, jet.position, jet.normal))[0];
    let q = 0.5 / 0.5f64.hypot(1.0);
    let exact = 3.0 * 0.5 * 4.0 / std::f64::consts::PI * q * q.atan();
    assert!((found - exact).abs() < 1e-14, "{found} instead of {exact}");
}

/// Both forms have the same limit: the box's mean irradiances agree ever better.
#[test]
fn split_and_projected_light_agree() {
    let scene = builtin("empty-box");
    let [split, projected] =
        [Direct::Split, Direct::Projected].map(|direct| outcome_of(&scene, &options(6, direct)));
    for surface in 0..scene.surfaces.len() {
        let [a, b] = [&split, &projected].map(|outcome| outcome.solution.mean_irradiance(0, surface));
        assert!((a - b).abs() < 5e-3 * b, "surface {surface}: {a} {b}");
    }
}
