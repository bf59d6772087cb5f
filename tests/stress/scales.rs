//! Scale, place and brightness: G has no scale, so light must not depend on the unit of length.
//!
//! Lengths times a power of two round nowhere: B is the same to the last bit. Powers of ten round the
//! coordinates.

use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

use crate::row::Row;

/// Shapes of every rule: flat ones that touch, hide each other and stand apart, and curved ones.
fn room(scale: f64, curved: bool) -> Scene {
    let list = |points: &[[f64; 3]]| {
        format!("{:?}", points.iter().map(|p| p.map(|x| x * scale)).collect::<Vec<_>>())
    };
    let quad = |material: &str, points: [[f64; 3]; 4]| {
        format!("[[surfaces]]\nmaterial = '{material}'\nquad = {{ vertices = {} }}\n", list(&points))
    };
    let mut text = String::from(
        "bands = ['grey']\n[materials.white]\nreflectance = 0.7\n[materials.lamp]\nreflectance = 0.2\nemission = 3\n",
    );
    text += &quad("white", [[0.0, 0.0, 0.0], [1.3, 0.0, 0.0], [1.3, 1.1, 0.0], [0.0, 1.1, 0.0]]);
    text += &quad("lamp", [[0.0, 0.0, 0.9], [0.0, 1.1, 0.9], [1.3, 1.1, 0.9], [1.3, 0.0, 0.9]]);
    text += &quad("white", [[0.0, 0.0, 0.0], [0.0, 1.1, 0.0], [0.0, 1.1, 0.9], [0.0, 0.0, 0.9]]);
    text += &format!(
        "[[surfaces]]\nmaterial = 'white'\ntwo_sided = true\npolygon = {{ vertices = {} }}\n",
        list(&[[0.4, 0.3, 0.3], [0.9, 0.35, 0.3], [0.6, 0.8, 0.3]])
    );
    if curved {
        let [x, y, z, r] = [0.7, 0.5, 0.55, 0.15].map(|x| x * scale);
        text += &format!(
            "[[surfaces]]\nmaterial = 'white'\nsphere = {{ center = [{x:?}, {y:?}, {z:?}], radius = {r:?} }}\n"
        );
    }
    typed(&text)
}

/// Irradiance coefficients over the length unit.
fn light(scale: f64, curved: bool, order: usize) -> Vec<f64> {
    let options = Options { order, ..Options::default() };
    let solution = outcome_of(&room(scale, curved), &options).solution;
    solution.bands()[0].coefficients.irradiance.iter().map(|h| h / scale).collect()
}

fn compare(row: &Row, scales: &[f64], curved: &[bool], order: usize) {
    for curved in curved.iter().copied() {
        let plain = light(1.0, curved, order);
        let largest = plain.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        for scale in scales {
            let scaled = light(*scale, curved, order);
            let error = plain.iter().zip(&scaled).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            row.add(error / largest, || format!("scale {scale:e}, curved: {curved}"));
        }
    }
}

#[test]
fn light_has_no_unit_of_length() {
    compare(
        &Row::new("lengths times 2^k", "k = ±20", 0.0, "of the light"),
        &[-20, 20].map(|k| 2f64.powi(k)),
        &[false, true],
        1,
    );
    let tens = [1e-6, 1e6];
    compare(&Row::new("lengths times 10^k", "k = ±6", 1e-12, "of the light"), &tens, &[false], 1);
    // Rounding decides in which order equal walls are told apart, and so which rays they send: to the
    // accuracy of shadows.
    compare(&Row::new("the same behind a ball", "k = ±6", 3e-3, "of the light"), &tens, &[true], 1);
}

#[test]
#[ignore = "many scales"]
fn light_has_no_unit_of_length_at_all() {
    let two: Vec<f64> = (-20..=20).step_by(5).map(|k| 2f64.powi(k)).collect();
    compare(&Row::new("lengths times 2^k", "k from −20 to 20", 0.0, "of the light"), &two, &[false, true], 3);
    let ten: Vec<f64> = (-6..=6).map(|k| 10f64.powi(k)).collect();
    compare(&Row::new("lengths times 10^k", "k from −6 to 6", 1e-12, "of the light"), &ten, &[false], 3);
    compare(&Row::new("the same behind a ball", "k from −6 to 6", 3e-3, "of the light"), &ten, &[true], 3);
}
