//! Makes the picture of `textured-room.toml`:
//!
//! ```text
//! cargo run --release -p radiosity-studies --bin wood -- examples/wood.png
//! ```

use std::{env, error::Error, fs::File};

use radiosity_test_support::grain;

fn main() -> Result<(), Box<dyn Error>> {
    let path = env::args().nth(1).ok_or("say where the picture is to be written")?;
    let [columns, rows] = grain::SIZE;
    let mut encoder = png::Encoder::new(File::create(path)?, columns as u32, rows as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    encoder.write_header()?.write_image_data(&grain::texels())?;
    Ok(())
}
