//! Numbers of a page: deflated (RFC 1951) and in Base64 (RFC 4648).
//!
//! Light is stored surface by surface, then as in [`LightTexture::texels`] part by part, band by band, row by
//! row, in IEEE 754 half precision (to 0.05 %) times a scale that keeps it in range. Of the bits of each
//! texel, taken as a number of 16 bits, those of the texel before it in its row are subtracted, of the first
//! those of the first in the row before; then all lower bytes come first, all higher ones after them. Light
//! that varies slowly leaves small differences, which deflate well.
//!
//! Triangles are stored surface by surface: of all corners the positions (three single-precision numbers
//! each, little-endian), of all corners the parameters (two each), then the corners of the triangles (32-bit,
//! counted within the surface).

use std::io::Write;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::DeflateEncoder;
use half::f16;

use crate::pictures::tessellation::Triangulation;
use radiosity_reading::pictures::lightmap::{LightTexture, Lightmap};

/// The number that the greatest irradiance becomes: half of the greatest in half precision.
const GREATEST: f32 = 32_752.0;

/// The numbers of a page.
pub(super) struct Packed {
    /// Irradiance (unit of exitance) per unit of the numbers in `light`.
    pub scale: f32,
    pub light: String,
    pub shape: String,
}

impl Packed {
    /// Packs the light of so many bands, and the triangles of all surfaces.
    pub(super) fn new(lightmap: &Lightmap, bands: usize, triangles: &[Triangulation]) -> Self {
        let parts = lightmap.parts().len();
        let planes = |texture: &LightTexture| {
            let pairs = (0..parts).flat_map(|part| (0..bands).map(move |band| (part, band)));
            pairs.map(|(part, band)| texture.texels(part, band).to_vec()).collect::<Vec<_>>()
        };
        let values = || lightmap.surfaces().iter().flat_map(planes).flatten();
        let greatest = values().fold(0.0, f32::max);
        let scale = if greatest > 0.0 { greatest / GREATEST } else { 1.0 };
        let mut bits: Vec<u16> = Vec::new();
        for texture in lightmap.surfaces() {
            for plane in planes(texture) {
                differences(&plane, texture.size()[0], scale, &mut bits);
            }
        }
        let low = bits.iter().map(|bits| bits.to_le_bytes()[0]);
        let high = bits.iter().map(|bits| bits.to_le_bytes()[1]);
        Self {
            scale,
            light: encoded(&low.chain(high).collect::<Vec<u8>>()),
            shape: encoded(&shape(triangles)),
        }
    }
}

/// Appends the differences of the bits of a plane of light in rows of so many columns.
fn differences(plane: &[f32], columns: usize, scale: f32, out: &mut Vec<u16>) {
    let mut above = 0;
    for row in plane.chunks_exact(columns) {
        let bits: Vec<u16> = row.iter().map(|value| f16::from_f32(value / scale).to_bits()).collect();
        let mut before = above;
        for own in &bits {
            out.push(own.wrapping_sub(before));
            before = *own;
        }
        above = bits[0];
    }
}

fn shape(triangles: &[Triangulation]) -> Vec<u8> {
    let single = |x: f64| (x as f32).to_le_bytes();
    let positions = triangles.iter().flat_map(|own| &own.positions).flat_map(|x| x.to_array());
    let parameters = triangles.iter().flat_map(|own| &own.parameters).flatten().copied();
    let numbers = positions.chain(parameters).flat_map(single);
    let corners = triangles.iter().flat_map(|own| &own.triangles).flatten();
    numbers.chain(corners.flat_map(|corner| corner.to_le_bytes())).collect()
}

fn encoded(bytes: &[u8]) -> String {
    let mut deflated = DeflateEncoder::new(Vec::new(), Compression::best());
    let written = deflated.write_all(bytes).and_then(|()| deflated.finish());
    STANDARD.encode(written.expect("a vector takes everything"))
}
