//! Single pairs of points: coefficients, bounds, symmetries.

use radiosity::geom::DVec3;
use radiosity::published::series::displacement::DisplacementSeries;
use radiosity::published::series::point_pair::PointPair;
use radiosity::published::series::power_series::inverse_square;
use radiosity_test_support::data::table;
use radiosity_test_support::random::Random;

fn pair(random: &mut Random) -> PointPair {
    let distance = 4f64.powf(random.signed());
    PointPair {
        offset: distance * random.direction(),
        receiver_normal: random.direction(),
        emitter_normal: random.direction(),
    }
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
        pair.series(direction, &mut phi);
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
fn the_remainder_is_below_its_bound_and_not_far_below() {
    let mut random = Random(2);
    let mut ratios = Vec::new();
    for k in 0..10_000 {
        let (pair, direction) = (pair(&mut random), 1.5 * random.direction());
        let orders = k % 13;
        let h = 0.475 * (1.0 + random.signed()) + 1e-3;
        let p = h * pair.offset.length() / direction.length() * random.signed().signum();
        let mut phi = vec![0.0; orders + 1];
        pair.series(direction, &mut phi);
        let exact = pair.kernel(p * direction);
        let rounding = 1e-14
            * (exact.abs() + phi.iter().enumerate().map(|(n, c)| (c * p.powi(n as i32)).abs()).sum::<f64>());
        let missed = (exact - sum(&phi, p)).abs();
        let bound = pair.remainder(direction, orders, p);
        assert!(missed <= bound + rounding, "order {orders}, h = {h}: {missed:e} > {bound:e}");
        if missed > 100.0 * rounding {
            ratios.push(bound / missed);
        }
    }
    ratios.sort_by(f64::total_cmp);
    let median = ratios[ratios.len() / 2];
    assert!(ratios.len() > 5000 && median < 30.0, "{} ratios of median {median}", ratios.len());
    assert_eq!(pair(&mut random).remainder(DVec3::X, 8, 1e3), f64::INFINITY);
}

#[test]
fn the_opposite_direction_changes_the_signs_of_odd_orders() {
    let mut random = Random(3);
    for _ in 0..1000 {
        let (pair, direction) = (pair(&mut random), random.direction());
        let (mut there, mut back) = ([0.0; 12], [0.0; 12]);
        pair.series(direction, &mut there);
        pair.series(-direction, &mut back);
        for n in 0..12 {
            assert_eq!(back[n], if n % 2 == 0 { there[n] } else { -there[n] });
        }
        let turned = PointPair {
            offset: -pair.offset,
            receiver_normal: pair.emitter_normal,
            emitter_normal: pair.receiver_normal,
        };
        let mut of_turned = [0.0; 12];
        turned.series(-direction, &mut of_turned);
        // The sums are formed in another order.
        for (n, (x, y)) in of_turned.iter().zip(&there).enumerate() {
            let size = pair.offset.length().powi(-(n as i32) - 2) * (n + 1) as f64;
            assert!((x - y).abs() <= 1e-14 * size.max(y.abs()), "order {n}: {x:e}, {y:e}");
        }
    }
}

#[test]
fn points_face_each_other_as_long_as_they_are_said_to() {
    let mut random = Random(4);
    let mut numbers = [0; 2];
    for _ in 0..1000 {
        let (pair, direction) = (pair(&mut random), random.direction());
        let faces_at = |p: f64| {
            let r = pair.offset + p * direction;
            pair.receiver_normal.dot(r) > 0.0 && pair.emitter_normal.dot(r) < 0.0
        };
        let (faces, span) = pair.facing(direction);
        assert_eq!(faces, faces_at(0.0));
        assert!(span.contains(0.0));
        numbers[usize::from(faces)] += 1;
        for end in [span.from, span.to] {
            let inside = if end.is_finite() { end * (1.0 - 1e-9) } else { end.signum() * 1e6 };
            assert_eq!(faces_at(inside), faces, "{span:?}");
            if end.is_finite() {
                assert_ne!(faces_at(end + end.signum() * 1e-9), faces, "{span:?}");
            }
        }
    }
    assert!(numbers.iter().all(|count| *count > 100));
}

/// Errors at 2h over those at h.
fn orders(error: impl Fn(f64) -> f64) -> f64 {
    (error(0.02) / error(0.01)).log2()
}

#[test]
fn three_series_along_the_axes_miss_the_products_that_one_in_three_variables_holds() {
    const DEGREE: usize = 5;
    let mut random = Random(5);
    for _ in 0..20 {
        let (pair, way) = (pair(&mut random), random.direction());
        let length = pair.offset.length();
        let at = |h: f64| h * length * way;
        let all = DisplacementSeries::new(&pair, DEGREE);
        let joint = |h: f64| (all.at(at(h)) - pair.kernel(at(h))).abs();
        let axes = |h: f64| {
            let changes = DVec3::AXES.map(|axis| {
                let mut phi = [0.0; DEGREE + 1];
                pair.series(axis, &mut phi);
                sum(&phi, at(h).dot(axis)) - phi[0]
            });
            (pair.kernel(DVec3::ZERO) + changes.iter().sum::<f64>() - pair.kernel(at(h))).abs()
        };
        assert!((orders(axes) - 2.0).abs() < 0.3, "along axes: order {}", orders(axes));
        assert!((orders(joint) - (DEGREE + 1) as f64).abs() < 0.5, "jointly: order {}", orders(joint));
        let mut phi = [0.0; DEGREE + 1];
        pair.series(way, &mut phi);
        let along = sum(&phi, 0.3 * length);
        assert!((along - all.at(at(0.3))).abs() <= 1e-14 * phi.iter().fold(0.0f64, |m, c| m.max(c.abs())));
    }
}
