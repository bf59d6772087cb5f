//! Light of openings whose radiance jumps at the horizon, against quadrature that is cut there.
//!
//! ```text
//! E = ∫ L(ω) cos θ cos θ' / d² dA ,     L = E_h l(ω)/∫ l cos Z dω above the horizon, ρ_g E_h/π below it
//! ```

#![expect(clippy::print_stdout, reason = "how far readings are off is printed with --nocapture")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use radiosity::elements::rule::UnitRule;
use radiosity::light::direct::DirectLight;
use radiosity::light::penumbra::{Penumbra, RayEffort};
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity_geom::DVec3 as V;
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::sources::Sources;

/// Accuracy of readings by default.
const EPS: f64 = 1.25e-3;

/// Illuminance of level ground (lx).
const LEVEL: f64 = 1000.0;

/// Relative radiance of a sky over its horizon.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Model {
    Uniform,
    Overcast,
    /// Clear, with the sun at this elevation and azimuth, in degrees.
    Clear([f64; 2]),
}

#[derive(Clone, Copy, Debug)]
struct Sky {
    model: Model,
    ground: f64,
}

const SKIES: [Sky; 6] = [
    Sky { model: Model::Uniform, ground: 0.2 },
    Sky { model: Model::Uniform, ground: 0.7 },
    Sky { model: Model::Overcast, ground: 0.2 },
    Sky { model: Model::Overcast, ground: 0.0 },
    Sky { model: Model::Clear([60.0, 180.0]), ground: 0.2 },
    Sky { model: Model::Clear([15.0, 350.0]), ground: 0.3 },
];

impl Sky {
    fn text(&self) -> String {
        let model = match self.model {
            Model::Uniform => "model = \"uniform\"".to_owned(),
            Model::Overcast => "model = \"overcast\"".to_owned(),
            Model::Clear([elevation, azimuth]) => {
                format!("model = \"clear\"\nsun = {{ elevation = {elevation}, azimuth = {azimuth} }}")
            }
        };
        format!("[sky]\n{model}\nilluminance = {LEVEL}\nground = {}\n", self.ground)
    }

    /// The direction to a sun about which the radiance has a tip.
    fn sun(&self) -> Option<V> {
        let Model::Clear(degrees) = self.model else { return None };
        let [elevation, azimuth] = degrees.map(f64::to_radians);
        Some(V::new(azimuth.sin() * elevation.cos(), azimuth.cos() * elevation.cos(), elevation.sin()))
    }

    /// l above the horizon.
    fn relative(&self, from: V) -> f64 {
        match (self.model, self.sun()) {
            (Model::Overcast, _) => (1.0 + 2.0 * from.z) / 3.0,
            (Model::Clear(_), Some(sun)) => {
                let chi = from.dot(sun).clamp(-1.0, 1.0).acos();
                let f =
                    1.0 + 10.0 * ((-3.0 * chi).exp() - (-3.0 * FRAC_PI_2).exp()) + 0.45 * chi.cos().powi(2);
                f * (1.0 - (-0.32 / from.z).exp())
            }
            _ => 1.0,
        }
    }

    /// ∫ l cos Z dω.
    fn level(&self) -> f64 {
        match self.model {
            Model::Uniform => PI,
            Model::Overcast => 7.0 * PI / 9.0,
            Model::Clear(_) => {
                let (rings, turns) = (600, 1200);
                let ring = |k: usize| {
                    let z = ((k as f64 + 0.5) / rings as f64).sqrt();
                    let sine = (1.0 - z * z).sqrt();
                    let at = |j: usize| {
                        let (sin, cos) = (TAU * (j as f64 + 0.5) / turns as f64).sin_cos();
                        self.relative(V::new(sine * cos, sine * sin, z))
                    };
                    (0..turns).map(at).sum::<f64>()
                };
                PI * (0..rings).map(ring).sum::<f64>() / (rings * turns) as f64
            }
        }
    }
}

/// A window, its front towards the room, with a bar before it or without.
#[derive(Clone, Debug)]
struct Window {
    origin: V,
    edges: [V; 2],
    bar: Option<[V; 4]>,
}

impl Window {
    /// A window that faces the south, upright or turned and tilted.
    fn random(random: &mut Random, upright: bool) -> Self {
        let (turn, tilt) = if upright { (0.0, 0.0) } else { (0.5 * random.signed(), 0.6 * random.signed()) };
        let along = V::new(turn.cos(), turn.sin(), 0.0);
        let level = V::new(turn.sin(), -turn.cos(), 0.0);
        let up = tilt.cos() * V::Z + tilt.sin() * level;
        let [width, height] = [random.between(0.5, 4.0), random.between(0.5, 2.5)];
        let origin = V::new(random.signed(), 3.0, random.between(0.0, 1.5));
        Self { origin, edges: [width * along, height * up], bar: None }
    }

    fn normal(&self) -> V {
        self.edges[0].cross(self.edges[1]).normalize()
    }

    fn at(&self, s: f64, t: f64) -> V {
        self.origin + s * self.edges[0] + t * self.edges[1]
    }

    fn corners(&self) -> Vec<V> {
        [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[s, t]| self.at(s, t)).to_vec()
    }

    fn scene(&self, sky: &Sky) -> Scene {
        let print = |x: &V| format!("[{}, {}, {}]", x.x, x.y, x.z);
        let [along, up] = &self.edges;
        let bar = self.bar.map_or_else(String::new, |bar| {
            let corners: Vec<String> = bar.iter().map(print).collect();
            format!(
                "[[surfaces]]\nname = \"bar\"\nmaterial = \"air\"\ntwo_sided = true\nquad = {{ vertices = [{}] }}\n",
                corners.join(", ")
            )
        });
        typed(&format!(
            "bands = [\"lm\"]\n{}[materials.air]\nreflectance = 0\n[[surfaces]]\nname = \"window\"\nmaterial = \"air\"\n\
             opening = true\nparallelogram = {{ origin = {}, edge1 = {}, edge2 = {} }}\n{bar}",
            sky.text(),
            print(&self.origin),
            print(along),
            print(up),
        ))
    }

    /// A sensor before the window that faces a point of it, more or less, mostly at the height of some of it.
    fn sensor(&self, random: &mut Random) -> (V, V) {
        let opposite = self.at(random.between(-0.3, 1.3), random.between(-0.3, 1.3));
        let x = opposite + random.between(0.2, 5.0) * self.normal();
        let towards = (self.at(random.unit(), random.unit()) - x).normalize();
        let aside = V::new(random.signed(), random.signed(), random.signed());
        (x, (towards + 0.6 * aside).normalize())
    }

    /// E at `x` with the normal `n`, by pieces cut at the horizon and at the shadow of the bar.
    fn irradiance(&self, sky: &Sky, level: f64, x: V, n: V) -> f64 {
        let whole = clipped(&self.corners(), x, n);
        let shadow = self.bar.map_or_else(Vec::new, |bar| {
            (0..4).fold(whole.clone(), |part, k| {
                let side = (bar[k] - x).cross(bar[(k + 1) % 4] - x);
                let middle: V = bar.iter().sum::<V>() / 4.0;
                clipped(&part, x, side * (middle - x).dot(side).signum())
            })
        });
        let from = |part: &[V]| self.of_part(sky, part, x, n);
        let ([sky, ground], [hidden, under]) = (from(&whole), from(&shadow));
        LEVEL * ((sky - hidden) / level + ground - under)
    }

    /// ∫ l and ∫ ρ_g/π, times cos θ cos θ' / d², over a convex part of the window.
    fn of_part(&self, sky: &Sky, part: &[V], x: V, n: V) -> [f64; 2] {
        let above =
            Piece { x, n, front: self.normal(), sun: sky.sun(), radiance: &|from| sky.relative(from) };
        let below = Piece { sun: None, radiance: &|_| sky.ground / PI, ..above };
        [above.polygon(&clipped(part, x, V::Z)), below.polygon(&clipped(part, x, -V::Z))]
    }
}

/// The part of a convex polygon on the side of a plane through `x` that `inward` points to.
fn clipped(polygon: &[V], x: V, inward: V) -> Vec<V> {
    let mut kept = Vec::new();
    for (k, a) in polygon.iter().enumerate() {
        let b = polygon[(k + 1) % polygon.len()];
        let [low, high] = [*a, b].map(|y| (y - x).dot(inward));
        if low >= 0.0 {
            kept.push(*a);
        }
        if low * high < 0.0 {
            kept.push(a.lerp(b, low / (low - high)));
        }
    }
    kept
}

/// The integrand over a part of the window.
#[derive(Clone, Copy)]
struct Piece<'a> {
    x: V,
    n: V,
    front: V,
    sun: Option<V>,
    radiance: &'a dyn Fn(V) -> f64,
}

impl Piece<'_> {
    fn polygon(&self, corners: &[V]) -> f64 {
        (2..corners.len()).map(|k| self.triangle([corners[0], corners[k - 1], corners[k]])).sum()
    }

    /// By Gauss's rule with the corner a collapsed, in triangles that are small beside their distance, and
    /// about the sun smaller still.
    fn triangle(&self, [a, b, c]: [V; 3]) -> f64 {
        let middle = (a + b + c) / 3.0;
        let size = a.distance(b).max(b.distance(c)).max(c.distance(a));
        let ratio = size / middle.distance(self.x);
        let towards = (middle - self.x).normalize();
        let has_sun = self.sun.is_some_and(|sun| towards.distance(sun) < 1.5 * ratio);
        if ratio > 0.4 || (has_sun && ratio > 2e-3) {
            let [d, e, f] = [a.midpoint(b), b.midpoint(c), c.midpoint(a)];
            return [[a, d, f], [d, b, e], [f, e, c], [d, e, f]].map(|part| self.triangle(part)).iter().sum();
        }
        let twice = (b - a).cross(c - a).length();
        let rule = UnitRule::of(5);
        let row = |(s, ws): (f64, f64)| {
            let at = |(t, wt): (f64, f64)| wt * self.density(a + s * (b.lerp(c, t) - a));
            s * ws * rule.iter().map(at).sum::<f64>()
        };
        twice * rule.iter().map(row).sum::<f64>()
    }

    fn density(&self, y: V) -> f64 {
        let step = y - self.x;
        let cosines = self.n.dot(step).max(0.0) * -self.front.dot(step);
        (self.radiance)(step.normalize()) * cosines / step.length_squared().powi(2)
    }
}

/// Largest relative errors, by cells and as in pictures, of sensors before windows under each sky.
fn errors(windows: &[Window], sensors: usize, random: &mut Random) -> Vec<[f64; 2]> {
    let mut worst = vec![[0.0_f64; 2]; SKIES.len()];
    let levels = SKIES.map(|sky| sky.level());
    for window in windows {
        let places: Vec<(V, V)> = (0..sensors).map(|_| window.sensor(random)).collect();
        for ((sky, worst), level) in SKIES.iter().zip(&mut worst).zip(levels) {
            let scene = window.scene(sky);
            let visibility = Options::default().visibility(&scene);
            let sources = Sources::of(&scene, &visibility);
            let sources = sources.emitters();
            let cells = DirectLight::within(&sources, &visibility, EPS);
            let pictures = Penumbra::new(&sources, &visibility, EPS);
            for (x, n) in &places {
                let receiver = ReceiverPoint::free(*x, *n);
                let effort = RayEffort { error_factor: 1.0, sure: true };
                let factors = pictures.estimate(&receiver, None, 0.0, effort).factors;
                let exitance = |element: usize| sources.coatings[0].exitance[element];
                let in_picture: f64 = factors.iter().map(|own| own.value * exitance(own.element)).sum();
                let by_cells = cells.irradiance(&receiver, &cells.around(&receiver.site()))[0];
                let exact = window.irradiance(sky, level, *x, *n);
                let off = [by_cells, in_picture].map(|found| (found / exact - 1.0).abs());
                *worst = [worst[0].max(off[0]), worst[1].max(off[1])];
            }
        }
    }
    worst
}

#[track_caller]
fn check(errors: &[[f64; 2]]) {
    for (sky, [by_cells, in_picture]) in SKIES.iter().zip(errors) {
        println!("{sky:?}: {by_cells:.1e} by cells, {in_picture:.1e} in pictures");
        let most = if sky.model == Model::Uniform { 1e-6 } else { 1e-3 };
        assert!(*by_cells < most && *in_picture < most, "{sky:?}: {by_cells:e}, {in_picture:e}");
    }
}

/// Windows, so many upright and as many turned and tilted.
fn windows(half: usize, random: &mut Random) -> Vec<Window> {
    (0..2 * half).map(|k| Window::random(random, k < half)).collect()
}

/// The radiance of a uniform sky over even ground has a closed form on either side of the horizon; that of
/// other skies is found to the accuracy of readings.
#[test]
fn openings_are_cut_at_the_horizon() {
    let random = &mut Random(1);
    let windows = windows(10, random);
    check(&errors(&windows, 25, random));
}

/// A bar across the window hides sky and ground alike.
#[test]
fn bars_are_cut_out_on_both_sides_of_the_horizon() {
    let random = &mut Random(3);
    let mut windows = windows(1, random);
    for window in &mut windows {
        let at = |s, t| window.at(s, t) + 0.1 * window.normal();
        window.bar = Some([at(-0.1, 0.4), at(1.1, 0.45), at(1.1, 0.55), at(-0.1, 0.5)]);
    }
    check(&errors(&windows, 6, random));
}
