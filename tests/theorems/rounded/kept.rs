//! Parts that must not be welded, or seen as one: small gaps beside far skies, rooms side by side, whole
//! metres on a map.

use radiosity::Work;
use radiosity::scene::{Scene, SceneBuilder};
use radiosity::solve::view_factors::ViewFactors;
use radiosity_geom::shapes::Polygon;
use radiosity_geom::{DVec3, Motion};
use radiosity_test_support::scenes::material;
use radiosity_test_support::shapes::disk;
use radiosity_test_support::solved::usual_factors as factors;

use crate::rounded::sheet::{Sheet, cuboid, placed, plate, scene, sheet};

fn factor(found: &ViewFactors, from: &str, to: &str) -> f64 {
    let place = |name: &str| found.names.iter().position(|own| own == name).expect("it is there");
    found.factor(place(from), place(to))
}

/// The factor of two unit squares that face each other at a distance d, in closed form (Howell, C-11):
/// F = 2/(π X²) { ln √((1 + X²)²/(1 + 2X²)) + 2X √(1 + X²) atan(X/√(1 + X²)) − 2X atan X }, X = 1/d.
fn facing_squares(distance: f64) -> f64 {
    let x = 1.0 / distance;
    let root = (1.0 + x * x).sqrt();
    let logarithm = ((1.0 + x * x).powi(2) / (1.0 + 2.0 * x * x)).sqrt().ln();
    2.0 / (std::f64::consts::PI * x * x)
        * (logarithm + 2.0 * x * root * (x / root).atan() - 2.0 * x * x.atan())
}

/// Two unit squares with a gap between them, fronts towards each other.
fn squares(gap: f64) -> Vec<Sheet> {
    let low = sheet("low", &[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    let high = sheet("high", &[[0.0, 0.0, gap], [0.0, 1.0, gap], [1.0, 1.0, gap], [1.0, 0.0, gap]]);
    vec![low, high]
}

#[test]
fn a_coarse_sky_does_not_close_gaps_of_small_things() {
    let turn = Motion::new(DVec3::ZERO, DVec3::new(0.2, 0.7, -0.4), 0.9, 1.0).expect("a motion");
    let single = |x: DVec3| DVec3::from_array(x.to_array().map(|x| f64::from(x as f32)));
    for size in [1e3, 1e4, 1e5] {
        let sky = sheet(
            "sky",
            &[[-size, size, size], [size, size, size], [size, -size, size], [-size, -size, size]],
        );
        let sky = placed(vec![sky], |x| single(turn.point(x)));
        let sheets: Vec<Sheet> = squares(5e-3).into_iter().chain(sky).collect();
        let found = factors(&scene(&sheets).expect("a scene"));
        let error = factor(&found, "low", "high") - facing_squares(5e-3);
        assert!(error.abs() < 1e-4, "sky of {size:e}: {error:e}");
    }
}

#[test]
fn whole_metres_far_from_the_origin_are_meant() {
    let [x, y] = [431_000.0, 5_412_000.0];
    let square = |name: &str, z: f64, up: bool| {
        let mut corners = [[x, y, z], [x + 300.0, y, z], [x + 300.0, y + 300.0, z], [x, y + 300.0, z]];
        if !up {
            corners.reverse();
        }
        sheet(name, &corners)
    };
    let scene = scene(&[square("low", 0.0, true), square("high", 2.0, false)]).expect("a scene");
    assert_eq!(scene.fitted.welded.corners, 0);
    let error = factor(&factors(&scene), "low", "high") - facing_squares(2.0 / 300.0);
    assert!(error.abs() < 1e-9, "{error:e}");
}

/// A box with its fronts inside.
fn hollow(name: &str, low: [f64; 3], high: [f64; 3]) -> Vec<Sheet> {
    let mut walls = cuboid(name, low, high, &[]);
    walls.iter_mut().for_each(|wall| wall.corners.reverse());
    walls
}

#[test]
fn rooms_side_by_side_and_shells_in_shells_stay_closed() {
    let turn = Motion::new(DVec3::ZERO, DVec3::new(0.48, 0.6, 0.64), 0.7, 1.0).expect("a motion");
    let rooms = [
        [hollow("one", [0.0; 3], [1.0; 3]), hollow("other", [1.0, 0.0, 0.0], [2.0, 1.0, 1.0])],
        [hollow("one", [0.0; 3], [3.0; 3]), hollow("other", [3.0, 0.0, 0.0], [5.0, 2.0, 3.0])],
        [hollow("one", [0.0; 3], [3.0; 3]), cuboid("skin", [0.0; 3], [3.0; 3], &[])],
        [hollow("one", [0.0; 3], [3.0; 3]), cuboid("skin", [0.0; 3], [6.0, 3.0, 3.0], &[])],
    ];
    for pair in rooms {
        for place in [|x: DVec3, _: &Motion| x, |x: DVec3, turn: &Motion| turn.point(x)] {
            let found = factors(&scene(&placed(pair.concat(), |x| place(x, &turn))).expect("a scene"));
            for (name, sum) in found.names.iter().zip(found.row_sums()) {
                let exact = if name.starts_with("skin") { 0.0 } else { 1.0 };
                assert!((sum - exact).abs() < 3e-3, "{name}: {sum}");
            }
        }
    }
}

#[test]
fn copies_are_refused_wherever_they_are() {
    let turn = Motion::new(DVec3::ZERO, DVec3::new(0.48, 0.6, 0.64), 0.7, 1.0).expect("a motion");
    let [low, _] = [0, 1].map(|k| squares(1.0).swap_remove(k));
    let copy = Sheet { name: "copy".to_owned(), ..low.clone() };
    for place in [|x: DVec3, _: &Motion| x, |x: DVec3, turn: &Motion| turn.point(x)] {
        let error = scene(&placed(vec![low.clone(), copy.clone()], |x| place(x, &turn)))
            .expect_err("one is too many");
        assert!(error.to_string().contains("coincides"), "{error}");
    }
}

#[test]
fn a_box_stands_on_a_board_whatever_its_turn() {
    for step in 0..8 {
        let turn = Motion::new(DVec3::ZERO, DVec3::new(0.3, -0.5, 0.8), 0.7 * f64::from(step), 1.0)
            .expect("a motion");
        let board = plate("board", &[[-1.0, -1.0, 0.0], [2.0, -1.0, 0.0], [2.0, 2.0, 0.0], [-1.0, 2.0, 0.0]]);
        let sheets: Vec<Sheet> = cuboid("box", [0.0; 3], [1.0; 3], &[]).into_iter().chain([board]).collect();
        let found = factors(&scene(&placed(sheets, |x| turn.point(x))).expect("a scene"));
        let contact = factor(&found, "box-bottom", "board");
        assert!((contact - 1.0).abs() < 1e-6, "turn {step}: {contact}");
    }
}

/// A floor with a plate over it under a sun seen under 0.2666° from its middle to its rim.
fn under_the_sun(distance: f64) -> Scene {
    let mut scene = SceneBuilder::new("sun", ["grey"]);
    let grey = scene.material("grey", material(0.5, 0.0));
    let shine = scene.material("shine", material(0.0, 46000.0));
    let square = |half: f64, z: f64| {
        let corners = [[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]];
        Polygon::new(corners.map(DVec3::from_array).to_vec(), Vec::new()).expect("a square")
    };
    scene.surface("floor", square(5.0, 0.0), &grey);
    scene.surface("plate", square(0.5, 1.0), &grey).two_sided();
    let radius = distance * 0.2666f64.to_radians().tan();
    let disk = disk(distance * DVec3::Z, DVec3::NEG_Z, radius);
    scene.surface("sun", disk, &shine);
    scene.build().expect("a scene")
}

#[test]
fn a_plate_casts_its_shadow_however_far_the_sun_is() {
    for distance in [1e6, 1e8, 1e10, 1.5e11] {
        let scene = under_the_sun(distance);
        let found = factors(&scene);
        let exact = 0.2666f64.to_radians().sin().powi(2);
        assert!((factor(&found, "plate", "sun") / exact - 1.0).abs() < 1e-4, "at {distance:e}");
        let solved = radiosity::solve::solved::Solved::new(
            scene,
            radiosity::solve::Options::default(),
            &Work::alone(),
        );
        let solved = solved.expect("a solution");
        let visibility = solved.visibility();
        let gather = radiosity::solve::gather::Gather::new(&solved.outcome.solution, visibility, 1e-3);
        let at = |x: f64| {
            gather.at(&radiosity::light::receiver_point::ReceiverPoint::on(
                0,
                DVec3::new(x, 0.0, 0.0),
                DVec3::Z,
            ))[0]
        };
        let open = 46000.0 * exact;
        assert!((at(3.0) / open - 1.0).abs() < 1e-2, "at {distance:e}: {} of {open}", at(3.0));
        // Under the plate comes what the floor sends up and the plate down again.
        assert!(at(0.0) < 0.1 * open, "at {distance:e}: {} of {open}", at(0.0));
    }
}

/// Tiles of a terrace beside a kerb, in single precision as modellers leave them: the edges overlap by 3e-8
/// along no common corner.
#[test]
fn tiles_whose_edges_overlap_by_rounding_touch() {
    let tile = |name: &str, x: [f32; 2], y: [f32; 2]| {
        let [[x0, x1], [y0, y1]] = [x, y].map(|pair| pair.map(f64::from));
        sheet(name, &[[x0, y0, 0.0], [x1, y0, 0.0], [x1, y1, 0.0], [x0, y1, 0.0]])
    };
    let (end, start) = (2.58_f32, f32::from_bits(2.58_f32.to_bits() - 1));
    let kerb = tile("kerb", [2.3, end], [0.0, 19.8]);
    let tiles = [tile("first", [start, 3.42], [9.22, 10.58]), tile("second", [start, 3.42], [10.58, 12.0])];
    let scene = scene(&[vec![kerb], tiles.to_vec()].concat()).expect("edges that touch do not coincide");
    assert_eq!(scene.surfaces.len(), 3);
}
