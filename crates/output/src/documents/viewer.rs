//! One HTML file to walk through a solved scene in a browser, without a server or a network.
//!
//! The page draws the triangles of the surfaces ([`crate::pictures::tessellation`]) by WebGL 2 and colours
//! them from their textures of light ([`radiosity_reading::pictures::lightmap`]) with the exposure and tone
//! of pictures. It keeps the light of each group and band apart, so that groups can be dimmed and values read
//! at any point. Its script and style stand beside this file; `packing` says how the numbers are written,
//! `header` what they belong to.

mod first_view_settings;
mod packing;
mod header;

use std::io::{self, Write};

use radiosity_reading::exposure::Exposure;
use radiosity_reading::pictures::lightmap::Lightmap;
use radiosity_reading::pictures::render::white_balance;
use radiosity_solve::solved::Solved;

use crate::pictures::image::Image;
use crate::pictures::lightmap_view::lightmap_view;
use crate::pictures::tessellation::tessellation;
pub use first_view_settings::{FirstViewColours, FirstViewSettings};
use header::Header;
use packing::Packed;

/// Most values of light, over all texels, parts and bands, of two bytes each. Chosen: the page stays below 3
/// MB even where they cannot be compressed.
const VALUES: usize = 1_000_000;

/// Fewest texels, so that scenes of many groups and bands get larger pages instead of coarser light; most, so
/// that those of one band take no longer. Both are chosen.
const FEWEST: usize = 20_000;
const MOST: usize = 400_000;

/// Greatest distance of triangles from curved surfaces, over the diagonal of the scene. Chosen: a third of a
/// pixel in a picture 1000 pixels wide.
const TOLERANCE: f64 = 2e-4;

/// The texels of a page on a scene whose light is kept apart in so many parts and bands.
pub fn texels(parts: usize, bands: usize) -> usize {
    (VALUES / (parts * bands)).clamp(FEWEST, MOST)
}

const PAGE: &str = include_str!("viewer/page.html");
const STYLE: &str = include_str!("viewer/style.css");
const SHADERS: [(&str, &str); 4] = [
    ("surface.vert", include_str!("viewer/surface.vert")),
    ("surface.frag", include_str!("viewer/surface.frag")),
    ("screen.vert", include_str!("viewer/screen.vert")),
    ("screen.frag", include_str!("viewer/screen.frag")),
];

/// The script, each part of which uses those before it.
const SCRIPT: [&str; 11] = [
    include_str!("viewer/vector.js"),
    include_str!("viewer/data.js"),
    include_str!("viewer/light.js"),
    include_str!("viewer/shape.js"),
    include_str!("viewer/camera.js"),
    include_str!("viewer/drawing.js"),
    include_str!("viewer/legend.js"),
    include_str!("viewer/viewer.js"),
    include_str!("viewer/panel.js"),
    include_str!("viewer/hands.js"),
    include_str!("viewer/main.js"),
];

/// The exposure that is chosen for the first view of a page.
pub fn automatic_exposure(solved: &Solved, lightmap: &Lightmap, start: &FirstViewSettings) -> Exposure {
    let view = lightmap_view(solved, lightmap, &start.camera, &start.grid, start.shown);
    Image::new(&view, white_balance(&solved.outcome.solution)).automatic_exposure()
}

/// Writes the page of a solved scene with this light; `automatic` is the exposure that was chosen for its first
/// view.
///
/// # Errors
/// Whatever the writer reports.
pub fn write_viewer(
    solved: &Solved,
    lightmap: &Lightmap,
    start: &FirstViewSettings,
    automatic: Exposure,
    mut writer: impl Write,
) -> io::Result<()> {
    let (scene, visibility) = (&solved.scene, solved.visibility());
    let triangles = tessellation(scene, TOLERANCE * visibility.bounds().diagonal());
    let balance = white_balance(&solved.outcome.solution);
    let packed = Packed::new(lightmap, scene.bands.len(), &triangles);
    let header = Header::new(solved, lightmap, &triangles, start, automatic, balance, packed.scale);
    let shaders: Vec<String> = SHADERS
        .iter()
        .map(|(name, text)| format!("<script type=\"x-shader\" id=\"{name}\">\n{text}</script>\n"))
        .collect();
    let title = scene.title.as_deref().unwrap_or(&scene.name);
    let parts = [
        ("title", escaped(title)),
        ("style", STYLE.to_owned()),
        ("shaders", shaders.concat()),
        ("script", SCRIPT.concat()),
        ("header", header.json()?),
        ("light", packed.light),
        ("shape", packed.shape),
    ];
    for (index, piece) in PAGE.split("{{").enumerate() {
        let (name, text) =
            if index == 0 { ("", piece) } else { piece.split_once("}}").unwrap_or(("", piece)) };
        let part = parts.iter().find(|(own, _)| *own == name).map_or("", |(_, part)| part);
        writer.write_all(part.as_bytes())?;
        writer.write_all(text.as_bytes())?;
    }
    Ok(())
}

/// A text in HTML.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
