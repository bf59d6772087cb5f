//! Rasters as OpenEXR: 32-bit floating point, linear, without exposure or white balance.
//!
//! Three bands become the channels R, G and B; any other number one channel each, named as the band (`band-2`
//! where a name has letters outside Latin-1). The numbers are radiosities, or another quantity, in the
//! scene's unit, both of which the comment of the layer names; the radiance of a diffuse surface is the
//! radiosity over π. Channel A is the part of the pixel in which a surface is seen; it is left
//! out if a band is called A. The radiosities are means over the whole pixel, as the format wants colours:
//! multiplied by A.

use std::io::{self, Cursor, Read, Seek, Write};

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels, ReadLayers,
    Text, WritableImage, read,
};

use radiosity_reading::pictures::raster::Raster;

/// Channel of the coverage.
const COVERAGE: &str = "A";

/// Why a file is no raster of the bands asked for.
#[derive(Debug, thiserror::Error)]
pub enum ExrError {
    /// The file is not OpenEXR, or of a kind that is not read.
    #[error("it is no OpenEXR picture: {0}")]
    Format(String),
    /// The file has no channel for a band.
    #[error("it has no channel {wanted:?}; its channels: {present}")]
    Channel {
        /// Name of the channel wanted.
        wanted: String,
        /// Names of the file's channels, separated by commas.
        present: String,
    },
}

/// Writes `raster`, whose values are a `quantity` in a `unit`.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_exr(raster: &Raster, [quantity, unit]: [&str; 2], mut writer: impl Write) -> io::Result<()> {
    let [width, height] = raster.size().map(|x| x as usize);
    let names = channels(raster.bands());
    let mut list: Vec<AnyChannel<FlatSamples>> = (names.iter().enumerate())
        .map(|(k, name)| channel(name, raster.pixels().map(|values| values[k] as f32).collect()))
        .collect();
    if !names.iter().any(|name| name == COVERAGE) {
        list.push(channel(COVERAGE, raster.coverage().iter().map(|x| *x as f32).collect()));
    }
    let mut about = LayerAttributes::named("radiosity");
    about.comments = Some(comment(quantity, unit));
    let channels = AnyChannels::sort(list.into_iter().collect());
    let layer = Layer::new((width, height), about, Encoding::SMALL_LOSSLESS, channels);
    // The format wants to seek, which a pipe cannot.
    let mut bytes = Cursor::new(Vec::new());
    let written = Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes);
    written.map_err(|error| io::Error::other(error.to_string()))?;
    writer.write_all(&bytes.into_inner())
}

/// Reads the channels of `bands`, named as [`write_exr`] names them; without a channel A everything is seen.
///
/// # Errors
/// A file of another kind, or one without a channel for a band.
pub fn read_exr(reader: impl Read + Seek, bands: &[String]) -> Result<Raster, ExrError> {
    let image = read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer();
    let image = image.all_attributes().non_parallel().from_unbuffered(reader);
    let layer = image.map_err(|error| ExrError::Format(error.to_string()))?.layer_data;
    let list = &layer.channel_data.list;
    let find = |name: &str| list.iter().find(|channel| channel.name.to_string() == name);
    let wanted = |name: String| {
        let present = || list.iter().map(|channel| channel.name.to_string()).collect::<Vec<_>>().join(", ");
        find(&name).map(numbers).ok_or_else(|| ExrError::Channel { wanted: name, present: present() })
    };
    let channels: Vec<Vec<f64>> = channels(bands).into_iter().map(wanted).collect::<Result<_, _>>()?;
    let pixels = layer.size.0 * layer.size.1;
    let coverage = find(COVERAGE).map_or_else(|| vec![1.0; pixels], numbers);
    let values = (0..pixels).flat_map(|pixel| channels.iter().map(move |channel| channel[pixel])).collect();
    Ok(Raster::new([layer.size.0 as u32, layer.size.1 as u32], bands.to_vec(), values, coverage))
}

/// Comment that names the values and their unit, in ASCII: readers take other letters to be of Latin-1, as the
/// format does, or of UTF-8. Powers come down to the line; what else is no ASCII becomes a question mark.
fn comment(quantity: &str, unit: &str) -> Text {
    let radiance = if quantity == "radiosity" { "; radiance is radiosity / pi" } else { "" };
    let plain = |letter: char| match letter {
        '⁻' => '-',
        '¹' => '1',
        '²' => '2',
        '³' => '3',
        letter if letter.is_ascii() => letter,
        _ => '?',
    };
    let text: String = format!("{quantity} in {unit}, linear{radiance}").chars().map(plain).collect();
    Text::new_or_panic(text)
}

fn channels(bands: &[String]) -> Vec<String> {
    if bands.len() == 3 {
        return ["R", "G", "B"].map(str::to_owned).to_vec();
    }
    let name = |(index, band): (usize, &String)| match Text::new_or_none(band) {
        Some(_) if band != COVERAGE => band.clone(),
        _ => format!("band-{}", index + 1),
    };
    bands.iter().enumerate().map(name).collect()
}

fn channel(name: &str, samples: Vec<f32>) -> AnyChannel<FlatSamples> {
    AnyChannel::new(Text::new_or_panic(name), FlatSamples::F32(samples))
}

fn numbers(channel: &AnyChannel<FlatSamples>) -> Vec<f64> {
    channel.sample_data.values_as_f32().map(f64::from).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn raster(bands: &[&str]) -> Raster {
        let values = (0..6 * bands.len()).map(|k| k as f64 / 8.0 - 0.5).collect();
        let bands = bands.iter().map(|band| (*band).to_owned()).collect();
        Raster::new([3, 2], bands, values, vec![1.0, 1.0, 0.5, 0.0, 1.0, 0.25])
    }

    #[test]
    fn what_is_written_is_read() {
        for bands in [&["r", "g", "b"][..], &["grey"], &["450 nm", "λ", "zz", "a"]] {
            let raster = raster(bands);
            let mut bytes = Vec::new();
            write_exr(&raster, ["radiosity", "W m⁻²"], &mut bytes).expect("a vector takes everything");
            let read = read_exr(Cursor::new(bytes), raster.bands()).expect("it is ours");
            assert_eq!(read, raster, "multiples of 1/8 are exact in 32 bits");
        }
    }

    #[test]
    fn comments_name_quantity_and_unit() {
        let told = |quantity: &str, unit: &str| comment(quantity, unit).to_string();
        assert_eq!(told("illuminance", "lx"), "illuminance in lx, linear");
        assert_eq!(told("radiosity", "W m⁻²"), "radiosity in W m-2, linear; radiance is radiosity / pi");
        assert_eq!(told("importance", "1/area"), "importance in 1/area, linear");
    }

    #[test]
    fn other_files_and_bands_are_refused() {
        assert!(matches!(read_exr(Cursor::new(b"radiosity"), &[]), Err(ExrError::Format(_))));
        let mut bytes = Vec::new();
        write_exr(&raster(&["grey"]), ["illuminance", "lx"], &mut bytes).expect("a vector takes everything");
        let error = read_exr(Cursor::new(bytes), &["violet".to_owned()]).expect_err("there is no violet");
        assert_eq!(error.to_string(), "it has no channel \"violet\"; its channels: A, grey");
    }
}
