//! The variational functional, Neumann's series, and what a preconditioner may change.

use proptest::prelude::*;
use radiosity_solvers::method::Method;
use radiosity_solvers::{Operator, Partition, Preconditioner, Settings, functional};

use crate::exact::norm;
use radiosity_test_support::random::Random;
use radiosity_test_support::systems::{enclosure, partition, positive_definite};

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn conjugate_gradients_lower_the_functional_in_every_step(
        seed: u64, dim in 2..40usize, largest in 1..7usize, floor in -4.0..0f64, plain: bool,
    ) {
        let random = &mut Random(seed);
        let partition = partition(random, dim, largest);
        let a = positive_definite(random, partition, 10f64.powf(floor));
        let b = random.numbers(dim);
        let preconditioner = if plain { Preconditioner::None } else { Preconditioner::Block };
        let settings = Settings::default().with_tolerance(1e-12).with_preconditioner(preconditioner);
        let (mut x, mut energies) = (vec![0.0; dim], Vec::new());
        let solver = Method::named("cg").unwrap().solver;
        solver.solve(&a, &b, &mut x, &settings, &mut |step| energies.push(functional(&a, &b, step.x))).unwrap();
        let least = -0.5 * dot(&b, &x);
        // Down to rounding of the functional itself.
        let rounding = 1e-13 * least.abs();
        prop_assert!(energies[0] == 0.0);
        prop_assert!(energies.windows(2).all(|pair| pair[1] <= pair[0] + rounding), "{energies:?}");
        prop_assert!(energies[1] < energies[0]);
        prop_assert!((energies[energies.len() - 1] - least).abs() <= 1e-12 * least.abs());
    }

    #[test]
    fn its_distance_from_the_least_is_half_the_square_of_the_error_of_energy(
        seed: u64, dim in 1..30usize, floor in -2.0..0f64,
    ) {
        let random = &mut Random(seed);
        let a = positive_definite(random, Partition::points(dim), 10f64.powf(floor));
        let (truth, other) = (random.numbers(dim), random.numbers(dim));
        let mut b = vec![0.0; dim];
        a.apply(&truth, &mut b);
        let error: Vec<f64> = other.iter().zip(&truth).map(|(x, truth)| x - truth).collect();
        let zero = vec![0.0; dim];
        let energy = functional(&a, &zero, &error);
        let distance = functional(&a, &b, &other) - functional(&a, &b, &truth);
        let scale = dot(&b, &truth).abs() + dot(&b, &other).abs() + energy;
        prop_assert!((distance - energy).abs() <= 1e-13 * scale, "{distance} {energy}");
    }

    #[test]
    fn richardson_adds_the_terms_of_neumanns_series(seed: u64, dim in 2..20usize, terms in 1..8usize) {
        let random = &mut Random(seed);
        let partition = partition(random, dim, 4);
        let a = enclosure(random, partition, [0.3, 0.9], false);
        let b: Vec<f64> = (0..dim).map(|_| random.unit()).collect();
        // b + K b + … with K = I − A, by powers.
        let (mut term, mut sum) = (b.clone(), b.clone());
        for _ in 1..terms {
            let mut image = vec![0.0; dim];
            a.apply(&term, &mut image);
            term.iter_mut().zip(&image).for_each(|(t, i)| *t -= i);
            sum.iter_mut().zip(&term).for_each(|(s, t)| *s += t);
        }
        let settings = Settings::default().with_max_iterations(terms).with_tolerance(0.0);
        let mut x = vec![0.0; dim];
        let solver = Method::named("richardson").unwrap().solver;
        let _ = solver.solve(&a, &b, &mut x, &settings, &mut |_| ());
        let error: Vec<f64> = x.iter().zip(&sum).map(|(x, s)| x - s).collect();
        prop_assert!(norm(&error) <= 1e-14 * norm(&sum), "{error:?}");
    }

    #[test]
    fn no_preconditioner_reads_no_diagonal_block_and_finds_the_same(seed: u64, dim in 2..30usize, symmetric: bool) {
        struct Undisclosed(radiosity_solvers::Dense);
        impl Operator for Undisclosed {
            fn partition(&self) -> &Partition {
                self.0.partition()
            }
            fn gather(&self, row: usize, x: &[f64], y: &mut [f64]) {
                self.0.gather(row, x, y);
            }
            fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
                self.0.shoot(column, x, y);
            }
            fn diagonal(&self, _block: usize, _out: &mut [f64]) {
                panic!("a diagonal block was read");
            }
            fn symmetric(&self) -> bool {
                self.0.symmetric()
            }
        }
        let random = &mut Random(seed);
        let partition = partition(random, dim, 5);
        let a = Undisclosed(enclosure(random, partition, [0.2, 0.9], symmetric));
        let truth = random.numbers(dim);
        let mut b = vec![0.0; dim];
        a.apply(&truth, &mut b);
        let settings = Settings::default().with_preconditioner(Preconditioner::None).with_tolerance(1e-13);
        for name in if symmetric { &["cg", "gmres"][..] } else { &["gmres"][..] } {
            let mut x = vec![0.0; dim];
            Method::named(name).unwrap().solver.solve(&a, &b, &mut x, &settings, &mut |_| ()).unwrap();
            let error: Vec<f64> = x.iter().zip(&truth).map(|(x, t)| x - t).collect();
            prop_assert!(norm(&error) <= 1e-11 * norm(&truth), "{name}");
        }
    }
}
