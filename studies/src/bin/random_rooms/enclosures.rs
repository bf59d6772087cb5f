//! Random scenes of heat: rooms and ducts with boxes, plates, shields and pipes of temperatures and fluxes.

use glam::DVec3;

use crate::draft::{Draft, cuboid, parallelogram};
use radiosity_test_support::random::Random;

/// Draws one.
pub(crate) fn draw(random: &mut Random) -> Draft {
    let mut draft = Draft::default();
    match random.below(4) {
        0 => plates(&mut draft, random),
        1 => pipe(&mut draft, random),
        shell => room(&mut draft, random, shell == 2),
    }
    draft
}

/// Keys of what is known: a temperature, a flux, or neither.
fn known(random: &mut Random) -> String {
    match random.below(4) {
        0 => "adiabatic = true".to_owned(),
        1 => format!("heat_flux = {:.1}", random.between(10.0, 300.0)),
        _ => warm(random),
    }
}

fn warm(random: &mut Random) -> String {
    format!("temperature = {:.1}", random.between(250.0, 900.0))
}

fn foil(draft: &mut Draft, random: &mut Random) -> String {
    draft.material(&format!("emissivity = {:.3}", random.pick(&[0.05, 0.2, 0.5, 0.8, 0.95])))
}

/// A closed room, or a long duct, with what stands in it.
fn room(draft: &mut Draft, random: &mut Random, is_duct: bool) {
    draft.has(if is_duct { "duct" } else { "room" });
    let size = match is_duct {
        true => DVec3::new(random.between(4.0, 16.0), 1.0, random.between(0.5, 1.5)),
        false => DVec3::new(random.between(1.0, 3.0), random.between(1.0, 3.0), random.between(1.0, 2.0)),
    };
    let words = ["left", "right", "front", "back", "bottom", "top"];
    for (k, word) in words.into_iter().enumerate() {
        let others = words.into_iter().filter(|own| *own != word).map(|own| format!("\"{own}\""));
        let open = others.collect::<Vec<_>>().join(", ");
        let shape = cuboid(DVec3::ZERO, size, &open).replace(", open", ", inward = true, open");
        let material = foil(draft, random);
        // The first two differ, so that heat flows.
        let keys = if k < 2 { warm(random) } else { known(random) };
        draft.surface("wall", &material, &keys, &shape);
    }
    if !is_duct {
        stand(draft, random, size);
    }
}

/// Something in a room: a box, a ball, a pipe or a shield.
fn stand(draft: &mut Draft, random: &mut Random, size: DVec3) {
    let (material, keys) = (foil(draft, random), known(random));
    let middle = size * DVec3::new(random.between(0.4, 0.6), random.between(0.4, 0.6), 0.5);
    match random.below(5) {
        0 => {
            draft.has("box");
            let half = size * random.between(0.1, 0.3);
            draft.surface("box", &material, &keys, &cuboid(middle - half, 2.0 * half, ""));
        }
        1 => {
            draft.has("ball");
            let radius = random.between(0.1, 0.35) * size.min_element();
            let shape = format!("sphere = {{ center = {:?}, radius = {radius:?} }}", middle.to_array());
            draft.surface("ball", &material, &keys, &shape);
        }
        2 => {
            draft.has("can");
            let radius = random.between(0.05, 0.3) * size.min_element();
            let [low, high] = [0.3, 0.7].map(|part| middle.with_z(part * size.z).to_array());
            let along = 0.4 * size.z;
            let shape =
                format!("cylinder = {{ base = {low:?}, axis = [0, 0, {along:?}], radius = {radius:?} }}");
            draft.surface("can", &material, &keys, &shape);
            for (name, center, z) in [("lid", high, 1), ("base", low, -1)] {
                let shape =
                    format!("disk = {{ center = {center:?}, normal = [0, 0, {z}], radius = {radius:?} }}");
                draft.surface(name, &material, &keys, &shape);
            }
        }
        3 => {
            draft.has("shield");
            let half = size * random.between(0.2, 0.45);
            let shape =
                parallelogram(middle - half.with_z(0.0), 2.0 * half.x * DVec3::X, 2.0 * half.y * DVec3::Y);
            draft.surface("shield", &material, "two_sided = true\nadiabatic = true", &shape);
        }
        _ => draft.has("empty"),
    }
}

/// Two plates that face each other across a gap, in the open or with a shield between them.
fn plates(draft: &mut Draft, random: &mut Random) {
    draft.has("plates");
    let gap = random.power(-2.0, 0.0);
    let [first, second] = [foil(draft, random), foil(draft, random)];
    let (lower, upper) = (warm(random), known(random));
    let square = |z: f64, flips: bool| {
        let [a, b] = if flips { [DVec3::Y, DVec3::X] } else { [DVec3::X, DVec3::Y] };
        parallelogram(z * DVec3::Z, a, b)
    };
    draft.surface("lower", &first, &lower, &square(0.0, false));
    draft.surface("upper", &second, &upper, &square(gap, true));
    if random.unit() < 0.4 {
        draft.has("shield");
        let material = foil(draft, random);
        draft.surface("shield", &material, "two_sided = true\nadiabatic = true", &square(0.5 * gap, false));
    }
}

/// A pipe with two lids, seen from inside.
fn pipe(draft: &mut Draft, random: &mut Random) {
    draft.has("tube");
    let length = random.power(-0.3, 0.9);
    let [wall, lid, other] = [0; 3].map(|_| foil(draft, random));
    let (around, below, above) = (known(random), warm(random), warm(random));
    let shape = format!("cylinder = {{ base = [0, 0, 0], axis = [0, 0, {length:?}], radius = 0.5 }}");
    draft.surface("wall", &wall, &format!("flip = true\n{around}"), &shape);
    draft.surface("lower", &lid, &below, "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 0.5 }");
    if random.unit() < 0.7 {
        let shape = format!("disk = {{ center = [0, 0, {length:?}], normal = [0, 0, -1], radius = 0.5 }}");
        draft.surface("upper", &other, &above, &shape);
    } else {
        draft.has("open");
    }
}
