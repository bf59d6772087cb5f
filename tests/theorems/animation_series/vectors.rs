//! Blocks and their series against 80-bit integrals.

use radiosity::elements::Elements;
use radiosity::elements::space::Space;
use radiosity::geom::DVec3;
use radiosity::published::series::{
    BlockSeries, MovedPair, MovingBlock, RelativeMotion, SeriesError, Settings,
};
use radiosity_test_support::data::{numbers, point, table};
use serde_json::Value;

use super::quads::{Quad, elements, relative};

const PRECISE: Settings = Settings { orders: 24, tolerance: 2e-13 };

/// A pair of elements of the vectors, with its blocks as they are published.
struct Case {
    name: String,
    elements: Elements,
    direction: DVec3,
    /// √(area_s area_m) of the parameters: our blocks over theirs.
    scale: f64,
    value: Value,
}

impl Case {
    fn pair(&self) -> MovedPair<'_> {
        let [fixed, moving] = self.elements.list() else { panic!("two quads are two elements") };
        MovedPair::new(fixed, moving, RelativeMotion::Translation(self.direction)).expect("quads are flat")
    }

    fn scaled(&self, block: &Value) -> Vec<f64> {
        numbers(block).iter().map(|x| x * self.scale).collect()
    }

    /// The displacements with their blocks, from the nearest to the farthest.
    fn blocks(&self) -> Vec<(f64, Vec<f64>)> {
        let list = self.value["K"].as_array().expect("blocks");
        let mut blocks: Vec<(f64, Vec<f64>)> =
            list.iter().map(|k| (k["p"].as_f64().expect("a number"), self.scaled(&k["G"]))).collect();
        blocks.sort_by(|a, b| a.0.abs().total_cmp(&b.0.abs()));
        blocks
    }
}

fn cases() -> Vec<Case> {
    let data = table("animation_series.json");
    let case = |value: &Value| {
        let quads = [Quad::read(&value["static"]), Quad::read(&value["moving"])];
        Case {
            name: value["name"].as_str().expect("a name").to_owned(),
            elements: elements(&quads, Space::Tensor, 2),
            direction: point(&value["dir"]),
            scale: (quads[0].stretch() * quads[1].stretch()).sqrt(),
            value: value.clone(),
        }
    };
    let cases: Vec<Case> = data["pairs"].as_array().expect("pairs").iter().map(case).collect();
    assert_eq!(cases.len(), 6);
    cases
}

#[test]
fn blocks_are_those_of_exact_integrals() {
    for case in cases().iter().filter(|case| case.value["clamp"] == false) {
        let mut block = MovingBlock::new(case.pair(), PRECISE);
        for (p, exact) in case.blocks() {
            let found = block.at(p).expect("the quads face each other");
            let error = relative(&found.values, &exact);
            assert!(error <= 1e-12, "{} at {p}: {error:e}", case.name);
        }
    }
}

#[test]
fn series_reach_to_where_their_error_is_told() {
    for case in cases().iter().filter(|case| case.value["clamp"] == false) {
        let series = BlockSeries::new(&case.pair(), 0.0, Settings { orders: 16, tolerance: 1e-4 });
        let series = series.expect("the quads face each other");
        let radius = series.radius();
        let least = case.value["rmin"].as_f64().expect("a number");
        assert!(0.3 * least < radius && radius < 0.501 * least, "{}: {radius} of {least}", case.name);
        for (p, exact) in case.blocks() {
            match series.at(p) {
                Ok(found) => {
                    let error =
                        found.values.iter().zip(&exact).fold(0.0f64, |e, (x, y)| e.max((x - y).abs()));
                    assert!(error <= found.error, "{} at {p}: {error:e} > {:e}", case.name, found.error);
                }
                Err(told) => {
                    assert!(p.abs() > radius, "{} at {p}: {told}", case.name);
                    assert!(matches!(told, SeriesError::Range { .. }));
                }
            }
        }
    }
}

#[test]
fn terms_are_those_of_exact_integrals() {
    for case in cases().iter().filter(|case| case.value["clamp"] == false) {
        // Rules for sums to large displacements are accurate for single terms.
        let far = Settings { orders: 40, tolerance: 1e-15 };
        let series = BlockSeries::new(&case.pair(), 0.0, far).expect("the quads face each other");
        let exact = case.value["phi"].as_array().expect("terms");
        assert_eq!(exact.len(), 9);
        for (n, exact) in exact.iter().enumerate() {
            let exact = case.scaled(exact);
            // Terms of odd order vanish where the motion is across a plane of symmetry.
            if exact.iter().all(|x| *x == 0.0) {
                continue;
            }
            let error = relative(&series.terms()[n], &exact);
            assert!(error <= 1e-11, "{}, order {n}: {error:e}", case.name);
        }
    }
}

#[test]
fn pairs_across_a_horizon_are_refused_and_pairs_beyond_it_see_nothing() {
    let cases = cases();
    let case = cases.iter().find(|case| case.value["clamp"] == true).expect("one pair crosses");
    // The lamp, half a length 0.12, is behind the wall's plane from p = 0.27 on and in front of it up to
    // p = 0.03.
    for (p, exact) in case.blocks() {
        match BlockSeries::new(&case.pair(), p, PRECISE) {
            Ok(series) => {
                assert!(!(0.031..=0.269).contains(&p), "{p} is no place of a series");
                let found = series.at(p).expect("the centre is in the range");
                if p > 0.2 {
                    assert!(found.values.iter().all(|x| *x == 0.0) && exact.iter().all(|x| *x == 0.0));
                } else {
                    assert!(relative(&found.values, &exact) <= 1e-12, "{p}");
                    assert!((series.range().to - 0.03).abs() < 1e-12 || series.range().to < 0.03);
                }
            }
            Err(told) => {
                assert!(0.03 < p && p < 0.27, "{p}: {told}");
                assert!(matches!(told, SeriesError::Horizon { .. }));
            }
        }
    }
}
