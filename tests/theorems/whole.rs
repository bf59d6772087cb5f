//! Properties that must hold whatever the numbers: the white furnace, energy, agreement of solvers, equal
//! bits.

use radiosity::Work;
use radiosity::elements::cells::Layers;
use radiosity::elements::coating::Coating;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Elements, Subdivide};
use radiosity::kernel::Accuracy;
use radiosity::light::direct::DirectLight;
use radiosity::light::first_bounce::DirectLightEntry;
use radiosity::reading::grid::{Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::solve::checks::Checks;
use radiosity::solve::solution::{Band, Solution, SurfacePlace};
use radiosity::solve::system::System;
use radiosity::solve::{Options, Outcome};
use radiosity::visibility::{Shadows, Visibility};
use radiosity::work::ranks::Ranks;
use radiosity_solvers::Settings;
use radiosity_solvers::method::Method;
use radiosity_test_support::direct::ACCURACY;
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::{blocks_of, outcome_of};

fn options(order: usize, solver: &str) -> Options {
    let method = Method::named(solver).expect("the solver is listed");
    Options { order, solver: method, tolerance: 1e-10, threads: 2, ..Options::default() }
}

fn solved(scene: &str, options: &Options) -> Outcome {
    let scene = builtin(scene);
    outcome_of(&scene, options)
}

/// Largest |B − 2| over a grid on every element that reaches its corners.
fn furnace_error(solution: &Solution) -> f64 {
    let ticks: Vec<f64> = (0..=10).map(|k| -1.0 + 0.2 * f64::from(k)).collect();
    let mut largest = 0.0f64;
    for (index, element) in solution.elements().list().iter().enumerate() {
        for (u, v) in ticks.iter().flat_map(|u| ticks.iter().map(move |v| (*u, *v))) {
            let position = solution.elements().shape(element.surface).jet(u, v).position;
            let place = SurfacePlace { surface: element.surface, parameters: [u, v], position };
            largest = largest.max((solution.radiosity(0, index, &place) - 2.0).abs());
        }
    }
    largest
}

/// The furnace cube with given blocks, by one solver; the residual is that of the original system.
fn furnace(order: usize, eps: f64) -> Vec<(&'static str, Solution, Checks, f64)> {
    let scene = builtin("furnace-cube");
    let visibility = Visibility::open(&scene);
    let how =
        Discretization { order, space: Space::Total, subdivide: Subdivide::Uniform(1), layers: Layers::NONE };
    let accuracy = Accuracy { eps, shadow_eps: 3e-3 };
    let assemble = |elements: &Elements| blocks_of(elements, &visibility, accuracy);
    let blocks = assemble(&Elements::new(&scene, &how).expect("a cube has area"));
    let solve_with = |method: &'static Method| {
        let elements = Elements::new(&scene, &how).expect("a cube has area");
        let coating = Coating::constant(vec![0.5; 6], vec![1.0; 6]);
        let system = System::new(elements.list(), &blocks, &coating);
        let right = system.right_hand_side();
        let mut unknowns = vec![0.0; right.len()];
        let measure = system.shooting_measure();
        let settings = Settings::default().with_tolerance(1e-12).with_measure(&measure);
        let matrix = system.matrix().expect("the matrix is finite");
        method.solver.solve(&matrix, &right, &mut unknowns, &settings, &mut |_| {}).expect(method.name);
        let coefficients = system.coefficients(&unknowns);
        let residual = coefficients.residual;
        let band = Band::new("grey".into(), &elements, coating.clone(), coefficients);
        let solution = Solution::new(elements, vec![band]);
        let checks = Checks::of(&solution, &blocks, &DirectLightEntry::Carried, Ranks::alone());
        (method.name, solution, checks, residual)
    };
    Method::ALL.iter().map(solve_with).collect()
}

#[test]
fn white_furnace_is_two_everywhere_for_every_solver_and_order() {
    for eps in [1e-4, 1e-8] {
        for order in 0..=8 {
            for (name, solution, checks, residual) in furnace(order, eps) {
                let error = furnace_error(&solution);
                assert!(error <= 10.0 * eps, "{name}, order {order}, eps {eps:e}: |B - 2| = {error:e}");
                let imbalance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
                // A direct solver's residual can be below one rounding of the sums themselves.
                let allowed = 10.0 * residual.max(f64::EPSILON) * checks.energy_in;
                assert!(imbalance.abs() <= allowed, "{name}, order {order}: {imbalance:e} of {allowed:e}");
            }
        }
    }
}

#[test]
fn furnace_error_falls_with_eps() {
    let error = |eps| furnace_error(&furnace(4, eps)[0].1);
    let (coarse, fine) = (error(1e-2), error(1e-8));
    assert!(fine < 1e-4 * coarse, "{coarse:e} {fine:e}");
}

/// Largest difference of radiosity coefficients relative to the largest coefficient.
fn difference(a: &Outcome, b: &Outcome) -> f64 {
    let (mut largest, mut scale) = (0.0f64, 0.0f64);
    for (x, y) in a.solution.bands().iter().zip(b.solution.bands()) {
        for (x, y) in x.coefficients.radiosity.iter().zip(&y.coefficients.radiosity) {
            largest = largest.max((x - y).abs());
            scale = scale.max(x.abs());
        }
    }
    largest / scale
}

#[test]
fn solvers_agree_on_every_small_built_in_scene() {
    // Solvers see matrices: the large scenes would add time, not cases.
    let small =
        |scene: &&str| !["teapot", "temple", "billiard", "billiard-slide", "cathedral"].contains(scene);
    for scene in radiosity::language::builtins().iter().map(|scene| scene.name).filter(small) {
        let reference = solved(scene, &options(2, "lu"));
        assert!(reference.residual < 1e-12);
        for method in Method::ALL {
            let other = solved(scene, &options(2, method.name));
            // Error of the unknowns: the residual over the lowest eigenvalue, 1 − ρ_max.
            let largest = difference(&reference, &other);
            assert!(largest <= 1e-8, "{scene}, {}: {largest:e}", method.name);
        }
    }
}

/// The bits of all radiosity coefficients.
fn bits(outcome: &Outcome) -> Vec<u64> {
    let bands = outcome.solution.bands().iter();
    bands.flat_map(|band| band.coefficients.radiosity.iter().map(|b| b.to_bits())).collect()
}

#[test]
fn threads_do_not_change_a_bit() {
    for solver in ["auto", "lu", "southwell"] {
        let with = |threads| solved("cornell-box", &Options { threads, ..options(3, solver) });
        let (one, two) = (with(1), with(2));
        assert_eq!(bits(&one), bits(&two), "{solver}");
        assert_eq!(one.checks, two.checks);
        assert_eq!((one.samples, one.rays), (two.samples, two.rays));
    }
}

#[test]
fn transport_is_bounded_and_energy_is_kept_with_shadows() {
    for order in [0, 3] {
        let outcome = solved("cornell-box", &options(order, "lu"));
        let checks = outcome.checks;
        assert!(checks.row_sum_min > 0.0 && checks.row_sum_max <= 1.0 + 3e-3, "{checks:?}");
        assert!(checks.spectral_bound < 0.765, "below the largest reflectance but one: {checks:?}");
        // An identity of the discrete solution, whatever the transfers are: what is checked is the solver.
        let imbalance = (checks.energy_in - checks.energy_absorbed - checks.energy_lost).abs();
        assert!(imbalance <= 1e-7 * checks.energy_in, "{imbalance:e}");
        assert!(checks.energy_lost > 0.1 * checks.energy_in, "the box is open");
    }
}

#[test]
fn closed_rooms_lose_no_more_power_than_their_transfers_at_any_order() {
    for order in [0, 1, 4] {
        let outcome = solved("empty-box", &Options { eps: 1e-8, ..options(order, "lu") });
        let checks = outcome.checks;
        assert!((checks.energy_absorbed - checks.energy_in).abs() <= 1e-7 * checks.energy_in, "{checks:?}");
        assert!(checks.closure_max < 1e-7);
    }
}

/// Irradiance below the middle of a square of exitance 1 and half side a at distance 1: four times the
/// corner's 1/(2π) · 2 a/√(1+a²) atan(a/√(1+a²)).
#[test]
fn direct_light_is_exact_at_a_point() {
    let scene = builtin("empty-box");
    let outcome = solved("empty-box", &Options { eps: 1e-6, ..options(8, "auto") });
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    let direct = DirectLight::within(&outcome.solution.emitters(), &visibility, ACCURACY);
    let floor = scene.surfaces.iter().position(|surface| surface.name == "floor").expect("there is a floor");
    let jet = scene.surfaces[floor].shape.jet(0.0, 0.0);
    let lit: f64 = direct.at(floor, jet.position, jet.normal)[0];
    let q = 0.5 / 0.5f64.hypot(1.0);
    let exact = 4.0 / std::f64::consts::PI * q * q.atan();
    assert!((lit - exact).abs() < 1e-14, "{lit} {exact}");
    // What the polynomials make of the same light converges to it.
    let place = SurfacePlace { surface: floor, parameters: [0.0; 2], position: jet.position };
    let basis = outcome.solution.irradiance(0, floor, &place);
    let split = lit + outcome.solution.indirect(0, floor, &place);
    assert!((basis - split).abs() < 1e-4 * split, "{basis} {split}");
}

#[test]
fn cells_add_up_to_the_whole() {
    let outcome = solved("cornell-box", &options(3, "lu"));
    let solution = &outcome.solution;
    let scene = builtin("cornell-box");
    let visibility = Visibility::open(&scene);
    let reader = Reader::new(solution, &visibility, ReadMode::Basis, 1e-3);
    for cells in [[1, 1], [3, 5]] {
        let mut power = vec![0.0; scene.surfaces.len()];
        for cell in grid(&reader, cells, Rates::default(), &Work::alone()) {
            power[cell.surface] += cell.area * cell.irradiance[0];
        }
        for (surface, power) in power.iter().enumerate() {
            let exact: f64 = solution.elements().of_surface(surface).map(|i| mean_power(solution, i)).sum();
            assert!((power - exact).abs() <= 1e-9 * exact, "surface {surface}: {power} {exact}");
        }
    }
}

/// ∫ E dA over an element: ⟨c, h⟩.
fn mean_power(solution: &Solution, element: usize) -> f64 {
    let list = solution.elements().list();
    let start: usize = list[..element].iter().map(|e| e.basis.len()).sum();
    let own = &solution.bands()[0].coefficients.irradiance[start..];
    list[element].constant.iter().zip(own).map(|(c, h)| c * h).sum()
}

/// Total degree 2N contains degree N in each coordinate: on squares, function by function.
#[test]
fn tensor_blocks_are_parts_of_the_blocks_of_total_degree() {
    let scene = builtin("furnace-cube");
    let visibility = Visibility::open(&scene);
    let accuracy = Accuracy { eps: 1e-10, shadow_eps: 3e-3 };
    let cut = |order, space| {
        let how = Discretization { order, space, subdivide: Subdivide::Uniform(1), layers: Layers::NONE };
        Elements::new(&scene, &how).expect("a cube has area")
    };
    let blocks = |elements: &Elements| blocks_of(elements, &visibility, accuracy);
    let (tensor, total) = (cut(3, Space::Tensor), cut(6, Space::Total));
    let (small, large) = (blocks(&tensor), blocks(&total));
    let places: Vec<usize> = tensor.list()[0]
        .basis
        .degrees()
        .map(|degrees| {
            total.list()[0].basis.degrees().position(|other| other == degrees).expect("i + j ≤ 2N")
        })
        .collect();
    let count = total.list()[0].basis.len();
    assert_eq!(small.iter().count(), 15);
    for (ours, theirs) in small.iter().zip(large.iter()) {
        let [i, j] = [ours.row, ours.column];
        assert_eq!([i, j], [theirs.row, theirs.column]);
        for (row, ours) in places.iter().zip(ours.values.chunks_exact(places.len())) {
            for (column, value) in places.iter().zip(ours) {
                let error = value - theirs.values[row * count + column];
                assert!(error.abs() < 1e-9, "{i} {j}: {error:e}");
            }
        }
    }
}
