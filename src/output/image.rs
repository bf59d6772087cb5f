//! Pictures: linear pixels, exposure, sRGB, PNG.

use std::io::{self, Write};

/// A picture in linear light, three channels per pixel, rows from the top.
#[derive(Clone, Debug)]
pub struct Image {
    width: u32,
    height: u32,
    pixels: Vec<[f64; 3]>,
}

impl Image {
    /// A picture of `width × height` pixels in row order from the top left.
    ///
    /// # Panics
    /// If the number of pixels is not `width · height`.
    pub fn new(width: u32, height: u32, pixels: Vec<[f64; 3]>) -> Self {
        assert_eq!(pixels.len(), width as usize * height as usize, "one entry per pixel");
        Self { width, height, pixels }
    }

    /// Linear pixels in row order.
    pub fn pixels(&self) -> &[[f64; 3]] {
        &self.pixels
    }

    /// Exposure that brings the brightest fiftieth of the pixels that are not black to white: 1 over the
    /// 98th percentile of their largest channel; 1 for a black picture.
    pub fn automatic_exposure(&self) -> f64 {
        let mut levels: Vec<f64> =
            self.pixels.iter().map(|p| p.iter().copied().fold(0.0, f64::max)).filter(|x| *x > 0.0).collect();
        if levels.is_empty() {
            return 1.0;
        }
        levels.sort_by(f64::total_cmp);
        1.0 / levels[(levels.len() - 1) * 98 / 100]
    }

    /// Writes an 8-bit sRGB PNG of the pixels times `exposure`, clipped at white.
    ///
    /// # Errors
    /// Whatever the writer reports.
    pub fn write_png(&self, exposure: f64, writer: impl Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(writer, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        let bytes: Vec<u8> = self.pixels.iter().flatten().map(|x| quantise(x * exposure)).collect();
        let mut stream = encoder.write_header()?;
        stream.write_image_data(&bytes)?;
        stream.finish()?;
        Ok(())
    }
}

/// Linear light in [0, 1], clipped, to the sRGB code (IEC 61966-2-1).
fn quantise(linear: f64) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let encoded = if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 };
    (255.0 * encoded).round() as u8
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn srgb_ends_and_middle() {
        assert_eq!(quantise(-1.0), 0);
        assert_eq!(quantise(0.0), 0);
        assert_eq!(quantise(1.0), 255);
        assert_eq!(quantise(7.0), 255);
        assert_eq!(quantise(0.5), 188);
        assert_eq!(quantise(0.003), 10);
    }

    #[test]
    fn png_starts_with_its_signature_and_size() {
        let image = Image::new(2, 1, vec![[0.0; 3], [1.0; 3]]);
        let mut bytes = Vec::new();
        image.write_png(1.0, &mut bytes).expect("a vector takes everything");
        assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
        assert_eq!(&bytes[16..24], &[0, 0, 0, 2, 0, 0, 0, 1]);
    }
}
