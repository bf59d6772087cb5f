#![expect(clippy::print_stdout, reason = "errors and cells are shown with --nocapture")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use proptest::prelude::*;
use radiosity_geom::shapes::{Cone, Cylinder, Disk, FULL_TURN};
use radiosity_geom::{DVec3, Flipped, Jet, Surface};

use super::*;

fn cylinder(radius: f64, heights: [f64; 2]) -> Box<dyn Surface> {
    cone(radius, radius, heights)
}

fn cone(low: f64, high: f64, [bottom, top]: [f64; 2]) -> Box<dyn Surface> {
    let (base, axis) = (bottom * DVec3::Z, (top - bottom) * DVec3::Z);
    if low == high {
        return Box::new(Cylinder::new(base, axis, low, FULL_TURN).unwrap());
    }
    Box::new(Cone::new(base, axis, low, high, FULL_TURN).unwrap())
}

fn ring([inner, outer]: [f64; 2], height: f64, up: f64) -> Box<dyn Surface> {
    Box::new(Disk::new(height * DVec3::Z, up * DVec3::Z, outer, inner, FULL_TURN).unwrap())
}

fn hollow(shape: Box<dyn Surface>) -> Box<dyn Surface> {
    Box::new(Flipped::new(shape))
}

fn pair(surfaces: [&dyn Surface; 2], core: f64) -> Coaxial {
    let [first, second] = surfaces.map(|surface| surface.meridian().expect("it goes round"));
    let is_same = std::ptr::addr_eq(surfaces[0], surfaces[1]);
    Coaxial { pair: [first, second.beside(&first).expect("they are coaxial")], is_same, core }
}

/// F from the first to the second.
fn factor(surfaces: [&dyn Surface; 2], core: f64, eps: f64) -> f64 {
    pair(surfaces, core).exchange(eps).value / surfaces[0].area()
}

/// F₂₁ and F₂₂ of the outer of two coaxial cylinders of the radii 1 and `r` and the height `h` (Howell's
/// catalogue, C-91 and C-92).
fn of_outer(r: f64, h: f64) -> [f64; 2] {
    let (a, b) = (h * h + r * r - 1.0, h * h - r * r + 1.0);
    let arc = ((a + 2.0).powi(2) - 4.0 * r * r).sqrt() * (b / (r * a)).acos();
    let inner = (1.0 - ((b / a).acos() - (arc + b * (1.0 / r).asin() - FRAC_PI_2 * a) / (2.0 * h)) / PI) / r;
    let root = (4.0 * r * r + h * h).sqrt() / h;
    let sine = (4.0 * (r * r - 1.0) + h * h * (1.0 - 2.0 / (r * r))) / (h * h + 4.0 * (r * r - 1.0));
    let arcs = root * sine.asin() - (1.0 - 2.0 / (r * r)).asin() + FRAC_PI_2 * (root - 1.0);
    let own =
        1.0 - 1.0 / r + 2.0 / (PI * r) * (2.0 * (r * r - 1.0).sqrt() / h).atan() - h / (2.0 * PI * r) * arcs;
    [inner, own]
}

#[test]
fn tubes_have_the_factors_of_the_catalogue() {
    for (r, h) in [(1.1, 0.1), (1.1, 30.0), (1.5, 1.0), (2.0, 2.0), (2.5, 5.0), (10.0, 3.0), (50.0, 400.0)] {
        let inner = cylinder(1.0, [0.0, h]);
        let outer = hollow(cylinder(r, [0.0, h]));
        let [to_inner, to_itself] = of_outer(r, h);
        let found = [factor([&*outer, &*inner], 0.0, 1e-12), factor([&*outer, &*outer], 1.0, 1e-12)];
        let off = [found[0] - to_inner, found[1] - to_itself].map(f64::abs);
        assert!(off[0].max(off[1]) < 2e-12 * r.max(h), "{r} {h}: {off:?}");
    }
}

/// The six of tubes of the radii 1 and 2 and the height 2, by closed forms.
#[test]
fn tubes_with_rings_at_their_ends_have_the_factors_of_closed_forms() {
    let (inner, outer) = (cylinder(1.0, [0.0, 2.0]), hollow(cylinder(2.0, [0.0, 2.0])));
    let (low, high) = (ring([1.0, 2.0], 0.0, 1.0), ring([1.0, 2.0], 2.0, -1.0));
    for (from, to, core, right) in [
        (&outer, &inner, 0.0, 0.337_106_027_518_950_5),
        (&outer, &outer, 1.0, 0.228_481_018_987_998_95),
        (&outer, &low, 1.0, 0.217_206_476_746_525_3),
        (&inner, &low, 0.0, 0.162_893_972_481_049_54),
        (&low, &inner, 0.0, 0.217_191_963_308_066_05),
        (&low, &high, 1.0, 0.203_590_765_367_866_5),
    ] {
        let found = factor([&**from, &**to], core, 1e-13);
        assert!((found - right).abs() < 1e-13, "{found} {right}");
    }
}

/// Row sums of closed rooms about a tube; the wall is a cylinder or a cone.
#[test]
fn rows_of_closed_rooms_sum_to_1() {
    for (core, radii, height) in [(0.4, [1.0, 1.0], 2.0), (0.4, [1.0, 0.5], 0.7), (0.0, [1.0, 0.3], 1.5)] {
        let mut room = vec![
            hollow(cone(radii[0], radii[1], [0.0, height])),
            ring([core, radii[0]], 0.0, 1.0),
            ring([core, radii[1]], height, -1.0),
        ];
        room.extend((core > 0.0).then(|| cylinder(core, [0.0, height])));
        for from in &room {
            let sum: f64 = room.iter().map(|to| factor([&**from, &**to], core, 1e-12)).sum();
            assert!((sum - 1.0).abs() < 3e-12, "{core} {radii:?}: {sum}");
        }
    }
}

#[test]
fn facing_disks_have_the_factor_of_the_catalogue() {
    for (a, b, h) in [(1.0, 1.0, 2.0), (0.1, 3.0, 0.05), (2.0, 0.5, 1e-3), (1.0, 1.0, 1e-4), (1.0, 1.0, 1e-7)]
    {
        let (low, high) = (ring([0.0, a], 0.0, 1.0), ring([0.0, b], h, -1.0));
        // Howell's C-41, its root taken apart so that digits do not cancel.
        let (a, b): (f64, f64) = (a, b);
        let [near, far] = [a - b, a + b].map(|x| (x * x + h * h) / (a * a));
        let right = 2.0 * (b / a).powi(2) / (0.5 * (near + far) + (near * far).sqrt());
        let found = factor([&*low, &*high], 0.0, 1e-11);
        assert!((found - right).abs() < 1e-10 * right, "{a} {b} {h}: {found} {right}");
    }
}

/// Row sums of a tube in a tube, and of fins on one, at gaps down to a millionth.
#[test]
fn narrow_gaps_lose_nothing() {
    for gap in [0.1, 1e-3, 1e-6] {
        let radius = 1.0 + gap;
        let pipe = [
            cylinder(1.0, [0.0, 2.0]),
            hollow(cylinder(radius, [0.0, 2.0])),
            ring([1.0, radius], 0.0, 1.0),
            ring([1.0, radius], 2.0, -1.0),
        ];
        let fins = [
            ring([1.0, 2.0], 0.0, 1.0),
            ring([1.0, 2.0], gap, -1.0),
            cylinder(1.0, [0.0, gap]),
            hollow(cylinder(2.0, [0.0, gap])),
        ];
        for room in [pipe, fins] {
            for from in &room {
                let found = room.each_ref().map(|to| pair([&**from, &**to], 1.0).exchange(1e-10));
                let sum = found.iter().map(|found| found.value).sum::<f64>() / from.area();
                let told = found.iter().map(|found| found.error).sum::<f64>() / from.area();
                let cells = found.map(|found| found.cells);
                println!("{gap} {:.1e} {told:.1e} {cells:?}", sum - 1.0);
                assert!((sum - 1.0).abs() < 1e-9 && told < 3e-9, "{gap}: {sum} {told:.1e}");
            }
        }
    }
}

/// ∫ κ dφ over the circle by sums of visible points, without any of the formulas of the rule.
fn by_points(x: &Jet, around: impl Fn(f64) -> Jet, core: f64) -> f64 {
    const COUNT: usize = 200_000;
    let at = |k: usize| {
        let y = around((2.0 * k as f64 + 1.0) / COUNT as f64 - 1.0);
        let d = y.position - x.position;
        let [flat, way] = [x.position, d].map(|p| p.truncate());
        let nearest = (flat + (-flat.dot(way) / way.length_squared()).clamp(0.0, 1.0) * way).length();
        let cosines = x.normal.dot(d).max(0.0) * (-y.normal.dot(d)).max(0.0);
        if nearest < core { 0.0 } else { cosines / (PI * d.length_squared().powi(2)) }
    };
    TAU / COUNT as f64 * (0..COUNT).map(at).sum::<f64>()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn rings_exchange_what_their_visible_points_do(
        low in 0.3..2.0, high in 0.3..2.0, other in 0.02..2.0, height in 0.1..3.0, core in 0.0..0.3,
        kinds in (0..2u8, 0..4u8),
    ) {
        let wall = cone(low, high, [0.0, height]);
        let first = if kinds.0 == 0 { hollow(wall) } else { wall };
        let second = match kinds.1 {
            0 => ring([0.5 * other, other], -0.2, 1.0),
            1 => ring([0.5 * other, other], height + 0.1, -1.0),
            2 => cylinder(other, [0.1, 0.9]),
            _ => hollow(cylinder(other, [-0.5, 0.3])),
        };
        let (v, w) = (0.3, -0.2);
        let [x, y] = [first.jet(0.1, v), second.jet(0.1, w)];
        let radius = y.position.truncate().length();
        prop_assume!(core < 0.9 * radius.min(x.position.truncate().length()));
        let rings = [(&first, v), (&second, w)].map(|(own, v)| {
            let meridian = own.meridian().unwrap().beside(&first.meridian().unwrap()).unwrap();
            Ring { place: meridian.part([v, 1.0]).ends[0], normal: meridian.normal }
        });
        let found = RingPair::new(rings, false).exchange(core);
        let both = 2.0 * PI * x.position.truncate().length() * radius;
        let right = both * by_points(&x, |u| second.jet(u, w), core);
        let whole = both * by_points(&x, |u| second.jet(u, w), 0.0);
        prop_assert!((found - right).abs() <= 1e-4 * whole + 1e-12, "{found} {right}");
    }
}

/// Error against samples of the six exchanges of tubes with rings: it falls exponentially, and is told.
#[test]
fn errors_fall_exponentially_and_are_told() {
    let (inner, outer) = (cylinder(0.4, [0.0, 2.0]), hollow(cylinder(1.0, [0.0, 2.0])));
    let (low, high) = (ring([0.4, 1.0], 0.0, 1.0), ring([0.4, 1.0], 2.0, -1.0));
    for (from, to, core) in [
        (&outer, &inner, 0.0),
        (&outer, &outer, 0.4),
        (&outer, &low, 0.4),
        (&inner, &low, 0.0),
        (&low, &high, 0.4),
    ] {
        let pair = pair([&**from, &**to], core);
        let right = pair.exchange(0.0).value;
        for digits in 1..=12 {
            let Found { value, error, samples, cells } = pair.exchange(0.1_f64.powi(digits));
            let off = (value - right).abs();
            println!("{digits} {cells} {samples} {:.1e} {:.1e}", off / right, error / right);
            assert!(
                off <= error && error <= 6.0 * (0.1_f64.powi(digits + 1) + 2e-14) * right,
                "{off} {error}"
            );
            assert!(cells <= 16 + 40 * digits as usize, "{digits}: {cells}");
        }
    }
}
