//! Three quads of which one moves: the solution at displacements, by one expansion or a few.

use radiosity::elements::space::Space;
use radiosity::geom::DVec3;
use radiosity::published::series::{MovedPair, MovingBlock, RelativeMotion, Settings};
use radiosity_test_support::data::{numbers, point, table};
use serde_json::Value;

use super::quads::{Quad, elements, relative};

/// Functions of a quad.
const N: usize = 9;

/// The solution of (I − ρ G) b = e by the Neumann series, which ends: reflectances are below 0.6.
fn solved(blocks: &[(usize, usize, Vec<f64>)], reflectances: &[f64], emitted: &[f64]) -> Vec<f64> {
    let mut b = emitted.to_vec();
    for _ in 0..200 {
        let mut next = emitted.to_vec();
        for (i, j, block) in blocks {
            for (k, l) in (0..N).flat_map(|k| (0..N).map(move |l| (k, l))) {
                next[i * N + k] += reflectances[*i] * block[k * N + l] * b[j * N + l];
                next[j * N + l] += reflectances[*j] * block[k * N + l] * b[i * N + k];
            }
        }
        b = next;
    }
    b
}

#[test]
fn the_solution_of_a_moving_lamp_is_the_exact_one() {
    let data = table("animation_solve.json");
    let list = data["quads"].as_array().expect("quads");
    let quads: Vec<Quad> = list.iter().map(Quad::read).collect();
    let number = |value: &Value, key: &str| value[key].as_f64().expect("a number");
    let reflectances: Vec<f64> = list.iter().map(|quad| number(quad, "rho")).collect();
    let elements = elements(&quads, Space::Tensor, 2);
    let mut emitted = vec![0.0; N * quads.len()];
    for (k, quad) in list.iter().enumerate() {
        emitted[N * k] = number(quad, "e") * elements.list()[k].area.sqrt();
    }
    let direction = point(&data["dir"]);
    let of_pair = |i: usize, j: usize| {
        // A pair that stays has a direction too, and no displacement.
        let direction = if j == 2 { direction } else { DVec3::X };
        let pair =
            MovedPair::new(&elements.list()[i], &elements.list()[j], RelativeMotion::Translation(direction));
        let settings = Settings { orders: 20, tolerance: 1e-13 };
        (i, j, MovingBlock::new(pair.expect("quads are flat"), settings))
    };
    let mut moving = [of_pair(0, 1), of_pair(0, 2), of_pair(1, 2)];
    let solutions = data["solutions"].as_array().expect("solutions");
    assert_eq!(solutions.len(), 4);
    for solution in solutions {
        let p = number(solution, "p");
        let blocks: Vec<(usize, usize, Vec<f64>)> = moving
            .iter_mut()
            .map(|(i, j, block)| {
                let found = block.at(if *j == 2 { p } else { 0.0 }).expect("the quads face each other");
                (*i, *j, found.values)
            })
            .collect();
        let ours = solved(&blocks, &reflectances, &emitted);
        let theirs: Vec<f64> =
            ours.iter().enumerate().map(|(k, x)| x / quads[k / N].stretch().sqrt()).collect();
        let error = relative(&theirs, &numbers(&solution["b"]));
        assert!(error <= 1e-11, "at {p}: {error:e}");
    }
    assert_eq!(moving[0].2.expansions(), 1);
}
