//! Repairs 100 000 polygons of which one in a hundred has each fault, and prints how long that takes and what
//! was found.

use std::io::{self, Write};
use std::time::Instant;

use glam::DVec3;
use radiosity_formats::model::{Material, Model, Shape, Sides, Surface};
use radiosity_formats::repair::{Options, RepairKind, repair};

/// Boxes, of six faces each.
const BOXES: usize = 16_667;

/// Boxes along a hall.
const ALONG: usize = 128;

/// Boxes for each one that has a fault.
const RARE: usize = 100;

/// Faults that are made in turn.
const FAULTS: usize = 9;

fn main() -> io::Result<()> {
    let mut model = halls();
    let polygons = model.surfaces.len();
    let start = Instant::now();
    let repairs = repair(&mut model, &Options { fix_fronts: true, ..Options::default() });
    let seconds = start.elapsed().as_secs_f64();
    let mut out = io::stdout().lock();
    writeln!(out, "{polygons} polygons repaired in {seconds:.2} s; {} are left", model.surfaces.len())?;
    for kind in [
        RepairKind::Vertices,
        RepairKind::Sliver,
        RepairKind::Outline,
        RepairKind::Plane,
        RepairKind::Coincident,
        RepairKind::Overlap,
        RepairKind::Reflectance,
        RepairKind::Fronts,
    ] {
        writeln!(out, "{kind:?}: {}", repairs.count(kind))?;
    }
    Ok(())
}

/// Rows of boxes on a floor, some of them faulty.
fn halls() -> Model {
    let material = Material { name: "paint".into(), reflectance: vec![1.0], emission: vec![0.0] };
    let mut model = Model { bands: vec!["grey".into()], materials: vec![material], ..Model::default() };
    let side = 3.0 * ALONG as f64;
    let floor =
        [[0.0, 0.0], [side, 0.0], [side, side], [0.0, side]].map(|[x, y]| DVec3::new(x, y, 0.0) - DVec3::ONE);
    add(&mut model, floor.map(|x| DVec3::new(x.x, x.y, 0.0)).to_vec());
    for index in 0..BOXES {
        let low = DVec3::new(3.0 * (index % ALONG) as f64, 3.0 * (index / ALONG) as f64, 0.0);
        let mut faces = cuboid(low, 1.0 + (index % 7) as f64 * 0.1);
        for fault in (0..FAULTS).filter(|fault| (index + 11 * fault) % RARE == 0) {
            spoil(&mut faces, fault);
        }
        faces.into_iter().for_each(|face| add(&mut model, face));
    }
    model
}

fn add(model: &mut Model, outline: Vec<DVec3>) {
    model.surfaces.push(Surface {
        name: format!("polygon-{}", model.surfaces.len() + 1),
        material: Some(0),
        shape: Shape::Polygon { outline, holes: Vec::new() },
        sides: Sides::Open,
        place: None,
        file: None,
    });
}

/// The faces of a box, fronts outwards; the top comes second.
fn cuboid(low: DVec3, size: f64) -> Vec<Vec<DVec3>> {
    let [x, y, z] = [size * DVec3::X, size * DVec3::Y, size * DVec3::Z];
    let faces = [(low, y, x), (low + z, x, y), (low, x, z), (low + y, z, x), (low, z, y), (low + x, y, z)];
    faces.iter().map(|(at, a, b)| vec![*at, *at + *a, *at + *a + *b, *at + *b]).collect()
}

/// Makes one fault in the faces of a box.
fn spoil(faces: &mut Vec<Vec<DVec3>>, fault: usize) {
    let top = faces[1].clone();
    let [a, b, c, d] = [top[0], top[1], top[2], top[3]];
    let inner = |u: f64, v: f64| a + u * (b - a) + v * (d - a);
    match fault {
        0 => faces[1].insert(1, a),
        1 => faces[1].splice(1..1, [b + (b - a), b]).for_each(drop),
        2 => faces.push(vec![a, b, 0.5 * (a + b)]),
        3 => {
            faces[1] = vec![a, b, c, d, a, inner(0.2, 0.2), inner(0.2, 0.6), inner(0.6, 0.2), inner(0.2, 0.2)]
        }
        4 => faces[1] = vec![a, c, b, d],
        5 => faces[1][2] += 0.01 * DVec3::Z,
        6 => faces.push(vec![c, d, a, b]),
        7 => faces.iter_mut().for_each(|face| face.reverse()),
        _ => faces.push([inner(0.5, 0.2), inner(1.5, 0.2), inner(1.5, 0.7), inner(0.5, 0.7)].to_vec()),
    }
}
