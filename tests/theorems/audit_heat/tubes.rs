//! Clausing's tubes: between a black disk at 1000 K and one at 0 K an adiabatic wall passes on the heat
//! W π R² σ T⁴, as a tube lets molecules through.

use std::f64::consts::PI;

use super::scored::{SEEN, Scored, apart, heat, heat_of, level, of};

/// Length over radius and the probability W of passage: P. Clausing's integral equation (Ann. Phys. 404,
/// 1932), solved by collocation at 30 and at 50 Gauss points, whose integrals are split at the kink of the
/// kernel; both agree to all digits.
const PASSAGES: [[f64; 2]; 6] = [
    [0.1, 0.952_398_907_3],
    [0.5, 0.801_271_420_2],
    [1.0, 0.671_983_901_9],
    [2.0, 0.514_230_534_5],
    [5.0, 0.310_525_283_1],
    [10.0, 0.190_942_431_9],
];

/// A tube of radius 1.
fn tube(length: f64) -> String {
    format!(
        r#"
        materials.hot = {{ emissivity = 1, temperature = 1000 }}
        materials.cold = {{ emissivity = 1, temperature = 0 }}
        materials.wall = {{ emissivity = 0.5, adiabatic = true }}
        [[surfaces]]
        name = "wall"
        material = "wall"
        flip = true
        cylinder = {{ base = [0, 0, 0], axis = [0, 0, {length}], radius = 1 }}
        [[surfaces]]
        name = "bottom"
        material = "hot"
        disk = {{ center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }}
        [[surfaces]]
        name = "top"
        material = "cold"
        disk = {{ center = [0, 0, {length}], normal = [0, 0, -1], radius = 1 }}
        "#
    )
}

#[test]
fn tubes_pass_on_what_clausing_found() {
    let mut scored = Scored::default();
    for (k, [length, passage]) in PASSAGES.into_iter().enumerate() {
        let flow = passage * PI * level(1000.0);
        for seed in 0..12 {
            let found = heat(&tube(length), 2048.0, 100 * k as u64 + seed);
            scored.add("bottom", &of(&found, "bottom").flow, flow);
            scored.add("top", &of(&found, "top").flow, -flow);
            // By symmetry about the middle the wall has the mean of both levels.
            scored.add("wall", &of(&found, "wall").level, 0.5 * level(1000.0));
        }
    }
    scored.check(200);
}

#[test]
fn a_passage_that_is_off_by_a_hundredth_is_seen() {
    let [length, passage] = PASSAGES[3];
    let flow = heat_of("bottom", &tube(length), 524_288.0, 7).flow;
    let right = passage * PI * level(1000.0);
    assert!(apart(&flow, right) < SEEN, "{flow:?} for {right}");
    assert!(apart(&flow, 1.01 * right) > SEEN, "{flow:?} for {right}");
}
