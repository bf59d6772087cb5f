//! Films as animated PNG, which browsers show: all colours of the pictures, none lost.

use std::io;
use std::path::Path;

use radiosity_output::drawings::picture::Picture;

use super::refusal::refused;
use crate::error::CliError;
use crate::output_file::OutputFile;

/// Units of time in a second in which it is stored how long a picture stays. Chosen: a picture of up to a minute.
const UNITS: u16 = 1000;

/// Most pictures a second: each stays for a unit at least.
const FASTEST: f64 = UNITS as f64;

/// An animated PNG, written at the end.
#[derive(Debug)]
pub(super) struct Apng {
    output: OutputFile,
    fps: f64,
    /// Pixels across and down.
    size: [u32; 2],
    /// Red, green and blue of all pixels of each picture.
    pictures: Vec<Vec<u8>>,
}

impl Apng {
    /// Refuses pictures a second that a film of this name cannot have.
    pub(super) fn require_speed(name: &Path, fps: f64) -> Result<(), CliError> {
        require_slowness(name, fps, FASTEST)?;
        if fps <= FASTEST {
            return Ok(());
        }
        Err(refused(
            name,
            &format!("an .apng shows {FASTEST} pictures a second at the most, and {fps} were asked for"),
            "add --fps 50, which screens show, or choose a film ending in .mp4 or .webm",
        ))
    }

    /// A film of so many pictures a second, of which there is none yet.
    pub(super) fn new(output: OutputFile, fps: f64) -> Self {
        Self { output, fps, size: [0; 2], pictures: Vec::new() }
    }

    /// Adds a picture.
    pub(super) fn add(&mut self, picture: &Picture) {
        if !self.output.is_elsewhere() {
            self.size = picture.size();
            self.pictures.push(picture.codes().to_vec());
        }
    }

    /// Writes the film, which is shown again and again.
    pub(super) fn finish(self) -> Result<(), CliError> {
        let Self { output, fps, size: [width, height], pictures } = self;
        output.write(|writer| {
            let mut encoder = png::Encoder::new(writer, width, height);
            encoder.set_color(png::ColorType::Rgb);
            encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
            encoder.set_animated(pictures.len() as u32, 0).map_err(io::Error::other)?;
            let mut frames = encoder.write_header().map_err(io::Error::other)?;
            for (number, picture) in pictures.iter().enumerate() {
                let time = delay(number, fps, f64::from(UNITS));
                frames.set_frame_delay(time, UNITS).map_err(io::Error::other)?;
                frames.write_image_data(picture).map_err(io::Error::other)?;
            }
            frames.finish().map_err(io::Error::other)
        })
    }
}

/// Refuses so few pictures a second that the time for which one stays, in `units` of a second, has no number of 16
/// bits.
pub(super) fn require_slowness(name: &Path, fps: f64, units: f64) -> Result<(), CliError> {
    let longest = f64::from(u16::MAX) / units;
    if fps * longest >= 1.0 {
        return Ok(());
    }
    Err(refused(
        name,
        &format!(
            "a picture of such a film stays for {longest} s at the most, and {fps} a second were asked for"
        ),
        "raise --fps, or choose a film ending in .mp4 or .webm",
    ))
}

/// Time for which the picture of this number stays, in `units` of a second. Each ends at the nearest unit to where it
/// should: rounding does not add up.
pub(super) fn delay(picture: usize, fps: f64, units: f64) -> u16 {
    let end = |picture: usize| (units * picture as f64 / fps).round();
    (end(picture + 1) - end(picture)) as u16
}
