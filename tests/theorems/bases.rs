//! Bases of the variational source: mass matrices, best fits and convergence rates against closed forms; what
//! Ritz's method keeps.

use proptest::prelude::*;
use radiosity::Basis;
use radiosity::elements::cells::Layers;
use radiosity::elements::coating::Coating;
use radiosity::elements::rule::UnitRule;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Element, Elements, Subdivide};
use radiosity::kernel::Accuracy;
use radiosity::published::bases::{Projection, Subspace};
use radiosity::scene::Scene;
use radiosity::solve::system::System;
use radiosity::solve::system::ritz::Ritz;
use radiosity::solve::{Options, Preconditioning, Transport};
use radiosity::visibility::Visibility;
use radiosity_geom::DVec3;
use radiosity_solvers::method::Method;
use radiosity_solvers::{Preconditioner, Settings, Step, functional as functional_of};
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::{blocks_of, elements_of, outcome_of, solved_of};

const SQUARE: &str = "parallelogram = { origin = [0,0,0], edge1 = [1,0,0], edge2 = [0,1,0] }";
const CYLINDER: &str = "cylinder = { base = [0,0,0], axis = [0,0,2], radius = 0.5, angle = [10, 200] }";

/// All bases that are not polynomials on elements.
const OTHERS: [Basis; 3] = [Basis::Constant, Basis::Linear, Basis::Harmonic];

fn scene(shape: &str) -> Scene {
    let text = format!(
        "materials.grey = {{ reflectance = 0.5, emission = 1 }}\n[[surfaces]]\nmaterial = \"grey\"\n{shape}"
    );
    typed(&text)
}

/// The elements of a basis on `cells` × `cells` cells, for transfers accurate to 1e-9.
fn ground(scene: &Scene, basis: Basis, degree: usize, cells: usize, space: Space) -> Elements {
    let how =
        Discretization { order: degree, space, subdivide: Subdivide::Uniform(cells), layers: Layers::NONE };
    let ground = basis.ground(scene, &how, 1e-9);
    match ground.mesh {
        Some(mesh) => Elements::of_mesh(scene, &ground.how, mesh),
        None => Elements::new(scene, &ground.how),
    }
    .expect("the surface has area")
}

/// The mass matrix of the functions of a basis on the only surface of a scene.
fn mass(shape: &str, basis: Basis, degree: usize, cells: usize, space: Space) -> Vec<Vec<f64>> {
    let scene = scene(shape);
    let elements = ground(&scene, basis, degree, cells, space);
    let rects: Vec<_> = elements.list().iter().map(|element| element.rect).collect();
    let functions = basis.functions(&rects, degree, space).expect("it is not elementwise");
    let list: Vec<&Element> = elements.list().iter().collect();
    Projection::new(functions.as_ref(), elements.shape(0), &list).mass()
}

#[test]
fn cosines_are_orthogonal_where_the_area_element_is_constant() {
    for (shape, area) in [(SQUARE, 1.0), (CYLINDER, 2.0 * 0.5 * 190f64.to_radians())] {
        for (space, degree) in [(Space::Total, 5), (Space::Tensor, 3)] {
            let mass = mass(shape, Basis::Harmonic, degree, 1, space);
            for (k, row) in mass.iter().enumerate() {
                let (i, j) = space.degrees(degree, k);
                let halves = i32::from(i > 0) + i32::from(j > 0);
                for (l, entry) in row.iter().enumerate() {
                    let expected = if k == l { area * 0.5f64.powi(halves) } else { 0.0 };
                    assert!((entry - expected).abs() < 1e-10 * area, "{shape} {k} {l}: {entry}");
                }
            }
        }
    }
}

#[test]
fn tents_have_the_mass_matrix_of_the_textbooks() {
    let cells = 4;
    let mass = mass(SQUARE, Basis::Linear, 1, cells, Space::Total);
    let count = cells + 1;
    assert_eq!(mass.len(), count * count);
    // h/6 times (2, 1), (1, 4, 1), …, (1, 2) in each direction.
    let line = |i: usize, j: usize| {
        let h = 1.0 / cells as f64;
        match i.abs_diff(j) {
            0 if i == 0 || i == cells => h / 3.0,
            0 => 2.0 * h / 3.0,
            1 => h / 6.0,
            _ => 0.0,
        }
    };
    for (k, row) in mass.iter().enumerate() {
        for (l, entry) in row.iter().enumerate() {
            let expected = line(k / count, l / count) * line(k % count, l % count);
            assert!((entry - expected).abs() < 1e-14, "{k} {l}: {entry} {expected}");
        }
    }
}

#[test]
fn constants_have_the_areas_of_their_cells() {
    let mass = mass(SQUARE, Basis::Constant, 0, 3, Space::Total);
    for (k, row) in mass.iter().enumerate() {
        for (l, entry) in row.iter().enumerate() {
            assert!((entry - if k == l { 1.0 / 9.0 } else { 0.0 }).abs() < 1e-15);
        }
    }
}

proptest! {
    #[test]
    fn constants_and_tents_sum_to_one_everywhere(cells in 1..9usize, u in -1.0..=1.0, v in -1.0..=1.0) {
        let elements = ground(&scene(SQUARE), Basis::Linear, 1, cells, Space::Total);
        let rects: Vec<_> = elements.list().iter().map(|element| element.rect).collect();
        for basis in [Basis::Constant, Basis::Linear] {
            let functions = basis.functions(&rects, 1, Space::Total).expect("it is not elementwise");
            let mut values = vec![7.0; functions.count()];
            functions.values([u, v], &mut values);
            prop_assert!((values.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            prop_assert!(values.iter().all(|value| (0.0..=1.0).contains(value)));
        }
    }
}

/// Points and weights of a rule on an element, on 4 × 4 parts of each patch.
fn points(element: &Element) -> Vec<(DVec3, [f64; 2], f64)> {
    let rule = UnitRule::of(24);
    let place = |part: usize, x: f64| (part as f64 + x) / 4.0;
    let mut points = Vec::new();
    for patch in &element.patches {
        for part in 0..16 {
            for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
                let node = patch.node(place(part / 4, s), place(part % 4, t));
                let weight = ws * wt / 16.0 * node.area;
                points.push((node.position, node.parameters.to_array(), weight));
            }
        }
    }
    points
}

/// Relative error in L² of the best sum of the functions of a basis for f(x) on the unit square.
fn best_fit(basis: Basis, degree: usize, cells: usize, f: impl Fn(f64) -> f64) -> f64 {
    let scene = scene(SQUARE);
    let elements = ground(&scene, basis, degree, cells, Space::Total);
    let mut coefficients = Vec::new();
    for element in elements.list() {
        let count = element.basis.len();
        let mut sums = vec![0.0; count];
        for (x, parameters, weight) in points(element) {
            let raw = element.raw_values(x, parameters);
            sums.iter_mut().zip(raw).for_each(|(sum, raw)| *sum += weight * f(x.x) * raw);
        }
        let rows = element.basis.transform().chunks_exact(count);
        coefficients.extend(rows.map(|row| row.iter().zip(&sums).map(|(t, s)| t * s).sum::<f64>()));
    }
    let subspace = Subspace::new(basis, &elements, &|_| degree, Space::Total);
    let fitted = subspace.map_or_else(|| coefficients.clone(), |own| own.projected(&coefficients));
    let (mut error, mut size, mut rest) = (0.0, 0.0, &fitted[..]);
    for element in elements.list() {
        let (own, others) = rest.split_at(element.basis.len());
        let raw = element.basis.to_raw(own);
        for (x, parameters, weight) in points(element) {
            error += weight * (f(x.x) - element.evaluate(&raw, x, parameters)).powi(2);
            size += weight * f(x.x).powi(2);
        }
        rest = others;
    }
    f64::sqrt(error / size)
}

/// Irradiance along a line under a small source at the height 0.4 above u = 0.3.
fn under_a_source(u: f64) -> f64 {
    0.16 / ((u - 0.3).powi(2) + 0.16).powi(2)
}

/// Functions along u: constants, tents, cosines and polynomials.
fn errors(unknowns: usize, f: fn(f64) -> f64) -> [f64; 4] {
    [
        best_fit(Basis::Constant, 0, unknowns, f),
        best_fit(Basis::Linear, 1, unknowns - 1, f),
        best_fit(Basis::Harmonic, unknowns - 1, 1, f),
        best_fit(Basis::Legendre, unknowns - 1, 1, f),
    ]
}

/// Unknowns, a function, and the errors of its best fits by constants, tents, cosines and polynomials.
type Row = (usize, fn(f64) -> f64, [f64; 4]);

#[test]
fn best_fits_are_those_of_an_independent_least_squares_program() {
    // NumPy's lstsq on the values of the functions at Gauss points.
    let table: [Row; 4] = [
        (5, under_a_source, [1.59133e-1, 5.71395e-2, 2.28927e-2, 7.11624e-2]),
        (9, under_a_source, [9.04027e-2, 1.18730e-2, 1.06203e-2, 2.64143e-3]),
        (15, under_a_source, [5.44723e-2, 3.49756e-3, 4.78367e-3, 8.01166e-5]),
        (9, f64::exp, [3.20552e-2, 5.82844e-4, 5.67855e-3, 1.20701e-11]),
    ];
    for (unknowns, f, expected) in table {
        let found = errors(unknowns, f);
        for (found, expected) in found.iter().zip(expected) {
            let rounding = 1e-13;
            assert!(
                (found - expected).abs() < 1e-4 * expected + rounding,
                "{unknowns}: {found:e} {expected:e}"
            );
        }
    }
}

/// The rate at which an error falls while `size` doubles.
fn rate(error: impl Fn(usize) -> f64, size: usize) -> f64 {
    (error(size) / error(2 * size)).log2()
}

#[test]
fn best_fits_converge_at_the_rates_of_theory() {
    let f = under_a_source;
    let constants = rate(|cells| best_fit(Basis::Constant, 0, cells, f), 8);
    assert!((constants - 1.0).abs() < 0.1, "{constants}");
    let tents = rate(|cells| best_fit(Basis::Linear, 1, cells, f), 12);
    assert!((tents - 2.0).abs() < 0.2, "{tents}");
    // A slope at the sides leaves coefficients like 1/i².
    let cosines = rate(|degree| best_fit(Basis::Harmonic, degree, 1, f), 9);
    assert!((cosines - 1.5).abs() < 0.15, "{cosines}");
    // Double poles at 0.3 ± 0.4 i, on the ellipse of sum of axes ϱ = 2.1466: errors like n ϱ⁻ⁿ.
    let fall = (best_fit(Basis::Legendre, 8, 1, f) / best_fit(Basis::Legendre, 20, 1, f)).ln() / 12.0;
    let expected = 2.1466f64.ln() - 2.5f64.ln() / 12.0;
    assert!((fall - expected).abs() < 0.1 * expected, "{fall} {expected}");
}

fn options(basis: Basis, order: usize, cells: usize) -> Options {
    Options { basis, order, subdivide: Some(cells), eps: 1e-6, ..Options::default() }
}

/// Irradiance from a unit square of exitance 1, at the height `h` below it: the sum of four corners (Howell's
/// catalogue, A-3).
fn below_a_square(x: f64, y: f64, h: f64) -> f64 {
    let corner = |a: f64, b: f64| {
        let (a, b) = (a / h, b / h);
        let (p, q) = ((1.0 + a * a).sqrt(), (1.0 + b * b).sqrt());
        (a / p * (b / p).atan() + b / q * (a / q).atan()) / std::f64::consts::TAU
    };
    corner(x, y) + corner(1.0 - x, y) + corner(x, 1.0 - y) + corner(1.0 - x, 1.0 - y)
}

/// Relative L² error of the irradiance of the floor below a luminous square.
fn error_below_a_square(options: &Options) -> f64 {
    let scene = typed(
        "materials.floor = { reflectance = 0.5 }\nmaterials.lamp = { reflectance = 0, emission = 1 }\n\
         [[surfaces]]\nmaterial = \"floor\"\nparallelogram = { origin = [0,0,0], edge1 = [1,0,0], edge2 = [0,1,0] }\n\
         [[surfaces]]\nmaterial = \"lamp\"\norder = 0\nparallelogram = { origin = [0,0,0.7], edge1 = [0,1,0], edge2 = [1,0,0] }\n",
    );
    let outcome = outcome_of(&scene, options);
    let solution = &outcome.solution;
    let (mut error, mut size) = (0.0, 0.0);
    for index in solution.elements().of_surface(0) {
        let element = &solution.elements().list()[index];
        for (x, parameters, weight) in points(element) {
            let place = radiosity::solve::solution::SurfacePlace { surface: 0, parameters, position: x };
            let exact = below_a_square(x.x, x.y, 0.7);
            error += weight * (solution.irradiance(0, index, &place) - exact).powi(2);
            size += weight * exact * exact;
        }
    }
    f64::sqrt(error / size)
}

#[test]
fn solutions_converge_at_the_rates_of_theory() {
    let of = |basis, order, cells| error_below_a_square(&options(basis, order, cells));
    let constants = rate(|cells| of(Basis::Constant, 0, cells), 4);
    assert!((constants - 1.0).abs() < 0.1, "{constants}");
    let tents = rate(|cells| of(Basis::Linear, 1, cells), 4);
    assert!((tents - 2.0).abs() < 0.2, "{tents}");
    // The light is even about the middle, so that even degrees alone matter.
    let [low, high] = [4, 10].map(|degree| of(Basis::Harmonic, degree, 1));
    let cosines = (low / high).ln() / (11.0f64 / 5.0).ln();
    assert!((cosines - 1.5).abs() < 0.15, "{cosines}: {low} {high}");
    let [low, high] = [2, 6].map(|order| of(Basis::Legendre, order, 1));
    assert!(high < 0.01 * low, "{low} {high}");
}

/// −½ ρ/(1 − ρ) A of a closed room of reflectance ρ and area A that emits 1.
#[test]
fn the_functional_of_a_furnace_is_known() {
    for name in ["furnace-cube", "furnace-sphere"] {
        let scene = builtin(name);
        let area: f64 = scene.surfaces.iter().map(|surface| surface.shape.area()).sum();
        for basis in [Basis::Legendre, Basis::Constant, Basis::Linear, Basis::Harmonic] {
            let outcome = outcome_of(&scene, &Options { eps: 1e-4, ..options(basis, 2, 2) });
            let [functional] = &outcome.functionals[..] else { panic!("one band, no groups") };
            let expected = -0.5 * area;
            assert!(
                (functional.value / expected - 1.0).abs() < 1e-4,
                "{name} {basis:?}: {}",
                functional.value
            );
            assert!((outcome.solution.mean_irradiance(0, 0) - 2.0).abs() < 1e-3, "{name} {basis:?}");
        }
    }
}

/// The functional of a run.
fn functional(scene: &Scene, options: &Options) -> f64 {
    outcome_of(scene, options).functionals.iter().map(|own| own.value).sum()
}

#[test]
fn larger_spaces_have_lower_functionals() {
    let scene = builtin("empty-box");
    let of = |basis, order, cells| functional(&scene, &options(basis, order, cells));
    let falls = |all: &[f64]| assert!(all.windows(2).all(|pair| pair[1] < pair[0]), "{all:?}");
    falls(&[0, 1, 2, 3].map(|order| of(Basis::Legendre, order, 1)));
    falls(&[1, 2, 4].map(|cells| of(Basis::Constant, 0, cells)));
    falls(&[1, 2, 4].map(|cells| of(Basis::Linear, 1, cells)));
    falls(&[0, 1, 2, 3].map(|degree| of(Basis::Harmonic, degree, 1)));
    // Constants lie among the polynomials of order 1 on the same cells, tents among those of order 2.
    falls(&[of(Basis::Constant, 0, 2), of(Basis::Legendre, 1, 2)]);
    falls(&[of(Basis::Linear, 1, 2), of(Basis::Legendre, 2, 2)]);
}

#[test]
fn cosines_do_not_depend_on_the_cells_that_hold_them() {
    let scene = builtin("empty-box");
    let [whole, cut] = [1, 3].map(|cells| functional(&scene, &options(Basis::Harmonic, 3, cells)));
    assert!((whole / cut - 1.0).abs() < 1e-5, "{whole} {cut}");
}

#[test]
fn every_solver_finds_the_same_light_in_every_basis() {
    let scene = builtin("empty-box");
    for basis in OTHERS {
        let means = |method: &'static Method| {
            let outcome = outcome_of(
                &scene,
                &Options { solver: method, tolerance: 1e-10, eps: 1e-3, ..options(basis, 1, 1) },
            );
            assert!(
                outcome.converged && outcome.residual < 1e-8,
                "{basis:?} {}: {}",
                method.name,
                outcome.residual
            );
            (0..scene.surfaces.len()).map(|s| outcome.solution.mean_irradiance(0, s)).collect::<Vec<_>>()
        };
        let first = means(&Method::ALL[0]);
        for method in &Method::ALL[1..] {
            let other = means(method);
            let same = first.iter().zip(&other).all(|(a, b)| (a - b).abs() < 1e-7 * a.abs().max(1e-3));
            assert!(same, "{basis:?} {}: {first:?} {other:?}", method.name);
        }
    }
}

#[test]
fn every_basis_keeps_power_to_rounding() {
    for name in ["empty-box", "two-boxes", "occluder-box"] {
        let scene = builtin(name);
        for basis in OTHERS {
            let checks = outcome_of(&scene, &Options { eps: 1e-3, ..options(basis, 2, 2) }).checks;
            let sum = checks.energy_absorbed + checks.energy_lost;
            assert!((sum / checks.energy_in - 1.0).abs() < 1e-6, "{name} {basis:?}: {checks:?}");
        }
    }
}

#[test]
fn tents_and_cosines_have_no_jumps_inside_surfaces() {
    let scene = builtin("empty-box");
    for (basis, jump) in [(Basis::Linear, 1e-12), (Basis::Harmonic, 1e-5)] {
        let found = outcome_of(&scene, &options(basis, 2, 4)).checks.seam_jump_max;
        assert!(found < jump, "{basis:?}: {found}");
    }
    assert!(outcome_of(&scene, &options(Basis::Constant, 0, 4)).checks.seam_jump_max > 0.1);
}

#[test]
fn solution_files_of_every_basis_are_read_as_they_were() {
    let scene = builtin("empty-box");
    for basis in OTHERS {
        let written = solved_of(scene.clone(), options(basis, 2, 2));
        let file = radiosity::reading::files::solution_file::SolutionFile::new(&written);
        let text = serde_json::to_string(&file).expect("it is written");
        let source = radiosity::scene::Source::new("file", &text);
        let read = radiosity::reading::files::solution_file::read(&source).expect("it is read");
        assert_eq!(read.options.basis, basis);
        assert_eq!(read.outcome.unknowns, written.outcome.unknowns);
        for (before, after) in written.outcome.solution.bands().iter().zip(read.outcome.solution.bands()) {
            assert_eq!(before.coefficients.irradiance, after.coefficients.irradiance);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn conjugate_gradients_lower_the_functional_of_rooms(
        reflectances in prop::collection::vec(0.0..0.98, 6), exitances in prop::collection::vec(0.0..5.0, 6), order in 0..4usize,
    ) {
        let scene = builtin("empty-box");
        let elements = elements_of(&scene, order, 1);
        let visibility = Visibility::open(&scene);
        let accuracy = Accuracy { eps: 1e-4, shadow_eps: 3e-3 };
        let blocks = blocks_of(&elements, &visibility, accuracy);
        let coating = Coating::constant(reflectances, exitances);
        let ritz = Ritz::new(System::new(elements.list(), &blocks, &coating), None);
        let (operator, _) = ritz.operator(&Method::CG, Preconditioner::Block, 1, 1).expect("it is finite");
        let right = ritz.right_hand_side();
        let mut unknowns = vec![0.0; right.len()];
        let mut values = Vec::new();
        let settings = Settings::default().with_tolerance(1e-14);
        let cg = Method::CG.solver;
        let mut observe = |step: &Step<'_>| values.push(functional_of(&*operator, &right, step.x));
        // The floor of rounding may come before the tolerance.
        let _ = cg.solve(&*operator, &right, &mut unknowns, &settings, &mut observe);
        let least = -0.5 * right.iter().zip(&unknowns).map(|(f, y)| f * y).sum::<f64>();
        prop_assert!(values.windows(2).all(|pair| pair[1] <= pair[0] + 1e-14 * least.abs()), "{values:?}");
        let found = ritz.found(&unknowns).functional;
        prop_assert!((found - least).abs() <= 1e-12 * least.abs(), "{found} {least}");
    }
}

/// Steps of cg in the tube that `scene` holds, closed by a lamp at one end.
fn steps(order: usize, cells: usize, preconditioner: Preconditioning) -> usize {
    let scene = typed(
        "materials.wall = { reflectance = 0.9 }\nmaterials.lamp = { reflectance = 0, emission = 10 }\n\
         [[surfaces]]\nmaterial = \"wall\"\nflip = true\ncylinder = { base = [0,0,0], axis = [0,0,4], radius = 0.5 }\n\
         [[surfaces]]\nmaterial = \"lamp\"\ndisk = { center = [0,0,0], normal = [0,0,1], radius = 0.5 }\n",
    );
    let method = &Method::CG;
    let options = Options {
        preconditioner,
        solver: method,
        transport: Transport::Exact,
        tolerance: 1e-10,
        order,
        subdivide: Some(cells),
        ..Options::default()
    };
    outcome_of(&scene, &options).iterations
}

#[test]
fn preconditioned_gradients_solve_a_single_concave_element_at_once() {
    let [block, none] = [Preconditioning::Block, Preconditioning::None].map(|own| steps(6, 1, own));
    assert!(block == 1 && none > 5, "{block} {none}");
    let [block, none] = [Preconditioning::Block, Preconditioning::None].map(|own| steps(3, 4, own));
    assert!(block.abs_diff(none) < 4, "{block} {none}");
}
