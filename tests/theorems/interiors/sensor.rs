//! Where light is read: on surfaces, often beside an edge, and in the air.

use std::f64::consts::TAU;

use radiosity::reading::probe::Probe;
use radiosity_geom::DVec3;

use crate::interiors::interior::{Interior, contains};
use crate::interiors::surface::{Shape, Surface};
use radiosity_test_support::random::Random;

/// Distance before a surface (metres) at which a point must be free for a sensor to stand there, below all
/// distances from edges.
const BEFORE: f64 = 1e-9;

/// Sensors of an interior, those on surfaces no nearer to their edges than `least` metres.
pub(crate) fn sensors(random: &mut Random, interior: &Interior, count: usize, least: f64) -> Vec<Probe> {
    let mut found = Vec::new();
    for _ in 0..100 * count {
        if found.len() == count {
            break;
        }
        let surfaces = &interior.surfaces;
        let surface = random.between(0.0, surfaces.len() as f64) as usize;
        let sensor = match random.pick(&[0, 1, 1, 1]) {
            0 => in_air(random, interior),
            _ => on_surface(random, &surfaces[surface], least).filter(|probe| is_open(interior, probe)),
        };
        found.extend(sensor);
    }
    found
}

/// Whether air lies before a sensor on a surface.
fn is_open(interior: &Interior, probe: &Probe) -> bool {
    let before = probe.position + BEFORE * probe.normal;
    before.z > 0.0 && !interior.is_solid(before)
}

fn in_air(random: &mut Random, interior: &Interior) -> Option<Probe> {
    let position = DVec3::from_array(interior.plan.size.map(|side| random.between(0.0, side)));
    let probe = Probe { position, normal: direction(random) };
    interior.is_air(position).then_some(probe)
}

fn direction(random: &mut Random) -> DVec3 {
    let (z, turn) = (random.between(-1.0, 1.0), random.between(0.0, TAU));
    let across = (1.0 - z * z).sqrt();
    DVec3::new(across * turn.cos(), across * turn.sin(), z)
}

fn on_surface(random: &mut Random, surface: &Surface, least: f64) -> Option<Probe> {
    match &surface.shape {
        Shape::Polygon(corners) => on_polygon(random, corners, least),
        Shape::Sphere { center, radius } => {
            let normal = direction(random);
            Some(Probe { position: center + radius * normal, normal })
        }
        Shape::Pipe { base, axis, radius } => {
            let (u, v) = axis.normalize().any_orthonormal_pair();
            let turn = random.between(0.0, TAU);
            let normal = turn.cos() * u + turn.sin() * v;
            let away = distance(random, 0.5 * axis.length(), least) / axis.length();
            let along = random.pick(&[away, 1.0 - away]);
            Some(Probe { position: base + along * axis + radius * normal, normal })
        }
        Shape::Disk { center, normal, radius } => {
            let (u, v) = normal.any_orthonormal_pair();
            let turn = random.between(0.0, TAU);
            let out = radius - distance(random, *radius, least);
            Some(Probe { position: center + out * (turn.cos() * u + turn.sin() * v), normal: *normal })
        }
    }
}

/// A distance from an edge: anywhere, or very small.
fn distance(random: &mut Random, most: f64, least: f64) -> f64 {
    let tiny = random.power(least.log10(), -1.0).clamp(least, 0.99 * most);
    let anywhere = random.between(0.05, 0.95) * most;
    random.pick(&[anywhere, tiny])
}

fn on_polygon(random: &mut Random, corners: &[DVec3], least: f64) -> Option<Probe> {
    let count = corners.len();
    let normal = (0..count).map(|k| corners[k].cross(corners[(k + 1) % count])).sum::<DVec3>().normalize();
    let k = random.between(0.0, count as f64) as usize;
    let (a, b) = (corners[k], corners[(k + 1) % count]);
    let edge = b - a;
    let along = distance(random, 0.5 * edge.length(), least) / edge.length();
    let along = random.pick(&[along, 1.0 - along]);
    let extent = corners.iter().map(|x| x.distance(a)).fold(0.0, f64::max);
    let inward = normal.cross(edge).normalize();
    let position = a + along * edge + distance(random, 0.5 * extent, least) * inward;
    let (u, v) = normal.any_orthonormal_pair();
    let flat = |x: &DVec3| [x.dot(u), x.dot(v)];
    let outline: Vec<[f64; 2]> = corners.iter().map(flat).collect();
    contains(&outline, flat(&position)).then_some(Probe { position, normal })
}
