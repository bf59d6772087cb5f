//! The text of the temple: a vaulted nave between two rows of columns, an aisle on either side.
//!
//! All lengths are in metres and are the design of this scene; z points up, the nave runs along y from the
//! wall y = 0 to the dais. A half turn about the temple's vertical axis exchanges the two rows: everything is
//! written for x > 0, and the parts of a row are turned to the other side. A column consists of quarters,
//! each turned four times. No two surfaces cross: floors end where plinths and pilasters stand, and base and
//! capital lead from square to circle by exact arcs, so that every contact is a common edge or a part of one.

use std::fmt::Write;

use super::arcs::{Point, WEIGHT, circle, square};

/// Distance between columns (length).
const BAY: f64 = 2.2;
/// Floor of the aisles, two steps above the nave, and depth of a step.
const UPPER: f64 = 0.32;
const TREAD: f64 = 0.3;
/// Distance of the first step's riser from the middle of the nave (length).
const STEP: f64 = 2.0;
/// Depth of the dais between the last step and the wall.
const DAIS: f64 = 4.0;
/// Axis of the columns, half the widths of plinth and beam, radius of the shaft.
const COLUMN: f64 = 3.0;
const PLINTH: f64 = 0.42;
const BEAM: f64 = 0.36;
const SHAFT_RADIUS: f64 = 0.28;
/// Heights above the floor of the aisles: top of the plinth, the base, the shaft, the capital, the abacus.
const ORDERS: [f64; 5] = [0.22, 0.42, 3.78, 4.13, 4.25];
/// Soffit and upper edge of the beams, springing of the vault, and half its span.
const SOFFIT: f64 = UPPER + ORDERS[4];
const CORNICE: f64 = 5.15;
const SPRINGING: f64 = 5.4;
const SPAN: f64 = 2.44;
/// Side walls; depth, half the width and height of their pilasters.
const WALL: f64 = 5.4;
const PILASTER: [f64; 3] = [0.18, 0.3, 4.4];
/// Size of the mouldings under the ceilings of the aisles.
const MOULDING: f64 = 0.2;
/// Radius, lower and upper end of the lamps.
const LAMP: [f64; 3] = [0.11, 3.5, 4.1];

const HEADER: &str = r#"title = "Temple: a vaulted nave, two rows of columns, lamps between them"

[camera]
eye = [0.75, 0.5, 1.95]
target = [-0.35, 12, 2.75]
up = [0, 0, 1]
fov = 66
width = 800
height = 640

[materials.stone]
reflectance = [0.72, 0.67, 0.58]

[materials.marble]
reflectance = [0.55, 0.5, 0.44]

[materials.brick]
reflectance = [0.5, 0.34, 0.25]

[materials.plaster]
reflectance = [0.66, 0.68, 0.7]

[materials.bronze]
reflectance = [0.5, 0.36, 0.2]

[materials.lamp]
reflectance = 0
emission = [100, 92, 78]
"#;

/// The text of the temple with `bays` bays.
pub(super) fn text(bays: usize) -> String {
    let mut temple = Temple { text: HEADER.to_owned(), bays, length: BAY * bays as f64 };
    temple.floors();
    temple.ends();
    for turned in [false, true] {
        temple.side_wall(turned);
        (0..bays).for_each(|bay| temple.bay(bay, turned));
        (1..bays).for_each(|number| temple.column(number, turned));
    }
    temple.urn();
    temple.text
}

struct Temple {
    text: String,
    bays: usize,
    length: f64,
}

/// Place of a surface that is written for x > 0.
#[derive(Clone, Copy)]
enum Put {
    Here,
    /// Turned about the temple's axis by half a turn.
    Across,
    /// Turned about its own axis by quarters, then moved.
    Quarter(u32, Point),
}

impl Put {
    fn across(turned: bool) -> Self {
        if turned { Put::Across } else { Put::Here }
    }
}

impl Temple {
    fn surface(&mut self, name: &str, material: &str, put: Put, shape: &str) {
        let length = self.length;
        let transform = match put {
            Put::Here => String::new(),
            Put::Across => {
                format!("transform = {{ rotate = [0, 0, 1, 180], translate = [0, {length}, 0] }}\n")
            }
            Put::Quarter(quarters, [x, y, z]) => {
                let degrees = 90 * quarters;
                format!("transform = {{ rotate = [0, 0, 1, {degrees}], translate = [{x}, {y}, {z}] }}\n")
            }
        };
        write!(self.text, "\n[[surfaces]]\nname = {name:?}\nmaterial = {material:?}\n{transform}{shape}\n")
            .expect("a String takes all text");
    }

    /// A rectangle with its front towards edge1 × edge2.
    fn rectangle(&mut self, name: &str, material: &str, put: Put, [origin, edge1, edge2]: [Point; 3]) {
        let shape =
            format!("parallelogram = {{ origin = {origin:?}, edge1 = {edge1:?}, edge2 = {edge2:?} }}");
        self.surface(name, material, put, &shape);
    }

    /// Floor of the nave, and the steps up to the aisles and to the dais.
    fn floors(&mut self) {
        let (length, riser) = (self.length, 0.5 * UPPER);
        let end = length - DAIS - TREAD;
        let (width, second) = (2.0 * STEP, STEP + TREAD);
        let nave = format!(
            "order = 7\nparallelogram = {{ origin = [{}, 0, 0], edge1 = [{width}, 0, 0], edge2 = [0, {end}, 0] }}",
            -STEP
        );
        self.surface("floor", "marble", Put::Here, &nave);
        let up = [0.0, 0.0, riser];
        self.rectangle("riser-1", "brick", Put::Here, [[-STEP, end, 0.0], [width, 0.0, 0.0], up]);
        let tread = [[-STEP, end, riser], [width, 0.0, 0.0], [0.0, TREAD, 0.0]];
        self.rectangle("tread", "brick", Put::Here, tread);
        let upper = [[-second, end + TREAD, riser], [2.0 * second, 0.0, 0.0], up];
        self.rectangle("riser-2", "brick", Put::Here, upper);
        let dais = [[-second, end + TREAD, UPPER], [2.0 * second, 0.0, 0.0], [0.0, DAIS, 0.0]];
        self.rectangle("dais", "marble", Put::Here, dais);
        // The steps end at the dais and are not equal after a half turn: each side is written out.
        for (side, sign) in [("right", 1.0), ("left", -1.0)] {
            let along = |y: f64| [0.0, sign * y, 0.0];
            let from = |y: f64| if sign > 0.0 { 0.0 } else { y };
            let first = [[sign * STEP, from(end), 0.0], up, along(end)];
            self.rectangle(&format!("riser-1-{side}"), "brick", Put::Here, first);
            let tread =
                [[sign * STEP, from(end + TREAD), riser], [sign * TREAD, 0.0, 0.0], along(end + TREAD)];
            self.rectangle(&format!("tread-{side}"), "brick", Put::Here, tread);
            let second = [[sign * second, from(end + TREAD), riser], up, along(end + TREAD)];
            self.rectangle(&format!("riser-2-{side}"), "brick", Put::Here, second);
        }
    }

    /// The end walls with the half disks above them, and the vault.
    fn ends(&mut self) {
        let length = self.length;
        for (name, y, normal, angle) in [("front", 0.0, 1.0, [180, 360]), ("back", length, -1.0, [0, 180])] {
            self.end_wall(name, y, normal);
            let disk = format!(
                "order = 7\ndisk = {{ center = [0, {y}, {SPRINGING}], normal = [0, {normal}, 0], radius = {SPAN}, angle = {angle:?} }}"
            );
            self.surface(&format!("lunette-{name}"), "stone", Put::Here, &disk);
        }
        let vault = format!(
            "order = 7\nflip = true\ncylinder = {{ base = [0, 0, {SPRINGING}], axis = [0, {length}, 0], radius = {SPAN}, angle = [180, 360] }}"
        );
        self.surface("vault", "plaster", Put::Here, &vault);
    }

    /// The wall at y with its front towards `normal` y: one piece behind the nave, others behind the aisles
    /// and steps.
    fn end_wall(&mut self, name: &str, y: f64, normal: f64) {
        let [inner, outer, second] = [COLUMN - BEAM, COLUMN + BEAM, STEP + TREAD];
        let mut pieces = vec![("nave", [-inner, inner], [UPPER, SPRINGING])];
        if normal > 0.0 {
            pieces.push(("foot", [-STEP, STEP], [0.0, 0.5 * UPPER]));
            pieces.push(("step", [-second, second], [0.5 * UPPER, UPPER]));
        }
        pieces.push(("right-jamb", [inner, outer], [UPPER, SOFFIT]));
        pieces.push(("left-jamb", [-outer, -inner], [UPPER, SOFFIT]));
        // The part of the wall that mouldings hide belongs to the wall.
        pieces.push(("right", [outer, WALL], [UPPER, CORNICE]));
        pieces.push(("left", [-WALL, -outer], [UPPER, CORNICE]));
        for (piece, [x0, x1], [z0, z1]) in pieces {
            let (across, up) = ([x1 - x0, 0.0, 0.0], [0.0, 0.0, z1 - z0]);
            let edges = if normal > 0.0 { [up, across] } else { [across, up] };
            let order = if piece == "nave" { "order = 7\n" } else { "" };
            let shape = format!(
                "{order}parallelogram = {{ origin = [{x0}, {y}, {z0}], edge1 = {:?}, edge2 = {:?} }}",
                edges[0], edges[1]
            );
            self.surface(&format!("wall-{name}-{piece}"), "stone", Put::Here, &shape);
        }
    }

    /// Surfaces along a whole side: the floor before the columns, floor and ceiling of the aisle, the top of
    /// the wall.
    fn side_wall(&mut self, turned: bool) {
        let (side, put, length) = (side(turned), Put::across(turned), [0.0, self.length, 0.0]);
        let across = |x: [f64; 2]| [x[1] - x[0], 0.0, 0.0];
        let edge = [STEP + TREAD, COLUMN - PLINTH];
        self.rectangle(&format!("{side}-edge"), "marble", put, [[edge[0], 0.0, UPPER], across(edge), length]);
        let aisle = [COLUMN + PLINTH, WALL - PILASTER[0]];
        self.rectangle(
            &format!("{side}-aisle"),
            "marble",
            put,
            [[aisle[0], 0.0, UPPER], across(aisle), length],
        );
        let top = [0.0, 0.0, CORNICE - MOULDING - PILASTER[2]];
        self.rectangle(&format!("{side}-wall-top"), "stone", put, [[WALL, 0.0, PILASTER[2]], top, length]);
    }

    /// The surfaces of one bay of a side between its columns.
    fn bay(&mut self, bay: usize, turned: bool) {
        let (side, put) = (side(turned), Put::across(turned));
        let name = |part: &str| format!("{side}-{part}-{}", bay + 1);
        let (bays, start, end) = (self.bays, bay as f64 * BAY, (bay + 1) as f64 * BAY);
        // From column to column; the temple's ends have none.
        let between = |half: f64| {
            let from = if bay == 0 { start } else { start + half };
            let to = if bay + 1 == bays { end } else { end - half };
            (from, [0.0, to - from, 0.0])
        };
        let [inner, outer] = [COLUMN - BEAM, COLUMN + BEAM];
        let (y, along) = between(PLINTH);
        self.rectangle(
            &name("floor"),
            "marble",
            put,
            [[COLUMN - PLINTH, y, UPPER], [2.0 * PLINTH, 0.0, 0.0], along],
        );
        let (y, along) = between(BEAM);
        self.rectangle(&name("soffit"), "stone", put, [[inner, y, SOFFIT], along, [2.0 * BEAM, 0.0, 0.0]]);
        let (y, along) = between(PILASTER[1]);
        let foot = WALL - PILASTER[0];
        self.rectangle(&name("margin"), "marble", put, [[foot, y, UPPER], [PILASTER[0], 0.0, 0.0], along]);
        let height = [0.0, 0.0, PILASTER[2] - UPPER];
        self.rectangle(&name("wall"), "stone", put, [[WALL, y, UPPER], height, along]);
        let whole = [0.0, BAY, 0.0];
        let frieze = CORNICE - MOULDING;
        let faces = [[inner, start, SOFFIT], [0.0, 0.0, CORNICE - SOFFIT], whole];
        self.rectangle(&name("beam-nave"), "stone", put, faces);
        let faces = [[outer, start, SOFFIT], whole, [0.0, 0.0, frieze - SOFFIT]];
        self.rectangle(&name("beam-aisle"), "stone", put, faces);
        let ceiling = [outer + MOULDING, WALL - MOULDING];
        let ceiling = [[ceiling[0], start, CORNICE], whole, [ceiling[1] - ceiling[0], 0.0, 0.0]];
        self.rectangle(&name("ceiling"), "plaster", put, ceiling);
        let cornice = [[inner, CORNICE], [inner, CORNICE + 0.13], [SPAN, CORNICE + 0.12], [SPAN, SPRINGING]];
        self.moulding(&name("cornice"), put, cornice, [start, BAY]);
        let cove = |x: f64, sign: f64| {
            let at = |a: f64, b: f64| [x + sign * a * MOULDING, frieze + b * MOULDING];
            [at(0.0, 0.0), at(0.0, 0.7), at(0.3, 1.0), at(1.0, 1.0)]
        };
        self.moulding(&name("cove-beam"), put, cove(outer, 1.0), [end, -BAY]);
        self.moulding(&name("cove-wall"), put, cove(WALL, -1.0), [start, BAY]);
        if 0 < bay && bay + 1 < self.bays {
            self.lamp(&name("lamp"), put, start + 0.5 * BAY);
        }
    }

    /// A profile in x and z drawn along y from `y[0]` by `y[1]`; its front is to the right of the profile
    /// seen along y.
    fn moulding(&mut self, name: &str, put: Put, profile: [[f64; 2]; 4], y: [f64; 2]) {
        let curve = profile.map(|[x, z]| [x, y[0], z]);
        let shape = format!("extrusion = {{ curve = {curve:?}, direction = [0, {}, 0] }}", y[1]);
        self.surface(name, "stone", put, &shape);
    }

    /// A luminous cylinder between two disks.
    fn lamp(&mut self, name: &str, put: Put, y: f64) {
        let [radius, low, high] = LAMP;
        let glass = format!(
            "order = 13\ncylinder = {{ base = [{COLUMN}, {y}, {low}], axis = [0, 0, {}], radius = {radius} }}",
            high - low
        );
        self.surface(name, "lamp", put, &glass);
        for (end, z, normal) in [("foot", low, -1), ("top", high, 1)] {
            let disk = format!(
                "disk = {{ center = [{COLUMN}, {y}, {z}], normal = [0, 0, {normal}], radius = {radius} }}"
            );
            self.surface(&format!("{name}-{end}"), "bronze", put, &disk);
        }
    }

    /// A column before the bay `number`, and the pilaster behind it.
    fn column(&mut self, number: usize, turned: bool) {
        let (side, put) = (side(turned), Put::across(turned));
        let y = number as f64 * BAY;
        let place = if turned { [-COLUMN, self.length - y, UPPER] } else { [COLUMN, y, UPPER] };
        let [plinth, base, shaft, capital, abacus] = ORDERS;
        let name = |part: &str| format!("{side}-{part}-{number}");
        self.prism(&name("plinth"), place, PLINTH, [0.0, plinth]);
        let r = SHAFT_RADIUS;
        let rows = [
            square(PLINTH, plinth),
            circle(1.4 * r, plinth + 0.04),
            circle(1.02 * r, plinth + 0.1),
            circle(r, base),
        ];
        self.blend(&name("base"), "stone", place, rows);
        let cylinder = format!(
            "cylinder = {{ base = [0, 0, {base}], axis = [0, 0, {}], radius = {r}, angle = [-45, 45] }}",
            shaft - base
        );
        for quarter in 0..4 {
            self.surface(
                &format!("{}-{quarter}", name("shaft")),
                "stone",
                Put::Quarter(quarter, place),
                &cylinder,
            );
        }
        let rows = [
            circle(r, shaft),
            circle(r, shaft + 0.16),
            circle(1.45 * r, shaft + 0.24),
            square(BEAM, capital),
        ];
        self.blend(&name("capital"), "stone", place, rows);
        self.prism(&name("abacus"), place, BEAM, [capital, abacus]);
        let [depth, half, top] = PILASTER;
        let (x, height) = (WALL - depth, [0.0, 0.0, top - UPPER]);
        let wide = [0.0, 2.0 * half, 0.0];
        self.rectangle(&name("pilaster"), "stone", put, [[x, y - half, UPPER], height, wide]);
        let deep = [depth, 0.0, 0.0];
        self.rectangle(&name("pilaster-near"), "stone", put, [[x, y - half, UPPER], deep, height]);
        self.rectangle(&name("pilaster-far"), "stone", put, [[x, y + half, UPPER], height, deep]);
        self.rectangle(&name("pilaster-top"), "stone", put, [[x, y - half, top], deep, wide]);
    }

    /// The four sides of a square block.
    fn prism(&mut self, name: &str, place: Point, half: f64, z: [f64; 2]) {
        let shape = format!(
            "parallelogram = {{ origin = [{half}, {}, {}], edge1 = [0, {}, 0], edge2 = [0, 0, {}] }}",
            -half,
            z[0],
            2.0 * half,
            z[1] - z[0]
        );
        for quarter in 0..4 {
            self.surface(&format!("{name}-{quarter}"), "stone", Put::Quarter(quarter, place), &shape);
        }
    }

    /// Four rational bicubic patches through sections from the lowest to the highest.
    fn blend(&mut self, name: &str, material: &str, place: Point, sections: [[Point; 4]; 4]) {
        let points: [[Point; 4]; 4] = std::array::from_fn(|i| sections.map(|section| section[i]));
        let weights = [1.0, WEIGHT, WEIGHT, 1.0].map(|weight| [weight; 4]);
        let shape = format!("rational = {{ points = {points:?}, weights = {weights:?} }}");
        for quarter in 0..4 {
            self.surface(&format!("{name}-{quarter}"), material, Put::Quarter(quarter, place), &shape);
        }
    }

    /// An urn with a lid on a pedestal in the middle of the dais.
    fn urn(&mut self) {
        let place = [0.0, self.length - 0.5 * DAIS, UPPER];
        self.prism("pedestal", place, 0.45, [0.0, 1.0]);
        let foot = [square(0.45, 1.0), circle(0.4, 1.04), circle(0.2, 1.08), circle(0.16, 1.18)];
        self.blend("urn-foot", "bronze", place, foot);
        let body = [circle(0.16, 1.18), circle(0.55, 1.3), circle(0.75, 1.85), circle(0.3, 2.05)];
        self.blend("urn-body", "bronze", place, body);
        let (radius, top) = (0.4, 2.22);
        let lip = [circle(0.3, 2.05), circle(0.15, 2.14), circle(0.3, 2.2), circle(radius, top)];
        self.blend("urn-lip", "bronze", place, lip);
        // Without a lid the urn would swallow light: the inside of its walls is no front.
        let [x, y, z] = place;
        let z = z + top;
        let lid = format!("disk = {{ center = [{x}, {y}, {z}], normal = [0, 0, 1], radius = {radius} }}");
        self.surface("urn-lid", "bronze", Put::Here, &lid);
    }
}

fn side(turned: bool) -> &'static str {
    if turned { "left" } else { "right" }
}
