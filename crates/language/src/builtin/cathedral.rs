//! The text of the cathedral: a nave and two aisles under vaults, and a lamp that travels along the nave.
//!
//! All lengths are in metres and are the design of this scene; z points up, the nave runs along y from the
//! wall y = 0. A bay is as long as the distance of two columns and is written for x > 0 about its middle;
//! half a turn makes the other side. Groin vaults are four webs, parts of two cylinders (the one across the
//! nave round, the one along it elliptic) that end at the groins. Webs, the walls over arches and windows are
//! ruled between an arc and a second curve at the same parameters, so that every seam is exact; capitals and
//! bases lead from a square to a circle.

use std::fmt::Write;

use super::arcs::{Point, WEIGHT, circle, quarter, square};

/// Distance between columns (length).
const BAY: f64 = 5.0;
/// Half the width of the nave, thickness of its walls, width of an aisle.
const NAVE: f64 = 4.0;
const WALL: f64 = 0.8;
const AISLE: f64 = 4.0;
/// Heights of the springing of the arches, of the nave's vault and of the aisles' vaults (length).
const ARCHES: f64 = 4.5;
const VAULT: f64 = 9.0;
const AISLE_VAULT: f64 = VAULT - AISLE;
/// Half the width of the square under and over a column, radius of its shaft.
const PIER: f64 = 0.5 * WALL;
const SHAFT: f64 = 0.33;
/// Heights of a column: top of the plinth, of the base, of the shaft.
const ORDERS: [f64; 3] = [0.3, 0.6, 3.85];
/// Radius of the arches, and of the rose windows.
const ARCH: f64 = 0.5 * BAY - PIER;
const ROSE: f64 = 2.4;
/// Radius and height of the lamp, and how near it comes to the end walls.
const LAMP: [f64; 3] = [0.18, 3.2, 2.0];

const HEADER: &str = r#"title = "Cathedral: a vaulted nave and aisles, and a lamp that travels along the nave"
frames = 100
fps = 25

[camera]
eye = [-2.2, 0.7, 1.9]
target = [0.9, 11, 4.9]
fov = 82
width = 640
height = 640

[materials.stone]
reflectance = [0.66, 0.61, 0.53]

[materials.vault]
reflectance = [0.7, 0.68, 0.63]

[materials.floor]
reflectance = [0.34, 0.29, 0.25]

[materials.window]
reflectance = [0.1, 0.16, 0.3]

[materials.rose]
reflectance = [0.4, 0.1, 0.15]

[materials.lamp]
reflectance = 0
emission = [1900, 1450, 850]
"#;

/// The text of the cathedral with `bays` bays.
pub(super) fn text(bays: usize) -> String {
    let mut cathedral = Cathedral { text: HEADER.to_owned(), list: "" };
    let length = BAY * bays as f64;
    cathedral.list = "parts.half.surfaces";
    cathedral.arcade();
    cathedral.vault();
    cathedral.aisle();
    cathedral.list = "parts.quarter.surfaces";
    cathedral.quarter_of_column();
    cathedral.list = "parts.column.surfaces";
    let [_, base, shaft] = ORDERS;
    let cylinder =
        format!("cylinder = {{ base = [0, 0, {base}], axis = [0, 0, {}], radius = {SHAFT} }}", shaft - base);
    cathedral.surface("shaft", "stone", &cylinder);
    cathedral.list = "parts.end.surfaces";
    cathedral.end();
    cathedral.list = "surfaces";
    cathedral.rectangle("floor", "floor", [[-NAVE, 0.0, 0.0], [2.0 * NAVE, 0.0, 0.0], [0.0, length, 0.0]]);
    let [radius, height, margin] = LAMP;
    let lamp = format!("sphere = {{ center = [0, {margin}, {height}], radius = {radius} }}");
    cathedral.surface("lamp", "lamp", &lamp);
    let mut text = cathedral.text;
    write!(text, "{}", placed(bays, length)).expect("a String takes all text");
    text
}

/// The instances, and the motion of the lamp.
fn placed(bays: usize, length: f64) -> String {
    let quarters: String = [0, 90, 180, 270]
        .map(|degrees| {
            format!(
                "\n[[parts.column.instances]]\npart = \"quarter\"\nname = \"at-{degrees}\"\n\
                 transform = {{ rotate = [0, 0, 1, {degrees}] }}\n"
            )
        })
        .concat();
    let way = length - 2.0 * LAMP[2];
    let axis = NAVE + PIER;
    let columns = bays - 1;
    format!(
        r#"{quarters}
[[instances]]
part = "half"
name = "right"
transform = {{ translate = [0, {}, 0] }}
array = {{ count = {bays}, step = [0, {BAY}, 0] }}

[[instances]]
part = "half"
name = "left"
transform = {{ rotate = [0, 0, 1, 180], translate = [0, {}, 0] }}
array = {{ count = {bays}, step = [0, {BAY}, 0] }}

[[instances]]
part = "column"
name = "column-right"
transform = {{ translate = [{axis}, {BAY}, 0] }}
array = {{ count = {columns}, step = [0, {BAY}, 0] }}

[[instances]]
part = "column"
name = "column-left"
transform = {{ translate = [{}, {BAY}, 0] }}
array = {{ count = {columns}, step = [0, {BAY}, 0] }}

[[instances]]
part = "end"
name = "front"

[[instances]]
part = "end"
name = "back"
transform = {{ rotate = [0, 0, 1, 180], translate = [0, {length}, 0] }}

[[motion]]
name = "lamp"
surfaces = ["lamp"]
translate = {{ points = [[0, 0, 0], [0, {way}, 0]] }}
"#,
        0.5 * BAY,
        0.5 * BAY,
        -axis,
    )
}

/// Side of a patch that faces the air.
#[derive(Clone, Copy)]
enum Front {
    AsWritten,
    Turned,
}

struct Cathedral {
    text: String,
    /// The list that surfaces are added to.
    list: &'static str,
}

impl Cathedral {
    fn surface(&mut self, name: &str, material: &str, shape: &str) {
        let list = self.list;
        write!(self.text, "\n[[{list}]]\nname = {name:?}\nmaterial = {material:?}\n{shape}\n")
            .expect("a String takes all text");
    }

    /// A rectangle with its front towards edge1 × edge2.
    fn rectangle(&mut self, name: &str, material: &str, [origin, edge1, edge2]: [Point; 3]) {
        let shape =
            format!("parallelogram = {{ origin = {origin:?}, edge1 = {edge1:?}, edge2 = {edge2:?} }}");
        self.surface(name, material, &shape);
    }

    /// A rational bicubic patch through rows of control points that all run along arcs.
    fn patch(&mut self, name: &str, material: &str, rows: [[Point; 4]; 4], front: Front) {
        let points: [[Point; 4]; 4] = std::array::from_fn(|i| rows.map(|row| row[i]));
        let weights = [1.0, WEIGHT, WEIGHT, 1.0].map(|weight| [weight; 4]);
        let flip = if matches!(front, Front::Turned) { "flip = true\n" } else { "" };
        self.surface(
            name,
            material,
            &format!("{flip}rational = {{ points = {points:?}, weights = {weights:?} }}"),
        );
    }

    /// The patch that is ruled from an arc to another curve of the same weights.
    fn ruled(&mut self, name: &str, material: &str, [from, to]: [[Point; 4]; 2], front: Front) {
        let between = |part: f64| -> [Point; 4] {
            std::array::from_fn(|i| std::array::from_fn(|k| (1.0 - part) * from[i][k] + part * to[i][k]))
        };
        self.patch(name, material, [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0].map(between), front);
    }

    /// The wall between nave and aisle over an arch, seen from both, the arch, and the windows over it.
    fn arcade(&mut self) {
        let thick = [WALL, 0.0, 0.0];
        let arch = format!(
            "flip = true\ncylinder = {{ base = [{NAVE}, 0, {ARCHES}], axis = {thick:?}, radius = {ARCH}, angle = [0, 180] }}"
        );
        self.surface("arch", "stone", &arch);
        self.rectangle("threshold", "floor", [[NAVE, -ARCH, 0.0], thick, [0.0, 2.0 * ARCH, 0.0]]);
        let (up, along) = ([0.0, 0.0, VAULT - ARCHES], [0.0, PIER, 0.0]);
        for (place, sign, start) in [("near", -1.0, -0.5 * BAY), ("far", 1.0, ARCH)] {
            let (toward_nave, toward_aisle) = match sign > 0.0 {
                true => (Front::AsWritten, Front::Turned),
                false => (Front::Turned, Front::AsWritten),
            };
            let arc = |x: f64| quarter().map(|[c, s]| [x, sign * ARCH * c, ARCHES + ARCH * s]);
            let top = |x: f64| quarter().map(|[c, _]| [x, sign * ARCH * c, VAULT]);
            let outer = NAVE + WALL;
            self.ruled(&format!("spandrel-{place}"), "stone", [arc(NAVE), top(NAVE)], toward_nave);
            self.ruled(&format!("spandrel-aisle-{place}"), "stone", [arc(outer), top(outer)], toward_aisle);
            self.rectangle(&format!("pier-{place}"), "stone", [[NAVE, start, ARCHES], up, along]);
            self.rectangle(&format!("pier-aisle-{place}"), "stone", [[outer, start, ARCHES], along, up]);
            let sill = quarter().map(|[c, _]| [NAVE, 0.5 * sign * BAY * c, VAULT]);
            let head = quarter().map(|[c, s]| [NAVE, 0.5 * sign * BAY * c, VAULT + NAVE * s]);
            self.ruled(&format!("window-{place}"), "window", [sill, head], toward_nave);
        }
    }

    /// The webs over x > 0: two against the arches across the nave, and the two halves of that against the
    /// windows.
    fn vault(&mut self) {
        let half = 0.5 * BAY;
        for (place, sign) in [("near", -1.0), ("far", 1.0)] {
            let (across, along) = match sign > 0.0 {
                true => (Front::Turned, Front::AsWritten),
                false => (Front::AsWritten, Front::Turned),
            };
            let groin = quarter().map(|[c, s]| [NAVE * c, sign * half * c, VAULT + NAVE * s]);
            let arch = quarter().map(|[c, s]| [NAVE * c, sign * half, VAULT + NAVE * s]);
            let head = quarter().map(|[c, s]| [NAVE, sign * half * c, VAULT + NAVE * s]);
            self.ruled(&format!("web-{place}"), "vault", [arch, groin], across);
            self.ruled(&format!("web-window-{place}"), "vault", [head, groin], along);
        }
    }

    /// Floor, wall and vault of the aisle.
    fn aisle(&mut self) {
        let (inner, outer, half) = (NAVE + WALL, NAVE + WALL + AISLE, 0.5 * BAY);
        let along = [0.0, BAY, 0.0];
        self.rectangle("aisle-floor", "floor", [[inner, -half, 0.0], [AISLE, 0.0, 0.0], along]);
        self.rectangle("aisle-wall", "stone", [[outer, -half, 0.0], [0.0, 0.0, AISLE_VAULT], along]);
        let vault = format!(
            "flip = true\ncylinder = {{ base = [{inner}, {}, {AISLE_VAULT}], axis = {along:?}, radius = {AISLE}, angle = [270, 360] }}",
            -half
        );
        self.surface("aisle-vault", "vault", &vault);
    }

    /// The side towards +x of a plinth, the base on it, and the capital.
    fn quarter_of_column(&mut self) {
        let [plinth, base, shaft] = ORDERS;
        let side = [[PIER, -PIER, 0.0], [0.0, 2.0 * PIER, 0.0], [0.0, 0.0, plinth]];
        self.rectangle("plinth", "stone", side);
        let rows = [
            square(PIER, plinth),
            circle(1.15 * SHAFT, plinth + 0.05),
            circle(1.02 * SHAFT, plinth + 0.14),
            circle(SHAFT, base),
        ];
        self.patch("base", "stone", rows, Front::AsWritten);
        let rows = [
            circle(SHAFT, shaft),
            circle(SHAFT, shaft + 0.25),
            circle(1.1 * SHAFT, shaft + 0.5),
            square(PIER, ARCHES),
        ];
        self.patch("capital", "stone", rows, Front::AsWritten);
    }

    /// The end of nave and aisles at y = 0, with a rose window and half a pier on either side.
    fn end(&mut self) {
        let wall = [[-NAVE, 0.0, 0.0], [0.0, 0.0, VAULT], [2.0 * NAVE, 0.0, 0.0]];
        self.rectangle("wall", "stone", wall);
        let half = |radius: f64, inner: f64, angle: [u32; 2], [x, z]: [f64; 2]| {
            format!(
                "disk = {{ center = [{x}, 0, {z}], normal = [0, 1, 0], radius = {radius}, inner_radius = {inner}, angle = {angle:?} }}"
            )
        };
        let over = [180, 360];
        self.surface("rose", "rose", &half(ROSE, 0.0, over, [0.0, VAULT]));
        self.surface("gable", "stone", &half(NAVE, ROSE, over, [0.0, VAULT]));
        let (up, deep) = ([0.0, 0.0, ARCHES], [0.0, PIER, 0.0]);
        for (side, sign, angle) in [("right", 1.0, [270, 360]), ("left", -1.0, [180, 270])] {
            let (inner, outer) = (sign * NAVE, sign * (NAVE + WALL));
            let low = |x: f64, width: f64| if sign > 0.0 { x } else { x - width };
            let toward = |edges: [Point; 2]| if sign > 0.0 { edges } else { [edges[1], edges[0]] };
            let [first, second] = toward([up, deep]);
            self.rectangle(&format!("respond-{side}"), "stone", [[inner, 0.0, 0.0], first, second]);
            let [first, second] = toward([deep, up]);
            self.rectangle(&format!("respond-aisle-{side}"), "stone", [[outer, 0.0, 0.0], first, second]);
            let face = [[low(inner, WALL), PIER, 0.0], up, [WALL, 0.0, 0.0]];
            self.rectangle(&format!("respond-face-{side}"), "stone", face);
            let wall = [[low(outer, AISLE), 0.0, 0.0], [0.0, 0.0, AISLE_VAULT], [AISLE, 0.0, 0.0]];
            self.rectangle(&format!("aisle-{side}"), "stone", wall);
            let lunette = half(AISLE, 0.0, angle, [outer, AISLE_VAULT]);
            self.surface(&format!("lunette-{side}"), "stone", &lunette);
        }
    }
}
