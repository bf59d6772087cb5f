//! A surface that lies on another, and the part that it covers, exchange light with each other alone.

use proptest::prelude::*;
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, Transport};
use radiosity::visibility::covered_parts::CoveredParts;
use radiosity_geom::polygon_area;
use radiosity_test_support::solved::usual_factors as factors;
use radiosity_test_support::solved::{elements_of, outcome_of};

use crate::rounded::sheet::{Sheet, cuboid, plate, room, scene, scene_lit_by, sheet, turned};

fn built(sheets: &[Sheet]) -> Scene {
    scene(sheets).expect("a scene")
}

/// The mean irradiance of every surface but the floor and the bottom of the box.
fn irradiances(sheets: &[Sheet]) -> Vec<f64> {
    let scene = scene_lit_by(sheets, |name| name == "room-top").expect("a scene");
    let options = Options {
        order: 2,
        subdivide: Some(1),
        eps: 1e-6,
        shadow_eps: 1e-5,
        direct: Direct::Projected,
        ..Options::default()
    };
    let outcome = outcome_of(&scene, &options);
    assert!(outcome.checks.row_sum_min > 0.999 && outcome.checks.row_sum_max < 1.001, "{:?}", outcome.checks);
    let others = scene.surfaces.iter().enumerate().filter(|(_, surface)| !surface.name.ends_with("bottom"));
    others.map(|(index, _)| outcome.solution.mean_irradiance(0, index)).collect()
}

#[test]
fn a_box_lights_a_room_alike_with_and_without_a_bottom() {
    let boxes = [
        ("on the floor", [1.3, 1.0, 0.0], [2.3, 1.8, 0.6]),
        ("at a wall", [0.0, 1.0, 0.0], [0.7, 1.8, 0.6]),
        ("in a corner", [0.0; 3], [0.7, 0.8, 0.5]),
    ];
    for (place, low, high) in boxes {
        // Sides at walls lie on them as the bottom lies on the floor; without them walls end at the box.
        let touching: Vec<&str> = [("bottom", low[2]), ("x0", low[0]), ("y0", low[1])]
            .iter()
            .filter(|x| x.1 == 0.0)
            .map(|x| x.0)
            .collect();
        let with = |open: &[&str]| [room(), cuboid("box", low, high, open)].concat();
        let (closed, open) = (with(&[]), with(&touching));
        let kept = |sheets: &[Sheet], values: Vec<f64>| -> Vec<f64> {
            let names = sheets.iter().map(|sheet| &sheet.name).filter(|name| !name.ends_with("bottom"));
            // Walls that are covered count as a whole in one and without what is covered in the other.
            let plain = |name: &&String| !touching.iter().any(|face| name.ends_with(face));
            names.zip(values).filter(|(name, _)| plain(name)).map(|(_, value)| value).collect()
        };
        let (a, b) = (kept(&closed, irradiances(&closed)), kept(&open, irradiances(&open)));
        let worst = a.iter().zip(&b).map(|(x, y)| (x - y).abs() / y).fold(0.0, f64::max);
        println!("box {place}: {worst:.1e}");
        assert!(a.len() == b.len() && worst < 1e-5, "box {place}: {worst:e}");
    }
}

#[test]
fn a_bottom_sees_the_floor_and_nothing_else() {
    let sheets =
        [room(), turned(cuboid("box", [1.3, 1.0, 0.0], [2.3, 1.8, 0.6], &[]), [1.8, 1.4], 0.3)].concat();
    let found = factors(&built(&sheets));
    let place = |name: &str| found.names.iter().position(|own| own == name).expect("it is there");
    let (floor, bottom) = (place("room-bottom"), place("box-bottom"));
    assert!((found.factor(bottom, floor) - 1.0).abs() < 1e-12);
    assert!((found.factor(floor, bottom) - 0.8 / 14.0).abs() < 1e-12);
}

#[test]
fn rays_light_a_room_with_a_box_on_its_floor_as_exact_transport_does() {
    // The bottom and the floor below it send no rays; they see each other alone, exactly.
    let sheets = [room(), cuboid("box", [1.3, 1.0, 0.0], [2.3, 1.8, 0.6], &[])].concat();
    let scene = scene_lit_by(&sheets, |name| name == "room-top").expect("a scene");
    let means = |transport: Transport, rays| {
        let options = Options { order: 2, transport, rays, direct: Direct::Projected, ..Options::default() };
        let outcome = outcome_of(&scene, &options);
        if let Some(sampling) = outcome.sampling {
            assert_eq!(sampling.rays, sampling.planned, "all rays are planned for what sends some");
        }
        let mean = |index| outcome.solution.mean_irradiance(0, index);
        (0..scene.surfaces.len()).map(mean).collect::<Vec<f64>>()
    };
    let (exact, rays) = (means(Transport::Exact, None), means(Transport::Sampled, Some(200_000)));
    for ((surface, exact), rays) in scene.surfaces.iter().zip(&exact).zip(&rays) {
        println!("{}: {rays:.4} by rays, {exact:.4} exactly", surface.name);
        assert!((rays - exact).abs() <= 0.03 * exact, "{}: {rays} and {exact}", surface.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Plates of two sides that overlap: parts and rest make up each surface, and rows add up.
    #[test]
    fn parts_and_rest_make_up_every_surface(
        places in prop::collection::vec((0.8f64..2.0, 0.8f64..1.6, 0.2f64..1.0, 0.2f64..1.0), 1..4),
        angle in 0.0f64..0.3,
    ) {
        assert_made_up(&places.iter().map(|(x, y, a, b)| [*x, *y, *a, *b]).collect::<Vec<_>>(), angle);
    }
}

/// The first and the last plate are side by side, each partly in front of the other side of the second.
#[test]
fn parts_and_rest_make_up_plates_side_by_side() {
    let places = [
        [1.78043561518243, 0.8, 0.2, 0.921257800087161],
        [0.8852286448933901, 1.198328411360143, 0.9206858596520442, 0.6485500713991791],
        [1.4638560362062019, 1.4303124459930716, 0.276415221543204, 0.2],
    ];
    assert_made_up(&places, 0.2732955866490863);
}

/// Parts and rest make up each surface of a room with plates of two sides on its floor, each a little higher than the
/// one before it, by their lower corners and sides; all turned by an angle.
fn assert_made_up(places: &[[f64; 4]], angle: f64) {
    let layer = |(k, [x, y, a, b]): (usize, &[f64; 4])| {
        let z = 3e-8 * (k + 1) as f64;
        plate(&format!("plate-{k}"), &[[*x, *y, z], [x + a, *y, z], [x + a, y + b, z], [*x, y + b, z]])
    };
    let plates = places.iter().enumerate().map(layer).collect();
    let sheets = [room(), turned(plates, [2.0, 1.7], angle)].concat();
    let scene = built(&sheets);
    let elements = elements_of(&scene, 0, 1);
    for (index, surface) in scene.surfaces.iter().enumerate() {
        let whole = surface.shape.region().expect("flat").area();
        let sum: f64 = elements.of_surface(index).map(|k| elements.list()[k].area).sum();
        assert!((sum / whole - 1.0).abs() < 1e-6, "{}: {sum} of {whole}", surface.name);
    }
    for cover in CoveredParts::new(&scene).list() {
        let area: f64 = cover.pieces.iter().map(|piece| polygon_area(piece)).sum();
        assert!(area > 0.0);
    }
    let sums = factors(&scene).row_sums();
    assert!(sums.iter().all(|sum| (sum - 1.0).abs() < 3e-3), "{sums:?}");
}

/// Boxes in rows on one floor: each bottom covers its base, and the floor keeps its area.
#[test]
fn many_boxes_cover_their_bases() {
    const ROWS: usize = 12;
    let place = |k: usize| [4.0 * (k % ROWS) as f64, 3.0 * (k / ROWS) as f64].map(|at| at / ROWS as f64);
    let size = |k: usize| 0.1 + 0.1 * ((7 * k) % 10) as f64 / 10.0;
    let boxes = (0..ROWS * ROWS).flat_map(|k| {
        let [x, y] = place(k);
        cuboid(&format!("box-{k}"), [x + 0.02, y + 0.01, 0.0], [x + 0.02 + size(k), y + 0.2, 0.3], &[])
    });
    let scene = built(&room().into_iter().chain(boxes).collect::<Vec<_>>());
    let floor = scene.surfaces.iter().position(|surface| surface.name == "room-bottom").expect("a floor");
    let parts = CoveredParts::new(&scene);
    let covered: f64 =
        parts.of_surface(floor).flat_map(|part| &part.pieces).map(|piece| polygon_area(piece)).sum();
    let bases: f64 = (0..ROWS * ROWS).map(|k| 0.19 * size(k)).sum();
    assert_eq!((parts.of_surface(floor).len(), parts.list().len()), (ROWS * ROWS, 2 * ROWS * ROWS));
    assert!((covered / bases - 1.0).abs() < 1e-6, "{covered} of {bases}");
    let elements = elements_of(&scene, 0, 3);
    let of_floor = || elements.list()[elements.of_surface(floor)].iter();
    let sum: f64 = of_floor().map(|element| element.area).sum();
    let whole = scene.surfaces[floor].shape.area();
    assert!((sum / whole - 1.0).abs() < 1e-9, "{sum} of {whole}");
    // Each base is found at its middle.
    let shape = elements.shape(floor);
    for (element, index) in
        of_floor().zip(elements.of_surface(floor)).filter(|(own, _)| own.contact.is_some())
    {
        let middle = element.bounds().center();
        let foot = shape.project(middle);
        assert_eq!(elements.at(floor, [foot.u, foot.v]), Some(index));
    }
}

/// A box that stands across tiles of a floor, larger than some of them, stands on all of them.
#[test]
fn a_box_stands_on_tiles() {
    let tile = |name: &str, x: [f64; 2], y: [f64; 2]| {
        sheet(name, &[[x[0], y[0], 0.0], [x[1], y[0], 0.0], [x[1], y[1], 0.0], [x[0], y[1], 0.0]])
    };
    let walls: Vec<Sheet> = room().into_iter().filter(|wall| wall.name != "room-bottom").collect();
    let strips = vec![tile("strip", [0.0, 0.5], [0.0, 3.5]), tile("rest", [0.5, 4.0], [0.0, 3.5])];
    let inner = vec![
        tile("inner", [1.0, 1.5], [1.0, 1.5]),
        tile("west", [0.0, 1.0], [0.0, 3.5]),
        tile("east", [1.5, 4.0], [0.0, 3.5]),
        tile("south", [1.0, 1.5], [0.0, 1.0]),
        tile("north", [1.0, 1.5], [1.5, 3.5]),
    ];
    for floor in [strips, inner] {
        let cuboid = cuboid("box", [0.2, 0.5, 0.0], [2.7, 3.0, 1.0], &[]);
        let found = factors(&built(&[walls.clone(), floor, cuboid].concat()));
        for (name, sum) in found.names.iter().zip(found.row_sums()) {
            assert!((sum - 1.0).abs() < 3e-3, "{name}: {sum}");
        }
    }
}

/// Three boxes side by side in a corner: their shadows run along each other, and leave slivers without width.
#[test]
fn boxes_side_by_side_in_a_corner_come_to_an_end() {
    let boxes = [
        ("a", [0.0; 3], [1.0; 3]),
        ("b", [1.0, 0.0, 0.0], [2.0, 1.0, 1.0]),
        ("c", [0.0, 1.0, 0.0], [1.0, 2.0, 1.0]),
    ];
    let boxes = boxes.into_iter().flat_map(|(name, low, high)| cuboid(name, low, high, &[])).collect();
    let scene = built(&[room(), boxes].concat());
    let outcome = outcome_of(&scene, &Options { subdivide: Some(1), ..Options::default() });
    assert!(outcome.checks.row_sum_min > 0.997 && outcome.checks.row_sum_max < 1.003, "{:?}", outcome.checks);
}
