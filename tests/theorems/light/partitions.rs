//! Light in two rooms that a partition parts, a bright and a dark one, beside walks that know the scene alone.

use radiosity::audit::{Effort, Referee, Spot};
use radiosity::reading::probe::{Probe, probe};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::{Options, Work};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::solved_of;

/// Two rooms of 3.4 and 2.4 m, with a door between them and a lamp in one.
const ROOMS: &str = r#"
bands = ["lm"]
materials.grey = { reflectance = 0.5 }
materials.glow = { reflectance = 0.5, emission = 8000 }
[[surfaces]]
name = "rooms"
material = "grey"
box = { origin = [0, 0, 0], size = [5.8, 5.2, 2.5], inward = true }
[[surfaces]]
name = "partition"
material = "grey"
two_sided = true
polygon = { vertices = [[3.4, 0, 0], [3.4, 1.4, 0], [3.4, 1.4, 2.05], [3.4, 2.2, 2.05], [3.4, 2.2, 0], [3.4, 5.2, 0],
  [3.4, 5.2, 2.5], [3.4, 0, 2.5]] }
[[surfaces]]
name = "lamp"
material = "glow"
parallelogram = { origin = [2.4, 2.5, 2.45], edge1 = [0, 0.8, 0], edge2 = [0.2, 0, 0] }
"#;

/// Points of floor, ceiling and walls of both rooms, near the partition and far from it, with their normals.
const POINTS: [[f64; 6]; 6] = [
    [4.4, 2.7, 2.5, 0.0, 0.0, -1.0],
    [5.8, 3.1, 1.2, -1.0, 0.0, 0.0],
    [3.2, 4.9, 0.0, 0.0, 0.0, 1.0],
    [1.0, 5.2, 0.6, 0.0, -1.0, 0.0],
    [2.9, 0.0, 1.2, 0.0, 1.0, 0.0],
    [0.6, 3.5, 0.8, 0.0, 0.0, 1.0],
];

/// Accuracy of what is gathered, the default.
const EPS: f64 = 1.25e-3;

/// Walks of the referee, which leave .1 % in the bright room.
const WALKS: f64 = 2.0e6;

/// Largest error of a reading, relative to it, beside three standard errors of the referee. With surfaces that are cut
/// in their middles four of them are off by 1 to 1.6 %.
const LARGEST: f64 = 0.008;

#[test]
fn a_dark_room_beside_a_bright_one_is_read_as_it_is() {
    let solved = solved_of(typed(ROOMS), Options::default());
    let scene = &solved.scene;
    let reader = Reader::new(&solved.outcome.solution, solved.visibility(), ReadMode::Gather, EPS);
    let points = POINTS.map(|[x, y, z, nx, ny, nz]| (DVec3::new(x, y, z), DVec3::new(nx, ny, nz)));
    let probes = points.map(|(x, n)| Probe::along(x, n).expect("a direction"));
    let found = probe(&reader, &probes, scene.middle, &Work::alone()).expect("light");
    let spots: Vec<Spot> = probes.iter().map(|probe| probe.spot(scene)).collect();
    let right = Referee::of_light(scene).estimates(&spots, &Effort::of_walks(WALKS), &Work::alone());
    for ((found, right), [x, y, z, ..]) in found.iter().zip(right).zip(POINTS) {
        let (light, mean) = (found.irradiance[0], right.bands[0]);
        let off = (light - mean.value).abs();
        assert!(
            off < LARGEST * mean.value + 3.0 * mean.error,
            "at {x}, {y}, {z}: {light}, not {} ± {}",
            mean.value,
            mean.error
        );
    }
}
