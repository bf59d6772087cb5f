//! Progressive refinement: shots, the columns that are integrated for them, and the ambient term.

use radiosity::kernel::PlacedBlock;
use radiosity::kernel::block_columns::{BlockColumns, ByColumn};
use radiosity::solve::{
    ColumnChoice, Direct, Failure, Options, Outcome, RelaxedAtOnce, Relaxing, ShotLimit, Shots, SweepOrder,
    Transport, solve,
};
use radiosity::transport::{ColumnsAsShot, Demand};
use radiosity::{Scene, Work};
use radiosity_core::dot;
use radiosity_solvers::method::Method;
use radiosity_test_support::scenes::{builtin, builtin_with, material, typed};
use radiosity_test_support::solved::{blocks_of, elements_of, outcome_of};

/// Options of a run by shots, all light carried by them.
fn by_shots(order: usize, count: impl Into<Option<usize>>) -> Options {
    Options {
        order,
        eps: 1e-6,
        solver: &Method::SOUTHWELL,
        direct: Direct::Projected,
        shots: count.into().map(|count| ShotLimit { count, ambient: false }),
        ..Options::default()
    }
}

fn ambient(options: Options) -> Options {
    Options { shots: options.shots.map(|shots| ShotLimit { ambient: true, ..shots }), ..options }
}

fn shots(outcome: &Outcome) -> &Shots {
    outcome.shots.as_ref().expect("light was shot")
}

/// ∫ B dA of a scene of one band.
fn power(outcome: &Outcome) -> f64 {
    dot(&outcome.solution.bands()[0].coefficients.radiosity, &outcome.solution.elements().constant())
}

/// Coefficients of the irradiance of all bands, as bits.
fn bits(outcome: &Outcome) -> Vec<u64> {
    let bands = outcome.solution.bands().iter();
    bands.flat_map(|band| &band.coefficients.irradiance).map(|h| h.to_bits()).collect()
}

/// Two unit squares that face each other at a distance of 1; the lower one emits 1, both reflect a half.
fn two_squares() -> Scene {
    typed(
        r#"
        materials.lamp = { reflectance = 0.5, emission = 1 }
        materials.grey = { reflectance = 0.5 }
        [[surfaces]]
        name = "lower"
        material = "lamp"
        quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] }
        [[surfaces]]
        name = "upper"
        material = "grey"
        quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }
        "#,
    )
}

/// The inside of a cylinder over a disk that emits 1.
fn tube() -> Scene {
    typed(
        r#"
        materials.lamp = { reflectance = 0.5, emission = 1 }
        materials.grey = { reflectance = 0.8 }
        [[surfaces]]
        name = "tube"
        material = "grey"
        flip = true
        cylinder = { base = [0, 0, 0], axis = [0, 0, 1], radius = 1 }
        [[surfaces]]
        name = "lamp"
        material = "lamp"
        disk = { center = [0, 0, -0.5], normal = [0, 0, 1], radius = 0.5 }
        "#,
    )
}

#[test]
fn the_ambient_term_is_all_the_light_of_a_furnace_before_the_first_shot() {
    for name in ["furnace-cube", "furnace-sphere"] {
        for reflectance in [0.2, 0.5, 0.9] {
            let scene =
                builtin(name).with_material("wall", material(reflectance, 1.0)).expect("it has walls");
            let outcome = outcome_of(&scene, &ambient(by_shots(2, 0)));
            assert_eq!((shots(&outcome).count, shots(&outcome).columns), (0, 0));
            for surface in 0..scene.surfaces.len() {
                let expected = 1.0 / (1.0 - reflectance);
                let found = outcome.solution.mean_irradiance(0, surface);
                assert!((found / expected - 1.0).abs() < 1e-12, "{name} {reflectance}: {found}");
            }
            let dark = outcome_of(&scene, &by_shots(2, 0));
            assert_eq!(dark.solution.mean_irradiance(0, 0), 0.0);
        }
    }
}

#[test]
fn the_ambient_term_keeps_the_power_of_a_closed_room_after_any_number_of_shots() {
    // The ceiling of the unit cube emits 1; every wall reflects ρ: 1 / (1 − ρ) is sent in all.
    for reflectance in [0.3, 0.7] {
        let scene = builtin_with("empty-box", &[("reflectance", reflectance)]);
        for count in [0, 1, 2, 3, 5, 8, 20] {
            let outcome = outcome_of(&scene, &ambient(by_shots(1, count)));
            let found = power(&outcome) * (1.0 - reflectance);
            assert!((found - 1.0).abs() < 1e-4, "{reflectance} {count}: {found}");
            let without = power(&outcome_of(&scene, &by_shots(1, count))) * (1.0 - reflectance);
            assert!(
                without < 1.0 + 1e-4 && (without < 0.99 || count > 5),
                "{reflectance} {count}: {without}"
            );
        }
    }
}

#[test]
fn one_shot_is_the_light_of_one_lamp() {
    let scene = two_squares();
    let outcome = outcome_of(&scene, &by_shots(0, 1));
    let made = shots(&outcome);
    assert_eq!((made.count, made.columns, made.of, made.are_lazy()), (1, 1, 2, true));
    assert_eq!(outcome.iterations, 1);
    // The view factor between opposite unit squares at a distance of 1 (Howell, C-11).
    let factor = 0.199_824_895_698_387_26;
    let [lower, upper] = [0, 1].map(|surface| outcome.solution.mean_irradiance(0, surface));
    assert_eq!(lower, 0.0);
    assert!((upper - factor).abs() < 1e-6, "{upper}");
    // A half of what arrived waits.
    assert!((made.unshot - 0.5 * factor).abs() < 1e-6, "{}", made.unshot);
    // The second shot sends it back.
    let second = outcome_of(&scene, &by_shots(0, 2));
    assert!((second.solution.mean_irradiance(0, 0) - 0.5 * factor * factor).abs() < 1e-6);
    assert_eq!(shots(&second).columns, 2);
}

#[test]
fn power_is_absorbed_or_lost_or_waits() {
    for scene in [two_squares(), builtin("occluder-box")] {
        for count in [0, 1, 2, 3, 4] {
            let outcome = outcome_of(&scene, &by_shots(1, count));
            let checks = &outcome.checks;
            let waits = shots(&outcome).unshot * checks.energy_in;
            let all = checks.energy_absorbed + checks.energy_lost + waits;
            assert!((all / checks.energy_in - 1.0).abs() < 1e-12, "{count}: {all} {}", checks.energy_in);
        }
    }
}

#[test]
fn unshot_power_falls_with_every_shot() {
    for name in ["empty-box", "furnace-sphere", "occluder-box"] {
        for order in [0, 2] {
            let outcome = outcome_of(&builtin(name), &by_shots(order, 40));
            let history = &shots(&outcome).history;
            assert_eq!((history.len(), history[0].unshot), (shots(&outcome).count + 1, 1.0));
            let falls = history.windows(2).all(|pair| pair[1].unshot < pair[0].unshot);
            assert!(falls, "{name} {order}: {history:?}");
            assert!(history.windows(2).all(|pair| pair[1].columns <= pair[0].columns + 1), "{name}");
        }
    }
}

#[test]
fn columns_integrated_as_they_are_shot_are_those_of_the_whole_matrix() {
    for (name, order) in [("occluder-box", 1), ("two-boxes", 0), ("furnace-sphere", 2)] {
        let scene = builtin(name);
        let elements = elements_of(&scene, order, 2);
        let options = by_shots(order, None);
        let visibility = options.visibility(&scene);
        let whole = blocks_of(&elements, &visibility, options.accuracy());
        let whole = ByColumn::of(&whole);
        let columns =
            ColumnsAsShot::new(Demand::all(&elements, &visibility, options.accuracy()), Work::alone());
        // In another order than that of the matrix.
        for element in (0..elements.list().len()).rev() {
            let [all, own] = [&whole as &dyn BlockColumns, &columns].map(|own| nonzero(own.column(element)));
            assert_eq!(own, all, "{name}, column {element}");
        }
    }
}

/// Receivers of blocks that differ from zero, with their values as bits.
fn nonzero(column: Vec<PlacedBlock<'_>>) -> Vec<(usize, usize, Vec<u64>)> {
    let is_lit = |block: &PlacedBlock<'_>| block.values.iter().any(|value| *value != 0.0);
    let bits = |block: PlacedBlock<'_>| {
        (block.row, block.column, block.values.iter().map(|value| value.to_bits()).collect())
    };
    column.into_iter().filter(is_lit).map(bits).collect()
}

#[test]
fn light_is_the_same_to_the_bit_whenever_columns_are_integrated() {
    for name in ["occluder-box", "furnace-sphere"] {
        for count in [Some(0), Some(3), None] {
            for direct in [Direct::Projected, Direct::Auto] {
                let options = Options { direct, tolerance: 1e-4, ..by_shots(1, count) };
                let [lazy, all] = [ColumnChoice::Shot, ColumnChoice::All].map(|columns| {
                    outcome_of(&builtin(name), &Options { columns: Some(columns), ..options })
                });
                assert_eq!(bits(&lazy), bits(&all), "{name} {count:?} {direct:?}");
                assert!(shots(&lazy).are_lazy() && !shots(&all).are_lazy());
                assert_eq!(shots(&all).columns, shots(&all).of);
            }
        }
    }
}

#[test]
fn few_shots_integrate_few_columns_and_pairs() {
    let scene = builtin("two-boxes");
    let options = Options { subdivide: Some(2), ..by_shots(0, 4) };
    let outcome = outcome_of(&scene, &options);
    let [some, all] =
        [&outcome, &outcome_of(&scene, &Options { columns: Some(ColumnChoice::All), ..options })]
            .map(|outcome| outcome.distinct);
    assert!(shots(&outcome).columns <= 4 && shots(&outcome).of >= 60, "{:?}", shots(&outcome));
    assert!(4 * some < all, "{some} of {all} kernel values");
}

#[test]
fn shooting_finds_the_light_of_other_solvers() {
    for name in ["empty-box", "occluder-box", "two-boxes"] {
        let options = Options { tolerance: 1e-9, direct: Direct::Auto, ..by_shots(1, None) };
        let shot = outcome_of(&builtin(name), &options);
        let solved = outcome_of(&builtin(name), &Options { solver: &Method::LU, ..options });
        for surface in 0..builtin(name).surfaces.len() {
            let [own, other] = [&shot, &solved].map(|outcome| outcome.solution.mean_irradiance(0, surface));
            assert!((own - other).abs() < 1e-6 * (1.0 + other), "{name} {surface}: {own} {other}");
        }
    }
}

#[test]
fn every_way_of_relaxing_finds_the_same_light() {
    // Only elements that see themselves have more than the identity for a diagonal block.
    let (flat, curved) = (builtin("empty-box"), tube());
    let options = |solver, relaxing| Options { solver, relaxing, tolerance: 1e-8, ..by_shots(2, None) };
    let usual = Relaxing::default();
    let by_coefficient = Relaxing { at_once: RelaxedAtOnce::Coefficient, ..usual };
    for (scene, solver, relaxing) in [
        (&curved, &Method::GAUSS_SEIDEL, by_coefficient),
        (&flat, &Method::GAUSS_SEIDEL, Relaxing { sweep: SweepOrder::Symmetric, ..usual }),
        (&flat, &Method::GAUSS_SEIDEL, Relaxing { relaxation: 1.1, ..usual }),
        (&curved, &Method::JACOBI, by_coefficient),
        (&flat, &Method::RICHARDSON, Relaxing { relaxation: 0.9, ..usual }),
        (&flat, &Method::SOUTHWELL, by_coefficient),
        (&flat, &Method::SOUTHWELL, Relaxing { relaxation: 1.1, ..usual }),
        (&flat, &Method::GMRES, Relaxing { restart: 2, ..usual }),
    ] {
        let exact = outcome_of(scene, &options(&Method::LU, usual)).solution.mean_irradiance(0, 0);
        let outcome = outcome_of(scene, &options(solver, relaxing));
        let found = outcome.solution.mean_irradiance(0, 0);
        assert!((found - exact).abs() < 1e-6, "{} {relaxing:?}: {found} {exact}", solver.name);
        let usual = outcome_of(scene, &options(solver, usual));
        assert_ne!(bits(&outcome), bits(&usual), "{} {relaxing:?} changes nothing", solver.name);
    }
}

#[test]
fn columns_are_not_told_to_be_integrated_as_they_are_shot_where_they_are_not() {
    let rays = Options { transport: Transport::Sampled, rays: Some(100_000), ..by_shots(0, 3) };
    let outcome = outcome_of(&builtin("empty-box"), &rays);
    let made = shots(&outcome);
    assert_eq!((made.columns, made.all_first.as_deref()), (made.of, Some("rays carry the light")));
    let refused = Options { columns: Some(ColumnChoice::Shot), ..rays };
    let found = solve(&builtin("empty-box"), &refused, &Work::alone());
    assert!(matches!(found, Err(Failure::AllFirst { why: "rays carry the light" })));
}
