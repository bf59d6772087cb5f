//! The irradiance of the floor at a grid of points, and errors against it.

use std::error::Error;
use std::time::Duration;

use cpu_time::ProcessTime;
use radiosity::reading::quality::{Quality, ReadSettings};
use radiosity::solve::solution::{Solution, SurfacePlace};
use radiosity::solve::{Options, Transport, solve};
use radiosity::visibility::Visibility;
use radiosity::{Scene, Work};
use radiosity_geom::DVec3;
use rayon::prelude::*;

/// Points along each side of the floor.
const POINTS: usize = 48;
/// Height over a side of an element, in parts of a room of 1, from which a point counts as beyond it.
const ON: f64 = 1e-9;

/// Points of the floor off its holes, and the irradiance there.
pub(crate) struct Judge {
    points: Vec<DVec3>,
    exact: Vec<Vec<f64>>,
}

/// Light at the points, and the CPU time of reading it.
struct Readings {
    values: Vec<Vec<f64>>,
    time: Duration,
}

impl Judge {
    /// Light of the finest preset, gathered twice.
    pub(crate) fn new(scene: &Scene) -> Result<Self, Box<dyn Error>> {
        let floor = scene.surface_named("floor")?;
        let shape = &scene.surfaces[floor].shape;
        let place = |k: usize| (2 * k + 1) as f64 / POINTS as f64 - 1.0;
        let all = (0..POINTS * POINTS).map(|k| shape.jet(place(k % POINTS), place(k / POINTS)).position);
        let points = all.filter(|x| shape.region().is_none_or(|own| own.contains(*x))).collect();
        let options = Options { transport: Transport::Exact, ..Quality::Finest.options() };
        let outcome = solve(scene, &options, &Work::alone())?;
        let mut judge = Self { points, exact: Vec::new() };
        let reading = Quality::Finest.reading();
        let visibility = options.visibility(scene);
        judge.exact = judge.read(scene, &outcome.solution, &visibility, reading)?.values;
        Ok(judge)
    }

    /// The relative L2 error of a solution that is read so, and the CPU time of that.
    pub(crate) fn error(
        &self,
        scene: &Scene,
        solution: &Solution,
        visibility: &Visibility,
        reading: ReadSettings,
    ) -> Result<(f64, Duration), Box<dyn Error>> {
        let Readings { values, time } = self.read(scene, solution, visibility, reading)?;
        let pairs = values.iter().flatten().zip(self.exact.iter().flatten());
        let [missed, size] = pairs.fold([0.0; 2], |[missed, size], (found, exact)| {
            [missed + (found - exact).powi(2), size + exact.powi(2)]
        });
        Ok(((missed / size).sqrt(), time))
    }

    fn read(
        &self,
        scene: &Scene,
        solution: &Solution,
        visibility: &Visibility,
        reading: ReadSettings,
    ) -> Result<Readings, Box<dyn Error>> {
        let list = solution.elements().list();
        let is_floor = |k: &usize| scene.surfaces[list[*k].surface].name.starts_with("floor");
        let floor: Vec<usize> = (0..list.len()).filter(is_floor).collect();
        let place = |x: &DVec3| -> Option<(usize, SurfacePlace)> {
            let element = *floor.iter().find(|k| list[**k].covers(*x, ON))?;
            let surface = list[element].surface;
            let foot = scene.surfaces[surface].shape.project(*x);
            Some((element, SurfacePlace { surface, parameters: [foot.u, foot.v], position: *x }))
        };
        let places: Option<Vec<(usize, SurfacePlace)>> = self.points.iter().map(place).collect();
        let places = places.ok_or("a point of the floor lies in no element")?;
        let start = ProcessTime::now();
        let reader = reading.reader(solution, visibility);
        let values = places
            .par_iter()
            .map(|(element, place)| reader.irradiance(*element, place, DVec3::Z).irradiance)
            .collect();
        Ok(Readings { values, time: start.elapsed() })
    }
}
