//! Halls: boxes of random heights that stand on one floor, in rows, under lamps; the boxes are open at the
//! bottom, or closed, so that their bottoms lie on the floor.

use std::fmt::Write;

use radiosity::Work;
use radiosity::elements::Subdivide;
use radiosity::elements::cells::Layers;
use radiosity::elements::space::Space;
use radiosity::elements::{Discretization, Elements};
use radiosity::solve::{Options, solve};
use radiosity::visibility::covered_parts::CoveredParts;
use radiosity::visibility::footprints::footprints;
use radiosity_test_support::random::Random;

use crate::family::{Family, Row, read, timed};

const STAGES: &[&str] = &["read", "footprints", "covered parts", "elements", "obstacles", "solve"];
const SIZES: &[usize] = &[1_000, 3_000, 10_000, 30_000, 100_000];

/// Boxes that are open at the bottom.
pub(crate) const OPEN: Family =
    Family { name: "halls", stages: STAGES, sizes: SIZES, measure: |n| measure(n, false) };
/// Boxes with bottoms, which lie on the floor.
pub(crate) const CLOSED: Family =
    Family { name: "closed", stages: STAGES, sizes: SIZES, measure: |n| measure(n, true) };

/// Times of the stages; "solve" is all that follows reading, those before it once more.
fn measure(surfaces: usize, closed: bool) -> Row {
    let mut seconds = Vec::new();
    let text = hall(surfaces, closed);
    let scene = read(&mut seconds, &text);
    timed(&mut seconds, || footprints(&scene));
    timed(&mut seconds, || CoveredParts::new(&scene));
    let how = Discretization {
        order: 0,
        space: Space::Total,
        subdivide: Subdivide::Uniform(1),
        layers: Layers::NONE,
    };
    timed(&mut seconds, || Elements::new(&scene, &how).expect("all have area"));
    let options = Options { threads: 1, ..Options::default() };
    timed(&mut seconds, || options.visibility(&scene));
    timed(&mut seconds, || solve(&scene, &options, &Work::alone()).expect("the hall can be solved"));
    Row { surfaces: scene.surfaces.len(), seconds }
}

/// The text of a hall of about so many surfaces.
fn hall(surfaces: usize, closed: bool) -> String {
    let faces = if closed { 6 } else { 5 };
    let boxes = surfaces.saturating_sub(6) / faces;
    let aisles = (boxes as f64).sqrt().ceil() as usize;
    let breadth = 2.0 * aisles as f64;
    let mut text = format!(
        r#"bands = ["lm"]
materials.wall = {{ reflectance = 0.6 }}
materials.box = {{ reflectance = 0.4 }}
materials.lamp = {{ reflectance = 0.1, emission = 5000 }}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [{breadth}, {breadth}, 6], inward = true }}
"#
    );
    let mut random = Random(surfaces as u64);
    let open = if closed { "" } else { ", open = [\"bottom\"]" };
    for k in 0..boxes {
        let [x, y] = [k % aisles, k / aisles].map(|place| 2.0 * place as f64 + 0.5);
        let (x, height) = (x + random.between(0.0, 0.3), random.between(0.4, 2.4));
        write!(
            text,
            "[[surfaces]]\nname = \"box-{k}\"\nmaterial = \"box\"\nbox = {{ origin = [{x}, {y}, 0], size = [0.8, 0.8, {height}]{open} }}\n"
        )
        .expect("a text takes all");
    }
    let lamps = (boxes / 16).max(4);
    let rows = (lamps as f64).sqrt().ceil() as usize;
    for k in 0..lamps {
        let [x, y] = [k / rows, k % rows].map(|at| breadth * (at as f64 + 0.5) / rows as f64 - 0.3);
        write!(
            text,
            "[[surfaces]]\nname = \"lamp-{k}\"\nmaterial = \"lamp\"\nparallelogram = {{ origin = [{x}, {y}, 5.8], edge1 = [0, 0.6, 0], edge2 = [0.6, 0, 0] }}\n"
        )
        .expect("a text takes all");
    }
    text
}
