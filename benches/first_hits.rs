//! Rays per second, on one core, that find the first surface they meet.
//!
//! `cargo bench -q -p radiosity-benches --bench first_hits`. Rays start at points of the surfaces, evenly by
//! area, and leave by the cosine law: in random order, or a thousand from one surface after another. A hall is
//! made here: turned boxes of random sides in the cells of a grid. The rooms are read from `../shared`, a
//! folder that does not come with the sources; without it they are left out. Beside [`RayTree`]: the hierarchy
//! of obvhs, the fastest crate for single rays known to us (eight wide, quantised boxes in single precision),
//! over the surfaces, with their own tests in its leaves, and over triangles that flat surfaces are cut into,
//! tested in double precision. A rate is that of the fastest of some rounds, in which the ways take turns.

#![expect(clippy::print_stdout, reason = "a table for people")]

use std::hint::black_box;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use glam::{DVec3, Vec3A};
use obvhs::cwbvh::{CwBvh, builder::build_cwbvh};
use obvhs::{BvhBuildParams, ray::RayHit};
use radiosity_geom::{Aabb, Hit, Ray, RayTree, Rect, Surface};

use radiosity_test_support::random::Random;
use radiosity_test_support::shapes::plate;
use radiosity_test_support::triangle::hit_triangle;

const RAYS: usize = 200_000;
const ROUNDS: usize = 9;
/// Rays from one surface after another.
const RUN: usize = 1000;
/// Boxes along the edges of the hall, one a metre.
const HALL: [usize; 3] = [40, 32, 8];
/// A ray meets the curved surface that it starts on no sooner, as a part of its size.
const LEAVING: f64 = 1e-6;

type Shape = Arc<dyn Surface>;

/// A ray that starts on a surface.
struct Start {
    own: usize,
    origin: DVec3,
    direction: DVec3,
}

fn main() {
    println!(
        "| scene | surfaces | rays | RayTree, M hits/s | built in, ms | obvhs, surfaces | obvhs, triangles |"
    );
    println!("| --- | --- | --- | ---: | ---: | ---: | ---: |");
    compare("hall", &hall());
    for name in ["classroom", "soda"] {
        let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../shared/scenes/mgf");
        let path = folder.join(name).with_extension("json");
        if !path.exists() {
            println!("| {name} | not there: {} | | | | | |", path.display());
            continue;
        }
        let scene = radiosity::load(&path.to_string_lossy()).expect("the scene can be read");
        compare(name, &scene.surfaces.iter().map(|surface| Arc::clone(&surface.shape)).collect::<Vec<_>>());
    }
}

/// The rows of a scene.
fn compare(name: &str, surfaces: &[Shape]) {
    let start = Instant::now();
    let tree = RayTree::new(surfaces.to_vec());
    let built = 1e3 * start.elapsed().as_secs_f64();
    let (whole, cut) = (Wide::new(surfaces.iter().enumerate().map(Part::whole)), Wide::new(parts(surfaces)));
    for (order, run) in [("random order", 1), ("by surface", RUN)] {
        let starts = starts(surfaces, run);
        let ways: [&dyn Fn(&Start) -> bool; 3] = [
            &|start| tree.nearest_from(start.own, start.origin, start.direction).is_some(),
            &|start| whole.nearest(surfaces, start).is_some(),
            &|start| cut.nearest(surfaces, start).is_some(),
        ];
        let rates = rates(&starts, &ways);
        let others: Vec<String> =
            rates[1..].iter().map(|rate| format!("{rate:.2} ({:.2})", rate / rates[0])).collect();
        println!(
            "| {name} | {} | {order} | {:.2} | {built:.1} | {} |",
            surfaces.len(),
            rates[0],
            others.join(" | ")
        );
    }
}

/// Millions of rays a second of each way.
fn rates(starts: &[Start], ways: &[&dyn Fn(&Start) -> bool]) -> Vec<f64> {
    let mut best = vec![f64::INFINITY; ways.len()];
    for _ in 0..ROUNDS {
        for (way, best) in ways.iter().zip(&mut best) {
            let begin = Instant::now();
            black_box(black_box(starts).iter().filter(|start| way(start)).count());
            *best = best.min(begin.elapsed().as_secs_f64());
        }
    }
    best.iter().map(|seconds| starts.len() as f64 / seconds / 1e6).collect()
}

impl Start {
    fn ray(&self) -> Ray {
        Ray::new(self.origin, self.direction)
    }

    /// The hit with a surface, which is not the place where the ray starts.
    fn hit(&self, surfaces: &[Shape], k: usize, ray: &Ray) -> Option<Hit> {
        let surface = &surfaces[k];
        if k != self.own {
            return surface.intersect(ray);
        }
        let leaving = |surface: &Shape| LEAVING * surface.bounds(&Rect::FULL).diagonal();
        let curved = Some(surface).filter(|surface| surface.region().is_none())?;
        curved.intersect(&Ray { range: [leaving(curved), ray.range[1]], ..*ray })
    }
}

/// A room with a box, turned and of random sides, in each cell of a grid.
fn hall() -> Vec<Shape> {
    let size = DVec3::from_array(HALL.map(|count| count as f64));
    let axes = [DVec3::X, DVec3::Y, DVec3::Z];
    let mut faces = faces(0.5 * size, axes.map(|axis| -size.dot(axis) * axis));
    let mut random = Random(1);
    for k in 0..HALL.iter().product() {
        let at = [k % HALL[0], k / HALL[0] % HALL[1], k / HALL[0] / HALL[1]].map(|place| place as f64 + 0.5);
        let (sin, cos) = random.between(0.0, 1.5).sin_cos();
        let turned = [DVec3::new(cos, sin, 0.0), DVec3::new(-sin, cos, 0.0), DVec3::Z];
        faces.extend(self::faces(DVec3::from_array(at), turned.map(|axis| random.between(0.2, 0.6) * axis)));
    }
    faces
}

/// The faces of a box, fronts outside, or inside where the edges are left-handed.
fn faces(center: DVec3, edges: [DVec3; 3]) -> Vec<Shape> {
    let corner = center - 0.5 * edges.iter().sum::<DVec3>();
    let face = |origin, a, b| -> Shape { Arc::new(plate(origin, a, b)) };
    let pair = |k: usize| {
        let [across, a, b] = [0, 1, 2].map(|step| edges[(k + step) % 3]);
        [face(corner, b, a), face(corner + across, a, b)]
    };
    (0..3).flat_map(pair).collect()
}

/// Rays from the surfaces, `run` of each that is drawn.
fn starts(surfaces: &[Shape], run: usize) -> Vec<Start> {
    let mut random = Random(7);
    let sums: Vec<f64> = surfaces
        .iter()
        .scan(0.0, |sum, surface| {
            *sum += surface.area();
            Some(*sum)
        })
        .collect();
    let mut starts = Vec::with_capacity(RAYS);
    while starts.len() < RAYS {
        let place = random.between(0.0, sums[sums.len() - 1]);
        let own = sums.partition_point(|sum| *sum < place).min(sums.len() - 1);
        let densest = densest(&surfaces[own]);
        starts.extend((0..run).map(|_| leave(surfaces, own, densest, &mut random)));
    }
    starts
}

/// The largest area element, about.
fn densest(surface: &Shape) -> f64 {
    let at = |k: usize| k as f64 / 3.5 - 1.0;
    1.05 * (0..64).map(|k| surface.jet(at(k % 8), at(k / 8)).area).fold(0.0, f64::max)
}

/// A ray from a surface by the cosine law: the unit normal and a point of the unit sphere, added.
fn leave(surfaces: &[Shape], own: usize, densest: f64, random: &mut Random) -> Start {
    loop {
        let jet = surfaces[own].jet(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        let is_there = match surfaces[own].region() {
            Some(region) => region.contains(jet.position),
            None => random.between(0.0, densest) <= jet.area,
        };
        if is_there {
            let direction = (jet.normal + (1.0 - 1e-6) * random.direction()).normalize();
            return Start { own, origin: jet.position, direction };
        }
    }
}

/// A leaf of the hierarchy of obvhs: a surface, or a triangle of one.
struct Part {
    surface: usize,
    bounds: Aabb,
    corners: Option<[DVec3; 3]>,
}

impl Part {
    fn whole((surface, shape): (usize, &Shape)) -> Part {
        Part { surface, bounds: shape.bounds(&Rect::FULL), corners: None }
    }

    fn hit(&self, surfaces: &[Shape], start: &Start, ray: &Ray) -> Option<f64> {
        match &self.corners {
            Some(corners) => (self.surface != start.own).then(|| hit_triangle(corners, ray)).flatten(),
            None => start.hit(surfaces, self.surface, ray).map(|hit| hit.t),
        }
    }
}

/// Triangles of the flat surfaces; the curved ones whole.
fn parts(surfaces: &[Shape]) -> impl Iterator<Item = Part> + '_ {
    surfaces.iter().enumerate().flat_map(|(surface, shape)| {
        let Some(region) = shape.region() else { return vec![Part::whole((surface, shape))] };
        let fans = region
            .convex_pieces()
            .iter()
            .flat_map(|piece| piece[1..].windows(2).map(|side| [piece[0], side[0], side[1]]));
        fans.map(|corners| Part { surface, bounds: Aabb::around(corners), corners: Some(corners) }).collect()
    })
}

/// The hierarchy of obvhs over padded boxes.
struct Wide {
    parts: Vec<Part>,
    tree: CwBvh,
}

impl Wide {
    fn new(parts: impl Iterator<Item = Part>) -> Wide {
        let parts: Vec<Part> = parts.collect();
        let room = Vec3A::splat(1e-5);
        let boxes: Vec<obvhs::aabb::Aabb> = parts
            .iter()
            .map(|part| {
                obvhs::aabb::Aabb::new(single(part.bounds.min) - room, single(part.bounds.max) + room)
            })
            .collect();
        let tree = build_cwbvh(&boxes, BvhBuildParams::medium_build(), &mut Duration::default());
        Wide { parts, tree }
    }

    fn nearest(&self, surfaces: &[Shape], start: &Start) -> Option<f64> {
        let mut ray = start.ray();
        let mut found = RayHit::none();
        let wide = obvhs::ray::Ray::new(single(ray.origin), single(ray.direction), 0.0, f32::INFINITY);
        self.tree.ray_traverse(wide, &mut found, |_, id| {
            let part = &self.parts[self.tree.primitive_indices[id] as usize];
            let Some(t) = part.hit(surfaces, start, &ray) else { return f32::INFINITY };
            ray = ray.until(t);
            t as f32
        });
        (ray.range[1] < f64::INFINITY).then_some(ray.range[1])
    }
}

fn single(x: DVec3) -> Vec3A {
    Vec3A::new(x.x as f32, x.y as f32, x.z as f32)
}
