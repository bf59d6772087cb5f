//! Random pairs of bodies apart, at poses whose planes may cut the other body: what they exchange by rules
//! against iterated quadrature, and the errors that are told.

mod bodies;

use radiosity::ViewFactors;
use radiosity::scene::Scene;
use radiosity::visibility::Shadows;
use radiosity_geom::DVec3;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::grey;
use radiosity_test_support::solved::factors_of;

use super::turned::{Ring, Tube};
use bodies::{Body, KINDS, Kind};

/// Factors below this are not looked at: of so small ones less is asked.
const SMALLEST: f64 = 1e-4;

/// Errors told that a true error may be.
const FAR_OFF: f64 = 3.0;

/// Tolerance of the quadrature, relative, and what it errs by where faces end at planes, whose slivers it meets by
/// chance: triangles, of which a closed form is known, by 7e-8.
const REFEREE: f64 = 3e-9;
const UNSEEN: f64 = 3e-7;

/// Two bodies with what they exchange.
struct Pair {
    kinds: [Kind; 2],
    bodies: [Body; 2],
    exchange: f64,
    scene: Scene,
}

impl Pair {
    /// The next pair that sees each other, its balls 0.05 to 5 sizes of the smaller one apart.
    fn random(random: &mut Random) -> Self {
        loop {
            let kinds = [random.pick(&KINDS), random.pick(&KINDS)];
            let reach = random.power(-0.7, 0.7);
            let gap = reach.min(1.0) * random.power(-1.3, 0.7);
            let place = (1.0 + reach + gap) * random.direction();
            let bodies = [
                Body::random(kinds[0], DVec3::ZERO, 1.0, random),
                Body::random(kinds[1], place, reach, random),
            ];
            let least = bodies[0].area().min(bodies[1].area());
            let rough = bodies[0].rough_exchange(&bodies[1]);
            if rough > SMALLEST * least {
                return Self::of(kinds, bodies, rough);
            }
        }
    }

    fn of(kinds: [Kind; 2], bodies: [Body; 2], rough: f64) -> Self {
        // Lines of what a tube sees are fewer than those of what sees a tube.
        let is_tube = |kind| matches!(kind, Kind::Cylinder | Kind::Cone);
        let [outer, inner] = if is_tube(kinds[1]) { [1, 0] } else { [0, 1] };
        let exchange = bodies[outer].exchange(&bodies[inner], REFEREE * rough);
        let (mut builder, grey) = grey();
        for (k, body) in bodies.iter().enumerate() {
            builder.surface(format!("s{k}"), body.surface(), &grey);
        }
        let scene = builder.build().expect("the scene is valid");
        Self { kinds, bodies, exchange, scene }
    }

    fn judged(&self, eps: f64) -> Judged {
        let found: ViewFactors = factors_of(&self.scene, Shadows::Auto, eps, eps);
        let factor = self.exchange / found.areas[1];
        Judged {
            off: (found.factor(1, 0) - factor).abs(),
            told: found.errors[1],
            factor,
            samples: found.samples,
            is_by_rays: found.pairs.by_rays > 0,
        }
    }
}

/// A factor by rules beside that by quadrature.
struct Judged {
    off: f64,
    told: f64,
    factor: f64,
    samples: u64,
    is_by_rays: bool,
}

impl Judged {
    fn is_silent(&self) -> bool {
        self.off > FAR_OFF * self.told + UNSEEN * self.factor
    }
}

/// The two orders of each quadrature are two sums of different terms.
#[test]
fn quadrature_is_reciprocal() {
    let mut random = Random(3);
    for _ in 0..6 {
        let Pair { kinds, bodies: [a, b], exchange, .. } = Pair::random(&mut random);
        let [there, back] = [[&a, &b], [&b, &a]].map(|[p, q]| p.exchange(q, 1e-6 * exchange));
        println!("{kinds:?}: {:.1e}", there / back - 1.0);
        assert!((there - back).abs() < 3e-6 * there, "{kinds:?}: {there} {back}");
    }
}

/// Judges so many random pairs at each accuracy, and returns how many errors are told too small.
fn hunt(pairs: usize, seed: u64, accuracies: &[f64]) -> usize {
    let mut random = Random(seed);
    let mut all: Vec<(f64, usize, [Kind; 2], Judged)> = Vec::new();
    for number in 0..pairs {
        let pair = Pair::random(&mut random);
        all.extend(accuracies.iter().map(|eps| (*eps, number, pair.kinds, pair.judged(*eps))));
    }
    let silent = all.iter().filter(|(.., found)| found.is_silent()).count();
    for eps in accuracies {
        let own: Vec<_> = all.iter().filter(|(accuracy, ..)| accuracy == eps).collect();
        let mut ratios: Vec<f64> = own
            .iter()
            .filter(|(.., found)| found.off > UNSEEN * found.factor)
            .map(|(.., found)| found.told / found.off)
            .collect();
        ratios.sort_by(f64::total_cmp);
        let share =
            |part: f64| ratios.get((part * ratios.len() as f64) as usize).copied().unwrap_or(f64::NAN);
        let beyond = own.iter().filter(|(.., found)| found.off > FAR_OFF * eps * found.factor).count();
        let missed = own.iter().filter(|(.., found)| found.is_silent()).count();
        let samples: u64 = own.iter().map(|(.., found)| found.samples).sum();
        let rays = own.iter().filter(|(.., found)| found.is_by_rays).count();
        let fair = ratios.iter().filter(|ratio| (0.5..=3.0).contains(*ratio)).count();
        println!(
            "{eps:.0e}: {missed} silent, {beyond} beyond 3 eps, {rays} by rays, of {} seen {fair} fair, told/true 5 % {:.2} 50 % {:.2} 95 % {:.1}, {samples} samples",
            ratios.len(),
            share(0.05),
            share(0.5),
            share(0.95)
        );
    }
    all.sort_by(|a, b| (b.3.off / b.3.told).total_cmp(&(a.3.off / a.3.told)));
    for (eps, number, kinds, found) in all.iter().take(20) {
        let Judged { off, told, factor, .. } = found;
        println!("{number} {kinds:?} {eps:.0e}: F {factor:.3e}, {off:.1e} off, {told:.1e} told");
    }
    silent
}

/// A disk that leans over the floor of a room, with its ceiling: rules of three points a direction.
#[test]
fn the_error_of_a_leaning_disk_is_told() {
    let (sin, cos) = 150.0f64.to_radians().sin_cos();
    let disk = Ring {
        center: DVec3::new(0.1, -0.2, 0.4 * sin - 1.0),
        normal: DVec3::new(sin, 0.0, -cos),
        radius: 0.4,
        inner: 0.0,
    };
    let corners = [[-1.0, -1.0, 1.0], [-1.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, -1.0, 1.0]];
    let bodies = [Body::Plate(corners.map(DVec3::from_array).to_vec()), Body::Ring(disk)];
    check([Kind::Rectangle, Kind::Disk], bodies);
}

/// A ball past the border of a cylinder and of another ball: corners of their parts alone see it.
#[test]
fn balls_past_borders_are_seen_by_corners() {
    let ball = |at: [f64; 3], radius: f64| Body::Ball { center: DVec3::from_array(at), radius };
    let tube = Tube {
        base: DVec3::new(-0.1961, 0.4402, -0.1717),
        axis: DVec3::new(0.3922, -0.8804, 0.3434),
        radii: [0.8592; 2],
    };
    check([Kind::Cylinder, Kind::Ball], [Body::Tube(tube), ball([0.4221, -0.4167, -2.4403], 0.4468)]);
}

/// Asks for the factor of two bodies.
fn check(kinds: [Kind; 2], bodies: [Body; 2]) {
    let rough = bodies[0].rough_exchange(&bodies[1]);
    let pair = Pair::of(kinds, bodies, rough);
    for eps in [1e-3, 1e-4, 1e-6] {
        let found = pair.judged(eps);
        println!("{kinds:?} {eps:.0e}: {:.1e} off, {:.1e} told", found.off, found.told);
        assert!(!found.is_silent(), "{eps:.0e}: {:.1e} {:.1e}", found.off, found.told);
        assert!(found.off <= eps * found.factor + UNSEEN * found.factor, "{eps:.0e}: {:.1e}", found.off);
    }
}

#[test]
fn errors_of_pairs_apart_are_told() {
    assert_eq!(hunt(16, 11, &[1e-3, 1e-4, 1e-6]), 0);
}

#[test]
#[ignore = "takes some minutes"]
fn errors_of_many_pairs_apart_are_told() {
    assert_eq!(hunt(400, 12, &[1e-3, 1e-4, 1e-6]), 0);
}
