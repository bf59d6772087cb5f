//! Figures 7 and 8: one shadow, seven ways, in the box with a lamp and a hovering panel.
//!
//! Writes docs/occluder-box-pictures.png and docs/occluder-box-differences.png, each of seven pictures side
//! by side, and prints how far the radiosity of the floor's pixels is off (relative L2):
//!
//! 1. polynomials alone, of order 4, on the floor 8, by the rules of 1993 (figure 7), and
//! 2. by ours;
//! 3. direct light times masks of 40 × 40 cells, order 8 on the lamp too, by the rules of 1993 (figure 8), and
//! 4. by ours;
//! 5. with masks that average light instead of area;
//! 6. direct light exact at every point, the rest from polynomials of the same orders (`--read direct`);
//! 7. all light gathered anew at every point (`--read gather`).
//!
//! The second file shows the differences from the finest preset, blue where too dark, red where too bright,
//! white where equal; the ends of the scale are ±20 % of the mean radiosity.

use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};
use std::num::NonZeroUsize;

use radiosity::Work;
use radiosity::output::drawings::false_colour::false_colour;
use radiosity::output::drawings::picture::Picture;
use radiosity::output::drawings::scale::Scale;
use radiosity::output::pictures::image::Image;
use radiosity::published::zatz1993::masking::{Average, Masking};
use radiosity::published::zatz1993::transfers::PaperRules;
use radiosity::reading::difference::Difference;
use radiosity::reading::exposure::Exposure;
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::raster::Raster;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quality::Quality;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::ReadMode;
use radiosity::scene::{Camera, Scene};
use radiosity::solve::{Direct, Options, in_threads};

use crate::reproduction::{HYBRID, reproduced};

/// Start of the names of the files.
const PREFIX: &str = "docs/occluder-box";
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
    /// Rules of the transfers.
    kernel: Option<PaperRules>,
    options: Options,
    read: ReadMode,
}

/// Prints the errors, and writes the pictures and their differences.
pub(crate) fn figure_7(out: &mut impl Write) -> Result<(), Box<dyn Error>> {
    let reference = Way {
        name: "finest",
        orders: [None; 2],
        kernel: None,
        options: Quality::Finest.options(),
        read: ReadMode::GatherTwice,
    };
    let exact = picture(&reference)?;
    let taken = ways()?.into_iter().map(|way| Ok((way.name, picture(&way)?)));
    let taken = taken.collect::<Result<Vec<_>, Box<dyn Error>>>()?;
    let floor = floor_pixels();
    writeln!(out, "| figures 7, 8 | floor, % | all, rms in % of the mean | largest, % |")?;
    writeln!(out, "| --- | --- | --- | --- |")?;
    for (name, raster) in &taken {
        let Difference { rms, largest, .. } = compared(raster, &exact)?;
        let floor = 100.0 * error(raster, &exact, &floor);
        writeln!(out, "| {name} | {floor:.2} | {rms:.2} | {largest:.1} |")?;
    }
    let exposure = Exposure::fixed(EXPOSURE * Image::new(&exact, [1.0; 3]).automatic_exposure().factor());
    let photographs = taken.iter().map(|(_, raster)| Image::new(raster, [1.0; 3]).exposed(exposure));
    write_side_by_side("pictures", &photographs.collect::<Vec<_>>())?;
    let scale = Scale::diverging(ENDS);
    let differences =
        taken.iter().map(|(_, raster)| Ok(false_colour(&compared(raster, &exact)?.field, &scale)));
    write_side_by_side("differences", &differences.collect::<Result<Vec<_>, Box<dyn Error>>>()?)
}

fn compared(raster: &Raster, exact: &Raster) -> Result<Difference, Box<dyn Error>> {
    Ok(Difference::new(&raster.field(None), &exact.field(None)).ok_or("two views")?)
}

/// The seven of the table.
fn ways() -> Result<[Way; 7], Box<dyn Error>> {
    let paper = Options { order: 4, subdivide: Some(1), ..Options::default() };
    let ringing = Options { direct: Direct::Projected, ..paper };
    let cells = NonZeroUsize::new(40).ok_or("no cells")?;
    let masked = |average| Options { masks: Some(Masking { cells, average }), ..paper };
    let (plain, weighted) = (masked(Average::Plain), masked(Average::Weighted));
    let split = Options { direct: Direct::Split, ..paper };
    let seven = |name, kernel, options, read| Way { name, orders: [Some(8), None], kernel, options, read };
    let eight =
        |name, kernel, options| Way { name, orders: [Some(8); 2], kernel, options, read: ReadMode::Basis };
    Ok([
        seven("figure 7: polynomials, rules of 1993", Some(HYBRID), ringing, ReadMode::Basis),
        seven("figure 7: polynomials, ours", None, ringing, ReadMode::Basis),
        eight("figure 8: masks of 1993, rules of 1993", Some(HYBRID), plain),
        eight("figure 8: masks of 1993, ours", None, plain),
        eight("weighted masks", None, weighted),
        seven("--read direct", None, split, ReadMode::Direct),
        seven("--read gather", None, split, ReadMode::Gather),
    ])
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

fn picture(way: &Way) -> Result<Raster, Box<dyn Error>> {
    let scene = scene(way.orders);
    let outcome = reproduced(&scene, way.kernel, &way.options)?.outcome;
    let visibility = way.options.visibility(&scene);
    let (solution, camera) = (&outcome.solution, camera(&scene));
    let work = Work::alone();
    Ok(in_threads(way.options.threads, || {
        PictureRequest {
            solution,
            visibility: &visibility,
            camera: &camera,
            samples: SAMPLES,
            read: way.read,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&work)
    })?)
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

fn write_side_by_side(name: &str, pictures: &[Picture]) -> Result<(), Box<dyn Error>> {
    let count = pictures.len() as u32;
    let mut sheet = Picture::filled(count * (SIZE + GAP) - GAP, SIZE, [255; 3]);
    for (place, picture) in (0..).zip(pictures) {
        let left = place * (SIZE + GAP) as i32;
        for (x, y) in (0..SIZE as i32).flat_map(|x| (0..SIZE as i32).map(move |y| (x, y))) {
            let colour = picture.at(x, y).expect("it is inside");
            sheet.blend(left + x, y, colour, 1.0);
        }
    }
    sheet.write_png(BufWriter::new(File::create(format!("{PREFIX}-{name}.png"))?))?;
    Ok(())
}
