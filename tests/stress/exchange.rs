//! Exchange of rectangles against their closed forms in double-double: gaps, slivers, distances.
//!
//! ```text
//! parallel, a × b at distance c, X = a/c, Y = b/c:
//!   A F = 2c²/π { ½ ln[(1 + X²)(1 + Y²)/(1 + X² + Y²)] + X √(1 + Y²) atan(X/√(1 + Y²)) + Y √(1 + X²) atan(Y/√(1 + X²))
//!                 − X atan X − Y atan Y }
//! at right angles with a common edge l, widths w and h, W = w/l, H = h/l, S = 1 + W² + H²:
//!   A F = l²/π { W atan 1/W + H atan 1/H − √(H² + W²) atan 1/√(H² + W²)
//!                + ¼ [ln((1 + W²)(1 + H²)/S) + W² ln(W² S/((1 + W²)(W² + H²))) + H² ln(H² S/((1 + H²)(W² + H²)))] }
//! ```
//!
//! (J. R. Howell, *A Catalog of Radiation Heat Transfer Configuration Factors*, C-11 and C-14). The terms of
//! either cancel to many digits where X or W are small or large, so that f64 would not do.

use radiosity::kernel::{Accuracy, polygon_exchange};
use radiosity::visibility::Visibility;
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::{blocks_of, elements_of};

use crate::double::Double;
use crate::row::Row;
use radiosity_test_support::random::Random;

/// A F of two parallel rectangles.
fn parallel(a: f64, b: f64, c: f64) -> Double {
    let [a, b, c] = [a, b, c].map(Double::from);
    let (x, y) = (a / c, b / c);
    let (x2, y2) = (x * x, y * y);
    let root = |z: Double| (Double::ONE + z).sqrt();
    let (p, q) = (root(y2), root(x2));
    // (1 + X²)(1 + Y²)/(1 + X² + Y²) = 1 + X²Y²/(1 + X² + Y²).
    let logarithm = (x2 * y2 / (Double::ONE + x2 + y2)).ln_1p() * Double::from(0.5);
    let angles = x * p * (x / p).atan() + y * q * (y / q).atan() - x * x.atan() - y * y.atan();
    Double::from(2.0) * c * c / Double::PI * (logarithm + angles)
}

/// A F of two rectangles at right angles with the common edge l.
fn hinged(l: f64, w: f64, h: f64) -> Double {
    let [l, w, h] = [l, w, h].map(Double::from);
    let (w, h) = (w / l, h / l);
    let (w2, h2) = (w * w, h * h);
    let (sum, all) = (w2 + h2, Double::ONE + w2 + h2);
    let angle = |x: Double| x * Double::ONE.atan2(x);
    let first = (w2 * h2 / all).ln_1p();
    let second = w2 * (w2 * all / ((Double::ONE + w2) * sum)).ln();
    let third = h2 * (h2 * all / ((Double::ONE + h2) * sum)).ln();
    let logarithms = (first + second + third) * Double::from(0.25);
    l * l / Double::PI * (angle(w) + angle(h) - angle(sum.sqrt()) + logarithms)
}

fn rectangle(origin: DVec3, u: DVec3, v: DVec3) -> [DVec3; 4] {
    [origin, origin + u, origin + u + v, origin + v]
}

fn facing(a: f64, b: f64, c: f64) -> [[DVec3; 4]; 2] {
    let (u, v) = (DVec3::X * a, DVec3::Y * b);
    [rectangle(DVec3::ZERO, u, v), rectangle(DVec3::Z * c, v, u)]
}

fn corner(l: f64, w: f64, h: f64) -> [[DVec3; 4]; 2] {
    let (edge, floor, wall) = (DVec3::Y * l, DVec3::X * w, DVec3::Z * h);
    [rectangle(DVec3::ZERO, floor, edge), rectangle(DVec3::ZERO, edge, wall)]
}

/// Error of [`polygon_exchange`] in multiples of `unit`.
fn error([p, q]: &[[DVec3; 4]; 2], exact: Double, unit: f64) -> f64 {
    (Double::from(polygon_exchange(p, q)) - exact).abs().to_f64() / unit
}

fn contours(count: usize) {
    let mut random = Random(3);
    let near = Row::new("exchange of parallel squares", "gaps to 1e-8", 10.0, "ε");
    let far = Row::new("exchange of parallel squares, relative", "distances to 1e6", 40.0, "ε");
    let sliver = Row::new("exchange of parallel slivers", "1e4 : 1, gaps to 1e-4", 20.0, "ε of length²");
    let edge = Row::new("exchange at a common edge", "widths 1e-4 to 1e4", 20.0, "ε of length²");
    for _ in 0..count {
        let c = random.power(-8.0, 0.0);
        near.add(error(&facing(1.0, 1.0, c), parallel(1.0, 1.0, c), f64::EPSILON), || format!("gap {c:e}"));
        let (b, c) = (random.between(0.5, 1.0), random.power(0.7, 6.0));
        let exact = parallel(1.0, b, c);
        far.add(error(&facing(1.0, b, c), exact, exact.to_f64() * f64::EPSILON), || format!("{b} at {c:e}"));
        let (b, c) = (random.power(-4.0, 0.0), random.power(-4.0, 0.7));
        sliver
            .add(error(&facing(1.0, b, c), parallel(1.0, b, c), f64::EPSILON), || format!("{b:e} at {c:e}"));
        let (w, h) = (random.power(-4.0, 4.0), random.power(-4.0, 4.0));
        let extent = w.min(h).max(1.0);
        edge.add(error(&corner(1.0, w, h), hinged(1.0, w, h), extent * extent * f64::EPSILON), || {
            format!("{w:e}, {h:e}")
        });
    }
}

/// √(A_i A_j) G₀₀ of the blocks of two parallelograms at an order.
fn transfer([p, q]: &[[DVec3; 4]; 2], order: usize, eps: f64) -> f64 {
    let surface = |c: &[DVec3; 4]| {
        let [origin, u, v] = [c[0], c[1] - c[0], c[3] - c[0]].map(|x| x.to_array());
        format!("[[surfaces]]\nparallelogram = {{ origin = {origin:?}, edge1 = {u:?}, edge2 = {v:?} }}\n")
    };
    let text = format!("bands = [\"grey\"]\n{}{}", surface(p), surface(q));
    let scene = typed(&text);
    let elements = elements_of(&scene, order, 1);
    let visibility = Visibility::open(&scene);
    let blocks = blocks_of(&elements, &visibility, Accuracy { eps, shadow_eps: eps });
    let block =
        blocks.iter().find(|block| (block.row, block.column) == (0, 1)).expect("they face each other");
    block.values[0] * (elements.list()[0].area * elements.list()[1].area).sqrt()
}

/// Orders above 0 take other rules than contours, whose mean is the same.
fn rules(count: usize, orders: &[usize]) {
    let mut random = Random(4);
    let gaps =
        Row::new("blocks of parallel squares, mean", "gaps to 1e-8, orders to 8, eps to 1e-10", 1.0, "eps");
    let edges = Row::new(
        "blocks at a common edge, mean",
        "widths 0.01 to 100, orders to 20, eps to 1e-12",
        1.0,
        "eps",
    );
    for _ in 0..count {
        let (order, eps) = (random.pick(orders).min(8), random.pick(&[1e-4, 1e-7, 1e-10]));
        let c = random.power(-8.0, 0.0);
        let off = transfer(&facing(1.0, 1.0, c), order, eps) - parallel(1.0, 1.0, c).to_f64();
        gaps.add(off.abs() / (eps + 1e-13), || format!("gap {c:e}, order {order}, eps {eps:e}"));
        let (order, eps) = (random.pick(orders), random.pick(&[1e-4, 1e-8, 1e-12]));
        let (w, h) = (random.power(-2.0, 2.0), random.power(-2.0, 2.0));
        let exact = hinged(1.0, w, h).to_f64();
        let off = transfer(&corner(1.0, w, h), order, eps) - exact;
        // The accuracy is one of the largest entry of the block, and that is not the mean.
        edges.add(off.abs() / (eps + 1e-13) / (w * h).sqrt(), || {
            format!("{w:e}, {h:e}, order {order}, eps {eps:e}: {exact:e}")
        });
    }
}

#[test]
fn exchanges_keep_their_digits() {
    contours(200);
    rules(4, &[1, 2, 4]);
}

#[test]
#[ignore = "many cases, and orders to 20"]
fn exchanges_keep_their_digits_everywhere() {
    contours(20_000);
    rules(100, &[1, 2, 4, 8, 20]);
}
