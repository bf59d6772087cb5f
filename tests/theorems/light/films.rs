//! Pictures of frames that follow each other: they change by as much as things move, and no more.

use std::convert::Infallible;

use radiosity::Work;
use radiosity::reading::pictures::film::{Film, FilmError, FilmFrame};
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::Scene;
use radiosity::solve::animation::follower::{FollowMode, Follower};
use radiosity::solve::animation::frame::Frame;
use radiosity::solve::{Options, Transport};
use radiosity_test_support::scenes::typed;

/// A closed room in which a round lamp moves so over a block and a ball.
fn room(frames: usize, way: &str, [width, height]: [u32; 2]) -> Scene {
    let text = format!(
        r#"
frames = {frames}
camera = {{ eye = [0.05, 0.05, 0.9], target = [0.6, 0.6, 0], fov = 70, width = {width}, height = {height} }}
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

/// A closed room lit by what a lamp that faces the ceiling sends there, in which a cube so moves over the floor, beside
/// this motion of the lamp.
fn cube_room(frames: usize, way: &str, lamp: &str) -> Scene {
    let text = format!(
        r#"
frames = {frames}
camera = {{ eye = [0.5, 0.02, 0.6], target = [0.5, 0.6, 0], fov = 75, width = 16, height = 12 }}
materials.wall = {{ reflectance = 0.6 }}
materials.dark = {{ reflectance = 0.1 }}
materials.lamp = {{ reflectance = 0, emission = 1 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
[[surfaces]]
name = "cube"
material = "dark"
box = {{ origin = [0.1, 0.4, 0.05], size = [0.15, 0.15, 0.15] }}
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = {{ origin = [0.4, 0.75, 0.7], edge1 = [0.2, 0, 0], edge2 = [0, 0.1, 0] }}
[[motion]]
surfaces = "cube"
translate = {{ points = {way} }}
[[motion]]
surfaces = "lamp"
translate = {{ points = {lamp} }}
"#
    );
    typed(&text)
}

/// The light of all frames.
fn solved(scene: &Scene, transport: Transport) -> Vec<Frame> {
    let options = Options { order: 1, transport, rays: Some(20_000), ..Options::default() };
    let last = scene.frames() - 1;
    let mut follower = Follower::new(scene, &options, FollowMode::Selective, [0, last]);
    (0..=last).map(|number| follower.frame(number, &Work::alone()).expect("it is solved")).collect()
}

/// The pictures of some of these frames, taken as one film, and its error.
fn film(scene: &Scene, frames: &[Frame], read: ReadMode, wanted: &[usize]) -> (Vec<Raster>, FilmError) {
    let camera = scene.camera.clone().expect("a camera");
    let shown = frames.iter().enumerate().map(|(number, frame)| FilmFrame {
        number,
        frame,
        camera: camera.clone(),
        is_wanted: wanted.contains(&number),
    });
    let shown: Vec<FilmFrame> = shown.collect();
    let (mut film, mut pictures) = (Film::new(scene, &frames[0], read, 2), Vec::new());
    let keep = |_: &FilmFrame, raster| {
        pictures.push(raster);
        Ok::<(), Infallible>(())
    };
    film.pictures(&shown, &Work::alone(), keep).expect("it cannot fail");
    (pictures, film.error())
}

/// The picture of a frame alone.
fn alone(scene: &Scene, frame: &Frame) -> Raster {
    let camera = scene.camera.clone().expect("a camera");
    let Frame { solution, visibility, .. } = frame;
    PictureRequest {
        solution,
        visibility,
        camera: &camera,
        samples: 2,
        read: ReadMode::Gather,
        shown: Quantity::Radiosity,
        is_preview: false,
    }
    .picture(&Work::alone())
}

/// Differences of the pixels of two pictures, over the mean: the root mean square, and the largest.
fn apart(one: &Raster, other: &Raster) -> [f64; 2] {
    let (one, other) = (values(one), values(other));
    let mean = other.iter().sum::<f64>() / other.len() as f64;
    let apart: Vec<f64> = one.iter().zip(&other).map(|(a, b)| (a - b).abs() / mean).collect();
    let squares = apart.iter().map(|x| x * x).sum::<f64>() / apart.len() as f64;
    [squares.sqrt(), apart.into_iter().fold(0.0, f64::max)]
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
    let scene = room(13, "[[0, 0, 0], [0, 0, 0], [0.1, 0, 0]]", [12, 9]);
    let frames = solved(&scene, Transport::Sampled);
    for read in [ReadMode::Direct, ReadMode::Gather] {
        let (film, _) = film(&scene, &frames, read, &[0, 1, 3, 6, 10]);
        let values: Vec<Vec<f64>> = film.iter().map(values).collect();
        assert!(values[1..4].iter().all(|own| *own == values[0]), "{read:?}");
        assert!(values[4] != values[0], "{read:?}: the lamp moves then");
    }
}

#[test]
fn half_the_step_changes_pictures_by_half() {
    // Light and penumbrae are smooth in the place of the lamp, whose breadth is sixteen steps: the largest
    // change of a pixel goes like the step. Noise that is drawn anew for each frame, or light that pops,
    // changes by as much in half a step.
    let scene = room(5, "[[0, 0, 0], [0.05, 0, 0]]", [24, 18]);
    let frames = solved(&scene, Transport::Exact);
    let (film, _) = film(&scene, &frames, ReadMode::Direct, &[0, 1, 2, 3, 4]);
    let [one, two, four] = [1, 2, 4].map(|step| largest_change(&film, step));
    assert!(four > 0.1, "something happens: {four}");
    assert!(two < 0.6 * four && one < 0.6 * two, "{one} {two} {four}");
}

/// The light that a cube takes from the floor below moves with it. Interpolated between five frames of the way, which
/// is four of its edges long, pictures are off by 3.6e-2, and by 0.25 in the worst pixel.
#[test]
fn beside_what_moves_light_is_gathered_in_each_frame() {
    let scene = cube_room(9, "[[0, 0, 0], [0.6, 0, 0]]", "[[0, 0, 0], [0, 0, 0]]");
    let frames = solved(&scene, Transport::Exact);
    let wanted = [3, 5];
    let (film, _) = film(&scene, &frames, ReadMode::Gather, &wanted);
    for (number, picture) in wanted.into_iter().zip(&film) {
        let [mean, most] = apart(picture, &alone(&scene, &frames[number]));
        assert!(mean < 3e-3 && most < 2e-2, "{number}: {mean:.2e} {most:.2e}");
    }
}

/// A closed room lit by what a lamp sends to the ceiling, which has these factors in two bands in nine frames. What
/// else glows, hardly, does so otherwise in each: something happens in all steps.
fn coloured_room(factors: &str) -> Scene {
    let text = format!(
        r#"
bands = ["r", "g"]
frames = 9
camera = {{ eye = [0.5, 0.02, 0.4], target = [0.5, 0.6, 0.2], fov = 75, width = 12, height = 9 }}
materials.wall = {{ reflectance = 0.6 }}
materials.lamp = {{ reflectance = 0, emission = [1, 1] }}
materials.glow = {{ reflectance = 0, emission = [1e-3, 1e-3] }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = {{ origin = [0.4, 0.45, 0.7], edge1 = [0.2, 0, 0], edge2 = [0, 0.1, 0] }}
[[surfaces]]
name = "glow"
material = "glow"
parallelogram = {{ origin = [0.1, 0.1, 0.1], edge1 = [0.05, 0, 0], edge2 = [0, 0.05, 0] }}
[[motion]]
surfaces = "lamp"
emission = {factors}
[[motion]]
surfaces = "glow"
emission = {{ factors = [1, 1.1] }}
"#
    );
    typed(&text)
}

/// The colour of a lamp flips between two frames, or in one alone; the sum of its bands stays. Judged by that sum,
/// light is interpolated all the same, and pictures are off by 0.08 to 1.5 of the mean.
#[test]
fn light_that_changes_its_colour_alone_is_not_interpolated() {
    let flip = "{ factors = [[1, 0.4], [0.4, 1]], times = [4, 5] }";
    let flash = "{ factors = [[1, 0.4], [0.4, 1], [1, 0.4]], times = [4, 5, 6] }";
    for factors in [flip, flash] {
        let scene = coloured_room(factors);
        let frames = solved(&scene, Transport::Exact);
        let wanted = [3, 5];
        let (film, _) = film(&scene, &frames, ReadMode::Gather, &wanted);
        for (number, picture) in wanted.into_iter().zip(&film) {
            let [mean, most] = apart(picture, &alone(&scene, &frames[number]));
            assert!(mean < 1e-3 && most < 3e-3, "{factors} {number}: {mean:.2e} {most:.2e}");
        }
    }
}

/// A lamp of which only reflected light is seen moves steadily: second differences of pictures are those of the light,
/// and what is told of the error is true.
#[test]
fn films_do_not_flicker_and_tell_their_error() {
    let scene = cube_room(9, "[[0, 0, 0], [0, 0, 0]]", "[[0, 0, 0], [0.15, 0, 0]]");
    let frames = solved(&scene, Transport::Exact);
    let all: Vec<usize> = (0..9).collect();
    let (film, error) = film(&scene, &frames, ReadMode::Gather, &all);
    let mean = values(&film[4]).iter().sum::<f64>() / values(&film[4]).len() as f64;
    let mut squares = Vec::new();
    for three in film.windows(3) {
        let [one, two, three] = [0, 1, 2].map(|k| values(&three[k]));
        let second =
            (0..one.len()).map(|pixel| ((one[pixel] - 2.0 * two[pixel] + three[pixel]) / mean).powi(2));
        squares.extend(second);
    }
    let flicker = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
    let told = error.told().expect("light is interpolated");
    let found = apart(&film[5], &alone(&scene, &frames[5]))[0];
    assert!(flicker < 3e-3, "{flicker:.2e}");
    assert!(told < 5e-3 && found < 2.0 * told, "told {told:.2e}, found {found:.2e}");
}
