//! Whole rooms: groups, bands and threads.

use radiosity::audit::{Effort, Estimate, Mean, Referee, Spot};
use radiosity::{Scene, Work};
use radiosity_test_support::scenes::typed;

/// Standard errors squared that two independent means of eight shifts are apart: F(1, ν) with ν from 7 to 14,
/// whose mean is from 7/6 to 7/5; one in 10⁵ exceeds the largest.
const APART: [f64; 2] = [0.8, 1.8];
const FARTHEST: f64 = 11.2;

/// A room with lamps of three groups, a luminaire, a window with a sun, a sheet that lets light through, a
/// pattern and a ball; reflectances and emissions for each of `bands`.
fn room(bands: &[usize]) -> Scene {
    let list = |values: [f64; 6]| format!("{:?}", bands.iter().map(|band| values[*band]).collect::<Vec<_>>());
    let names: Vec<String> = bands.iter().map(|band| format!("band {band}")).collect();
    let walls = list([0.7, 0.5, 0.3, 0.6, 0.1, 0.8]);
    let silk = [list([0.3, 0.1, 0.5, 0.2, 0.4, 0.3]), list([0.4, 0.6, 0.1, 0.3, 0.2, 0.5])];
    let lamp = list([900.0, 300.0, 100.0, 0.0, 50.0, 400.0]);
    let glow = list([10.0, 30.0, 0.0, 60.0, 20.0, 15.0]);
    let bulb = list([50.0, 20.0, 70.0, 10.0, 30.0, 40.0]);
    let sky = list([5.0, 6.0, 9.0, 3.0, 2.0, 1.0]);
    let sun = list([20.0, 10.0, 5.0, 9.0, 8.0, 1.0]);
    typed(&format!(
        r#"
bands = {names:?}
[sky]
model = "clear"
illuminance = {sky}
sun = {{ elevation = 35, azimuth = 270, illuminance = {sun} }}
[materials]
wall = {{ reflectance = {walls} }}
silk = {{ reflectance = {}, transmittance = {} }}
lamp = {{ reflectance = 0.1, emission = {lamp}, group = "lamp" }}
glow = {{ reflectance = 0.3, emission = {glow}, group = "glow" }}
pane = {{ reflectance = 0.1 }}
tiles = {{ reflectance = {{ cells = [[0.1, 0.7], [0.6, 0.3]] }} }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [4, 5, 3], inward = true, open = ["left", "bottom"] }}
[[surfaces]]
name = "floor"
material = "tiles"
parallelogram = {{ origin = [0, 0, 0], edge1 = [4, 0, 0], edge2 = [0, 5, 0] }}
[[surfaces]]
name = "left"
material = "wall"
quad = {{ vertices = [[0, 0, 0], [0, 5, 0], [0, 5, 3], [0, 0, 3]], holes = [[[0, 1, 1], [0, 4, 1], [0, 4, 2.5], [0, 1, 2.5]]] }}
[[surfaces]]
name = "window"
material = "pane"
group = "window"
glass = {{}}
quad = {{ vertices = [[0, 1, 1], [0, 4, 1], [0, 4, 2.5], [0, 1, 2.5]] }}
[[surfaces]]
name = "lamp"
material = "lamp"
disk = {{ center = [1, 1, 2.9], normal = [0, 0, -1], radius = 0.2 }}
[[surfaces]]
name = "ball"
material = "glow"
sphere = {{ center = [3, 3.5, 0.8], radius = 0.5 }}
[[surfaces]]
name = "screen"
material = "silk"
two_sided = true
parallelogram = {{ origin = [2, 1, 0.5], edge1 = [0, 2, 0], edge2 = [0.3, 0, 1.5] }}
[[luminaires]]
position = [3, 1, 2.5]
spot = {{ exponent = 2 }}
flux = {bulb}
group = "bulb"
"#,
        silk[0], silk[1]
    ))
}

/// Lamps of weak groups are seldom chosen: with fewer walks their means are not normal.
const WALKS: f64 = 2048.0;

const GROUPS: [&str; 4] = ["lamp", "glow", "bulb", "window"];

const ALL: [usize; 6] = [0, 1, 2, 3, 4, 5];

fn spots(scene: &Scene) -> Vec<Spot> {
    let points = Referee::of_light(scene).sample(12, 3).into_iter().map(|own| own.spot);
    points.chain((0..scene.surfaces.len()).map(Spot::Surface)).collect()
}

fn estimates(scene: &Scene, spots: &[Spot], seed: u64) -> Vec<Estimate> {
    let effort = Effort::of_walks(WALKS).seeded(seed);
    Referee::of_light(scene).estimates(spots, &effort, &Work::alone())
}

/// Asserts that means differ as independent means of one thing do.
#[track_caller]
fn assert_alike(pairs: &[(Mean, Mean)]) {
    let squares: Vec<f64> = pairs
        .iter()
        .filter(|(a, b)| a.error > 0.0 || b.error > 0.0)
        .map(|(a, b)| (a.value - b.value).powi(2) / (a.error.powi(2) + b.error.powi(2)))
        .collect();
    let mean = squares.iter().sum::<f64>() / squares.len() as f64;
    let largest = squares.iter().fold(0.0_f64, |largest, own| largest.max(*own)).sqrt();
    println!("{} pairs: {mean:.2}, {largest:.1}", squares.len());
    assert!(mean > APART[0] && mean < APART[1] && largest < FARTHEST, "{mean} {largest}");
    let dark = pairs.iter().filter(|(a, b)| a.error == 0.0 && b.error == 0.0);
    dark.for_each(|(a, b)| assert!((a.value - b.value).abs() <= 1e-9 * b.value, "{a:?} {b:?}"));
}

#[test]
fn bands_together_are_the_bands_alone() {
    let whole = room(&ALL);
    let spots = spots(&whole);
    let of_all = estimates(&whole, &spots, 1);
    let mut pairs = Vec::new();
    for (seed, bands) in [(2, vec![0]), (3, vec![3]), (4, vec![5]), (5, vec![1, 2, 4])] {
        let some = estimates(&room(&bands), &spots, seed);
        for (own, all) in some.iter().zip(&of_all) {
            pairs.extend(bands.iter().enumerate().map(|(k, band)| (own.bands[k], all.bands[*band])));
        }
    }
    assert_alike(&pairs);
}

#[test]
fn groups_sum_to_the_whole_and_are_what_they_are_alone() {
    let whole = room(&ALL);
    let referee = Referee::of_light(&whole);
    let spots = spots(&whole);
    let of_all = estimates(&whole, &spots, 6);
    for own in &of_all {
        for (band, mean) in own.bands.iter().enumerate() {
            let sum: f64 = own.groups.iter().map(|group| group[band].value).sum();
            assert!((sum - mean.value).abs() <= 1e-12 * mean.value, "{sum} {mean:?}");
        }
    }
    let mut pairs = Vec::new();
    for (group, name) in GROUPS.into_iter().enumerate() {
        let others: Vec<(&str, f64)> =
            GROUPS.into_iter().filter(|own| *own != name).map(|own| (own, 0.0)).collect();
        let dimmed = whole.dimmed(&others).unwrap_or_else(|error| panic!("{error}"));
        let alone = estimates(&dimmed, &spots, 10 + group as u64);
        let group = referee.groups().iter().position(|own| own.as_deref() == Some(name)).expect("a group");
        for (own, all) in alone.iter().zip(&of_all) {
            pairs.extend(own.bands.iter().copied().zip(all.groups[group].iter().copied()));
        }
    }
    assert_alike(&pairs);
}

#[test]
fn threads_change_no_bit() {
    let scene = room(&ALL);
    let spots = spots(&scene);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| estimates(&scene, &spots, 7))
    };
    let alone = on(1);
    assert!(on(2) == alone && on(3) == alone);
}
