//! Time of a ray on surfaces as they are, compared with the same scene cut into triangles.
//!
//! Two scenes: 10⁴ mixed surfaces in random places, and the teapot. Three ways: this crate's hierarchy over
//! the surfaces; the hierarchy of obvhs (wide, single precision, boxes padded) over the same surfaces, with
//! the same double precision test in its leaves; and obvhs over triangles, tested in double precision.
//! Nearest hit and any hit, incoherent segments.

#![expect(clippy::print_stdout, reason = "the table of ratios is a result")]

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec3, Vec3A};
use obvhs::{BvhBuildParams, cwbvh::CwBvh, cwbvh::builder::build_cwbvh, ray::RayHit};
use radiosity_geom::shapes::{
    Bezier, Bilinear, Cone, Cylinder, Disk, Extrusion, FULL_TURN, Revolution, Sphere, Torus,
};
use radiosity_geom::{Aabb, Bvh, Hit, Motion, Placed, Ray, RayTree, Rect, Surface};
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use radiosity_test_support::random::Random;
use radiosity_test_support::triangle::hit_triangle;

/// Rays per scene.
const RAYS: usize = 20_000;

struct Scene {
    surfaces: Vec<Arc<dyn Surface>>,
    rays: Vec<Ray>,
    /// Cells along each parameter when cut into triangles.
    cells: i32,
}

fn mixed(random: &mut Random) -> Scene {
    let surfaces = (0..10_000).map(|k| {
        let (axis, angle) = (random.direction(), random.between(-3.0, 3.0));
        let motion =
            Motion::new(random.vector(-1.0, 1.0), axis, angle, random.between(0.02, 0.06)).expect("a motion");
        Arc::new(Placed::new(shape(k), motion)) as Arc<dyn Surface>
    });
    let surfaces = surfaces.collect();
    let rays = (0..RAYS).map(|_| Ray::segment(random.vector(-1.0, 1.0), random.vector(-1.0, 1.0))).collect();
    Scene { surfaces, rays, cells: 8 }
}

fn shape(k: usize) -> Box<dyn Surface> {
    let (o, x, y, z) = (DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z);
    let curve = [x, 1.5 * x + 0.5 * z, 0.3 * x + z, 0.6 * x + 1.5 * z];
    let sheet = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            DVec3::new(i as f64 - 1.5, j as f64 - 1.5, ((i * i + 2 * j) % 3) as f64 * 0.5)
        })
    });
    match k % 9 {
        0 => Box::new(Sphere::new(o, 1.0, z, [-1.0, 1.0], FULL_TURN).expect("a shape")),
        1 => Box::new(Cylinder::new(o, z, 1.0, [0.0, 4.0]).expect("a shape")),
        2 => Box::new(Cone::new(o, 2.0 * z, 1.0, 0.0, FULL_TURN).expect("a shape")),
        3 => Box::new(Disk::new(o, z, 1.0, 0.3, FULL_TURN).expect("a shape")),
        4 => Box::new(Torus::new(o, z, 1.0, 0.4, FULL_TURN, FULL_TURN).expect("a shape")),
        5 => Box::new(Bilinear::new([o, x, x + y + z, y]).expect("a shape")),
        6 => Box::new(Bezier::new(sheet).expect("a shape")),
        7 => Box::new(Extrusion::new(curve, y).expect("a shape")),
        _ => Box::new(Revolution::new(curve, o, z, FULL_TURN).expect("a shape")),
    }
}

/// The patches of the teapot.
fn patches() -> Vec<Arc<dyn Surface>> {
    let data: serde_json::Value =
        serde_json::from_str(include_str!("../../geom/tests/data/teapot.json")).expect("the table");
    let number = |k: usize, axis: usize| data["vertices"][k][axis].as_f64().expect("a number");
    let point = |k: usize| DVec3::new(number(k, 0), number(k, 1), number(k, 2));
    let index = |p: usize, k: usize| data["patches"][p][k].as_u64().expect("an index") as usize;
    let net = |p: usize| std::array::from_fn(|i| std::array::from_fn(|j| point(index(p, 4 * i + j))));
    (0..32).map(|p| Arc::new(Bezier::new(net(p)).expect("a patch")) as Arc<dyn Surface>).collect()
}

fn teapot(random: &mut Random) -> Scene {
    let surfaces = patches();
    let rays = (0..RAYS)
        .map(|_| Ray::segment(5.0 * random.direction(), random.vector(-2.0, 2.0) + DVec3::Z))
        .collect();
    Scene { surfaces, rays, cells: 32 }
}

/// The triangles of a regular cut in the parameters.
fn triangles(scene: &Scene) -> Vec<[DVec3; 3]> {
    let step = 2.0 / f64::from(scene.cells);
    let mut all = Vec::new();
    for surface in &scene.surfaces {
        let at = |i: i32, j: i32| surface.jet(f64::from(i) * step - 1.0, f64::from(j) * step - 1.0).position;
        for (i, j) in (0..scene.cells).flat_map(|i| (0..scene.cells).map(move |j| (i, j))) {
            let [p, q, r, s] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            all.extend([[p, q, r], [p, r, s]]);
        }
    }
    all
}

/// The hierarchy of obvhs over padded boxes; tests are looked up by its own order.
struct Wide(CwBvh);

impl Wide {
    fn build(boxes: &[Aabb]) -> Wide {
        let single = |x: DVec3| Vec3A::new(x.x as f32, x.y as f32, x.z as f32);
        let padded: Vec<obvhs::aabb::Aabb> = boxes
            .iter()
            .map(|b| {
                obvhs::aabb::Aabb::new(single(b.min) - Vec3A::splat(1e-6), single(b.max) + Vec3A::splat(1e-6))
            })
            .collect();
        Wide(build_cwbvh(&padded, BvhBuildParams::medium_build(), &mut Duration::default()))
    }

    fn ray(ray: &Ray) -> obvhs::ray::Ray {
        let single = |x: DVec3| Vec3A::new(x.x as f32, x.y as f32, x.z as f32);
        obvhs::ray::Ray::new(single(ray.origin), single(ray.direction), 0.0, 1.000_001)
    }

    fn nearest(&self, ray: &Ray, test: impl Fn(usize) -> Option<f64>) -> Option<f64> {
        let mut best: Option<f64> = None;
        let mut hit = RayHit::none();
        self.0.ray_traverse(Wide::ray(ray), &mut hit, |_, id| {
            let t = test(self.0.primitive_indices[id] as usize);
            if t.is_some_and(|t| best.is_none_or(|b| t < b)) {
                best = t;
            }
            t.map_or(f32::INFINITY, |t| t as f32)
        });
        best
    }

    fn any(&self, ray: &Ray, test: impl Fn(usize) -> bool) -> bool {
        !self.0.ray_traverse_miss(Wide::ray(ray), |_, id| {
            if test(self.0.primitive_indices[id] as usize) { 0.0 } else { f32::INFINITY }
        })
    }
}

/// A named way to answer whether a ray hits.
type Way<'a> = (&'static str, Box<dyn Fn(&Ray) -> bool + 'a>);

fn compare(c: &mut Criterion, name: &str, scene: &Scene) {
    let boxes: Vec<Aabb> = scene.surfaces.iter().map(|s| s.bounds(&Rect::FULL)).collect();
    let (own, wide) = (Bvh::build(&boxes), Wide::build(&boxes));
    let tree = RayTree::new(scene.surfaces.clone());
    let triangles = triangles(scene);
    let corners: Vec<Aabb> = triangles.iter().map(|t| Aabb::around(*t)).collect();
    let cut = Wide::build(&corners);
    let hit = |k: usize, ray: &Ray| -> Option<Hit> { scene.surfaces[k].intersect(ray) };
    let shadow = |k: usize, ray: &Ray| scene.surfaces[k].occludes(ray);
    let cut_hit = |k: usize, ray: &Ray| hit_triangle(&triangles[k], ray);
    let ways: [Way; 6] = [
        ("nearest, triangles, obvhs", Box::new(|r| cut.nearest(r, |k| cut_hit(k, r)).is_some())),
        ("nearest, surfaces, own", Box::new(|r| tree.nearest(r).is_some())),
        ("nearest, surfaces, obvhs", Box::new(|r| wide.nearest(r, |k| hit(k, r).map(|h| h.t)).is_some())),
        ("any, triangles, obvhs", Box::new(|r| cut.any(r, |k| cut_hit(k, r).is_some()))),
        ("any, surfaces, own", Box::new(|r| own.any(r, |k| shadow(k, r)))),
        ("any, surfaces, obvhs", Box::new(|r| wide.any(r, |k| shadow(k, r)))),
    ];
    let mut group = c.benchmark_group(format!("{name}, {} triangles", triangles.len()));
    group
        .throughput(Throughput::Elements(RAYS as u64))
        .sample_size(10)
        .measurement_time(Duration::from_secs(2));
    for (name, way) in &ways {
        group.bench_function(*name, |b| b.iter(|| count(&scene.rays, way)));
    }
    ratios(&scene.rays, &ways);
}

fn count(rays: &[Ray], way: &dyn Fn(&Ray) -> bool) -> usize {
    black_box(rays).iter().filter(|ray| way(ray)).count()
}

/// The fastest of 15 rounds of each way, the ways taking turns, against noise.
fn ratios(rays: &[Ray], ways: &[Way]) {
    let mut best = vec![f64::INFINITY; ways.len()];
    for _ in 0..15 {
        for ((_, way), best) in ways.iter().zip(&mut best) {
            let start = Instant::now();
            count(rays, way);
            *best = best.min(start.elapsed().as_secs_f64());
        }
    }
    for (k, (name, way)) in ways.iter().enumerate() {
        let (rate, ratio) = (rays.len() as f64 / best[k] / 1e6, best[k / 3 * 3] / best[k]);
        println!("{name}: {rate:.3} Mray/s, {ratio:.2} of the triangles' rate, {} hits", count(rays, way));
    }
}

/// A ray, by the numbers of the two patches that it joins.
type Joint = (usize, usize, Ray);

/// Segments between facing points of the teapot, half of them on one patch, as for shadows on curved
/// surfaces.
fn joints(surfaces: &[Arc<dyn Surface>], random: &mut Random) -> Vec<Joint> {
    let mut joints = Vec::new();
    while joints.len() < RAYS {
        let mut patch = || (random.between(0.0, 32.0) as usize).min(31);
        let (a, b) = (patch(), patch());
        let b = if joints.len() % 2 == 0 { a } else { b };
        let [x, y] = [a, b].map(|k| surfaces[k].jet(random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
        let d = y.position - x.position;
        if d.dot(x.normal) > 0.0 && d.dot(y.normal) < 0.0 {
            joints.push((a, b, Ray { range: [1e-6, 1.0 - 1e-6], ..Ray::segment(x.position, y.position) }));
        }
    }
    joints
}

/// Whether patches hide their own points from each other, and what a third patch hides.
fn own_shadows(c: &mut Criterion, random: &mut Random) {
    let surfaces = patches();
    let joints = joints(&surfaces, random);
    let own = |(a, b, ray): &Joint| surfaces[*a].occludes(ray) || a != b && surfaces[*b].occludes(ray);
    let third = |(a, b, ray): &Joint| {
        let others = (0..32).filter(|k| k != a && k != b);
        others.filter(|k| surfaces[*k].occludes(ray)).count() > 0
    };
    let mut group = c.benchmark_group("points of the teapot");
    group
        .throughput(Throughput::Elements(RAYS as u64))
        .sample_size(10)
        .measurement_time(Duration::from_secs(2));
    let hidden = |way: &dyn Fn(&Joint) -> bool| black_box(&joints).iter().filter(|joint| way(joint)).count();
    group.bench_function("own patches", |b| b.iter(|| hidden(&own)));
    group.bench_function("the 30 others", |b| b.iter(|| hidden(&third)));
    println!("hidden by own patches: {}, by others: {}", hidden(&own), hidden(&third));
}

fn rays(c: &mut Criterion) {
    let mut random = Random(1);
    own_shadows(c, &mut random);
    compare(c, "teapot", &teapot(&mut random));
    compare(c, "10000 mixed surfaces", &mixed(&mut random));
}

criterion_group!(benches, rays);
criterion_main!(benches);
