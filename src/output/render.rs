//! Pictures of a solution: camera rays meet the true surfaces, where radiosity is read.
//!
//! The camera is a pinhole. Each pixel averages the radiosity at `samples × samples` points of a regular grid; a ray
//! that meets the back of a surface, or nothing, is black.

use radiosity_geom::{DVec3, Encounter, Ray};
use rayon::prelude::*;

use super::pinhole::Pinhole;
use super::raster::Raster;
pub use super::reader::Read;
use super::reader::{Light, Reader};
use super::shown::Shown;
use crate::gather::spot::Spot;
use crate::scene::Camera;
use crate::solution::{Place, Solution};
use crate::visibility::Visibility;

/// Relative accuracy of recomputed light in pictures: finer than the steps of eight bits, 1/255. Chosen; not tuned.
const GATHERED: f64 = 3e-3;

/// Most rows that a thread gets at once: rows of a picture take very different times. Chosen; not tuned.
const AT_ONCE: usize = 4;

/// Renders `solution` through `camera`; `progress` gets (rows done, rows in all), from any thread.
///
/// The pixels hold what is `shown`, W m⁻² (radiosity is radiance times π), in the bands of the solution.
pub fn render(
    solution: &Solution,
    visibility: &Visibility,
    camera: &Camera,
    samples: u32,
    read: Read,
    shown: Shown,
    progress: &(dyn Fn(usize, usize) + Sync),
) -> Raster {
    let view = Pinhole::new(camera);
    let reader = Reader::new(solution, visibility, read, GATHERED);
    let eye = Eye { reader, shown, diagonal: visibility.bounds().diagonal() };
    let done = std::sync::atomic::AtomicUsize::new(0);
    let rows: Vec<Vec<Seen>> = (0..camera.height)
        .into_par_iter()
        .with_max_len(AT_ONCE)
        .map(|row| {
            let pixels = (0..camera.width).map(|column| pixel(&eye, &view, [column, row], samples));
            let pixels = pixels.collect();
            progress(done.fetch_add(1, std::sync::atomic::Ordering::Relaxed) + 1, camera.height as usize);
            pixels
        })
        .collect();
    let pixels = || rows.iter().flatten();
    let bands = solution.bands().iter().map(|band| band.name.clone()).collect();
    let values = pixels().flat_map(|seen| &seen.radiosity).copied().collect();
    let coverage = pixels().map(|seen| seen.coverage).collect();
    Raster::new([camera.width, camera.height], bands, values, coverage)
}

/// The radiosity seen through a pixel.
struct Seen {
    /// Mean over the pixel, per band.
    radiosity: Vec<f64>,
    /// Part of the pixel in which a front is seen.
    coverage: f64,
}

fn pixel(eye: &Eye, view: &Pinhole, [column, row]: [u32; 2], samples: u32) -> Seen {
    let mut radiosity = vec![0.0; eye.reader.solution().bands().len()];
    let mut count = 0u32;
    for index in 0..samples * samples {
        let offset = |k: u32| (f64::from(k) + 0.5) / f64::from(samples);
        let x = f64::from(column) + offset(index % samples);
        let y = f64::from(row) + offset(index / samples);
        if let Some(values) = eye.along(&view.ray(x, y)) {
            radiosity.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
            count += 1;
        }
    }
    let scale = 1.0 / f64::from(samples * samples);
    radiosity.iter_mut().for_each(|sum| *sum *= scale);
    Seen { radiosity, coverage: f64::from(count) * scale }
}

/// The data that turn a camera ray into radiosities.
struct Eye<'a> {
    reader: Reader<'a>,
    shown: Shown,
    /// Diagonal of the scene's bounding box.
    diagonal: f64,
}

impl Eye<'_> {
    /// What is shown, per band, of the front that a ray meets first, if it is a front.
    fn along(&self, ray: &Ray) -> Option<Vec<f64>> {
        let Encounter { surface, hit, front } = self.reader.visibility().nearest(ray)?;
        let elements = self.reader.solution().elements();
        // Where two surfaces meet, light is the limit from within the visible one.
        let spot = front.then(|| Spot::at(elements, surface, [hit.u, hit.v], self.diagonal))??;
        Some(self.values(spot.element, &spot.place, spot.normal))
    }

    /// What is shown, per band.
    fn values(&self, element: usize, place: &Place, normal: DVec3) -> Vec<f64> {
        let irradiance = match self.reader.light() {
            Light::Direct(direct) => {
                let rest = self.reader.indirect_polynomials(element, place);
                let lit = direct.at_beside(element, place.position, normal, &rest);
                lit.iter().zip(rest).map(|(d, s)| d + s.max(0.0)).collect()
            }
            Light::Basis | Light::Gather(_) => self.reader.irradiance(element, place, normal),
        };
        let bands = self.reader.solution().bands().iter();
        bands.zip(irradiance).map(|(band, e)| self.shown.of(&band.coating, element, e)).collect()
    }
}

/// Factors that make the emitted light of a three-band scene white, as a camera's white balance. All are 1 if a band
/// emits nothing, and for any other number of bands.
pub fn white_balance(solution: &Solution) -> [f64; 3] {
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
