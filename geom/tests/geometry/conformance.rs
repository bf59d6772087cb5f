//! Promises of the trait `Surface`, checked on every shape.

use radiosity_geom::{Aabb, Bvh, DVec3, Hit, Jet, Ray, Rect, Surface};
use radiosity_test_support::gallery::{Exhibit, gallery};
use radiosity_test_support::random::Random;

/// A surface stripped to what a shape must give, so that the provided methods are what is tested.
#[derive(Debug)]
struct Bare<'a>(&'a dyn Surface);

impl Surface for Bare<'_> {
    fn jet(&self, u: f64, v: f64) -> Jet {
        self.0.jet(u, v)
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        self.0.bounds(rect)
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        self.0.intersect(ray)
    }
}

fn size(surface: &dyn Surface) -> f64 {
    surface.bounds(&Rect::FULL).diagonal()
}

/// Random parameters of a point of the surface, a little inside the domain.
fn somewhere(surface: &dyn Surface, random: &mut Random) -> [f64; 2] {
    loop {
        let at = [random.between(-0.999, 0.999), random.between(-0.999, 0.999)];
        let on = |region: &radiosity_geom::PlanarRegion| region.contains(surface.jet(at[0], at[1]).position);
        if surface.region().is_none_or(on) {
            return at;
        }
    }
}

fn each(test: impl Fn(&Exhibit, &mut Random)) {
    for (k, exhibit) in gallery().iter().enumerate() {
        test(exhibit, &mut Random(k as u64));
    }
}

#[test]
fn tangents_are_the_derivatives() {
    each(|Exhibit { name, surface, .. }, random| {
        for _ in 0..200 {
            let [u, v] = somewhere(&**surface, random).map(|w| 0.99 * w);
            let jet = surface.jet(u, v);
            let h = 1e-3;
            let at = |u, v| surface.jet(u, v).position;
            // Richardson's extrapolation of central differences: error h⁴.
            let difference =
                |d: &dyn Fn(f64) -> DVec3| (8.0 * (d(h) - d(-h)) - (d(2.0 * h) - d(-2.0 * h))) / (12.0 * h);
            let (du, dv) = (difference(&|h| at(u + h, v)), difference(&|h| at(u, v + h)));
            let tolerance = 1e-9 * size(&**surface);
            assert!(
                jet.du.distance(du) < tolerance && jet.dv.distance(dv) < tolerance,
                "{name} at {u}, {v}: {jet:?} {du} {dv}"
            );
        }
    });
}

#[test]
fn normals_are_unit_and_stand_on_the_tangents() {
    each(|Exhibit { name, surface, inside, .. }, random| {
        let sign = if name.starts_with("flipped") { -1.0 } else { 1.0 };
        for _ in 0..200 {
            let [u, v] = somewhere(&**surface, random);
            let jet = surface.jet(u, v);
            let cross = jet.du.cross(jet.dv);
            assert!((jet.normal.length() - 1.0).abs() < 1e-14, "{name}");
            assert!(
                (cross - sign * jet.area * jet.normal).length() < 1e-12 * cross.length(),
                "{name} at {u}, {v}"
            );
            assert!(
                inside.is_none_or(|p| (jet.position - p).dot(jet.normal) > 0.0),
                "{name} faces inward at {u}, {v}"
            );
        }
    });
}

#[test]
fn border_normals_are_limits() {
    each(|Exhibit { name, surface, .. }, _| {
        for k in 0..=20 {
            let w = f64::from(k) / 10.0 - 1.0;
            for (u, v) in [(-1.0, w), (1.0, w), (w, -1.0), (w, 1.0)] {
                let near = 1.0 - 1e-7;
                let (edge, inner) = (surface.jet(u, v), surface.jet(near * u, near * v));
                assert!((edge.normal.length() - 1.0).abs() < 1e-14, "{name} at {u}, {v}: {edge:?}");
                assert!(edge.normal.distance(inner.normal) < 1e-5, "{name} at {u}, {v}: {edge:?} {inner:?}");
            }
        }
    });
}

#[test]
fn areas_match_closed_forms_and_the_jets() {
    each(|Exhibit { name, surface, area, .. }, _| {
        if let Some(area) = area {
            let found = surface.area();
            assert!((found - area).abs() <= 1e-13 * area, "{name}: {found} instead of {area}");
        }
        if surface.region().is_none() {
            let (own, by_jets) = (surface.area(), Bare(&**surface).area());
            assert!((own - by_jets).abs() <= 1e-13 * own, "{name}: {own} but the jets say {by_jets}");
        }
    });
}

#[test]
fn boxes_hold_their_part_closely() {
    each(|Exhibit { name, surface, .. }, random| {
        for _ in 0..40 {
            let mut range = || {
                let (a, b) = (random.between(-1.0, 1.0), random.between(-1.0, 1.0));
                [a.min(b), a.max(b)]
            };
            let rect = Rect { u: range(), v: range() };
            let bounds = surface.bounds(&rect);
            let grid = (0..=40)
                .flat_map(|i| (0..=40).map(move |j| (f64::from(i) / 20.0 - 1.0, f64::from(j) / 20.0 - 1.0)));
            let points = grid.map(|(s, t)| rect.at(s, t)).map(|[u, v]| surface.jet(u, v).position);
            let points: Vec<DVec3> =
                points.filter(|x| surface.region().is_none_or(|r| r.contains(*x))).collect();
            let roomy = bounds.inflate(1e-14 * size(&**surface));
            assert!(points.iter().all(|x| roomy.contains(*x)), "{name}: {rect:?} leaves {bounds:?}");
            // Of a polygon only the part inside the outline fills its rectangle.
            let around = Aabb::around(points).diagonal();
            let wide = if name.starts_with("placed") { 1.5 } else { 1.25 };
            assert!(
                surface.region().is_some() || bounds.diagonal() <= wide * around + 1e-3,
                "{name}: {rect:?} {bounds:?} {around}"
            );
        }
    });
}

/// No plane through a face of the hull's box, nor any random one, has a point of the part beyond all hull
/// points.
#[test]
fn hulls_hold_their_part() {
    each(|Exhibit { name, surface, .. }, random| {
        let rect = Rect { u: [-0.7, 0.4], v: [-0.2, 0.9] };
        let hull = surface.hull(&rect);
        let points: Vec<DVec3> = (0..400)
            .map(|k| rect.at(f64::from(k % 20) / 9.5 - 1.0, f64::from(k / 20) / 9.5 - 1.0))
            .map(|[u, v]| surface.jet(u, v).position)
            .filter(|x| surface.region().is_none_or(|region| region.contains(*x)))
            .collect();
        for _ in 0..200 {
            let d = random.direction();
            let reach = |points: &[DVec3]| points.iter().map(|x| x.dot(d)).fold(f64::MIN, f64::max);
            assert!(reach(&points) <= reach(&hull) + 1e-12 * size(&**surface), "{name}");
        }
    });
}

#[test]
fn rays_through_a_point_of_the_surface_hit_it() {
    rays_through_points(10_000);
}

/// For the long run: `cargo test --release -p radiosity-geom -- --ignored million`.
#[test]
#[ignore = "takes minutes"]
fn a_million_rays_through_points_of_every_surface_hit_it() {
    rays_through_points(1_000_000);
}

fn rays_through_points(count: usize) {
    each(|Exhibit { name, surface, .. }, random| {
        let size = size(&**surface);
        for _ in 0..count {
            let [u, v] = somewhere(&**surface, random);
            let target = surface.jet(u, v);
            let direction = random.direction();
            if direction.dot(target.normal).abs() < 1e-3 {
                continue;
            }
            let away = random.between(0.0, 2.0 * size);
            let ray = Ray::new(target.position - away * direction, 3.0 * direction);
            let Some(hit) = surface.intersect(&ray) else {
                panic!("{name}: missed at {u}, {v} along {direction}")
            };
            // Rounding moves the hit along the surface: along the ray by more, the flatter it comes in.
            let late = 1e-13 * size.max(away) / direction.dot(target.normal).abs();
            assert!(hit.t <= (away + late) / 3.0, "{name}: {hit:?} beyond {u}, {v} along {direction}");
            assert!(surface.occludes(&ray), "{name}");
            let on = surface.jet(hit.u, hit.v).position.distance(ray.at(hit.t));
            assert!(on <= 1e-12 * size.max(away), "{name}: {on:e} off at {hit:?}");
            // Cut off just before the nearest hit, the ray is free; just behind, it is not.
            let grace = 1e-9 * size;
            assert!(
                hit.t < grace || !surface.occludes(&ray.until(hit.t - grace)),
                "{name}: {hit:?} was not the nearest"
            );
        }
    });
}

#[test]
fn inversion_returns_the_parameters() {
    each(|Exhibit { name, surface, .. }, random| {
        for surface in [&**surface, &Bare(&**surface)] {
            for _ in 0..100 {
                let [u, v] = somewhere(surface, random);
                let jet = surface.jet(u, v);
                let [a, b] =
                    surface.invert(jet.position).unwrap_or_else(|| panic!("{name}: lost at {u}, {v}"));
                let off = ((a - u) * jet.du).length() + ((b - v) * jet.dv).length();
                assert!(off <= 1e-9 * size(surface), "{name}: {a}, {b} instead of {u}, {v}");
                let foot = surface.project(jet.position);
                assert!(foot.distance <= 1e-12 * size(surface), "{name}: {foot:?} for {u}, {v}");
            }
        }
    });
}

#[test]
fn points_off_the_surface_are_not_inverted() {
    each(|Exhibit { name, surface, .. }, _| {
        let far = surface.bounds(&Rect::FULL).max + DVec3::ONE;
        assert!(surface.invert(far).is_none(), "{name}");
    });
}

/// A fine triangulation of a surface, for comparison only.
struct Mesh {
    triangles: Vec<[DVec3; 3]>,
    tree: Bvh,
    /// Largest distance between the surface and its triangles (length).
    error: f64,
}

const CELLS: i32 = 48;

fn tessellate(surface: &dyn Surface) -> Mesh {
    let step = 2.0 / f64::from(CELLS);
    let at = |i: f64, j: f64| surface.jet(i * step - 1.0, j * step - 1.0).position;
    let (mut triangles, mut error) = (Vec::new(), 0.0f64);
    for (i, j) in (0..CELLS).flat_map(|i| (0..CELLS).map(move |j| (f64::from(i), f64::from(j)))) {
        let [p, q, r, s] = [at(i, j), at(i + 1.0, j), at(i + 1.0, j + 1.0), at(i, j + 1.0)];
        triangles.extend([[p, q, r], [p, r, s]]);
        let sag =
            [(p + r, 0.5, 0.5), (p + q, 0.5, 0.0), (q + r, 1.0, 0.5), (r + s, 0.5, 1.0), (s + p, 0.0, 0.5)];
        let sag = sag.map(|(twice, a, b)| (0.5 * twice).distance(at(i + a, j + b)));
        error = sag.into_iter().fold(error, f64::max);
    }
    // Room for rounding: the boxes of level triangles are flat.
    let boxes: Vec<Aabb> = triangles.iter().map(|t: &[DVec3; 3]| Aabb::around(*t).inflate(error)).collect();
    Mesh { triangles, tree: Bvh::build(&boxes), error }
}

impl Mesh {
    /// All hits as (t, cosine of the angle with the triangle's normal).
    fn hits(&self, ray: &Ray) -> Vec<(f64, f64)> {
        let hit = |[p, q, r]: &[DVec3; 3]| {
            let (e, f) = (*q - *p, *r - *p);
            let normal = e.cross(f);
            let det = ray.direction.dot(normal);
            let from = ray.origin - *p;
            let turned = from.cross(ray.direction);
            let (a, b) = (-turned.dot(f) / det, turned.dot(e) / det);
            let t = -from.dot(normal) / det;
            let inside = a >= 0.0 && b >= 0.0 && a + b <= 1.0 && t >= 0.0;
            inside.then(|| (t, det.abs() / normal.length()))
        };
        let mut hits = Vec::new();
        self.tree.any(ray, |index| {
            hits.extend(hit(&self.triangles[index]));
            false
        });
        hits.sort_by(|a, b| a.0.total_cmp(&b.0));
        hits
    }
}

#[test]
fn random_rays_agree_with_a_fine_tessellation() {
    against_tessellation(10_000);
}

/// For the long run: `cargo test --release -p radiosity-geom -- --ignored tessellation`.
#[test]
#[ignore = "takes minutes"]
fn many_random_rays_agree_with_a_fine_tessellation() {
    against_tessellation(1_000_000);
}

/// A mesh hit that is not grazing has the surface within its error, and a surface hit well inside has the
/// mesh.
fn against_tessellation(count: usize) {
    each(|Exhibit { name, surface, .. }, random| {
        if surface.region().is_some() {
            return; // Flat: the tessellation would be the surface.
        }
        let mesh = tessellate(&**surface);
        let size = size(&**surface);
        let bounds = surface.bounds(&Rect::FULL);
        for _ in 0..count {
            let through = DVec3::new(
                random.between(bounds.min.x, bounds.max.x),
                random.between(bounds.min.y, bounds.max.y),
                random.between(bounds.min.z, bounds.max.z),
            );
            let direction = random.direction();
            let ray = Ray::new(through - 2.0 * size * direction, direction);
            let (hit, hits) = (surface.intersect(&ray), mesh.hits(&ray));
            let slack = |cosine: f64| 3.0 * mesh.error / cosine + 1e-9 * size;
            if let Some((t, cosine)) = hits.first()
                && *cosine > 0.3
            {
                let near = hit.is_some_and(|hit| hit.t <= t + slack(*cosine));
                assert!(
                    near || at_border(&**surface, ray.at(*t), mesh.error),
                    "{name}: mesh at {t}, surface {hit:?}"
                );
            }
            if let Some(hit) = hit {
                let cosine = surface.jet(hit.u, hit.v).normal.dot(direction).abs();
                let inner = hit.u.abs().max(hit.v.abs()) < 0.98;
                let near = hits.iter().any(|(t, _)| (t - hit.t).abs() <= slack(cosine));
                assert!(near || cosine < 0.3 || !inner, "{name}: surface at {hit:?}, mesh {hits:?}");
            }
        }
    });
}

/// Whether a point near the surface is so close to its border that a ray through it may pass by.
fn at_border(surface: &dyn Surface, x: DVec3, error: f64) -> bool {
    let foot = surface.project(x);
    let jet = surface.jet(foot.u, foot.v);
    let reach = 20.0 * error;
    (1.0 - foot.u.abs()) * jet.du.length() < reach || (1.0 - foot.v.abs()) * jet.dv.length() < reach
}
