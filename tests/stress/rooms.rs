//! Random closed rooms with boxes on the floor and in the air: rows, energy, the furnace.

use std::f64::consts::TAU;

use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity::visibility::Shadows;

use crate::row::Row;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;
use radiosity_test_support::walls::walls;

fn quad(points: [[f64; 3]; 4]) -> String {
    format!("[[surfaces]]\nmaterial = 'white'\nquad = {{ vertices = {points:?} }}\n")
}

/// A box that is turned about the vertical, its faces seen from outside; without a bottom where it stands.
fn block(random: &mut Random, [x, y]: [f64; 2], radius: f64, height: f64) -> String {
    let angle = random.between(0.0, TAU);
    let squeeze = random.between(0.3, TAU / 4.0 - 0.3);
    let stands = random.pick(&[true, false, true]);
    let low = if stands { 0.0 } else { random.between(0.05, 0.4) * height };
    let high = low + random.between(0.1, 0.5) * height;
    let corner = |k: usize, z: f64| {
        let turn = angle + [-squeeze, squeeze, TAU / 2.0 - squeeze, TAU / 2.0 + squeeze][k % 4];
        [x + radius * turn.cos(), y + radius * turn.sin(), z]
    };
    let side = |k: usize| quad([corner(k, low), corner(k + 1, low), corner(k + 1, high), corner(k, high)]);
    let sides: String = (0..4).map(side).collect();
    let top = quad([0, 1, 2, 3].map(|k| corner(k, high)));
    let bottom = if stands { String::new() } else { quad([3, 2, 1, 0].map(|k| corner(k, low))) };
    sides + &top + &bottom
}

/// A room with up to four boxes in it, all of it white furnace: ρ = ½, E₀ = 1, B = 2.
fn room(random: &mut Random) -> Scene {
    let scale = random.power(-3.0, 3.0);
    let size = [1.0, random.between(0.5, 1.5), random.between(0.4, 1.2)].map(|x| x * scale);
    let mut text = String::from("bands = ['grey']\n[materials.white]\nreflectance = 0.5\nemission = 1\n");
    text += &walls(size).map(|wall| format!("[[surfaces]]\nmaterial = 'white'\n{wall}")).concat();
    for quarter in 0..4 {
        if random.pick(&[true, false]) {
            continue;
        }
        let cell = [0.5 * size[0], 0.5 * size[1]];
        let radius = 0.5 * cell[0].min(cell[1]) * random.between(0.2, 0.9);
        let middle = [0, 1].map(|k| {
            let first = if quarter >> k & 1 == 1 { cell[k] } else { 0.0 };
            first + random.between(1.01 * radius, cell[k] - 1.01 * radius)
        });
        text += &block(random, middle, radius, size[2]);
    }
    typed(&text)
}

/// Error that a sum over a row may have, over the accuracy asked: it adds up some twenty blocks.
const ROW: f64 = 10.0;

fn hunt(count: usize, orders: &[usize], accuracies: &[f64]) {
    let range = format!("up to 4 boxes, sizes 1e-3 to 1e3, eps {:?}", accuracies);
    let row = |what| Row::new(what, range.clone(), ROW, "eps");
    let rows = row("closed rooms with boxes, row sums");
    let energy = row("closed rooms with boxes, energy");
    let furnace = row("closed rooms with boxes, furnace, mean B of each surface");
    let mut random = Random(6);
    for case in 0..count {
        let scene = room(&mut random);
        let (order, eps) = (random.pick(orders), random.pick(accuracies));
        let options = Options { order, eps, shadow_eps: eps, shadows: Shadows::Exact, ..Options::default() };
        let outcome = outcome_of(&scene, &options);
        let checks = &outcome.checks;
        let name = || format!("room {case}, order {order}, eps {eps:e}, {} surfaces", scene.surfaces.len());
        rows.add((1.0 - checks.row_sum_min).max(checks.row_sum_max - 1.0) / eps, name);
        energy.add((checks.energy_absorbed / checks.energy_in - 1.0).abs() / eps, name);
        for surface in 0..scene.surfaces.len() {
            let off = 0.5 * outcome.solution.mean_irradiance(0, surface) - 1.0;
            furnace.add(off.abs() / eps, name);
        }
    }
}

#[test]
fn rooms_with_boxes_are_closed() {
    hunt(5, &[0, 1], &[1e-3, 1e-4]);
}

#[test]
#[ignore = "hundreds of rooms"]
fn rooms_with_boxes_are_closed_by_the_hundred() {
    hunt(200, &[0, 1, 2, 3], &[1e-2, 1e-3, 1e-4]);
    hunt(20, &[0, 1], &[1e-5]);
}
