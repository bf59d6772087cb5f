//! A surface of a shape of one's own: where it is, what a box around it is, and where a ray meets it. The
//! rest is provided.
//!
//! ```text
//! cargo run --release --example shape
//! ```

#![expect(clippy::print_stdout, reason = "two numbers for people")]

use std::error::Error;

use radiosity::geom::{Aabb, DVec3, Hit, Jet, Ray, Rect, Surface, shapes::Disk, shapes::FULL_TURN};
use radiosity::{Material, Options, SceneBuilder, Work, solve};

/// The saddle z = x y over the square |x|, |y| ≤ 1, with the parameters u = x and v = y.
#[derive(Debug)]
struct Saddle;

impl Surface for Saddle {
    fn jet(&self, u: f64, v: f64) -> Jet {
        let (du, dv) = (DVec3::new(1.0, 0.0, v), DVec3::new(0.0, 1.0, u));
        let across = du.cross(dv);
        let (normal, area) = (across.normalize(), across.length());
        Jet { position: DVec3::new(u, v, u * v), du, dv, normal, area }
    }

    fn bounds(&self, rect: &Rect) -> Aabb {
        // It is bilinear, so that it lies between its corners.
        Aabb::around(rect.u.into_iter().flat_map(|u| rect.v.map(|v| DVec3::new(u, v, u * v))))
    }

    fn intersect(&self, ray: &Ray) -> Option<Hit> {
        // z = x y along o + t d: a t² + b t + c = 0.
        let (o, d) = (ray.origin, ray.direction);
        let (a, b, c) = (d.x * d.y, o.x * d.y + o.y * d.x - d.z, o.x * o.y - o.z);
        let q = -0.5 * (b + b.signum() * (b * b - 4.0 * a * c).sqrt());
        let hit = |t: f64| {
            let [u, v] = [ray.at(t).x, ray.at(t).y];
            let is_on = u.abs() <= 1.0 + Hit::SEAM && v.abs() <= 1.0 + Hit::SEAM && ray.reaches(t);
            is_on.then(|| Hit { t, u: u.clamp(-1.0, 1.0), v: v.clamp(-1.0, 1.0) })
        };
        [q / a, c / q].into_iter().filter_map(hit).min_by(|one, other| one.t.total_cmp(&other.t))
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut scene = SceneBuilder::new("saddle", ["grey"]);
    let white = scene.material("white", Material::new(vec![0.8], vec![0.0])?);
    let glow = scene.material("glow", Material::new(vec![0.0], vec![1000.0])?);
    scene.surface("saddle", Saddle, &white);
    scene.surface("lamp", Disk::new(2.0 * DVec3::Z, -DVec3::Z, 0.5, 0.0, FULL_TURN)?, &glow);
    let scene = scene.build()?;
    let outcome = solve(&scene, &Options::default(), &Work::alone())?;
    let saddle = scene.surface_named("saddle")?;
    println!("area: {:.6}", scene.surfaces[saddle].shape.area());
    println!("irradiance: {:.2} W/m² on average", outcome.solution.mean_irradiance(0, saddle));
    Ok(())
}
