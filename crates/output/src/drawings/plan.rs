//! Plans: the irradiance over a plane of sensors, seen against its normal, the first edge to the right.

use radiosity_scene::SensorPlane;

use super::interpolant::Interpolant;
use radiosity_reading::field::Field;

/// Pixels along the longer side of a plan. Chosen.
const PIXELS: f64 = 640.0;

/// Steps to the sensors beside one, along both edges.
const AROUND: [[isize; 2]; 4] = [[1, 0], [-1, 0], [0, 1], [0, -1]];

/// The values of a plane's sensors as a drawing.
#[derive(Clone, Debug)]
pub(crate) struct Plan<'a> {
    plane: &'a SensorPlane,
    values: &'a [Option<f64>],
    /// Components of the second edge along the first one and away from it (scene length).
    second: [f64; 2],
}

impl<'a> Plan<'a> {
    /// The plan of `plane` with a value per sensor, in the order of [`SensorPlane::sensors`], none where it is left
    /// out: its cell stays white.
    ///
    /// # Panics
    /// If there is not an entry per sensor, or no value at all.
    pub(crate) fn new(plane: &'a SensorPlane, values: &'a [Option<f64>]) -> Self {
        let [n, m] = plane.counts();
        assert_eq!(values.len(), n * m, "one entry per sensor");
        let [a, b] = plane.edges();
        let along = b.dot(a.normalize());
        Self { plane, values, second: [along, (b - along * a.normalize()).length()] }
    }

    /// Least and greatest coordinate along the first edge and away from it, from the origin (scene length).
    pub(crate) fn extent(&self) -> [[f64; 2]; 2] {
        let (first, [along, away]) = (self.plane.edges()[0].length(), self.second);
        [[along.min(0.0), first + along.max(0.0)], [0.0, away]]
    }

    /// The values, smooth between the sensors, pixel by pixel; nothing is covered beyond the plane, and where sensors
    /// are left out.
    pub(crate) fn field(&self) -> Field {
        let extent = self.extent();
        let lengths = extent.map(|[low, high]| high - low);
        let scale = PIXELS / lengths[0].max(lengths[1]);
        let size = lengths.map(|length| (length * scale).round().max(1.0) as u32);
        let counts = self.plane.counts();
        let values = completed(counts, self.values);
        let interpolant = Interpolant::new(counts, &values);
        let pixels = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| [x, y].map(|k| f64::from(k) + 0.5)));
        let pixel = |[x, y]: [f64; 2]| {
            let parts = [x / f64::from(size[0]), 1.0 - y / f64::from(size[1])];
            let place = [0, 1].map(|k| extent[k][0] + parts[k] * lengths[k]);
            self.pixel(&interpolant, place, scale)
        };
        let (values, coverage) = pixels.map(pixel).unzip();
        Field::new(size, values, coverage)
    }

    /// Value and coverage at a place along the first edge and away from it, with `scale` pixels per length.
    fn pixel(&self, interpolant: &Interpolant, [x, y]: [f64; 2], scale: f64) -> (f64, f64) {
        let (first, [along, away]) = (self.plane.edges()[0].length(), self.second);
        let part = [(x - y / away * along) / first, y / away];
        let [n, m] = self.plane.counts().map(|count| count as f64);
        let value = interpolant.at([part[0] * n - 0.5, part[1] * m - 0.5]);
        // Distances from the slanted sides, in pixels.
        let beside = first * away / along.hypot(away) * scale;
        let inside = (0.5 + beside * part[0]).min(0.5 + beside * (1.0 - part[0]));
        let is_shown = self.values[self.cell(part)].is_some();
        (value, if is_shown { inside.clamp(0.0, 1.0) } else { 0.0 })
    }

    /// The sensor in whose cell a place lies, given in parts of the edges.
    fn cell(&self, part: [f64; 2]) -> usize {
        let [n, m] = self.plane.counts();
        let [i, j] =
            [(part[0], n), (part[1], m)].map(|(part, count)| ((part * count as f64) as usize).min(count - 1));
        i * m + j
    }
}

/// The values with others in place of those that are left out, ring after ring about what is known: the mean of
/// the lines that come from the neighbours.
fn completed([n, m]: [usize; 2], values: &[Option<f64>]) -> Vec<f64> {
    let mut known = values.to_vec();
    assert!(known.iter().any(Option::is_some), "some value");
    let of_known = |fold: fn(f64, f64) -> f64| values.iter().copied().flatten().reduce(fold).unwrap_or(0.0);
    let range = [of_known(f64::min), of_known(f64::max)];
    while known.contains(&None) {
        let at = |i: isize, j: isize| {
            let is_there = (0..n as isize).contains(&i) && (0..m as isize).contains(&j);
            is_there.then(|| known[i as usize * m + j as usize]).flatten()
        };
        let along = |i: isize, j: isize, [di, dj]: [isize; 2]| {
            let near = at(i + di, j + dj)?;
            Some(at(i + 2 * di, j + 2 * dj).map_or(near, |far| 2.0 * near - far))
        };
        let mean = |place: usize| {
            let (i, j) = ((place / m) as isize, (place % m) as isize);
            let lines: Vec<f64> = AROUND.iter().filter_map(|step| along(i, j, *step)).collect();
            let mean = lines.iter().sum::<f64>() / lines.len() as f64;
            (!lines.is_empty()).then(|| mean.clamp(range[0], range[1]))
        };
        known = (0..known.len()).map(|place| known[place].or_else(|| mean(place))).collect();
    }
    known.into_iter().flatten().collect()
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;

    use super::*;
    use crate::drawings::isolines::Isoline;

    #[test]
    fn isolines_of_a_linear_field_are_straight_at_their_places_on_the_plan() {
        for edges in
            [[4.0 * DVec3::X, 3.0 * DVec3::Y], [DVec3::new(4.0, 0.0, 0.0), DVec3::new(1.0, 3.0, 0.0)]]
        {
            let plane = SensorPlane::new("slope", DVec3::ZERO, edges, [0.5, 0.5]).unwrap();
            let linear = |x: f64, y: f64| 100.0 + 20.0 * x - 35.0 * y;
            let values: Vec<Option<f64>> =
                plane.sensors().map(|sensor| Some(linear(sensor.x, sensor.y))).collect();
            let plan = Plan::new(&plane, &values);
            let [[left, right], [_, high]] = plan.extent();
            let field = plan.field();
            let [width, height] = field.size().map(f64::from);
            let parts: Vec<Option<u32>> =
                field.pixels().map(|(_, part)| (part == 1.0).then_some(0)).collect();
            let lines = Isoline::all(&field, &parts, 90.0);
            assert_eq!(lines.len(), 1, "one line");
            for [x, y] in &lines[0].points {
                let place = [left + x / width * (right - left), high * (1.0 - y / height)];
                assert!((linear(place[0], place[1]) - 90.0).abs() < 1e-9, "{place:?}");
            }
            assert!(lines[0].length() > 0.6 * width, "it crosses the plan");
        }
    }

    #[test]
    fn slanted_planes_cover_their_share_of_the_plan() {
        let edges = [2.0 * DVec3::X, DVec3::new(-1.0, 1.5, 0.0)];
        let plane = SensorPlane::new("slanted", DVec3::ZERO, edges, [1.0, 1.0]).unwrap();
        let field = Plan::new(&plane, &[Some(1.0); 4]).field();
        let share = field.pixels().map(|(_, part)| part).sum::<f64>() / field.pixels().count() as f64;
        assert!((share - 2.0 / 3.0).abs() < 1e-3, "{share}");
    }
    #[test]
    fn what_is_left_out_stays_white_and_isolines_end_there() {
        let plane = SensorPlane::new("l", DVec3::ZERO, [6.0 * DVec3::X, 6.0 * DVec3::Y], [0.5, 0.5]).unwrap();
        let is_left_out = |place: DVec3| place.x > 3.0 && place.y > 3.0;
        let value = |sensor: DVec3| (!is_left_out(sensor)).then_some(100.0 + 20.0 * sensor.x);
        let values: Vec<Option<f64>> = plane.sensors().map(value).collect();
        let field = Plan::new(&plane, &values).field();
        let share = field.pixels().map(|(_, part)| part).sum::<f64>() / field.pixels().count() as f64;
        assert!((share - 0.75).abs() < 1e-9, "{share}");
        let parts: Vec<Option<u32>> = field.pixels().map(|(_, part)| (part == 1.0).then_some(0)).collect();
        // The line at x = 4 runs up to the wall, straight.
        let lines = Isoline::all(&field, &parts, 180.0);
        assert_eq!(lines.len(), 1, "one line");
        let [width, height] = field.size().map(f64::from);
        for [x, y] in &lines[0].points {
            assert!((x / width * 6.0 - 4.0).abs() < 1e-9 && y / height > 0.5, "{x}, {y}");
        }
        assert!((lines[0].length() / height - 0.5).abs() < 0.01);
    }
}
