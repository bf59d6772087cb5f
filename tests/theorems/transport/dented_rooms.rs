//! Two hundred random rooms, convex or with one wall dented by 3·10⁻⁸ to 0.1 of their size: what is found to
//! hide nothing, before any ray, against segments tested against all surfaces.

use std::f64::consts::TAU;
use std::sync::Arc;

use radiosity::geom::shapes::{Bezier, Cone, Cylinder, Disk, Extrusion, FULL_TURN, Polygon, Sphere};
use radiosity::geom::{DVec3, Flipped, Surface};
use radiosity::scene::Scene;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::shining;

const ROOMS: u64 = 200;
/// Random pairs of points of a room.
const PAIRS: usize = 300;
/// Chords through the dent of a room.
const CHORDS: usize = 40;

type Shape = Arc<dyn Surface>;

/// Surfaces that face the inside, and a chord through the dent.
struct Room {
    shapes: Vec<Shape>,
    /// A point outside of the room, within the dent, and a direction in which chords through it leave the
    /// dent both ways, turned by the dent's share of the size at the most.
    chord: Option<[DVec3; 2]>,
    dent: f64,
}

fn flipped(shape: impl Surface + 'static) -> Shape {
    Arc::new(Flipped::new(Box::new(shape)))
}

fn disk(height: f64, radius: f64, side: f64) -> Shape {
    let center = height * DVec3::Z;
    Arc::new(Disk::new(center, side * DVec3::Z, radius, 0.0, FULL_TURN).expect("a disc"))
}

fn polygon(corners: Vec<DVec3>) -> Shape {
    Arc::new(Polygon::new(corners, vec![]).expect("a polygon"))
}

/// The wall of a frustum between two heights.
fn slope([low, high]: [f64; 2], [below, above]: [f64; 2]) -> Shape {
    let (base, axis) = (low * DVec3::Z, (high - low) * DVec3::Z);
    match below == above {
        true => flipped(Cylinder::new(base, axis, below, FULL_TURN).expect("a cylinder")),
        false => flipped(Cone::new(base, axis, below, above, FULL_TURN).expect("a cone")),
    }
}

/// A prism, of which the first side may be dented at its middle.
fn prism(random: &mut Random, dent: f64) -> Room {
    let (sides, height) = (3 + random.below(5), random.between(0.5, 2.0));
    let corner = |k: usize, z: f64| {
        let (sin, cos) = (k as f64 / sides as f64 * TAU).sin_cos();
        DVec3::new(cos, sin, z)
    };
    let ring = |z: f64| (0..sides).map(move |k| corner(k, z));
    let mut shapes = vec![polygon(ring(0.0).collect()), polygon(ring(height).rev().collect())];
    let outline = |k: usize| [corner(k, 0.0), corner(k, height), corner(k + 1, height), corner(k + 1, 0.0)];
    shapes.extend((1..sides).map(|k| polygon(outline(k).to_vec())));
    let wall = outline(0);
    if dent == 0.0 {
        shapes.push(polygon(wall.to_vec()));
        return Room { shapes, chord: None, dent };
    }
    // Corners nearer to a plane than 10⁻⁶ of the extent are moved into it when a scene is made.
    let dent = dent.max(3e-6);
    let middle = wall.iter().sum::<DVec3>() / 4.0;
    let inward = -(middle - 0.5 * height * DVec3::Z).normalize();
    let top = middle + dent * inward;
    shapes.extend((0..4).map(|k| polygon(vec![wall[k], wall[(k + 1) % 4], top])));
    Room { shapes, chord: Some([middle + 0.5 * dent * inward, DVec3::Z]), dent }
}

/// A can or a frustum, of which the wall may have a waist.
fn frustum(random: &mut Random, dent: f64) -> Room {
    let radii = [1.0, if random.below(2) == 0 { 1.0 } else { random.between(0.3, 1.0) }];
    let height = random.between(0.5, 2.0);
    let mut shapes = vec![disk(0.0, radii[0], 1.0), disk(height, radii[1], -1.0)];
    if dent == 0.0 {
        shapes.push(slope([0.0, height], radii));
        return Room { shapes, chord: None, dent };
    }
    let (middle, radius) = (0.5 * height, 0.5 * (radii[0] + radii[1]));
    let waist = radius - dent;
    shapes.extend([slope([0.0, middle], [radii[0], waist]), slope([middle, height], [waist, radii[1]])]);
    let (sin, cos) = random.between(0.0, TAU).sin_cos();
    let radial = DVec3::new(cos, sin, 0.0);
    let along = height * DVec3::Z + (radii[1] - radii[0]) * radial;
    let place = middle * DVec3::Z + (radius - 0.5 * dent) * radial;
    Room { shapes, chord: Some([place, along.normalize()]), dent }
}

/// A can whose lid may reach out of the wall on one side.
fn shifted_lid(random: &mut Random, dent: f64) -> Room {
    let height = random.between(0.5, 2.0);
    let (sin, cos) = random.between(0.0, TAU).sin_cos();
    let radial = DVec3::new(cos, sin, 0.0);
    let lid = Disk::new(height * DVec3::Z + dent * radial, -DVec3::Z, 1.0, 0.0, FULL_TURN).expect("a disc");
    let shapes = vec![disk(0.0, 1.0, 1.0), Arc::new(lid) as Shape, slope([0.0, height], [1.0; 2])];
    // A chord from below the overhang down and inwards.
    let place = (1.0 + 0.5 * dent) * radial + (1.0 - 0.1 * dent) * height * DVec3::Z;
    let along = (height * DVec3::Z + radial).normalize();
    Room { shapes, chord: (dent > 0.0).then_some([place, along]), dent }
}

/// A part of a ball over a floor, of which the top may be pushed in.
fn dome(random: &mut Random, dent: f64) -> Room {
    let low = random.between(-0.6, 0.4);
    let ball = |range: [f64; 2]| {
        flipped(Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, range, FULL_TURN).expect("a part of a ball"))
    };
    let floor = disk(low, (1.0 - low * low).sqrt(), 1.0);
    if dent == 0.0 {
        return Room { shapes: vec![floor, ball([low, 1.0])], chord: None, dent };
    }
    let ring = random.between(0.6, 0.8);
    let radius = f64::sqrt(1.0 - ring * ring);
    let funnel =
        Cone::new((ring - dent) * DVec3::Z, dent * DVec3::Z, 0.0, radius, FULL_TURN).expect("a cone");
    let shapes = vec![floor, ball([low, ring]), Arc::new(funnel) as Shape];
    let (sin, cos) = random.between(0.0, TAU).sin_cos();
    Room { shapes, chord: Some([(ring - 0.5 * dent) * DVec3::Z, DVec3::new(cos, sin, 0.0)]), dent }
}

/// A barrel vault, of which the crown may be pushed in; extruded, or of bicubic patches.
fn vault(random: &mut Random, dent: f64) -> Room {
    let (spring, rise, length) =
        (random.between(0.3, 1.0), random.between(0.2, 0.9), random.between(0.5, 2.0));
    let point = |x: f64, z: f64| DVec3::new(x, 0.0, spring + z);
    let curve = [point(-1.0, 0.0), point(-1.0, rise), point(1.0, rise), point(1.0, 0.0)];
    let along = length * DVec3::Y;
    let third = |k: usize| k as f64 / 3.0;
    let is_extruded = random.below(2) == 0;
    let roof = |curve: [DVec3; 4]| match is_extruded {
        true => flipped(Extrusion::new(curve, along).expect("a roof")),
        false => {
            let net = curve.map(|x| std::array::from_fn(|k| x + third(k) * along));
            flipped(Bezier::new(net).expect("a roof"))
        }
    };
    let ground = |k: usize| DVec3::new(2.0 * third(k) - 1.0, 0.0, 0.0);
    let end = |y: DVec3| -> [[DVec3; 4]; 4] {
        std::array::from_fn(|i| std::array::from_fn(|j| y + ground(j).lerp(curve[j], third(i))))
    };
    let [west, east] = [0, 3].map(|k| [ground(k), ground(k) + spring * DVec3::Z]);
    let side = |[low, high]: [DVec3; 2]| vec![low, low + along, high + along, high];
    let mut shapes = vec![
        polygon(vec![west[0], east[0], east[0] + along, west[0] + along]),
        polygon(side(west)),
        polygon(side(east).into_iter().rev().collect()),
        flipped(Bezier::new(end(DVec3::ZERO)).expect("an end")),
        Arc::new(Bezier::new(end(along)).expect("an end")) as Shape,
    ];
    if dent == 0.0 {
        shapes.push(roof(curve));
        return Room { shapes, chord: None, dent };
    }
    // As a prism's.
    let dent = dent.max(3e-6);
    // From the shoulders a groove of two flat strips runs along the crown.
    let west = start_of(curve, 0.4);
    let [d, c, b, a] = curve;
    let [third, second, first, shoulder] = start_of([a, b, c, d], 0.4);
    let east = [shoulder, first, second, third];
    let bottom = 0.5 * (west[3] + shoulder) - dent * DVec3::Z;
    let strip = |from: DVec3, to: DVec3| polygon(vec![from, from + along, to + along, to]);
    shapes.extend([roof(west), roof(east), strip(west[3], bottom), strip(bottom, shoulder)]);
    Room { shapes, chord: Some([bottom + 0.5 * dent * DVec3::Z + 0.5 * along, DVec3::X]), dent }
}

/// The part from 0 to `s` of a cubic Bézier curve, by de Casteljau's scheme.
fn start_of([a, b, c, d]: [DVec3; 4], s: f64) -> [DVec3; 4] {
    let [ab, bc, cd] = [a.lerp(b, s), b.lerp(c, s), c.lerp(d, s)];
    let [abc, bcd] = [ab.lerp(bc, s), bc.lerp(cd, s)];
    [a, ab, abc, abc.lerp(bcd, s)]
}

fn room(seed: u64) -> Room {
    let mut random = Random(seed);
    let dent = if seed.is_multiple_of(4) { 0.0 } else { random.power(-7.5, -1.0) };
    match (seed / 4) % 5 {
        0 => prism(&mut random, dent),
        1 => frustum(&mut random, dent),
        2 => dome(&mut random, dent),
        3 => vault(&mut random, dent),
        _ => shifted_lid(&mut random, dent),
    }
}

/// The pairs of surfaces of a room: what may hide parts of one from parts of the other.
struct Seen {
    visibility: Visibility,
    blockers: Vec<Vec<usize>>,
    count: usize,
}

impl Seen {
    fn of(scene: &Scene) -> Self {
        let visibility = Visibility::new(scene, Shadows::Auto, 1e-9);
        let count = scene.surfaces.len();
        let found = |i: usize, j: usize| {
            let [a, b] = [i, j].map(|k| visibility.hull(k));
            let mut found = visibility.candidates(a, b, [i, j]);
            found.extend(visibility.hiding_themselves([i, j], [a, b]));
            found
        };
        let blockers = (0..count * count).map(|k| found(k / count, k % count)).collect();
        Self { visibility, blockers, count }
    }

    /// Whether a segment is free by the blockers that are found, and by all surfaces.
    fn free(&self, [(i, x), (j, y)]: [(usize, DVec3); 2]) -> [bool; 2] {
        let all: Vec<usize> = (0..self.count).collect();
        [&self.blockers[i * self.count + j], &all]
            .map(|blockers| self.visibility.free_between([i, j], blockers, x, y))
    }

    /// Whether no surface is taken to hide nothing between points that it stands between; the first point may
    /// lie in the air.
    fn contains_rightly(&self, [(_, x), (j, y)]: [(usize, DVec3); 2]) -> bool {
        let visibility = &self.visibility;
        let taken = |k: &usize| visibility.contains(*k, &[x]) && visibility.encloses(*k, j);
        (0..self.count).filter(taken).all(|k| !visibility.blocks(k, x, y, 1e-6))
    }
}

/// Two random points whose fronts face each other.
fn pair(scene: &Scene, random: &mut Random) -> Option<[(usize, DVec3); 2]> {
    let ends: [_; 2] = std::array::from_fn(|_| {
        let index = random.below(scene.surfaces.len());
        let shape = &scene.surfaces[index].shape;
        let jet = shape.jet(random.signed(), random.signed());
        (index, jet, shape.region().is_none_or(|region| region.contains(jet.position)))
    });
    let way = ends[1].1.position - ends[0].1.position;
    let faces = way.dot(ends[0].1.normal) > 1e-6 && way.dot(ends[1].1.normal) < -1e-6;
    (faces && ends.iter().all(|end| end.2)).then(|| ends.map(|(index, jet, _)| (index, jet.position)))
}

/// The first front that a ray meets.
fn front(scene: &Scene, from: DVec3, along: DVec3) -> Option<(usize, DVec3)> {
    let hits = scene.surfaces.iter().enumerate().filter_map(|(index, surface)| {
        let ray =
            radiosity::geom::Ray { range: [0.0, f64::INFINITY], ..radiosity::geom::Ray::new(from, along) };
        let hit = surface.shape.intersect(&ray)?;
        let jet = surface.shape.jet(hit.u, hit.v);
        (jet.normal.dot(along) < 0.0).then_some((hit.t, index, jet.position))
    });
    hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, index, place)| (index, place))
}

/// The blockers found hide all that any surface hides, wherever a dent is; in convex rooms nothing is found.
#[test]
fn dents_are_found_and_convex_rooms_are_free() {
    let (mut convex, mut dented, mut without_chord) = (0, 0, 0);
    for seed in 0..ROOMS {
        let Room { shapes, chord, dent } = room(seed);
        let scene = shining(shapes.into_iter().map(|shape| (shape, 1.0))).build().expect("a room");
        let seen = Seen::of(&scene);
        let mut random = Random(seed + 1000);
        for _ in 0..PAIRS {
            let Some(ends) = pair(&scene, &mut random) else { continue };
            let [found, all] = seen.free(ends);
            assert_eq!(found, all, "room {seed}, dent {dent:.1e}: {ends:?}");
            assert!(seen.contains_rightly(ends), "room {seed}, dent {dent:.1e}: {ends:?}");
            assert!(all || dent > 0.0, "room {seed}: hidden in a convex room: {ends:?}");
        }
        let Some([place, along]) = chord else {
            assert!(seen.blockers.iter().all(Vec::is_empty), "room {seed}: {:?}", seen.blockers);
            convex += 1;
            continue;
        };
        let mut hidden = 0;
        for _ in 0..CHORDS {
            let along = (along + 0.1 * dent * random.vector(-1.0, 1.0)).normalize();
            let ends = [along, -along].map(|along| front(&scene, place, along));
            let [Some(first), Some(second)] = ends else { continue };
            let [found, all] = seen.free([first, second]);
            assert_eq!(found, all, "room {seed}, dent {dent:.1e}: {first:?} {second:?}");
            assert!(
                seen.contains_rightly([first, second]),
                "room {seed}, dent {dent:.1e}: {first:?} {second:?}"
            );
            hidden += usize::from(!all);
        }
        dented += usize::from(hidden > 0);
        without_chord += usize::from(hidden == 0);
        if hidden == 0 {
            println!("room {seed}: no chord through a dent of {dent:.1e}");
        }
    }
    println!("{convex} convex rooms, {dented} with a dent that hides, {without_chord} where no chord does");
    assert!(convex == 50 && without_chord == 0);
}
