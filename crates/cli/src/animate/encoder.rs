//! Films by `ffmpeg`, which gets the pictures through a pipe as they are made.
//!
//! They come as rows of red, green and blue and are stored as yuv420p, which all players show: brightness for
//! each pixel, colour for four together, so that sizes are even. The film grows in a temporary file, which
//! takes the name that was typed when it is complete.

use std::io::{self, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdin, Command, Stdio};
use std::thread::{self, JoinHandle};

use crate::error::CliError;
use crate::interrupt::{dismiss, employ};
use crate::output_file::{Draft, OutputFile};

/// Name of the program.
const PROGRAM: &str = "ffmpeg";

/// The kind of a film's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Container {
    Mp4,
    WebM,
}

/// A film while it is made.
#[derive(Debug)]
pub(super) struct Encoder {
    output: OutputFile,
    /// Temporary file of the film; None when the film is in place.
    draft: Option<Draft>,
    size: [u32; 2],
    pipe: Option<ChildStdin>,
    /// Messages of the program, read to their end in a thread.
    complaints: Option<JoinHandle<String>>,
}

impl Container {
    /// The container that the `ending` of a file names; None for others.
    pub(super) fn of(ending: &str) -> Option<Self> {
        match ending {
            "mp4" => Some(Self::Mp4),
            "webm" => Some(Self::WebM),
            _ => None,
        }
    }

    /// Arguments of the program: the container's format and coding.
    fn arguments(self) -> &'static [&'static str] {
        match self {
            // The index stands at the beginning, where players need it first.
            Self::Mp4 => &["-movflags", "+faststart", "-f", "mp4"],
            Self::WebM => &["-f", "webm"],
        }
    }
}

/// Refuses a film if the program cannot be started.
pub(super) fn require_program(film: &Path) -> Result<(), CliError> {
    let mut command = Command::new(PROGRAM);
    command.arg("-version").stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let reason = match command.status() {
        Ok(status) if status.success() => return Ok(()),
        Ok(status) => format!("it ended with {status}"),
        Err(error) if error.kind() == io::ErrorKind::NotFound => "it was not found".to_owned(),
        Err(error) => error.to_string(),
    };
    Err(CliError::refused(
        format!("{}: films other than .gif and .apng are made by {PROGRAM}: {reason}", film.display()),
        "install it so that it is on the PATH (apt install ffmpeg, brew install ffmpeg, winget install ffmpeg), or choose \
               a film ending in .gif or .apng or pictures such as frame-####.png, which need nothing else",
    ))
}

impl Encoder {
    /// A film of pictures of this size in pixels, `fps` a second; nothing is shown yet.
    pub(super) fn start(
        output: OutputFile,
        container: Container,
        size: [u32; 2],
        fps: f64,
    ) -> Result<Self, CliError> {
        let draft = output.draft()?;
        let [width, height] = size.map(even);
        let mut command = Command::new(PROGRAM);
        command.args([
            "-hide_banner",
            "-loglevel",
            "error",
            "-y",
            "-f",
            "rawvideo",
            "-pixel_format",
            "rgb24",
        ]);
        command.args([
            "-video_size",
            &format!("{width}x{height}"),
            "-framerate",
            &fps.to_string(),
            "-i",
            "-",
        ]);
        command.args(["-an", "-vf", "scale=out_color_matrix=bt709", "-pix_fmt", "yuv420p"]);
        command.args(["-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709"]);
        command.args(container.arguments()).arg(draft.path());
        command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = command.spawn().map_err(|reason| output.unwritten(reason))?;
        let (pipe, complaints) = (child.stdin.take(), child.stderr.take().map(read_all));
        employ(child);
        Ok(Self { output, draft: Some(draft), size, pipe, complaints })
    }

    /// Adds a picture: red, green and blue of all pixels, in row order.
    pub(super) fn add(&mut self, codes: &[u8]) -> Result<(), CliError> {
        let picture = padded(codes, self.size);
        let sent = self.pipe.as_mut().map_or(Ok(()), |pipe| pipe.write_all(&picture));
        // The program says more about it than a broken pipe does.
        sent.or_else(|error| self.end().and(Err(self.output.unwritten(error))))
    }

    /// Puts the film in place.
    pub(super) fn finish(mut self) -> Result<(), CliError> {
        self.end()?;
        self.draft.take().map_or(Ok(()), |draft| self.output.put(draft))
    }

    /// Lets the program end.
    fn end(&mut self) -> Result<(), CliError> {
        drop(self.pipe.take());
        let status = dismiss().map(|mut child| child.wait()).transpose();
        let status = status.map_err(|error| self.output.unwritten(error))?;
        let said = self.complaints.take().and_then(|thread| thread.join().ok()).unwrap_or_default();
        match status {
            Some(status) if !status.success() => {
                let reason = format!("{PROGRAM} ended with {status}: {}", said.trim());
                Err(self.output.unwritten(io::Error::other(reason)))
            }
            _ => Ok(()),
        }
    }
}

impl Drop for Encoder {
    /// Ends the program if the film was given up.
    fn drop(&mut self) {
        drop(self.pipe.take());
        if let Some(mut child) = dismiss() {
            end_now(&mut child);
        }
    }
}

/// Ends a program whose work is not wanted.
fn end_now(child: &mut Child) {
    // Where it has ended already there is nothing to do.
    drop(child.kill());
    drop(child.wait());
}

/// Reads all that a program says.
fn read_all(mut from: ChildStderr) -> JoinHandle<String> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        drop(from.read_to_end(&mut bytes));
        String::from_utf8_lossy(&bytes).into_owned()
    })
}

/// The next even number.
fn even(pixels: u32) -> u32 {
    pixels.next_multiple_of(2)
}

/// The picture with its last column and its last row repeated where their number is odd.
fn padded(codes: &[u8], [width, height]: [u32; 2]) -> Vec<u8> {
    const BYTES: usize = 3;
    let row = BYTES * width as usize;
    let mut picture = Vec::with_capacity(BYTES * (even(width) * even(height)) as usize);
    let mut add = |codes: &[u8]| {
        picture.extend_from_slice(codes);
        if width % 2 == 1 {
            picture.extend_from_slice(&codes[row - BYTES..]);
        }
    };
    codes.chunks_exact(row).for_each(&mut add);
    if height % 2 == 1 {
        add(&codes[codes.len() - row..]);
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn odd_pictures_repeat_their_last_column_and_row() {
        // Three columns and one row, then two columns and two rows.
        let codes: Vec<u8> = (0..9).collect();
        let row = [0, 1, 2, 3, 4, 5, 6, 7, 8, 6, 7, 8];
        assert_eq!(padded(&codes, [3, 1]), [row, row].concat());
        let codes: Vec<u8> = (0..12).collect();
        assert_eq!(padded(&codes, [2, 2]), codes);
    }
}
