//! Cost, forecast and error of pictures: seconds of the processor, error against light computed anew, and the
//! largest joint between elements.
//!
//! `cargo run --release -p radiosity-studies --bin pictures -- [SCENE [--eye X,Y,Z] [--target X,Y,Z]
//! [--view-up X,Y,Z] [--fov DEGREES]] [--size WxH[,WxH...]] [--frames N] [--judge SECONDS]`
//!
//! A scene, built in or a file, is solved and taken as `radiosity render SCENE` does, on one thread, in each of the
//! sizes; without one those that are built in. `s` are seconds of the processor; `forecast` is what is told before
//! the picture, `gathers` the places at which reflected light is gathered, and `exponent` p of seconds ~ pixelsᵖ since
//! the size before. The error is that of the radiosity at 1000 pixels, evenly chosen, fewer where these take more than
//! a minute or `--judge`, lamps left out, over the root mean square of the radiosity: against light gathered to 1e-3 or
//! less. A joint is what the error changes by, over the mean radiosity, from pixels to the next where these see
//! different elements of one surface: the mean over sixteen pixels along a joint, since a step shows where it runs on;
//! the largest of fifty such runs, evenly chosen, or of as many as a minute takes. The largest step between two single
//! pixels stands beside it: it has the noise of both pixels and of the light that they are compared with. With
//! `--judge 0` no errors are judged; with `--frames` the first frames of a scene that moves are one film.

#![expect(clippy::print_stdout, reason = "a table for people")]

mod asked;
mod cost;
mod errors;

use std::borrow::Cow;
use std::error::Error;
use std::ffi::OsStr;
use std::path::Path;

use radiosity::scene::{Camera, Scene};
use radiosity::solve::{Options, in_threads};
use radiosity::{Solved, Work};

use asked::Asked;
use cost::Cost;
use errors::{Errors, Joints};

/// Scenes that are taken unless others are asked for; the last ones in smaller sizes.
const SCENES: [(&str, Option<[u32; 2]>); 6] = [
    ("cornell-box", None),
    ("two-boxes", None),
    ("occluder-box", None),
    ("empty-box", None),
    ("teapot", Some([320, 240])),
    ("temple", Some([240, 192])),
];

fn main() -> Result<(), Box<dyn Error>> {
    let asked = Asked::typed()?;
    println!(
        "| scene | pixels | solve s | picture s | forecast s | gathers | exponent | judged | rms error % | largest % | \
         joints | largest joint % | largest step % |"
    );
    println!("| --- |{}", " --- |".repeat(12));
    let of = || match &asked.scene {
        Some(name) => rows(name, &asked),
        None => SCENES.iter().try_for_each(|(name, size)| {
            let sizes = size.map_or_else(|| asked.sizes.clone(), |size| vec![size]);
            rows(name, &Asked { sizes, ..asked.clone() })
        }),
    };
    in_threads(1, || of().map_err(|error| error.to_string()))??;
    Ok(())
}

/// Prints the rows of a scene.
fn rows(name: &str, asked: &Asked) -> Result<(), Box<dyn Error>> {
    let scene = radiosity::load(name)?;
    let camera = asked.view.of(&scene)?.camera;
    let own = vec![[camera.width, camera.height]];
    let sizes = if asked.sizes.is_empty() { &own } else { &asked.sizes };
    let mut before: Option<Cost> = None;
    for [width, height] in sizes.iter().copied() {
        let camera = Camera { width, height, ..camera.clone() };
        let cost = match asked.frames {
            Some(frames) => Cost::of_film(&scene, &camera, frames)?,
            None => Cost::of_picture(&scene, &camera)?,
        };
        let judges = asked.judge > 0.0 && asked.frames.is_none();
        let errors = if judges { judged(&scene, &camera, asked.judge)? } else { " | | | | | |".to_owned() };
        let exponent = before.map_or_else(String::new, |before| format!("{:.2}", cost.exponent(&before)));
        let Cost { solve, picture, forecast, gathers, .. } = cost;
        println!(
            "| {} | {width} × {height} | {solve:.2} | {picture:.2} | {forecast:.2} | {gathers} | {exponent} |{errors}",
            stem(name),
        );
        before = Some(cost);
    }
    Ok(())
}

/// The cells of the errors of a picture.
fn judged(scene: &Scene, camera: &Camera, longest: f64) -> Result<String, Box<dyn Error>> {
    let solved = Solved::new(scene.clone(), Options::default(), &Work::alone())?;
    let errors = Errors::of(&solved.outcome.solution, solved.visibility(), camera);
    let (pixels, Joints { runs, joint, step }) = (errors.judged(longest), errors.joints(longest));
    let [rms, largest, joint, step] = [pixels.rms, pixels.largest, joint, step].map(|part| 100.0 * part);
    Ok(format!(" {} | {rms:.2} | {largest:.1} | {runs} | {joint:.2} | {step:.2} |", pixels.pixels))
}

/// The name of a scene, of a file without its folder and its ending.
fn stem(name: &str) -> Cow<'_, str> {
    Path::new(name).file_stem().map_or(Cow::Borrowed(name), OsStr::to_string_lossy)
}
