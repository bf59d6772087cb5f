//! Coaxial surfaces past a coaxial cylinder: closed forms, rows that sum to 1, and what rays find.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::{Arc, Mutex};

use radiosity::geom::shapes::{Cone, Disk, FULL_TURN};
use radiosity::geom::{DVec3, Surface};
use radiosity::kernel::Accuracy;
use radiosity::scene::Scene;
use radiosity::solve::Transport;
use radiosity::solve::view_factors::Options;
use radiosity::visibility::Shadows;
use radiosity::work::Progress;
use radiosity::{ViewFactors, Work};
use radiosity_test_support::scenes::grey;
use radiosity_test_support::shapes::{ball, tube};
use radiosity_test_support::solved::factors_of;

/// Surfaces about an axis through a place.
struct Axis {
    origin: DVec3,
    along: DVec3,
}

const UPRIGHT: Axis = Axis { origin: DVec3::ZERO, along: DVec3::Z };

impl Axis {
    fn at(&self, height: f64) -> DVec3 {
        self.origin + height * self.along
    }

    fn tube(&self, radius: f64, [bottom, top]: [f64; 2]) -> Arc<dyn Surface> {
        Arc::new(tube(self.at(bottom), (top - bottom) * self.along, radius))
    }

    fn cone(&self, radii: [f64; 2], [bottom, top]: [f64; 2]) -> Arc<dyn Surface> {
        let axis = (top - bottom) * self.along;
        Arc::new(Cone::new(self.at(bottom), axis, radii[0], radii[1], FULL_TURN).expect("a cone"))
    }

    /// A ring that faces upward where `up` is 1.
    fn ring(&self, [inner, outer]: [f64; 2], height: f64, up: f64) -> Arc<dyn Surface> {
        Arc::new(Disk::new(self.at(height), up * self.along, outer, inner, FULL_TURN).expect("a ring"))
    }
}

/// A surface, and whether it is turned over.
type Sheet = (Arc<dyn Surface>, bool);

fn scene(sheets: Vec<Sheet>) -> Scene {
    let (mut builder, grey) = grey();
    for (k, (shape, is_flipped)) in sheets.into_iter().enumerate() {
        let surface = builder.surface(format!("s{k}"), shape, &grey);
        if is_flipped {
            surface.flip();
        }
    }
    builder.build().expect("the scene is valid")
}

/// A tube of the radius r in one of the radius 1 and the height h, closed by rings: inner, outer, bottom, top.
fn furnace(axis: &Axis, r: f64, h: f64) -> Vec<Sheet> {
    vec![
        (axis.tube(r, [0.0, h]), false),
        (axis.tube(1.0, [0.0, h]), true),
        (axis.ring([r, 1.0], 0.0, 1.0), false),
        (axis.ring([r, 1.0], h, -1.0), false),
    ]
}

/// All factors of the furnace (Howell's catalogue, C-91 and C-92, for the first two; the others by sums and
/// reciprocity).
fn of_furnace(inner: f64, height: f64) -> [[f64; 4]; 4] {
    let (r, h) = (1.0 / inner, height / inner);
    let (a, b) = (h * h + r * r - 1.0, h * h - r * r + 1.0);
    let arc = ((a + 2.0).powi(2) - 4.0 * r * r).sqrt() * (b / (r * a)).acos();
    let inward = (1.0 - ((b / a).acos() - (arc + b * (1.0 / r).asin() - FRAC_PI_2 * a) / (2.0 * h)) / PI) / r;
    let root = (4.0 * r * r + h * h).sqrt() / h;
    let sine = (4.0 * (r * r - 1.0) + h * h * (1.0 - 2.0 / (r * r))) / (h * h + 4.0 * (r * r - 1.0));
    let arcs = root * sine.asin() - (1.0 - 2.0 / (r * r)).asin() + FRAC_PI_2 * (root - 1.0);
    let own =
        1.0 - 1.0 / r + 2.0 / (PI * r) * (2.0 * (r * r - 1.0).sqrt() / h).atan() - h / (2.0 * PI * r) * arcs;
    let outward = inward * r;
    let [to_end, from_inner] = [0.5 * (1.0 - inward - own), 0.5 * (1.0 - outward)];
    let end = 0.5 * (1.0 - inner * inner) / height;
    let [end_to_inner, end_to_outer] = [from_inner * inner / end, to_end / end];
    let across = 1.0 - end_to_inner - end_to_outer;
    [
        [0.0, outward, from_inner, from_inner],
        [inward, own, to_end, to_end],
        [end_to_inner, end_to_outer, 0.0, across],
        [end_to_inner, end_to_outer, across, 0.0],
    ]
}

#[test]
fn furnaces_have_the_factors_of_the_catalogue_and_tell_their_error() {
    let tilted = Axis { origin: DVec3::new(3.0, -1.0, 2.0), along: DVec3::new(2.0, -1.0, 2.0) / 3.0 };
    for (axis, inner, height) in [(&UPRIGHT, 0.4, 2.0), (&UPRIGHT, 0.9, 0.3), (&tilted, 0.1, 8.0)] {
        let (scene, right) = (scene(furnace(axis, inner, height)), of_furnace(inner, height));
        for eps in [1e-3, 1e-6, 1e-9] {
            let found = factors_of(&scene, Shadows::Auto, eps, eps);
            assert_eq!((found.pairs.by_rays, found.rays), (0, 0));
            for (i, right) in right.iter().enumerate() {
                let row = found.row(i);
                let largest = right.iter().copied().fold(0.0, f64::max);
                let off = row.iter().zip(right).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                println!("{inner} {height} {eps:.0e} {i}: {off:.1e}, told {:.1e}", found.errors[i]);
                assert!(off <= 3.0 * found.errors[i].max(1e-13) && off <= eps * largest, "{eps} {i}: {off}");
                assert!(found.errors[i] <= eps * largest, "{eps} {i}: {}", found.errors[i]);
            }
        }
    }
}

/// The inner tube in two pieces, of which the rule takes both for one cylinder, in another order.
#[test]
fn pieces_of_a_tube_hide_what_the_whole_does() {
    let mut sheets = furnace(&UPRIGHT, 0.4, 2.0);
    sheets[0].0 = UPRIGHT.tube(0.4, [0.0, 0.7]);
    sheets.insert(0, (UPRIGHT.tube(0.4, [0.7, 2.0]), false));
    sheets.reverse();
    let found = factors_of(&scene(sheets), Shadows::Auto, 1e-9, 1e-9);
    let right = of_furnace(0.4, 2.0);
    assert_eq!(found.pairs.by_rays, 0);
    let [top, bottom, outer, low, high] = [0, 1, 2, 3, 4];
    for (i, j, right) in [(top, bottom, right[2][3]), (outer, outer, right[1][1]), (outer, top, right[1][3])]
    {
        assert!((found.factor(i, j) - right).abs() < 1e-9, "{i} {j}");
    }
    assert!((found.factor(outer, low) + found.factor(outer, high) - right[1][0]).abs() < 1e-9);
}

/// Tubes that end before the walls do, and other things, have no rule: rays carry what they hide a part of.
#[test]
fn other_things_between_leave_pairs_to_rays() {
    let mut short = furnace(&UPRIGHT, 0.4, 2.0);
    short[0].0 = UPRIGHT.tube(0.4, [0.0, 1.5]);
    let mut beside = furnace(&UPRIGHT, 0.4, 2.0);
    beside.push((Arc::new(ball(DVec3::new(0.7, 0.0, 1.0), 0.1)), false));
    let mut apart = furnace(&UPRIGHT, 0.4, 2.0);
    apart[0].0 = Arc::new(tube(DVec3::new(1e-3, 0.0, 0.0), 2.0 * DVec3::Z, 0.4));
    for sheets in [short, beside, apart] {
        let found = factors_of(&scene(sheets), Shadows::Auto, 3e-3, 3e-3);
        assert!(found.pairs.by_rays > 0, "{:?}", found.pairs);
    }
}

/// Rooms about one axis whose factors no formula tells, by rules and by rays alone.
#[test]
fn rays_find_what_the_rule_does() {
    let axis = &UPRIGHT;
    let cone = vec![
        (axis.tube(0.3, [0.0, 1.0]), false),
        (axis.cone([1.0, 0.5], [0.0, 1.0]), true),
        (axis.ring([0.3, 1.0], 0.0, 1.0), false),
        (axis.ring([0.3, 0.5], 1.0, -1.0), false),
    ];
    // A washer on the tube, which hides either end of the room from the other.
    let washer = vec![
        (axis.tube(0.3, [0.0, 2.0]), false),
        (axis.tube(1.0, [0.0, 2.0]), true),
        (axis.ring([0.3, 1.0], 0.0, 1.0), false),
        (axis.ring([0.3, 1.0], 2.0, -1.0), false),
        (axis.ring([0.3, 0.6], 1.1, 1.0), false),
        (axis.ring([0.3, 0.6], 1.0, -1.0), false),
        (axis.tube(0.6, [1.0, 1.1]), false),
    ];
    // A collar on the tube, as wide as it is not elsewhere.
    let collar = vec![
        (axis.tube(0.3, [0.0, 0.8]), false),
        (axis.cone([0.3, 0.6], [0.8, 1.0]), false),
        (axis.tube(0.6, [1.0, 1.5]), false),
        (axis.tube(1.0, [0.0, 1.5]), true),
        (axis.ring([0.3, 1.0], 0.0, 1.0), false),
        (axis.ring([0.6, 1.0], 1.5, -1.0), false),
    ];
    for (name, sheets) in [("cone", cone), ("washer", washer), ("collar", collar)] {
        let scene = scene(sheets);
        let accuracy = Accuracy { eps: 1e-3, shadow_eps: 1e-3 };
        let by = |transport: Transport, rays: Option<u64>| {
            let options = Options { accuracy, transport, rays, threads: 2, ..Options::default() };
            ViewFactors::new(&scene, &options, &Work::alone()).expect("all have area")
        };
        let (rules, rays) = (by(Transport::Exact, None), by(Transport::Sampled, Some(400_000)));
        for i in 0..rules.names.len() {
            let pairs = rules.row(i).into_iter().zip(rays.row(i));
            let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            let told = rules.errors[i].hypot(rays.errors[i]);
            println!("{name} {i}: {off:.1e}, told {told:.1e}");
            assert!(off <= 3.0 * told, "{name} {i}: {off:.1e} {told:.1e}");
        }
    }
}

/// A tube in a tube, both in so many slices, closed by rings.
fn sliced(slices: usize) -> Scene {
    let edge = |k: usize| 2.0 * k as f64 / slices as f64;
    let slice = |k: usize| {
        let heights = [edge(k), edge(k + 1)];
        [(UPRIGHT.tube(0.4, heights), false), (UPRIGHT.tube(1.0, heights), true)]
    };
    let ends = [(UPRIGHT.ring([0.4, 1.0], 0.0, 1.0), false), (UPRIGHT.ring([0.4, 1.0], 2.0, -1.0), false)];
    scene((0..slices).flat_map(slice).chain(ends).collect())
}

/// The price of pairs that the rule knows is theirs, in seconds as they are told before and in evaluations as they are
/// taken, and rules are chosen where those of other curved things would take minutes.
#[test]
fn what_rules_of_rings_take_is_told_before() {
    let accuracy = Accuracy { eps: 1e-3, shadow_eps: 1e-3 };
    let options = Options { accuracy, threads: 2, ..Options::default() };
    let seconds_of_a_sample = |slices: usize| {
        let told = Mutex::new(0.0);
        let observer = |progress| {
            if let Progress::Expected { seconds, .. } = progress {
                *told.lock().expect("no other panicked") += seconds;
            }
        };
        let work = Work::alone().observed_by(&observer);
        let factors = ViewFactors::new(&sliced(slices), &options, &work).expect("all have area");
        assert!(!factors.choice.sampled, "{}", factors.choice.why);
        told.into_inner().expect("no other panicked") / factors.samples as f64
    };
    let [few, many] = [4, 24].map(seconds_of_a_sample);
    assert!((0.4..2.5).contains(&(few / many)), "{few} {many}");
}
