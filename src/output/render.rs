//! Pictures of a solution: camera rays against the true surfaces, radiosity read off where they arrive.
//!
//! The camera is a pinhole. Each pixel averages the radiosity at `samples × samples` points of a regular
//! grid; a ray that meets the back of a surface, or nothing, is black. Bands become colours thus: three
//! bands are red, green and blue; any other number is averaged to grey. Three bands that all emit are
//! white-balanced on the light that the scene emits, as a camera would do: the lamps' own colour is taken away.

use radiosity_geom::{DVec3, Ray};
use rayon::prelude::*;

use super::image::Image;
pub use super::reader::Read;
use super::reader::{Light, Reader};
use crate::scene::Camera;
use crate::solution::{Place, Solution};
use crate::visibility::Visibility;

/// Accuracy of gathered light in pictures, relative: finer than eight bits of colour show.
const GATHERED: f64 = 3e-3;

/// Renders `solution` through `camera`; `progress` hears (rows done, rows in all), from any thread.
///
/// The pixels hold radiosity, W m⁻² (radiance times π).
pub fn render(
    solution: &Solution,
    visibility: &Visibility,
    camera: &Camera,
    samples: u32,
    read: Read,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Image {
    let view = View::new(camera);
    let balance = white_balance(solution);
    let eye = Eye { reader: Reader::new(solution, visibility, read, GATHERED) };
    let done = std::sync::atomic::AtomicUsize::new(0);
    let rows: Vec<Vec<[f64; 3]>> = (0..camera.height)
        .into_par_iter()
        .map(|row| {
            let pixel = |column| pixel(&eye, &view, [column, row], samples, balance);
            let pixels = (0..camera.width).map(pixel).collect();
            progress(done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1, camera.height as usize);
            pixels
        })
        .collect();
    Image::new(camera.width, camera.height, rows.concat())
}

/// A camera ready to cast rays.
struct View {
    eye: DVec3,
    /// Direction through the left upper corner of the picture.
    corner: DVec3,
    /// Steps by one pixel to the right and down.
    right: DVec3,
    down: DVec3,
}

impl View {
    fn new(camera: &Camera) -> Self {
        let forward = (camera.target - camera.eye).normalize();
        let right = forward.cross(camera.up).normalize();
        let down = forward.cross(right);
        let half_height = f64::tan(0.5 * camera.fov.to_radians());
        let pixel = 2.0 * half_height / f64::from(camera.height);
        let half_width = 0.5 * pixel * f64::from(camera.width);
        Self {
            eye: camera.eye,
            corner: forward - right * half_width - down * half_height,
            right: right * pixel,
            down: down * pixel,
        }
    }

    fn ray(&self, x: f64, y: f64) -> Ray {
        let direction = self.corner + self.right * x + self.down * y;
        Ray { origin: self.eye, direction, range: [0.0, f64::INFINITY] }
    }
}

fn pixel(eye: &Eye, view: &View, [column, row]: [u32; 2], samples: u32, balance: [f64; 3]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for index in 0..samples * samples {
        let offset = |k: u32| (f64::from(k) + 0.5) / f64::from(samples);
        let x = f64::from(column) + offset(index % samples);
        let y = f64::from(row) + offset(index / samples);
        let colour = eye.colour(&view.ray(x, y));
        sum.iter_mut().zip(colour).for_each(|(sum, value)| *sum += value);
    }
    let scale = 1.0 / f64::from(samples * samples);
    std::array::from_fn(|k| sum[k] * scale * balance[k])
}

/// What a camera ray needs to become a colour.
struct Eye<'a> {
    reader: Reader<'a>,
}

impl Eye<'_> {
    fn colour(&self, ray: &Ray) -> [f64; 3] {
        let Some((surface, hit)) = self.reader.visibility().nearest(ray) else { return [0.0; 3] };
        let elements = self.reader.solution().elements();
        let jet = elements.shape(surface).jet(hit.u, hit.v);
        let parameters = [hit.u, hit.v];
        let seen = jet.normal.dot(ray.direction) < 0.0;
        let Some(element) = elements.at(surface, parameters).filter(|_| seen) else { return [0.0; 3] };
        let place = Place { surface, parameters, position: jet.position };
        let values = self.radiosity(element, &place, jet.normal);
        match values[..] {
            [red, green, blue] => [red, green, blue],
            _ => [values.iter().sum::<f64>() / values.len() as f64; 3],
        }
    }

    /// Radiosity per band; what polynomials undershoot is cut off at zero.
    fn radiosity(&self, element: usize, place: &Place, normal: DVec3) -> Vec<f64> {
        let irradiance = match self.reader.light() {
            Light::Direct(direct) => {
                let lit = direct.at(element, place.position, normal);
                let rest = self.reader.indirect_polynomials(element, place);
                lit.iter().zip(rest).map(|(d, s)| d + s.max(0.0)).collect()
            }
            Light::Basis | Light::Gather(_) => self.reader.irradiance(element, place, normal),
        };
        let bands = self.reader.solution().bands().iter();
        bands.zip(irradiance).map(|(band, e)| band.coating.radiosity(element, e).max(0.0)).collect()
    }
}

/// Factors that make the emitted light of a three-band scene white; all 1 if any band emits nothing.
fn white_balance(solution: &Solution) -> [f64; 3] {
    if solution.bands().len() != 3 {
        return [1.0; 3];
    }
    let list = solution.elements().list();
    let power = |band: usize| -> f64 {
        let exitance = &solution.bands()[band].coating.exitance;
        list.iter().zip(exitance).map(|(element, e)| element.area * e).sum()
    };
    let powers = [power(0), power(1), power(2)];
    if powers.contains(&0.0) {
        return [1.0; 3];
    }
    let mean = powers.iter().sum::<f64>() / 3.0;
    powers.map(|power| mean / power)
}
