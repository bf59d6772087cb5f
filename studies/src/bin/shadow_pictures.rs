//! One shadow, four ways: the box with a lamp and a hovering panel, as in figures 7 and 8 of Zatz 1993.
//!
//! `cargo run --release -p radiosity-studies --bin shadow_pictures -- [PREFIX]` writes PREFIX-pictures.png
//! and PREFIX-differences.png (docs/occluder-box unless said), each of five pictures side by side, and prints
//! how far the radiosity of the floor's pixels is off (relative L2):
//!
//! 1. polynomials alone, of order 4, on the floor 8 (figure 7);
//! 2. the same with direct light times masks of 40 × 40 cells, order 8 on the lamp too (figure 8);
//! 3. with masks that average light instead of area;
//! 4. direct light exact at every point, the rest from polynomials of the same orders (`--read direct`);
//! 5. all light gathered anew at every point (`--read gather`).
//!
//! The second file shows the differences from the finest preset, blue where too dark, red where too bright,
//! white where equal; the ends of the scale are ±20 % of the mean radiosity.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::fs::File;
use std::io::{BufWriter, Result};
use std::num::NonZeroUsize;

use radiosity::Work;
use radiosity::output::drawings::false_colour::false_colour;
use radiosity::output::drawings::picture::Picture;
use radiosity::output::drawings::scale::Scale;
use radiosity::output::pictures::image::Image;
use radiosity::output::pictures::tone::Tone;
use radiosity::published::zatz1993::masked_light::{Average, Masking};
use radiosity::reading::difference::Difference;
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::render;
use radiosity::reading::quality::Quality;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::{Camera, Scene};
use radiosity::solve::{Direct, Options, in_threads, solve};
use radiosity::visibility::Shadows;

/// Pixels across and down each picture, and rays along the side of a pixel.
const SIZE: u32 = 176;
const SAMPLES: u32 = 2;
/// Pixels between pictures.
const GAP: u32 = 4;
/// Ends of the scale of differences, % of the mean.
const ENDS: f64 = 20.0;
/// Part of the brightest radiosity of the reference that becomes white: the lamp is not in the picture.
const EXPOSURE: f64 = 0.95;

/// A way to see the box.
struct Way {
    name: &'static str,
    /// Orders of the floor and of the lamp.
    orders: [Option<usize>; 2],
    options: Options,
    read: ReadMode,
}

fn main() -> Result<()> {
    let prefix = std::env::args().nth(1).unwrap_or_else(|| "docs/occluder-box".to_owned());
    in_threads(0, || {
        let reference = Way {
            name: "finest",
            orders: [None; 2],
            options: Quality::Finest.options(),
            read: ReadMode::GatherTwice,
        };
        let exact = picture(&reference);
        let taken = ways().map(|way| (way.name, picture(&way)));
        let floor = floor_pixels();
        println!("| picture | floor, % | all, rms in % of the mean | largest, % |");
        println!("| --- | --- | --- | --- |");
        for (name, raster) in &taken {
            let difference = Difference::new(&raster.field(None), &exact.field(None)).expect("one view");
            let Difference { rms, largest, .. } = difference;
            println!("| {name} | {:.2} | {rms:.2} | {largest:.1} |", 100.0 * error(raster, &exact, &floor));
        }
        let exposure = EXPOSURE * Image::new(&exact, [1.0; 3]).automatic_exposure();
        let photograph = |raster: &Raster| Image::new(raster, [1.0; 3]).exposed(exposure, Tone::Linear);
        let scale = Scale::diverging(ENDS);
        let compared = |raster: &Raster| {
            let difference = Difference::new(&raster.field(None), &exact.field(None)).expect("one view");
            false_colour(&difference.field, &scale)
        };
        let sheet = |name: &str, view: &dyn Fn(&Raster) -> Picture| {
            let file = BufWriter::new(File::create(format!("{prefix}-{name}.png"))?);
            side_by_side(&taken.each_ref().map(|(_, raster)| view(raster))).write_png(file)
        };
        sheet("pictures", &photograph)?;
        sheet("differences", &compared)
    })
    .expect("threads can be started")
}

/// The five of the table.
fn ways() -> [Way; 5] {
    let orders = [Some(8), None];
    let paper = Options { order: 4, subdivide: Some(1), ..Options::default() };
    let ringing = Options { shadows: Shadows::Rays, direct: Direct::Projected, ..paper };
    let cells = NonZeroUsize::new(40).expect("40 is not zero");
    let masked = |average| Options { masks: Some(Masking { cells, average }), ..paper };
    let split = Options { direct: Direct::Split, ..paper };
    [
        Way { name: "polynomials", orders, options: ringing, read: ReadMode::Basis },
        Way {
            name: "masks of 1993",
            orders: [Some(8); 2],
            options: masked(Average::Plain),
            read: ReadMode::Basis,
        },
        Way {
            name: "weighted masks",
            orders: [Some(8); 2],
            options: masked(Average::Weighted),
            read: ReadMode::Basis,
        },
        Way { name: "--read direct", orders, options: split, read: ReadMode::Direct },
        Way { name: "--read gather", orders, options: split, read: ReadMode::Gather },
    ]
}

fn scene(orders: [Option<usize>; 2]) -> Scene {
    let mut scene = radiosity::builtin("occluder-box").expect("the scene is built in");
    for (name, order) in ["floor", "lamp"].into_iter().zip(orders) {
        let surface = scene.surface_named(name).expect("it is there");
        scene.surfaces[surface].order = order;
    }
    scene
}

fn camera(scene: &Scene) -> Camera {
    let camera = scene.camera.clone().expect("the scene has a camera");
    Camera { width: SIZE, height: SIZE, ..camera }
}

fn picture(way: &Way) -> Raster {
    let scene = scene(way.orders);
    let outcome = solve(&scene, &way.options, &Work::alone()).expect("the box can be solved");
    let visibility = way.options.visibility(&scene);
    render(
        &outcome.solution,
        &visibility,
        &camera(&scene),
        SAMPLES,
        way.read,
        Quantity::Radiosity,
        &Work::alone(),
    )
}

/// Whether all rays of each pixel meet the floor.
fn floor_pixels() -> Vec<bool> {
    let scene = scene([None; 2]);
    let floor = scene.surface_named("floor").expect("it is there");
    let visibility = Options::default().visibility(&scene);
    let view = Pinhole::new(&camera(&scene));
    let offsets = || (0..SAMPLES).map(|k| (f64::from(k) + 0.5) / f64::from(SAMPLES));
    let pixel = |index: u32| {
        let (x, y) = (f64::from(index % SIZE), f64::from(index / SIZE));
        let mut rays = offsets().flat_map(|dx| offsets().map(move |dy| (dx, dy)));
        rays.all(|(dx, dy)| {
            visibility.nearest(&view.ray(x + dx, y + dy)).is_some_and(|met| met.surface == floor)
        })
    };
    (0..SIZE * SIZE).map(pixel).collect()
}

/// ‖B − B′‖₂ / ‖B′‖₂ over the pixels that count.
fn error(raster: &Raster, exact: &Raster, counts: &[bool]) -> f64 {
    let pairs = raster.pixels().zip(exact.pixels()).zip(counts).filter(|(_, counts)| **counts);
    let squares = |[difference, norm]: [f64; 2], ((own, other), _): ((&[f64], &[f64]), &bool)| {
        [difference + (own[0] - other[0]).powi(2), norm + other[0].powi(2)]
    };
    let [difference, norm] = pairs.fold([0.0; 2], squares);
    (difference / norm).sqrt()
}

fn side_by_side(pictures: &[Picture]) -> Picture {
    let count = pictures.len() as u32;
    let mut sheet = Picture::filled(count * (SIZE + GAP) - GAP, SIZE, [255; 3]);
    for (place, picture) in (0..).zip(pictures) {
        let left = place * (SIZE + GAP) as i32;
        for (x, y) in (0..SIZE as i32).flat_map(|x| (0..SIZE as i32).map(move |y| (x, y))) {
            let colour = picture.at(x, y).expect("it is inside");
            sheet.blend(left + x, y, colour, 1.0);
        }
    }
    sheet
}
