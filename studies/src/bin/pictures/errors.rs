//! Errors of pictures, beside light computed anew at their pixels.

use cpu_time::ProcessTime;

use radiosity::Work;
use radiosity::geom::{DVec3, Encounter};
use radiosity::reading::pictures::pinhole::Pinhole;
use radiosity::reading::pictures::render::PictureRequest;
use radiosity::reading::quantity::Quantity;
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Camera;
use radiosity::solve::gather::gather_method::GatherMethod;
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::visibility::Visibility;

const PIXELS: usize = 1000;
const RUN: usize = 16;
const RUNS: usize = 50;
/// Accuracy of light computed anew.
const EPS: f64 = 1e-3;

/// Errors of the pixels that were judged.
pub(crate) struct Judged {
    /// Number of them.
    pub(crate) pixels: usize,
    /// Root mean square over that of the radiosity.
    pub(crate) rms: f64,
    /// The largest over the root mean square of the radiosity.
    pub(crate) largest: f64,
}

/// The place that the middle of a pixel sees.
#[derive(Clone, Copy)]
struct Seen {
    element: usize,
    place: SurfacePlace,
    normal: DVec3,
}

/// The pixels of a picture beside light computed anew.
pub(crate) struct Errors<'a> {
    solution: &'a Solution,
    reader: Reader<'a>,
    width: usize,
    seen: Vec<Option<Seen>>,
    /// Radiosity of the picture, all bands together (W m⁻²).
    picture: Vec<f64>,
}

impl<'a> Errors<'a> {
    /// Takes the picture of one sample a pixel.
    pub(crate) fn of(solution: &'a Solution, visibility: &'a Visibility, camera: &Camera) -> Self {
        let gather = ReadMode::Gather;
        let raster = PictureRequest {
            solution,
            visibility,
            camera,
            samples: 1,
            read: gather,
            shown: Quantity::Radiosity,
            is_preview: false,
        }
        .picture(&Work::alone());
        let view = Pinhole::new(camera);
        let width = camera.width as usize;
        let look = |pixel: usize| {
            let ray = view.ray((pixel % width) as f64 + 0.5, (pixel / width) as f64 + 0.5);
            let Encounter { surface, hit, .. } = visibility.nearest(&ray).filter(|met| met.front)?;
            let element = solution.elements().at(surface, [hit.u, hit.v])?;
            let jet = solution.elements().shape(surface).jet(hit.u, hit.v);
            let place = SurfacePlace { surface, parameters: [hit.u, hit.v], position: jet.position };
            let emits = solution.bands().iter().any(|band| band.coating.exitance[element] > 0.0);
            (!emits).then_some(Seen { element, place, normal: jet.normal })
        };
        Self {
            solution,
            reader: Reader::by(GatherMethod::Auto, solution, visibility, gather, EPS),
            width,
            seen: (0..width * camera.height as usize).map(look).collect(),
            picture: raster.pixels().map(|bands| bands.iter().sum()).collect(),
        }
    }

    /// The radiosity of a pixel computed anew, all bands together.
    fn exact(&self, seen: &Seen) -> f64 {
        let irradiance = self.reader.irradiance(seen.element, &seen.place, seen.normal).irradiance;
        let bands = self.solution.bands().iter().zip(irradiance);
        bands.map(|(band, e)| band.coating.radiosity(seen.element, seen.place.parameters, e, 0.0)).sum()
    }

    fn error(&self, pixel: usize) -> Option<f64> {
        Some(self.picture[pixel] - self.exact(self.seen[pixel].as_ref()?))
    }

    /// Errors of pixels all over the picture, in an order that is even wherever it ends: after so many seconds of the
    /// processor.
    pub(crate) fn judged(&self, longest: f64) -> Judged {
        let start = ProcessTime::now();
        let step = coprime(self.seen.len());
        let pixels = (0..self.seen.len().min(PIXELS)).map(|index| index * step % self.seen.len());
        let (mut count, mut squares, mut all, mut largest) = (0u32, 0.0, 0.0, 0.0f64);
        for pixel in pixels.take_while(|_| start.elapsed().as_secs_f64() < longest) {
            let Some(error) = self.error(pixel) else { continue };
            count += 1;
            squares += error * error;
            largest = largest.max(error.abs());
            all += self.picture[pixel].powi(2);
        }
        let size = f64::sqrt(all / f64::from(count));
        Judged {
            pixels: count as usize,
            rms: f64::sqrt(squares / f64::from(count)) / size,
            largest: largest / size,
        }
    }

    /// The largest steps across joints, of runs all over the picture, as many as so many seconds take.
    pub(crate) fn joints(&self, longest: f64) -> Joints {
        let start = ProcessTime::now();
        let runs: Vec<Vec<Pair>> = self.runs();
        let step = coprime(runs.len());
        let chosen = (0..runs.len().min(RUNS)).map(|index| &runs[index * step % runs.len()]);
        let mut largest = Joints { runs: 0, joint: 0.0, step: 0.0 };
        for run in chosen.take_while(|_| start.elapsed().as_secs_f64() < longest) {
            let jumps =
                run.iter().filter_map(|pair| Some(self.error(pair.pixels[1])? - self.error(pair.pixels[0])?));
            let jumps: Vec<f64> = jumps.collect();
            let mean = jumps.iter().sum::<f64>() / jumps.len().max(1) as f64;
            largest.runs += 1;
            largest.joint = largest.joint.max(mean.abs());
            largest.step = jumps.iter().fold(largest.step, |step, jump| step.max(jump.abs()));
        }
        let lit = (0..self.seen.len()).filter(|pixel| self.seen[*pixel].is_some());
        let lit: Vec<f64> = lit.map(|pixel| self.picture[pixel]).collect();
        let mean = lit.iter().sum::<f64>() / lit.len() as f64;
        Joints { joint: largest.joint / mean, step: largest.step / mean, ..largest }
    }

    /// Pairs of pixels across the joints, those along one joint together.
    fn runs(&self) -> Vec<Vec<Pair>> {
        let mut pairs: Vec<Pair> = (0..self.seen.len())
            .flat_map(|pixel| [(pixel, 1), (pixel, self.width)])
            .filter_map(|(pixel, step)| self.pair(pixel, step))
            .collect();
        pairs.sort_by_key(|pair| (pair.elements, pair.step));
        let runs = pairs.chunk_by(|a, b| (a.elements, a.step) == (b.elements, b.step));
        runs.flat_map(|along| along.chunks_exact(RUN).map(<[Pair]>::to_vec)).collect()
    }

    /// A pixel and the one a step after it, if a joint lies between them; that of the lower element first.
    fn pair(&self, pixel: usize, step: usize) -> Option<Pair> {
        let other = pixel + step;
        let is_beside = step > 1 || !other.is_multiple_of(self.width);
        let [a, b] = [pixel, other].map(|pixel| self.seen.get(pixel).copied().flatten());
        let (a, b) =
            a.zip(b).filter(|(a, b)| a.place.surface == b.place.surface && a.element != b.element)?;
        let pixels = if a.element < b.element { [pixel, other] } else { [other, pixel] };
        let elements = [a.element.min(b.element), a.element.max(b.element)];
        is_beside.then_some(Pair { pixels, elements, step })
    }
}

/// Two pixels beside each other that see two elements of one surface.
#[derive(Clone, Copy)]
struct Pair {
    pixels: [usize; 2],
    elements: [usize; 2],
    /// Pixels from the one to the other.
    step: usize,
}

/// Largest steps of the error, over the mean radiosity.
pub(crate) struct Joints {
    /// Runs that were judged.
    pub(crate) runs: usize,
    /// Mean of those along a part of a joint.
    pub(crate) joint: f64,
    /// Between two pixels.
    pub(crate) step: f64,
}

/// A step about the golden part of a count that has no divisor in common with it: its multiples are even.
fn coprime(count: usize) -> usize {
    let is_coprime = |step: &usize| {
        let (mut a, mut b) = (*step, count);
        while b > 0 {
            (a, b) = (b, a % b);
        }
        a == 1
    };
    let golden = (0.618 * count as f64) as usize;
    (golden.max(1)..).find(is_coprime).unwrap_or(1)
}
