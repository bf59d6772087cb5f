//! Files of the pictures of frames: one for each, or one film.

use std::io;
use std::path::{Path, PathBuf};

use gif::Repeat;
use radiosity_output::drawings::picture::Picture;
use radiosity_output::files::exr_file::write_exr;
use radiosity_reading::pictures::raster::Raster;
use radiosity_work::ranks::Ranks;

use super::apng::{Apng, delay, require_slowness};
use super::encoder::{Container, Encoder, require_program};
use super::refusal::refused;
use crate::error::CliError;
use crate::loaded::Loaded;
use crate::output_file::OutputFile;

/// Pictures a second where nothing says how long a frame lasts.
const FPS: f64 = 25.0;

/// Units of time in a second, as GIF counts how long a picture stays.
const GIF_UNITS: f64 = 100.0;

/// Most pictures a second of a GIF: viewers slow down shorter ones.
const FASTEST: f64 = 50.0;

/// Speed of the search for the 256 colours of a GIF, from 1 to 30, coarsest; chosen: 10 is three times as
/// fast, and the loss is hardly seen.
const SPEED: i32 = 10;

/// Files of the pictures of frames.
#[derive(Debug)]
pub(super) enum FrameFiles {
    /// A file for each frame.
    Files(Pattern),
    /// One animated GIF, written at the end.
    Gif { output: OutputFile, fps: f64, size: [u16; 2], frames: Vec<gif::Frame<'static>> },
    /// One animated PNG, written at the end.
    Apng(Apng),
    /// One film by a program that gets the pictures as they are made; none before the first.
    Encoded { output: Option<OutputFile>, container: Container, fps: f64, encoder: Option<Encoder> },
}

/// A name in which a run of # stands for the number of a frame.
#[derive(Debug)]
pub(super) struct Pattern {
    before: String,
    digits: usize,
    after: String,
    is_exr: bool,
}

impl FrameFiles {
    /// The files of a name as typed; finds out whether they can be written. Pictures a second are those that
    /// were `typed`, or those `of_scene`.
    pub(super) fn new(
        name: &Path,
        typed: Option<f64>,
        of_scene: Option<f64>,
        first: usize,
        loaded: &Loaded,
        ranks: &Ranks,
    ) -> Result<Self, CliError> {
        let fps = typed.or(of_scene).unwrap_or(FPS);
        let ending = name.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let reserved = |path: &Path| loaded.apart(OutputFile::reserve(path, ranks)?);
        match ending.as_deref() {
            Some("gif") => {
                require_speed_of_gif(name, fps)?;
                Ok(Self::Gif { output: reserved(name)?, fps, size: [0; 2], frames: Vec::new() })
            }
            Some("apng") => {
                Apng::require_speed(name, fps)?;
                Ok(Self::Apng(Apng::new(reserved(name)?, fps)))
            }
            Some(ending @ ("png" | "exr")) => {
                let pattern = Pattern::without_speed(name, ending == "exr", typed)?;
                reserved(&pattern.path(first))?;
                Ok(Self::Files(pattern))
            }
            Some(ending) if let Some(container) = Container::of(ending) => {
                if ranks.is_first() {
                    require_program(name)?;
                }
                Ok(Self::Encoded { output: Some(reserved(name)?), container, fps, encoder: None })
            }
            _ => Err(refused(
                name,
                "the ending names no kind of pictures",
                "choose names such as frame-####.png or frame-####.exr, or a film ending in .gif, .apng, .mp4 or .webm",
            )),
        }
    }

    /// Whether the picture of a frame is there already.
    pub(super) fn has(&self, frame: usize, ranks: &Ranks) -> bool {
        // Others may look when it has just been written.
        let Self::Files(pattern) = self else { return false };
        ranks.of_first(pattern.path(frame).exists())
    }

    /// Whether the files hold values rather than colours.
    pub(super) fn is_exr(&self) -> bool {
        matches!(self, Self::Files(pattern) if pattern.is_exr)
    }

    /// Takes the picture of a frame, of what is `shown`: a quantity and its unit; files are written at once.
    pub(super) fn add(
        &mut self,
        frame: usize,
        raster: &Raster,
        shown: [&str; 2],
        picture: impl FnOnce() -> Picture,
        ranks: &Ranks,
    ) -> Result<(), CliError> {
        match self {
            Self::Files(pattern) => {
                let output = OutputFile::reserve(&pattern.path(frame), ranks)?;
                if pattern.is_exr {
                    return output.write(|writer| write_exr(raster, shown, writer));
                }
                let picture = picture();
                output.write(|writer| picture.write_png(writer))
            }
            Self::Gif { output, fps, size, frames } => {
                let picture = picture();
                if output.is_elsewhere() {
                    return Ok(());
                }
                let [width, height] = picture.size().map(|pixels| pixels as u16);
                let mut frame = gif::Frame::from_rgb_speed(width, height, picture.codes(), SPEED);
                frame.delay = delay(frames.len(), *fps, GIF_UNITS);
                *size = [width, height];
                frames.push(frame);
                Ok(())
            }
            Self::Apng(film) => {
                film.add(&picture());
                Ok(())
            }
            Self::Encoded { output, container, fps, encoder } => {
                let picture = picture();
                if output.as_ref().is_some_and(OutputFile::is_elsewhere) {
                    return Ok(());
                }
                if let Some(output) = output.take() {
                    *encoder = Some(Encoder::start(output, *container, picture.size(), *fps)?);
                }
                encoder.as_mut().map_or(Ok(()), |encoder| encoder.add(picture.codes()))
            }
        }
    }

    /// Writes the film, where it is one.
    pub(super) fn finish(self) -> Result<(), CliError> {
        let (output, [width, height], frames) = match self {
            Self::Files(_) => return Ok(()),
            Self::Apng(film) => return film.finish(),
            Self::Encoded { encoder, .. } => return encoder.map_or(Ok(()), Encoder::finish),
            Self::Gif { output, size, frames, .. } => (output, size, frames),
        };
        output.write(|writer| {
            let mut encoder = gif::Encoder::new(writer, width, height, &[]).map_err(io::Error::other)?;
            encoder.set_repeat(Repeat::Infinite).map_err(io::Error::other)?;
            frames.iter().try_for_each(|frame| encoder.write_frame(frame)).map_err(io::Error::other)
        })
    }
}

/// Refuses more pictures a second than viewers show of a GIF, or fewer than it can have.
fn require_speed_of_gif(name: &Path, fps: f64) -> Result<(), CliError> {
    require_slowness(name, fps, GIF_UNITS)?;
    if fps <= FASTEST {
        return Ok(());
    }
    Err(refused(
        name,
        &format!("a .gif shows {FASTEST} pictures a second at the most, and {fps} were asked for"),
        "add --fps 50, or write pictures of their own: frame-####.png",
    ))
}

impl Pattern {
    /// The pattern of a name, of files that have no speed: none may be `typed`.
    fn without_speed(name: &Path, is_exr: bool, typed: Option<f64>) -> Result<Self, CliError> {
        if typed.is_some() {
            return Err(refused(
                name,
                "files have no speed",
                "leave out --fps, or choose a film ending in .gif, .apng, .mp4 or .webm",
            ));
        }
        let missing = || {
            refused(
                name,
                "one name for all frames",
                "write #### where the number of the frame goes, as in frame-####.png",
            )
        };
        Self::of(name, is_exr).ok_or_else(missing)
    }

    /// The pattern of a name; None without a run of #, or with several.
    fn of(name: &Path, is_exr: bool) -> Option<Self> {
        let text = name.to_str()?;
        let start = text.find('#')?;
        let end = text.rfind('#')? + 1;
        let all = text[start..end].bytes().all(|byte| byte == b'#');
        all.then(|| Self {
            before: text[..start].to_owned(),
            digits: end - start,
            after: text[end..].to_owned(),
            is_exr,
        })
    }

    /// The file of a frame.
    fn path(&self, frame: usize) -> PathBuf {
        let Self { before, digits, after, .. } = self;
        format!("{before}{frame:0digits$}{after}").into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_the_place_of_the_run() {
        let pattern = |name: &str| Pattern::of(Path::new(name), false).map(|pattern| pattern.path(7));
        assert_eq!(pattern("out/f-####.png"), Some("out/f-0007.png".into()));
        assert_eq!(pattern("#.png"), Some("7.png".into()));
        assert_eq!(pattern("f.png"), None);
        assert_eq!(pattern("#-#.png"), None);
    }
}
