//! Lamps: surfaces that glow, luminaires with tables, shades about balls.

use glam::DVec3;

use crate::draft::{Draft, parallelogram};
use radiosity_test_support::random::Random;

/// Angles of a luminaire's table (degrees).
const ANGLES: [f64; 9] = [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 75.0, 90.0];

/// Draws one to three lamps of one kind.
pub(crate) fn draw(draft: &mut Draft, random: &mut Random, size: DVec3) {
    let count = random.pick(&[1, 2, 3]);
    let kind = random.below(6);
    for k in 0..count {
        let x = size.x * (k as f64 + random.between(0.35, 0.65)) / f64::from(count);
        let place = DVec3::new(x, size.y * random.between(0.3, 0.7), size.z);
        match kind {
            0 => panel(draft, random, k, place),
            1 => sheet(draft, random, k, place),
            2 => spot(draft, random, place),
            3 => table(draft, random, k, place),
            4 => area(draft, random, k, place),
            _ => shade(draft, random, k, place),
        }
    }
}

/// A glowing rectangle below the ceiling.
fn panel(draft: &mut Draft, random: &mut Random, k: i32, place: DVec3) {
    draft.has("panel");
    let [a, b] = [random.between(0.2, 1.2), random.between(0.1, 0.4)];
    let origin = place - DVec3::new(0.5 * a, 0.5 * b, random.pick(&[0.02, 0.1, 0.5]));
    let lamp =
        draft.material(&format!("reflectance = 0.5\nemission = {:.0}", random.between(1000.0, 9000.0)));
    draft.surface(&format!("lamp{k}"), &lamp, "", &parallelogram(origin, b * DVec3::Y, a * DVec3::X));
}

/// A hanging sheet that glows below, and above or not.
fn sheet(draft: &mut Draft, random: &mut Random, k: i32, place: DVec3) {
    draft.has("two-sided lamp");
    let [a, b] = [random.between(0.2, 1.0), random.between(0.2, 0.5)];
    let origin = place - DVec3::new(0.5 * a, 0.5 * b, random.between(0.2, 0.8));
    let lamp =
        draft.material(&format!("reflectance = 0.4\nemission = {:.0}", random.between(1000.0, 7000.0)));
    let other = draft.paint(0.5);
    let keys = if random.unit() < 0.5 {
        "two_sided = true".to_owned()
    } else {
        format!("two_sided = true\nback_material = \"{other}\"")
    };
    draft.surface(&format!("lamp{k}"), &lamp, &keys, &parallelogram(origin, b * DVec3::Y, a * DVec3::X));
}

/// A sharp or a wide cone from a point.
fn spot(draft: &mut Draft, random: &mut Random, place: DVec3) {
    draft.has("spot");
    let position = (place - 0.01 * DVec3::Z).to_array();
    let aim = DVec3::new(0.6 * random.signed(), 0.6 * random.signed(), -1.0).to_array();
    let angle = random.between(12.0, 70.0);
    let flux = random.between(300.0, 2000.0);
    draft.luminaire(&format!(
        "position = {position:?}\naim = {aim:?}\nspot = {{ angle = {angle:.1}, edge = 6 }}\nflux = {flux:.0}"
    ));
}

/// A luminaire with a table of its intensities.
fn table(draft: &mut Draft, random: &mut Random, k: i32, place: DVec3) {
    draft.has("table");
    let exponent = random.between(0.5, 6.0);
    let wing = random.between(0.0, 1.5);
    let intensity = |angle: f64| {
        let cosine = angle.to_radians().cos().max(0.0);
        500.0 * (cosine.powf(exponent) + wing * cosine * (3.0 * angle.to_radians()).sin().powi(2))
    };
    let row = |numbers: Vec<String>| numbers.join(" ");
    let angles = row(ANGLES.iter().map(|angle| format!("{angle}")).collect());
    let candelas = row(ANGLES.iter().map(|angle| format!("{:.2}", intensity(*angle))).collect());
    let name = format!("{}-{k}.ies", random.bits());
    let text = format!(
        "IESNA:LM-63-2002\n[TEST] none\n[MANUFAC] none\nTILT=NONE\n1 -1 1 {} 1 1 2 0 0 0\n1 1 10\n{angles}\n0\n{candelas}\n",
        ANGLES.len()
    );
    draft.tables.push((name.clone(), text));
    let position = (place - random.pick(&[0.01, 0.4]) * DVec3::Z).to_array();
    draft.luminaire(&format!("position = {position:?}\nphotometry = \"{name}\""));
}

/// A luminaire with an extent.
fn area(draft: &mut Draft, random: &mut Random, k: i32, place: DVec3) {
    draft.has("extent");
    let position = (place - random.pick(&[0.05, 0.5]) * DVec3::Z).to_array();
    let [a, b] = [random.between(0.2, 1.2), random.between(0.1, 0.4)];
    let (extent, spread) =
        random.pick(&[("area", "exponent = 2"), ("area", "angle = 60, edge = 20"), ("line", "exponent = 1")]);
    let extent = if extent == "area" { format!("[{a:.3}, {b:.3}]") } else { format!("[0, {a:.3}]") };
    let flux = random.between(500.0, 3000.0);
    draft.luminaire(&format!(
        "name = \"luminaire{k}\"\nposition = {position:?}\nspot = {{ {spread} }}\nflux = {flux:.0}\nextent = {extent}"
    ));
}

/// A ball in a shade of metal or paper.
fn shade(draft: &mut Draft, random: &mut Random, k: i32, place: DVec3) {
    draft.has("shade");
    let middle = place - random.between(0.5, 1.2) * DVec3::Z;
    let bulb =
        draft.material(&format!("reflectance = 0.3\nemission = {:.0}", random.between(5000.0, 20000.0)));
    let radius = random.between(0.03, 0.07);
    let center = middle.to_array();
    draft.surface(
        &format!("bulb{k}"),
        &bulb,
        "",
        &format!("sphere = {{ center = {center:?}, radius = {radius:.4} }}"),
    );
    let sheet = if random.unit() < 0.5 {
        draft.has("paper");
        draft.material("reflectance = 0.5\ntransmittance = 0.35")
    } else {
        draft.paint(random.between(0.3, 0.7))
    };
    let base = (middle - 0.12 * DVec3::Z).to_array();
    let [r1, r2] = [random.between(0.15, 0.25), random.between(0.09, 0.14)];
    let shape =
        format!("cone = {{ base = {base:?}, axis = [0, 0, 0.25], radius1 = {r1:.4}, radius2 = {r2:.4} }}");
    draft.surface(&format!("shade{k}"), &sheet, "two_sided = true", &shape);
    let reach = DVec3::new(0.27, 0.27, 0.2);
    draft.solids.push([middle - reach, middle + reach]);
}
