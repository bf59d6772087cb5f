//! Light is linear in emission: a solution with its groups dimmed is the solution of the scene whose lamps
//! emit that much.

use proptest::prelude::*;
use radiosity::published::zatz1993::masking::{Average, Masking};
use radiosity::scene::{FaultKind, Scene, SceneError};
use radiosity::solve::solved::{RelightError, Solved};
use radiosity::solve::{Direct, Options, Transport};
use radiosity_solvers::method::Method;
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::solved_of;

/// Number of lamps, each a group of its own.
pub(crate) const LAMPS: usize = 3;

/// A closed room with a panel that casts a shadow, lamps that are groups, and a wall that glows and is none.
/// The lamps emit their share of `levels`.
pub(crate) fn room(levels: [f64; LAMPS]) -> Scene {
    let emission = [[3.0, 2.0], [0.0, 5.0], [1.0, 0.25]];
    let lamp = |k: usize| {
        let [a, b] = emission[k].map(|emission| levels[k] * emission);
        let x = 0.1 + 0.3 * k as f64;
        format!(
            "[materials.lamp{k}]\nreflectance = [0.1, 0]\nemission = [{a:?}, {b:?}]\ngroup = \"lamp{k}\"\n\
             [[surfaces]]\nname = \"lamp{k}\"\nmaterial = \"lamp{k}\"\n\
             quad = {{ vertices = [[{x},0.4,0.9],[{x},0.6,0.9],[{y},0.6,0.9],[{y},0.4,0.9]] }}\n",
            y = x + 0.2
        )
    };
    let lamps: String = (0..LAMPS).map(lamp).collect();
    let text = format!(
        r#"
        bands = ["long", "short"]
        [materials.white]
        reflectance = [0.7, 0.3]
        [materials.glow]
        reflectance = 0.5
        emission = [0.1, 0.2]
        [[surfaces]]
        name = "floor"
        material = "white"
        quad = {{ vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }}
        [[surfaces]]
        name = "ceiling"
        material = "white"
        quad = {{ vertices = [[0,0,1],[0,1,1],[1,1,1],[1,0,1]] }}
        [[surfaces]]
        name = "west"
        material = "glow"
        quad = {{ vertices = [[0,0,0],[0,1,0],[0,1,1],[0,0,1]] }}
        [[surfaces]]
        name = "east"
        material = "white"
        quad = {{ vertices = [[1,0,0],[1,0,1],[1,1,1],[1,1,0]] }}
        [[surfaces]]
        name = "south"
        material = "white"
        quad = {{ vertices = [[0,0,0],[0,0,1],[1,0,1],[1,0,0]] }}
        [[surfaces]]
        name = "north"
        material = "white"
        quad = {{ vertices = [[0,1,0],[1,1,0],[1,1,1],[0,1,1]] }}
        [[surfaces]]
        name = "panel"
        material = "white"
        two_sided = true
        quad = {{ vertices = [[0.2,0.2,0.5],[0.7,0.2,0.5],[0.7,0.5,0.5],[0.2,0.5,0.5]] }}
        {lamps}"#
    );
    typed(&text)
}

/// A direct solver, so that what is compared is the theorem and not a tolerance.
fn options() -> Options {
    let method = Method::named("cholesky").expect("it is listed");
    Options {
        order: 2,
        eps: 1e-2,
        shadow_eps: 3e-2,
        subdivide: Some(1),
        solver: method,
        ..Options::default()
    }
}

fn solved(levels: [f64; LAMPS], options: Options) -> Solved {
    solved_of(room(levels), options)
}

fn names() -> [String; LAMPS] {
    std::array::from_fn(|k| format!("lamp{k}"))
}

fn relit(solved: &Solved, factors: [f64; LAMPS]) -> Solved {
    let names = names();
    let settings: Vec<(&str, f64)> = names.iter().map(String::as_str).zip(factors).collect();
    solved.relight(&settings).expect("the groups are there")
}

/// Holds that two solutions are the same light: coefficients, exitances, balance of power.
#[track_caller]
fn assert_same(a: &Solved, b: &Solved) {
    let [one, other] = [a, b].map(|solved| &solved.outcome);
    for (one, other) in one.solution.bands().iter().zip(other.solution.bands()) {
        let of = [&one.coefficients, &other.coefficients];
        let pairs = [
            of.map(|own| &own.irradiance),
            of.map(|own| &own.direct),
            of.map(|own| &own.radiosity),
            [&one.coating.exitance, &other.coating.exitance],
        ];
        for [x, y] in pairs {
            let scale = x.iter().chain(y).map(|x| x.abs()).fold(0.0, f64::max);
            let far = x.iter().zip(y).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(x.len() == y.len() && far <= 1e-12 * scale, "{far:e} of {scale:e}");
        }
    }
    let [c, d] = [one.checks, other.checks];
    for (c, d) in
        [(c.energy_in, d.energy_in), (c.energy_absorbed, d.energy_absorbed), (c.energy_lost, d.energy_lost)]
    {
        assert!((c - d).abs() <= 1e-12 * one.checks.energy_in, "{c} {d}");
    }
    assert!((c.seam_jump_max - d.seam_jump_max).abs() <= 1e-9, "{c:?} {d:?}");
    assert!(one.residual < 1e-9 && other.residual < 1e-9, "{} {}", one.residual, other.residual);
}

/// Holds that dimming is solving the dimmed scene, for factors that leave every lamp on.
#[track_caller]
fn assert_linear(options: Options) {
    let full = solved([1.0; LAMPS], options);
    assert!(full.outcome.solution.groups().len() == LAMPS + 1);
    let factors = [0.3, 1.2, 2.7];
    assert_same(&relit(&full, factors), &solved(factors, options));
}

#[test]
fn dimming_is_solving_again_where_polynomials_carry_all_light() {
    assert_linear(Options { direct: Direct::Projected, ..options() });
}

#[test]
fn dimming_is_solving_again_where_direct_light_is_split_off() {
    assert_linear(Options { direct: Direct::Split, ..options() });
}

#[test]
fn dimming_is_solving_again_where_rays_carry_the_light() {
    assert_linear(Options { transport: Transport::Sampled, rays: Some(100_000), ..options() });
}

#[test]
fn dimming_is_solving_again_behind_shadow_masks() {
    let cells = std::num::NonZeroUsize::new(4).expect("it is above 0");
    assert_linear(Options { masks: Some(Masking { cells, average: Average::Weighted }), ..options() });
}

#[test]
fn dimming_is_solving_again_by_iterations() {
    for name in ["cg", "gmres", "gauss-seidel", "southwell"] {
        let method = Method::named(name).expect("it is listed");
        assert_linear(Options { solver: method, tolerance: 1e-13, direct: Direct::Projected, ..options() });
    }
}

/// A group's light does not depend on the others: turned off, they leave the rest as it is without them.
#[test]
fn lights_that_are_off_are_as_if_they_did_not_emit() {
    for direct in [Direct::Projected, Direct::Split] {
        let options = Options { direct, ..options() };
        let full = solved([1.0; LAMPS], options);
        for k in 0..LAMPS {
            let factors = std::array::from_fn(|other| f64::from(u8::from(other != k)));
            assert_same(&relit(&full, factors), &solved(factors, options));
        }
        let dark = relit(&full, [0.0; LAMPS]);
        let glow = 0.1 + 0.2;
        assert!((dark.outcome.checks.energy_in - glow).abs() < 1e-14, "the wall of area 1 glows on");
    }
}

#[test]
fn factors_are_those_of_the_scene_not_of_one_another() {
    let full = solved([1.0; LAMPS], options());
    let back = relit(&relit(&full, [0.0; LAMPS]), [1.0; LAMPS]);
    let [a, b] = [&full, &back].map(|solved| &solved.outcome.solution.bands()[0].coefficients.irradiance);
    assert_eq!(a, b);
    let some = relit(&full, [0.5; LAMPS]).relight(&[("lamp1", 2.0)]).expect("it is there");
    assert_eq!(
        some.scene.light_groups().iter().map(|group| group.factor).collect::<Vec<_>>(),
        [0.5, 2.0, 0.5]
    );
    assert_same(&some, &relit(&full, [0.5, 2.0, 0.5]));
}

#[test]
fn a_dimmed_scene_is_solved_as_it_is_dimmed() {
    let scene = room([1.0; LAMPS]).dimmed(&[("lamp0", 0.25), ("lamp2", 0.0)]).expect("they are there");
    let dimmed = solved_of(scene, options());
    assert_same(&dimmed, &relit(&solved([1.0; LAMPS], options()), [0.25, 1.0, 0.0]));
}

#[test]
fn what_is_emitted_is_absorbed_or_lost_at_any_factors() {
    for direct in [Direct::Projected, Direct::Split] {
        let full = solved([1.0; LAMPS], Options { direct, ..options() });
        let checks = relit(&full, [0.01, 30.0, 1.0]).outcome.checks;
        let emitted = 0.2 * 0.2 * (5.0 * 0.01 + 5.0 * 30.0 + 1.25) + 0.3;
        assert!((checks.energy_in - emitted).abs() < 1e-12 * emitted, "{checks:?}");
        let balance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
        assert!(balance.abs() < 1e-9 * checks.energy_in, "{checks:?}");
    }
}

#[test]
fn gathered_light_is_that_of_the_dimmed_scene() {
    let options = Options { direct: Direct::Split, ..options() };
    let factors = [0.3, 1.2, 0.5];
    let [a, b] = [relit(&solved([1.0; LAMPS], options), factors), solved(factors, options)].map(|solved| {
        solved.irradiance_at(radiosity_geom::DVec3::new(0.8, 0.3, 0.2), radiosity_geom::DVec3::Z)
    });
    for (a, b) in a.iter().zip(&b) {
        assert!((a - b).abs() <= 1e-9 * b, "{a} {b}");
    }
}

#[test]
fn scenes_without_groups_keep_nothing_apart() {
    let scene = builtin("furnace-cube");
    let solved = solved_of(scene, options());
    assert!(solved.outcome.solution.groups().is_empty());
    assert_same(&solved, &solved.relight(&[]).expect("nothing is set"));
}

#[test]
fn what_cannot_be_set_is_refused() {
    let full = solved([1.0; LAMPS], options());
    let fault = |settings: &[(&str, f64)]| match full.relight(settings) {
        Err(RelightError::Scene(SceneError { fault, .. })) => fault,
        other => panic!("{other:?}"),
    };
    let unknown = fault(&[("lamp", 1.0)]);
    assert_eq!(unknown.to_string(), "no light comes from a group \"lamp\"");
    let known = format!("light groups of this scene: {}", names().join(", "));
    assert!(unknown.cure().is_some_and(|cure| cure.ends_with(&known)), "{:?}", unknown.cure());
    let twice = fault(&[("lamp1", 1.0), ("lamp0", 1.0), ("lamp1", 1.0)]);
    assert_eq!(twice.to_string(), "the light group \"lamp1\" is set twice");
    assert_eq!(fault(&[("lamp1", -1e-300)]).kind, FaultKind::OutOfRange);
    for value in [f64::NAN, f64::INFINITY] {
        assert_eq!(fault(&[("lamp1", value)]).kind, FaultKind::NotFinite);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// Factors of any size, for any way in which direct light enters.
    #[test]
    fn any_factors_give_the_solution_of_the_scene_that_emits_so_much(
        factors in prop::array::uniform3(prop_oneof![Just(0.0), 1e-6..1e6f64]),
        is_split in any::<bool>(),
    ) {
        let direct = if is_split { Direct::Split } else { Direct::Projected };
        let options = Options { order: 1, direct, ..options() };
        assert_same(&relit(&solved([1.0; LAMPS], options), factors), &solved(factors, options));
    }
}
