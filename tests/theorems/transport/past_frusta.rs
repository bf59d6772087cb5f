//! Polygons and disks past balls, cans, cones and disks: by their outlines, without rays. What a thing hides of a
//! ceiling that is wide enough is what it catches; rooms are closed; and quadratures of this test's own.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::elements::Element;
use radiosity::elements::rule::UnitRule;
use radiosity::geom::shapes::{Cone, Disk, FULL_TURN, Parallelogram, Polygon};
use radiosity::geom::{DVec3, Ray, Surface};
use radiosity::kernel::Accuracy;
use radiosity::scene::Scene;
use radiosity::transport::{Demand, assemble};
use radiosity::visibility::{Shadows, Visibility};
use radiosity::work::Work;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::grey;
use radiosity_test_support::shapes::{ball, disk, faces, plate, tube};
use radiosity_test_support::solved::{blocks_of, elements_of, factors_of};

/// A thing of one surface or more.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Thing {
    Ball,
    /// A wall with a lid on top, and one below where it is closed.
    Can {
        is_closed: bool,
    },
    /// A cone with its tip on top.
    Cone,
    /// A cone with its tip below, and a lid.
    Funnel,
    /// A cone without its tip, with a lid on top.
    Stump,
    Disk,
    /// A wall without lids.
    Tube,
}

const THINGS: [Thing; 7] = [
    Thing::Ball,
    Thing::Can { is_closed: false },
    Thing::Can { is_closed: true },
    Thing::Cone,
    Thing::Funnel,
    Thing::Stump,
    Thing::Disk,
];

/// Where a thing begins, its axis with its height, and its largest radius.
#[derive(Clone, Copy, Debug)]
struct Place {
    base: DVec3,
    axis: DVec3,
    radius: f64,
}

type Shapes = Vec<Arc<dyn Surface>>;

impl Thing {
    /// Whether its wall has no lid below.
    fn is_open(self) -> bool {
        matches!(self, Self::Can { is_closed: false } | Self::Cone | Self::Stump)
    }

    fn shapes(self, Place { base, axis, radius }: Place) -> Shapes {
        let (along, top) = (axis.normalize(), base + axis);
        let cone = |low: f64, high: f64| -> Arc<dyn Surface> {
            Arc::new(Cone::new(base, axis, low, high, FULL_TURN).expect("a cone"))
        };
        let lid = |place: DVec3, normal: DVec3, radius: f64| -> Arc<dyn Surface> {
            Arc::new(disk(place, normal, radius))
        };
        match self {
            Self::Ball => vec![Arc::new(ball(base + radius * along, radius))],
            Self::Can { is_closed } => {
                let mut all: Shapes = vec![Arc::new(tube(base, axis, radius)), lid(top, along, radius)];
                all.extend(is_closed.then(|| lid(base, -along, radius)));
                all
            }
            Self::Tube => vec![Arc::new(tube(base, axis, radius))],
            Self::Cone => vec![cone(radius, 0.0)],
            Self::Funnel => vec![cone(0.0, radius), lid(top, along, radius)],
            Self::Stump => vec![cone(radius, 0.6 * radius), lid(top, along, 0.6 * radius)],
            Self::Disk => vec![lid(base, along, radius)],
        }
    }
}

/// A scene of plates and of things; a disk has two sides.
fn scene(
    plates: impl IntoIterator<Item = Parallelogram>,
    things: impl IntoIterator<Item = (Thing, Place)>,
) -> Scene {
    let (mut builder, grey) = grey();
    for (k, own) in plates.into_iter().enumerate() {
        builder.surface(format!("plate {k}"), own, &grey);
    }
    for (k, (thing, place)) in things.into_iter().enumerate() {
        for (part, shape) in thing.shapes(place).into_iter().enumerate() {
            let surface = builder.surface(format!("thing {k}, {part}"), shape, &grey);
            if thing == Thing::Disk {
                surface.two_sided();
            }
        }
    }
    builder.build().expect("the scene is valid")
}

const ROOM: [f64; 3] = [2.0, 2.5, 2.0];

/// The walls of a room: left, right, front, back, floor and ceiling.
fn room() -> [Parallelogram; 6] {
    let [x, y, z] = ROOM;
    faces(DVec3::ZERO, [x * DVec3::X, y * DVec3::Y, z * DVec3::Z])
}

const FLOOR: usize = 4;

/// Below a ceiling that holds the shadows of a thing from all of a small floor, the thing hides as much as the floor
/// sends to it.
#[test]
fn what_is_hidden_of_a_wide_ceiling_is_what_is_caught() {
    let floor = || plate(DVec3::new(-0.1, -0.2, 0.0), 0.2 * DVec3::X, 0.4 * DVec3::Y);
    let ceiling = || plate(DVec3::new(-30.0, -30.0, 4.0), 60.0 * DVec3::Y, 60.0 * DVec3::X);
    let places = [
        Place { base: DVec3::new(0.1, 0.2, 0.9), axis: 0.4 * DVec3::Z, radius: 0.3 },
        Place { base: DVec3::new(-0.4, 0.1, 1.2), axis: DVec3::new(0.5, 0.2, 0.3), radius: 0.2 },
        Place { base: DVec3::new(0.3, 0.0, 1.6), axis: DVec3::new(0.1, 0.4, -0.6), radius: 0.5 },
    ];
    let open = factors_of(&scene([floor(), ceiling()], None), Shadows::Auto, 1e-9, 1e-9).factor(0, 1);
    for (thing, place) in THINGS.into_iter().flat_map(|thing| places.map(|place| (thing, place))) {
        // An open end looks upward.
        let is_turned = thing.is_open() && place.axis.z > 0.0;
        let turned = Place { base: place.base + place.axis, axis: -place.axis, ..place };
        let placed = Some((thing, if is_turned { turned } else { place }));
        let found = factors_of(&scene([floor(), ceiling()], placed), Shadows::Auto, 1e-7, 1e-7);
        let caught: f64 = found.row(0)[2..].iter().sum();
        let off = (open - caught - found.factor(0, 1)).abs();
        println!(
            "{thing:?} {place:?}: {caught:.3e} is caught, off by {off:.1e}, told {:.1e}",
            found.errors[0]
        );
        assert!(caught > 3e-3 && found.rays == 0, "{thing:?} {place:?}: {} rays", found.rays);
        assert!(off <= 1e-7, "{thing:?} {place:?}: off by {off:.1e}");
    }
}

/// The polygon of this many corners that stands for a disk at a height, of its area, and seen from below.
fn many_sided(corners: usize, height: f64, radius: f64) -> Polygon {
    let turn = TAU / corners as f64;
    let out = radius * (turn / turn.sin()).sqrt();
    let corner = |k: usize| {
        let (sin, cos) = (-turn * k as f64).sin_cos();
        DVec3::new(out * cos, out * sin, height)
    };
    Polygon::new((0..corners).map(corner).collect(), Vec::new()).expect("a polygon")
}

/// A disk sees a disk, and a ring, past a thing as it sees polygons of many sides, without a ray.
#[test]
fn disks_past_things_are_polygons_of_many_sides() {
    let places = [
        Place { base: DVec3::new(0.2, 0.1, 0.4), axis: 0.9 * DVec3::Z, radius: 0.4 },
        Place { base: DVec3::new(0.7, 0.1, 1.0), axis: DVec3::new(0.3, 0.1, 0.3), radius: 0.5 },
    ];
    let (eps, height, [hole, rim]) = (1e-6, 2.0, [0.5, 1.2]);
    let seen = |place: Place, thing: Thing, other: Arc<dyn Surface>| {
        let (mut builder, grey) = grey();
        builder.surface("low", disk(DVec3::ZERO, DVec3::Z, 1.0), &grey);
        builder.surface("high", other, &grey);
        for (part, shape) in thing.shapes(place).into_iter().enumerate() {
            builder.surface(format!("part {part}"), shape, &grey);
        }
        let scene = builder.build().expect("the scene is valid");
        let (elements, visibility) = (elements_of(&scene, 0, 1), Visibility::new(&scene, Shadows::Auto, eps));
        let accuracy = Accuracy { eps, shadow_eps: eps };
        let demand = Demand::all(&elements, &visibility, accuracy);
        let found = assemble(demand.of(&|a, b| [a, b] == [0, 1]), None, &Work::alone());
        assert_eq!(found.statistics.rays, 0, "{thing:?} {place:?}");
        let firsts: f64 = found.iter().map(|block| block.values[0]).sum();
        firsts * (elements.list()[1].area / elements.list()[0].area).sqrt()
    };
    for (thing, place) in [Thing::Can { is_closed: true }, Thing::Funnel]
        .into_iter()
        .flat_map(|thing| places.map(|place| (thing, place)))
    {
        let polygon = |radius: f64| seen(place, thing, Arc::new(many_sided(64, height, radius)));
        let (whole, amid) = (polygon(rim), polygon(hole));
        for (inner, right) in [(0.0, whole), (hole, whole - amid)] {
            let round = Disk::new(height * DVec3::Z, -DVec3::Z, rim, inner, FULL_TURN).expect("a ring");
            let off = (seen(place, thing, Arc::new(round)) - right).abs();
            println!("{thing:?} {place:?}, hole {inner}: {right:.5}, off by {off:.1e}");
            assert!(off <= eps, "{thing:?} {place:?}, hole {inner}: off by {off:.1e}");
        }
    }
}

/// Things beyond an end of another, in the endless solid on which its wall lies, hide as well, and once where their
/// shadows overlap.
#[test]
fn things_beyond_the_ends_of_others_are_caught_too() {
    let floor = || plate(DVec3::new(-0.1, -0.2, 0.0), 0.2 * DVec3::X, 0.4 * DVec3::Y);
    let ceiling = || plate(DVec3::new(-30.0, -30.0, 4.0), 60.0 * DVec3::Y, 60.0 * DVec3::X);
    let eps = 1e-4;
    let open = factors_of(&scene([floor(), ceiling()], None), Shadows::Auto, 1e-9, 1e-9).factor(0, 1);
    let axes = [0.4 * DVec3::Z, DVec3::new(0.1, 0.2, 0.4)];
    let closed = THINGS.into_iter().filter(|thing| !thing.is_open());
    let cases = closed.flat_map(|thing| axes.map(|axis| (thing, axis)));
    for ((thing, axis), second) in cases.flat_map(|case| {
        [None, Some(Thing::Disk), Some(Thing::Can { is_closed: true })].map(|second| (case, second))
    }) {
        let place = Place { base: DVec3::new(0.1, 0.2, 0.9), axis, radius: 0.3 };
        let along = axis.normalize();
        let length = match thing {
            Thing::Ball => 0.6,
            Thing::Disk => 0.0,
            _ => axis.length(),
        };
        let (first, other) = along.any_orthonormal_pair();
        let above = place.base + (length + 0.05) * along + 0.1 * first;
        let tile = plate(above - 0.15 * (first + other), 0.3 * other, 0.3 * first);
        let beyond = second.map(|second| (second, Place { base: above, axis: 0.2 * along, radius: 0.25 }));
        let tile = second.is_none().then_some(tile);
        let placed = [Some((thing, place)), beyond].into_iter().flatten();
        let scene = scene([floor(), ceiling()].into_iter().chain(tile), placed);
        let found = factors_of(&scene, Shadows::Auto, eps, eps);
        let caught: f64 = found.row(0)[2..].iter().sum();
        let off = (open - caught - found.factor(0, 1)).abs();
        println!(
            "{thing:?}, {second:?}: off by {off:.1e}, told {:.1e}, {} rays",
            found.errors[0], found.rays
        );
        assert!(off <= eps, "{thing:?} along {axis}, {second:?}: off by {off:.1e}");
    }
}

/// Largest |Σ_j G_ij c_j − c_i| over √A_i, and the number of rays sent.
fn openness(scene: &Scene, eps: f64) -> (f64, u64) {
    let elements = elements_of(scene, 0, 1);
    let visibility = Visibility::new(scene, Shadows::Auto, eps);
    let blocks = blocks_of(&elements, &visibility, Accuracy { eps, shadow_eps: eps });
    let constant = elements.constant();
    let arrives = blocks.apply(&constant);
    let off = |(element, start): (&Element, &usize)| {
        let range = *start..start + element.basis.len();
        range.map(|k| (arrives[k] - constant[k]).abs()).fold(0.0, f64::max) / element.area.sqrt()
    };
    let worst = elements.list().iter().zip(&elements.starts()).map(off).fold(0.0, f64::max);
    (worst, blocks.statistics.rays)
}

/// All that leaves a point of a closed room arrives somewhere.
#[test]
fn rooms_with_things_are_closed() {
    let places = [
        Place { base: DVec3::new(1.1, 1.3, 0.4), axis: 0.7 * DVec3::Z, radius: 0.3 },
        Place { base: DVec3::new(0.8, 0.9, 0.9), axis: DVec3::new(0.3, 0.6, 0.2), radius: 0.25 },
    ];
    for (thing, place) in THINGS.into_iter().flat_map(|thing| places.map(|place| (thing, place))) {
        if thing.is_open() {
            continue;
        }
        let scene = scene(room(), Some((thing, place)));
        for eps in [1e-3, 1e-5] {
            let (open, rays) = openness(&scene, eps);
            println!("{thing:?}, {eps:.0e}: {open:.1e}, {rays} rays");
            // A row is the sum of six blocks or more.
            assert!(open < 2.0 * eps, "{thing:?} {place:?}, {eps:.0e}: open by {open:.1e}");
            assert_eq!(rays, 0, "{thing:?} {place:?}");
        }
    }
}

/// A thing that stands on the floor takes its place from it.
#[test]
fn what_stands_on_a_floor_darkens_its_place() {
    let place = Place { base: DVec3::new(1.1, 1.3, 0.0), axis: 0.7 * DVec3::Z, radius: 0.3 };
    for thing in THINGS.into_iter().filter(|thing| thing.is_open()) {
        let found = factors_of(&scene(room(), Some((thing, place))), Shadows::Auto, 1e-6, 1e-6);
        let dark = PI * place.radius * place.radius / (ROOM[0] * ROOM[1]);
        for (surface, sum) in found.row_sums().into_iter().enumerate() {
            let right = if surface == FLOOR { 1.0 - dark } else { 1.0 };
            assert!((sum - right).abs() < 3e-6, "{thing:?}, {surface}: {sum} for {right}");
        }
        assert_eq!(found.rays, 0, "{thing:?}");
    }
}

/// A small disk wholly in the shadow of a wide one hides nothing more: what little is seen past them is found by
/// rays.
#[test]
fn things_that_hide_each_other_leave_pairs_to_rays() {
    let tile = |[x, y]: [f64; 2], z: f64, up: f64| {
        let along = DVec3::new(1.0, 0.0, 0.0);
        let (first, second) = if up > 0.0 { (along, DVec3::Y) } else { (DVec3::Y, along) };
        plate(DVec3::new(x, y, z), first, second)
    };
    let plates = || [tile([0.0; 2], 0.0, 1.0), tile([0.0; 2], 2.0, -1.0)];
    let disk = |base: DVec3, axis: DVec3, radius: f64| (Thing::Disk, Place { base, axis, radius });
    let wide = disk(DVec3::new(0.25, 0.5, 0.5), DVec3::Z, 0.75);
    let factor = |other: Option<(Thing, Place)>| {
        let placed = [Some(wide), other].into_iter().flatten();
        let found = factors_of(&scene(plates(), placed), Shadows::Auto, 1e-3, 1e-3);
        (found.factor(0, 1), found.errors[0], found.rays)
    };
    let (alone, _, none) = factor(None);
    let in_shadow = disk(DVec3::new(0.25, 0.5, 1.0), DVec3::Z, 0.01);
    let (shadowed, told, rays) = factor(Some(in_shadow));
    assert!(none == 0 && rays > 0, "{none} and {rays} rays");
    assert!((shadowed - alone).abs() < 3.0 * told, "{shadowed} for {alone}, told {told:.1e}");
}

/// Light passes through a tube that no lid closes: by rays.
#[test]
fn open_tubes_leave_pairs_to_rays() {
    let place = Place { base: DVec3::new(1.1, 1.3, 0.4), axis: 0.7 * DVec3::Z, radius: 0.3 };
    let found = factors_of(&scene(room(), Some((Thing::Tube, place))), Shadows::Auto, 3e-3, 3e-3);
    assert!(found.pairs.by_rays > 0, "{:?}", found.pairs);
}

/// Exchange that shapes hide between two plates over the area of the first: by points of the first, by lines on the
/// second, and by the part of each line that segments do not reach.
fn hidden(from: &Parallelogram, to: &Parallelogram, shapes: &Shapes) -> f64 {
    const PANELS: usize = 12;
    let (points, lines) = (UnitRule::of(3), UnitRule::of(24));
    let at = |own: &Parallelogram, s: f64, t: f64| own.jet(2.0 * s - 1.0, 2.0 * t - 1.0);
    let area = 4.0 * at(to, 0.5, 0.5).area;
    let place = |panel: usize, t: f64| (panel as f64 + t) / PANELS as f64;
    let panels = (0..PANELS * PANELS).map(|k| [k / PANELS, k % PANELS]);
    let mut sum = 0.0;
    for [i, j] in panels {
        for ((s, ws), (t, wt)) in points.iter().flat_map(|s| points.iter().map(move |t| (s, t))) {
            let x = at(from, place(i, s), place(j, t));
            let is_hidden = |s: f64, t: f64| {
                let direction = at(to, s, t).position - x.position;
                let ray = Ray { origin: x.position, direction, range: [1e-9, 1.0 - 1e-9] };
                shapes.iter().any(|shape| shape.occludes(&ray))
            };
            let Some([low, high]) = range(|s| looks().any(|t| is_hidden(s, t))) else { continue };
            // The part of a line changes like a square root at either end.
            let of_line = |(place, weight): (f64, f64)| {
                let angle = PI * place;
                let s = low + (high - low) * 0.5 * (1.0 - angle.cos());
                let Some([first, last]) = range(|t| is_hidden(s, t)) else { return 0.0 };
                let along = |(t, w): (f64, f64)| {
                    let y = at(to, s, first + (last - first) * t);
                    w * (last - first) * kernel(x.position, x.normal, y.position, y.normal)
                };
                let seen: f64 = UnitRule::of(10).iter().map(along).sum();
                0.5 * PI * angle.sin() * (high - low) * weight * seen
            };
            sum += ws * wt * area * lines.iter().map(of_line).sum::<f64>();
        }
    }
    sum / (PANELS * PANELS) as f64
}

/// cos cos/(π d²).
fn kernel(x: DVec3, n: DVec3, y: DVec3, m: DVec3) -> f64 {
    let d = y - x;
    n.dot(d).max(0.0) * (-m.dot(d)).max(0.0) / (PI * d.length_squared().powi(2))
}

/// Steps of [0, 1] at which what holds on a range of it is looked for.
const LOOKS: usize = 40;

fn at_look(k: usize) -> f64 {
    k as f64 / LOOKS as f64
}

fn looks() -> impl Iterator<Item = f64> {
    (0..=LOOKS).map(at_look)
}

/// The range of [0, 1] where something convex holds.
fn range(holds: impl Fn(f64) -> bool) -> Option<[f64; 2]> {
    let inner = (0..=LOOKS).find(|k| holds(at_look(*k)))?;
    let outer = (0..=LOOKS).rev().find(|k| holds(at_look(*k)))?;
    let border = |mut inside: f64, mut outside: f64| {
        for _ in 0..30 {
            let middle = 0.5 * (inside + outside);
            *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    };
    let low = if inner == 0 { 0.0 } else { border(at_look(inner), at_look(inner - 1)) };
    let high = if outer == LOOKS { 1.0 } else { border(at_look(outer), at_look(outer + 1)) };
    Some([low, high])
}

/// The floor of a room sees each wall past things that stand on it, lean, hang, or touch a wall.
#[test]
fn walls_past_things_have_the_factors_of_a_quadrature() {
    let mut random = Random(7);
    for thing in THINGS {
        let radius = random.between(0.15, 0.45);
        let base = DVec3::new(random.between(0.5, 1.5), random.between(0.5, 2.0), random.pick(&[0.0, 0.5]));
        let axis = if base.z == 0.0 { DVec3::Z } else { DVec3::new(random.signed(), random.signed(), 1.0) };
        let place = Place { base, axis: random.between(0.3, 0.6) * axis, radius };
        let shapes = thing.shapes(place);
        let with = factors_of(&scene(room(), Some((thing, place))), Shadows::Auto, 1e-6, 1e-6);
        let without = factors_of(&scene(room(), None), Shadows::Auto, 1e-9, 1e-9);
        assert_eq!(with.rays, 0, "{thing:?} {place:?}");
        let walls = room();
        for wall in [0, 3, 5] {
            // From the wall on, as what stands on the floor hides all from its own place.
            let share = without.areas[wall] / without.areas[FLOOR];
            let right = without.factor(FLOOR, wall) - share * hidden(&walls[wall], &walls[FLOOR], &shapes);
            let off = (with.factor(FLOOR, wall) - right).abs();
            println!("{thing:?} to {wall}: {right:.6}, off by {off:.1e}, told {:.1e}", with.errors[FLOOR]);
            assert!(off < 3e-5, "{thing:?} {place:?} to {wall}: off by {off:.1e}");
        }
    }
}

/// Things anywhere in rooms: all walls see each other as exactly as is asked.
#[test]
fn random_rooms_keep_to_what_is_asked() {
    let mut random = Random(11);
    for thing in THINGS.into_iter().filter(|thing| !thing.is_open()).cycle().take(8) {
        let base = DVec3::new(random.between(0.7, 1.3), random.between(0.7, 1.8), random.between(0.7, 1.0));
        let axis = random.between(0.1, 0.6) * random.direction();
        let place = Place { base, axis, radius: random.power(-1.3, -0.5) };
        let [rough, fine] =
            [1e-3, 1e-6].map(|eps| factors_of(&scene(room(), Some((thing, place))), Shadows::Auto, eps, eps));
        for (i, j) in (0..36).map(|k| (k / 6, k % 6)) {
            let largest = fine.row(i).into_iter().fold(0.0, f64::max);
            let off = (rough.factor(i, j) - fine.factor(i, j)).abs();
            assert!(off <= 1e-3 * largest, "{thing:?} {place:?}, {i} to {j}: off by {off:.1e}");
        }
        assert_eq!(rough.rays + fine.rays, 0, "{thing:?} {place:?}");
    }
}

/// Rooms with a cone on a wall are closed, also where patches of the wall end amid its foot or touch it, and with
/// things in round numbers, of which outlines touch sides and pass through corners.
#[test]
fn rooms_in_round_numbers_are_closed() {
    let eps = 1e-3;
    let mut random = Random(5);
    let walls = || faces(DVec3::ZERO, [2.0 * DVec3::X, 2.0 * DVec3::Y, 2.0 * DVec3::Z]);
    let on_wall = Place { base: DVec3::new(0.0, 1.0, 0.75), axis: DVec3::X, radius: 0.5 };
    let round = |thing: Thing, random: &mut Random| {
        let mut quarters = |low: usize, high: usize| 0.25 * (low + random.below(high + 1 - low)) as f64;
        let base = DVec3::new(quarters(2, 6), quarters(2, 6), quarters(1, 3));
        (thing, Place { base, axis: quarters(1, 4) * DVec3::Z, radius: random.pick(&[0.125, 0.25, 0.375]) })
    };
    let hung = [Thing::Can { is_closed: true }, Thing::Funnel, Thing::Disk];
    let stood = [Thing::Can { is_closed: false }, Thing::Cone, Thing::Stump];
    let beside_cuts =
        Place { base: DVec3::new(2.0, 1.25, 1.25), axis: DVec3::new(-0.5, 0.0, 0.0), radius: 0.25 };
    let mut cases = vec![(Thing::Cone, on_wall), (Thing::Cone, beside_cuts)];
    for thing in hung.into_iter().chain(stood).cycle().take(8) {
        let (thing, place) = round(thing, &mut random);
        let foot = if thing.is_open() { 0.0 } else { place.base.z };
        cases.push((thing, Place { base: place.base.with_z(foot), ..place }));
    }
    for (thing, place) in cases {
        let found = factors_of(&scene(walls(), Some((thing, place))), Shadows::Auto, eps, eps);
        let dark = if thing.is_open() { PI * place.radius * place.radius / 4.0 } else { 0.0 };
        let foot = if place.axis.x == 0.0 { FLOOR } else { usize::from(place.axis.x < 0.0) };
        println!("{thing:?} {place:?}: {:?}", found.row_sums());
        for (surface, sum) in found.row_sums().into_iter().take(6).enumerate() {
            let right = if surface == foot { 1.0 - dark } else { 1.0 };
            assert!((sum - right).abs() < eps, "{thing:?} {place:?}, {surface}: {sum} for {right}");
        }
        // A wall that narrows may need rays to the floor on which it stands.
        assert!(found.rays == 0 || thing == Thing::Stump, "{thing:?} {place:?}: {} rays", found.rays);
    }
}
