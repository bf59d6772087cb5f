//! The text of the teapot's scene: Newell's pot in the middle of a room that is open in front, under four
//! lamps.

use std::fmt::Write;

use serde::Deserialize;

/// Points and patches of the pot.
const TABLE: &str = include_str!("../../scenes/teapot-table.toml");

const ROOM: &str = include_str!("../../scenes/teapot.toml");

/// Corners of the floor's hole under the pot, and its radius. The pot's bottom touches the floor in one
/// point.
const HOLE_CORNERS: usize = 8;
const HOLE_RADIUS: f64 = 1.3;

#[derive(Deserialize)]
struct Table {
    points: Vec<[f64; 3]>,
    patches: Vec<[u32; 16]>,
}

/// The text with a pot of that reflectance, its heights multiplied by `height`.
pub(super) fn text(height: f64, reflectance: f64) -> String {
    let Table { points, patches } = toml::from_str(TABLE).expect("the table is part of the program");
    let points: Vec<[f64; 3]> = points.iter().map(|[x, y, z]| [*x, *y, height * z]).collect();
    let hole: Vec<[f64; 3]> = (0..HOLE_CORNERS).map(corner).collect();
    let mut text = ROOM.replace("$pot", &format!("{reflectance:?}")).replace("$hole", &format!("{hole:?}"));
    write!(text, "\n[surfaces.patches]\npoints = {points:?}\npatches = {patches:?}\n")
        .expect("a String takes all text");
    text
}

fn corner(number: usize) -> [f64; 3] {
    let (sin, cos) = (std::f64::consts::TAU * (number as f64 + 0.5) / HOLE_CORNERS as f64).sin_cos();
    [HOLE_RADIUS * cos, HOLE_RADIUS * sin, 0.0]
}
