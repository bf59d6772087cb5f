//! Pictures: PNG and OpenEXR → linear numbers of texels.
//!
//! A picture is read row by row and, where it has more texels than asked for, averaged on the way: memory is
//! that of the result, whatever the header says. What is done to it is told in its [`Picture::remarks`].
//!
//! Transparent texels are refused, since nothing says what is behind them. A picture that is opaque
//! everywhere may have an alpha channel.

use radiosity_photometry::error::{Refusal, refuse};

mod coding;
mod refusals;
mod reduction;
mod portable;
mod open;

pub use coding::Coding;
pub use reduction::Picture;

/// The beginnings of files of other kinds, by which they are named.
const OTHERS: [(&[u8], &str); 9] = [
    (b"\xff\xd8\xff", "a JPEG"),
    (b"GIF8", "a GIF"),
    (b"BM", "a BMP"),
    (b"II*\0", "a TIFF"),
    (b"MM\0*", "a TIFF"),
    (b"RIFF", "a WebP"),
    (b"#?", "a picture of Radiance"),
    (b"8BPS", "a picture of Photoshop"),
    (b"\0\0\0\x0cjP", "a JPEG 2000"),
];

/// Reads a PNG or an OpenEXR, averaged to at most `most` texels; `coding` goes before what the file says of a
/// PNG.
///
/// # Errors
/// Another kind of file, a damaged or cut one, more than 8192 × 8192 texels or 65536 along a side,
/// transparent texels, numbers that are not finite, channels other than grey or red, green and blue.
pub fn read(bytes: &[u8], coding: Option<Coding>, most: usize) -> Result<Picture, Refusal> {
    if bytes.starts_with(b"\x89PNG") {
        return portable::read(bytes, coding, most);
    }
    if bytes.starts_with(b"\x76\x2f\x31\x01") {
        return match coding {
            Some(Coding::Srgb) => refuse("an OpenEXR picture is linear, not sRGB", "leave the encoding out"),
            _ => open::read(bytes, most),
        };
    }
    let kind = OTHERS.iter().find(|(start, _)| bytes.starts_with(start)).map(|(_, kind)| *kind);
    refuse(
        format!("it is {}, not PNG or OpenEXR", kind.unwrap_or("no picture that is known")),
        "convert it, e.g. with ImageMagick: magick wood.jpg wood.png",
    )
}
