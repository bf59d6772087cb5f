//! The borders of elements as a camera sees them: hidden lines removed, curved borders curved.
//!
//! Camera rays at `samples × samples` points per pixel find the visible elements. A point is on a border if
//! its right or its lower neighbour sees another element. With e = 1 there and S points along a pixel's side,
//! the coverage of a pixel with its middle at (x, y) is
//!
//! ```text
//! 1/S Σ e(a, b) Λ(a − x) Λ(b − y) ,     Λ(x) = max(0, 1 − |x|) ,
//! ```
//!
//! a line about one pixel broad. Outlines of visible surfaces count as borders too.

use radiosity_elements::Elements;
use radiosity_geom::Encounter;
use radiosity_scene::Camera;
use radiosity_visibility::Visibility;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::ranks::{PartName, Ranks};
use rayon::prelude::*;

use radiosity_reading::pictures::pinhole::Pinhole;

/// No element is seen.
const NOTHING: u32 = u32::MAX;

/// The part of each pixel that borders cover, in row order.
pub fn wireframe(
    elements: &Elements,
    visibility: &Visibility,
    camera: &Camera,
    samples: u32,
    ranks: &Ranks,
) -> Vec<f64> {
    let view = Pinhole::new(camera);
    let [columns, rows] = [camera.width, camera.height].map(|pixels| (pixels * samples) as usize);
    let seen: Vec<Vec<u32>> = ranks.map_even(PartName::Borders, rows + 1, 1, |row| {
        let at = |k: usize| (k as f64 + 0.5) / f64::from(samples);
        (0..=columns).map(|column| element(elements, visibility, &view, at(column), at(row))).collect()
    });
    let border = |row: usize, column: usize| {
        let here = seen[row][column];
        here != seen[row][column + 1] || here != seen[row + 1][column]
    };
    let samples = samples as usize;
    let pixel = |row: usize, column: usize| {
        let near = |pixel: usize, end: usize| {
            (pixel * samples).saturating_sub(samples / 2 + 1)
                ..((pixel + 1) * samples + samples / 2 + 1).min(end)
        };
        // A border found by a point runs half a step to its right, or below it.
        let tent = |k: usize, pixel: usize| {
            (1.0 - ((k as f64 + 1.0) / samples as f64 - pixel as f64 - 0.5).abs()).max(0.0)
        };
        let row_sum = |r: usize| -> f64 {
            near(column, columns).filter(|c| border(r, *c)).map(|c| tent(c, column)).sum()
        };
        let sum: f64 = near(row, rows).map(|r| tent(r, row) * row_sum(r)).sum();
        (sum / samples as f64).min(1.0)
    };
    (0..camera.height as usize)
        .into_par_iter()
        .flat_map_iter(|row| (0..camera.width as usize).map(move |column| (row, column)))
        .map(|(row, column)| {
            check_interrupt();
            pixel(row, column)
        })
        .collect()
}

/// The element whose front is seen through the point (x, y) of the picture.
fn element(elements: &Elements, visibility: &Visibility, view: &Pinhole, x: f64, y: f64) -> u32 {
    let ray = view.ray(x, y);
    let Some(Encounter { surface, hit, front, .. }) = visibility.nearest(&ray) else { return NOTHING };
    let element = elements.at(surface, [hit.u, hit.v]).filter(|_| front);
    element.and_then(|index| u32::try_from(index).ok()).unwrap_or(NOTHING)
}
