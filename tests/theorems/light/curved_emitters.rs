//! Curved emitters alone, near and far, face on, at grazing angles and partly below the horizon, against quadrature
//! over their charts.

use std::f64::consts::PI;

use radiosity::light::penumbra::{Penumbra, RayEffort};
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity_geom::{DVec3, Rect, Surface};
use radiosity_test_support::direct::{ACCURACY, in_the_open};
use radiosity_test_support::random::Random;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::sources::Sources;

/// Points along each direction of the chart, and for the light that errors are compared with.
const GRID: usize = 240;
const COARSE: usize = 60;

/// Receivers of each emitter.
const RECEIVERS: usize = 60;

/// Part of the light, were the emitter as bright as face on and the receiver turned to it, of which light is as good as
/// [`ACCURACY`] in any case.
const DARK: f64 = 0.05;

/// Distance from the middle of an emitter from which its light has a closed form: more than twice its radius.
const FAR: f64 = 2.0;

/// Convex fronts of some 1 in size, of which nothing hides another part.
const SHAPES: &[(&str, &str)] = &[
    ("disk", "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 0.5 }"),
    ("ring", "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 0.5, inner_radius = 0.4 }"),
    ("sector", "disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 0.8, angle = [0, 200] }"),
    ("tube", "cylinder = { base = [0, 0, -0.5], axis = [0, 0, 1], radius = 0.1 }"),
    ("can", "cylinder = { base = [0, 0, -0.2], axis = [0, 0, 0.4], radius = 0.4 }"),
    ("gutter", "cylinder = { base = [0, 0, -0.5], axis = [0, 0, 1], radius = 0.3, angle = [0, 200] }"),
    ("ball", "sphere = { center = [0, 0, 0], radius = 0.5 }"),
    ("cap", "sphere = { center = [0, 0, 0], radius = 0.5, z = [0.2, 0.5] }"),
    ("frustum", "cone = { base = [0, 0, -0.3], axis = [0, 0, 0.6], radius1 = 0.5, radius2 = 0.2 }"),
    ("cone", "cone = { base = [0, 0, -0.3], axis = [0, 0, 0.6], radius1 = 0.5, radius2 = 0 }"),
    (
        "leaf",
        "bezier = { points = [[[-0.5, -0.1, 0], [-0.5, -0.05, 0], [-0.5, 0.05, 0], [-0.5, 0.1, 0]], \
         [[-0.4, -0.6, 0], [-0.2, -0.1, 0], [-0.2, 0.1, 0], [-0.4, 0.6, 0]], \
         [[0.1, -0.6, 0], [0.1, -0.1, 0], [0.1, 0.1, 0], [0.1, 0.6, 0]], \
         [[0.5, -0.1, 0], [0.5, -0.05, 0], [0.5, 0.05, 0], [0.5, 0.1, 0]]] }",
    ),
];

/// An emitter of exitance 1 alone.
fn shining(shape: &str) -> Scene {
    typed(&format!(
        "bands = [\"grey\"]\n[materials.lamp]\nreflectance = 0\nemission = 1\n[[surfaces]]\nname = \"lamp\"\n\
         material = \"lamp\"\n{shape}\n"
    ))
}

/// A luminaire that is a disk, of the intensity cosⁿ γ, and a far black ball.
fn downlight(exponent: f64) -> Scene {
    typed(&format!(
        "bands = [\"lm\"]\n[materials.black]\nreflectance = 0\n[[surfaces]]\nname = \"ball\"\nmaterial = \"black\"\n\
         sphere = {{ center = [0, 0, 900], radius = 1 }}\n[[luminaires]]\nposition = [0, 0, 0]\n\
         spot = {{ exponent = {exponent} }}\nintensity = 1\nextent = 1\n"
    ))
}

/// Irradiance by quadrature of a surface whose radiance is a function of the cosine to its normal.
fn quadrature(grid: usize, shape: &dyn Surface, radiance: impl Fn(f64) -> f64, x: DVec3, n: DVec3) -> f64 {
    let place = |k: usize| (2.0 * k as f64 + 1.0) / grid as f64 - 1.0;
    let part = |k: usize| {
        let jet = shape.jet(place(k / grid), place(k % grid));
        let step = jet.position - x;
        let (arriving, leaving) = (step.dot(n), -step.dot(jet.normal));
        if arriving <= 0.0 || leaving <= 0.0 {
            return 0.0;
        }
        let square = step.length_squared();
        radiance(leaving / square.sqrt()) * arriving * leaving * jet.area / (square * square)
    };
    (0..grid * grid).map(part).sum::<f64>() * 4.0 / (grid * grid) as f64
}

/// Receivers before the front of a surface, 0.2 to 30 of its sizes away, of any normal.
fn receivers(shape: &dyn Surface, random: &mut Random) -> Vec<(DVec3, DVec3)> {
    let receiver = || {
        let jet = shape.jet(0.9 * random.signed(), 0.9 * random.signed());
        let distance = random.power(-0.7, 1.5);
        let mut away = random.direction();
        if away.dot(jet.normal) < 0.0 {
            away = -away;
        }
        let towards = -(away + 0.05 * jet.normal).normalize();
        let normal = (towards + random.between(0.0, 1.5) * random.direction()).normalize();
        (jet.position - distance * towards, normal)
    };
    std::iter::repeat_with(receiver).take(RECEIVERS).collect()
}

/// Light by cells and closed forms at random receivers of surface `index`, against quadrature.
fn check(name: &str, scene: &Scene, index: usize, radiance: impl Fn(f64) -> f64 + Copy) {
    let shape = &*scene.surfaces[index].shape;
    let points = receivers(shape, &mut Random(index as u64 + name.len() as u64));
    let cells = in_the_open(scene, &Options::default(), &points, ACCURACY);
    let visibility = Options::default().visibility(scene);
    let sources = Sources::of(scene, &visibility);
    let emitters = sources.emitters();
    let forms = Penumbra::new(&emitters, &visibility, ACCURACY);
    let hull = shape.hull(&Rect::FULL);
    for ((x, n), by_cells) in points.into_iter().zip(cells) {
        let right = quadrature(GRID, shape, radiance, x, n);
        let facing = quadrature(COARSE, shape, |_| radiance(1.0), x, -x.normalize());
        let assert_right = |found: f64, by: &str| {
            let off = (found - right) / (right + DARK * facing);
            assert!(off.abs() < ACCURACY, "{name} from {x} towards {n} by {by}: {found}, not {right}");
        };
        assert_right(by_cells, "cells");
        let is_above = hull.iter().all(|y| (*y - x).dot(n) > 0.0);
        if !emitters.are_directed() && is_above && x.length() > FAR {
            let effort = RayEffort { error_factor: 1.0, sure: true };
            let estimate = forms.estimate(&ReceiverPoint::free(x, n), None, 0.0, effort);
            assert_right(estimate.factors.iter().map(|own| own.value).sum(), "a form");
        }
    }
}

#[test]
fn curved_emitters_alone_give_what_quadrature_says() {
    for (name, shape) in SHAPES {
        check(name, &shining(shape), 0, |_| 1.0 / PI);
    }
    for exponent in [0.0, 1.0, 2.0, 8.0] {
        let scene = downlight(exponent);
        let area = scene.surfaces[1].shape.area();
        check("spot", &scene, 1, |cosine: f64| cosine.powf(exponent - 1.0) / area);
    }
}
