//! The rules of 1993 against the paper's numbers, an independent reproduction of them, and theorems.
//!
//! The tables are metric (30) in percent of an independent implementation (Python, SciPy's Gauss rules and
//! polynomials), each number to the digits given. It is the mean of |B_Galerkin − B_exact| / B_exact over the
//! centres of 500 × 500 cells of a unit square of reflectance 1 that receives from another of exitance 1. The
//! paper quotes .04 (parallel, distance 1, N = 4), 16.9 (distance .1, N = 7), 33.2 (perpendicular, Legendre,
//! N = 7), 1.4 (Jacobi, N = 4 and 5).

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::Work;
use radiosity::elements::{Discretization, Elements};
use radiosity::kernel::{Accuracy, Blocks};
use radiosity::published::zatz1993::transfers::{HybridReading, PaperRules, assemble};
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity::transport::Demand;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_core::gauss;
use radiosity_geom::shapes::{Cylinder, Parallelogram, Sphere};
use radiosity_geom::{DVec3, Flipped, Surface};
use radiosity_test_support::scenes::{builtin, typed};
use radiosity_test_support::solved::{blocks_of, outcome_of};

const CELLS: usize = 500;
const RECEIVER: [[f64; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
/// Over the receiver's edge y = 0, facing +y.
const WALL: [[f64; 3]; 4] = [[0., 0., 0.], [0., 0., 1.], [1., 0., 1.], [1., 0., 0.]];
const H1: PaperRules = PaperRules::Hybrid(HybridReading::H1);
const H2: PaperRules = PaperRules::Hybrid(HybridReading::H2);
const H3: PaperRules = PaperRules::Hybrid(HybridReading::H3);
const LITERAL: PaperRules = PaperRules::Hybrid(HybridReading::Literal);

fn ceiling(d: f64) -> [[f64; 3]; 4] {
    [[0., 0., d], [0., 1., d], [1., 1., d], [1., 0., d]]
}

fn centre(k: usize) -> f64 {
    (k as f64 + 0.5) / CELLS as f64
}

/// A function at the centres of the cells of the receiver, x by x.
fn at_centres(f: impl Fn(f64, f64) -> f64) -> Vec<f64> {
    (0..CELLS * CELLS).map(|k| f(centre(k / CELLS), centre(k % CELLS))).collect()
}

/// Irradiance from a parallel unit square of exitance 1 at distance d: configuration factor of a rectangle
/// with one corner above the point, four times.
fn under_ceiling(d: f64) -> Vec<f64> {
    let half = |a: f64, b: f64| a / a.hypot(d) * (b / a.hypot(d)).atan();
    let corner = |a: f64, b: f64| (half(a, b) + half(b, a)) / TAU;
    at_centres(|x, y| [x, 1.0 - x].iter().flat_map(|a| [y, 1.0 - y].map(|b| corner(*a, b))).sum())
}

/// Irradiance from a perpendicular unit square of exitance 1 over the edge y = 0: a rectangle with one corner
/// beside the point, twice.
fn beside_wall() -> Vec<f64> {
    let corner = |a: f64, y: f64| ((a / y).atan() - y / y.hypot(1.0) * (a / y.hypot(1.0)).atan()) / TAU;
    at_centres(|x, y| corner(x, y) + corner(1.0 - x, y))
}

fn metric(galerkin: &[f64], exact: &[f64]) -> f64 {
    let sum: f64 = galerkin.iter().zip(exact).map(|(b, e)| (b - e).abs() / e).sum();
    100.0 * sum / exact.len() as f64
}

/// The irradiance of the receiver, in z = 0, from an emitter of exitance 1, at points of it.
fn received(
    [receiver, emitter]: [[[f64; 3]; 4]; 2],
    order: usize,
    extra: usize,
    rules: PaperRules,
) -> impl Fn(f64, f64) -> f64 {
    let (elements, visibility) = two(receiver, emitter, order);
    let blocks = as_1993(&elements, &visibility, rules, extra);
    let [receiver, source] = elements.list() else { panic!("one element a square") };
    let emitted = [vec![0.0; receiver.basis.len()], source.constant.clone()].concat();
    let raw = receiver.basis.to_raw(&blocks.apply(&emitted)[..receiver.basis.len()]);
    let receiver = receiver.clone();
    move |x, y| receiver.evaluate(&raw, DVec3::new(x, y, 0.0), [0.0; 2])
}

fn by_paper(emitter: [[f64; 3]; 4], exact: &[f64], order: usize, extra: usize, rules: PaperRules) -> f64 {
    metric(&at_centres(received([RECEIVER, emitter], order, extra, rules)), exact)
}

/// Asserts that `value` rounds to the decimal `shown`.
#[track_caller]
fn assert_shown(value: f64, shown: &str, what: &str) {
    let digits = shown.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let (number, half) = (shown.parse::<f64>().unwrap(), 0.5 * 0.1f64.powi(digits as i32));
    assert!((value - number).abs() <= 1.001 * half, "{what}: {value}, not {shown}");
}

/// A row of the table: the metric for N = 0, 1, … with N + `extra` points.
fn row(emitter: [[f64; 3]; 4], exact: &[f64], extra: usize, rules: PaperRules, shown: &str) {
    for (order, shown) in shown.split(' ').enumerate() {
        let value = by_paper(emitter, exact, order, extra, rules);
        assert_shown(value, shown, &format!("{rules:?}, N + {extra} points, N = {order}"));
    }
}

#[test]
fn parallel_squares_give_the_published_errors() {
    let exact = under_ceiling(1.0);
    let shown = "61.5 9.83 .803 .756 .0385 .0388 .0013 .0013 .0001 .0001";
    row(ceiling(1.0), &exact, 1, PaperRules::Legendre, shown);
    assert_shown(by_paper(ceiling(1.0), &exact, 4, 2, PaperRules::Legendre), ".04", "the paper's own number");
    let exact = under_ceiling(0.3);
    row(ceiling(0.3), &exact, 1, PaperRules::Legendre, "546 78.4 16.5 6.57 1.61 .613 .195 .113 .0231 .0152");
    row(
        ceiling(0.3),
        &exact,
        2,
        PaperRules::Legendre,
        "78.4 26.9 6.57 3.37 .613 .458 .113 .0930 .0152 .0139",
    );
    let exact = under_ceiling(0.1);
    row(ceiling(0.1), &exact, 1, PaperRules::Legendre, "3919 907 371 194 108 65.3 40.7 26.1 16.9 11.0");
    row(ceiling(0.1), &exact, 2, PaperRules::Legendre, "907 404 194 111 65.3 41.1 26.1 16.93 11.0 7.25");
    assert_shown(
        by_paper(ceiling(0.1), &exact, 7, 2, PaperRules::Legendre),
        "16.9",
        "the paper's own number",
    );
}

#[test]
fn perpendicular_squares_give_the_published_errors() {
    let exact = beside_wall();
    row(WALL, &exact, 1, PaperRules::Legendre, "128 68.9 55.8 44.9 38.6 33.6 30.2 27.0 24.4 22.2");
    row(WALL, &exact, 2, PaperRules::Legendre, "119 79.9 66.1 55.4 48.2 42.6 38.0 34.1 30.8 27.9");
    row(WALL, &exact, 2, H1, "43.0 16.5 6.89 2.42 1.415 1.430 1.56 1.79 1.93 1.94");
    row(WALL, &exact, 2, H2, "42.9 16.6 7.73 3.06 1.547 1.413 1.295 1.27 1.38 1.49");
    row(WALL, &exact, 2, H3, "42.6 15.4 6.60 2.42 1.92 1.99 2.06 2.14 2.21 2.27");
    for (order, shown) in [(4, "1.373"), (5, "1.371")] {
        assert_shown(by_paper(WALL, &exact, order, H2.extra_points(), H2), shown, "H2, N + 3 points");
        assert_shown(by_paper(WALL, &exact, order, H1.extra_points(), H1), "1.4", "the paper's own number");
    }
}

/// Irradiance from the wall at brightness (1 + v)² = 4 z²: over x in closed form, over z by composite Gauss.
fn beside_tilted_wall() -> Vec<f64> {
    let (mut nodes, mut weights) = ([0.0; 8], [0.0; 8]);
    gauss::legendre(&mut nodes, &mut weights).unwrap();
    // ∫₀ᵃ dx / (c² + x²)²
    let over_x = |a: f64, c: f64| (a / (c * c + a * a) + (a / c).atan() / c) / (2.0 * c * c);
    let strip = |x: f64, y: f64, z: f64| {
        let c = y.hypot(z);
        4.0 * z.powi(3) * y / PI * (over_x(x, c) + over_x(1.0 - x, c))
    };
    at_centres(|x, y| {
        let mut sum = 0.0;
        let mut low = 0.0;
        while low < 1.0 {
            let high = (2.0 * f64::max(low, y)).min(1.0);
            let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
            let points = nodes.iter().zip(&weights);
            sum += half * points.map(|(n, w)| w * strip(x, y, middle + half * n)).sum::<f64>();
            low = high;
        }
        sum
    })
}

#[test]
fn as_printed_equation_27_lights_with_another_wall() {
    let exact = beside_wall();
    let limit = metric(&beside_tilted_wall(), &exact);
    assert_shown(limit, "38.7", "limit of eq. 27 as printed");
    let errors = [4, 7, 10, 14].map(|order| (by_paper(WALL, &exact, order, 2, LITERAL) - limit).abs());
    assert!(errors.is_sorted_by(|a, b| a > b) && errors[3] < 1e-2, "{errors:?}");
}

/// Reflectance ½ and exitance 1 everywhere, one element a surface.
fn scene(quads: &[[[f64; 3]; 4]]) -> Scene {
    let surface = |corners| {
        format!(
            "[[surfaces]]\nmaterial = \"white\"\nsubdivide = [1, 1]\nquad = {{ vertices = {corners:?} }}\n"
        )
    };
    let surfaces: String = quads.iter().map(surface).collect();
    let text = format!("[materials.white]\nreflectance = 0.5\nemission = 1\n{surfaces}");
    typed(&text)
}

fn elements(scene: &Scene, order: usize) -> Elements {
    let how = Discretization::uniform(order, 1);
    Elements::new(scene, &how).expect("all surfaces have area")
}

/// Two squares without shadows.
fn two(first: [[f64; 3]; 4], second: [[f64; 3]; 4], order: usize) -> (Elements, Visibility) {
    let scene = scene(&[first, second]);
    (elements(&scene, order), Visibility::open(&scene))
}

fn ours(elements: &Elements, visibility: &Visibility, eps: f64) -> Blocks {
    blocks_of(elements, visibility, Accuracy { eps, shadow_eps: 1e-3 })
}

fn as_1993(elements: &Elements, visibility: &Visibility, rules: PaperRules, extra: usize) -> Blocks {
    let accuracy = Options::default().accuracy();
    assemble(Demand::all(elements, visibility, accuracy), rules, extra, &Work::alone())
}

/// Our rules reach the error of the basis itself: the same independent implementation with exact integrals.
#[test]
fn our_rules_leave_only_the_error_of_the_basis() {
    let floors = [
        (ceiling(1.0), under_ceiling(1.0), [".755", ".0389", ".0389", ".0013", ".0001"]),
        (ceiling(0.3), under_ceiling(0.3), ["2.76", ".451", ".451", ".0896", ".0137"]),
        (ceiling(0.1), under_ceiling(0.1), ["7.04", "1.93", "1.93", ".372", ".2315"]),
        (WALL, beside_wall(), ["8.90", "2.85", "2.38", ".960", ".662"]),
    ];
    for (emitter, exact, shown) in floors {
        for (order, shown) in [2, 4, 5, 7, 9].into_iter().zip(shown) {
            let (elements, visibility) = two(RECEIVER, emitter, order);
            let blocks = ours(&elements, &visibility, 1e-9);
            let [receiver, source] = elements.list() else { panic!("one element a square") };
            let emitted = [vec![0.0; receiver.basis.len()], source.constant.clone()].concat();
            let raw = receiver.basis.to_raw(&blocks.apply(&emitted)[..receiver.basis.len()]);
            let galerkin = at_centres(|x, y| {
                receiver.evaluate(&raw, DVec3::new(x, y, 0.0), [2.0 * x - 1.0, 2.0 * y - 1.0])
            });
            assert_shown(metric(&galerkin, &exact), shown, &format!("{emitter:?}, N = {order}"));
        }
    }
}

/// Whatever corner of receiver and emitter is the first, the same light arrives at the same place.
#[test]
fn the_common_edge_may_lie_on_any_side() {
    let turned = |mut corners: [[f64; 3]; 4], by: usize| {
        corners.rotate_left(by);
        corners
    };
    let places = [(0.5, 0.01), (0.2, 0.3), (0.9, 0.95)];
    for rules in [PaperRules::Legendre, H1, H2, H3, LITERAL] {
        let plain = received([RECEIVER, WALL], 4, 2, rules);
        for (k, l) in (0..4).flat_map(|k| (0..4).map(move |l| (k, l))) {
            let other = received([turned(RECEIVER, k), turned(WALL, l)], 4, 2, rules);
            for (x, y) in places {
                let (a, b) = (plain(x, y), other(x, y));
                assert!((a - b).abs() < 1e-12, "{rules:?}: {a} {b}");
            }
        }
    }
}

/// Without an edge in common the hybrid is Legendre's rule.
#[test]
fn hybrid_is_for_common_edges_only() {
    let apart = WALL.map(|[x, y, z]| [x, y - 0.1, z]);
    for emitter in [ceiling(0.5), apart] {
        let [plain, hybrid] =
            [PaperRules::Legendre, H1].map(|rules| received([RECEIVER, emitter], 3, 2, rules)(0.3, 0.6));
        assert_eq!(plain, hybrid);
    }
}

/// F = .199824895698387 for unit squares at distance 1 (closed form, Howell's catalog C-11).
#[test]
fn first_coefficient_is_the_form_factor() {
    let (elements, visibility) = two(RECEIVER, ceiling(1.0), 0);
    let blocks = as_1993(&elements, &visibility, PaperRules::Legendre, 20);
    let factor = blocks.apply(&[0.0, 1.0])[0];
    let root = 2f64.sqrt();
    let closed =
        2.0 / PI * ((4.0f64 / 3.0).sqrt().ln() + 2.0 * root * (1.0 / root).atan() - 2.0 * 1f64.atan());
    assert!((factor - closed).abs() < 1e-14, "{factor} {closed}");
    // Two ordered pairs.
    assert_eq!(blocks.statistics.samples, 2 * 160_000);
}

/// Largest difference of what the first element receives from each function of the second, relative to the
/// largest.
fn difference(a: &Blocks, b: &Blocks) -> f64 {
    let [_, first, both] = a.starts() else { panic!("there are two elements") };
    let (mut largest, mut scale) = (0.0f64, 0.0f64);
    for k in *first..*both {
        let mut unit = vec![0.0; *both];
        unit[k] = 1.0;
        for (x, y) in a.apply(&unit).iter().zip(b.apply(&unit)).take(*first) {
            largest = largest.max((x - y).abs());
            scale = scale.max(x.abs());
        }
    }
    largest / scale
}

/// Where the kernel is smooth, many points of 1993 give a flat receiver what our rules give it, from curved
/// emitters too. (Receivers whose area element varies project on their polynomials otherwise: in the
/// parameters, not in area.)
#[test]
fn with_many_points_flat_receivers_get_what_we_give_them() {
    let skew =
        Parallelogram::new(DVec3::new(0.3, 0.1, 1.2), DVec3::new(0.0, 1.5, 0.2), DVec3::new(0.8, 0.3, 0.0));
    let pipe = Cylinder::new(2.0 * DVec3::Z, DVec3::X, 0.5, [4.4, 5.0]);
    let cap = Sphere::new(DVec3::new(0.4, 0.5, 1.8), 0.8, DVec3::NEG_Z, [0.7, 0.8], [0.0, 2.0]);
    let shapes: [Arc<dyn Surface>; 3] = [
        Arc::new(skew.expect("it has area")),
        Arc::new(pipe.expect("it has area")),
        Arc::new(cap.expect("it has area")),
    ];
    for shape in shapes {
        let mut scene = scene(&[RECEIVER, ceiling(1.0)]);
        scene.surfaces[1].shape = shape;
        let (elements, visibility) = (elements(&scene, 3), Visibility::open(&scene));
        let exact = ours(&elements, &visibility, 1e-10);
        let theirs = as_1993(&elements, &visibility, PaperRules::Legendre, 20);
        let error = difference(&exact, &theirs);
        assert!(error < 1e-8, "{:?}: {error:e}", scene.surfaces[1].shape);
    }
}

/// Inside a sphere κ is constant, and G maps the constant to itself.
#[test]
fn a_sphere_is_closed_by_the_rules_of_1993() {
    let mut scene = scene(&[RECEIVER, ceiling(1.0)]);
    for (surface, z) in scene.surfaces.iter_mut().zip([[-2.0, 0.5], [0.5, 2.0]]) {
        let part = Sphere::new(DVec3::new(1.0, 2.0, 3.0), 2.0, DVec3::Z, z, [0.0, TAU]).expect("it has area");
        surface.shape = Arc::new(Flipped::new(Box::new(part)));
    }
    let (elements, visibility) = (elements(&scene, 2), Visibility::open(&scene));
    let blocks = as_1993(&elements, &visibility, PaperRules::Legendre, 10);
    let ones: Vec<f64> = elements.list().iter().flat_map(|element| element.constant.clone()).collect();
    for (c, gc) in ones.iter().zip(blocks.apply(&ones)) {
        assert!((c - gc).abs() < 1e-8 * ones[0], "{c} {gc}");
    }
}

#[test]
fn only_the_hybrid_is_not_reciprocal_on_squares() {
    let (elements, visibility) = two(RECEIVER, WALL, 4);
    let transposed_error = |rules| {
        let blocks = as_1993(&elements, &visibility, rules, 2);
        assert!(!blocks.symmetric());
        let (mut largest, dim) = (0.0f64, blocks.dim());
        for k in 0..dim {
            let mut unit = vec![0.0; dim];
            unit[k] = 1.0;
            let (column, row) = (blocks.apply(&unit), blocks.apply_transposed(&unit));
            largest = column.iter().zip(&row).map(|(x, y)| (x - y).abs()).fold(largest, f64::max);
        }
        largest
    };
    assert!(transposed_error(PaperRules::Legendre) < 1e-15);
    assert!(transposed_error(H1) > 1e-3 && transposed_error(H2) > 1e-3);
}

/// Power that is emitted is absorbed or lost, however coarse the rules: an identity that needs Gᵀ where G is
/// not symmetric.
#[test]
fn power_balances_without_symmetry() {
    let scene = builtin("empty-box");
    for rules in [PaperRules::Legendre, H1, H2] {
        let options = Options { order: 4, kernel: Some(rules), threads: 2, ..Options::default() };
        let outcome = outcome_of(&scene, &options);
        assert_eq!(outcome.solver, "lu");
        let checks = outcome.checks;
        let imbalance = checks.energy_in - checks.energy_absorbed - checks.energy_lost;
        assert!(imbalance.abs() < 1e-12, "{rules:?}: {imbalance:e}");
        // 30 ordered pairs with (4 + 2)⁴ or (4 + 3)⁴ points each.
        let points = (4 + rules.extra_points() as u64).pow(4);
        assert_eq!((outcome.samples, outcome.pairs.total), (30 * points, 15));
    }
}

/// A panel over half of the middle plane hides exactly half: what it lets pass from x to y it hides from the
/// mirror image of x to that of y. With an odd number of points on one side only, no segment meets the
/// panel's edge.
#[test]
fn a_panel_over_half_hides_half() {
    let panel = [[0.0, -1.0, 0.5], [0.5, -1.0, 0.5], [0.5, 2.0, 0.5], [0.0, 2.0, 0.5]];
    let mut scene = scene(&[RECEIVER, ceiling(1.0), panel]);
    scene.surfaces[1].order = Some(1);
    let elements = elements(&scene, 0);
    let received = |shadows| {
        let visibility = Visibility::new(&scene, shadows, 1e-3);
        let blocks = as_1993(&elements, &visibility, PaperRules::Legendre, 8);
        let mut emitted = vec![0.0; blocks.dim()];
        emitted[1] = 1.0;
        blocks.apply(&emitted)[0]
    };
    let (free, shadowed) = (received(Shadows::Off), received(Shadows::Rays));
    assert!((shadowed - 0.5 * free).abs() < 1e-14, "{shadowed} of {free}");
}
