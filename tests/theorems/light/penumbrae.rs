//! Direct light in pictures, by rays to emitters, against closed forms and against light computed without
//! them.

use std::f64::consts::PI;

use radiosity::geom::shapes::{Disk, FULL_TURN, Parallelogram};
use radiosity::geom::{DVec3, Encounter};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::solve::solution::SurfacePlace;
use radiosity::solve::{Options, Outcome};
use radiosity::visibility::Visibility;
use radiosity::{Scene, SceneBuilder, Work, scene::Camera};
use radiosity_test_support::scenes::{material, typed};
use radiosity_test_support::shapes::{ball, plate};
use radiosity_test_support::solved::outcome_of;

const SIZE: u32 = 96;

/// Part of the light E, or of √(E Ē) where it is darker than the mean Ē of the scene, by which pixels between those
/// that are computed may err: half of what pictures are accurate to.
const FITTED: f64 = 1.5e-3;

/// Radius of the disk that shines.
const DISK: f64 = 0.5;

/// A ball that emits or stands in the way, over a floor that reflects nothing.
fn over_floor(height: f64, radius: f64, exitance: f64, lamp: Option<Parallelogram>) -> Scene {
    let mut builder = SceneBuilder::new("ball", ["grey"]);
    let mut material = |name: &str, exitance: f64| builder.material(name, material(0.0, exitance));
    let (black, own, glow) = (material("black", 0.0), material("ball", exitance), material("glow", 1.0));
    let center = DVec3::new(0.0, 0.0, height);
    let shape = ball(center, radius);
    builder.surface("ball", shape, &own);
    let floor = Parallelogram::new(DVec3::new(-4.0, -4.0, 0.0), 8.0 * DVec3::X, 8.0 * DVec3::Y);
    builder.surface("floor", floor.expect("a square"), &black);
    if let Some(lamp) = lamp {
        builder.surface("lamp", lamp, &glow);
    }
    let camera = Camera::new(DVec3::new(0.3, -5.0, 3.0), DVec3::new(0.0, 0.0, 0.0));
    builder.camera(Camera { width: SIZE, height: SIZE, ..camera });
    builder.build().expect("a scene")
}

/// A scene, solved, with its picture of irradiance by direct light.
struct Taken {
    scene: Scene,
    outcome: Outcome,
    visibility: Visibility,
    raster: Raster,
}

fn taken(scene: Scene, samples: u32) -> Taken {
    let options = Options::default();
    let outcome = outcome_of(&scene, &options);
    let visibility = options.visibility(&scene);
    let camera = scene.camera.clone().expect("a camera");
    let read = ReadMode::Direct;
    let raster = PictureRequest {
        solution: &outcome.solution,
        visibility: &visibility,
        camera: &camera,
        samples,
        read,
        shown: Quantity::Irradiance,
        is_preview: false,
    }
    .picture(&Work::alone());
    Taken { scene, outcome, visibility, raster }
}

impl Taken {
    /// Value and place of each pixel that sees the floor.
    fn on_floor(&self) -> Vec<(f64, SurfacePlace)> {
        let view = Pinhole::new(self.scene.camera.as_ref().expect("a camera"));
        let pixel = |(index, values): (usize, &[f64])| {
            let [column, row] = [index as u32 % SIZE, index as u32 / SIZE].map(|at| f64::from(at) + 0.5);
            let met = self.visibility.nearest(&view.ray(column, row))?;
            let Encounter { surface, hit, .. } = met;
            let position = self.outcome.solution.elements().shape(surface).jet(hit.u, hit.v).position;
            let place = SurfacePlace { surface, parameters: [hit.u, hit.v], position };
            (self.scene.surfaces[surface].name == "floor").then_some((values[0], place))
        };
        self.raster.pixels().enumerate().filter_map(pixel).collect()
    }
}

#[test]
fn a_round_lamp_lights_the_floor_far_below_and_close_by() {
    // E = M (r/d)² h/d where all of the ball of radius r at height h is above the horizon.
    const RADIUS: f64 = 0.25;
    for height in [2.0, 0.5, 0.28] {
        let taken = taken(over_floor(height, RADIUS, 3.0, None), 1);
        let floor = taken.on_floor();
        assert!(floor.len() > 2000);
        let mean = taken.outcome.solution.mean_arriving()[0];
        for (value, place) in &floor {
            let step = place.position + taken.scene.middle - DVec3::new(0.0, 0.0, height);
            let exact = 3.0 * RADIUS.powi(2) * height / step.length().powi(3);
            let allowed = FITTED * (exact * mean.max(exact)).sqrt();
            assert!((value - exact).abs() < allowed, "{height}: {value} for {exact}");
        }
    }
}

/// A disk that shines down from a height of 2 over a floor that reflects nothing, and a plate between them.
fn under_disk(plate: Option<Parallelogram>) -> Scene {
    let mut builder = SceneBuilder::new("disk", ["grey"]);
    let mut material = |name: &str, exitance: f64| builder.material(name, material(0.0, exitance));
    let (black, glow) = (material("black", 0.0), material("glow", 1.0));
    let disk = Disk::new(DVec3::new(0.0, 0.0, 2.0), -DVec3::Z, DISK, 0.0, FULL_TURN);
    builder.surface("lamp", disk.expect("a disk"), &glow);
    let floor = Parallelogram::new(DVec3::new(-4.0, -4.0, 0.0), 8.0 * DVec3::X, 8.0 * DVec3::Y);
    builder.surface("floor", floor.expect("a square"), &black);
    if let Some(plate) = plate {
        builder.surface("plate", plate, &black);
    }
    let camera = Camera::new(DVec3::new(0.3, -5.0, 3.0), DVec3::new(0.0, 0.0, 0.0));
    builder.camera(Camera { width: SIZE, height: SIZE, ..camera });
    builder.build().expect("a scene")
}

/// Irradiance on the floor under that disk, as far aside as `aside`: ½
/// (1 − (h² + a² − R²)/√((h² + a² + R²)² − 4 R² a²)), the view factor from an element to a parallel disk.
fn from_disk(aside: f64) -> f64 {
    let (h, a, r) = (4.0, aside * aside, DISK * DISK);
    0.5 * (1.0 - (h + a - r) / ((h + a + r).powi(2) - 4.0 * r * a).sqrt())
}

#[test]
fn a_disk_lights_the_floor_without_noise() {
    let taken = taken(under_disk(None), 1);
    let floor = taken.on_floor();
    assert!(floor.len() > 2000);
    for (value, place) in floor {
        let at = place.position + taken.scene.middle;
        let exact = from_disk(at.x.hypot(at.y));
        assert!((value / exact - 1.0).abs() < FITTED, "{at}: {value} for {exact}");
    }
}

/// Irradiance at `at` on that floor from the part u < `edge` of the disk, by the midpoint rule over strips of
/// it.
fn from_part(at: DVec3, edge: f64) -> f64 {
    const STRIPS: usize = 300;
    let width = (edge.clamp(-DISK, DISK) + DISK) / STRIPS as f64;
    let strip = |k: usize| {
        let u = -DISK + (k as f64 + 0.5) * width;
        let half = (DISK * DISK - u * u).sqrt();
        let value = |i: usize| {
            let v = half * ((2 * i + 1) as f64 / STRIPS as f64 - 1.0);
            let square = (u - at.x).powi(2) + (v - at.y).powi(2) + 4.0;
            4.0 / (PI * square * square)
        };
        width * 2.0 * half / STRIPS as f64 * (0..STRIPS).map(value).sum::<f64>()
    };
    (0..STRIPS).map(strip).sum()
}

#[test]
fn the_edge_of_a_plate_cuts_a_disk() {
    // The plate hides x > 0 halfway up: from x it leaves the part u < -x of the disk.
    let plate = Parallelogram::new(DVec3::new(0.0, -8.0, 1.0), 8.0 * DVec3::X, 16.0 * DVec3::Y);
    let camera = Camera::new(DVec3::new(-3.0, 0.3, 0.8), DVec3::new(0.2, 0.0, 0.0));
    let mut scene = under_disk(Some(plate.expect("a plate")));
    scene.camera = Some(Camera { width: SIZE, height: SIZE, ..camera });
    let taken = taken(scene, 1);
    let (mut mixed, mut clear, mut none) = (0, 0, 0);
    for (value, place) in taken.on_floor().into_iter().step_by(23) {
        let at = place.position + taken.scene.middle;
        let exact = from_part(at, -at.x);
        assert!((value - exact).abs() < FITTED * from_disk(at.x.hypot(at.y)), "{at}: {value} for {exact}");
        let kind = if at.x.abs() < DISK {
            &mut mixed
        } else if at.x < 0.0 {
            &mut clear
        } else {
            &mut none
        };
        *kind += 1;
    }
    assert!(mixed > 20 && clear > 20 && none > 20, "{mixed} {clear} {none}");
}

#[test]
fn shadows_of_a_ball_are_those_of_exact_light() {
    let lamp = plate(DVec3::new(-0.5, -0.5, 3.0), DVec3::Y, DVec3::X);
    let taken = taken(over_floor(1.0, 0.5, 0.0, Some(lamp)), 1);
    let reader = Reader::new(&taken.outcome.solution, &taken.visibility, ReadMode::Direct, 1e-4);
    let (mut squares, mut sum, mut dark) = (0.0, 0.0, 0);
    for (value, place) in taken.on_floor() {
        let element =
            taken.outcome.solution.elements().at(place.surface, place.parameters).expect("no holes");
        let exact = reader.irradiance(element, &place, DVec3::Z).irradiance[0];
        squares += (value - exact).powi(2);
        sum += exact * exact;
        dark += usize::from(exact < 1e-3 / PI);
    }
    let rms = f64::sqrt(squares / sum);
    assert!(rms < 4e-3, "{rms}");
    assert!(dark > 10, "some pixels are in the umbra: {dark}");
}

#[test]
fn parts_of_pixels_make_up_their_means() {
    let taken = taken(over_floor(0.5, 0.25, 3.0, None), 3);
    let mut several = 0;
    for (pixel, values) in taken.raster.pixels().enumerate() {
        let Some(samples) = taken.raster.samples(pixel) else { continue };
        let parts: Vec<_> = samples.parts().collect();
        let mean: f64 = parts.iter().map(|part| part.share * part.radiosity[0]).sum();
        let cover: f64 = parts.iter().map(|part| part.share).sum();
        assert!((mean - values[0]).abs() <= 1e-6 * values[0].max(1e-6), "{mean} {values:?}");
        assert!((cover - taken.raster.coverage()[pixel]).abs() < 1e-6);
        several += usize::from(parts.len() > 1);
    }
    assert!(several > 50, "the borders of ball and floor cross pixels: {several}");
}

/// Two lamps over a black floor, one wholly behind a panel, the other nearly behind a ball: that nothing
/// comes from the first is known without rays, of which the other cannot have enough.
#[test]
fn rays_end_where_one_emitter_is_known_and_another_is_not() {
    let room = r#"
materials.black = { reflectance = 0.0 }
materials.lamp = { reflectance = 0, emission = 40 }
camera = { eye = [2.5, -3, 1.5], target = [2.5, 2, 0], width = 40, height = 30 }
[[surfaces]]
name = "floor"
material = "black"
quad = { vertices = [[0,0,0],[5,0,0],[5,4,0],[0,4,0]] }
[[surfaces]]
name = "hidden"
material = "lamp"
quad = { vertices = [[1,1,3],[1,2,3],[2,2,3],[2,1,3]] }
[[surfaces]]
name = "half"
material = "lamp"
quad = { vertices = [[3,1,3],[3,2,3],[4,2,3],[4,1,3]] }
[[surfaces]]
name = "ball"
material = "black"
sphere = { center = [3.5,1.5,1.5], radius = 0.5 }
[[surfaces]]
name = "panel"
material = "black"
quad = { vertices = [[0.5,0.5,2.8],[2.5,0.5,2.8],[2.5,2.5,2.8],[0.5,2.5,2.8]] }
"#;
    let scene = typed(room);
    let Taken { raster, .. } = taken(scene, 1);
    assert!(raster.pixels().any(|pixel| pixel[0] > 0.1));
}

/// A disk one half of which is a hundred times as bright as the other, by rays and by polynomials: it is no
/// single source.
#[test]
fn a_disk_that_shines_unevenly_lights_as_its_parts_do() {
    let room = r#"
materials.wall = { reflectance = 0.0 }
materials.lamp = { reflectance = 0, emission = { cells = [[1, 100], [1, 100]] } }
camera = { eye = [0, -5, 2.5], target = [0, 0, 0], width = 24, height = 18 }
[[surfaces]]
name = "floor"
material = "wall"
quad = { vertices = [[-2,-2,0],[2,-2,0],[2,2,0],[-2,2,0]] }
[[surfaces]]
name = "disk"
material = "lamp"
disk = { center = [0,0,3], normal = [0,0,-1], radius = 0.5 }
[[surfaces]]
name = "ball"
material = "wall"
sphere = { center = [1.5,1.5,1.0], radius = 0.2 }
"#;
    let scene = typed(room);
    let Taken { outcome, visibility, scene, raster } = taken(scene, 1);
    let camera = scene.camera.clone().expect("a camera");
    let read = ReadMode::Basis;
    let smooth = PictureRequest {
        solution: &outcome.solution,
        visibility: &visibility,
        camera: &camera,
        samples: 1,
        read,
        shown: Quantity::Irradiance,
        is_preview: false,
    }
    .picture(&Work::alone());
    let [direct, basis] = [&raster, &smooth].map(|own| own.pixels().map(|pixel| pixel[0]).sum::<f64>());
    assert!((direct - basis).abs() < 0.03 * basis, "{direct} {basis}");
}
