//! Reflectance and emission that vary over surfaces, and light that surfaces let through.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed};
use radiosity::Work;
use radiosity::geom::DVec3;
use radiosity::geom::shapes::Parallelogram;
use radiosity::scene::{Material, Pattern, Placement, Polynomial, Scene, SceneBuilder, SurfaceDraft, Term};
use radiosity::solve::solution::SurfacePlace;
use radiosity::solve::{Options, Outcome};
use radiosity_test_support::scenes::{material, typed};
use radiosity_test_support::shapes::faces;
use radiosity_test_support::shapes::{ball, plate};
use radiosity_test_support::solved::outcome_of;

/// The unit cube, its front inward, whose walls are made by `paint`.
fn cube(builder: &mut SceneBuilder, mut paint: impl FnMut(usize) -> Material) {
    for (wall, shape) in faces(DVec3::ZERO, DVec3::AXES).into_iter().enumerate() {
        let material = builder.material(format!("paint {wall}"), paint(wall));
        builder.surface(format!("wall {wall}"), shape, &material);
    }
}

fn patterned(reflectance: Pattern, emission: Pattern) -> Material {
    let material = Material::black(1).with_reflectance_pattern(reflectance);
    let material = material.and_then(|own| own.with_emission_pattern(emission));
    material.expect("it is in range")
}

fn exact() -> Options {
    Options { order: 4, tolerance: 1e-14, eps: 1e-13, shadow_eps: 1e-8, ..Options::default() }
}

/// Largest |E − 1| over coefficients, against those of the constant 1.
fn off_one(outcome: &Outcome) -> f64 {
    let ones = outcome.solution.elements().constant();
    let light = &outcome.solution.bands()[0].coefficients;
    let parts = [&light.irradiance, &light.radiosity];
    parts.iter().flat_map(|own| own.iter().zip(&ones)).map(|(x, c)| (x - c).abs()).fold(0.0, f64::max)
}

/// 1 − q.
fn rest(pattern: &[f64]) -> Vec<f64> {
    pattern.iter().map(|q| 1.0 - q).collect()
}

proptest! {
    #![proptest_config(Config { cases: 6, rng_seed: RngSeed::Fixed(30), ..Config::default() })]

    /// In a closed room of any reflectances ρ(x) that emits 1 − ρ(x), the radiosity is 1.
    #[test]
    fn a_textured_furnace_is_uniform(
        texels in prop::collection::vec(prop::collection::vec(0.0..0.95f64, 12), 6),
        columns in prop::sample::select(vec![1usize, 2, 3, 4, 6, 12]),
    ) {
        let mut builder = SceneBuilder::new("furnace", ["grey"]);
        cube(&mut builder, |wall| {
            let grid = |values| Pattern::texels(columns, vec![values], Placement::default()).expect("a grid");
            patterned(grid(texels[wall].clone()), grid(rest(&texels[wall])))
        });
        let outcome = outcome_of(&builder.build().expect("a scene"), &exact());
        prop_assert!(off_one(&outcome) < 1e-12, "{}", off_one(&outcome));
    }

    /// A furnace stays uniform where reflectance and exitance are polynomials of degree 4.
    #[test]
    fn a_furnace_of_polynomial_reflectance_is_uniform(
        terms in prop::collection::vec(prop::collection::vec(-0.06..0.06f64, 8), 6),
    ) {
        let powers = [[1, 0], [0, 1], [2, 0], [1, 1], [0, 3], [4, 0], [2, 2], [1, 3]];
        let polynomial = |constant: f64, sign: f64, factors: &[f64]| {
            let own = powers.iter().zip(factors);
            let own = own.map(|([u, v], factor)| Term { u: *u, v: *v, factor: sign * factor });
            Pattern::polynomial(vec![Polynomial::new(own.chain([Term { u: 0, v: 0, factor: constant }]))])
        };
        let mut builder = SceneBuilder::new("furnace", ["grey"]);
        cube(&mut builder, |wall| {
            patterned(polynomial(0.5, 1.0, &terms[wall]), polynomial(0.5, -1.0, &terms[wall]))
        });
        let outcome = outcome_of(&builder.build().expect("a scene"), &exact());
        prop_assert!(off_one(&outcome) < 1e-12, "{}", off_one(&outcome));
    }

    /// A sheet with ρ + τ < 1 that emits the rest on both sides, in a room of the same kind.
    #[test]
    fn a_furnace_with_a_sheet_that_lets_light_through_is_uniform(
        share in 0.0..1.0f64, all in 0.1..0.95f64, wall in 0.0..0.95f64, split in 1usize..3,
    ) {
        let (reflectance, transmittance) = (share * all, (1.0 - share) * all);
        let mut builder = SceneBuilder::new("furnace", ["grey"]);
        cube(&mut builder, |_| material(wall, 1.0 - wall));
        let sheet = material(reflectance, 1.0 - all);
        let sheet = sheet.with_transmittance(vec![transmittance]).expect("it is in range");
        let sheet = builder.material("sheet", sheet);
        let shape = Parallelogram::new(DVec3::new(0.2, 0.3, 0.5), DVec3::X * 0.5, DVec3::Y * 0.4);
        let _: &mut SurfaceDraft =
            builder.surface("sheet", shape.expect("a square"), &sheet).two_sided().subdivide(split, 1);
        let outcome = outcome_of(&builder.build().expect("a scene"), &Options { order: 2, ..exact() });
        prop_assert!(off_one(&outcome) < 1e-7, "{}", off_one(&outcome));
    }
}

/// A furnace stays uniform where a box stands on a part of the sheet: the covered part of its upper side is
/// an element of its own.
#[test]
fn a_furnace_with_a_box_on_a_sheet_is_uniform() {
    let room = r#"
materials.wall = { reflectance = 0.5, emission = 0.5 }
materials.paper = { reflectance = 0.2, transmittance = 0.6, emission = 0.2 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [1, 1, 1], inward = true }
[[surfaces]]
name = "table"
material = "paper"
two_sided = true
parallelogram = { origin = [0.2, 0.2, 0.5], edge1 = [0.6, 0, 0], edge2 = [0, 0.6, 0] }
[[surfaces]]
name = "block"
material = "wall"
box = { origin = [0.2, 0.2, 0.5], size = [0.3, 0.6, 0.2] }
"#;
    let scene = typed(room);
    let outcome = outcome_of(&scene, &Options { order: 1, shadow_eps: 1e-7, ..exact() });
    let (solution, ones) = (&outcome.solution, outcome.solution.elements().constant());
    let light = &solution.bands()[0].coefficients.irradiance;
    // What touches a body below it receives nothing, or all from it.
    let starts = solution.elements().starts();
    for (index, element) in solution.elements().list().iter().enumerate() {
        let own = starts[index]..starts[index + 1];
        let off = light[own.clone()].iter().zip(&ones[own]).map(|(x, c)| (x - c).abs()).fold(0.0, f64::max);
        let name = &scene.surfaces[element.surface].name;
        assert!(off < 1e-6, "{name} {:?} {off}", element.rect);
    }
    // Below the block the sheet passes on what arrives under it.
    let below = scene.surface_named("table:back").expect("it is there");
    let element = solution.elements().at(below, [-0.5, 0.0]).expect("it is there");
    let position = scene.surfaces[below].shape.jet(-0.5, 0.0).position;
    let place = SurfacePlace { surface: below, parameters: [-0.5, 0.0], position };
    assert!((solution.radiosity(0, element, &place) - 1.0).abs() < 1e-6);
}

/// Concentric spheres, the middle one letting light through: the irradiances solve a system of four.
#[test]
fn a_shade_between_spheres_is_as_its_closed_form() {
    let (a, b, c) = (0.3f64, 0.6f64, 1.0f64);
    let (core, shade, outer) = ((0.4, 1.0), (0.3, 0.55), 0.6);
    let mut builder = SceneBuilder::new("shade", ["grey"]);
    let paint = |rho: f64, exitance: f64| material(rho, exitance);
    let ball = |radius| ball(DVec3::ZERO, radius);
    let material = builder.material("core", paint(core.0, core.1));
    builder.surface("core", ball(a), &material);
    let sheet = paint(shade.0, 0.0).with_transmittance(vec![shade.1]).expect("it is in range");
    let material = builder.material("shade", sheet);
    builder.surface("shade", ball(b), &material).two_sided();
    let material = builder.material("outer", paint(outer, 0.0));
    builder.surface("outer", ball(c), &material).flip();
    let scene = builder.build().expect("a scene");
    let outcome = outcome_of(&scene, &Options { order: 1, eps: 1e-4, shadow_eps: 1e-4, ..exact() });
    // Irradiances: on the core, on the inner side of the shade, on its outer side, on the outer sphere.
    let (ab, bc) = ((a / b).powi(2), (b / c).powi(2));
    let (mut e, mut last) = ([0.0f64; 4], [1.0f64; 4]);
    while e.iter().zip(&last).any(|(x, y)| (x - y).abs() > 1e-15) {
        last = e;
        let radiosity = [
            core.1 + core.0 * e[0],
            shade.0 * e[1] + shade.1 * e[2],
            shade.0 * e[2] + shade.1 * e[1],
            outer * e[3],
        ];
        e = [
            radiosity[1],
            ab * radiosity[0] + (1.0 - ab) * radiosity[1],
            radiosity[3],
            bc * radiosity[2] + (1.0 - bc) * radiosity[3],
        ];
    }
    let surface = |name: &str| scene.surface_named(name).expect("it has that name");
    let names = ["core", "shade:back", "shade", "outer"];
    for (name, exact) in names.into_iter().zip(e) {
        let mean = outcome.solution.mean_irradiance(0, surface(name));
        assert!((mean - exact).abs() < 2e-4 * exact, "{name}: {mean} {exact}");
    }
    let checks = outcome.checks;
    let balance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
    assert!(balance.abs() < 1e-12 * checks.energy_in, "{balance}");
}

/// A floor of 8 × 8 black and white fields as one element, against 64 squares.
#[test]
fn a_chessboard_floor_lights_a_room_as_its_squares_do() {
    let field = |k: usize| if (k % 8 + k / 8).is_multiple_of(2) { 0.85 } else { 0.05 };
    let room = |fields: bool| {
        let mut builder = SceneBuilder::new("room", ["grey"]);
        let white = builder.material("white", material(0.6, 0.0));
        let lamp = builder.material("lamp", material(0.2, 10.0));
        let quad = |o: [f64; 3], a: DVec3, b: DVec3| plate(o.into(), a, b);
        let [x, y, z] = DVec3::AXES;
        builder.surface("x0", quad([0.0; 3], y, z), &white);
        builder.surface("x1", quad([1.0, 0.0, 0.0], z, y), &white);
        builder.surface("y0", quad([0.0; 3], z, x), &white);
        builder.surface("y1", quad([0.0, 1.0, 0.0], x, z), &white);
        builder.surface("ceiling", quad([0.0, 0.0, 1.0], y, x), &lamp);
        if fields {
            for k in 0..64 {
                let own = material(field(k), 0.0);
                let own = builder.material(format!("field {k}"), own);
                let [i, j] = [k % 8, k / 8].map(|k| k as f64 / 8.0);
                builder.surface(format!("field {k}"), quad([i, j, 0.0], x / 8.0, y / 8.0), &own).order(1);
            }
        } else {
            let texels = (0..64).map(field).collect();
            let pattern = Pattern::texels(8, vec![texels], Placement::default()).expect("a grid");
            let board = Material::black(1).with_reflectance_pattern(pattern).expect("in range");
            let board = builder.material("board", board);
            builder.surface("floor", quad([0.0; 3], x, y), &board);
        }
        builder.build().expect("a scene")
    };
    let options = Options { order: 3, ..exact() };
    let [pattern, squares] = [false, true].map(|fields| (room(fields), outcome_of(&room(fields), &options)));
    let (one, many) = (pattern.1.solution.elements(), squares.1.solution.elements());
    let floor = |outcome: &Outcome, scene: &Scene, name: &str| {
        outcome.solution.mean_irradiance(0, scene.surface_named(name).expect("it has that name"))
    };
    for name in ["x0", "x1", "y0", "y1", "ceiling"] {
        let [a, b] = [&pattern, &squares].map(|(scene, outcome)| floor(outcome, scene, name));
        assert!((a - b).abs() < 5e-3 * b, "{name}: {a} {b}");
    }
    let walls: usize = one.list()[..5].iter().map(|element| element.basis.len()).sum();
    let own = one.coefficients() - walls;
    assert!(10 * own < many.coefficients() - walls, "{own} {}", many.coefficients());
}

/// A new pattern changes S alone: the blocks are those that were there.
#[test]
fn another_pattern_needs_no_new_blocks() {
    use radiosity::Model;
    let grid = |values: Vec<f64>| Pattern::texels(2, vec![values], Placement::default()).expect("a grid");
    let scene = |first: [f64; 4]| {
        let mut builder = SceneBuilder::new("room", ["grey"]);
        cube(&mut builder, |_| patterned(grid(first.to_vec()), grid(vec![1.0; 4])));
        builder.build().expect("a scene")
    };
    let before = scene([0.2, 0.7, 0.5, 0.0]);
    let model = Model::assemble(&before, &exact(), &Work::alone()).expect("a model");
    let mut after = before;
    for wall in 0..6 {
        let paint = patterned(grid(vec![0.9, 0.1, 0.3, 0.6]), grid(vec![1.0; 4]));
        after = after.with_material(&format!("paint {wall}"), paint).expect("it has that material");
    }
    let repainted = model.solve(&after, &Work::alone()).expect("a solution");
    let anew = outcome_of(&scene([0.9, 0.1, 0.3, 0.6]), &exact());
    let light = |outcome: &Outcome| outcome.solution.bands()[0].coefficients.irradiance.clone();
    for (a, b) in light(&repainted).iter().zip(light(&anew)) {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

/// A closed shade of ρ and τ about a lamp of the flux Φ in a black room: Φ + ρ Φ + ρ² Φ + … arrives on its
/// inner side, so that τ Φ / (1 − ρ) comes out, whatever its shape.
#[test]
fn a_lamp_shade_lets_out_its_share() {
    let shade = r#"
bands = ["lm"]
materials.black = { reflectance = 0 }
materials.shade = { reflectance = 0.5, transmittance = 0.4 }
[[surfaces]]
name = "room"
material = "black"
box = { origin = [-1, -1, -1], size = [2, 2, 2], inward = true }
[[surfaces]]
name = "round"
material = "shade"
two_sided = true
cylinder = { base = [0, 0, -0.3], axis = [0, 0, 0.6], radius = 0.25 }
[[surfaces]]
name = "lid"
material = "shade"
two_sided = true
disk = { center = [0, 0, 0.3], normal = [0, 0, 1], radius = 0.25 }
[[surfaces]]
name = "bottom"
material = "shade"
two_sided = true
disk = { center = [0, 0, -0.3], normal = [0, 0, -1], radius = 0.25 }
[[luminaires]]
name = "bulb"
position = [0, 0, 0.05]
flux = 1000
point = {}
"#;
    let scene = typed(shade);
    let outcome = outcome_of(&scene, &Options { order: 4, ..Options::default() });
    let walls = scene.surfaces.iter().enumerate().filter(|(_, own)| own.name.starts_with("room"));
    let arrives: f64 =
        walls.map(|(index, wall)| outcome.solution.mean_irradiance(0, index) * wall.shape.area()).sum();
    let exact = 0.4 * 1000.0 / (1.0 - 0.5);
    assert!((arrives - exact).abs() < 5e-3 * exact, "{arrives} {exact}");
    let checks = outcome.checks;
    let balance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
    assert!(balance.abs() < 1e-6 * checks.energy_in, "{balance}");
}
