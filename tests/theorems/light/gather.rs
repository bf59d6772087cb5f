//! The gathered read-off against closed forms: factors of points, rooms where radiosity is 2 everywhere,
//! contacts.

use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};

use proptest::prelude::*;
use radiosity::Work;
use radiosity::elements::cells::Layers;
use radiosity::light::direct::DirectLight;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::reading::grid::{Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity::solve::gather::Gather;
use radiosity::solve::gather::standpoint::Standpoint;
use radiosity::solve::solution::Solution;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::shapes::Disk;
use radiosity_geom::{DVec3, PlanarRegion, Surface, shapes::Polygon};
use radiosity_test_support::data::{number, table};
use radiosity_test_support::direct::ACCURACY;
use radiosity_test_support::given::even;
use radiosity_test_support::scenes::shining;
use radiosity_test_support::scenes::{builtin, material};
use radiosity_test_support::shapes::inside;
use radiosity_test_support::shapes::{ball, disk, wall};
use radiosity_test_support::solved::outcome_of;

const EPS: f64 = 1e-3;

type Shapes = Vec<(Arc<dyn Surface>, f64)>;

fn scene(shapes: Shapes) -> Scene {
    shining(shapes).build().expect("the scene is valid")
}

fn at(gather: &Gather, solution: &Solution, visibility: &Visibility, x: DVec3, n: DVec3) -> f64 {
    let standpoint = Standpoint::find(solution.elements(), visibility, x, n);
    gather.at(&standpoint.receiver_point(n))[0]
}

/// Light straight from all emitters of exitance 1, at the origin, from above.
fn lit_at_origin(shapes: Shapes) -> f64 {
    let scene = scene(shapes);
    let solution = even(&scene, 2, 0.0, 0.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    let direct = DirectLight::within(&solution.emitters(), &visibility, ACCURACY);
    let receiver = ReceiverPoint::free(DVec3::ZERO, DVec3::Z);
    direct.irradiance(&receiver, &direct.around(&receiver.site()))[0]
}

fn lid(height: f64, radius: f64) -> Disk {
    disk(height * DVec3::Z, -DVec3::Z, radius)
}

/// The cases `element_to_…` of the table of view factors: their formulas, evaluated with 40 digits.
#[test]
fn factors_of_a_point_agree_with_closed_forms() {
    let rectangle = |a: f64, b: f64, c: f64| wall(c * DVec3::Z, b * DVec3::Y, a * DVec3::X);
    let cases: [(&str, Arc<dyn Surface>, f64, f64); 7] = [
        ("square over its corner", rectangle(1.0, 1.0, 1.0), 0.138531605994893, 1e-14),
        ("rectangle over its corner", rectangle(3.0, 1.0, 0.5), 0.22269468089180286, 1e-14),
        ("disk r = h", Arc::new(lid(1.0, 1.0)), 0.5, EPS),
        ("disk r = h/4", Arc::new(lid(2.0, 0.5)), 0.058823529411764705, EPS),
        ("ball r = h/2", Arc::new(ball(2.0 * DVec3::Z, 1.0)), 0.25, 2.0 * EPS),
        ("ball near by", Arc::new(ball(1.01 * DVec3::Z, 1.0)), 0.9802960494069208, 2.0 * EPS),
        ("ball r = h/5", Arc::new(ball(5.0 * DVec3::Z, 1.0)), 0.04, EPS),
    ];
    for (name, shape, exact, tolerance) in cases {
        let found = lit_at_origin(vec![(shape, 1.0)]);
        assert!((found / exact - 1.0).abs() < tolerance, "{name}: {found} instead of {exact}");
    }
}

/// Inside a ball everything is 2, at its poles as well, where its parameters end.
#[test]
fn the_poles_of_a_ball_see_what_the_rest_sees() {
    let scene = scene(vec![(inside(ball(DVec3::X, 0.7)), 1.0)]);
    let solution = even(&scene, 2, 2.0, 1.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    let gather = Gather::new(&solution, &visibility, EPS);
    for v in [0.0, 0.9, 0.999, 0.999_999, 1.0] {
        let jet = scene.surfaces[0].shape.jet(0.3, v);
        let found = gather.at(&ReceiverPoint::on(0, jet.position, jet.normal))[0];
        assert!((found / 2.0 - 1.0).abs() < EPS, "{found} at v = {v}");
        // Askew by ϑ the kernel is no constant, and (1 + cos ϑ)/2 of what the normal faces lies over the
        // ground.
        let askew = ReceiverPoint {
            normal: (jet.normal + 0.1 * DVec3::Y).normalize(),
            ground: Some(jet.normal),
            ..ReceiverPoint::on(0, jet.position, jet.normal)
        };
        let found = gather.at(&askew)[0];
        let exact = 1.0 + askew.normal.dot(jet.normal);
        assert!((found / exact - 1.0).abs() < 2.0 * EPS, "{found} instead of {exact} at v = {v}");
    }
}

/// A ball of radius r at height h before a disk leaves R²/(R² + H²) − (r/h)² of it; a plate over a quarter of
/// a square lamp hides a quarter.
#[test]
fn blockers_take_away_what_they_cover() {
    let lamp = lid(2.0, 1.0);
    let found = lit_at_origin(vec![(Arc::new(lamp), 1.0), (Arc::new(ball(DVec3::Z, 0.2)), 0.0)]);
    let exact = 0.2 - 0.04;
    assert!((found / exact - 1.0).abs() < 3.0 * EPS, "{found} instead of {exact}");
    let square = wall(DVec3::new(-0.5, -0.5, 1.0), DVec3::Y, DVec3::X);
    let whole = lit_at_origin(vec![(square.clone(), 1.0)]);
    let before = wall(DVec3::new(0.0, 0.0, 0.5), DVec3::X, DVec3::Y);
    let found = lit_at_origin(vec![(square, 1.0), (before, 0.0)]);
    assert!((found / whole - 0.75).abs() < 1e-14, "{found} of {whole}");
    // A curved lamp behind a planar blocker: half of it.
    let half = wall(DVec3::new(0.0, -2.0, 0.5), 2.0 * DVec3::X, 4.0 * DVec3::Y);
    let found = lit_at_origin(vec![(Arc::new(lid(1.0, 1.0)), 1.0), (half, 0.0)]);
    assert!((found / 0.25 - 1.0).abs() < 5.0 * EPS, "{found} instead of 0.25");
}

/// A cube from inside with a block on its floor and a two-sided screen. Everything emits 1 and reflects a
/// half: E = B = 2.
fn furnished_room() -> Scene {
    let (x, y, z) = (DVec3::X, DVec3::Y, DVec3::Z);
    let p = DVec3::new;
    let (low, high) = (p(0.2, 0.3, 0.0), p(0.5, 0.6, 0.4));
    let (a, b, c) = (0.3 * x, 0.3 * y, 0.4 * z);
    let footprint = vec![low, low + a, low + a + b, low + b];
    let outline = vec![DVec3::ZERO, x, x + y, y];
    let floor = PlanarRegion::new(outline, vec![footprint]).expect("a floor with a hole");
    let floor = Polygon::new(floor.outer().to_vec(), floor.holes().to_vec()).expect("a floor");
    let screen = wall(p(0.7, 0.1, 0.3), 0.1 * x + 0.2 * y, 0.3 * z);
    let shapes: Vec<Arc<dyn Surface>> = vec![
        Arc::new(floor),
        wall(z, y, x),
        wall(DVec3::ZERO, y, z),
        wall(x, z, y),
        wall(DVec3::ZERO, z, x),
        wall(y, x, z),
        wall(low + c, a, b),
        wall(low, a, c),
        wall(low, c, b),
        wall(high, -c, -a),
        wall(high, -b, -c),
    ];
    let mut room = shining(shapes.into_iter().map(|shape| (shape, 1.0)));
    let white = room.material("white", material(0.5, 1.0));
    room.surface("screen", screen, &white).two_sided();
    room.build().expect("the room is valid")
}

/// Irradiance in the furnished room.
fn in_room(x: DVec3, n: DVec3) -> f64 {
    static ROOM: OnceLock<(Solution, Visibility)> = OnceLock::new();
    static GATHER: OnceLock<Gather> = OnceLock::new();
    let (solution, visibility) = ROOM.get_or_init(|| {
        let scene = furnished_room();
        (even(&scene, 2, 2.0, 1.0), Visibility::new(&scene, Shadows::Rays, 3e-3))
    });
    let gather = GATHER.get_or_init(|| Gather::new(solution, visibility, EPS));
    at(gather, solution, visibility, x, n)
}

#[test]
fn furnace_is_two_everywhere_even_at_contacts() {
    let p = DVec3::new;
    let mut points = vec![
        ("floor corner", DVec3::ZERO, DVec3::Z),
        ("room edge", p(0.0, 0.3, 0.0), DVec3::X),
        ("beside the block", p(0.2 - 1e-3, 0.4, 0.0), DVec3::Z),
        ("nearer", p(0.2 - 1e-6, 0.4, 0.0), DVec3::Z),
        ("at the block's foot", p(0.2, 0.4, 0.0), DVec3::Z),
        ("at its corner", p(0.2, 0.3, 0.0), DVec3::Z),
        ("on its side, at the foot", p(0.2, 0.4, 0.0), -DVec3::X),
        ("a trifle inside its side", p(0.2 + 4e-7, 0.4, 0.2), -DVec3::X),
        ("a trifle off it", p(0.2 - 4e-7, 0.4, 0.2), -DVec3::X),
        ("tilted on the floor", p(0.6, 0.5, 0.0), p(0.6, 0.0, 0.8)),
        ("on the screen", p(0.75, 0.2, 0.4), p(2.0, -1.0, 0.0).normalize()),
        ("on its back", p(0.75, 0.2, 0.4), p(-2.0, 1.0, 0.0).normalize()),
    ];
    for x in [0.0, 1e-7, 1e-3, 0.1, 0.9, 1.0] {
        points.push(("ceiling", p(x, 0.7, 1.0), -DVec3::Z));
        points.push(("wall", p(x, 1.0, 0.999), -DVec3::Y));
    }
    for (name, x, n) in points {
        let e = in_room(x, n);
        // A tilted receiver sees the floor itself in part of its half-space, and the floor's own light does
        // not reach it.
        let exact = if name.starts_with("tilted") { 2.0 * 0.5 * (1.0 + 0.8) } else { 2.0 };
        assert!((e / exact - 1.0).abs() < 3.0 * EPS, "{name}: {e} at {x} along {n}");
    }
}

#[test]
fn nothing_leaks_through_walls() {
    let p = DVec3::new;
    for (x, n) in
        [(p(0.6, 0.5, -1e-3), DVec3::Z), (p(-0.5, 0.5, 0.5), DVec3::X), (p(0.35, 0.4, 0.2), DVec3::X)]
    {
        let e = in_room(x, n);
        assert!(e.abs() < 1e-12, "{e} at {x}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn furnace_is_two_at_random_points(
        points in prop::collection::vec((0.001..0.999, 0.001..0.999, 0.001..0.999, 0.0..PI, 0.0..2.0 * PI), 4),
    ) {
        for (x, y, z, theta, phi) in points {
            let x = DVec3::new(x, y, z);
            let block = (0.2..0.5).contains(&x.x) && (0.3..0.6).contains(&x.y) && x.z < 0.4;
            if block {
                continue;
            }
            let n = DVec3::new(theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos());
            let e = in_room(x, n);
            prop_assert!((e / 2.0 - 1.0).abs() < 3.0 * EPS, "{e} at {x} along {n}");
        }
    }
}

/// The inside of a ball, where every point sees every other: E = 2 on it and within.
#[test]
fn furnace_ball_is_two_everywhere() {
    let scene = scene(vec![(inside(ball(DVec3::ZERO, 1.0)), 1.0)]);
    let solution = even(&scene, 2, 2.0, 1.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    let gather = Gather::new(&solution, &visibility, EPS);
    let p = DVec3::new;
    for (x, n) in [(p(1.0, 0.0, 0.0), -DVec3::X), (p(0.0, 0.0, -1.0), DVec3::Z), (p(0.2, 0.3, 0.9), DVec3::Y)]
    {
        let e = at(&gather, &solution, &visibility, x, n);
        assert!((e / 2.0 - 1.0).abs() < 3.0 * EPS, "{e} at {x}");
    }
}

/// A ball within a ball: the outer one sees the inner, and itself past it.
#[test]
fn furnace_between_balls_is_two() {
    let shapes: Shapes = vec![(inside(ball(DVec3::ZERO, 1.0)), 1.0), (Arc::new(ball(DVec3::ZERO, 0.5)), 1.0)];
    let scene = scene(shapes);
    let solution = even(&scene, 2, 2.0, 1.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    let gather = Gather::new(&solution, &visibility, EPS);
    let p = DVec3::new;
    for (x, n) in
        [(p(1.0, 0.0, 0.0), -DVec3::X), (p(0.0, 0.6, 0.8), p(0.0, -0.6, -0.8)), (p(0.0, 0.0, 0.5), DVec3::Z)]
    {
        let e = at(&gather, &solution, &visibility, x, n);
        // Errors of the cells that the inner ball's outline cuts have the same sign. Unshadowed it would be
        // 2.5.
        assert!((e / 2.0 - 1.0).abs() < 6.0 * EPS, "{e} at {x}");
    }
}

/// Cells of the furnished room: 2 on the part of a cell that is not cut out, whatever is read.
#[test]
fn cells_of_the_furnace_are_two_times_what_is_uncovered() {
    let scene = furnished_room();
    let solution = even(&scene, 2, 2.0, 1.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 3e-3);
    for read in [ReadMode::Basis, ReadMode::Direct, ReadMode::Gather] {
        let reader = Reader::new(&solution, &visibility, read, 1e-2);
        let cells = grid(&reader, [4, 4], Rates { direct: 2, indirect: 1 }, &Work::alone());
        for cell in cells.iter().filter(|cell| cell.surface < 11) {
            let [low, high] = [0, 1].map(|k| [cell.index[0], cell.index[1]].map(|i| 0.25 * (i + k) as f64));
            let shared = |k: usize, from: f64, to: f64| (high[k].min(to) - low[k].max(from)).max(0.0);
            // u and v of a polygon lie along its own axes: those of the floor are x and y.
            let covered =
                if cell.surface == 0 { shared(0, 0.2, 0.5) * shared(1, 0.3, 0.6) / cell.area } else { 0.0 };
            let exact = 2.0 * (1.0 - covered);
            let e = cell.irradiance[0];
            // Of 176 cells, by eight sequences each.
            let told = cell.uncertainty.deviation.map_or(6e-3, |deviation| deviation.absolute);
            assert!(
                (e - exact).abs() < 5.0 * told,
                "{read:?} {:?}: {e} ± {told} instead of {exact}",
                (cell.surface, cell.index)
            );
        }
    }
}

#[test]
fn tight_accuracies_are_kept_and_gathered_light_is_no_worse_than_its_polynomials() {
    let file = table("box_radiosity.json");
    let points = file["scenes"][0]["points"].as_array().expect("points are listed");
    let scene = builtin("empty-box");
    let layers = Layers { count: 2, ratio: 0.25 };
    let options = Options { order: 8, layers, eps: 1e-6, ..Options::default() };
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    let rms = |read: ReadMode, eps: f64| {
        let reader = Reader::new(&outcome.solution, &visibility, read, eps);
        let square = |point: &serde_json::Value| {
            let (a, b, exact) = (number(&point[1][0]), number(&point[1][1]), number(&point[2]));
            let (surface, place, normal, emitted) = match point[0].as_str() {
                Some("floor") => (0, [a, b, 0.0], DVec3::Z, 0.0),
                Some("ceiling") => (1, [a, b, 1.0], -DVec3::Z, 1.0),
                _ => (2, [0.0, a, b], DVec3::X, 0.0),
            };
            let standpoint = Standpoint::find(
                outcome.solution.elements(),
                &visibility,
                DVec3::from_array(place) - scene.middle,
                normal,
            );
            let point = standpoint.on().expect("it lies on a wall");
            assert_eq!(point.place.surface, surface);
            let irradiance = reader.irradiance(point.element, &point.place, point.normal).irradiance[0];
            ((emitted + 0.5 * irradiance) / exact - 1.0).powi(2)
        };
        (points.iter().map(square).sum::<f64>() / points.len() as f64).sqrt()
    };
    let polynomials = rms(ReadMode::Basis, 1e-6);
    let gathered = [1e-4, 1e-5, 1e-6].map(|eps| rms(ReadMode::Gather, eps));
    assert!(gathered[0] < 2e-4 && gathered[1] < 3e-5, "{gathered:?}");
    assert!(gathered[2] <= polynomials && polynomials < 3e-4, "{gathered:?} {polynomials}");
}
