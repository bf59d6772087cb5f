//! Skies and the sun through windows: the radiance of the standard skies and the transmittance of glass, written
//! down anew, summed over the opening as the point sees it, cut at the horizon.

use std::f64::consts::{FRAC_PI_2, PI};

use radiosity::audit::{Judged, Verdict};
use radiosity_geom::DVec3;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;

use super::fairness::assert_fair;
use super::trial::{Trial, quotients};

const WALKS: f64 = 512.0;

/// Illuminance of level ground, reflectance of the ground, illuminance across the beam of the sun.
const LEVEL: f64 = 9000.0;
const GROUND: f64 = 0.3;
const BEAM: f64 = 50_000.0;

/// Midpoints along each side of each part of an opening.
const SIDE: usize = 150;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Model {
    Uniform,
    Overcast,
    Clear,
}

/// A sky over the ground.
#[derive(Clone, Copy, Debug)]
struct Outside {
    model: Model,
    up: DVec3,
    /// Direction to the sun, and its illuminance.
    sun: Option<(DVec3, f64)>,
    /// ∫ l cos Z dω.
    whole: f64,
}

impl Outside {
    /// The sky of that model over the horizon of `up`; the sun stands 40° high in the south-east.
    fn of(model: Model, up: DVec3, beam: f64) -> Self {
        let up = up.normalize();
        let north = (DVec3::Y - DVec3::Y.dot(up) * up).normalize();
        let east = north.cross(up);
        let [high, azimuth]: [f64; 2] = [40.0_f64.to_radians(), 150.0_f64.to_radians()];
        let sun = high.sin() * up + high.cos() * (azimuth.cos() * north + azimuth.sin() * east);
        let has_sun = model == Model::Clear || beam > 0.0;
        let sky = Self { model, up, sun: has_sun.then_some((sun, beam)), whole: 1.0 };
        let (x, y) = up.any_orthonormal_pair();
        const COUNT: usize = 1000;
        let mut whole = 0.0;
        for k in 0..COUNT * COUNT {
            let [square, turn] = [k / COUNT, k % COUNT].map(|own| (own as f64 + 0.5) / COUNT as f64);
            // Even by cos Z dω / π.
            let (sine, cosine) = (2.0 * PI * turn).sin_cos();
            let from = square.sqrt() * (cosine * x + sine * y) + (1.0 - square).sqrt() * up;
            whole += PI / (COUNT * COUNT) as f64 * sky.relative(from);
        }
        Self { whole, ..sky }
    }

    /// Relative radiance above the horizon (ISO 15469, types 5, 16 and 12).
    fn relative(&self, from: DVec3) -> f64 {
        let cosine = from.dot(self.up);
        match self.model {
            Model::Uniform => 1.0,
            Model::Overcast => (1.0 + 2.0 * cosine) / 3.0,
            Model::Clear => {
                let chi = self.sun.map_or(0.0, |(sun, _)| from.dot(sun).clamp(-1.0, 1.0).acos());
                let near =
                    1.0 + 10.0 * ((-3.0 * chi).exp() - (-3.0 * FRAC_PI_2).exp()) + 0.45 * chi.cos().powi(2);
                near * (1.0 - (-0.32 / cosine).exp())
            }
        }
    }

    fn radiance(&self, from: DVec3) -> f64 {
        if from.dot(self.up) > 0.0 {
            return LEVEL * self.relative(from) / self.whole;
        }
        let beam = self.sun.map_or(0.0, |(sun, beam)| beam * sun.dot(self.up));
        GROUND * (LEVEL + beam) / PI
    }

    fn text(&self) -> String {
        let model = format!("{:?}", self.model).to_lowercase();
        let sun = self.sun.map_or(String::new(), |(_, beam)| {
            format!("sun = {{ elevation = 40, azimuth = 150, illuminance = {beam:?} }}\n")
        });
        let up = self.up.to_array();
        format!(
            "[sky]\nmodel = \"{model}\"\nilluminance = {LEVEL:?}\nground = {GROUND:?}\nup = {up:?}\n{sun}"
        )
    }
}

/// Transmittance of two panes of the index 1.5, of which the glass itself absorbs as much as makes it 0.7 along
/// the normal (Fresnel; Duffie and Beckman, section 5.3).
fn glass(cosine: f64) -> f64 {
    let bare = |cosine: f64| {
        let sine = (1.0 - cosine * cosine).max(0.0).sqrt();
        let inner = (sine / 1.5).asin();
        let outer = cosine.acos();
        let [across, along] = if outer < 1e-4 {
            [0.04, 0.04]
        } else {
            [
                ((inner - outer).sin() / (inner + outer).sin()).powi(2),
                ((inner - outer).tan() / (inner + outer).tan()).powi(2),
            ]
        };
        (0.5 * ((1.0 - across) / (1.0 + 3.0 * across) + (1.0 - along) / (1.0 + 3.0 * along)), inner.cos())
    };
    let (straight, _) = bare(1.0);
    let (through, inner) = bare(cosine);
    through * (0.7 / straight).powf(1.0 / inner)
}

/// A rectangular opening whose front is along `a` × `b`.
#[derive(Clone, Copy, Debug)]
struct Window {
    corner: DVec3,
    a: DVec3,
    b: DVec3,
    has_glass: bool,
}

impl Window {
    fn front(&self) -> DVec3 {
        self.a.cross(self.b).normalize()
    }

    fn through(&self, cosine: f64) -> f64 {
        if self.has_glass { glass(cosine) } else { 1.0 }
    }

    /// Irradiance of a point before the window that nothing hides; the part of the window above the horizon and
    /// the part below are summed by themselves, by lines along `a` that are cut where they cross it.
    fn irradiance(&self, sky: &Outside, point: DVec3, normal: DVec3) -> f64 {
        let at = |k: usize| (k as f64 + 0.5) / SIDE as f64;
        let front = self.front();
        let mut sum = 0.0;
        for line in 0..SIDE {
            let start = self.corner + at(line) * self.b - point;
            // Height over the point: h + s d for s in [0, 1].
            let (h, d) = (start.dot(sky.up), self.a.dot(sky.up));
            let cut = (-h / d).clamp(0.0, 1.0);
            let cut = if cut.is_finite() { cut } else { 0.0 };
            for [low, high] in [[0.0, cut], [cut, 1.0]] {
                for k in 0..SIDE {
                    let step = start + (low + at(k) * (high - low)) * self.a;
                    let squared = step.length_squared();
                    let from = step / squared.sqrt();
                    let leaving = -front.dot(from);
                    let cosine = normal.dot(from).max(0.0);
                    let light = sky.radiance(from) * self.through(leaving) * cosine * leaving / squared;
                    sum += (high - low) / (SIDE * SIDE) as f64 * light;
                }
            }
        }
        let sun = sky.sun.map_or(0.0, |(sun, beam)| self.sun(sun, beam, point, normal));
        self.a.cross(self.b).length() * sum + sun
    }

    /// The irradiance by the middles of 6 × 6 cells, each all sky or all ground.
    fn uncut(&self, sky: &Outside, point: DVec3, normal: DVec3) -> f64 {
        let part = |k: usize| (k as f64 + 0.5) / 6.0;
        let front = self.front();
        let light = |k: usize| {
            let step = self.corner + part(k % 6) * self.a + part(k / 6) * self.b - point;
            let squared = step.length_squared();
            let from = step / squared.sqrt();
            sky.radiance(from) * normal.dot(from).max(0.0) * -front.dot(from) / squared
        };
        self.a.cross(self.b).length() / 36.0 * (0..36).map(light).sum::<f64>()
    }

    fn sun(&self, sun: DVec3, beam: f64, point: DVec3, normal: DVec3) -> f64 {
        let front = self.front();
        let leaving = -front.dot(sun);
        let far = (self.corner - point).dot(front) / sun.dot(front);
        let place = point + far * sun - self.corner;
        let part = |side: DVec3| place.dot(side) / side.length_squared();
        let is_seen =
            leaving > 0.0 && far > 0.0 && [self.a, self.b].iter().all(|own| (0.0..1.0).contains(&part(*own)));
        if is_seen { beam * self.through(leaving) * normal.dot(sun).max(0.0) } else { 0.0 }
    }

    /// A window of perpendicular sides, alone.
    fn scene(&self, sky: &Outside) -> radiosity::Scene {
        let [corner, a, b] = [self.corner, self.a, self.b].map(|own| own.to_array());
        let pane = if self.has_glass {
            "glass = { panes = 2, index = 1.5, transmittance = 0.7 }"
        } else {
            "opening = true"
        };
        typed(&format!(
            "bands = [\"lm\"]\n{}\n[materials.pane]\nreflectance = 0\n[[surfaces]]\nname = \"window\"\n\
             material = \"pane\"\n{pane}\nparallelogram = {{ origin = {corner:?}, edge1 = {a:?}, edge2 = {b:?} }}\n",
            sky.text()
        ))
    }
}

fn trial(model: Model, up: DVec3, beam: f64, window: Window, seed: u64) -> Trial {
    let sky = Outside::of(model, up, beam);
    let mut random = Random(seed);
    let name = format!("{model:?} {up} {beam} glass {}", window.has_glass);
    let mut trial = Trial::of(name, window.scene(&sky));
    let middle = window.corner + 0.5 * (window.a + window.b);
    for _ in 0..14 {
        let away = window.front() + 0.7 * random.direction();
        let point = middle + random.between(0.8, 4.0) * away.normalize();
        let normal = (middle - point).normalize() + 0.8 * random.direction();
        trial = trial.point(point, normal, window.irradiance(&sky, point, normal.normalize()));
    }
    trial
}

pub(super) fn windows() -> Vec<Trial> {
    // A window to the south, its front to the north; a skylight; one that leans.
    let south = |has_glass| Window {
        corner: DVec3::new(-1.0, 0.0, 0.8),
        a: 1.5 * DVec3::Z,
        b: 2.0 * DVec3::X,
        has_glass,
    };
    let roof = |has_glass| Window { corner: DVec3::new(-1.0, 0.0, 3.0), a: DVec3::Y, b: DVec3::X, has_glass };
    let slope = DVec3::new(0.0, -0.6, 0.8);
    let leaning =
        |has_glass| Window { corner: DVec3::new(-1.0, 1.0, 1.0), a: slope, b: 1.3 * DVec3::X, has_glass };
    let mut trials = Vec::new();
    for model in [Model::Uniform, Model::Overcast, Model::Clear] {
        for window in [south(false), south(true), roof(false), roof(true), leaning(true)] {
            for beam in [0.0, BEAM] {
                let up = if window.has_glass { DVec3::Z } else { DVec3::new(0.1, -0.2, 1.0) };
                trials.push(trial(model, up, beam, window, trials.len() as u64));
            }
        }
    }
    trials
}

#[test]
fn windows_give_what_their_skies_send() {
    assert_fair(&quotients(&windows(), WALKS, 900));
}

/// A rule over cells of the opening that the horizon crosses, at sensors at the height of eyes: errors of both signs,
/// up to a tenth.
#[test]
fn a_horizon_that_is_not_cut_is_found() {
    let sky = Outside::of(Model::Overcast, DVec3::Z, 0.0);
    let window =
        Window { corner: DVec3::new(-1.0, 0.0, 0.8), a: 1.5 * DVec3::Z, b: 2.0 * DVec3::X, has_glass: false };
    let trial = Trial::of("horizon", window.scene(&sky));
    let normal = window.front();
    let points: Vec<DVec3> = (0..64)
        .map(|k| DVec3::new(f64::from(k % 8) * 0.3 - 1.0, 0.0, 1.2 + f64::from(k / 8) * 0.1) + 2.0 * normal)
        .collect();
    let trial = points
        .iter()
        .fold(trial, |own, point| own.point(*point, -normal, window.irradiance(&sky, *point, -normal)));
    let verdict = |printed: &dyn Fn(usize) -> f64| {
        let judge = |(k, estimate)| Judged {
            printed: vec![printed(k)],
            printed_groups: Vec::new(),
            estimate,
            size: 1.0,
            class: "plane".to_owned(),
        };
        let judged: Vec<Judged> = trial.estimates(1024.0, 5).into_iter().enumerate().map(judge).collect();
        Verdict::of(&judged, 3)
    };
    let right = verdict(&|k| trial.exact[k][0]);
    assert!(!right.finds(0.0), "{right:?}");
    let uncut = |k: usize| window.uncut(&sky, points[k], -normal);
    let off = |k: usize| (uncut(k) - trial.exact[k][0]).powi(2);
    let true_error =
        ((0..64).map(off).sum::<f64>() / trial.exact.iter().map(|own| own[0] * own[0]).sum::<f64>()).sqrt();
    let wrong = verdict(&uncut);
    assert!(wrong.finds(0.0) && wrong.exceeds(0.0), "{wrong:?}");
    assert!((wrong.error() - true_error).abs() < 0.1 * true_error, "{} {true_error}", wrong.error());
}
