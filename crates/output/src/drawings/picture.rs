//! A picture of 8-bit sRGB pixels, to draw on and to write as PNG.
//!
//! Pixel (x, y) covers [x, x + 1] × [y, y + 1], y down. Disks are anti-aliased: a pixel takes the
//! colour by the part c ≈ clamp(½ + r − d, 0, 1) that a shape of half width r covers, with d the distance of
//! the pixel's middle from the shape's. Colours are mixed as they are encoded, which keeps thin dark letters
//! on white dark.

use std::io::{self, Write};

/// An sRGB colour.
pub type Colour = [u8; 3];

/// Pixels in rows from the top.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    width: u32,
    height: u32,
    pixels: Vec<Colour>,
    /// Remarks that files of it carry: keyword and text.
    remarks: Vec<[String; 2]>,
}

impl Picture {
    /// `width × height` pixels of one colour.
    pub fn filled(width: u32, height: u32, colour: Colour) -> Self {
        Self::new(width, height, vec![colour; width as usize * height as usize])
    }

    /// The pixels in row order from the top left.
    ///
    /// # Panics
    /// If the number of pixels is not `width · height`.
    pub(crate) fn new(width: u32, height: u32, pixels: Vec<Colour>) -> Self {
        assert_eq!(pixels.len(), width as usize * height as usize, "one entry per pixel");
        Self { width, height, pixels, remarks: Vec::new() }
    }

    /// The picture with a remark that a PNG of it carries, under a keyword of 1 to 79 Latin letters.
    #[must_use]
    pub fn with_remark(mut self, keyword: &str, text: String) -> Self {
        self.remarks.push([keyword.to_owned(), text]);
        self
    }

    /// Pixels across and down.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Red, green and blue of all pixels, in row order.
    pub fn codes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// The colour of pixel (x, y), or None outside.
    pub fn at(&self, x: i32, y: i32) -> Option<Colour> {
        self.index(x, y).map(|index| self.pixels[index])
    }

    /// Lets pixel (x, y) take `colour` by the part `coverage` in [0, 1]; outside the picture nothing happens.
    pub fn blend(&mut self, x: i32, y: i32, colour: Colour, coverage: f64) {
        let Some(index) = self.index(x, y) else { return };
        for (old, new) in self.pixels[index].iter_mut().zip(colour) {
            *old = (f64::from(*old) + (f64::from(new) - f64::from(*old)) * coverage).round() as u8;
        }
    }

    /// Fills the pixels x0 ≤ x < x1, y0 ≤ y < y1.
    pub(crate) fn fill(&mut self, [x0, x1]: [i32; 2], [y0, y1]: [i32; 2], colour: Colour) {
        for (y, x) in (y0..y1).flat_map(|y| (x0..x1).map(move |x| (y, x))) {
            self.blend(x, y, colour, 1.0);
        }
    }

    /// A disk.
    pub(crate) fn disk(&mut self, center: [f64; 2], radius: f64, colour: Colour) {
        let range = |k: usize| {
            let [low, high] = [center[k] - radius - 1.0, center[k] + radius + 1.0];
            low.floor() as i32..high.ceil() as i32
        };
        for (row, column) in range(1).flat_map(|row| range(0).map(move |column| (row, column))) {
            let distance = (f64::from(column) + 0.5 - center[0]).hypot(f64::from(row) + 0.5 - center[1]);
            self.blend(column, row, colour, (0.5 + radius - distance).clamp(0.0, 1.0));
        }
    }

    /// Lets the pixels of the left upper corner take `colour` by the parts `coverage`, in rows of `width`.
    pub fn overlay(&mut self, coverage: &[f64], width: u32, colour: Colour) {
        for (row, parts) in coverage.chunks(width as usize).enumerate() {
            for (column, part) in parts.iter().enumerate() {
                self.blend(column as i32, row as i32, colour, *part);
            }
        }
    }

    /// Copies `other` with its left upper corner at (x, y).
    pub(crate) fn paste(&mut self, other: &Self, [left, top]: [i32; 2]) {
        for (index, colour) in other.pixels.iter().enumerate() {
            let (x, y) = (index % other.width as usize, index / other.width as usize);
            self.blend(left + x as i32, top + y as i32, *colour, 1.0);
        }
    }

    /// Writes an 8-bit sRGB PNG, with the remarks as its international texts (`iTXt`).
    ///
    /// # Errors
    /// Whatever the writer reports.
    pub fn write_png(&self, writer: impl Write) -> io::Result<()> {
        let mut encoder = png::Encoder::new(writer, self.width, self.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
        for [keyword, text] in &self.remarks {
            encoder.add_itxt_chunk(keyword.clone(), text.clone())?;
        }
        let mut stream = encoder.write_header()?;
        stream.write_image_data(self.codes())?;
        stream.finish()?;
        Ok(())
    }

    fn index(&self, x: i32, y: i32) -> Option<usize> {
        let (x, y) = (u32::try_from(x).ok()?, u32::try_from(y).ok()?);
        (x < self.width && y < self.height).then_some(y as usize * self.width as usize + x as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn png_holds_its_pixels() {
        let picture = Picture::new(2, 1, vec![[0, 7, 255], [1, 2, 3]]);
        let picture = picture.with_remark("Exposure", "8 W/m² is white".to_owned());
        let mut bytes = Vec::new();
        picture.write_png(&mut bytes).expect("a vector takes everything");
        let mut reader = png::Decoder::new(io::Cursor::new(bytes)).read_info().expect("a PNG");
        let mut pixels = [0; 6];
        let info = reader.next_frame(&mut pixels).expect("a frame");
        assert_eq!((info.width, info.height), (2, 1));
        assert_eq!(pixels, [0, 7, 255, 1, 2, 3]);
        let texts = &reader.info().utf8_text;
        assert_eq!(texts[0].get_text().expect("it is plain"), "8 W/m² is white");
    }

    #[test]
    fn disks_cover_their_area() {
        let darkness =
            |picture: &Picture| -> f64 { picture.pixels.iter().map(|p| 1.0 - f64::from(p[0]) / 255.0).sum() };
        let mut disk = Picture::filled(64, 64, [255; 3]);
        disk.disk([31.3, 32.9], 20.0, [0; 3]);
        assert!((darkness(&disk) / (std::f64::consts::PI * 400.0) - 1.0).abs() < 0.01);
    }

    #[test]
    fn what_lies_outside_is_left_out() {
        let mut picture = Picture::filled(2, 2, [9; 3]);
        picture.blend(-1, 0, [0; 3], 1.0);
        picture.fill([2, 40], [-3, 0], [0; 3]);
        assert_eq!(picture, Picture::filled(2, 2, [9; 3]));
    }
}
