//! Curved surfaces cut into flat pieces for other programs: area and enclosed volume tend to those of the surface with
//! the square of the width of a cell.

use std::f64::consts::PI;
use std::num::NonZeroUsize;

use radiosity::formats::model::{Model, Shape};
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::typed;

/// Area and enclosed volume of bodies: a ball, a ring, and a tube with a lid at either end.
const BODIES: [(&str, f64, f64); 3] = [
    (
        "surfaces = [{ name = \"ball\", sphere = { center = [1, 2, 3], radius = 0.5, axis = [1, 1, 0] } }]",
        PI,
        PI / 6.0,
    ),
    (
        "surfaces = [{ name = \"ring\", torus = { center = [0, 1, 0], axis = [0, 1, 1], major = 2, minor = 0.5 } }]",
        4.0 * PI * PI,
        PI * PI,
    ),
    (
        "surfaces = [
            { name = \"tube\", cylinder = { base = [0, 0, 1], axis = [0, 0, 2], radius = 1 } },
            { name = \"top\", disk = { center = [0, 0, 3], normal = [0, 0, 1], radius = 1 } },
            { name = \"bottom\", flip = true, disk = { center = [0, 0, 1], normal = [0, 0, 1], radius = 1 } } ]",
        6.0 * PI,
        2.0 * PI,
    ),
];

fn outlines(text: &str, count: usize) -> Vec<Vec<DVec3>> {
    let model: Model = radiosity::language::model(&typed(text), NonZeroUsize::new(count)).expect("a model");
    let outline = |shape: Shape| match shape {
        Shape::Polygon { outline, .. } => outline,
        curved => panic!("{curved:?}"),
    };
    model.surfaces.into_iter().map(|surface| outline(surface.shape)).collect()
}

/// Area, and volume by the divergence theorem: ⅓ ∫ x · n dA, about the origin.
fn measures(outlines: &[Vec<DVec3>]) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for outline in outlines {
        for pair in outline[1..].windows(2) {
            let area = 0.5 * (pair[0] - outline[0]).cross(pair[1] - outline[0]);
            sums[0] += area.length();
            sums[1] += area.dot(outline[0]) / 3.0;
        }
    }
    sums
}

#[test]
fn flat_pieces_tend_to_the_surface_with_the_square_of_their_width() {
    for (text, area, volume) in BODIES {
        let [coarse, fine] = [16, 32].map(|count| measures(&outlines(text, count)));
        for (k, exact) in [area, volume].into_iter().enumerate() {
            let [first, second] = [coarse[k], fine[k]].map(|found| 1.0 - found / exact);
            assert!(first > 0.0 && first < 0.06, "pieces lie inside: {first} {text}");
            assert!((first / second - 4.0).abs() < 0.2, "{first} {second} {text}");
        }
    }
}

/// A cell at a pole is a triangle, one of a tube is a flat quadrilateral, one of a bent patch two triangles.
#[test]
fn cells_become_as_few_pieces_as_are_flat() {
    let corners = |text: &str| outlines(text, 4).iter().map(Vec::len).collect::<Vec<_>>();
    let ball = corners(BODIES[0].0);
    assert_eq!([3, 4].map(|count| ball.iter().filter(|own| **own == count).count()), [8, 8]);
    assert!(corners(BODIES[2].0)[..16].iter().all(|own| *own == 4));
    let saddle =
        "surfaces = [{ name = \"saddle\", quad = { vertices = [[0,0,0],[1,0,0.5],[1,1,0],[0,1,0.5]] } }]";
    assert_eq!(corners(saddle), [3; 32]);
}
