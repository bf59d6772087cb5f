//! Direct light past curved blockers against rays without number, and against closed forms.

use std::sync::Arc;

use radiosity::light::direct::DirectLight;
use radiosity::scene::Scene;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::shapes::{Bezier, Cone, Cylinder, Disk, FULL_TURN, Sphere, Torus};
use radiosity_geom::{DVec3, Surface};
use radiosity_test_support::direct::ACCURACY;
use radiosity_test_support::given::even;
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::scenes::shining;
use radiosity_test_support::shapes::{ball, disk, tube, wall};

/// Rays to a lamp.
const RAYS: usize = 10_000;

/// Factor below which a point counts as out of sight of all lamps.
const FAINT: f64 = 1e-3;

fn scene(shapes: Vec<Arc<dyn Surface>>, emits: impl Fn(usize) -> bool) -> Scene {
    let exitance = |index: usize| if emits(index) { 1.0 } else { 0.0 };
    let shapes = shapes.into_iter().enumerate().map(|(index, shape)| (shape, exitance(index)));
    shining(shapes).build().expect("the scene is valid")
}

/// Points of lamp `lamp`, of exitance 1, that x would receive light from, each with that light.
fn lit_by(scene: &Scene, lamp: usize, x: DVec3, n: DVec3) -> Vec<(DVec3, f64)> {
    let shape = &scene.surfaces[lamp].shape;
    let point = |(_, u, v): (usize, f64, f64)| {
        let jet = shape.jet(u, v);
        let y = jet.position - x;
        let cosines = n.dot(y).max(0.0) * (-jet.normal.dot(y)).max(0.0);
        let light = cosines * jet.area * (4.0 / RAYS as f64) / y.length_squared().powi(2);
        (light > 0.0).then_some((jet.position, light / std::f64::consts::PI))
    };
    scattered(lamp, RAYS).into_iter().filter_map(point).collect()
}

/// Errors at places (surface, u, v), relative to the light without blockers, where there is any; ascending.
fn errors(scene: &Scene, places: &[(usize, f64, f64)]) -> Vec<f64> {
    let solution = even(scene, 1, 0.0, 0.0);
    let visibility = Visibility::new(scene, Shadows::Rays, 1e-3);
    let direct = DirectLight::within(&solution.emitters(), &visibility, ACCURACY);
    let emits = |surface: &usize| scene.surfaces[*surface].material.emission[0] > 0.0;
    let lamps: Vec<usize> = (0..scene.surfaces.len()).filter(emits).collect();
    let error = |(surface, u, v): &(usize, f64, f64)| {
        let jet = scene.surfaces[*surface].shape.jet(*u, *v);
        let element = solution.elements().at(*surface, [*u, *v])?;
        let found: f64 = direct.factors(element, jet.position, jet.normal).iter().map(|(_, f)| f).sum();
        let points = lamps.iter().map(|lamp| (*lamp, lit_by(scene, *lamp, jet.position, jet.normal)));
        let points: Vec<(usize, Vec<(DVec3, f64)>)> = points.collect();
        let whole: f64 = points.iter().flat_map(|(_, points)| points).map(|(_, light)| light).sum();
        if whole <= FAINT {
            return None;
        }
        let seen = |(lamp, points): &(usize, Vec<(DVec3, f64)>)| -> f64 {
            let others: Vec<usize> = (0..scene.surfaces.len()).filter(|other| other != lamp).collect();
            let is_free = |y: &DVec3| visibility.free(&others, jet.position + 1e-7 * (y - jet.position), *y);
            points.iter().filter(|(y, _)| is_free(y)).map(|(_, light)| light).sum()
        };
        let exact: f64 = points.iter().map(seen).sum();
        Some((found - exact).abs() / whole)
    };
    let mut errors: Vec<f64> = places.iter().filter_map(error).collect();
    errors.sort_by(f64::total_cmp);
    errors
}

/// Each error is below 2.5 times the accuracy, the rays' own noise included, and the mean square below half
/// of it.
fn assert_accurate(errors: &[f64]) {
    let mean = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
    let largest = errors[errors.len() - 1];
    assert!(largest < 2.5 * ACCURACY && mean.sqrt() < 0.5 * ACCURACY, "{largest:.1e}, {:.1e}", mean.sqrt());
}

/// Places of a surface that follow no grid (fractional parts of multiples of the golden ratio's relatives).
fn scattered(surface: usize, count: usize) -> Vec<(usize, f64, f64)> {
    let at = |k: usize, by: f64| 2.0 * (k as f64 * by).fract() - 1.0;
    (1..=count).map(|k| (surface, at(k, 0.754_877_666), at(k, 0.569_840_291))).collect()
}

/// A floor and a square lamp of side 1 at height 3 over it.
fn under_a_lamp(blockers: Vec<Arc<dyn Surface>>) -> Scene {
    let p = DVec3::new;
    let mut shapes = vec![
        wall(p(-1.5, -1.5, 0.0), 3.0 * DVec3::X, 3.0 * DVec3::Y),
        wall(p(-0.5, -0.5, 3.0), DVec3::Y, DVec3::X),
    ];
    shapes.extend(blockers);
    scene(shapes, |index| index == 1)
}

#[test]
fn balls_and_rings() {
    let center = DVec3::new(0.1, 0.2, 1.2);
    let ball = ball(center, 0.5);
    assert_accurate(&errors(&under_a_lamp(vec![Arc::new(ball)]), &scattered(0, 40)));
    let axis = DVec3::new(0.3, 0.2, 1.0);
    let ring = Torus::new(center, axis, 0.5, 0.15, FULL_TURN, FULL_TURN).expect("a ring");
    let scene = under_a_lamp(vec![Arc::new(ring)]);
    assert_accurate(&errors(&scene, &scattered(0, 40)));
    assert_accurate(&errors(&scene, &scattered(2, 40)));
}

/// All of a ball of radius R and exitance 1 at distance d above a horizon: E = cos θ (R/d)².
#[test]
fn a_ball_shines_as_its_cone() {
    let (center, radius) = (DVec3::new(0.2, -0.1, 1.0), 0.3);
    let ball = Sphere::new(center, radius, DVec3::X, [-radius, radius], FULL_TURN).expect("a ball");
    let floor = wall(DVec3::new(-1.5, -1.5, 0.0), 3.0 * DVec3::X, 3.0 * DVec3::Y);
    let scene = scene(vec![floor, Arc::new(ball)], |index| index == 1);
    let solution = even(&scene, 1, 0.0, 0.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 1e-3);
    let direct = DirectLight::within(&solution.emitters(), &visibility, ACCURACY);
    for (_, u, v) in scattered(0, 20) {
        let jet = scene.surfaces[0].shape.jet(u, v);
        let found = direct.factors(0, jet.position, jet.normal)[0].1;
        let away = center - jet.position;
        let exact = away.z * radius * radius / away.length().powi(3);
        assert!((found - exact).abs() < 2e-4 * exact, "{found} instead of {exact}");
    }
}

/// A luminous can between its lids, seen past a ball and a column whose axis stands at x = `column`.
fn lit_by_a_can(column: f64) -> Scene {
    let p = DVec3::new;
    let lamp = tube(p(0.0, 0.0, 1.4), 0.6 * DVec3::Z, 0.2);
    let lid = |z: f64, up: f64| disk(p(0.0, 0.0, z), up * DVec3::Z, 0.2);
    let ball = ball(p(0.5, 0.3, 0.9), 0.25);
    let column = tube(p(column, 0.2, 0.2), 1.6 * DVec3::Z, 0.15);
    let floor = wall(p(-1.5, -1.5, 0.0), 3.0 * DVec3::X, 3.0 * DVec3::Y);
    let shapes: Vec<Arc<dyn Surface>> = vec![
        floor,
        Arc::new(lamp),
        Arc::new(lid(1.4, -1.0)),
        Arc::new(lid(2.0, 1.0)),
        Arc::new(ball),
        Arc::new(column),
    ];
    scene(shapes, |index| index == 1)
}

fn assert_near(errors: &[f64]) {
    let mean = errors.iter().map(|error| error * error).sum::<f64>() / errors.len() as f64;
    let largest = errors[errors.len() - 1];
    assert!(largest < 6e-3 && mean.sqrt() < 2e-3, "{largest:.1e}, {:.1e}", mean.sqrt());
}

/// Far from all else the lamp is taken as a whole, also where no more than a sliver of it is seen beside the
/// column.
#[test]
fn lamps_without_a_plane() {
    let scene = lit_by_a_can(-0.9);
    assert_near(&errors(&scene, &scattered(0, 200)));
    assert_near(&errors(&scene, &[scattered(4, 20), scattered(5, 20)].concat()));
}

/// With the column close beside it, the lamp is cut into cells.
#[test]
fn lamps_close_to_others() {
    let scene = lit_by_a_can(-0.45);
    assert_near(&errors(&scene, &scattered(0, 20)));
    assert_near(&errors(&scene, &[scattered(4, 10), scattered(5, 10)].concat()));
}

/// A bulb in a shade that is open above and below: the box of the shade holds the bulb, the shade comes nowhere
/// near it, and some of it stands before the bulb, some beyond. The bulb is taken as a whole.
#[test]
fn bulbs_in_shades() {
    let p = DVec3::new;
    let bulb = ball(p(0.1, 0.0, 1.4), 0.05);
    let shade = Cone::new(p(0.1, 0.0, 1.3), 0.25 * DVec3::Z, 0.17, 0.1, FULL_TURN).expect("a shade");
    let below = wall(p(-1.5, -1.5, 0.0), 3.0 * DVec3::X, 3.0 * DVec3::Y);
    let above = wall(p(-1.5, -1.5, 2.5), 3.0 * DVec3::Y, 3.0 * DVec3::X);
    let scene = scene(vec![below, Arc::new(bulb), above, Arc::new(shade)], |index| index == 1);
    assert_near(&errors(&scene, &[scattered(0, 60), scattered(2, 60)].concat()));
}

#[test]
fn cans() {
    let can = Cylinder::new(DVec3::new(0.0, 0.0, 0.5), DVec3::new(0.3, 0.0, 1.0), 0.4, FULL_TURN);
    let lid = Disk::new(DVec3::new(0.3, 0.0, 1.5), DVec3::new(0.3, 0.0, 1.0), 0.4, 0.0, FULL_TURN);
    let scene = under_a_lamp(vec![Arc::new(can.expect("a can")), Arc::new(lid.expect("a lid"))]);
    assert_accurate(&errors(&scene, &scattered(0, 40)));
    assert_accurate(&errors(&scene, &scattered(2, 40)));
}

#[test]
fn sheets() {
    let p = |i: usize, j: usize| {
        let (x, y) = (i as f64 / 3.0 - 0.5, j as f64 / 3.0 - 0.5);
        DVec3::new(x, y, 1.2 + 1.5 * x * x - 2.0 * y * y + 0.4 * (3.0 * x).sin())
    };
    let sheet = Bezier::new(std::array::from_fn(|i| std::array::from_fn(|j| p(i, j)))).expect("a sheet");
    let scene = under_a_lamp(vec![Arc::new(sheet)]);
    assert_accurate(&errors(&scene, &scattered(0, 40)));
    assert_accurate(&errors(&scene, &scattered(2, 40)));
}

#[test]
fn teapot() {
    let scene = builtin("teapot");
    assert_accurate(&errors(&scene, &scattered(0, 20)));
    let pot: Vec<_> = (8..40).flat_map(|patch| scattered(patch, 3)).collect();
    assert_accurate(&errors(&scene, &pot));
}
