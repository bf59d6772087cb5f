//! Rooms without anything in them: floors, walls and ceilings.

use radiosity_geom::DVec3;

use crate::interiors::surface::Surface;
use radiosity_test_support::random::Random;

/// A rectangle of a plan, [x₀, y₀, x₁, y₁].
pub(crate) type Cell = [f64; 4];

/// A room over a plan.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    pub(crate) kind: &'static str,
    pub(crate) surfaces: Vec<Surface>,
    /// Corners of the floor plan (metres), counterclockwise.
    pub(crate) outline: Vec<[f64; 2]>,
    /// Least height of the ceiling.
    pub(crate) height: f64,
    /// Parts of the floor where things may stand.
    pub(crate) cells: Vec<Spot>,
    /// Width, depth and the top of everything.
    pub(crate) size: [f64; 3],
}

/// A part of the floor where things may stand, with its height.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    pub(crate) cell: Cell,
    pub(crate) floor: f64,
}

/// A room of one of the kinds.
pub(crate) fn plan(random: &mut Random) -> Plan {
    let size = [random.between(3.0, 9.0), random.between(3.0, 7.0), random.between(2.3, 3.8)];
    match random.pick(&[0, 1, 2, 3, 4, 5]) {
        0 => rectangle(size),
        1 => angle(random, size),
        2 => court(random, size),
        3 => step(random, size),
        4 => attic(random, size),
        _ => rectangle([2.0 * size[0], size[1], size[2]]),
    }
}

fn on_floor(cell: Cell) -> Spot {
    Spot { cell, floor: 0.0 }
}

/// Floor, ceiling and upright walls over an outline.
fn upright(kind: &'static str, outline: Vec<[f64; 2]>, size: [f64; 3], cells: Vec<Cell>) -> Plan {
    let height = size[2];
    let at = |z: f64| outline.iter().map(move |[x, y]| DVec3::new(*x, *y, z));
    let mut surfaces = vec![
        Surface::polygon("floor", at(0.0).collect()),
        Surface::polygon("ceiling", at(height).rev().collect()),
    ];
    for k in 0..outline.len() {
        let ([a, b], [c, d]) = (outline[k], outline[(k + 1) % outline.len()]);
        let corner = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        let corners = vec![corner(a, b, 0.0), corner(a, b, height), corner(c, d, height), corner(c, d, 0.0)];
        surfaces.push(Surface::polygon(format!("wall {k}"), corners));
    }
    Plan { kind, surfaces, outline, height, cells: cells.into_iter().map(on_floor).collect(), size }
}

fn rectangle(size: [f64; 3]) -> Plan {
    let [w, d, _] = size;
    let outline = vec![[0.0, 0.0], [w, 0.0], [w, d], [0.0, d]];
    upright("rectangle", outline, size, vec![[0.0, 0.0, w, d]])
}

/// A room over an L.
fn angle(random: &mut Random, size: [f64; 3]) -> Plan {
    let [w, d, _] = size;
    let (x, y) = (random.between(0.35, 0.7) * w, random.between(0.35, 0.7) * d);
    let outline = vec![[0.0, 0.0], [w, 0.0], [w, y], [x, y], [x, d], [0.0, d]];
    upright("L", outline, size, vec![[0.0, 0.0, x, y], [x, 0.0, w, y], [0.0, y, x, d]])
}

/// A room over a U.
fn court(random: &mut Random, size: [f64; 3]) -> Plan {
    let [w, d, _] = size;
    let (a, b) = (random.between(0.25, 0.4) * w, random.between(0.6, 0.75) * w);
    let y = random.between(0.35, 0.7) * d;
    let outline = vec![[0.0, 0.0], [w, 0.0], [w, d], [b, d], [b, y], [a, y], [a, d], [0.0, d]];
    upright("U", outline, size, vec![[0.0, 0.0, w, y], [0.0, y, a, d], [b, y, w, d]])
}

/// A rectangle with a floor on two levels.
fn step(random: &mut Random, size: [f64; 3]) -> Plan {
    let [w, d, h] = size;
    let (x, s) = (random.between(0.3, 0.7) * w, random.between(0.05, 0.6));
    let polygon = |name: &str, corners: &[[f64; 3]]| {
        Surface::polygon(name, corners.iter().map(|x| DVec3::from_array(*x)).collect())
    };
    let profile = |y: f64| [[0.0, y, 0.0], [x, y, 0.0], [x, y, s], [w, y, s], [w, y, h], [0.0, y, h]];
    let reversed: Vec<[f64; 3]> = profile(0.0).into_iter().rev().collect();
    let surfaces = vec![
        polygon("floor", &[[0.0, 0.0, 0.0], [x, 0.0, 0.0], [x, d, 0.0], [0.0, d, 0.0]]),
        polygon("podium", &[[x, 0.0, s], [w, 0.0, s], [w, d, s], [x, d, s]]),
        polygon("riser", &[[x, 0.0, 0.0], [x, 0.0, s], [x, d, s], [x, d, 0.0]]),
        polygon("ceiling", &[[0.0, 0.0, h], [0.0, d, h], [w, d, h], [w, 0.0, h]]),
        polygon("wall 0", &reversed),
        polygon("wall 1", &[[w, 0.0, s], [w, 0.0, h], [w, d, h], [w, d, s]]),
        polygon("wall 2", &profile(d)),
        polygon("wall 3", &[[0.0, 0.0, 0.0], [0.0, d, 0.0], [0.0, d, h], [0.0, 0.0, h]]),
    ];
    let outline = vec![[0.0, 0.0], [w, 0.0], [w, d], [0.0, d]];
    let cells = vec![on_floor([0.0, 0.0, x, d]), Spot { cell: [x, 0.0, w, d], floor: s }];
    // The riser is a solid for sensors: they are kept off it by its outline.
    Plan { kind: "step", surfaces, outline, height: h, cells, size }
}

/// A rectangle under a gabled roof.
fn attic(random: &mut Random, size: [f64; 3]) -> Plan {
    let [w, d, _] = size;
    let (h, top) = (random.between(0.6, 1.6), random.between(2.2, 3.5));
    let ridge = random.between(0.3, 0.7) * d;
    let polygon = |name: &str, corners: &[[f64; 3]]| {
        Surface::polygon(name, corners.iter().map(|x| DVec3::from_array(*x)).collect())
    };
    let gable = |x: f64| [[x, 0.0, 0.0], [x, d, 0.0], [x, d, h], [x, ridge, top], [x, 0.0, h]];
    let reversed: Vec<[f64; 3]> = gable(w).into_iter().rev().collect();
    let surfaces = vec![
        polygon("floor", &[[0.0, 0.0, 0.0], [w, 0.0, 0.0], [w, d, 0.0], [0.0, d, 0.0]]),
        polygon("knee wall 0", &[[0.0, 0.0, 0.0], [0.0, 0.0, h], [w, 0.0, h], [w, 0.0, 0.0]]),
        polygon("knee wall 1", &[[0.0, d, 0.0], [w, d, 0.0], [w, d, h], [0.0, d, h]]),
        polygon("roof 0", &[[0.0, 0.0, h], [0.0, ridge, top], [w, ridge, top], [w, 0.0, h]]),
        polygon("roof 1", &[[0.0, ridge, top], [0.0, d, h], [w, d, h], [w, ridge, top]]),
        polygon("gable 0", &gable(0.0)),
        polygon("gable 1", &reversed),
    ];
    let outline = vec![[0.0, 0.0], [w, 0.0], [w, d], [0.0, d]];
    Plan {
        kind: "attic",
        surfaces,
        outline,
        height: h,
        cells: vec![on_floor([0.0, 0.0, w, d])],
        size: [w, d, h],
    }
}
