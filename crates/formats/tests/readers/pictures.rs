//! Pictures: PNG of every kind and OpenEXR, how their numbers become light, and what is refused.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, Text, WritableImage,
};
use png::{BitDepth, ColorType, Encoder, ScaledFloat, SrgbRenderingIntent};
use proptest::prelude::*;
use radiosity_formats::picture::{Coding, Picture, read};
use radiosity_photometry::error::Refusal;

const ALL: usize = usize::MAX;

/// A PNG of these bytes, changed by `how` before they are written.
fn png(
    size: [u32; 2],
    colour: ColorType,
    depth: BitDepth,
    bytes: &[u8],
    how: impl Fn(&mut Encoder<'_, &mut Vec<u8>>),
) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, size[0], size[1]);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    how(&mut encoder);
    encoder.write_header().and_then(|mut writer| writer.write_image_data(bytes)).expect("it is written");
    file
}

fn plain(size: [u32; 2], colour: ColorType, depth: BitDepth, bytes: &[u8]) -> Vec<u8> {
    png(size, colour, depth, bytes, |_| {})
}

fn taken(bytes: &[u8]) -> Picture {
    read(bytes, None, ALL).unwrap_or_else(|fault| panic!("{}", fault.cause))
}

#[track_caller]
fn refused(bytes: &[u8], cause: &str) -> Refusal {
    let fault = read(bytes, None, ALL).expect_err(cause);
    assert!(fault.cause.contains(cause), "{} is not {cause}", fault.cause);
    assert!(!fault.cure.is_empty());
    fault
}

/// IEC 61966-2-1, at the codes 0, 51, 128 and 255 of 8 bits, by hand to 12 digits.
const CODES: [(u8, f64); 4] = [(0, 0.0), (51, 0.033_104_766_571), (128, 0.215_860_500_114), (255, 1.0)];

#[test]
fn eight_bits_are_srgb_unless_something_else_is_said() {
    let codes = CODES.map(|(code, _)| code);
    let file = plain([4, 1], ColorType::Grayscale, BitDepth::Eight, &codes);
    let picture = taken(&file);
    assert_eq!((picture.columns, picture.rows, picture.channels.len()), (4, 1, 1));
    for (value, (code, light)) in picture.channels[0].iter().zip(CODES) {
        assert!((value - light).abs() < 1e-11, "{code}: {value}");
    }
    assert_eq!(picture.remarks, ["8 bits, sRGB made linear"]);
    let linear = read(&file, Some(Coding::Linear), ALL).unwrap();
    assert_eq!(linear.channels[0], codes.map(|code| f64::from(code) / 255.0));
}

#[test]
fn sixteen_bits_are_linear_unless_something_else_is_said() {
    let bytes = [0x00, 0x00, 0x80, 0x00, 0xff, 0xff];
    let of = |how: fn(&mut Encoder<'_, &mut Vec<u8>>)| {
        taken(&png([3, 1], ColorType::Grayscale, BitDepth::Sixteen, &bytes, how)).channels[0][1]
    };
    let half = 32768.0 / 65535.0;
    assert_eq!(of(|_| {}), half);
    let srgb = ((half + 0.055_f64) / 1.055).powf(2.4);
    assert!((of(|encoder| encoder.set_source_srgb(SrgbRenderingIntent::Perceptual)) - srgb).abs() < 1e-15);
    assert!((of(|encoder| encoder.set_source_gamma(ScaledFloat::from_scaled(45455))) - srgb).abs() < 1e-15);
    assert_eq!(of(|encoder| encoder.set_source_gamma(ScaledFloat::from_scaled(100_000))), half);
    let power = of(|encoder| encoder.set_source_gamma(ScaledFloat::from_scaled(50_000)));
    assert!((power - half * half).abs() < 1e-15, "γ = 1/2 is a square");
}

#[test]
fn eight_bits_with_a_gamma_of_one_are_linear() {
    let file = png([1, 1], ColorType::Grayscale, BitDepth::Eight, &[128], |encoder| {
        encoder.set_source_gamma(ScaledFloat::from_scaled(100_000));
    });
    assert_eq!(taken(&file).channels[0], [128.0 / 255.0]);
}

#[test]
fn colours_palettes_and_few_bits_are_read() {
    let colours = plain([2, 1], ColorType::Rgb, BitDepth::Eight, &[255, 0, 0, 0, 255, 255]);
    assert_eq!(taken(&colours).channels, [vec![1.0, 0.0], vec![0.0, 1.0], vec![0.0, 1.0]]);
    let palette = png([2, 2], ColorType::Indexed, BitDepth::One, &[0b0100_0000, 0b1000_0000], |encoder| {
        encoder.set_palette(vec![0, 0, 0, 255, 255, 0]);
    });
    assert_eq!(taken(&palette).channels[0], [0.0, 1.0, 1.0, 0.0]);
    assert_eq!(taken(&palette).channels[2], [0.0; 4]);
    let bits = plain([8, 1], ColorType::Grayscale, BitDepth::One, &[0b1010_0001]);
    assert_eq!(taken(&bits).channels[0], [1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
}

#[test]
fn only_opaque_pictures_may_have_an_alpha_channel() {
    let opaque = plain([2, 1], ColorType::GrayscaleAlpha, BitDepth::Eight, &[0, 255, 255, 255]);
    assert_eq!(taken(&opaque).channels, [vec![0.0, 1.0]]);
    let clear = plain([1, 3], ColorType::Rgba, BitDepth::Eight, &[9, 9, 9, 255, 9, 9, 9, 254, 9, 9, 9, 0]);
    refused(&clear, "the texel in column 1, row 2 from the top is transparent");
    let keyed = png([2, 1], ColorType::Grayscale, BitDepth::Eight, &[7, 8], |encoder| {
        encoder.set_trns(vec![0, 8]);
    });
    refused(&keyed, "column 2, row 1 from the top is transparent");
}

/// An interlaced PNG of 8-bit grey, whose rows within passes are not filtered, made by hand after section 8
/// of its standard.
fn interlaced(columns: usize, rows: usize, grey: impl Fn(usize, usize) -> u8) -> Vec<u8> {
    let plain =
        plain([columns as u32, rows as u32], ColorType::Grayscale, BitDepth::Eight, &vec![0; columns * rows]);
    let passes =
        [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)];
    let mut rows_of_passes = Vec::new();
    for (x, y, dx, dy) in passes {
        if x >= columns {
            continue;
        }
        for row in (y..rows).step_by(dy) {
            rows_of_passes.push(0);
            rows_of_passes.extend((x..columns).step_by(dx).map(|column| grey(column, row)));
        }
    }
    let mut header = plain[16..29].to_vec();
    header[12] = 1;
    let mut file = plain[..8].to_vec();
    file.extend(chunk(b"IHDR", &header));
    file.extend(chunk(b"IDAT", &stored(&rows_of_passes)));
    file.extend(chunk(b"IEND", &[]));
    file
}

/// A zlib stream of one stored block (RFC 1950, RFC 1951).
fn stored(bytes: &[u8]) -> Vec<u8> {
    let length = bytes.len() as u16;
    let (mut a, mut b) = (1_u32, 0_u32);
    for byte in bytes {
        a = (a + u32::from(*byte)) % 65521;
        b = (b + a) % 65521;
    }
    let head = [0x78, 0x01, 1].into_iter().chain(length.to_le_bytes()).chain((!length).to_le_bytes());
    head.chain(bytes.iter().copied()).chain((b << 16 | a).to_be_bytes()).collect()
}

/// A chunk with its checksum, the CRC-32 of annex D.
fn chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let body: Vec<u8> = kind.iter().chain(data).copied().collect();
    let crc = body.iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(
            crc ^ u32::from(*byte),
            |crc, _| if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 },
        )
    });
    let length = (data.len() as u32).to_be_bytes();
    length.into_iter().chain(body).chain((!crc).to_be_bytes()).collect()
}

#[test]
fn interlaced_pictures_are_put_together() {
    for (columns, rows) in [(1, 1), (3, 5), (8, 8), (17, 10)] {
        let grey = |column: usize, row: usize| (7 * column + 13 * row) as u8;
        let picture = read(&interlaced(columns, rows, grey), Some(Coding::Linear), ALL).unwrap();
        assert_eq!((picture.columns, picture.rows), (columns, rows));
        for (index, value) in picture.channels[0].iter().enumerate() {
            assert_eq!(*value, f64::from(grey(index % columns, index / columns)) / 255.0);
        }
    }
}

#[test]
fn large_pictures_are_averaged_in_linear_light() {
    let bytes = [0, 255, 255, 255, 0, 0, 255, 0];
    let file = plain([4, 2], ColorType::Grayscale, BitDepth::Eight, &bytes);
    let picture = read(&file, None, 2).unwrap();
    assert_eq!(picture.channels, [vec![0.25, 0.75]]);
    assert_eq!(picture.remarks[1], "averaged from 4 × 2 to 2 × 1 texels");
}

#[test]
fn headers_of_huge_pictures_cost_nothing() {
    for size in [[u32::MAX >> 1, u32::MAX >> 1], [65537, 1], [8193, 8193], [1, 1 << 30]] {
        let plain = plain([1, 1], ColorType::Rgb, BitDepth::Sixteen, &[0; 6]);
        let header: Vec<u8> =
            size.iter().flat_map(|side| side.to_be_bytes()).chain(plain[24..29].iter().copied()).collect();
        let mut file = plain[..8].to_vec();
        file.extend(chunk(b"IHDR", &header));
        file.extend(&plain[33..]);
        refused(&file, "more than 65536 along a side or 8192 × 8192 in all");
    }
    let mut huge = exr([2, 2], &[("Y", FlatSamples::F32(vec![0.5; 4]))]);
    // The data window is four numbers: 0, 0, 1, 1.
    let place =
        huge.windows(10).position(|bytes| bytes == b"dataWindow").expect("it has one") + 10 + 1 + 6 + 4;
    for place in [place + 8, place + 12] {
        huge[place..place + 4].copy_from_slice(&99_999_i32.to_le_bytes());
    }
    refused(&huge, "100000 × 100000 texels");
}

#[test]
fn other_files_are_named_and_refused() {
    for (start, kind) in [
        (&b"\xff\xd8\xff\xe0\0\x10JFIF\0"[..], "it is a JPEG, not PNG or OpenEXR"),
        (b"GIF89a", "a GIF"),
        (b"II*\0\x08\0\0\0", "a TIFF"),
        (b"RIFF\0\0\0\0WEBP", "a WebP"),
        (b"#?RADIANCE\n", "a picture of Radiance"),
        (b"", "no picture that is known"),
        (b"wood", "no picture that is known"),
    ] {
        refused(start, kind);
    }
}

#[test]
fn cut_files_are_refused_at_every_length() {
    let png = plain([5, 4], ColorType::Rgb, BitDepth::Eight, &[77; 60]);
    let exr = exr([3, 2], &[("Y", FlatSamples::F32(vec![0.25; 6]))]);
    for file in [&png, &exr] {
        (0..file.len()).for_each(|length| drop(read(&file[..length], None, ALL).expect_err("it is cut")));
    }
}

fn exr(size: [usize; 2], channels: &[(&str, FlatSamples)]) -> Vec<u8> {
    let list =
        channels.iter().map(|(name, samples)| AnyChannel::new(Text::new_or_panic(name), samples.clone()));
    let channels = AnyChannels::sort(list.collect());
    let layer =
        Layer::new((size[0], size[1]), LayerAttributes::named("main"), Encoding::SMALL_LOSSLESS, channels);
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).expect("it is written");
    bytes.into_inner()
}

fn floats(numbers: &[f32]) -> FlatSamples {
    FlatSamples::F32(numbers.to_vec())
}

#[test]
fn open_exr_is_linear() {
    let (red, green, blue) = ([0.5, 2.0], [0.25, 1e-9], [0.0, 1e6]);
    let file = exr([2, 1], &[("R", floats(&red)), ("G", floats(&green)), ("B", floats(&blue))]);
    let picture = taken(&file);
    assert_eq!(picture.channels, [red, green, blue].map(|own| own.map(f64::from).to_vec()));
    assert_eq!(picture.remarks, ["floating point, linear"]);
    let grey = exr([1, 2], &[("albedo", floats(&[0.125, 0.75])), ("A", floats(&[1.0, 1.0]))]);
    assert_eq!(taken(&grey).channels, [vec![0.125, 0.75]]);
    assert!(read(&grey, Some(Coding::Srgb), ALL).is_err());
    assert!(read(&grey, Some(Coding::Linear), ALL).is_ok());
}

#[test]
fn open_exr_of_other_numbers_or_channels_is_refused() {
    let half = |alpha| exr([1, 1], &[("Y", floats(&[0.5])), ("A", floats(&[alpha]))]);
    refused(&half(0.5), "is transparent");
    refused(&half(f32::NAN), "is transparent");
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let file = exr([1, 2], &[("Y", floats(&[0.5, value]))]);
        refused(&file, "the texel in column 1, row 2 from the top is");
    }
    refused(&exr([1, 1], &[("U", floats(&[0.5])), ("V", floats(&[0.5]))]), "its channels: U, V");
    refused(&exr([1, 1], &[("Y", FlatSamples::U32(vec![1]))]), "whole numbers");
    let many: Vec<String> = (0..20).map(|k| format!("c{k:02}")).collect();
    let many: Vec<(&str, FlatSamples)> = many.iter().map(|name| (name.as_str(), floats(&[0.5]))).collect();
    refused(&exr([1, 1], &many), "too many channels");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn changed_bytes_are_refused_or_read(
        which in 0usize..4,
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..6),
    ) {
        let mut file = match which {
            0 => plain([6, 5], ColorType::Rgb, BitDepth::Eight, &[99; 90]),
            1 => interlaced(9, 7, |column, row| (column * row) as u8),
            2 => exr([7, 5], &[("R", floats(&[0.5; 35])), ("G", floats(&[0.1; 35])), ("B", floats(&[0.9; 35]))]),
            _ => exr([40, 30], &[("Y", FlatSamples::F32((0..1200).map(|k| k as f32).collect()))]),
        };
        for (index, byte) in changes {
            let index = index.index(file.len());
            file[index] = byte;
        }
        if let Ok(picture) = read(&file, None, 1 << 20) {
            prop_assert!(picture.channels.iter().flatten().all(|value| value.is_finite()));
            prop_assert!(picture.channels.iter().all(|own| own.len() == picture.columns * picture.rows));
        }
    }
}
