//! Faces that lie on others, nearly or quite, and edges: a reading belongs to what is seen from its side.

use radiosity::Scene;
use radiosity_geom::DVec3;
use radiosity_test_support::scenes::typed;

use super::fairness::assert_fair;
use super::lamps::{EXITANCE, lambert};
use super::trial::{Trial, quotients};

const WALKS: f64 = 1024.0;

/// Where the lamp is, as corners.
const LAMP: [DVec3; 4] = [
    DVec3::new(1.5, 1.5, 2.9),
    DVec3::new(1.5, 2.5, 2.9),
    DVec3::new(2.5, 2.5, 2.9),
    DVec3::new(2.5, 1.5, 2.9),
];

/// A black room with a lamp, a parallelogram, and other things in it.
fn room(lamp: &str, things: &str) -> Scene {
    typed(&format!(
        r#"
bands = ["lm"]
materials.black = {{ reflectance = 0 }}
materials.glow = {{ reflectance = 0, emission = {EXITANCE:?} }}
[[surfaces]]
name = "room"
material = "black"
box = {{ origin = [0, 0, 0], size = [4, 4, 3], inward = true }}
[[surfaces]]
name = "lamp"
material = "glow"
parallelogram = {{ {lamp} }}
{things}"#
    ))
}

/// A black room with a lamp under its ceiling, in it a black desk with a black mat `gap` above it.
fn desk(gap: f64, is_mat_first: bool, is_two_sided: bool, mat: &str) -> Scene {
    let desk = "[[surfaces]]\nname = \"desk\"\nmaterial = \"black\"\ntwo_sided = true\n\
        parallelogram = { origin = [1, 1, 0.75], edge1 = [2, 0, 0], edge2 = [0, 1, 0] }\n"
        .to_owned();
    let two = if is_two_sided { "two_sided = true\n" } else { "" };
    let height = 0.75 + gap;
    let mat = mat.replace('Z', &format!("{height:?}"));
    let mat = format!("[[surfaces]]\nname = \"mat\"\nmaterial = \"black\"\n{two}{mat}\n");
    let both = if is_mat_first { mat + &desk } else { desk + &mat };
    room("origin = [1.5, 1.5, 2.9], edge1 = [0, 1, 0], edge2 = [1, 0, 0]", &both)
}

const POLYGON: &str = "polygon = { vertices = [[1.2, 1.2, Z], [1.8, 1.2, Z], [1.8, 1.4, Z], [1.5, 1.4, Z], [1.5, 1.7, Z], [1.2, 1.7, Z]] }";
const DISK: &str = "disk = { center = [1.4, 1.4, Z], normal = [0, 0, 1], radius = 0.2 }";
const SQUARE: &str = "parallelogram = { origin = [1.2, 1.2, Z], edge1 = [0.5, 0, 0], edge2 = [0, 0.5, 0] }";

/// On a mat and on the desk beside it arrives the light of the lamp; from below the desk, none.
pub(super) fn mats() -> Vec<Trial> {
    let mut trials = Vec::new();
    for gap in [0.0, 1e-12, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3] {
        for (form, name) in [(POLYGON, "polygon"), (SQUARE, "square"), (DISK, "disk")] {
            // A disk has to be a millionth of its size before a plane.
            if form == DISK && gap < 1e-6 {
                continue;
            }
            for is_first in [false, true] {
                for is_two_sided in [false, true] {
                    let scene = desk(gap, is_first, is_two_sided, form);
                    let name = format!("{name} {gap} first {is_first} two-sided {is_two_sided}");
                    let mut trial = Trial::of(name, scene);
                    for [x, y] in [[1.4, 1.3], [1.21, 1.3], [1.3, 1.4], [2.6, 1.5], [1.9, 1.9]] {
                        let point = DVec3::new(x, y, 0.75 + gap);
                        trial = trial.point(point, DVec3::Z, lambert(&LAMP, point, DVec3::Z).abs());
                    }
                    trials.push(trial.point(DVec3::new(1.4, 1.3, 0.75), -DVec3::Z, 0.0));
                }
            }
        }
    }
    trials
}

#[test]
fn mats_on_desks_receive_what_the_lamp_sends() {
    assert_fair(&quotients(&mats(), WALKS, 1000));
}

/// A black room with a lamp, over a part of which lies a cover of this transmittance, `gap` below it.
fn covered(gap: f64, transmittance: f64) -> Scene {
    let height = 2.9 - gap;
    typed(&format!(
        r#"
bands = ["lm"]
materials.black = {{ reflectance = 0 }}
materials.film = {{ reflectance = 0, transmittance = {transmittance:?} }}
materials.glow = {{ reflectance = 0, emission = {EXITANCE:?} }}
[[surfaces]]
name = "room"
material = "black"
box = {{ origin = [0, 0, 0], size = [4, 4, 3], inward = true }}
[[surfaces]]
name = "lamp"
material = "glow"
parallelogram = {{ origin = [1.5, 1.5, 2.9], edge1 = [0, 1, 0], edge2 = [1, 0, 0] }}
[[surfaces]]
name = "cover"
material = "film"
two_sided = true
parallelogram = {{ origin = [1.6, 1.6, {height:?}], edge1 = [0, 0.8, 0], edge2 = [0.8, 0, 0] }}"#
    ))
}

/// Under a lamp that is partly covered: all that it sends less what the cover keeps back.
pub(super) fn covers() -> Vec<Trial> {
    let cover = [[1.6, 1.6], [1.6, 2.4], [2.4, 2.4], [2.4, 1.6]].map(|[x, y]| DVec3::new(x, y, 2.9));
    let mut trials = Vec::new();
    for gap in [0.0, 1e-9, 1e-7] {
        for transmittance in [0.0, 0.5] {
            let name = format!("cover {gap} transmits {transmittance}");
            let mut trial = Trial::of(name, covered(gap, transmittance));
            for [x, y] in [[0.5, 0.5], [1.4, 2.1], [2.0, 2.0], [3.3, 1.2]] {
                let point = DVec3::new(x, y, 0.0);
                let from = |corners: &[DVec3]| lambert(corners, point, DVec3::Z).abs();
                let exact = from(&LAMP) - (1.0 - transmittance) * from(&cover);
                trial = trial.point(point, DVec3::Z, exact);
            }
            trials.push(trial);
        }
    }
    trials
}

#[test]
fn lamps_do_not_shine_through_what_lies_on_them() {
    assert_fair(&quotients(&covers(), 4.0 * WALKS, 1200));
}

/// In the furnace of a desk with a hole: within 1e-4 of its rim and of its outline, above, below, and upright.
pub(super) fn rims() -> Vec<Trial> {
    let text = r#"
bands = ["lm"]
materials.wall = { reflectance = 0.5, emission = 1.5 }
materials.wood = { reflectance = 0.4, emission = 1.8 }
[[surfaces]]
name = "room"
material = "wall"
box = { origin = [0, 0, 0], size = [4, 4, 3], inward = true }
[[surfaces]]
name = "desk"
material = "wood"
two_sided = true
polygon = { vertices = [[1, 1, 0.75], [3, 1, 0.75], [3, 2.5, 0.75], [1, 2.5, 0.75]], holes = [[[1.5, 1.5, 0.75], [2, 1.5, 0.75], [2, 2, 0.75], [1.5, 2, 0.75]]] }
"#;
    let mut trial = Trial::of("rims", typed(text));
    for step in [1e-4, 1e-6, 1e-9, 0.0] {
        for [x, y] in [
            [1.5 - step, 1.75],
            [1.5 + step, 1.75],
            [1.7, 1.5 - step],
            [2.0 + step, 2.0 + step],
            [1.0 - step, 2.0],
            [3.0 + step, 1.0 - step],
        ] {
            for normal in [DVec3::Z, -DVec3::Z, DVec3::X, DVec3::new(1.0, 0.5, 0.17)] {
                trial = trial.point(DVec3::new(x, y, 0.75), normal, 3.0);
            }
        }
    }
    vec![trial]
}

#[test]
fn sensors_beside_rims_receive_what_the_room_sends() {
    assert_fair(&quotients(&rims(), WALKS, 1100));
}

/// A black room with a large lamp of one side at a table's height, and sensors just over it that look at it.
fn faced() -> Vec<Trial> {
    let scene = room("origin = [0.5, 0.5, 1], edge1 = [3, 0, 0], edge2 = [0, 3, 0]", "");
    let mut trial = Trial::of("faced", scene);
    for height in [1e-4, 1e-5, 3e-6, 1.5e-6] {
        let position = DVec3::new(1.9, 2.1, 1.0 + height);
        for normal in [-DVec3::Z, DVec3::new(0.6, 0.0, -0.8)] {
            // The lamp fills all below the sensor's horizon, where it looks at it.
            trial = trial.point(position, normal, EXITANCE * 0.5 * (1.0 - normal.z));
        }
    }
    vec![trial]
}

#[test]
fn sensors_see_what_they_face_from_close_by() {
    assert_fair(&quotients(&faced(), WALKS, 1300));
}
