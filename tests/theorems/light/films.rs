//! Pictures of frames that follow each other: they change by as much as things move, and no more.

use radiosity::Work;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::render;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::Scene;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::{Options, Transport};
use radiosity_test_support::scenes::typed;

/// A closed room in which a round lamp moves so over a block and a ball.
fn room(frames: usize, way: &str) -> Scene {
    let text = format!(
        r#"
frames = {frames}
camera = {{ eye = [0.05, 0.05, 0.9], target = [0.6, 0.6, 0], fov = 70, width = 32, height = 24 }}
materials.wall = {{ reflectance = 0.5 }}
materials.lamp = {{ reflectance = 0, emission = 1 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
[[surfaces]]
name = "block"
material = "wall"
box = {{ origin = [0.6, 0.5, 0], size = [0.2, 0.2, 0.3], open = ["bottom"] }}
[[surfaces]]
name = "ball"
material = "wall"
sphere = {{ center = [0.3, 0.6, 0.3], radius = 0.08 }}
[[surfaces]]
name = "lamp"
material = "lamp"
disk = {{ center = [0.4, 0.5, 0.9], normal = [0, 0, -1], radius = 0.1 }}
[[motion]]
surfaces = "lamp"
translate = {{ points = {way} }}
"#
    );
    typed(&text)
}

/// The pictures of all frames.
fn film(scene: &Scene, transport: Transport, read: ReadMode) -> Vec<Raster> {
    let options = Options { order: 1, transport, ..Options::default() };
    let camera = scene.camera.clone().expect("a camera");
    let frames = scene.frames();
    let mut follower = Follower::new(scene, &options, FollowMode::Selective, [0, frames - 1]);
    let picture = |number: usize| {
        let frame = follower.frame(number, &Work::alone()).expect("it is solved");
        let visibility = options.visibility(&frame.scene);
        render(&frame.solution, &visibility, &camera, 2, read, Quantity::Radiosity, &Work::alone())
    };
    (0..frames).map(picture).collect()
}

fn values(raster: &Raster) -> Vec<f64> {
    raster.pixels().map(|pixel| pixel[0]).collect()
}

/// Largest difference between frames `step` apart, over the mean.
fn largest_change(film: &[Raster], step: usize) -> f64 {
    let films: Vec<Vec<f64>> = film.iter().map(values).collect();
    let mean = films[0].iter().sum::<f64>() / films[0].len() as f64;
    let change = |now: &Vec<f64>, next: &Vec<f64>| {
        now.iter().zip(next).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    films.iter().zip(&films[step..]).map(|(now, next)| change(now, next)).fold(0.0, f64::max) / mean
}

#[test]
fn while_nothing_moves_pictures_are_the_same_to_the_bit() {
    // At rest for the first half of the way, by rays too.
    let scene = room(5, "[[0, 0, 0], [0, 0, 0], [0.1, 0, 0]]");
    for read in [ReadMode::Direct, ReadMode::Gather] {
        let film = film(&scene, Transport::Sampled, read);
        assert!(values(&film[0]) == values(&film[1]) && values(&film[1]) == values(&film[2]), "{read:?}");
        assert!(values(&film[2]) != values(&film[4]), "{read:?}: the lamp moves then");
    }
}

#[test]
fn half_the_step_changes_pictures_by_half() {
    // Light and penumbrae are smooth in the place of the lamp, whose breadth is sixteen steps: the largest
    // change of a pixel goes like the step. Noise that is drawn anew for each frame, or light that pops,
    // changes by as much in half a step.
    let film = film(&room(9, "[[0, 0, 0], [0.1, 0, 0]]"), Transport::Exact, ReadMode::Direct);
    let [one, two, four] = [1, 2, 4].map(|step| largest_change(&film, step));
    assert!(four > 0.1, "something happens: {four}");
    assert!(two < 0.6 * four && one < 0.6 * two, "{one} {two} {four}");
}
