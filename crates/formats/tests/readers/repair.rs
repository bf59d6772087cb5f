//! Repair of whole models: what is sound stays to the bit, what is not becomes sound.

use glam::{DQuat, DVec3};
use proptest::prelude::*;
use radiosity_formats::model::{Material, Model, Shape, Sides, Surface};
use radiosity_formats::repair::{Options, RepairKind, Repairs, refusal, repair};
use radiosity_geom::PlanarRegion;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note_text::NoteText;
use radiosity_test_support::random::seeded;

fn surface(name: &str, shape: Shape) -> Surface {
    Surface {
        name: name.into(),
        material: Some(0),
        shape,
        sides: Sides::Front,
        file: None,
        place: Some(FilePlace::Line(1)),
    }
}

fn polygon(points: &[[f64; 3]]) -> Shape {
    Shape::Polygon { outline: points.iter().map(|x| DVec3::from_array(*x)).collect(), holes: Vec::new() }
}

fn model(surfaces: Vec<Surface>) -> Model {
    let material = |name: &str, emission: f64| Material {
        name: name.into(),
        reflectance: vec![0.5],
        emission: vec![emission],
    };
    Model {
        bands: vec!["grey".into()],
        materials: vec![material("paint", 0.0), material("lamp", 100.0)],
        surfaces,
        ..Model::default()
    }
}

fn repaired(mut model: Model) -> (Model, Repairs) {
    let repairs = repair(&mut model, &Options::default());
    (model, repairs)
}

fn texts(repairs: &Repairs) -> Vec<&str> {
    repairs.list.iter().map(|repair| repair.text.as_str()).collect()
}

fn names(model: &Model) -> Vec<&str> {
    model.surfaces.iter().map(|surface| surface.name.as_str()).collect()
}

fn area(shape: &Shape) -> f64 {
    match shape {
        Shape::Polygon { outline, holes } => {
            PlanarRegion::new(outline.clone(), holes.clone()).expect("what was repaired is sound").area()
        }
        _ => 0.0,
    }
}

/// A square in the plane z, front up or down.
fn square(name: &str, [x, y, z]: [f64; 3], size: f64, up: bool) -> Surface {
    let mut points = [[x, y, z], [x + size, y, z], [x + size, y + size, z], [x, y + size, z]];
    if !up {
        points.reverse();
    }
    surface(name, polygon(&points))
}

/// The six faces of a box, fronts outwards or inwards.
fn cuboid(name: &str, low: DVec3, size: DVec3, is_outward: bool) -> Vec<Surface> {
    let [x, y, z] = [size.x * DVec3::X, size.y * DVec3::Y, size.z * DVec3::Z];
    let faces = [(low, y, x), (low + z, x, y), (low, x, z), (low + y, z, x), (low, z, y), (low + x, y, z)];
    let face = |(k, (at, a, b)): (usize, (DVec3, DVec3, DVec3))| {
        let mut outline = vec![at, at + a, at + a + b, at + b];
        if !is_outward {
            outline.reverse();
        }
        surface(&format!("{name}-{k}"), Shape::Polygon { outline, holes: Vec::new() })
    };
    faces.into_iter().enumerate().map(face).collect()
}

/// A room with boxes that stand on its floor and on each other, a picture, a window in a wall, a table on
/// legs, a globe and a two-sided board.
fn furnished() -> Vec<Surface> {
    let mut all = cuboid("room", DVec3::ZERO, DVec3::new(6.0, 5.0, 3.0), false);
    all.extend(cuboid("crate", DVec3::new(1.0, 1.0, 0.0), DVec3::splat(0.8), true));
    all.extend(cuboid("upper", DVec3::new(1.0, 1.0, 0.8), DVec3::splat(0.8), true));
    all.extend(cuboid("small", DVec3::new(1.2, 1.2, 1.6), DVec3::splat(0.2), true));
    all.extend(cuboid("at the wall", DVec3::new(5.0, 2.0, 0.0), DVec3::new(1.0, 0.7, 1.3), true));
    all.push(surface(
        "picture",
        polygon(&[[0.0, 2.0, 1.0], [0.0, 3.0, 1.0], [0.0, 3.0, 2.0], [0.0, 2.0, 2.0]]),
    ));
    let mut lamp = square("lamp", [2.0, 2.0, 2.9], 0.5, false);
    lamp.material = Some(1);
    all.push(lamp);
    let mut board = square("board", [3.0, 3.0, 1.1], 1.0, true);
    board.sides = Sides::Both;
    all.push(board);
    let center = DVec3::new(4.0, 1.0, 1.0);
    all.push(surface("globe", Shape::Sphere { center, radius: 0.3, inward: false }));
    let axis = 0.7 * DVec3::Z;
    all.push(surface(
        "leg",
        Shape::Cylinder { base: center - axis - 0.3 * DVec3::Z, axis, radius: 0.05, inward: false },
    ));
    let outline = [[2.0, 4.0, 0.5], [3.0, 4.0, 0.5], [3.0, 4.0, 1.5], [2.0, 4.0, 1.5]].map(DVec3::from_array);
    let hole = [[2.2, 4.0, 0.7], [2.8, 4.0, 0.7], [2.5, 4.0, 1.2]].map(DVec3::from_array);
    all.push(surface("frame", Shape::Polygon { outline: outline.to_vec(), holes: vec![hole.to_vec()] }));
    let bent = [[3.0, 4.5, 0.1], [3.5, 4.5, 0.1], [3.5, 4.7, 0.6], [3.0, 4.7, 0.3]].map(DVec3::from_array);
    all.push(surface("sail", Shape::Quad(bent)));
    all
}

/// The surfaces turned, moved and scaled.
fn placed(surfaces: Vec<Surface>, turn: DQuat, by: DVec3, scale: f64) -> Vec<Surface> {
    let at = |x: DVec3| scale * (turn * x) + by;
    let along = |x: DVec3| scale * (turn * x);
    let ring = |ring: Vec<DVec3>| ring.into_iter().map(at).collect();
    let shape = |shape: Shape| match shape {
        Shape::Polygon { outline, holes } => {
            Shape::Polygon { outline: ring(outline), holes: holes.into_iter().map(ring).collect() }
        }
        Shape::Quad(corners) => Shape::Quad(corners.map(at)),
        Shape::Sphere { center, radius, inward } => {
            Shape::Sphere { center: at(center), radius: scale * radius, inward }
        }
        Shape::Cylinder { base, axis, radius, inward } => {
            Shape::Cylinder { base: at(base), axis: along(axis), radius: scale * radius, inward }
        }
        shape => shape,
    };
    surfaces.into_iter().map(|surface| Surface { shape: shape(surface.shape), ..surface }).collect()
}

/// A whole number, one that misses it by rounding, or any other.
fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (0..5u8).prop_map(f64::from),
        1 => (0..5u8, -3e-10..3e-10f64).prop_map(|(whole, rounding)| f64::from(whole) + rounding),
        1 => 0.0..5.0f64,
    ]
}

proptest! {
    #![proptest_config(seeded(128, 7))]

    /// A sound model comes out equal to the bit, wherever it stands and however it is turned.
    #[test]
    fn what_is_sound_stays_to_the_bit(
        axis in prop::array::uniform3(-2.0..2.0f64),
        by in prop::array::uniform3(-50.0..50.0f64),
        scale in -3.0..3.0f64,
        is_turned in prop::bool::ANY,
        is_single in prop::bool::ANY,
    ) {
        let turn = if is_turned { DQuat::from_scaled_axis(DVec3::from_array(axis)) } else { DQuat::IDENTITY };
        let mut surfaces = placed(furnished(), turn, DVec3::from_array(by), 10.0_f64.powf(scale));
        if is_single && scale > 0.0 {
            let single = |x: &mut DVec3| *x = x.as_vec3().as_dvec3();
            for surface in &mut surfaces {
                if let Shape::Polygon { outline, holes } = &mut surface.shape {
                    outline.iter_mut().chain(holes.iter_mut().flatten()).for_each(single);
                }
            }
        }
        let before = model(surfaces);
        let (after, repairs) = repaired(before.clone());
        prop_assert!(repairs.is_empty(), "{:#?}", texts(&repairs));
        prop_assert_eq!(before, after);
    }

    /// Any ring of few points, most of them on a grid or beside it by rounding so that all kinds of contacts
    /// occur, becomes sound polygons, and repairing them again changes nothing.
    #[test]
    fn any_ring_becomes_sound(
        points in prop::collection::vec([coordinate(), coordinate()], 3..12),
        hole in prop::collection::vec([coordinate(), coordinate()], 0..6),
        axis in prop::array::uniform3(-2.0..2.0f64),
        is_turned in prop::bool::ANY,
    ) {
        let turn = if is_turned { DQuat::from_scaled_axis(DVec3::from_array(axis)) } else { DQuat::IDENTITY };
        let at = |[x, y]: &[f64; 2]| turn * DVec3::new(*x, *y, 0.7);
        let outline: Vec<DVec3> = points.iter().map(at).collect();
        let holes: Vec<Vec<DVec3>> = (hole.len() > 2).then(|| hole.iter().map(at).collect()).into_iter().collect();
        let before = model(vec![surface("face", Shape::Polygon { outline, holes })]);
        let (after, repairs) = repaired(before.clone());
        if repairs.is_empty() {
            prop_assert_eq!(&before, &after);
        }
        for surface in &after.surfaces {
            let Shape::Polygon { outline, holes } = &surface.shape else { continue };
            let region = PlanarRegion::new(outline.clone(), holes.clone());
            prop_assert!(region.is_ok(), "{:?} from {:?}: {:?}", surface.shape, before.surfaces, region.err());
        }
        let (again, more) = repaired(after.clone());
        prop_assert!(more.is_empty(), "{:#?}", texts(&more));
        prop_assert_eq!(after, again);
    }

    /// Squares thrown into one plane: afterwards those that lay partly on others cover the same place once,
    /// and every coordinate that was cut nowhere is the old one.
    #[test]
    fn partly_covered_squares_cover_their_union_once(
        places in prop::collection::vec((0..24u8, 0..24u8, 4..9u8), 2..7),
        axis in prop::array::uniform3(-2.0..2.0f64),
        is_turned in prop::bool::ANY,
    ) {
        let turn = if is_turned { DQuat::from_scaled_axis(DVec3::from_array(axis)) } else { DQuat::IDENTITY };
        let squares = places.iter().enumerate().map(|(k, (x, y, size))| {
            let (x, y, size) = (f64::from(*x) + 0.01 * k as f64, f64::from(*y) + 0.01 * k as f64, f64::from(*size));
            square(&format!("square-{k}"), [x, y, 0.3], size, true)
        });
        let before = placed(squares.collect(), turn, DVec3::ZERO, 1.0);
        let (after, _) = repaired(model(before));
        let covered: f64 = after.surfaces.iter().map(|surface| area(&surface.shape)).sum();
        let is_in = |x: f64, y: f64| places.iter().enumerate().any(|(k, (a, b, size))| {
            let (a, b, size) = (f64::from(*a) + 0.01 * k as f64, f64::from(*b) + 0.01 * k as f64, f64::from(*size));
            a < x && x < a + size && b < y && y < b + size
        });
        // All borders are multiples of 0.01, so that the middles of cells decide exactly.
        let hundredths = |count: usize| (0..count).map(|k| 0.01 * k as f64 + 0.005);
        let mut lines: Vec<(f64, f64)> = Vec::new();
        let mut edges: Vec<f64> = places.iter().enumerate().flat_map(|(k, (a, _, size))| {
            let low = f64::from(*a) + 0.01 * k as f64;
            [low, low + f64::from(*size)]
        }).collect();
        edges.sort_by(f64::total_cmp);
        for pair in edges.windows(2) {
            let middle = 0.5 * (pair[0] + pair[1]);
            let height = 0.01 * hundredths(3400).filter(|y| is_in(middle, *y)).count() as f64;
            lines.push((pair[1] - pair[0], height));
        }
        let union: f64 = lines.iter().map(|(width, height)| width * height).sum();
        let pictures: f64 = covered - union;
        // What lies wholly on another one is set apart by the scene and stays; it alone is counted twice.
        let nested: f64 = after.surfaces.iter().enumerate().map(|(k, own)| {
            let mut others = after.surfaces.iter().enumerate().filter(|(l, _)| *l != k);
            if others.any(|(_, other)| lies_in(own, other)) { area(&own.shape) } else { 0.0 }
        }).sum();
        prop_assert!((pictures - nested).abs() < 1e-6, "{covered} {union} {nested}");
    }
}

/// A length that readers let pass, sensible or not.
fn any_length() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (-2..3i8).prop_map(f64::from),
        1 => prop::sample::select(vec![1e-300, 5e-324, 1e-9, 1e9, 1e59, -1e59, 1e200, -1e300, f64::MAX]),
        1 => -2.0..2.0f64,
    ]
}

fn any_point() -> impl Strategy<Value = DVec3> {
    [any_length(), any_length(), any_length()].prop_map(DVec3::from_array)
}

fn any_shape() -> impl Strategy<Value = Shape> {
    let size = || any_length().prop_map(f64::abs);
    let ring = |least: usize| prop::collection::vec(any_point(), least..7);
    let cone = (any_point(), any_point(), [size(), size()], prop::bool::ANY)
        .prop_map(|(base, axis, radii, inward)| Shape::Cone { base, axis, radii, inward });
    prop_oneof![
        6 => (ring(3), prop::collection::vec(ring(0), 0..2))
            .prop_map(|(outline, holes)| Shape::Polygon { outline, holes }),
        1 => [any_point(), any_point(), any_point(), any_point()].prop_map(Shape::Quad),
        2 => (any_point(), any_point(), size(), size())
            .prop_map(|(center, normal, radius, inner)| Shape::Disk { center, normal, radius, inner }),
        1 => (any_point(), any_point(), size(), prop::bool::ANY)
            .prop_map(|(base, axis, radius, inward)| Shape::Cylinder { base, axis, radius, inward }),
        1 => cone,
        1 => (any_point(), size(), prop::bool::ANY)
            .prop_map(|(center, radius, inward)| Shape::Sphere { center, radius, inward }),
    ]
}

proptest! {
    #![proptest_config(seeded(256, 7))]

    /// Whatever numbers a file has, repair ends, and names stay unique.
    #[test]
    fn no_shape_is_too_odd(
        shapes in prop::collection::vec((any_shape(), 0..3usize), 1..9),
        fix_fronts in prop::bool::ANY,
    ) {
        let sides = [Sides::Front, Sides::Both, Sides::Open];
        let named = |(k, (shape, side)): (usize, (Shape, usize))| {
            Surface { sides: sides[side], ..surface(&format!("odd-{k}"), shape) }
        };
        let mut odd = model(shapes.into_iter().enumerate().map(named).collect());
        repair(&mut odd, &Options { fix_fronts, ..Options::default() });
        let mut unique = names(&odd);
        unique.sort_unstable();
        unique.dedup();
        prop_assert_eq!(unique.len(), odd.surfaces.len());
    }
}

/// Whether a face lies wholly in another one.
fn lies_in(own: &Surface, other: &Surface) -> bool {
    let region = |surface: &Surface| match &surface.shape {
        Shape::Polygon { outline, holes } => PlanarRegion::new(outline.clone(), holes.clone()).ok(),
        _ => None,
    };
    let (Some(own), Some(other)) = (region(own), region(other)) else { return false };
    let common: f64 = own.common_parts(&other).map(|part| radiosity_geom::polygon_area(&part)).sum();
    common > (1.0 - 1e-6) * own.area()
}

#[test]
fn of_copies_the_emitter_is_kept_or_else_the_first() {
    let mut lamp = square("lamp", [0.0, 0.0, 0.0], 1.0, true);
    lamp.material = Some(1);
    let desk = square("desk", [0.0, 0.0, 0.0], 1.0, true);
    let (after, repairs) = repaired(model(vec![desk.clone(), lamp]));
    assert_eq!(
        (names(&after), texts(&repairs)),
        (vec!["lamp"], vec![r#""desk" and "lamp" coincide; "desk" was removed"#])
    );
    let mut copy = square("copy", [0.0, 0.0, 0.0], 1.0, true);
    if let Shape::Polygon { outline, .. } = &mut copy.shape {
        // Another first vertex and a point of no effect.
        outline.rotate_left(2);
        outline.insert(1, 0.5 * (outline[0] + outline[1]));
    }
    let (after, repairs) = repaired(model(vec![desk, copy]));
    assert_eq!((names(&after), repairs.count(RepairKind::Coincident)), (vec!["desk"], 1));
    assert_eq!(repairs.list[0].surfaces, ["desk", "copy"]);
}

#[test]
fn two_sides_of_a_sheet_become_one_surface_or_front_and_back() {
    let [front, back] = [("front", true), ("back", false)].map(|(name, up)| square(name, [0.0; 3], 1.0, up));
    let (after, repairs) = repaired(model(vec![front.clone(), back.clone()]));
    assert_eq!((names(&after), after.surfaces[0].sides), (vec!["front"], Sides::Both));
    assert_eq!(repairs.count(RepairKind::Coincident), 1);
    let (after, _) = repaired(model(vec![front.clone(), Surface { material: Some(1), ..back.clone() }]));
    assert_eq!(names(&after), ["front", "front:back"]);
    assert!(after.surfaces.iter().all(|surface| surface.sides == Sides::Front));
    // Of two-sided ones the second is one too many.
    let [front, back] = [front, back].map(|surface| Surface { sides: Sides::Both, ..surface });
    assert_eq!(names(&repaired(model(vec![front, back])).0), ["front"]);
}

#[test]
fn curved_copies_are_found_however_they_are_given() {
    let cylinder = |base: f64, axis: f64, inward| Shape::Cylinder {
        base: base * DVec3::Z,
        axis: axis * DVec3::Z,
        radius: 1.0,
        inward,
    };
    let cone = Shape::Cone { base: DVec3::ZERO, axis: 2.0 * DVec3::Z, radii: [1.0, 1.0], inward: false };
    let pair = |second: Shape| model(vec![surface("one", cylinder(0.0, 2.0, false)), surface("two", second)]);
    for second in [cylinder(0.0, 2.0, false), cylinder(2.0, -2.0, false), cone] {
        assert_eq!(names(&repaired(pair(second)).0), ["one"]);
    }
    let (after, _) = repaired(pair(cylinder(0.0, 2.0, true)));
    assert_eq!((names(&after), after.surfaces[0].sides), (vec!["one"], Sides::Both));
    let (after, repairs) = repaired(pair(cylinder(2.0, 2.0, false)));
    assert!(after == pair(cylinder(2.0, 2.0, false)) && repairs.is_empty());
    let (after, repairs) = repaired(pair(cylinder(1.0, 1.5, false)));
    assert_eq!(texts(&repairs), [r#""two" lies partly in "one"; it was raised slightly"#]);
    let Shape::Cylinder { radius, .. } = after.surfaces[1].shape else { panic!("it stays a cylinder") };
    assert!(radius > 1.0 && radius < 1.0 + 1e-6);
}

#[test]
fn mantles_that_agree_to_rounding_are_found_whatever_their_radius() {
    let pipe = |name: &str, x: f64, z: f64, radius: f64| {
        surface(name, Shape::Cylinder { base: DVec3::new(x, 0.0, z), axis: DVec3::Z, radius, inward: false })
    };
    for middle in [0.5, 0.500_000_005, 0.500_000_007_3] {
        let pipes = vec![
            pipe("wide", 0.0, 9.0, 1.0),
            pipe("low", 0.0, 0.0, middle - 1e-12),
            pipe("high", 0.0, 0.5, middle + 1e-12),
            pipe("beside", 0.4, 0.5, middle),
        ];
        let (_, repairs) = repaired(model(pipes));
        assert_eq!(texts(&repairs), [r#""high" lies partly in "low"; it was raised slightly"#], "{middle}");
    }
}

#[test]
fn a_rug_half_over_the_edge_is_cut_out_of_its_floor() {
    let floor = square("floor", [0.0; 3], 4.0, true);
    let rug = square("rug", [3.0, 1.0, 0.0], 2.0, true);
    let (after, repairs) = repaired(model(vec![floor.clone(), rug.clone()]));
    assert_eq!(
        texts(&repairs),
        [r#""rug" shares a part of the place of "floor"; that part of "floor" was cut out"#]
    );
    assert!(names(&after) == ["floor", "rug"] && after.surfaces[1] == rug);
    assert!((area(&after.surfaces[0].shape) - 14.0).abs() < 1e-9);
    // A lamp is not cut by what does not emit.
    let mut lamp = floor;
    lamp.material = Some(1);
    let (after, _) = repaired(model(vec![lamp.clone(), rug]));
    assert!(after.surfaces[0] == lamp && (area(&after.surfaces[1].shape) - 2.0).abs() < 1e-9);
}

#[test]
fn a_runner_across_its_floor_leaves_two_parts() {
    let runner =
        surface("runner", polygon(&[[1.0, -1.0, 0.0], [2.0, -1.0, 0.0], [2.0, 5.0, 0.0], [1.0, 5.0, 0.0]]));
    let (after, _) = repaired(model(vec![square("floor", [0.0; 3], 4.0, true), runner]));
    assert_eq!(names(&after), ["floor-1", "floor-2", "runner"]);
    let corners: Vec<DVec3> = after.surfaces[..2]
        .iter()
        .flat_map(|surface| match &surface.shape {
            Shape::Polygon { outline, .. } => outline.clone(),
            _ => Vec::new(),
        })
        .collect();
    let given = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 4.0, 0.0], [0.0, 4.0, 0.0]].map(DVec3::from_array);
    assert!(given.iter().all(|x| corners.contains(x)) && corners.iter().all(|x| x.z == 0.0));
}

#[test]
fn what_turns_its_face_to_a_wall_is_removed_unless_it_emits() {
    let floor = square("floor", [0.0; 3], 4.0, true);
    let mut rug = square("rug", [1.0, 1.0, 0.0], 2.0, false);
    let (after, repairs) = repaired(model(vec![floor.clone(), rug.clone()]));
    assert_eq!((names(&after), repairs.count(RepairKind::Overlap)), (vec!["floor"], 1));
    rug.material = Some(1);
    let (after, _) = repaired(model(vec![floor, rug.clone()]));
    assert!(after.surfaces[1] == rug && (area(&after.surfaces[0].shape) - 12.0).abs() < 1e-9);
}

#[test]
fn slivers_and_impossible_reflectances_go() {
    let needle = surface("needle", polygon(&[[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-9, 0.0]]));
    let mut before = model(vec![needle, square("desk", [0.0; 3], 1.0, true)]);
    before.materials[0].reflectance = vec![1.0];
    before.materials[1].reflectance = vec![-0.25];
    let (after, repairs) = repaired(before);
    assert_eq!(names(&after), ["desk"]);
    assert_eq!((after.materials[0].reflectance[0], after.materials[1].reflectance[0]), (0.999, 0.0));
    assert_eq!(
        texts(&repairs),
        [
            r#"reflectance of material "paint": 1 became 0.999"#,
            r#"reflectance of material "lamp": -0.25 became 0"#,
            r#""needle" has no area; it was removed"#,
        ]
    );
}

#[test]
fn fronts_are_turned_only_when_asked() {
    let before = || {
        let mut all = cuboid("room", DVec3::ZERO, DVec3::splat(9.0), false);
        all.extend(cuboid("box", DVec3::splat(2.0), DVec3::ONE, false));
        all.extend(cuboid("other", DVec3::splat(5.0), DVec3::ONE, true));
        model(all)
    };
    let (after, repairs) = repaired(before());
    assert!(after == before() && repairs.count(RepairKind::DoubtfulFronts) == 1);
    let mut fixed = before();
    let repairs = repair(&mut fixed, &Options { fix_fronts: true, ..Options::default() });
    assert_eq!(repairs.count(RepairKind::Fronts), 1);
    assert!(
        repairs.list[0]
            .text
            .ends_with("enclose nothing and show their fronts inwards; they were turned over")
    );
    assert!(repaired(fixed).1.is_empty());
}

#[test]
fn open_sides_are_settled_as_asked() {
    let mut open = model(vec![square("desk", [0.0; 3], 1.0, true)]);
    open.surfaces[0].sides = Sides::Open;
    for (asked, expected) in
        [(None, Sides::Front), (Some(Sides::Front), Sides::Front), (Some(Sides::Both), Sides::Both)]
    {
        let mut model = open.clone();
        repair(&mut model, &Options { sides: asked, ..Options::default() });
        assert_eq!(model.surfaces[0].sides, expected);
    }
}

#[test]
fn a_refusal_tells_the_first_repair() {
    assert!(refusal(&Repairs::default(), "room.obj", NoteText::to_string).is_none());
    let desk = || square("desk", [0.0; 3], 1.0, true);
    let (_, repairs) = repaired(model(vec![desk(), Surface { name: "again".into(), ..desk() }]));
    let told = refusal(&repairs, "room.obj", NoteText::to_string).expect("a copy is at fault");
    assert_eq!(told.to_string(), r#"room.obj:1: "desk" and "again" coincide; "again" was removed"#);
    assert!(told.cure.contains("mend the file"));
    // What was left as it is was not repaired.
    let boxes = cuboid("box", DVec3::ZERO, DVec3::ONE, false);
    let (_, left) = repaired(model([boxes, vec![square("sign", [5.0; 3], 1.0, true)]].concat()));
    assert_eq!(
        (left.count(RepairKind::DoubtfulFronts), refusal(&left, "room.obj", NoteText::to_string)),
        (1, None)
    );
}

#[test]
fn of_faces_that_show_opposite_fronts_the_smaller_area_is_turned_and_none_of_halves() {
    // A floor and a wall that meet at a side and show opposite fronts.
    let fold = |height: f64| {
        let floor = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
        let wall = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 0.0, height], [0.0, 0.0, height]]);
        model(vec![surface("floor", floor), surface("wall", wall)])
    };
    let fixed = |height: f64| {
        let mut model = fold(height);
        let repairs = repair(&mut model, &Options { fix_fronts: true, ..Options::default() });
        let changed: Vec<String> = fold(height)
            .surfaces
            .iter()
            .zip(&model.surfaces)
            .filter(|(before, after)| before != after)
            .map(|(own, _)| own.name.clone())
            .collect();
        (changed, texts(&repairs).concat())
    };
    assert_eq!(fixed(0.5).0, ["wall"]);
    assert_eq!(fixed(2.0).0, ["floor"]);
    let (changed, told) = fixed(1.0);
    assert!(changed.is_empty());
    assert_eq!(
        told,
        r#""wall" shows its front where "floor" beside has its back, of equal areas; it was left so"#
    );
}

#[test]
fn a_fan_of_many_crossings_is_mended() {
    // A star polygon {n/k} has k − 1 crossings on each side; the even–odd rule leaves rings of alternate
    // depth.
    let (count, step) = (201, 80);
    let corner = |k: usize| {
        let angle = std::f64::consts::TAU * (k * step % count) as f64 / count as f64;
        [angle.cos(), angle.sin(), 0.0]
    };
    let star: Vec<[f64; 3]> = (0..count).map(corner).collect();
    let (after, repairs) = repaired(model(vec![surface("star", polygon(&star))]));
    assert!(repairs.count(RepairKind::Outline) == 1 && after.surfaces.len() > 1000);
}

#[test]
fn a_tolerance_makes_near_points_one() {
    let mut points = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.001, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
    let before = |points: &[[f64; 3]]| model(vec![surface("desk", polygon(points))]);
    assert!(repaired(before(&points)).1.is_empty());
    let mut asked = before(&points);
    repair(&mut asked, &Options { tolerance: Some(0.01), ..Options::default() });
    points.remove(2);
    assert_eq!(asked.surfaces, before(&points).surfaces);
}
