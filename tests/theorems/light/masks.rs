//! Shadow masks: direct light as polynomials without shadows times what part of the emitter is seen.

use std::num::NonZeroUsize;

use radiosity::Work;
use radiosity::light::direct::DirectLight;
use radiosity::published::zatz1993::masking::{Average, Masking};
use radiosity::reading::grid::{Cell, Rates, grid};
use radiosity::reading::reader::{ReadMode, Reader};
use radiosity::scene::Scene;
use radiosity::solve::{Direct, Options, Outcome};
use radiosity::visibility::Shadows;
use radiosity_test_support::direct::ACCURACY;
use radiosity_test_support::scenes::builtin;
use radiosity_test_support::solved::outcome_of;

fn cells(count: usize) -> NonZeroUsize {
    NonZeroUsize::new(count).expect("more than none")
}

fn solved(scene: &Scene, masks: Option<Masking>) -> Outcome {
    let options = Options { order: 6, masks, direct: Direct::Projected, ..Options::default() };
    outcome_of(scene, &options)
}

fn weighted(count: usize) -> Option<Masking> {
    Some(Masking { cells: cells(count), average: Average::Weighted })
}

/// Means over 16 × 16 cells.
fn means(scene: &Scene, outcome: &Outcome, read: ReadMode) -> Vec<Cell> {
    let visibility = Options::default().visibility(scene);
    let reader = Reader::new(&outcome.solution, &visibility, read, 1e-3);
    grid(&reader, [16, 16], Rates::default(), &Work::alone())
}

/// Relative L2 difference over the floor.
fn difference(scene: &Scene, ours: &[Cell], exact: &[Cell]) -> f64 {
    let floor = scene.surface_named("floor").expect("there is a floor");
    let both = || ours.iter().zip(exact).filter(|(cell, _)| cell.surface == floor);
    let sum = |term: &dyn Fn(&Cell, &Cell) -> f64| both().map(|(a, b)| a.area * term(a, b)).sum::<f64>();
    let error = sum(&|a, b| (a.irradiance[0] - b.irradiance[0]).powi(2));
    (error / sum(&|_, b| b.irradiance[0].powi(2))).sqrt()
}

/// A panel between lamp and floor: polynomials ring at the edge of its shadow, masks have the edge.
#[test]
fn masks_keep_the_shadow_of_a_panel() {
    let scene = builtin("occluder-box");
    let plain = solved(&scene, None);
    let exact = means(&scene, &plain, ReadMode::Direct);
    let ringing = difference(&scene, &means(&scene, &plain, ReadMode::Basis), &exact);
    let masked = difference(&scene, &means(&scene, &solved(&scene, weighted(40)), ReadMode::Basis), &exact);
    assert!(masked < 0.25 * ringing, "{masked} {ringing}");
}

/// The plain average of the paper forgets that the near parts of an emitter weigh more.
#[test]
fn the_papers_average_is_coarser() {
    let scene = builtin("occluder-box");
    let plain = solved(&scene, None);
    let exact = means(&scene, &plain, ReadMode::Direct);
    let [weighted, paper] = [Average::Weighted, Average::Plain].map(|average| {
        let masks = Masking { cells: cells(40), average };
        difference(&scene, &means(&scene, &solved(&scene, Some(masks)), ReadMode::Basis), &exact)
    });
    assert!(2.0 * weighted < paper && paper < 0.1);
}

/// At the nodes of a mask, light is that of the emitter without shadows times the part that is seen: to what
/// the polynomials of the unshadowed light leave.
#[test]
fn nodes_carry_the_share_that_is_seen() {
    let scene = builtin("occluder-box");
    let outcome = solved(&scene, weighted(20));
    let solution = &outcome.solution;
    let list = solution.elements().list();
    let [visibility, open] = [Shadows::Auto, Shadows::Off]
        .map(|shadows| (Options { shadows, ..Options::default() }).visibility(&scene));
    let [seen, free] = [&visibility, &open].map(|v| DirectLight::within(&solution.emitters(), v, ACCURACY));
    let floor = scene.surface_named("floor").expect("there is a floor");
    let element = solution.elements().of_surface(floor).start;
    let normal = list[element].plane.expect("it is flat").normal;
    let bounds = list[element].bounds();
    let masked = solution.masked().expect("masks");
    let mut half_shadows = 0;
    for (i, j) in (0..21).flat_map(|i| (0..21).map(move |j| (i, j))) {
        let place = [i, j].map(|k| f64::from(k) / 20.0);
        let x = bounds.min + (bounds.max - bounds.min) * radiosity_geom::DVec3::new(place[0], place[1], 0.0);
        let share = seen.at(element, x, normal)[0] / free.at(element, x, normal)[0];
        let light = masked.at(0, list, element, x, [0.0, 0.0]);
        let unshadowed = free.at(element, x, normal)[0];
        assert!((light - share * unshadowed).abs() <= 5e-3 * unshadowed, "{light} {share} {unshadowed}");
        half_shadows += u32::from(0.1 < share && share < 0.9);
    }
    assert!(half_shadows > 20, "{half_shadows} nodes in half-shadow");
}

#[test]
fn nothing_is_masked_where_nothing_stands_between() {
    let scene = builtin("empty-box");
    let masked = solved(&scene, weighted(10));
    assert!(masked.solution.masked().expect("asked for").is_plain());
    let plain = solved(&scene, None);
    let [a, b] = [&masked, &plain].map(|outcome| means(&scene, outcome, ReadMode::Basis));
    // Light reflected once is gathered on one side and transported by polynomials on the other.
    assert!(difference(&scene, &a, &b) < 3e-3);
}
