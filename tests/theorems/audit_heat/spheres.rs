//! Concentric spheres with and without shields between them: resistances in series (Modest, chapter 5).

use std::f64::consts::PI;

use super::scored::{SEEN, Scored, apart, heat, heat_of, level, of};

/// Radii of inner and outer sphere, of emissivities 0.8 and 0.6 and at 500 and 300 K.
const RADII: [f64; 2] = [1.0, 2.0];

/// Emissivities of the inner and the outer side of shields.
const FOIL: [f64; 2] = [0.1, 0.2];

/// Power (W) that a heated shield sends out.
const HEATED: f64 = 3000.0;

const WALKS: f64 = 2048.0;

fn area(radius: f64) -> f64 {
    4.0 * PI * radius * radius
}

/// The spheres, the inner one of this condition, and what stands between them.
fn spheres(inner: &str, between: &str) -> String {
    let [foil_inner, foil_outer] = FOIL;
    format!(
        r#"
        materials.hot = {{ emissivity = 0.8, {inner} }}
        materials.cold = {{ emissivity = 0.6, temperature = 300 }}
        materials.in = {{ emissivity = {foil_inner} }}
        materials.out = {{ emissivity = {foil_outer} }}
        [[surfaces]]
        name = "inner"
        material = "hot"
        sphere = {{ center = [0, 0, 0], radius = 1 }}
        [[surfaces]]
        name = "outer"
        material = "cold"
        flip = true
        sphere = {{ center = [0, 0, 0], radius = 2 }}
        {between}
        "#
    )
}

/// A shield of this radius and condition.
fn shield(radius: f64, condition: &str) -> String {
    format!(
        r#"
        [[surfaces]]
        name = "shield {radius}"
        material = "out"
        back_material = "in"
        two_sided = true
        {condition}
        sphere = {{ center = [0, 0, 0], radius = {radius} }}
        "#
    )
}

/// The nodes between the levels of inner and outer sphere: shields of these radii.
struct Series {
    /// Resistances between neighbouring levels (m⁻²).
    resistances: Vec<f64>,
}

impl Series {
    fn of(shields: &[f64]) -> Self {
        let radii = [&[RADII[0]], shields, &[RADII[1]]].concat();
        let count = radii.len();
        let surface = |emissivity: f64, radius: f64| (1.0 - emissivity) / (emissivity * area(radius));
        let resistance = |k: usize| {
            let leaving = if k == 0 { 0.8 } else { FOIL[1] };
            let arriving = if k + 2 == count { 0.6 } else { FOIL[0] };
            surface(leaving, radii[k]) + 1.0 / area(radii[k]) + surface(arriving, radii[k + 1])
        };
        Self { resistances: (0..count - 1).map(resistance).collect() }
    }

    fn total(&self) -> f64 {
        self.resistances.iter().sum()
    }

    /// The level of a shield by which this flow passes.
    fn level(&self, shield: usize, flow: f64) -> f64 {
        level(500.0) - flow * self.resistances[..=shield].iter().sum::<f64>()
    }
}

#[test]
fn walks_find_the_flow_between_spheres() {
    let mut scored = Scored::default();
    let resistance = Series::of(&[]).total();
    let flow = (level(500.0) - level(300.0)) / resistance;
    for seed in 0..60 {
        let known = heat(&spheres("temperature = 500", ""), WALKS, seed);
        scored.add("inner", &of(&known, "inner").flow, flow);
        scored.add("outer", &of(&known, "outer").flow, -flow);
        let heated = heat(&spheres("heat_flux = 1000", ""), WALKS, 1000 + seed);
        let inner = of(&heated, "inner");
        scored.add("inner", &inner.level, level(300.0) + 1000.0 * area(1.0) * resistance);
        scored.add("outer", &of(&heated, "outer").flow, -1000.0 * area(1.0));
        assert!(inner.flux.error == 0.0 && inner.flux.value == 1000.0);
    }
    scored.check(240);
}

#[test]
fn walks_pass_one_shield_and_several() {
    for shields in [&[1.5][..], &[1.2, 1.5, 1.8]] {
        let mut scored = Scored::default();
        let between: String = shields.iter().map(|radius| shield(*radius, "adiabatic = true")).collect();
        let series = Series::of(shields);
        let flow = (level(500.0) - level(300.0)) / series.total();
        for seed in 0..30 {
            let found = heat(&spheres("temperature = 500", &between), WALKS, seed);
            scored.add("inner", &of(&found, "inner").flow, flow);
            scored.add("outer", &of(&found, "outer").flow, -flow);
            for (k, radius) in shields.iter().enumerate() {
                let side = of(&found, &format!("shield {radius}"));
                scored.add("side", &side.flow, flow);
                scored.add("level", &side.level, series.level(k, flow));
                let kelvin = (series.level(k, flow) / level(1.0)).powf(0.25);
                assert!(apart(&side.temperature, kelvin) < 10.0, "{:?} for {kelvin}", side.temperature);
            }
        }
        scored.check(30 * (2 + 2 * shields.len()));
    }
}

#[test]
fn a_heated_shield_sends_its_heat_both_ways() {
    let series = Series::of(&[1.5]);
    let [to_inner, to_outer] = [0, 1].map(|k| 1.0 / series.resistances[k]);
    // Its own level is where what it gets from inside and is given goes outside.
    let found = (HEATED + to_inner * level(500.0) + to_outer * level(300.0)) / (to_inner + to_outer);
    let inward = to_inner * (found - level(500.0));
    let mut scored = Scored::default();
    let flux = format!("heat_flux = {}", HEATED / area(1.5));
    for seed in 0..60 {
        let all = heat(&spheres("temperature = 500", &shield(1.5, &flux)), WALKS, seed);
        scored.add("inner", &of(&all, "inner").flow, -inward);
        scored.add("inside", &of(&all, "shield 1.5:back").flow, inward);
        scored.add("outer", &of(&all, "outer").flow, inward - HEATED);
        scored.add("level", &of(&all, "shield 1.5").level, found);
    }
    scored.check(240);
}

#[test]
fn an_emissivity_that_is_off_by_a_hundredth_is_seen() {
    let inner = heat_of("inner", &spheres("temperature = 500", ""), 65536.0, 0).flow;
    let right = (level(500.0) - level(300.0)) / Series::of(&[]).total();
    // As of an emissivity of 0.808 instead of 0.8.
    let surface = |emissivity: f64| (1.0 - emissivity) / (emissivity * area(1.0));
    let wrong =
        (level(500.0) - level(300.0)) / (Series::of(&[]).total() - surface(0.8) + surface(1.01 * 0.8));
    assert!(apart(&inner, right) < SEEN, "{inner:?} for {right}");
    assert!(apart(&inner, wrong) > SEEN, "{inner:?} for {wrong}");
}

#[test]
fn a_shield_of_two_temperatures_is_seen() {
    // Sides that are adiabatic each by itself let no heat through, and come to the levels beside them.
    let found = heat(&spheres("temperature = 500", &shield(1.5, "adiabatic = true")), WALKS, 0);
    let [inside, outside] = ["shield 1.5:back", "shield 1.5"].map(|name| of(&found, name));
    for (own, split) in [(inside, 500.0), (outside, 300.0)] {
        assert!(apart(&own.temperature, split) > SEEN, "{:?} for {split}", own.temperature);
        assert!(apart(&own.flow, 0.0) > SEEN, "{:?} for 0", own.flow);
    }
    assert_eq!(inside.temperature, outside.temperature);
}
