//! Floor, ceiling and walls of a room, with a window to the sky.

use glam::DVec3;

use crate::draft::{Draft, cuboid, parallelogram};
use radiosity_test_support::random::Random;

/// The opening of a window in the wall x = 0: from y₀ to y₁, z₀ to z₁ (metres).
#[derive(Clone, Copy, Debug)]
struct Opening {
    y: [f64; 2],
    z: [f64; 2],
}

/// Draws the shell of a room of this size at the origin.
pub(crate) fn draw(draft: &mut Draft, random: &mut Random, size: DVec3) {
    for (name, low, high, others) in [
        ("ceiling", 0.6, 0.85, "left, right, front, back, bottom"),
        ("right", 0.3, 0.8, "left, front, back, bottom, top"),
        ("front", 0.3, 0.8, "left, right, back, bottom, top"),
        ("back", 0.3, 0.8, "left, right, front, bottom, top"),
    ] {
        let paint = draft.paint(random.between(low, high));
        let open = others.split(", ").map(|word| format!("\"{word}\"")).collect::<Vec<_>>().join(", ");
        let shape = cuboid(DVec3::ZERO, size, &open).replace(", open", ", inward = true, open");
        draft.surface(name, &paint, "", &shape);
    }
    floor(draft, random, size);
    if random.unit() < 0.5 {
        window(draft, random, size);
    } else {
        let paint = draft.paint(random.between(0.3, 0.8));
        draft.surface("left", &paint, "", &parallelogram(DVec3::ZERO, size.y * DVec3::Y, size.z * DVec3::Z));
    }
}

fn floor(draft: &mut Draft, random: &mut Random, size: DVec3) {
    let material = if random.unit() < 0.25 {
        draft.has("pattern");
        let [a, b] = [random.between(0.1, 0.3), random.between(0.4, 0.7)];
        let scale = random.pick(&[1, 2, 4]);
        draft.material(&format!(
            "reflectance = {{ cells = [[{a:.3}, {b:.3}], [{b:.3}, {a:.3}]], scale = {scale} }}"
        ))
    } else {
        draft.paint(random.between(0.15, 0.6))
    };
    draft.surface("floor", &material, "", &parallelogram(DVec3::ZERO, size.x * DVec3::X, size.y * DVec3::Y));
}

fn window(draft: &mut Draft, random: &mut Random, size: DVec3) {
    let width = random.between(0.3, 0.8) * size.y;
    let from = random.between(0.05, 0.95) * (size.y - width);
    let sill = random.pick(&[0.4, 0.8, 0.9, 1.1]);
    let opening = Opening { y: [from, from + width], z: [sill, random.between(1.9, size.z - 0.15)] };
    let Opening { y: [y0, y1], z: [z0, z1] } = opening;
    let outline = |a: [f64; 2], b: [f64; 2]| {
        [[0.0, a[0], b[0]], [0.0, a[1], b[0]], [0.0, a[1], b[1]], [0.0, a[0], b[1]]]
    };
    let wall = draft.paint(random.between(0.3, 0.8));
    let shape = format!(
        "quad = {{ vertices = {:?}, holes = [{:?}] }}",
        outline([0.0, size.y], [0.0, size.z]),
        outline(opening.y, opening.z)
    );
    draft.surface("left", &wall, "", &shape);
    let depth = if random.unit() < 0.5 { random.between(0.1, 0.35) } else { 0.0 };
    if depth > 0.0 {
        draft.has("reveal");
        let reveal = draft.paint(random.between(0.5, 0.8));
        let shape =
            cuboid(DVec3::new(-depth, y0, z0), DVec3::new(depth, y1 - y0, z1 - z0), "\"left\", \"right\"");
        draft.surface("reveal", &reveal, "", &shape.replace(", open", ", inward = true, open"));
    }
    let pane = draft.paint(0.1);
    let is_glass = random.unit() < 0.6;
    draft.has(if is_glass { "glass" } else { "opening" });
    let keys = if is_glass {
        format!("glass = {{ panes = {} }}", random.pick(&[1, 2, 3]))
    } else {
        "opening = true".into()
    };
    let [across, up] = [(y1 - y0) * DVec3::Y, (z1 - z0) * DVec3::Z];
    draft.surface("window", &pane, &keys, &parallelogram(DVec3::new(-depth, y0, z0), across, up));
    sky(draft, random);
    horizon(draft, random, size, opening);
}

fn sky(draft: &mut Draft, random: &mut Random) {
    let ground = random.between(0.05, 0.4);
    let illuminance = random.between(5000.0, 15000.0);
    let model = random.pick(&["uniform", "overcast", "clear"]);
    let mut keys = format!("model = \"{model}\"\nilluminance = {illuminance:.0}\nground = {ground:.2}");
    if model == "clear" {
        let beam = random.pick(&[0.0, 30000.0, 60000.0]);
        draft.has(if beam > 0.0 { "sun" } else { "clear sky" });
        // North is +y, so that the west, from which the sun meets the window, is −x.
        let (elevation, azimuth) = (random.between(12.0, 55.0), random.between(215.0, 325.0));
        keys += &format!(
            "\nsun = {{ elevation = {elevation:.1}, azimuth = {azimuth:.1}, illuminance = {beam} }}"
        );
    }
    draft.sky(keys);
}

/// A sensor that looks at the window from the height at which the horizon lies in it.
fn horizon(draft: &mut Draft, random: &mut Random, size: DVec3, opening: Opening) {
    draft.has("window");
    let [y, z] = [opening.y, opening.z].map(|[a, b]| random.between(a, b));
    let normal = random.pick(&[-DVec3::X, DVec3::Z]);
    draft.wanted.push([DVec3::new(random.between(0.2, 0.7) * size.x, y, z), normal]);
}
