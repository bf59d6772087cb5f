//! PNG: grey, coloured or of a palette, 1 to 16 bits, interlaced or not.
//!
//! The coding that is asked for counts, else that of an `sRGB` chunk, else that of a `gAMA` chunk; without
//! them pictures of up to 8 bits are sRGB and those of 16 bits linear. Reference: W3C, *Portable Network
//! Graphics*, third edition (2025).

use std::io::Cursor;

use png::{BitDepth, ColorType, Decoder, DecodingError, Info, Reader, Transformations};
use radiosity_photometry::error::Refusal;

use super::coding::{Coding, Curve};
use super::reduction::{Picture, Reduction};
use super::refusals::{check_size, damaged, transparent};

/// A pass over the texels: columns and rows from one of its texels to the next, and the first of them.
type Pass = ([usize; 2], [usize; 2]);

/// The passes of Adam7 (PNG, section 8.1).
const INTERLACED: [Pass; 7] = [
    ([8, 8], [0, 0]),
    ([8, 8], [4, 0]),
    ([4, 8], [0, 4]),
    ([4, 4], [2, 0]),
    ([2, 4], [0, 2]),
    ([2, 2], [1, 0]),
    ([1, 2], [0, 1]),
];

/// The pass of a picture that is not interlaced.
const PLAIN: [Pass; 1] = [([1, 1], [0, 0])];

/// Reads a PNG, averaged to at most `most` texels; without `coding`, the file itself tells its coding.
pub(super) fn read(bytes: &[u8], coding: Option<Coding>, most: usize) -> Result<Picture, Refusal> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    // Palettes become colours, grey of few bits becomes 8 bits, a transparent colour an alpha channel.
    decoder.set_transformations(Transformations::EXPAND);
    decoder.set_ignore_text_chunk(true);
    let [columns, rows] = {
        let info = decoder.read_header_info().map_err(fault)?;
        check_size([u64::from(info.width), u64::from(info.height)])?;
        [info.width, info.height].map(|side| side as usize)
    };
    let mut reader = decoder.read_info().map_err(fault)?;
    let info = reader.info();
    let curve = coding.map_or_else(|| curve(info), Curve::Of);
    let passes: &[Pass] = if info.interlaced { &INTERLACED } else { &PLAIN };
    let mut remarks = vec![format!("{} bits, {}", info.bit_depth as u8, curve.title())];
    if info.icc_profile.is_some() || info.coding_independent_code_points.is_some() {
        remarks.push("its colour profile left out".to_owned());
    }
    let texels = Texels::of(&reader, curve);
    let mut reduction = Reduction::new([columns, rows], texels.colours, most);
    for ([dx, dy], [x, y]) in passes.iter().filter(|(_, [x, y])| *x < columns && *y < rows) {
        for row in (*y..rows).step_by(*dy) {
            let line = reader.next_interlaced_row().map_err(fault)?;
            let line = line.ok_or_else(|| damaged("rows are missing"))?;
            texels.take(line.data(), (*x..columns).step_by(*dx), row, &mut reduction);
        }
    }
    // What follows the texels tells whether the file is whole.
    reader.finish().map_err(fault)?;
    reduction.finish(remarks)
}

/// The curve that the file states, or that of pictures that state none.
fn curve(info: &Info<'_>) -> Curve {
    match (info.srgb, info.gama_chunk) {
        (Some(_), _) => Curve::Of(Coding::Srgb),
        (None, Some(gamma)) if gamma.into_value() > 0.0 => {
            Curve::of_gamma(f64::from(gamma.into_scaled()) / 1e5)
        }
        _ if info.bit_depth == BitDepth::Sixteen => Curve::Of(Coding::Linear),
        _ => Curve::Of(Coding::Srgb),
    }
}

fn fault(error: DecodingError) -> Refusal {
    damaged(error)
}

/// Format of the texels in a row of bytes.
struct Texels {
    /// Light of every number, 0 to 255 or to 65535.
    light: Vec<f64>,
    is_wide: bool,
    /// Number of colours: 1 of grey; 3 of red, green and blue.
    colours: usize,
    has_alpha: bool,
}

impl Texels {
    fn of(reader: &Reader<Cursor<&[u8]>>, curve: Curve) -> Self {
        let (colour, depth) = reader.output_color_type();
        let is_wide = depth == BitDepth::Sixteen;
        let last: u32 = if is_wide { u16::MAX.into() } else { u8::MAX.into() };
        let light = (0..=last).map(|number| curve.light(f64::from(number) / f64::from(last))).collect();
        Self {
            light,
            is_wide,
            colours: if matches!(colour, ColorType::Grayscale | ColorType::GrayscaleAlpha) { 1 } else { 3 },
            has_alpha: matches!(colour, ColorType::GrayscaleAlpha | ColorType::Rgba),
        }
    }

    /// Takes in a row, whose texels stand in these columns.
    fn take(&self, line: &[u8], columns: impl Iterator<Item = usize>, row: usize, to: &mut Reduction) {
        let samples = self.colours + usize::from(self.has_alpha);
        let opaque = self.light.len() - 1;
        let width = if self.is_wide { 2 } else { 1 };
        let mut values = [0.0; 3];
        for (column, texel) in columns.zip(line.chunks_exact(samples * width)) {
            let number = |sample: usize| match self.is_wide {
                true => usize::from(u16::from_be_bytes([texel[2 * sample], texel[2 * sample + 1]])),
                false => usize::from(texel[sample]),
            };
            if self.has_alpha && number(self.colours) != opaque {
                to.refuse(|| transparent([column, row]));
            }
            for (colour, value) in values[..self.colours].iter_mut().enumerate() {
                *value = self.light[number(colour)];
            }
            to.add([column, row], &values[..self.colours]);
        }
    }
}
