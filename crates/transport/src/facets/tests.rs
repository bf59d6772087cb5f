//! Pairs of which a part is hidden, against quadratures.

use radiosity_elements::Discretization;
use radiosity_visibility::Shadows;

use super::*;

/// Places along an edge of the seat and of the tile, and scenes.
const ALONG_SEAT: usize = 10;
const ALONG_TILE: usize = 96;
const SCENES: u64 = 100;

/// A seat of 0.1 below a tile of 2, at this height, and a screen between them that covers x < edge.
fn scene(height: f64, edge: f64) -> String {
    let rectangle = |[x, y, z]: [f64; 3], width: f64, depth: f64| {
        let corners = [[x, y, z], [x + width, y, z], [x + width, y + depth, z], [x, y + depth, z]];
        format!("[[surfaces]]\npolygon = {{ vertices = {corners:?} }}\n")
    };
    rectangle([-0.05, -0.05, 0.0], 0.1, 0.1)
        + &rectangle([-1.0, 1.0, height], 2.0, -2.0)
        + &rectangle([-3.0, -3.0, 0.5 * height], 3.0 + edge, 6.0)
}

/// The part of the exchange of seat and tile that passes the edge, by midpoints.
fn part(height: f64, edge: f64) -> f64 {
    let middle = |place: usize, count: usize, size: f64| ((place as f64 + 0.5) / count as f64 - 0.5) * size;
    let (mut free, mut all) = (0.0, 0.0);
    for own in 0..ALONG_SEAT * ALONG_SEAT {
        let own = [own % ALONG_SEAT, own / ALONG_SEAT].map(|place| middle(place, ALONG_SEAT, 0.1));
        for other in 0..ALONG_TILE * ALONG_TILE {
            let other = [other % ALONG_TILE, other / ALONG_TILE].map(|place| middle(place, ALONG_TILE, 2.0));
            let square = (other[0] - own[0]).powi(2) + (other[1] - own[1]).powi(2) + height * height;
            let kernel = (square * square).recip();
            all += kernel;
            free += if own[0] + other[0] > 2.0 * edge { kernel } else { 0.0 };
        }
    }
    free / all
}

/// Few segments carry most of what a seat exchanges with a tile just above it: parts are known as well as is told.
#[test]
fn segments_tell_how_badly_they_know_what_few_carry() {
    let (mut squares, mut largest) = (0.0, 0.0_f64);
    for seed in 0..SCENES {
        let [height, edge] = shift::<2>(seed);
        let (height, edge) = (0.06 + 0.1 * height, -0.06 - 0.1 * edge);
        let scene = radiosity_scene::Source::new("seat", &scene(height, edge));
        let scene = radiosity_language::read(&scene).expect("three rectangles");
        let how = Discretization::uniform(0, 1);
        let elements = Elements::new(&scene, &how).expect("they have area");
        let visibility = Visibility::new(&scene, Shadows::Rays, 1e-3);
        let work = Work::alone();
        let transport = FacetTransport::new(&elements, &visibility, 2e-2, &work).expect("they are flat");
        let found = transport.exchanges(&|row, column| row == 0 && column == 1);
        let (_, pair) = found.rows[0].mixed().next().expect("a part is hidden");
        let error = (f64::from(pair.part) - part(height, edge)).abs();
        let ratio = error / f64::from(pair.variance).sqrt();
        squares += ratio * ratio;
        largest = largest.max(ratio);
    }
    let usual = (squares / SCENES as f64).sqrt();
    assert!(usual < 1.0 && largest < 2.0, "{usual}, {largest} at the most");
}
