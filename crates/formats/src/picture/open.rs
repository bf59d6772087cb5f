//! OpenEXR: floating-point numbers, linear.
//!
//! The first layer with channels R, G and B is read, else the first of a channel Y, else the first of a
//! single channel besides an alpha channel A. Reference: Academy Software Foundation, *Technical Introduction
//! to OpenEXR*.

use std::io::Cursor;

use exr::math::Vec2;
use exr::meta::MetaData;
use exr::meta::attribute::SampleType;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, ReadSpecificChannel, read as reading};

use super::reduction::{Picture, Reduction};
use super::refusals::{check_size, damaged, transparent};
use radiosity_photometry::error::{Refusal, refuse};

/// Most bytes of one texel, all of its channels together, so that a block of a file has at most 128 MB.
const WIDEST: usize = 64;

/// Reads an OpenEXR, averaged to at most `most` texels.
pub(super) fn read(bytes: &[u8], most: usize) -> Result<Picture, Refusal> {
    let meta = MetaData::read_from_buffered(bytes, false).map_err(damaged)?;
    meta.headers.iter().try_for_each(check_header)?;
    let names = names(&meta.headers)?;
    let reduction = match &names[..] {
        [red, green, blue] => coloured(bytes, [red, green, blue], most),
        names => grey(bytes, &names[0], most),
    };
    let reduction = reduction.map_err(damaged)?;
    reduction.finish(vec!["floating point, linear".to_owned()])
}

fn check_header(header: &Header) -> Result<(), Refusal> {
    check_size([header.layer_size.0 as u64, header.layer_size.1 as u64])?;
    let list = &header.channels.list;
    let problem = if header.deep {
        "it is deep"
    } else if header.channels.bytes_per_pixel > WIDEST {
        "it has too many channels"
    } else if list.iter().any(|channel| channel.sampling != Vec2(1, 1)) {
        "its channels have texels of different sizes"
    } else if list.iter().any(|channel| channel.sample_type == SampleType::U32) {
        "it holds whole numbers"
    } else {
        return Ok(());
    };
    refuse(problem, "write channels R, G and B, or Y, of floating-point numbers, alike in size")
}

/// The names of the channels that are read, three or one.
fn names(headers: &[Header]) -> Result<Vec<String>, Refusal> {
    let channels = |header: &Header| -> Vec<String> {
        header.channels.list.iter().map(|channel| channel.name.to_string()).collect()
    };
    let layers: Vec<Vec<String>> = headers.iter().map(channels).collect();
    let has =
        |layer: &Vec<String>, names: &[&str]| names.iter().all(|name| layer.iter().any(|own| own == name));
    for names in [&["R", "G", "B"][..], &["Y"]] {
        if layers.iter().any(|layer| has(layer, names)) {
            return Ok(names.iter().map(|name| (*name).to_owned()).collect());
        }
    }
    let single = |layer: &Vec<String>| {
        let mut colours = layer.iter().filter(|name| *name != "A");
        colours.next().filter(|_| colours.next().is_none()).cloned()
    };
    layers.iter().find_map(single).map(|name| vec![name]).ok_or_else(|| {
        let all = layers.concat().join(", ");
        Refusal::new(
            format!("it has no channels R, G and B, nor a single one; its channels: {all}"),
            "write it with channels R, G and B, or Y",
        )
    })
}

fn coloured(bytes: &[u8], [red, green, blue]: [&str; 3], most: usize) -> exr::error::Result<Reduction> {
    let image = reading().no_deep_data().largest_resolution_level().specific_channels();
    let image = image.required(red).required(green).required(blue).optional("A", 1.0);
    let image = image.collect_pixels(
        |size, _| Reduction::new([size.0, size.1], 3, most),
        |reduction: &mut Reduction, at, (red, green, blue, alpha): (f32, f32, f32, f32)| {
            take(reduction, at, &[red, green, blue], alpha);
        },
    );
    let image =
        image.first_valid_layer().all_attributes().non_parallel().from_buffered(Cursor::new(bytes))?;
    Ok(image.layer_data.channel_data.pixels)
}

fn grey(bytes: &[u8], name: &str, most: usize) -> exr::error::Result<Reduction> {
    let image = reading().no_deep_data().largest_resolution_level().specific_channels();
    let image = image.required(name).optional("A", 1.0).collect_pixels(
        |size, _| Reduction::new([size.0, size.1], 1, most),
        |reduction: &mut Reduction, at, (grey, alpha): (f32, f32)| take(reduction, at, &[grey], alpha),
    );
    let image =
        image.first_valid_layer().all_attributes().non_parallel().from_buffered(Cursor::new(bytes))?;
    Ok(image.layer_data.channel_data.pixels)
}

/// Takes in a texel; without a channel A it is opaque.
fn take(reduction: &mut Reduction, Vec2(column, row): Vec2<usize>, values: &[f32], alpha: f32) {
    let mut wide = [0.0; 3];
    wide.iter_mut().zip(values).for_each(|(wide, value)| *wide = f64::from(*value));
    if alpha != 1.0 {
        reduction.refuse(|| transparent([column, row]));
    }
    reduction.add([column, row], &wide[..values.len()]);
}
