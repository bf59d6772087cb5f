//! The pieces of the floors, drawn.

use std::error::Error;
use std::fmt::Write;
use std::fs;

use radiosity::Scene;

/// Units across and down of a floor, and around it.
const SIDE: f64 = 440.0;
const FREE: f64 = 20.0;

/// Draws the floors side by side, seen from above, y up.
pub(crate) fn write(path: &str, scenes: &[Scene]) -> Result<(), Box<dyn Error>> {
    let [width, height] = [(SIDE + 2.0 * FREE) * scenes.len() as f64, SIDE + 2.0 * FREE];
    let mut svg = format!(
        "<svg width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" xmlns=\"http://www.w3.org/2000/svg\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    );
    for (column, scene) in scenes.iter().enumerate() {
        let pieces: Vec<_> = scene
            .surfaces
            .iter()
            .filter(|own| own.name.starts_with("floor"))
            .map(|own| own.shape.corners())
            .collect();
        let extent = pieces.iter().flatten().fold(0.0, |extent, x| f64::max(extent, x.x.max(x.y)));
        let left = (SIDE + 2.0 * FREE) * column as f64 + FREE;
        for piece in &pieces {
            let corner = |x: f64, y: f64| {
                format!("{:.1},{:.1}", left + SIDE * x / extent, FREE + SIDE * (1.0 - y / extent))
            };
            let corners: Vec<String> = piece.iter().map(|x| corner(x.x, x.y)).collect();
            let points = corners.join(" ");
            writeln!(
                svg,
                "<polygon points=\"{points}\" fill=\"#eef3f8\" stroke=\"#000000\" stroke-width=\"0.8\"/>"
            )?;
        }
    }
    Ok(fs::write(path, svg + "</svg>\n")?)
}
