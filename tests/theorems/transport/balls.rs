//! Balls between surfaces, in rooms and in spheres, and bodies in spheres: found by outlines, without rays.
//!
//! In a closed scene all that leaves a point arrives somewhere: Σ_j K_ij 1 = 1 at each point of i, that is
//! Σ_j G_ij c_j = c_i with the coefficients c of the constant 1, for every polynomial.

use proptest::prelude::*;
use proptest::test_runner::TestRunner;
use radiosity::kernel::Accuracy;
use radiosity::scene::Scene;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_test_support::random::seeded;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::solved::{blocks_of, elements_of, factors_of};

use crate::transport::flat::elements;

/// A scene of these surfaces, each begun by @.
fn scene(surfaces: &str) -> Scene {
    let surfaces = surfaces.replace('@', "[[surfaces]]\nmaterial = \"grey\"\n");
    typed(&format!("materials.grey = {{ reflectance = 0.5 }}\n{surfaces}"))
}

/// Largest |Σ_j G_ij c_j − c_i| over √A_i, and the number of rays sent.
fn openness(scene: &Scene, order: usize, eps: f64) -> (f64, u64) {
    let elements = elements(scene, order).expect("all have area");
    let visibility = Visibility::new(scene, Shadows::Auto, eps);
    let blocks = blocks_of(&elements, &visibility, Accuracy { eps, shadow_eps: eps });
    let constant = elements.constant();
    let arrives = blocks.apply(&constant);
    let starts = elements.starts();
    let mut worst = 0.0f64;
    for (element, start) in elements.list().iter().zip(starts) {
        let range = start..start + element.basis.len();
        let off = range.map(|k| (arrives[k] - constant[k]).abs()).fold(0.0, f64::max);
        worst = worst.max(off / element.area.sqrt());
    }
    (worst, blocks.statistics.rays)
}

/// Checks each scene at orders and accuracies, and that no ray is sent but in some of them.
fn check(cases: &[(&str, String)], cases_by_rays: &[&str]) {
    for (name, surfaces) in cases {
        let scene = scene(surfaces);
        let by_rays = cases_by_rays.contains(name);
        let asked = [(0, 1e-3), (0, 1e-5), (2, 1e-3), (2, 1e-4)];
        for (order, eps) in asked.into_iter().take(if by_rays { 1 } else { asked.len() }) {
            let (open, rays) = openness(&scene, order, eps);
            println!("{name}, order {order}, {eps:.0e}: {open:.1e}, {rays} rays");
            assert!(open < eps, "{name}, order {order}, {eps:.0e}: open by {open:.1e}");
            assert!(rays == 0 || by_rays, "{name}: {rays} rays");
        }
    }
}

const ROOM: &str = "@box = { origin = [-1,-1,-1], size = [2,2.5,2], inward = true }\n\
                    @sphere = { center = [0.2,0.1,-0.3], radius = 0.4 }\n";

/// Walls see each other past balls, and past balls and blocks.
#[test]
fn walls_see_each_other_past_balls() {
    let with = |more: &str| format!("{ROOM}{more}\n");
    check(
        &[
            ("one ball", with("")),
            (
                "a ball of two sides",
                with("@two_sided = true\nsphere = { center = [0.1,0.9,0.4], radius = 0.2 }"),
            ),
            ("two balls", with("@sphere = { center = [0.1,0.9,0.4], radius = 0.2 }")),
            ("a ball on the floor", with("@sphere = { center = [0.4,0.9,-0.75], radius = 0.25 }")),
            (
                "a ball and a block",
                with("@box = { origin = [-0.8,0.6,-1], size = [0.5,0.4,1.2], open = [\"bottom\"] }"),
            ),
        ],
        &["two balls", "a ball on the floor"],
    );
}

/// The inside of a sphere sees itself past balls and bodies.
#[test]
fn insides_of_spheres_see_each_other_past_bodies() {
    let around =
        |inner: &str| format!("@flip = true\nsphere = {{ center = [0,0,0], radius = 1 }}\n{inner}\n");
    let two = "@sphere = { center = [0.3,-0.1,0.2], radius = 0.3 }\n\
               @sphere = { center = [-0.4,0.1,-0.2], radius = 0.25 }";
    let shield = "@two_sided = true\nsphere = { center = [0,0,0], radius = 0.7 }\n\
                  @sphere = { center = [0.1,0,0], radius = 0.4 }";
    let plate = "@two_sided = true\n\
                 parallelogram = { origin = [-0.3,-0.2,0.1], edge1 = [0.6,0,0.1], edge2 = [0,0.5,0] }";
    check(
        &[
            ("concentric", around("@sphere = { center = [0,0,0], radius = 0.5 }")),
            ("beside the centre", around("@sphere = { center = [0.2,-0.1,0.25], radius = 0.45 }")),
            ("two balls", around(two)),
            ("a shield", around(shield)),
            ("a box", around("@box = { origin = [-0.3,-0.2,-0.4], size = [0.5,0.6,0.7] }")),
            ("a plate", around(plate)),
        ],
        &["two balls"],
    );
}

/// From a ball of radius r all that is sent meets the sphere of radius R around it, which sees the ball by
/// (r/R)² and itself by the rest, wherever the ball is if the sphere is even: the error falls with what is asked.
#[test]
fn concentric_spheres_see_each_other_as_exactly_as_asked() {
    let scene = scene(
        "@sphere = { center = [0,0,0], radius = 0.5 }\n@flip = true\nsphere = { center = [0,0,0], radius = 1 }\n",
    );
    for eps in [1e-2, 1e-4, 1e-6, 1e-8] {
        let found = factors_of(&scene, Shadows::Auto, eps, eps);
        for (from, to, exact) in [(0, 1, 1.0), (1, 0, 0.25), (1, 1, 0.75)] {
            let off = (found.factor(from, to) - exact).abs();
            assert!(off <= 3.0 * eps, "{eps:.0e}, {from} to {to}: off by {off:.1e}");
        }
        assert_eq!(found.rays, 0);
    }
}

/// A ball anywhere within a sphere takes all that leaves it, by their areas, however narrow the gap: by a
/// closed form, in sums that do not grow without an end.
#[test]
fn balls_within_spheres_are_known_at_any_gap() {
    for (radius, off_centre) in [(0.2, 0.9), (0.9, 0.0), (0.99, 0.5), (0.999, 0.0), (0.999, 0.9)] {
        let place = 0.6 * off_centre * (1.0 - radius);
        let scene = scene(&format!(
            "@sphere = {{ center = [{place},0,{place}], radius = {radius} }}\n\
             @flip = true\nsphere = {{ center = [0,0,0], radius = 1 }}\n"
        ));
        let found = factors_of(&scene, Shadows::Auto, 1e-8, 1e-8);
        let share = radius * radius;
        for (from, to, exact) in [(0, 1, 1.0), (1, 0, share), (1, 1, 1.0 - share)] {
            let off = (found.factor(from, to) - exact).abs();
            assert!(off <= 3e-8, "radius {radius}, off by {place}, {from} to {to}: off by {off:.1e}");
        }
        assert!(found.rays == 0 && found.samples < 20_000_000, "{radius}: {} samples", found.samples);
    }
}

/// A plate through a sphere parts it: of even light a share f² + (1 − f)² stays, f the share of its area above. What
/// sticks out hides nothing more.
#[test]
fn a_plate_through_a_sphere_parts_it() {
    let scene = scene(
        "@parallelogram = { origin = [-1,-1,0], edge1 = [2,0,0], edge2 = [0,2,0] }\n\
         @flip = true\nsphere = { center = [0,0,0.1], radius = 0.4 }\n",
    );
    let found = factors_of(&scene, Shadows::Auto, 1e-3, 1e-3);
    let above = 0.5 / 0.8f64;
    let exact = above * above + (1.0 - above) * (1.0 - above);
    let off = (found.factor(1, 1) - exact).abs();
    assert!(off < 2e-3, "off by {off:.1e}");
}

/// A plate above the equator of a sphere. A point below the plate sees all of the sphere that is below it, by the
/// share of area: of the upper elements the zone up to the plate, h/2, evenly. A point above sees no lower element.
#[test]
fn elements_of_a_sphere_see_past_a_plate_what_is_on_their_side() {
    let (height, eps) = (0.3, 3e-3);
    let scene = scene(&format!(
        "@parallelogram = {{ origin = [-1,-1,{height}], edge1 = [2,0,0], edge2 = [0,2,0] }}\n\
         @flip = true\nsphere = {{ center = [0,0,0], radius = 1 }}\n"
    ));
    for order in [0, 1] {
        let elements = elements_of(&scene, order, 2);
        let visibility = Visibility::new(&scene, Shadows::Auto, eps);
        let blocks = blocks_of(&elements, &visibility, Accuracy { eps, shadow_eps: eps });
        assert!(blocks.statistics.rays > 0, "order {order}: no ray is sent");
        let is_upper = |surface: usize, v: [f64; 2]| surface == 1 && v[0] > -1e-9;
        let is_lower = |surface: usize, v: [f64; 2]| surface == 1 && v[1] < 1e-9;
        let lit = |is_lit: &dyn Fn(usize, [f64; 2]) -> bool| {
            let ones = elements.constant();
            let mut lit = vec![0.0; ones.len()];
            for (element, start) in elements.list().iter().zip(elements.starts()) {
                if is_lit(element.surface, element.rect.v) {
                    lit[start] = ones[start];
                }
            }
            blocks.apply(&lit)
        };
        let (by_upper, by_lower) = (lit(&is_upper), lit(&is_lower));
        println!(
            "order {order}: {} rays, {:.1e} told",
            blocks.statistics.rays, blocks.statistics.accuracy_reached
        );
        let mut seen = [0, 0];
        for (element, start) in elements.list().iter().zip(elements.starts()) {
            let side = element.area.sqrt();
            if is_lower(element.surface, element.rect.v) {
                seen[0] += 1;
                for k in 0..element.basis.len() {
                    let exact = if k == 0 { 0.5 * height } else { 0.0 };
                    let off = (by_upper[start + k] / side - exact).abs();
                    assert!(off < eps, "order {order}, entry {k} of a lower element: off by {off:.1e}");
                }
            } else if is_upper(element.surface, element.rect.v) {
                seen[1] += 1;
                let off = (by_lower[start] / side - 0.5 * height).abs();
                assert!(off < eps, "order {order}, an upper element: off by {off:.1e}");
            }
        }
        assert!(seen[0] > 0 && seen[1] > 0, "the equator parts no elements");
    }
}

/// Random balls in a room: what walls send arrives at walls and balls.
#[test]
fn random_balls_hide_what_they_take() {
    let place = prop::array::uniform3(-0.6..0.6f64);
    let runner = &mut TestRunner::new(seeded(12, 60));
    runner
        .run(&(place, 0.05..0.38f64), |([x, y, z], radius)| {
            let ball = format!("@sphere = {{ center = [{x},{y},{z}], radius = {radius} }}\n");
            let room = "@box = { origin = [-1,-1,-1], size = [2,2,2], inward = true }\n";
            let (open, rays) = openness(&scene(&format!("{room}{ball}")), 1, 1e-3);
            prop_assert!(open < 1e-3 && rays == 0, "open by {open:.1e}, {rays} rays");
            Ok(())
        })
        .expect("all that leaves arrives");
}
