//! Zones of a sphere: what leaves any part of its inside falls evenly on all of it, so that the balance of
//! any conditions is one equation.
//!
//! ```text
//! F_ij = f_j ,   H = Σ f_j J_j ,   H (Σ_T f ε + f_open) = Σ_T f ε σ T⁴ + Σ_q f q
//! ```
//!
//! with the parts f of the area (Modest, section 4.8: the inside of a sphere).

use std::fmt::Write;

use radiosity_test_support::random::Random;

use super::scored::{Scored, heat, level, of};

/// The known quantity of a zone.
#[derive(Clone, Copy)]
enum Known {
    Kelvin(f64),
    Flux(f64),
    /// It is not there.
    Open,
}

/// A zone between two heights of the unit sphere.
struct Zone {
    heights: [f64; 2],
    emissivity: f64,
    known: Known,
}

impl Zone {
    /// Its part of the area.
    fn part(&self) -> f64 {
        0.5 * (self.heights[1] - self.heights[0])
    }

    fn add_to(&self, text: &mut String, name: &str) {
        let condition = match self.known {
            Known::Kelvin(kelvin) => format!("temperature = {kelvin}"),
            Known::Flux(flux) => format!("heat_flux = {flux}"),
            Known::Open => return,
        };
        let (emissivity, heights) = (self.emissivity, self.heights);
        let written = write!(
            text,
            r#"
            [[surfaces]]
            name = "{name}"
            material = "{name}"
            flip = true
            sphere = {{ center = [0.3, 0.1, 2], radius = 1, axis = [1, 2, 3], z = {heights:?} }}
            [materials."{name}"]
            emissivity = {emissivity}
            {condition}
            "#
        );
        written.expect("strings take all");
    }
}

/// Two to six zones, the first of known temperature.
fn zones(random: &mut Random) -> Vec<Zone> {
    let count = 2 + random.below(5);
    let mut ends: Vec<f64> = (1..count).map(|_| random.signed()).collect();
    ends.extend([-1.0, 1.0]);
    ends.sort_by(f64::total_cmp);
    let zone = |(k, ends): (usize, &[f64])| {
        let known = match random.below(4) {
            choice if choice < 2 || k == 0 => Known::Kelvin(random.between(200.0, 900.0)),
            2 => Known::Flux(random.pick(&[0.0, 300.0, 1000.0])),
            _ => Known::Open,
        };
        Zone { heights: [ends[0], ends[1]], emissivity: random.between(0.1, 1.0), known }
    };
    ends.windows(2).enumerate().map(zone).collect()
}

/// The irradiance of all zones.
fn irradiance(zones: &[Zone]) -> f64 {
    let (mut given, mut taken) = (0.0, 0.0);
    for zone in zones {
        let part = zone.part();
        match zone.known {
            Known::Kelvin(kelvin) => {
                given += part * zone.emissivity * level(kelvin);
                taken += part * zone.emissivity;
            }
            Known::Flux(flux) => given += part * flux,
            Known::Open => taken += part,
        }
    }
    given / taken
}

#[test]
fn walks_find_any_balance_within_a_sphere() {
    let mut random = Random(0x5EED);
    let mut scored = Scored::default();
    for seed in 0..80 {
        let zones = zones(&mut random);
        let mut text = String::new();
        zones.iter().enumerate().for_each(|(k, zone)| zone.add_to(&mut text, &format!("zone {k}")));
        let exact = irradiance(&zones);
        let found = heat(&text, 2048.0, seed);
        for (k, zone) in zones.iter().enumerate() {
            let name = format!("zone {k}");
            match zone.known {
                Known::Kelvin(kelvin) => {
                    let flux = zone.emissivity * (level(kelvin) - exact);
                    scored.add(&name, &of(&found, &name).flux, flux);
                }
                Known::Flux(flux) => {
                    scored.add(&name, &of(&found, &name).level, exact + flux / zone.emissivity);
                }
                Known::Open => {}
            }
        }
    }
    scored.check(200);
}
