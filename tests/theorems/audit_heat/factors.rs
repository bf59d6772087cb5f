//! View factors that are wrong, by seeded faults.

use radiosity::Work;
use radiosity::audit::Effort;
use radiosity::kernel::Accuracy;
use radiosity::reading::checked_factors::CheckedFactors;
use radiosity::solve::view_factors::{Options, ViewFactors};
use radiosity_test_support::scenes::typed;

/// A can of radius 1 with its lid at this height.
fn can(height: f64) -> radiosity::Scene {
    let surface = |name: &str, shape: String| format!("[[surfaces]]\nname = \"{name}\"\n{shape}\n");
    let side = format!("flip = true\ncylinder = {{ base = [0, 0, 0], axis = [0, 0, {height}], radius = 1 }}");
    let bottom = "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }".to_owned();
    let lid = format!("disk = {{ center = [0, 0, {height}], normal = [0, 0, -1], radius = 1 }}");
    typed(&[surface("side", side), surface("bottom", bottom), surface("lid", lid)].concat())
}

/// The factors of a can of height `built`.
fn factors(built: f64) -> ViewFactors {
    let accuracy = Accuracy { eps: 1e-6, shadow_eps: 1e-6 };
    let options = Options { accuracy, threads: 2, ..Options::default() };
    ViewFactors::new(&can(built), &options, &Work::alone()).expect("all have area")
}

/// Factors, judged as those of a can of height 2.
fn judged(factors: &ViewFactors, effort: &Effort) -> CheckedFactors {
    CheckedFactors::judged(&can(2.0), factors, &[0, 1, 2], &|_, _| true, effort, &Work::alone())
}

/// Factors of a can that is a twentieth too high: those between its ends are a twelfth too small.
#[test]
fn factors_of_another_can_are_found_and_their_errors_grow_to_what_is_true() {
    let exact = |height: f64| {
        let x = 2.0 + height * height;
        0.5 * (x - (x * x - 4.0).sqrt())
    };
    let effort = Effort::of_walks(65536.0);
    let factors = factors(2.1);
    let told = judged(&factors, &effort);
    let checked = told.checked.expect("rays looked");
    let error = exact(2.0) - exact(2.1);
    assert!((exact(2.1) - factors.factor(1, 2)).abs() < 1e-6 && error > 0.01);
    assert!(checked.finding().is_some_and(|found| found.contains("view factors together")), "{checked:?}");
    for row in [1, 2] {
        let told = told.errors[row];
        assert!(told > 0.7 * error && told < 2.0 * error, "{row}: {told} told, {error} true");
    }
}

/// By chance, rays of one look in forty find more than the method tells: of a hundred right runs none may tell errors
/// that a second look denies.
#[test]
fn right_factors_keep_their_own_errors_whatever_is_drawn() {
    let right = factors(2.0);
    for seed in 0..100 {
        let told = judged(&right, &Effort::of_walks(8192.0).seeded(seed));
        let checked = told.checked.expect("rays looked");
        assert!(checked.finding().is_none() && checked.error_factor == 1.0, "{seed}: {checked:?}");
    }
}
