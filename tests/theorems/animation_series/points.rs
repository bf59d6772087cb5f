//! Single pairs of points: coefficients, bounds, symmetries.

use radiosity::geom::DVec3;
use radiosity::published::series::RelativeMotion;
use radiosity::published::series::point_pair::PointPair;
use radiosity::published::series::power_series::inverse_square;
use radiosity_test_support::data::table;
use radiosity_test_support::random::Random;

fn pair(random: &mut Random) -> PointPair {
    let distance = 4f64.powf(random.signed());
    PointPair {
        receiver: random.vector(-2.0, 2.0),
        offset: distance * random.direction(),
        receiver_normal: random.direction(),
        emitter_normal: random.direction(),
    }
}

fn translation(random: &mut Random) -> RelativeMotion {
    RelativeMotion::Translation(random.direction())
}

fn rotation(random: &mut Random) -> RelativeMotion {
    RelativeMotion::Rotation { axis: random.direction(), centre: random.vector(-2.0, 2.0) }
}

/// |r(π)|/r of a pair and a rotation: one over the convergence of its series.
fn rate(pair: &PointPair, motion: &RelativeMotion) -> f64 {
    let half_turned = motion.place(std::f64::consts::PI).point(pair.receiver + pair.offset);
    half_turned.distance(pair.receiver) / pair.offset.length()
}

fn sum(coefficients: &[f64], p: f64) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, c| sum * p + c)
}

/// Decimal digits of quotients that are kept: their rounding to binary digits is then that of the exact
/// quotient.
const DIGITS: usize = 40;

/// The number nearest to an integer or a fraction of any length, by division on paper.
fn fraction(text: &str) -> f64 {
    let (over, under) = text.split_once('/').unwrap_or((text, "1"));
    let (sign, over) = over.strip_prefix('-').map_or(("", over), |over| ("-", over));
    let digits = |text: &str| text.bytes().map(|byte| byte - b'0').collect::<Vec<u8>>();
    let (under, zeros) = (digits(under), under.len() + DIGITS);
    let mut rest: Vec<u8> = Vec::new();
    let mut quotient = String::new();
    for next in digits(over).into_iter().chain(std::iter::repeat_n(0, zeros)) {
        rest.push(next);
        let mut digit = 0;
        while let Some(less) = minus(&rest, &under) {
            (rest, digit) = (less, digit + 1);
        }
        quotient.push(char::from(b'0' + digit));
    }
    format!("{sign}{quotient}e-{zeros}").parse().expect("a number")
}

/// The difference of two natural numbers, digit by digit; None where it is negative.
fn minus(a: &[u8], b: &[u8]) -> Option<Vec<u8>> {
    let start = a.iter().position(|digit| *digit != 0).unwrap_or(a.len());
    let mut difference = a[start..].to_vec();
    let (longer, shorter) = (difference.len(), b.len());
    if longer < shorter || (longer == shorter && difference[..] < *b) {
        return None;
    }
    let mut borrowed = 0;
    for k in 0..longer {
        let taken = b.iter().rev().nth(k).copied().unwrap_or(0) + borrowed;
        let digit = &mut difference[longer - 1 - k];
        borrowed = u8::from(*digit < taken);
        *digit = *digit + 10 * borrowed - taken;
    }
    Some(difference)
}

#[test]
fn fractions_are_rounded_once() {
    for (text, value) in [("0", 0.0), ("-1/16", -0.0625), ("1/3", 1.0 / 3.0), ("10/5", 2.0), ("7", 7.0)] {
        assert_eq!(fraction(text), value, "{text}");
    }
    // Both are rounded to 2⁵³ by themselves.
    assert_eq!(fraction("9007199254740993/9007199254740992"), 1.0);
    assert_eq!(fraction("27021597764222979/9007199254740993"), 3.0);
}

#[test]
fn coefficients_of_the_inverse_square_are_those_of_exact_fractions() {
    let data = table("animation_xi.json");
    let cases = data["cases"].as_array().expect("cases");
    assert_eq!(cases.len(), 6);
    for case in cases {
        let number = |key: &str| fraction(case[key].as_str().expect("a fraction"));
        let exact = case["xi"].as_array().expect("coefficients");
        let mut found = vec![0.0; exact.len()];
        inverse_square(number("alpha"), number("beta"), number("r2"), &mut found);
        for (n, (found, exact)) in found.iter().zip(exact).enumerate() {
            let exact = fraction(exact.as_str().expect("a fraction"));
            let unit = (exact.abs().next_up() - exact.abs()).max(f64::MIN_POSITIVE);
            assert!((found - exact).abs() <= 4.0 * unit, "{case}: {n}, {found:e}, {exact:e}");
        }
    }
}

#[test]
fn two_divisions_give_the_combination_of_the_inverse_square() {
    let mut random = Random(1);
    for _ in 0..200 {
        let (pair, direction) = (pair(&mut random), random.direction());
        let (r, x, y) = (pair.offset, pair.receiver_normal, pair.emitter_normal);
        let (mut xi, mut phi) = ([0.0; 21], [0.0; 21]);
        inverse_square(direction.dot(r), 1.0, r.length_squared(), &mut xi);
        pair.series(&RelativeMotion::Translation(direction), &mut phi);
        let factor = -std::f64::consts::FRAC_1_PI / r.length_squared().powi(2);
        let numerator = [
            y.dot(r) * x.dot(r),
            y.dot(direction) * x.dot(r) + y.dot(r) * x.dot(direction),
            y.dot(direction) * x.dot(direction),
        ];
        for n in 0..phi.len() {
            let parts = [0, 1, 2].map(|k| if k <= n { factor * numerator[k] * xi[n - k] } else { 0.0 });
            let size: f64 = parts.iter().map(|x| x.abs()).sum();
            let local = r.length().powi(-(n as i32) - 2) * (n + 1) as f64;
            assert!((phi[n] - parts.iter().sum::<f64>()).abs() <= 1e-14 * size.max(local), "order {n}");
        }
    }
}

#[test]
fn the_series_of_a_rotation_is_the_kernel_of_the_turned_point() {
    const TERMS: usize = 80;
    let mut random = Random(6);
    for _ in 0..1000 {
        let (pair, motion) = (pair(&mut random), rotation(&mut random));
        let mut phi = [0.0; TERMS];
        pair.series(&motion, &mut phi);
        let variable = 0.6 * random.signed() / rate(&pair, &motion).max(0.1);
        let terms = phi.iter().enumerate().map(|(n, c)| (c * variable.powi(n as i32)).abs());
        let size = terms.fold(0.0, f64::max);
        let exact = pair.kernel(&motion.place(2.0 * variable.atan()));
        let found = sum(&phi, variable);
        assert!((found - exact).abs() <= 1e-12 * size, "{found:e} {exact:e} {motion:?} {pair:?}");
    }
}

#[test]
fn the_remainder_is_below_its_bound_and_not_far_below() {
    let mut random = Random(2);
    for turns in [false, true] {
        let mut ratios = Vec::new();
        for k in 0..10_000 {
            let pair = pair(&mut random);
            let motion = if turns { rotation(&mut random) } else { translation(&mut random) };
            let orders = k % 13;
            let h = 0.475 * (1.0 + random.signed()) + 1e-3;
            let convergence = if turns { 1.0 / rate(&pair, &motion) } else { pair.offset.length() };
            let t = h * convergence * random.signed().signum();
            let p = if turns { 2.0 * t.atan() } else { t };
            let mut phi = vec![0.0; orders + 1];
            pair.series(&motion, &mut phi);
            let exact = pair.kernel(&motion.place(p));
            let terms = phi.iter().enumerate().map(|(n, c)| (c * t.powi(n as i32)).abs());
            // The place of a point is rounded before the kernel between both.
            let nearest = pair.offset.length() * (1.0 - h);
            let rounding = 1e-14 * (1.0 + 1.0 / nearest) * (nearest.powi(-2) + terms.sum::<f64>());
            let missed = (exact - sum(&phi, t)).abs();
            let bound = pair.remainder(&motion, orders, p);
            assert!(missed <= bound + rounding, "order {orders}, h = {h}: {missed:e} > {bound:e}");
            if missed > 100.0 * rounding {
                ratios.push(bound / missed);
            }
        }
        ratios.sort_by(f64::total_cmp);
        let median = ratios[ratios.len() / 2];
        assert!(
            ratios.len() > 5000 && median < if turns { 60.0 } else { 30.0 },
            "{} ratios of median {median}",
            ratios.len()
        );
    }
    let along = RelativeMotion::Translation(DVec3::X);
    assert_eq!(pair(&mut random).remainder(&along, 8, 1e3), f64::INFINITY);
}

#[test]
fn the_opposite_motion_changes_the_signs_of_odd_orders() {
    let mut random = Random(3);
    for _ in 0..1000 {
        let (pair, direction) = (pair(&mut random), random.direction());
        let [along, against] = [direction, -direction].map(RelativeMotion::Translation);
        let centre = random.vector(-2.0, 2.0);
        let [left, right] = [direction, -direction].map(|axis| RelativeMotion::Rotation { axis, centre });
        for [motion, opposite] in [[along, against], [left, right]] {
            let (mut there, mut back) = ([0.0; 12], [0.0; 12]);
            pair.series(&motion, &mut there);
            pair.series(&opposite, &mut back);
            for n in 0..12 {
                assert_eq!(back[n], if n % 2 == 0 { there[n] } else { -there[n] });
            }
            // With the emitter in the place of the receiver, the motion is the opposite one.
            let exchanged = PointPair {
                receiver: pair.receiver + pair.offset,
                offset: -pair.offset,
                receiver_normal: pair.emitter_normal,
                emitter_normal: pair.receiver_normal,
            };
            let mut of_exchanged = [0.0; 12];
            exchanged.series(&opposite, &mut of_exchanged);
            let size = there.iter().fold(0.0f64, |most, x| most.max(x.abs()));
            for (n, (x, y)) in of_exchanged.iter().zip(&there).enumerate() {
                // The sums are formed in another order.
                assert!((x - y).abs() <= 1e-12 * size, "order {n}: {x:e}, {y:e}");
            }
        }
    }
}
