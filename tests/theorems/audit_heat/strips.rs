//! Two strips of any places across and of finite length, by Hottel's crossed strings and a double integral.
//!
//! Parallel lines at the distance r on both of which points z, z′ run from 0 to L see each other by
//! ∫∫ dz dz′ / (r² + (z − z′)²)² = L atan(L/r) / r³, so that strips of the widths a and b have
//!
//! ```text
//! F = 1/(π a) ∫ ∫ p₁ p₂ atan(L/r) / r³ dx₁ dx₂ ,     p = n · d ,   d from one to the other across
//! ```
//!
//! which for L → ∞ is what crossed strings tell, (crossed − uncrossed) / 2 a.

use std::f64::consts::PI;

use radiosity::Work;
use radiosity::audit::{Effort, ViewFactorReferee};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;

use super::scored::{SEEN, Scored, apart};

/// Midpoints along each strip. Chosen: the sums then agree with the strings to 10⁻⁶.
const POINTS: usize = 400;

/// A strip across: its ends, at the right of which its front lies when one goes from the first to the second.
type Ends = [[f64; 2]; 2];

fn less(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// (crossed − uncrossed) / 2 a.
fn strings([a, b]: [Ends; 2]) -> f64 {
    let between = |p, q| length(less(p, q));
    let crossed = between(a[0], b[0]) + between(a[1], b[1]);
    let uncrossed = between(a[0], b[1]) + between(a[1], b[0]);
    (crossed - uncrossed) / (2.0 * between(a[0], a[1]))
}

/// The double integral, with `atan(L/r)` as given.
fn integral([a, b]: [Ends; 2], angle: impl Fn(f64) -> f64) -> f64 {
    let [along_a, along_b] = [a, b].map(|own| less(own[1], own[0]));
    // Normals times widths, to the right of what goes along.
    let [normal_a, normal_b] = [along_a, along_b].map(|[x, y]| [y, -x]);
    let at = |ends: Ends, along: [f64; 2], k: usize| {
        let part = (k as f64 + 0.5) / POINTS as f64;
        [ends[0][0] + part * along[0], ends[0][1] + part * along[1]]
    };
    let dot = |p: [f64; 2], q: [f64; 2]| p[0] * q[0] + p[1] * q[1];
    let mut sum = 0.0;
    for i in 0..POINTS {
        for k in 0..POINTS {
            let step = less(at(b, along_b, k), at(a, along_a, i));
            let r = length(step);
            sum -= dot(normal_a, step) * dot(normal_b, step) * angle(r) / (r * r * r);
        }
    }
    sum / (POINTS * POINTS) as f64 / (PI * length(along_a))
}

/// The scene of two strips from y = 0 to y = `long`.
fn scene([a, b]: [Ends; 2], long: f64) -> String {
    let strip = |name: &str, [[x0, z0], [x1, z1]]: Ends| {
        format!(
            r#"
            [[surfaces]]
            name = "{name}"
            quad = {{ vertices = [[{x1},0,{z1}],[{x0},0,{z0}],[{x0},{long},{z0}],[{x1},{long},{z1}]] }}
            "#
        )
    };
    format!("{}{}", strip("a", a), strip("b", b))
}

/// Two strips that see each other whole: one below, to the right from its left end, and one above.
fn strips(random: &mut Random) -> [Ends; 2] {
    let low = [[random.between(-1.5, -0.5), 0.0], [random.between(0.5, 1.5), 0.0]];
    let mut end = |side: f64| [side * random.between(0.3, 2.0), random.between(0.5, 1.5)];
    // Fronts lie to the right: below goes from right to left, above from left to right.
    [[low[1], low[0]], [end(-1.0), end(1.0)]]
}

#[test]
fn rays_find_strips_of_any_length() {
    let mut random = Random(77);
    let mut scored = Scored::default();
    for seed in 0..60 {
        let ends = strips(&mut random);
        let (sum, exact) = (integral(ends, |_| 0.5 * PI), strings(ends));
        assert!((sum / exact - 1.0).abs() < 1e-5, "{sum} for {exact}");
        let long = random.power(-0.5, 1.5);
        let exact = integral(ends, |r| (long / r).atan());
        let referee = ViewFactorReferee::of(&typed(&scene(ends, long)));
        let rows = referee.rows(&[0, 1], &Effort::of_walks(1024.0).seeded(seed), &Work::alone());
        let [a, b] = ends.map(|own| length(less(own[1], own[0])));
        scored.add("a", &rows[0].to(1), exact);
        scored.add("b", &rows[1].to(0), exact * a / b);
        let lost = rows[0].lost.value + rows[0].to(1).value;
        assert!((lost - 1.0).abs() < 1e-12, "{lost}");
        assert!(rows[0].rays == 1024);
    }
    scored.check(120);
}

#[test]
fn a_row_that_is_off_by_a_hundredth_is_seen() {
    let ends = [[[1.0, 0.0], [-1.0, 0.0]], [[-1.0, 1.0], [1.0, 1.0]]];
    let exact = integral(ends, |r| (2.0 / r).atan());
    let referee = ViewFactorReferee::of(&typed(&scene(ends, 2.0)));
    let found = referee.rows(&[0], &Effort::of_walks(524_288.0), &Work::alone())[0].to(1);
    assert!(apart(&found, exact) < SEEN, "{found:?} for {exact}");
    assert!(apart(&found, 1.01 * exact) > SEEN, "{found:?} for {exact}");
}
