//! How often right numbers are called wrong: readings whose means are drawn from eight normal shifts each, and
//! furnaces walked with other draws.

use radiosity::Work;
use radiosity::audit::{Effort, Estimate, Judged, Mean, Referee, Spot, Verdict};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;

/// Part of runs that may raise a false alarm.
const FALSE: f64 = 0.01;

/// A number of the normal distribution (G. Box, M. Muller, 1958).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * (1.0 - random.unit()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.unit()).cos()
}

/// A right reading of this class: 1 is printed, and the shifts err by `noise`; bands err alike.
fn right(random: &mut Random, class: usize, noise: f64, bands: usize) -> Judged {
    let shifts: Vec<f64> = (0..Effort::SHIFTS).map(|_| 1.0 + noise * normal(random)).collect();
    Judged {
        printed: vec![1.0; bands],
        printed_groups: Vec::new(),
        estimate: Estimate { bands: vec![Mean::of(&shifts); bands], groups: Vec::new(), rays: 0 },
        size: 1.0,
        class: class.to_string(),
    }
}

/// Part of runs of right readings that raise an alarm, each of `readings` in `classes`, their noise spread over
/// a factor 10^`decades`.
fn false_alarms(readings: usize, classes: usize, decades: f64, bands: usize) -> f64 {
    const RUNS: usize = 4000;
    let mut random = Random(readings as u64 + 1000 * classes as u64);
    let mut run = || {
        let mut own = |k: usize| {
            let noise = random.power(-1.0 - decades, -1.0);
            right(&mut random, k % classes, noise, bands)
        };
        let judged: Vec<Judged> = (0..readings).map(&mut own).collect();
        Verdict::of(&judged, 3).finds(0.0)
    };
    (0..RUNS).filter(|_| run()).count() as f64 / RUNS as f64
}

/// Within three standard deviations of the count of one in a hundred.
#[track_caller]
fn assert_rare(readings: usize, classes: usize, decades: f64, bands: usize) {
    let found = false_alarms(readings, classes, decades, bands);
    println!("{readings} readings, {classes} classes, {decades} decades, {bands} bands: {found:.4}");
    assert!(found <= FALSE + 3.0 * (FALSE / 4000.0_f64).sqrt(), "{found}");
}

#[test]
fn right_readings_raise_alarms_once_in_a_hundred_runs() {
    for (readings, classes) in [(64, 1), (64, 8), (64, 40), (256, 20), (16, 4), (8, 8)] {
        assert_rare(readings, classes, 0.0, 1);
        assert_rare(readings, classes, 0.0, 3);
    }
}

#[test]
fn readings_of_unequal_noise_raise_alarms_once_in_a_hundred_runs() {
    for (readings, classes) in [(64, 1), (64, 8), (64, 40), (256, 20)] {
        assert_rare(readings, classes, 1.0, 1);
        assert_rare(readings, classes, 2.0, 1);
    }
}

/// A hundred runs in a room whose light is known, each with draws of its own.
#[test]
fn furnaces_raise_no_more_than_one_alarm_in_a_hundred_runs() {
    let scene = typed(
        r#"
bands = ["lm"]
materials.white = { reflectance = 0.8, emission = 0.6 }
materials.grey = { reflectance = 0.3, emission = 2.1 }
[[surfaces]]
name = "room"
material = "white"
box = { origin = [0, 0, 0], size = [4, 5, 3], inward = true }
[[surfaces]]
name = "crate"
material = "grey"
box = { origin = [1, 1, 0], size = [1, 1, 0.7] }
[[surfaces]]
name = "ball"
material = "grey"
sphere = { center = [3, 3, 1], radius = 0.4 }
"#,
    );
    let referee = Referee::of_light(&scene);
    let run = |seed: u64| {
        let points = referee.sample(32, seed);
        let spots: Vec<Spot> = points.iter().map(|own| own.spot.clone()).collect();
        let found = referee.estimates(&spots, &Effort::of_walks(128.0).seeded(seed), &Work::alone());
        let judged = found.into_iter().zip(&points).map(|(estimate, point)| Judged {
            printed: vec![3.0],
            printed_groups: Vec::new(),
            estimate,
            size: 1.0,
            class: scene.surfaces[point.surface].name.clone(),
        });
        Verdict::of(&judged.collect::<Vec<_>>(), 3).finds(0.0)
    };
    let alarms = (0..100).filter(|seed| run(*seed)).count();
    assert!(alarms <= 1, "{alarms}");
}

/// An error of all readings by one factor that is as large as what can be seen is found in half of all runs or
/// more.
#[test]
fn what_can_be_seen_is_seen() {
    let mut random = Random(5);
    let mut seen = 0;
    for _ in 0..200 {
        let mut judged: Vec<Judged> = (0..64).map(|k| right(&mut random, k % 4, 0.05, 1)).collect();
        let off = 1.0 + Verdict::of(&judged, 3).visible();
        judged.iter_mut().for_each(|own| own.printed[0] *= off);
        seen += usize::from(Verdict::of(&judged, 3).finds(0.0));
    }
    assert!(seen >= 100, "{seen}");
}
