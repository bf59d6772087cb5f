//! Random enclosures with open sides, backs and sheets: flows that sum to 0 where nothing is open, and flows and
//! temperatures that are those of walks of rays through rectangles, which the test makes by itself.

use std::fmt::Write;

use radiosity::Work;
use radiosity::geom::DVec3;
use radiosity::heat::{Heat, HeatOptions, SurfaceHeat};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;

use super::shared::level;

/// Walks from each side.
const WALKS: usize = 20_000;

/// Errors of a mean of walks that it is hardly off by, beside three told ones.
const CHANCE: f64 = 4.0;

/// Condition of a side.
#[derive(Clone, Copy, Debug)]
enum Known {
    Kelvin(f64),
    Flux(f64),
    /// A side of an adiabatic sheet of one temperature.
    Sheet,
}

/// A side of a rectangle across an axis.
#[derive(Clone, Debug)]
struct Side {
    name: String,
    axis: usize,
    at: f64,
    /// Ranges along the next two axes.
    ranges: [[f64; 2]; 2],
    /// Whether it faces along its axis.
    is_along: bool,
    emissivity: f64,
    known: Known,
    /// Whether it is the front of a sheet, whose back follows, or the back.
    of_sheet: Option<bool>,
}

impl Side {
    /// A black side of no sheet, in the plane x_axis = `at`, that faces along the axis or against it.
    fn new(name: String, axis: usize, at: f64, ranges: [[f64; 2]; 2], is_along: bool, known: Known) -> Self {
        Self { name, axis, at, ranges, is_along, emissivity: 1.0, known, of_sheet: None }
    }

    fn area(&self) -> f64 {
        self.ranges.iter().map(|range| range[1] - range[0]).product()
    }

    fn place(&self, shares: [f64; 2]) -> DVec3 {
        let mut place = DVec3::ZERO;
        place[self.axis] = self.at;
        for (k, ([low, high], share)) in self.ranges.iter().zip(shares).enumerate() {
            place[(self.axis + 1 + k) % 3] = low + (high - low) * share;
        }
        place
    }

    /// A direction by Lambert's law.
    fn leaving(&self, random: &mut Random) -> DVec3 {
        let normal = DVec3::AXES[self.axis] * if self.is_along { 1.0 } else { -1.0 };
        (normal + random.direction()).normalize()
    }

    /// How far along a ray this side is met from its front.
    fn met(&self, from: DVec3, along: DVec3) -> Option<f64> {
        if along[self.axis] == 0.0 || (along[self.axis] < 0.0) != self.is_along {
            return None;
        }
        let far = (self.at - from[self.axis]) / along[self.axis];
        let at = from + far * along;
        let holds = |k: usize| {
            let place = at[(self.axis + 1 + k) % 3];
            self.ranges[k][0] <= place && place <= self.ranges[k][1]
        };
        (far > 1e-9 && holds(0) && holds(1)).then_some(far)
    }

    fn corners(&self) -> [DVec3; 4] {
        let mut corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|shares| self.place(shares));
        if !self.is_along {
            corners.reverse();
        }
        corners
    }
}

/// Sides of a scene; the text of it, in which the backs follow from their fronts.
struct Enclosure {
    sides: Vec<Side>,
    text: String,
    is_closed: bool,
}

impl Enclosure {
    fn of(seed: u64) -> Self {
        let mut random = Random(seed);
        let size = random.vector(1.0, 3.0);
        let open = [usize::MAX, random.below(6), random.below(6)];
        let open = &open[..1 + random.below(3)];
        let mut own = Self { sides: Vec::new(), text: String::new(), is_closed: open.len() == 1 };
        let whole = |axis: usize| [1, 2].map(|k| [0.0, size[(axis + k) % 3]]);
        for face in (0..6).filter(|face| !open.contains(face)) {
            let (axis, is_along) = (face / 2, face % 2 == 0);
            let at = if is_along { 0.0 } else { size[axis] };
            let known = if own.sides.is_empty() { Known::Kelvin(700.0) } else { condition(&mut random) };
            let name = format!("wall-{face}");
            own.add(Side::new(name, axis, at, whole(axis), is_along, known), &mut random);
            own.write(own.sides.len() - 1, "");
        }
        let axis = random.below(3);
        for plate in 0..1 + random.below(2) {
            let at = size[axis] * (0.3 + 0.4 * plate as f64);
            let ranges = whole(axis)
                .map(|[_, high]| [high * random.between(0.1, 0.3), high * random.between(0.6, 0.9)]);
            own.plate(&format!("plate-{plate}"), axis, at, ranges, &mut random);
        }
        own
    }

    /// Adds a side of a random emissivity.
    fn add(&mut self, side: Side, random: &mut Random) {
        self.sides.push(Side { emissivity: random.pick(&[0.1, 0.3, 0.6, 0.9, 1.0]), ..side });
    }

    /// A plate of one side whose back is adiabatic, as warm as its front or of its own temperature; or a sheet.
    fn plate(&mut self, name: &str, axis: usize, at: f64, ranges: [[f64; 2]; 2], random: &mut Random) {
        let front = self.sides.len();
        let kelvin = Known::Kelvin(random.between(300.0, 900.0));
        self.add(Side::new(name.to_owned(), axis, at, ranges, random.below(2) == 0, kelvin), random);
        let mut back = Side { name: format!("{name}:back"), ..self.sides[front].clone() };
        back.is_along = !back.is_along;
        let keys = match random.below(4) {
            0 => {
                back.known = Known::Flux(0.0);
                ""
            }
            1 => "back = \"front\"",
            2 => {
                back.known = Known::Kelvin(500.0);
                "back = 500"
            }
            _ => {
                self.sides[front].known = Known::Sheet;
                self.sides[front].of_sheet = Some(true);
                back = Side { known: Known::Sheet, of_sheet: Some(false), ..back };
                "two_sided = true"
            }
        };
        self.sides.push(back);
        self.write(front, keys);
    }

    /// Adds the surface of a front to the text.
    fn write(&mut self, front: usize, keys: &str) {
        let side = &self.sides[front];
        let condition = match side.known {
            Known::Kelvin(kelvin) => format!("temperature = {kelvin}"),
            Known::Flux(flux) => format!("heat_flux = {flux}"),
            Known::Sheet => "adiabatic = true".to_owned(),
        };
        let corners = side.corners().map(|corner| corner.to_array());
        let Side { name, emissivity, .. } = side;
        write!(
            self.text,
            "[materials.{name}]\nemissivity = {emissivity}\n{condition}\n\
             [[surfaces]]\nname = \"{name}\"\nmaterial = \"{name}\"\n{keys}\nquad = {{ vertices = {corners:?} }}\n"
        )
        .expect("text takes all");
    }

    /// Radiosity that arrives at a place along a ray, in the mean of many (W m⁻²).
    fn arriving(&self, mut side: usize, random: &mut Random) -> f64 {
        let mut sum = 0.0;
        let mut place = self.sides[side].place([random.unit(), random.unit()]);
        loop {
            let along = self.sides[side].leaving(random);
            let met = self.sides.iter().enumerate().filter_map(|(k, own)| Some((k, own.met(place, along)?)));
            let Some((next, far)) = met.min_by(|a, b| a.1.total_cmp(&b.1)) else { return sum };
            (side, place) = (next, place + far * along);
            let own = &self.sides[side];
            let is_absorbed = random.unit() < own.emissivity;
            match own.known {
                Known::Kelvin(kelvin) if is_absorbed => return sum + level(kelvin),
                Known::Flux(flux) => sum += flux,
                Known::Sheet if is_absorbed => {
                    side = self.either(side, random);
                    place = self.sides[side].place([random.unit(), random.unit()]);
                }
                Known::Kelvin(_) | Known::Sheet => {}
            }
        }
    }

    /// This side of a sheet or the other.
    fn either(&self, side: usize, random: &mut Random) -> usize {
        let front = if self.sides[side].of_sheet == Some(false) { side - 1 } else { side };
        front + random.below(2)
    }

    /// The flow (W) of a side of known temperature, or the level (W m⁻²) of another, with its standard error.
    fn walked(&self, side: usize, random: &mut Random) -> [f64; 2] {
        let own = &self.sides[side];
        let start = |random: &mut Random| match own.known {
            Known::Sheet => self.either(side, random),
            Known::Kelvin(_) | Known::Flux(_) => side,
        };
        let (mut sum, mut squares) = (0.0, 0.0);
        for _ in 0..WALKS {
            let from = start(random);
            let found = self.arriving(from, random);
            (sum, squares) = (sum + found, squares + found * found);
        }
        let mean = sum / WALKS as f64;
        let error = ((squares / WALKS as f64 - mean * mean).max(0.0) / WALKS as f64).sqrt();
        let power = own.emissivity * own.area();
        match own.known {
            Known::Kelvin(kelvin) => [power * (level(kelvin) - mean), power * error],
            Known::Flux(flux) => [mean + flux / own.emissivity, error],
            Known::Sheet => [mean, error],
        }
    }
}

fn condition(random: &mut Random) -> Known {
    match random.below(4) {
        0 => Known::Flux(0.0),
        1 => Known::Flux(random.between(50.0, 900.0)),
        _ => Known::Kelvin(random.between(300.0, 900.0)),
    }
}

/// Flow or level that is printed of a side, with the error that is told.
fn printed(own: &SurfaceHeat) -> [f64; 2] {
    match own.is_temperature_known {
        true => [own.flow, own.flow_error],
        false => {
            let slope = 4.0 * level(own.temperature) / own.temperature;
            [level(own.temperature), slope * own.temperature_error]
        }
    }
}

/// Looks at the enclosures of these seeds; at most the part `most` of all sides may be off.
fn look(seeds: std::ops::Range<u64>, most: f64) {
    let (mut sides, mut off) = (0, Vec::new());
    for seed in seeds {
        let enclosure = Enclosure::of(seed);
        let heat = Heat::of(&typed(&enclosure.text), &HeatOptions::default(), &Work::alone())
            .unwrap_or_else(|error| panic!("{seed}: {error}\n{}", enclosure.text));
        assert_eq!(heat.is_closed(), enclosure.is_closed, "{seed}: lost {}\n{}", heat.lost, enclosure.text);
        let mut random = Random(!seed);
        for (side, own) in enclosure.sides.iter().enumerate() {
            // Heat does not reach the back of a plate that looks out of the scene.
            let Some(found) = heat.surfaces.iter().find(|surface| surface.name == own.name) else { continue };
            let [value, told] = printed(found);
            let [walked, error] = enclosure.walked(side, &mut random);
            sides += 1;
            if (value - walked).abs() > 3.0 * told + CHANCE * error {
                off.push(format!("{seed}: {} is {value} ± {told}, walks find {walked} ± {error}", own.name));
            }
        }
    }
    assert!(off.len() as f64 <= most * f64::from(sides), "{}", off.join("\n"));
}

#[test]
fn random_enclosures_are_in_balance_and_tell_their_errors() {
    look(0..3, 0.0);
}

#[test]
#[ignore = "a minute"]
fn many_random_enclosures_tell_their_errors() {
    look(3..30, 0.01);
}
