//! Furniture, a thing in each of some of nine parts of the floor, and sheets.

use glam::DVec3;

use crate::draft::{Draft, cuboid, parallelogram};
use radiosity_test_support::random::Random;

/// A part of the floor: its middle, and half its smaller side (metres).
#[derive(Clone, Copy, Debug)]
struct Spot {
    middle: DVec3,
    reach: f64,
}

/// Draws up to five things.
pub(crate) fn draw(draft: &mut Draft, random: &mut Random, size: DVec3) {
    let mut parts: Vec<usize> = (0..9).collect();
    for k in 0..random.below(6) {
        let part = parts.swap_remove(random.below(parts.len()));
        let middle = DVec3::new(
            size.x * (part % 3) as f64 + 0.5 * size.x,
            size.y * (part / 3) as f64 + 0.5 * size.y,
            0.0,
        ) / 3.0;
        let spot = Spot { middle, reach: 0.45 * size.x.min(size.y) / 3.0 };
        match random.below(9) {
            0 | 1 => table(draft, random, k, spot),
            2 => desk(draft, random, k, spot),
            3 => crate_(draft, random, k, spot),
            4 => ball(draft, random, k, spot),
            5 => bin(draft, random, k, spot),
            6 => leaning(draft, random, k, spot),
            7 => partition(draft, random, k, spot),
            _ => rug(draft, random, k, spot),
        }
    }
}

/// A table of a board and four legs, with a mat on it or not.
fn table(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("table top");
    let wood = draft.paint(random.between(0.2, 0.7));
    let half =
        DVec3::new(spot.reach * random.between(0.6, 0.95), spot.reach * random.between(0.4, 0.95), 0.0);
    let low = spot.middle - half + 0.7 * DVec3::Z;
    draft.surface(&format!("top{k}"), &wood, "", &cuboid(low, 2.0 * half + 0.04 * DVec3::Z, ""));
    for leg in 0..4 {
        let corner = DVec3::new(f64::from(leg % 2), f64::from(leg / 2), 0.0);
        let at = spot.middle - half + corner * (2.0 * half - 0.05);
        let (origin, size) = (at.with_z(0.0), DVec3::new(0.05, 0.05, 0.7));
        draft.surface(&format!("leg{k}{leg}"), &wood, "", &cuboid(origin, size, "\"bottom\", \"top\""));
        draft.solids.push([origin, origin + size]);
    }
    draft.solids.push([low, low + 2.0 * half + 0.04 * DVec3::Z]);
    if random.unit() < 0.5 {
        mat(draft, random, k, spot.middle + 0.74 * DVec3::Z, 0.5 * half);
    }
}

/// A thin sheet on something, with a sensor on it.
fn mat(draft: &mut Draft, random: &mut Random, k: usize, middle: DVec3, half: DVec3) {
    draft.has("mat");
    let felt = draft.paint(random.between(0.05, 0.6));
    let at = middle + random.pick(&[0.0005, 0.001, 0.003]) * DVec3::Z;
    let [a, b] = [2.0 * half.x * DVec3::X, 2.0 * half.y * DVec3::Y];
    draft.surface(&format!("mat{k}"), &felt, "", &parallelogram(at - half, a, b));
    draft.wanted.push([at + 0.3 * half, DVec3::Z]);
}

/// A board of two sides, turned.
fn desk(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("sheet");
    let [front, back] = [draft.paint(random.between(0.2, 0.7)), draft.paint(random.between(0.2, 0.7))];
    let (sine, cosine) = random.between(0.0, std::f64::consts::TAU).sin_cos();
    let [along, across] = [
        0.75 * spot.reach * DVec3::new(cosine, sine, 0.0),
        0.5 * spot.reach * DVec3::new(-sine, cosine, 0.0),
    ];
    let origin = spot.middle - along - across + 0.72 * DVec3::Z;
    let keys = format!("two_sided = true\nback_material = \"{back}\"");
    draft.surface(&format!("desk{k}"), &front, &keys, &parallelogram(origin, 2.0 * along, 2.0 * across));
    if random.unit() < 0.5 {
        let half = DVec3::new(0.3 * spot.reach, 0.3 * spot.reach, 0.0);
        mat(draft, random, k, spot.middle + 0.72 * DVec3::Z, half);
    }
}

fn crate_(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("crate");
    let wood = draft.paint(random.between(0.2, 0.7));
    let half = 0.9 * spot.reach * DVec3::new(random.between(0.4, 1.0), random.between(0.4, 1.0), 0.0);
    let size = 2.0 * half + random.between(0.3, 1.8) * DVec3::Z;
    draft.surface(&format!("crate{k}"), &wood, "", &cuboid(spot.middle - half, size, "\"bottom\""));
    draft.solids.push([spot.middle - half, spot.middle - half + size]);
}

fn ball(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("ball");
    let paint = draft.paint(random.between(0.2, 0.8));
    let radius = spot.reach * random.between(0.3, 0.9);
    let center = spot.middle + (radius + random.pick(&[0.01, 0.1, 0.4])) * DVec3::Z;
    let shape = format!("sphere = {{ center = {:?}, radius = {radius:?} }}", center.to_array());
    draft.surface(&format!("ball{k}"), &paint, "", &shape);
    draft.solids.push([center - radius, center + radius]);
}

/// A pipe that is open above, of two sides.
fn bin(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("bin");
    let paint = draft.paint(random.between(0.2, 0.8));
    let [radius, height] = [spot.reach * random.between(0.3, 0.8), random.between(0.3, 0.9)];
    let base = spot.middle.to_array();
    let shape = format!("cylinder = {{ base = {base:?}, axis = [0, 0, {height:?}], radius = {radius:?} }}");
    draft.surface(&format!("bin{k}"), &paint, "two_sided = true", &shape);
    let reach = DVec3::new(radius, radius, 0.0);
    draft.solids.push([spot.middle - reach, spot.middle + reach + height * DVec3::Z]);
}

/// A sheet that leans in the air.
fn leaning(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("sheet");
    let paint = draft.paint(random.between(0.2, 0.8));
    let along = random.direction();
    let across = along.cross(random.direction()).normalize();
    let [a, b] = [0.7 * spot.reach * along, 0.5 * spot.reach * across];
    let middle = spot.middle + random.between(0.9, 1.4) * DVec3::Z;
    draft.surface(
        &format!("sheet{k}"),
        &paint,
        "two_sided = true",
        &parallelogram(middle - a - b, 2.0 * a, 2.0 * b),
    );
}

fn partition(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("partition");
    let paint = draft.paint(random.between(0.2, 0.8));
    let half = DVec3::new(0.03, 0.95 * spot.reach, 0.0);
    let size = 2.0 * half + random.between(0.9, 1.9) * DVec3::Z;
    draft.surface(&format!("partition{k}"), &paint, "", &cuboid(spot.middle - half, size, "\"bottom\""));
    draft.solids.push([spot.middle - half, spot.middle - half + size]);
}

/// A rug just above the floor.
fn rug(draft: &mut Draft, random: &mut Random, k: usize, spot: Spot) {
    draft.has("rug");
    let half = 0.9 * spot.reach * DVec3::new(1.0, random.between(0.4, 1.0), 0.0);
    mat(draft, random, k, spot.middle + 0.002 * DVec3::Z, half);
}
