//! Promises of the settings.

use std::time::Duration;

use radiosity_solvers::method::{Method, Needs};
use radiosity_solvers::{Granularity, Operator, Partition, Settings, SolveError, Stop};

use crate::exact::norm;
use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, matrix, partition, positive_definite};

#[test]
fn no_tolerance_is_too_small_to_end() {
    let random = &mut Random(19);
    for floor in [1e-1, 1e-4, 1e-8] {
        let partition = partition(random, 40, 7);
        let a = positive_definite(random, partition, floor);
        let b = random.numbers(40);
        let settings = Settings::default().with_tolerance(0.0).with_max_iterations(100_000);
        for method in Method::ALL {
            let mut x = vec![0.0; 40];
            let solved = method.solver.solve(&a, &b, &mut x, &settings, &mut |_| ());
            let Err(SolveError::NotConverged { residual, stop, .. }) = solved else {
                panic!("{}: {solved:?}", method.name);
            };
            assert!(
                matches!(stop, Stop::Stagnation | Stop::Iterations | Stop::Divergence),
                "{}",
                method.name
            );
            // What converges at all goes down to the rounding floor, ε ‖A‖ ‖x‖ / ‖b‖ times a modest factor.
            let reachable = 1e-14 * norm(&x) / norm(&b);
            let slow = ["jacobi", "richardson"].contains(&method.name) || floor < 1e-6;
            assert!(slow || residual <= reachable, "{}: {residual:e} {reachable:e}", method.name);
        }
    }
}

#[test]
fn the_condition_number_is_found_on_request() {
    // ‖A‖₁ = 1, ‖A⁻¹‖₁ = 10⁶.
    let diagonal = [1.0, 1e-3, 1e-6, 0.5];
    let a = matrix(Partition::new(&[2, 2]), true, |i, j| if i == j { diagonal[i] } else { 0.0 });
    for method in Method::ALL.iter().filter(|method| method.storage == "n²") {
        let mut x = vec![0.0; 4];
        let asked = Settings::default().with_condition(true);
        let report = method.solver.solve(&a, &[1.0; 4], &mut x, &asked, &mut |_| ()).unwrap();
        assert!(
            (report.condition.unwrap() / 1e6 - 1.0).abs() < 1e-12,
            "{}: {:?}",
            method.name,
            report.condition
        );
        let report = method.solver.solve(&a, &[1.0; 4], &mut x, &Settings::default(), &mut |_| ()).unwrap();
        assert_eq!(report.condition, None);
    }
}

#[test]
fn the_condition_number_is_a_close_lower_bound() {
    let random = &mut Random(23);
    for _ in 0..50 {
        let dim = 1 + random.below(12);
        let a = matrix(Partition::points(dim), false, |_, _| random.signed());
        let mut inverse = vec![0.0; dim * dim];
        let mut identity = inverse.clone();
        (0..dim).for_each(|i| identity[i * dim + i] = 1.0);
        let one_norm = |values: &[f64]| {
            values.chunks(dim).map(|column| column.iter().map(|a| a.abs()).sum::<f64>()).fold(0.0, f64::max)
        };
        let settings = Settings::default().with_condition(true);
        for method in Method::ALL.iter().filter(|method| method.name.starts_with("lu")) {
            let reports =
                method.solver.solve_many(&a, &identity, &mut inverse, &settings, &mut |_| ()).unwrap();
            let condition = one_norm(a.values()) * one_norm(&inverse);
            let estimate = reports[0].condition.unwrap();
            assert!(estimate <= condition * 1.000_001, "{}: {estimate} {condition}", method.name);
            assert!(estimate >= condition / 5.0, "{}: {estimate} {condition}", method.name);
        }
    }
}

#[test]
fn iterations_start_from_the_given_guess() {
    let random = &mut Random(29);
    let a = enclosure(random, Partition::new(&[3; 10]), [0.5, 0.95], true);
    let truth: Vec<f64> = (0..30).map(|_| random.unit()).collect();
    let mut b = vec![0.0; 30];
    a.apply(&truth, &mut b);
    for name in ["gauss-seidel", "southwell", "cg", "gmres", "jacobi"] {
        let solver = Method::named(name).unwrap().solver;
        let mut x = truth.clone();
        let report = solver.solve(&a, &b, &mut x, &Settings::default(), &mut |_| ()).unwrap();
        assert_eq!((report.iterations, &x), (0, &truth), "{name}");
    }
}

#[test]
fn nothing_and_zero_are_solved() {
    let empty = matrix(Partition::new(&[]), true, |_, _| 0.0);
    let identity = matrix(Partition::new(&[1, 0, 2]), true, |i, j| f64::from(u8::from(i == j)));
    for method in Method::ALL {
        let report = method.solver.solve(&empty, &[], &mut [], &Settings::default(), &mut |_| ()).unwrap();
        assert_eq!(report.residual, 0.0, "{}", method.name);
        let none = method.solver.solve_many(&empty, &[], &mut [], &Settings::default(), &mut |_| ());
        assert_eq!(none, Ok(Vec::new()), "{}", method.name);
        let mut x = [1.0, 2.0, 3.0];
        let report =
            method.solver.solve(&identity, &[0.0; 3], &mut x, &Settings::default(), &mut |_| ()).unwrap();
        assert_eq!((report.residual, x), (0.0, [0.0; 3]), "{}", method.name);
    }
}

#[test]
fn nothing_has_no_condition() {
    let empty = matrix(Partition::new(&[0, 0]), true, |_, _| 0.0);
    let settings = Settings::default().with_condition(true);
    for method in Method::ALL {
        assert!(method.solver.solve(&empty, &[], &mut [], &settings, &mut |_| ()).is_ok(), "{}", method.name);
    }
}

#[test]
fn empty_blocks_are_passed_over() {
    let random = &mut Random(71);
    let a = enclosure(random, Partition::new(&[0, 2, 0, 0, 3, 1, 0]), [0.3, 0.8], true);
    let b = random.numbers(6);
    for granularity in [Granularity::Block, Granularity::Coefficient] {
        for method in Method::ALL {
            let mut x = vec![0.0; 6];
            let settings = Settings::default().with_granularity(granularity);
            let solved = method.solver.solve(&a, &b, &mut x, &settings, &mut |_| ());
            assert!(solved.is_ok(), "{}: {solved:?}", method.name);
        }
    }
}

#[test]
fn the_unit_of_the_matrix_does_not_matter() {
    for unit in [1e-200, 1e-100, 1e100, 1e200] {
        let a = matrix(Partition::new(&[2, 1]), true, |i, j| unit * if i == j { 1.0 } else { 0.25 });
        for method in Method::ALL.iter().filter(|method| method.needs != Needs::NearIdentity) {
            let mut x = vec![0.0; 3];
            let solved = method.solver.solve(&a, &[1.0, 2.0, 3.0], &mut x, &Settings::default(), &mut |_| ());
            assert!(solved.is_ok(), "{} with {unit:e}: {solved:?}", method.name);
        }
    }
}

#[test]
fn what_rises_first_and_falls_slowly_is_not_stuck() {
    // One large unknown among 400 in a closed system that reflects 99 %: it sends its light to all others,
    // and they send nine tenths to it. From b = e₀ the residual spreads, grows tenfold, and takes some 200
    // iterations to return to its first value.
    let dim = 400;
    let share = |i: usize, j: usize| match (i, j) {
        (0, 0) => 0.0,
        (0, _) => 1.0 / (dim - 1) as f64,
        (_, 0) => 0.9,
        (_, _) if i == j => 0.0,
        _ => 0.1 / (dim - 2) as f64,
    };
    let a = matrix(Partition::points(dim), false, |i, j| f64::from(u8::from(i == j)) - 0.99 * share(i, j));
    let mut b = vec![0.0; dim];
    b[0] = 1.0;
    let settings = Settings::default().with_max_iterations(10_000);
    for name in ["jacobi", "richardson", "gauss-seidel", "southwell"] {
        let mut x = vec![0.0; dim];
        let solved = Method::named(name).unwrap().solver.solve(&a, &b, &mut x, &settings, &mut |_| ());
        assert!(solved.is_ok(), "{name}: {solved:?}");
    }
}

#[test]
fn several_right_hand_sides_share_one_time_budget() {
    let a = enclosure(&mut Random(73), Partition::points(20), [0.3, 0.8], true);
    let pause = Duration::from_millis(40);
    let settings = Settings::default().with_time_budget(pause);
    for name in ["jacobi", "gauss-seidel", "gmres", "southwell", "cg"] {
        let (b, mut x) = (vec![1.0; 40], vec![0.0; 40]);
        let mut steps = 0;
        let solver = Method::named(name).unwrap().solver;
        let solved = solver.solve_many(&a, &b, &mut x, &settings, &mut |_| {
            // The first column takes all the time before its first iteration; none is left for the second.
            if steps == 0 {
                std::thread::sleep(pause);
            }
            steps += 1;
        });
        assert!(
            matches!(solved, Err(SolveError::NotConverged { stop: Stop::Time, .. })),
            "{name}: {solved:?}"
        );
        assert_eq!(steps, 2, "{name}");
    }
}

#[test]
fn observers_see_what_the_report_keeps() {
    let random = &mut Random(31);
    let a = enclosure(random, Partition::new(&[2; 9]), [0.5, 0.9], true);
    let b = random.numbers(18);
    for method in Method::ALL {
        let (mut x, mut seen) = (vec![0.0; 18], Vec::new());
        let report = method.solver.solve(&a, &b, &mut x, &Settings::default(), &mut |step| {
            assert_eq!(step.iteration, seen.len());
            seen.push(step.residual);
        });
        let report = report.unwrap();
        assert_eq!(seen, report.history, "{}", method.name);
        assert_eq!(report.iterations + 1, seen.len(), "{}", method.name);
    }
}

#[test]
fn a_residual_that_rises_and_then_falls_slowly_is_not_stuck() {
    // Six walls that see each other alike and reflect all but 10⁻⁵, one of them lit: column sums are 1 − ρ.
    let rho = 1.0 - 1e-5;
    let partition = partition(&mut Random(1), 6, 1);
    let a = matrix(partition, true, |i, j| if i == j { 1.0 } else { -0.2 * rho });
    let b: Vec<f64> = (0..6).map(|i| if i == 0 { 0.0 } else { 0.2 * rho }).collect();
    let settings = Settings::default().with_max_iterations(10_000_000);
    for name in ["gauss-seidel", "jacobi", "southwell"] {
        let method = Method::named(name).unwrap();
        let mut x = vec![0.0; 6];
        let report = method.solver.solve(&a, &b, &mut x, &settings, &mut |_| ()).unwrap();
        assert!(
            report.residual <= settings.tolerance && report.iterations > 1000,
            "{name}: {}",
            report.iterations
        );
        let [kept, given] = [(1.0 - rho) * x.iter().sum::<f64>(), b.iter().sum()];
        assert!((kept - given).abs() <= 10.0 * settings.tolerance, "{name}: {kept} of {given}");
    }
}
