//! Balances whose transfers rays carry: errors that are told, against rules; even fluxes; pockets without level.

use radiosity::Work;
use radiosity::heat::{Heat, HeatOptions, SurfaceHeat};
use radiosity::scene::Scene;
use radiosity::solve::{Options, Transport};
use radiosity_test_support::scenes::typed;

/// Part of the figures, at least, that are off by no more than so many told errors: halves of rays tell one only
/// roughly.
const MOST: f64 = 0.9;
const ROUGHLY: f64 = 1.5;
/// Told errors within which all lie.
const ALL: f64 = 3.0;

/// A cube of 1 m under a lid of 500 K, of two adiabatic walls; beside it a cube that is adiabatic as a whole.
fn cubes() -> Scene {
    let cube = |name: &str, at: f64, lid: &str, floor: &str| {
        let [low, high] = [at, at + 1.0];
        let wall = |side: &str, corners: [[f64; 3]; 4], known: &str| {
            format!(
                "[[surfaces]]\nname = \"{name}-{side}\"\nmaterial = \"paint\"\n{known}\npolygon = {{ vertices = {corners:?} }}\n"
            )
        };
        [
            wall("floor", [[low, 0.0, 0.0], [high, 0.0, 0.0], [high, 1.0, 0.0], [low, 1.0, 0.0]], floor),
            wall("lid", [[low, 0.0, 1.0], [low, 1.0, 1.0], [high, 1.0, 1.0], [high, 0.0, 1.0]], lid),
            wall(
                "west",
                [[low, 0.0, 0.0], [low, 1.0, 0.0], [low, 1.0, 1.0], [low, 0.0, 1.0]],
                "adiabatic = true",
            ),
            wall(
                "east",
                [[high, 0.0, 0.0], [high, 0.0, 1.0], [high, 1.0, 1.0], [high, 1.0, 0.0]],
                "adiabatic = true",
            ),
            wall("south", [[low, 0.0, 0.0], [low, 0.0, 1.0], [high, 0.0, 1.0], [high, 0.0, 0.0]], floor),
            wall("north", [[low, 1.0, 0.0], [high, 1.0, 0.0], [high, 1.0, 1.0], [low, 1.0, 1.0]], floor),
        ]
        .concat()
    };
    let paint = "[materials.paint]\nemissivity = 0.6\n".to_owned();
    let hot = cube("hot", 0.0, "temperature = 500", "temperature = 300");
    typed(&[paint, hot, cube("still", 3.0, "adiabatic = true", "adiabatic = true")].concat())
}

fn by(transport: Transport, rays: Option<u64>) -> Heat {
    let options = Options { transport, rays, threads: 2, ..HeatOptions::default().options };
    Heat::of(&cubes(), &HeatOptions { options, conductances: false }, &Work::alone())
        .expect("it has a balance")
}

/// The errors of the figures that are not given, over those that are told.
fn over_told(found: &SurfaceHeat, right: &SurfaceHeat) -> Vec<f64> {
    let flow = (found.flow - right.flow).abs() / found.flow_error;
    let temperature = (found.temperature - right.temperature).abs() / found.temperature_error;
    let is_found = [!found.is_flow_known, !found.is_temperature_known];
    [flow, temperature]
        .into_iter()
        .zip(is_found)
        .filter_map(|(own, is_found)| is_found.then_some(own))
        .collect()
}

#[test]
fn rays_err_by_what_they_tell() {
    let right = by(Transport::Exact, None);
    let mut all = Vec::new();
    for rays in [2_000, 5_000, 10_000, 20_000, 50_000] {
        let found = by(Transport::Sampled, Some(rays));
        assert!(
            found.outcome.choice.sampled && found.outcome.sampling.is_some_and(|own| own.error.is_some())
        );
        let pairs = found.surfaces.iter().zip(&right.surfaces).filter(|(own, _)| own.has_level());
        all.extend(pairs.flat_map(|(own, right)| over_told(own, right)));
    }
    all.sort_by(f64::total_cmp);
    let within = all.iter().filter(|own| **own <= ROUGHLY).count() as f64 / all.len() as f64;
    let [largest, median] = [all.len() - 1, all.len() / 2].map(|place| all[place]);
    assert!(within >= MOST && largest <= ALL && median > 0.1, "{within} of {all:?}");
}

#[test]
fn rules_carry_what_they_end_soon() {
    assert!(!by(Transport::Auto, None).outcome.choice.sampled);
    let given = by(Transport::Auto, Some(20_000));
    assert!(
        given.outcome.choice.sampled
            && given.outcome.solution.elements().list().iter().all(|own| own.basis.len() == 1)
    );
}

/// Nothing sets the level of the second cube, which takes no part.
#[test]
fn pockets_without_a_level_end_no_balance() {
    let found = by(Transport::Sampled, Some(20_000));
    assert_eq!(found.without_level.len(), 6);
    assert!(found.outcome.converged);
}
