//! Balls with something within: what is inside is not seen from outside, nor the other way round, and what stands
//! across a ball is seen where it is out.
//!
//! A ball of the radius r and the exitance M lights a plane that faces it from the distance d of its centre by
//! E = M (r/d)².

use radiosity::light::direct::DirectLight;
use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::Scene;
use radiosity::solve::Options;
use radiosity_geom::DVec3 as V;
use radiosity_test_support::compare::assert_close;
use radiosity_test_support::direct::in_the_open;
use radiosity_test_support::scenes::typed;
use radiosity_test_support::sources::Sources;

const EPS: f64 = 1e-3;

/// Radii of the bulb and of the globe.
const BULB: f64 = 0.1;
const GLOBE: f64 = 0.4;

/// A far panel of exitance 1 above.
const PANEL: &str = "[[surfaces]]\nname = \"panel\"\nmaterial = \"lamp\"\n\
                     parallelogram = { origin = [-1, -1, 2], edge1 = [0, 2, 0], edge2 = [2, 0, 0] }\n";

/// A black globe, seen from both sides, about the origin, a bulb of exitance 1 at `x`, and the panel.
fn scene(bulb: Option<f64>, globe: bool) -> Scene {
    typed(&format!("{}{PANEL}", alone(bulb, globe)))
}

/// The text of the scene without the panel.
fn alone(bulb: Option<f64>, globe: bool) -> String {
    let bulb = bulb.map_or_else(String::new, |x| {
        format!("[[surfaces]]\nname = \"bulb\"\nmaterial = \"lamp\"\nsphere = {{ center = [{x}, 0, 0], radius = {BULB} }}\n")
    });
    let globe = match globe {
        true => format!(
            "[[surfaces]]\nname = \"globe\"\nmaterial = \"black\"\ntwo_sided = true\n\
             sphere = {{ center = [0, 0, 0], radius = {GLOBE} }}\n"
        ),
        false => String::new(),
    };
    format!(
        "bands = [\"grey\"]\n[materials.black]\nreflectance = 0\n[materials.lamp]\nreflectance = 0\nemission = 1\n\
         {bulb}{globe}"
    )
}

fn read(scene: &Scene, x: V, n: V) -> f64 {
    in_the_open(scene, &Options::default(), &[(x, n)], EPS)[0]
}

/// Between the bulb and the globe there is the light of the bulb alone, and outside that of the panel alone, to the
/// last bit.
#[test]
fn globes_keep_light_in_and_out() {
    let lamp = scene(Some(0.0), true);
    for distance in [0.11, 0.2, 0.39] {
        let x = distance * V::new(0.6, 0.0, 0.8);
        assert_close(read(&lamp, x, -x.normalize()), (BULB / distance).powi(2), EPS);
        assert_eq!(read(&lamp, x, x.normalize()), 0.0, "from {x}, outwards");
    }
    let empty = scene(None, true);
    for x in [V::new(0.0, 0.0, -0.6), V::new(0.5, 0.2, -0.4), V::new(0.41, 0.0, 0.0), V::new(1.0, 0.0, -1.0)]
    {
        for n in [V::Z, -x.normalize()] {
            let (full, right) = (read(&lamp, x, n), read(&empty, x, n));
            assert!(full == right, "{x} towards {n}: {full}, not {right}");
        }
    }
    let open = scene(None, false);
    let x = V::new(0.3, 0.2, -0.6);
    assert!(read(&empty, x, V::Z) < 0.99 * read(&open, x, V::Z), "the globe hides a part of the panel");
}

/// A bulb that sticks out of the globe, by less than it measures across or more, lights what is on that side.
#[test]
fn what_stands_across_a_globe_is_seen() {
    for place in [GLOBE, 0.5 * BULB + GLOBE, GLOBE - 0.5 * BULB] {
        let lamp = typed(&alone(Some(place), true));
        let (x, distance) = (V::new(2.0, 0.0, 0.0), 2.0 - place);
        let all = (BULB / distance).powi(2);
        let found = read(&lamp, x, -V::X);
        // Of the bulb that is half within, the outer half is seen, and no more shows its front.
        if place >= GLOBE {
            assert_close(found, all, EPS);
        } else {
            assert!(found > 0.5 * all && found < all, "{found} of {all}");
        }
        assert!(read(&lamp, -x, V::X) == 0.0);
    }
}

/// Within the globe nothing hides the bulb, and the panel asks for no shadows.
#[test]
fn what_is_shut_out_is_no_emitter() {
    let lamp = scene(Some(0.0), true);
    let visibility = Options::default().visibility(&lamp);
    let sources = Sources::of(&lamp, &visibility);
    let direct = DirectLight::within(&sources.emitters(), &visibility, EPS);
    let within = ReceiverPoint::free(V::new(0.0, 0.0, -0.3), V::Z);
    assert!(direct.is_smooth(&within.site(), &direct.around(&within.site())), "something stands there");
}
