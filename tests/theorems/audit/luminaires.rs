//! Luminaires of all distributions and extents: the law of inverse squares and cosines, summed over the extent
//! in the test.
//!
//! ```text
//! E = ⟨ I(ω) cos θ / r² ⟩ over the points of the extent
//! ```

use radiosity::Scene;
use radiosity::scene::Source;
use radiosity_geom::DVec3;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::parsed;

use super::fairness::assert_fair;
use super::trial::{Trial, quotients};
use super::web::{Symmetry, Web};

const WALKS: f64 = 512.0;

/// Midpoints along each side of an extent.
const SIDE: usize = 200;

/// An extent: its key, and its points across the aim by two numbers from −½ to ½; a disk by polar ones.
#[derive(Clone, Copy, Debug)]
enum Extent {
    Point,
    Line(f64),
    Rectangle([f64; 2]),
    Disk(f64),
}

impl Extent {
    fn key(&self) -> String {
        match self {
            Self::Point => String::new(),
            Self::Line(y) => format!("extent = [0, {y:?}]\n"),
            Self::Rectangle(sides) => format!("extent = {sides:?}\n"),
            Self::Disk(diameter) => format!("extent = {diameter:?}\n"),
        }
    }

    /// The point at two numbers in (0, 1), even by area.
    fn at(&self, [s, t]: [f64; 2]) -> [f64; 2] {
        match *self {
            Self::Point => [0.0, 0.0],
            Self::Line(y) => [0.0, (s - 0.5) * y],
            Self::Rectangle([x, y]) => [(s - 0.5) * x, (t - 0.5) * y],
            Self::Disk(diameter) => {
                let (sine, cosine) = (std::f64::consts::TAU * t).sin_cos();
                let radius = 0.5 * diameter * s.sqrt();
                [radius * cosine, radius * sine]
            }
        }
    }
}

/// A luminaire on its own.
struct Lamp {
    name: String,
    /// Keys of its distribution and its strength.
    keys: String,
    extent: Extent,
    /// Intensity by the parts of a direction along C = 0, C = 90 and the aim.
    intensity: Box<dyn Fn([f64; 3]) -> f64>,
    /// Photometric file, by its name and its text.
    file: Option<(&'static str, String)>,
}

const POSITION: DVec3 = DVec3::new(1.0, 2.0, 3.0);
const AIM: DVec3 = DVec3::new(0.3, -0.2, -1.0);
const ALONG: DVec3 = DVec3::new(1.0, 0.5, 0.1);

impl Lamp {
    /// The axes C = 0, C = 90 and the aim.
    fn axes() -> [DVec3; 3] {
        let aim = AIM.normalize();
        let along = (ALONG - ALONG.dot(aim) * aim).normalize();
        [along, along.cross(aim), aim]
    }

    /// Irradiance at a point.
    fn irradiance(&self, point: DVec3, normal: DVec3) -> f64 {
        let axes = Self::axes();
        let count = if matches!(self.extent, Extent::Point) { 1 } else { SIDE };
        let at = |k: usize| (k as f64 + 0.5) / count as f64;
        let mut sum = 0.0;
        for k in 0..count * count {
            let [x, y] = self.extent.at([at(k % count), at(k / count)]);
            let step = point - (POSITION + x * axes[0] + y * axes[1]);
            let squared = step.length_squared();
            let along = step / squared.sqrt();
            let cosine = (-normal.dot(along)).max(0.0);
            sum += (self.intensity)(axes.map(|axis| axis.dot(along))) * cosine / squared;
        }
        sum / (count * count) as f64
    }

    /// A scene of the luminaire, far above a black ball.
    fn scene(&self) -> Scene {
        let [aim, along] = [AIM, ALONG].map(|own| own.to_array());
        let text = format!(
            "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[[surfaces]]\nmaterial = \"black\"\n\
             sphere = {{ center = [0, 0, -20], radius = 1 }}\n[[luminaires]]\nposition = {:?}\naim = {aim:?}\n\
             along = {along:?}\n{}{}",
            POSITION.to_array(),
            self.keys,
            self.extent.key()
        );
        let source = Source::new("lamp", &text);
        match &self.file {
            Some((name, table)) => parsed(&source.including(name, table)),
            None => parsed(&source),
        }
    }

    /// The lamp with points on all sides, some of them near.
    fn trial(&self, seed: u64, points: usize) -> Trial {
        let mut random = Random(seed);
        let mut trial = Trial::of(format!("{} {:?}", self.name, self.extent), self.scene());
        for k in 0..points {
            let side = if k % 3 == 2 { -1.0 } else { 1.0 };
            let away = side * Self::axes()[2] + 0.9 * random.direction();
            let point = POSITION + random.between(0.6, 4.0) * away.normalize();
            let normal = (POSITION - point).normalize() + 0.7 * random.direction();
            trial = trial.point(point, normal, self.irradiance(point, normal.normalize()));
        }
        trial
    }
}

const EXTENTS: [Extent; 4] =
    [Extent::Point, Extent::Line(0.9), Extent::Rectangle([0.3, 0.5]), Extent::Disk(0.4)];

/// Twelve LM-63 files and six EULUMDAT files.
fn webs() -> Vec<(Web, bool)> {
    let all = [Symmetry::None, Symmetry::Axial, Symmetry::AboutC0, Symmetry::AboutC90, Symmetry::Quadrant];
    let web = |symmetry, turn, gammas, steps| Web { symmetry, turn, gammas, steps };
    let mut webs = Vec::new();
    for symmetry in all {
        webs.push((web(symmetry, 22.5, [0.0, 180.0], 36), false));
        webs.push((web(symmetry, 45.0, [0.0, 90.0], 9), false));
        webs.push((web(symmetry, 15.0, [0.0, 180.0], 12), true));
    }
    webs.push((web(Symmetry::None, 30.0, [90.0, 180.0], 18), false));
    webs.push((web(Symmetry::AboutC0, 90.0, [0.0, 120.0], 8), false));
    webs.push((web(Symmetry::Quadrant, 10.0, [0.0, 90.0], 18), true));
    webs
}

pub(super) fn tables() -> Vec<Trial> {
    let lamp = |(k, (web, is_eulumdat)): (usize, (Web, bool))| {
        let file = if is_eulumdat { ("lamp.ldt", web.eulumdat()) } else { ("lamp.ies", web.ies()) };
        Lamp {
            name: format!("{web:?}"),
            keys: format!("photometry = \"{}\"\n", file.0),
            // Areas need a table that does not end beside the light: all but the last three.
            extent: if k < 15 { EXTENTS[k % 4] } else { EXTENTS[k % 2] },
            intensity: Box::new(move |along| web.intensity(along)),
            file: Some(file),
        }
    };
    let lamps = webs().into_iter().enumerate().map(lamp);
    (0..).zip(lamps).map(|(seed, lamp)| lamp.trial(seed, 12)).collect()
}

#[test]
fn photometric_tables_light_by_inverse_squares() {
    assert_fair(&quotients(&tables(), WALKS, 700));
}

fn spots() -> Vec<Lamp> {
    let peak = 400.0;
    let mut lamps = Vec::new();
    for extent in EXTENTS {
        lamps.push(Lamp {
            name: "point".into(),
            keys: format!("point = {{}}\nintensity = {peak}\n"),
            extent,
            intensity: Box::new(move |_| peak),
            file: None,
        });
        for exponent in [0.0, 1.0, 3.5, 40.0] {
            lamps.push(Lamp {
                name: format!("exponent {exponent}"),
                keys: format!("spot = {{ exponent = {exponent} }}\nintensity = {peak}\n"),
                extent,
                intensity: Box::new(
                    move |[_, _, aim]| if aim > 0.0 { peak * aim.powf(exponent) } else { 0.0 },
                ),
                file: None,
            });
        }
        let (angle, edge): (f64, f64) = (70.0, 20.0);
        lamps.push(Lamp {
            name: "cone".into(),
            keys: format!("spot = {{ angle = {angle}, edge = {edge} }}\nintensity = {peak}\n"),
            extent,
            intensity: Box::new(move |[x, y, aim]| {
                let gamma = x.hypot(y).atan2(aim).to_degrees();
                let part = ((gamma - 0.5 * (angle - edge)) / edge).clamp(0.0, 1.0);
                peak * 0.5 * (1.0 + (std::f64::consts::PI * part).cos())
            }),
            file: None,
        });
    }
    lamps
}

pub(super) fn distributions() -> Vec<Trial> {
    (50..).zip(spots()).map(|(seed, lamp)| lamp.trial(seed, 12)).collect()
}

#[test]
fn spots_and_points_light_by_inverse_squares() {
    assert_fair(&quotients(&distributions(), WALKS, 800));
}
