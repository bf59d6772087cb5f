//! Bases on surfaces that degenerate, and on polygons far from parallelograms.

use std::sync::Arc;

use proptest::prelude::*;
use radiosity_core::basis::{total, triangle};
use radiosity_geom::shapes::{Bezier, Bilinear, Cone, Disk, FULL_TURN, Sphere, Torus};
use radiosity_geom::{DVec2, PlanarRegion, Rect, Surface};

use super::super::patch::Direction;
use super::*;

/// Every patch in four.
fn quartered(patches: &[Patch]) -> Vec<Patch> {
    let halves = patches.iter().flat_map(|patch| patch.halves(Direction::Along));
    halves.flat_map(|patch| patch.halves(Direction::Across)).collect()
}

/// The parameters of a curved surface in cells that shrink towards all sides.
fn graded(surface: &Arc<dyn Surface>) -> Vec<Patch> {
    let breaks = [-1.0, -31.0 / 32.0, -7.0 / 8.0, -0.5, 0.0, 0.5, 7.0 / 8.0, 31.0 / 32.0, 1.0];
    let cell =
        |u: &[f64], v: &[f64]| Patch::curved(Arc::clone(surface), &Rect { u: [u[0], u[1]], v: [v[0], v[1]] });
    breaks.windows(2).flat_map(|u| breaks.windows(2).map(move |v| cell(u, v))).collect()
}

fn functions(basis: &AreaBasis, place: [f64; 2]) -> Vec<f64> {
    let mut raw = vec![0.0; basis.len()];
    basis.raw(place, &mut raw);
    basis
        .transform()
        .chunks_exact(basis.len())
        .map(|row| row.iter().zip(&raw).map(|(t, r)| t * r).sum())
        .collect()
}

/// Max |∫ φ_k φ_l dA − δ_kl| by a plain Gauss rule on a cover of its own.
fn defect(basis: &AreaBasis, cover: &[Patch], points: usize) -> f64 {
    let n = basis.len();
    let mut gram = vec![0.0; n * n];
    let rule = UnitRule::of(points);
    for patch in cover {
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = patch.node(s, t);
            let values = functions(basis, basis.frame().coordinates(&node));
            for (line, x) in gram.chunks_exact_mut(n).zip(&values) {
                let factor = ws * wt * node.area * x;
                line.iter_mut().zip(&values).for_each(|(g, y)| *g += factor * y);
            }
        }
    }
    gram.iter_mut().step_by(n + 1).for_each(|diagonal| *diagonal -= 1.0);
    gram.iter().fold(0.0, |largest, g| largest.max(g.abs()))
}

fn ring(points: &[[f64; 2]]) -> Vec<DVec3> {
    points.iter().map(|[x, y]| DVec3::new(*x, *y, 0.0)).collect()
}

fn polygon(outline: &[[f64; 2]], holes: &[&[[f64; 2]]]) -> Vec<Patch> {
    let holes = holes.iter().map(|hole| ring(hole)).collect();
    let region = PlanarRegion::new(ring(outline), holes).expect("a simple polygon");
    region.convex_pieces().iter().flat_map(|piece| Patch::of_polygon(piece, DVec3::Z)).collect()
}

fn basis(order: usize, patches: &[Patch]) -> AreaBasis {
    let corners: Vec<DVec3> = patches.iter().flat_map(Patch::polygon).collect();
    AreaBasis::new(order, Frame::bounding(&corners, [DVec3::X, DVec3::Y]), patches).expect("it has area")
}

fn assert_orthonormal(name: &str, order: usize, patches: &[Patch]) {
    let defect = defect(&basis(order, patches), &quartered(patches), order + 3);
    assert!(defect < 1e-12, "{name}, order {order}: {defect:e}");
}

/// Slivers of aspect 1e4, an L with arms a tenth of its length, a comb, a square frame.
#[test]
fn orthonormal_over_polygons_far_from_parallelograms() {
    let l = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.1], [0.1, 0.1], [0.1, 1.0], [0.0, 1.0]];
    let comb = [[0., 0.], [1., 0.], [1., 0.6], [0.9, 0.6], [0.9, 0.1], [0.5, 0.1], [0.5, 0.8], [0.4, 0.8]];
    let comb = [comb.as_slice(), &[[0.4, 0.1], [0.1, 0.1], [0.1, 1.0], [0.0, 1.0]]].concat();
    let hole = [[0.02, 0.02], [0.02, 0.97], [0.95, 0.95], [0.98, 0.04]];
    let shapes = [
        ("sliver", polygon(&[[0.0, 0.0], [1.0, 0.0], [0.3, 1e-4]], &[])),
        ("needle", polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1e-4]], &[])),
        ("thin quadrilateral", polygon(&[[0.0, 0.0], [1.0, 0.0], [0.9, 1e-4], [0.2, 0.6e-4]], &[])),
        ("L", polygon(&l, &[])),
        ("comb", polygon(&comb, &[])),
        ("frame", polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], &[&hole])),
    ];
    for (name, patches) in &shapes {
        for order in [1, 4, 9, 14] {
            assert_orthonormal(name, order, patches);
        }
    }
    for (name, patches) in &shapes[..4] {
        assert_orthonormal(name, HIGHEST_ORDER, patches);
    }
}

fn net(height: impl Fn(f64, f64) -> f64) -> [[DVec3; 4]; 4] {
    let third = |k: usize| k as f64 / 3.0;
    std::array::from_fn(|i| {
        std::array::from_fn(|j| DVec3::new(third(i), third(j), height(third(i), third(j))))
    })
}

/// Poles, apices, centres and collapsed sides, where the area element vanishes.
#[test]
fn orthonormal_over_curved_surfaces_that_degenerate() {
    let wavy = net(|x, y| (1.3 * x - 0.4).powi(2) + 0.8 * x * y - 0.5 * (y - 0.2).powi(3));
    let mut one_side = wavy;
    one_side[0] = [wavy[0][0]; 4];
    let mut two_sides = one_side;
    two_sides.iter_mut().for_each(|row| row[0] = wavy[0][0]);
    let nearly = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 0.01, 0.0]];
    let shapes: [(&str, Arc<dyn Surface>); 8] = [
        ("sphere", Arc::new(Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).unwrap())),
        ("cone", Arc::new(Cone::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).unwrap())),
        ("disk", Arc::new(Disk::new(DVec3::ZERO, DVec3::Z, 1.0, 0.0, FULL_TURN).unwrap())),
        ("torus", Arc::new(Torus::new(DVec3::ZERO, DVec3::Z, 2.0, 1.9, FULL_TURN, FULL_TURN).unwrap())),
        ("Bézier", Arc::new(Bezier::new(wavy).unwrap())),
        ("one side collapsed", Arc::new(Bezier::new(one_side).unwrap())),
        ("two sides collapsed", Arc::new(Bezier::new(two_sides).unwrap())),
        ("nearly a triangle", Arc::new(Bilinear::new(nearly.map(DVec3::from_array)).unwrap())),
    ];
    for (name, surface) in shapes {
        let patches = [Patch::curved(Arc::clone(&surface), &Rect::FULL)];
        for (order, points) in [(0, 24), (5, 24), (12, 24)] {
            let frame = Frame::Parameters { center: DVec2::ZERO, half: DVec2::ONE };
            let basis = AreaBasis::new(order, frame, &patches).expect("it has area");
            let defect = defect(&basis, &graded(&surface), points);
            assert!(defect < 1e-12, "{name}, order {order}: {defect:e}");
        }
    }
}

/// Σ_k φ_k(x) φ_k(y) does not depend on the basis of the space: Dubiner's gives the same.
#[test]
fn reproducing_kernel_of_a_triangle_is_that_of_dubiner() {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
    let basis = basis(HIGHEST_ORDER, &polygon(&corners, &[]));
    assert!(!basis.is_product());
    let dubiner = |[s, t]: [f64; 2]| {
        let mut values = vec![0.0; basis.len()];
        triangle::values(HIGHEST_ORDER, s, t, &mut values);
        values
    };
    let ours = |[x, y]: [f64; 2]| functions(&basis, basis.frame().locate(DVec3::new(x, y, 0.0), DVec2::ZERO));
    let kernel = |x: &[f64], y: &[f64]| -> f64 { x.iter().zip(y).map(|(x, y)| x * y).sum() };
    let places = [[-1.0, -1.0], [-0.9, 0.3], [-0.3, -0.4], [0.2, -0.95], [-0.99, 0.98]];
    for x in places {
        for y in places {
            let scale = (kernel(&dubiner(x), &dubiner(x)) * kernel(&dubiner(y), &dubiner(y))).sqrt();
            let error = kernel(&ours(x), &ours(y)) - kernel(&dubiner(x), &dubiner(y));
            assert!(error.abs() < 1e-12 * scale, "{x:?} {y:?}: {error:e} of {scale:e}");
        }
    }
}

#[test]
fn sheared_parallelogram_is_as_good_as_a_square() {
    let (a, b) = (DVec3::new(1.0, 0.0, 0.0), DVec3::new(100.0, 1.0, 0.5));
    let corners = [DVec3::ZERO, a, a + b, b];
    let patches = Patch::of_polygon(&corners, a.cross(b).normalize());
    let basis = AreaBasis::new(HIGHEST_ORDER, Frame::bounding(&corners, [a, b]), &patches);
    let basis = basis.expect("it has area");
    assert!(basis.is_product());
    let defect = defect(&basis, &quartered(&patches), HIGHEST_ORDER + 3);
    assert!(defect < 1e-12, "{defect:e}");
}

fn tensor(order: usize, patches: &[Patch]) -> AreaBasis {
    let corners: Vec<DVec3> = patches.iter().flat_map(Patch::polygon).collect();
    let measure = Measure::new(patches, Space::Tensor.chart_degree(order, patches));
    let frame = Frame::bounding(&corners, [DVec3::X, DVec3::Y]);
    AreaBasis::over(&measure, Space::Tensor, order, frame, patches).expect("it has area")
}

#[test]
fn tensor_basis_is_orthonormal_and_contains_total_degree() {
    let l = polygon(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.2], [0.3, 0.2], [0.3, 1.0], [0.0, 1.0]], &[]);
    let shapes = [
        (true, polygon(&[[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]], &[])),
        (false, polygon(&[[0.0, 0.0], [1.0, 0.0], [0.3, 0.8]], &[])),
        (false, l),
    ];
    for (product, patches) in &shapes {
        for order in [0, 1, 2, 5, 9] {
            let basis = tensor(order, patches);
            assert_eq!(basis.len(), (order + 1) * (order + 1));
            assert!(basis.is_product() == *product || order < 9);
            let defect = defect(&basis, &quartered(patches), 2 * order + 3);
            assert!(defect < 1e-12, "order {order}: {defect:e}");
            assert_contains(&basis, &super::tests::basis(order, patches), patches);
        }
    }
}

/// ‖φ‖² of every function of `part` is the sum of its squared coefficients in `whole`.
fn assert_contains(whole: &AreaBasis, part: &AreaBasis, patches: &[Patch]) {
    let rule = UnitRule::of(2 * whole.order() + 2);
    let mut overlaps = vec![0.0; part.len() * whole.len()];
    for patch in patches {
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = patch.node(s, t);
            let theirs = functions(whole, whole.frame().coordinates(&node));
            let ours = functions(part, part.frame().coordinates(&node));
            for (row, x) in overlaps.chunks_exact_mut(whole.len()).zip(&ours) {
                add_scaled(row, ws * wt * node.area * x, &theirs);
            }
        }
    }
    for row in overlaps.chunks_exact(whole.len()) {
        assert!((dot(row, row) - 1.0).abs() < 1e-12, "{}", dot(row, row));
    }
}

#[test]
fn no_area_gives_no_basis() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::X, DVec3::ZERO];
    let patch = Patch::Flat { corners, normal: DVec3::Z };
    let frame = Frame::Plane { origin: DVec3::ZERO, first: DVec3::X, second: DVec3::Y };
    assert!(AreaBasis::new(1, frame, &[patch]).is_none());
}

/// Polygons with a corner in each of 3 to 9 directions, at distances between 0.2 and 1.
fn star() -> impl Strategy<Value = Vec<[f64; 2]>> {
    prop::collection::vec(0.2..1.0, 3..10).prop_map(|radii| {
        let turn = std::f64::consts::TAU / radii.len() as f64;
        let corner = |(k, r): (usize, &f64)| [r * (k as f64 * turn).cos(), r * (k as f64 * turn).sin()];
        radii.iter().enumerate().map(corner).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn orthonormal_over_random_polygons(outline in star(), order in 0..=10usize) {
        let patches = polygon(&outline, &[]);
        let defect = defect(&basis(order, &patches), &quartered(&patches), order + 3);
        prop_assert!(defect < 1e-12, "{defect:e}");
    }

    /// Σ_k ⟨f, φ_k⟩ φ_k = f for f of degree N, the constant included.
    #[test]
    fn polynomials_are_in_the_span(
        outline in star(), order in 0..=8usize, factors in prop::collection::vec(-1.0..1.0f64, 45),
    ) {
        let patches = polygon(&outline, &[]);
        let basis = basis(order, &patches);
        let polynomial = |p: DVec3| -> f64 {
            let term = |k: usize| {
                let (i, j) = total::degrees(k);
                factors[k] * p.x.powi(i as i32) * p.y.powi(j as i32)
            };
            (0..basis.len()).map(term).sum()
        };
        let mut coefficients = vec![0.0; basis.len()];
        let rule = UnitRule::of(order + 2);
        for patch in &patches {
            for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                let factor = ws * wt * node.area * polynomial(node.position);
                let values = functions(&basis, basis.frame().coordinates(&node));
                coefficients.iter_mut().zip(values).for_each(|(c, value)| *c += factor * value);
            }
        }
        let raw = basis.to_raw(&coefficients);
        let mut values = vec![0.0; basis.len()];
        for patch in &patches {
            let node = patch.node(0.3, 0.8);
            basis.raw(basis.frame().coordinates(&node), &mut values);
            let sum: f64 = raw.iter().zip(&values).map(|(c, value)| c * value).sum();
            prop_assert!((sum - polynomial(node.position)).abs() < 1e-11);
        }
    }
}
