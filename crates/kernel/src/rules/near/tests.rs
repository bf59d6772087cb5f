//! Near pairs against exact blocks, closed forms, and theorems.

use std::f64::consts::PI;

use proptest::prelude::*;
use radiosity_elements::basis::{AreaBasis, Frame};
use radiosity_elements::patch::{Direction, Node};
use radiosity_geom::{DVec2, DVec3, clip_polygon, polygon_area};

use crate::irradiance::lambert;
use crate::rules::near::*;

fn quad(origin: [f64; 3], s: [f64; 3], t: [f64; 3], normal: [f64; 3]) -> Patch {
    let [o, s, t, n] = [origin, s, t, normal].map(DVec3::from_array);
    Patch::Flat { corners: [o, o + s, o + s + t, o + t], normal: n.normalize() }
}

fn basis(patch: &Patch, order: usize) -> AreaBasis {
    let [a, b, _, d] = patch.corners();
    let frame = Frame::bounding(&patch.polygon(), [b - a, d - a]);
    AreaBasis::new(order, frame, std::slice::from_ref(patch)).expect("it has area")
}

fn floor() -> Patch {
    quad([0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.])
}

/// A unit square at height `gap` over the floor.
fn ceiling(gap: f64) -> Patch {
    quad([0., 0., gap], [1., 0., 0.], [0., 1., 0.], [0., 0., -1.])
}

/// G and the samples it took.
fn block(p: &Patch, q: &Patch, order: usize, eps: f64) -> (Vec<f64>, u64) {
    let (receiver, emitter) = (basis(p, order), basis(q, order));
    let mut moments = Moments::new(&receiver, &emitter);
    Plan::new(&moments, p, q, eps).expect("few cells").integrate(&mut moments);
    let samples = moments.samples;
    (moments.into_block(), samples)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).fold(0.0, |most, (x, y)| most.max((x - y).abs()))
}

#[test]
fn exact_blocks_are_met_at_every_accuracy() {
    let data: serde_json::Value =
        serde_json::from_str(include_str!("../../../../../tests/data/near_pairs.json"))
            .expect("the data is valid");
    let cases = data["cases"].as_array().expect("a list of cases");
    assert_eq!(cases.len(), 4);
    for case in cases {
        let vector = |side: &str, name: &str| -> [f64; 3] {
            serde_json::from_value(case[side][name].clone()).expect("three numbers")
        };
        let patch = |side: &str| {
            quad(
                vector(side, "origin"),
                vector(side, "edge_s"),
                vector(side, "edge_t"),
                vector(side, "normal"),
            )
        };
        let exact: Vec<Vec<f64>> = serde_json::from_value(case["K"].clone()).expect("a matrix");
        let (p, q) = (patch("receiver"), patch("emitter"));
        let area = |p: &Patch| p.node(0.5, 0.5).area;
        let exact: Vec<f64> = exact.concat().iter().map(|k| k * (area(&p) / area(&q)).sqrt()).collect();
        for eps in [1e-2, 1e-4, 1e-8, 1e-12] {
            let error = difference(&block(&p, &q, 4, eps).0, &exact) / largest(&exact);
            assert!(error < eps + 2e-13, "{}: {error:e} at {eps:e}", case["name"]);
        }
    }
}

/// F of two parallel unit squares (Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*,
/// C-11).
fn parallel_squares(gap: f64) -> f64 {
    let (x, root) = (1.0 / gap, (1.0 + 1.0 / (gap * gap)).sqrt());
    let log = 0.5 * ((1.0 + x * x) * (1.0 + x * x) / (1.0 + 2.0 * x * x)).ln();
    2.0 / (PI * x * x) * (log + 2.0 * x * (root * (x / root).atan() - x.atan()))
}

#[test]
fn parallel_squares_at_any_gap() {
    for gap in [0.25, 0.1, 0.03, 1e-3, 1e-6, 1e-9] {
        for (order, eps) in [(0, 1e-2), (3, 1e-5), (2, 1e-12)] {
            let error = block(&floor(), &ceiling(gap), order, eps).0[0] - parallel_squares(gap);
            assert!(error.abs() < eps + 1e-13, "gap {gap} order {order} eps {eps:e}: {error:e}");
        }
    }
}

/// A₁F₁₂ of two perpendicular rectangles with a common edge of length 1 and depths `a` and `b` (Howell,
/// C-14).
fn perpendicular(a: f64, b: f64) -> f64 {
    if a.min(b) == 0.0 {
        return 0.0;
    }
    let (a2, b2) = (a * a, b * b);
    let sum = a2 + b2;
    let logs = ((1.0 + a2) * (1.0 + b2) / (1.0 + sum)).ln()
        + a2 * (a2 * (1.0 + sum) / ((1.0 + a2) * sum)).ln()
        + b2 * (b2 * (1.0 + sum) / ((1.0 + b2) * sum)).ln();
    let angles = a * (1.0 / a).atan() + b * (1.0 / b).atan() - sum.sqrt() * (1.0 / sum.sqrt()).atan();
    (angles + 0.25 * logs) / PI
}

#[test]
fn edges_that_almost_meet() {
    for gap in [0.05, 1e-2, 1e-4, 1e-6] {
        let (p, q) = (
            quad([0., gap, 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]),
            quad([0., 0., gap], [1., 0., 0.], [0., 0., 1.], [0., 1., 0.]),
        );
        let whole = 1.0 + gap;
        let exact = perpendicular(whole, whole) - 2.0 * perpendicular(whole, gap) + perpendicular(gap, gap);
        for eps in [1e-2, 1e-6, 1e-12] {
            let error = block(&p, &q, 3, eps).0[0] / exact - 1.0;
            assert!(error.abs() < eps + 1e-13, "gap {gap} eps {eps:e}: {error:e}");
        }
    }
}

#[test]
fn cost_grows_like_a_power_of_the_logarithm() {
    let samples = |gap: f64| block(&floor(), &ceiling(gap), 4, 1e-4).1;
    let (coarse, fine) = (samples(1e-3), samples(1e-9));
    // (ln 10⁹ / ln 10³)² = 9; halving would take 10¹² times as many.
    assert!(fine < 9 * coarse, "{coarse} {fine}");
    assert!(samples(0.1) < 50_000);
}

#[test]
fn the_smaller_patch_costs_no_more_when_the_larger_grows() {
    let small = quad([0.4, 0.4, 1e-3], [0.05, 0., 0.], [0., 0.05, 0.], [0., 0., -1.]);
    let wide = quad([-50., -50., 0.], [100., 0., 0.], [0., 100., 0.], [0., 0., 1.]);
    let (near, far) = (block(&floor(), &small, 4, 1e-4), block(&wide, &small, 4, 1e-4));
    assert!(far.1 < 2 * near.1, "{} {}", near.1, far.1);
    // Nearly everything that the small plate sends arrives on the wide one.
    assert!((far.0[0] / (0.05 / 100.0) - 1.0).abs() < 1e-4);
}

/// A patch in general position: over the floor by `gap` at its nearest corner, shifted, turned and tilted.
fn leaning(gap: f64, shift: [f64; 2], turn: f64, tilt: f64, size: f64) -> Patch {
    let (s, t) = (DVec2::from_angle(turn), DVec2::from_angle(turn + 1.4));
    let o = DVec3::new(shift[0], shift[1], gap);
    let (a, b) = (s.extend(0.0) * size, (t * tilt.cos()).extend(tilt.sin()) * (0.8 * size));
    Patch::Flat { corners: [o, o + a, o + a + b, o + b], normal: -a.cross(b).normalize() }
}

/// The part of the floor in front of `patch`, if it is a triangle or a quadrilateral and no sliver.
fn seeing(patch: &Patch) -> Option<Patch> {
    let node = patch.node(0.5, 0.5);
    let part = clip_polygon(&floor().polygon(), node.position, node.normal);
    let mut patches = if part.len() > 2 { Patch::of_polygon(&part, DVec3::Z) } else { Vec::new() };
    (patches.len() == 1 && polygon_area(&part) > 0.01).then(|| patches.remove(0))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Polar rays against Lambert's closed form, above and beside the emitter.
    #[test]
    fn constant_emitter_is_lamberts(
        x in -0.5f64..1.5, y in -0.5f64..1.5, log_height in -9.0f64..0.0, tilt in -1.5f64..1.5, axis in 0.0f64..6.3,
    ) {
        let emitter = ceiling(0.0);
        let basis = basis(&emitter, 3);
        let mut polar = Polar::new(&emitter, &basis, 1e-13);
        let side = DVec2::from_angle(axis).extend(0.0);
        let position = DVec3::new(x, y, -10f64.powf(log_height));
        let normal = DVec3::Z * tilt.cos() + side * tilt.sin();
        // Lambert's sum is the signed irradiance, as ours is: neither is clipped by the horizon.
        let node = Node { position, normal, area: 1.0, parameters: DVec2::ZERO };
        let seen = emitter.corners().map(|corner| corner - position);
        let expected = lambert::polygon(normal, &seen);
        let (column, _) = polar.column(&node, 1e-13);
        // L₀ = ½.
        prop_assert!((2.0 * column[0].abs() - expected).abs() < 1e-11, "{} {}", 2.0 * column[0], expected);
    }

    #[test]
    fn parts_add_up_and_no_more_is_received_than_sent(
        log_gap in -9.0f64..-0.6, x in -0.5f64..1.0, y in -0.5f64..1.0,
        turn in 0.0f64..3.0, tilt in 0.0f64..1.5, size in 0.05f64..1.5, across in any::<bool>(),
    ) {
        let q = leaning(10f64.powf(log_gap), [x, y], turn, tilt, size);
        let Some(p) = seeing(&q) else { return Ok(()) };
        let (receiver, emitter) = (basis(&p, 2), basis(&q, 3));
        let direction = if across { Direction::Across } else { Direction::Along };
        let mut whole = Moments::new(&receiver, &emitter);
        Plan::new(&whole, &p, &q, 1e-7).expect("few cells").integrate(&mut whole);
        let mut parts = Moments::new(&receiver, &emitter);
        for half in q.halves(direction) {
            Plan::new(&parts, &p, &half, 1e-7).expect("few cells").integrate(&mut parts);
        }
        let (whole, parts) = (whole.into_block(), parts.into_block());
        prop_assert!(difference(&whole, &parts) < 1e-6 * largest(&whole) + 1e-9);
        let ratio = (polygon_area(&p.polygon()) / polygon_area(&q.polygon())).sqrt();
        prop_assert!(whole[0] > 0.0 && whole[0] < ratio.min(1.0 / ratio) * (1.0 + 1e-7), "{}", whole[0]);
    }

    #[test]
    fn outer_and_inner_can_be_exchanged(
        log_gap in -9.0f64..-0.6, x in -0.5f64..1.0, y in -0.5f64..1.0,
        turn in 0.0f64..3.0, tilt in 0.0f64..1.5, size in 0.2f64..1.5,
    ) {
        let q = leaning(10f64.powf(log_gap), [x, y], turn, tilt, size);
        let Some(p) = seeing(&q) else { return Ok(()) };
        let (receiver, emitter) = (basis(&p, 3), basis(&q, 2));
        let [one, other] = [Side::Receiver, Side::Emitter].map(|side| {
            let mut moments = Moments::new(&receiver, &emitter);
            Plan::outside(side, &moments, &p, &q, 1e-7, f64::INFINITY).integrate(&mut moments);
            moments.into_block()
        });
        prop_assert!(difference(&one, &other) < 1e-6 * largest(&one) + 1e-9);
    }
}
