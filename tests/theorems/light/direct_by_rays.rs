//! Direct light of luminous areas that rays find for the elements of a scene, in black rooms: against Lambert's
//! formula, and Σ E A = Φ.

use radiosity::solve::{Options, Outcome, Transport};
use radiosity::{Scene, geom::DVec3 as V};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::outcome_of;

use crate::light::reflected_steps::factor;

/// Flux of a lamp (lm).
const FLUX: f64 = 3000.0;

/// Midpoints each way of the mean over a surface.
const POINTS: usize = 48;

/// A black room with Lambertian lamps at the ceiling, each by its corners.
struct Room {
    text: String,
    lamps: Vec<[V; 4]>,
}

impl Room {
    fn of(random: &mut Random) -> Self {
        let [width, depth, height] =
            [random.between(3.0, 9.0), random.between(3.0, 7.0), random.between(2.4, 4.0)];
        let mut text = format!(
            "bands = [\"lm\"]\nmaterials.black = {{ reflectance = 0 }}\n[[surfaces]]\nname = \"room\"\nmaterial = \"black\"\n\
             box = {{ origin = [0, 0, 0], size = [{width}, {depth}, {height}], inward = true }}\n"
        );
        let lamps = (0..1 + random.below(3)).map(|_| {
            let [along, across] = [random.between(0.2, 1.2), random.between(0.1, 0.6)];
            let [x, y] = [[width, along], [depth, across]]
                .map(|[room, lamp]| random.between(0.5 * lamp + 0.05, room - 0.5 * lamp - 0.05));
            let z = height - 0.05;
            text += &format!(
                "[[luminaires]]\nposition = [{x}, {y}, {z}]\nspot = {{ exponent = 1 }}\nflux = {FLUX}\nextent = [{along}, {across}]\n"
            );
            [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
                .map(|[s, t]| V::new(x + 0.5 * s * along, y + 0.5 * t * across, z))
        });
        let lamps = lamps.collect();
        Self { text, lamps }
    }

    /// The room with a few blocks that stand on the floor.
    fn furnished(self, random: &mut Random) -> Self {
        let mut text = self.text;
        for block in 0..3 + random.below(5) {
            // Apart from each other.
            let [x, y] = [0.1 + 0.7 * (block / 2) as f64, 0.1 + 1.4 * (block % 2) as f64];
            let [width, depth, height] =
                [random.between(0.1, 0.6), random.between(0.2, 1.3), random.between(0.3, 1.5)];
            text += &format!(
                "[[surfaces]]\nname = \"block-{block}\"\nmaterial = \"black\"\n\
                 box = {{ origin = [{x}, {y}, 0.2], size = [{width}, {depth}, {height}] }}\n"
            );
        }
        Self { text, ..self }
    }
}

/// A scene whose light rays carry.
fn carried_by_rays(text: &str) -> (Scene, Outcome) {
    let scene = typed(text);
    let options = Options { transport: Transport::Sampled, ..Options::default() };
    let outcome = outcome_of(&scene, &options);
    (scene, outcome)
}

/// The mean irradiance of a flat surface (lx); None of the ceiling, and where a lamp is not wholly above its horizon.
fn exact_mean(outcome: &Outcome, surface: usize, lamps: &[[V; 4]]) -> Option<f64> {
    let shape = outcome.solution.elements().shape(surface);
    let mut sum = 0.0;
    for (i, j) in (0..POINTS).flat_map(|i| (0..POINTS).map(move |j| (i, j))) {
        let [u, v] = [i, j].map(|k| (2.0 * k as f64 + 1.0) / POINTS as f64 - 1.0);
        let jet = shape.jet(u, v);
        for lamp in lamps {
            if jet.normal.z < 0.0
                || lamp.iter().any(|corner| (*corner - jet.position).dot(jet.normal) <= 1e-9)
            {
                return None;
            }
            let area = (lamp[1] - lamp[0]).length() * (lamp[3] - lamp[0]).length();
            sum += FLUX / area * factor(lamp, jet.position, jet.normal);
        }
    }
    Some(sum / (POINTS * POINTS) as f64)
}

/// Rays, about a thousand an element: without shadows their error is some 0.3 %.
#[test]
fn the_mean_of_each_surface_is_that_of_lambert() {
    let random = &mut Random(17);
    for _ in 0..6 {
        let Room { text, lamps } = Room::of(random);
        let (scene, outcome) = carried_by_rays(&text);
        let found: Vec<f64> = (0..scene.surfaces.len())
            .filter_map(|surface| {
                let exact = exact_mean(&outcome, surface, &lamps)?;
                Some(outcome.solution.mean_irradiance(0, surface) / exact - 1.0)
            })
            .collect();
        assert_eq!(found.len(), 5, "floor and walls");
        assert!(found.iter().all(|error| error.abs() < 0.015), "{found:?}\n{text}");
    }
}

/// The flux of the lamps arrives, whatever stands in its way.
#[test]
fn all_of_the_flux_arrives() {
    let random = &mut Random(23);
    let mut errors = Vec::new();
    for _ in 0..8 {
        let Room { text, lamps } = Room::of(random).furnished(random);
        let (scene, outcome) = carried_by_rays(&text);
        let elements = outcome.solution.elements();
        let area =
            |surface| elements.list()[elements.of_surface(surface)].iter().map(|own| own.area).sum::<f64>();
        let surfaces = 0..scene.surfaces.len();
        let arrived: f64 =
            surfaces.map(|surface| area(surface) * outcome.solution.mean_irradiance(0, surface)).sum();
        errors.push(arrived / (lamps.len() as f64 * FLUX) - 1.0);
    }
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    assert!(errors.iter().all(|error| error.abs() < 0.015) && mean.abs() < 0.004, "{errors:?}");
}
