//! A block does not depend on what else is in the scene, though blocks are shared and small ones are relaxed.

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use radiosity_geom::DVec3;
use radiosity_test_support::compare::largest;
use radiosity_test_support::random::seeded;

use crate::transport::flat::{Flat, Outline, block, blocks, elements, scene};
use crate::transport::polyhedra::rooms;

/// Compares each block of a scene with the one computed for its two elements alone, at the same accuracy.
/// Returns how many blocks were shared.
fn compare(surfaces: &[Flat], order: usize, eps: f64) -> Result<usize, String> {
    let together = scene(surfaces).map_err(|error| error.to_string())?;
    let Ok(all) = elements(&together, order) else { return Ok(0) };
    let blocks_together = blocks(&together, &all, eps);
    let count = surfaces.len();
    let found = |i, j| block(&blocks_together, i, j);
    let row = |i| (0..count).filter_map(|j| found(i, j)).map(|g| largest(&g)).fold(0.0, f64::max);
    let rows: Vec<f64> = (0..count).map(row).collect();
    for (i, j) in (0..count).flat_map(|j| (0..j).map(move |i| (i, j))) {
        let alone = scene(&[surfaces[i].clone(), surfaces[j].clone()]).map_err(|error| error.to_string())?;
        let pair = elements(&alone, order).expect("each has a basis");
        let zeros = || vec![0.0; pair.list()[0].basis.len().pow(2)];
        let own = block(&blocks(&alone, &pair, eps), 0, 1).unwrap_or_else(zeros);
        let shared = found(i, j).unwrap_or_else(zeros);
        let error = own.iter().zip(&shared).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        let allowed = 2.0 * eps * largest(&own).max(1e-2 * rows[i].min(rows[j])) + 2e-13;
        if error.is_nan() || error > allowed {
            return Err(format!(
                "block {i}, {j}: {error:e} of {allowed:e}\n    {:?}\n    {:?}",
                surfaces[i], surfaces[j]
            ));
        }
    }
    Ok(blocks_together.statistics.pairs.repeated)
}

/// Parallelograms cut into cells, the rest whole.
fn cut(faces: &[Flat], cells: [usize; 2]) -> Vec<Flat> {
    let cut_one = |face: &Flat| match face.outline {
        Outline::Parallelogram { origin, edges: [a, b] } => {
            let steps = [a / cells[0] as f64, b / cells[1] as f64];
            let at = move |i: usize, j: usize| origin + steps[0] * i as f64 + steps[1] * j as f64;
            let front = face.front;
            let corners = (0..cells[0]).flat_map(move |i| (0..cells[1]).map(move |j| (i, j)));
            corners
                .map(|(i, j)| Flat::facing(Outline::Parallelogram { origin: at(i, j), edges: steps }, front))
                .collect()
        }
        _ => vec![face.clone()],
    };
    faces.iter().flat_map(cut_one).collect()
}

/// A brick, whose cells repeat turned and mirrored.
#[test]
fn cells_of_a_brick_share_their_blocks_rightly() {
    let [a, b, c] = [DVec3::X, 0.5 * DVec3::Y, 0.25 * DVec3::Z];
    let face = |origin, edges, front| Flat::facing(Outline::Parallelogram { origin, edges }, front);
    let faces = [
        face(DVec3::ZERO, [a, b], c),
        face(c, [b, a], -c),
        face(DVec3::ZERO, [b, c], a),
        face(a + b, [c, -b], -a),
        face(DVec3::ZERO, [a, c], b),
        face(b + a, [-a, c], -b),
    ];
    let repeated = compare(&cut(&faces, [3, 2]), 3, 1e-6).unwrap_or_else(|why| panic!("{why}"));
    assert!(repeated > 100, "{repeated} blocks repeat");
}

#[test]
fn blocks_are_the_same_alone_and_among_others() {
    let seeded = seeded(12, 6);
    let asked = (rooms(), 0..4usize, prop::sample::select(vec![1e-2, 1e-4, 1e-6]));
    let outcome = TestRunner::new(seeded).run(&asked, |(faces, order, eps)| {
        compare(&cut(&faces, [2, 2]), order, eps).map(drop).map_err(TestCaseError::fail)
    });
    outcome.unwrap_or_else(|why| panic!("{why}"));
}
