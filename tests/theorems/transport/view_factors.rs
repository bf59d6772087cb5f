//! Theorems about the exchange of two polygons.

use proptest::prelude::*;
use radiosity::kernel::polygon_exchange;
use radiosity_core::gauss::Legendre;
use radiosity_geom::{DVec3, clip_polygon, polygon_area};

type Polygon = Vec<DVec3>;

fn polygon(corners: &[[f64; 3]]) -> Polygon {
    corners.iter().map(|x| DVec3::from_array(*x)).collect()
}

fn point() -> impl Strategy<Value = DVec3> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from_array)
}

/// A parallelogram at `center`, of sides about 1.
fn parallelogram(center: DVec3, u: DVec3, v: DVec3) -> Polygon {
    let u = u.try_normalize().unwrap_or(DVec3::X);
    let across = v - u * u.dot(v);
    let v = across.try_normalize().unwrap_or(u.any_orthonormal_vector()) + 0.3 * u;
    vec![center, center + u, center + u + v, center + v]
}

/// Two parallelograms anywhere near each other.
fn near_pair() -> impl Strategy<Value = (Polygon, Polygon)> {
    (point(), point(), point(), point(), point())
        .prop_map(|(a, b, c, d, e)| (parallelogram(DVec3::ZERO, a, b), parallelogram(1.5 * e, c, d)))
}

/// An orthonormal frame.
fn frame(a: DVec3, b: DVec3) -> [DVec3; 3] {
    let u = a.try_normalize().unwrap_or(DVec3::X);
    let v = (b - u * u.dot(b)).try_normalize().unwrap_or(u.any_orthonormal_vector());
    [u, v, u.cross(v)]
}

fn moved(polygon: &[DVec3], [u, v, w]: [DVec3; 3], origin: DVec3, scale: f64) -> Polygon {
    polygon.iter().map(|x| origin + scale * (u * x.x + v * x.y + w * x.z)).collect()
}

/// Largest deviation of a row sum from 1 in a closed convex room.
fn openness(faces: &[Polygon]) -> f64 {
    let sum = |p: &Polygon| faces.iter().map(|q| polygon_exchange(p, q)).sum::<f64>() / polygon_area(p);
    faces.iter().map(|face| (sum(face) - 1.0).abs()).fold(0.0, f64::max)
}

/// The faces of a prism over an anticlockwise polygon in the plane z = 0, seen from inside.
fn prism(base: &[DVec3], up: DVec3) -> Vec<Polygon> {
    let mut faces = vec![base.to_vec(), base.iter().rev().map(|x| x + up).collect()];
    for k in 0..base.len() {
        let (a, b) = (base[k], base[(k + 1) % base.len()]);
        faces.push(vec![b, a, a + up, b + up]);
    }
    faces
}

/// ∫∫ κ over two parallelograms wholly in front of each other by the product of four Gauss rules.
fn by_area(p: &[DVec3], q: &[DVec3]) -> f64 {
    let rule = &Legendre::<12>::RULE;
    let normal = |c: &[DVec3]| (c[1] - c[0]).cross(c[3] - c[0]);
    let (n, m) = (normal(p), normal(q));
    let at = |c: &[DVec3], s: f64, t: f64| {
        c[0] + (c[1] - c[0]) * (0.5 + 0.5 * s) + (c[3] - c[0]) * (0.5 + 0.5 * t)
    };
    let kernel = |x: DVec3, y: DVec3| {
        let d = y - x;
        n.dot(d) * -m.dot(d) / (std::f64::consts::PI * d.length_squared().powi(2))
    };
    let inner = |x: DVec3| rule.sum(|u| rule.sum(|v| kernel(x, at(q, u, v))));
    rule.sum(|s| rule.sum(|t| inner(at(p, s, t)))) / 16.0
}

proptest! {
    #[test]
    fn exchange_is_mutual_and_bounded((p, q) in near_pair()) {
        let (one, other) = (polygon_exchange(&p, &q), polygon_exchange(&q, &p));
        prop_assert!((one - other).abs() <= 1e-15);
        prop_assert!(one >= 0.0 && one <= polygon_area(&p).min(polygon_area(&q)));
    }

    #[test]
    fn parts_add_up((p, q) in near_pair(), through in 0.05..0.95f64, normal in point()) {
        prop_assume!(normal.length() > 0.1);
        let whole = polygon_exchange(&p, &q);
        let middle = p[0].lerp(p[2], through);
        let parts = [normal, -normal].map(|side| clip_polygon(&p, middle, side));
        let sum: f64 = parts.iter().map(|part| polygon_exchange(part, &q)).sum();
        prop_assert!((sum - whole).abs() < 1e-14, "{sum} {whole}");
        let middle = q[0].lerp(q[2], through);
        let parts = [normal, -normal].map(|side| clip_polygon(&q, middle, side));
        let sum: f64 = parts.iter().map(|part| polygon_exchange(&p, part)).sum();
        prop_assert!((sum - whole).abs() < 1e-14, "{sum} {whole}");
    }

    #[test]
    fn small_parts_add_up((p, q) in near_pair(), size in -6.0..-0.5f64, s in 0.0..1.0f64, t in 0.0..1.0f64) {
        // A small cell of p and the four cells around it: the parts are of very different sizes.
        let h = 10f64.powf(size);
        let at = |s: f64, t: f64| p[0] + (p[1] - p[0]) * s + (p[3] - p[0]) * t;
        let (s, t) = (s * (1.0 - h), t * (1.0 - h));
        let cell = |a: f64, b: f64, c: f64, d: f64| vec![at(a, c), at(b, c), at(b, d), at(a, d)];
        let around = [
            cell(0.0, s, 0.0, 1.0),
            cell(s + h, 1.0, 0.0, 1.0),
            cell(s, s + h, 0.0, t),
            cell(s, s + h, t + h, 1.0),
            cell(s, s + h, t, t + h),
        ];
        let sum: f64 = around.iter().map(|part| polygon_exchange(part, &q)).sum();
        prop_assert!((sum - polygon_exchange(&p, &q)).abs() < 1e-14);
        let small = polygon_exchange(&around[4], &q);
        let quarters: f64 = [(s, t), (s + 0.5 * h, t), (s, t + 0.5 * h), (s + 0.5 * h, t + 0.5 * h)]
            .iter()
            .map(|(s, t)| polygon_exchange(&cell(*s, s + 0.5 * h, *t, t + 0.5 * h), &q))
            .sum();
        // The corners round at 1e-16, the side being h.
        prop_assert!((small - quarters).abs() < 1e-14 * h * h + 4e-16 * h, "{small} {quarters} {h}");
    }

    #[test]
    fn similar_pairs_exchange_alike(
        (p, q) in near_pair(), a in point(), b in point(), origin in point(), size in -6.0..6.0f64
    ) {
        let scale = 10f64.powf(size);
        let [u, v] = [&p, &q].map(|x| moved(x, frame(a, b), scale * origin, scale));
        let (here, there) = (polygon_exchange(&p, &q), polygon_exchange(&u, &v) / (scale * scale));
        prop_assert!((here - there).abs() < 5e-15, "{here} {there}");
    }

    #[test]
    fn tetrahedra_are_closed(a in point(), b in point(), c in point(), d in point()) {
        let volume = (b - a).cross(c - a).dot(d - a);
        prop_assume!(volume.abs() > 0.05);
        let corners = if volume > 0.0 { [a, b, c, d] } else { [a, c, b, d] };
        let face = |k: [usize; 3]| k.map(|k| corners[k]).to_vec();
        let faces = [face([0, 1, 2]), face([0, 2, 3]), face([0, 3, 1]), face([1, 3, 2])];
        prop_assert!(openness(&faces) < 1e-13, "{}", openness(&faces));
    }

    #[test]
    fn oblique_prisms_are_closed(
        sides in 3..8usize, tilt in [-1.0..1.0f64, -1.0..1.0], height in 0.05..5.0f64, a in point(), b in point()
    ) {
        let corner = |k: usize| {
            let (sin, cos) = (std::f64::consts::TAU * k as f64 / sides as f64).sin_cos();
            DVec3::new(cos, 1.5 * sin, 0.0)
        };
        let base: Polygon = (0..sides).map(corner).collect();
        let faces: Vec<Polygon> = prism(&base, DVec3::new(tilt[0], tilt[1], height))
            .iter()
            .map(|face| moved(face, frame(a, b), a, 1.0))
            .collect();
        prop_assert!(openness(&faces) < 1e-13, "{}", openness(&faces));
    }

    #[test]
    fn slender_boxes_are_closed(width in 0.0..3.0f64, height in 0.0..3.0f64) {
        // Sides from 1 to 1000: the digits of the aspect ratio are lost.
        let [w, h] = [width, height].map(|x| 10f64.powf(x));
        let base = polygon(&[[0., 0., 0.], [w, 0., 0.], [w, 1., 0.], [0., 1., 0.]]);
        let openness = openness(&prism(&base, DVec3::Z * h));
        prop_assert!(openness < 1e-14 * w.max(h), "{openness}");
    }

    #[test]
    fn wedges_of_any_angle_are_closed(degrees in 1.0..179.0f64, length in 0.1..10.0f64) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let base = polygon(&[[0., 0., 0.], [1., 0., 0.], [cos, sin, 0.]]);
        let openness = openness(&prism(&base, DVec3::Z * length));
        prop_assert!(openness < 1e-13 * (1.0 + length) / sin, "{openness}");
    }

    #[test]
    fn trembling_hinges_tremble_little(
        size in -16.0..-1.0f64, axis in point(), shift in point(), degrees in 20.0..160.0f64, cut in 0.1..0.9f64
    ) {
        // Edges that nearly touch and are nearly parallel.
        let tremor = 10f64.powf(size);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let floor = polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let wall = polygon(&[[0., 0., 0.], [0., 1., 0.], [cos, 1., sin], [cos, 0., sin]]);
        let turn = frame(DVec3::X + tremor * axis, DVec3::Y + tremor * shift);
        let moved = moved(&wall, turn, tremor * shift, 1.0);
        let (still, trembling) = (polygon_exchange(&floor, &wall), polygon_exchange(&floor, &moved));
        // The exchange moves by about h ln h.
        prop_assert!((still - trembling).abs() < 2.0 * tremor * (1.0 - tremor.ln()) + 1e-15, "{still} {trembling}");
        let parts = [DVec3::Y, -DVec3::Y].map(|side| clip_polygon(&moved, cut * DVec3::Y, side));
        let sum: f64 = parts.iter().map(|part| polygon_exchange(&floor, part)).sum();
        // Clipping passes over heights of 1e-12 of the distance, which is not that of the parts: over either
        // plane.
        let low = |c: &[DVec3], n: DVec3, o: DVec3| {
            let heights = c.iter().map(|x| (x - o).dot(n).abs());
            heights.filter(|height| *height < 4e-12).fold(0.0, f64::max)
        };
        let normal = (moved[1] - moved[0]).cross(moved[3] - moved[0]).normalize();
        let over_floor = low(&parts.concat(), DVec3::Z, floor[0]);
        let passed_over = over_floor + low(&floor, normal, moved[0]);
        prop_assert!((sum - trembling).abs() < 2e-15 + passed_over, "{sum} {trembling}");
    }

    #[test]
    fn reflex_hinges_exchange_nothing(degrees in 181.0..359.0f64) {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let floor = polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let wall = polygon(&[[0., 0., 0.], [0., 1., 0.], [cos, 1., sin], [cos, 0., sin]]);
        prop_assert_eq!(polygon_exchange(&floor, &wall), 0.0);
    }

    #[test]
    fn pairs_apart_agree_with_area_integrals(
        u in point(), v in point(), w in point(), towards in point(), log_distance in 0.6..2.0f64
    ) {
        let towards = towards.try_normalize().unwrap_or(DVec3::Z);
        let p = parallelogram(DVec3::ZERO, u, v);
        let mut q = parallelogram(towards * 10f64.powf(log_distance), v, w);
        let normal = |c: &[DVec3]| (c[1] - c[0]).cross(c[3] - c[0]).normalize();
        let side = |c: &[DVec3], n: DVec3, o: DVec3| c.iter().map(|x| (x - o).dot(n)).fold(f64::INFINITY, f64::min);
        let p = if normal(&p).dot(q[0]) < 0.0 { p.into_iter().rev().collect() } else { p };
        if normal(&q).dot(p[0] - q[0]) < 0.0 {
            q.reverse();
        }
        // Where one sees the other at a grazing angle, the rounding of the corners is felt.
        let low = 0.1 * 10f64.powf(log_distance);
        prop_assume!(side(&q, normal(&p), p[0]) > low && side(&p, normal(&q), q[0]) > low);
        let (exchange, area) = (polygon_exchange(&p, &q), by_area(&p, &q));
        prop_assert!((exchange / area - 1.0).abs() < 2e-13, "{exchange} {area}");
    }

    #[test]
    fn parallel_squares_at_any_gap(log_gap in -9.0..9.0f64) {
        let d = 10f64.powf(log_gap);
        let floor = polygon(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let above = polygon(&[[0., 0., d], [0., 1., d], [1., 1., d], [1., 0., d]]);
        let factor = polygon_exchange(&floor, &above);
        if d < 2.0 {
            // The closed form in X = Y = 1/d, times d².
            let r = (1.0 + d * d).sqrt();
            let logarithm = d * d * ((1.0 + d * d).powi(2) / (d * d * (2.0 + d * d))).sqrt().ln();
            let exact = 2.0 / std::f64::consts::PI
                * (logarithm + 2.0 * (r * (1.0 / r).atan() - d * (1.0 / d).atan()));
            prop_assert!((factor - exact).abs() < 1e-14, "{d}: {factor} {exact}");
        } else if d > 100.0 {
            // With ρ the distance in the plane: 1/(π d²) Σ (−1)ᵏ (k + 1) ⟨ρ²ᵏ⟩ d⁻²ᵏ.
            let x = 1.0 / (d * d);
            let exact = x / std::f64::consts::PI * (1.0 - 2.0 / 3.0 * x + 17.0 / 30.0 * x * x);
            prop_assert!((factor / exact - 1.0).abs() < 1e-12, "{d}: {factor} {exact}");
        }
    }
}
