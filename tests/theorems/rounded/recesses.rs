//! Boxes in recesses, over gaps from 1e-7 of their size: no row misses 1 by more than it tells.
//!
//! The recess is closed, so all rows add up to 1. Of the bottom of the box, the side a, over that of the recess, the
//! gap d, all but what leaves through the slit at its four sides is caught: 1 − 2 d/a ≤ F ≤ 1.

use std::f64::consts::FRAC_PI_3;

use radiosity::solve::view_factors::ViewFactors;
use radiosity::visibility::Shadows;
use radiosity_test_support::solved::factors_of;

use crate::rounded::sheet::{Sheet, cuboid, scene};

/// Accuracy asked.
const EPS: f64 = 1e-6;

/// Factor by which errors may exceed those told.
const TOLD: f64 = 3.0;

/// A box of half the height of a unit recess, π/3 times as far from its sides and its bottom.
fn recess(gap: f64) -> Vec<Sheet> {
    let mut walls = cuboid("recess", [0.0; 3], [1.0; 3], &[]);
    // Not a few units of the last decimal of the scene: these are rounding.
    let gap = gap * FRAC_PI_3;
    walls.iter_mut().for_each(|wall| wall.corners.reverse());
    [cuboid("box", [gap; 3], [1.0 - gap, 1.0 - gap, 0.5 + gap], &[]), walls].concat()
}

fn found(gap: f64) -> ViewFactors {
    factors_of(&scene(&recess(gap)).expect("a scene"), Shadows::Auto, EPS, EPS)
}

/// Errors of the rows of these surfaces, and those told of them.
fn rows(found: &ViewFactors, of: &str) -> Vec<(f64, f64)> {
    let sums = found.row_sums().into_iter().zip(&found.errors).zip(&found.names);
    sums.filter(|(_, name)| name.starts_with(of)).map(|((sum, told), _)| ((1.0 - sum).abs(), *told)).collect()
}

/// The rows of `of` miss 1 by no more than they tell.
fn hold(found: &ViewFactors, of: &str, gap: f64) {
    for (off, told) in rows(found, of) {
        assert!(off <= TOLD * told + 1e-14, "{gap:e}: a row of the {of} is off by {off:e}, told {told:e}");
    }
}

#[test]
fn boxes_in_recesses_see_them_over_thin_gaps() {
    for gap in [1e-7, 3e-7, 1e-6, 1e-5] {
        let found = found(gap);
        hold(&found, "box", gap);
        if gap >= 1e-6 {
            hold(&found, "recess", gap);
        }
        let place = |name: &str| found.names.iter().position(|own| own == name).expect("its name");
        let (bottom, below) = (place("box-bottom"), place("recess-bottom"));
        let (factor, told) = (found.factor(bottom, below), found.errors[bottom]);
        let least = 1.0 - 2.0 * FRAC_PI_3 * gap / (1.0 - 2.0 * FRAC_PI_3 * gap);
        assert!(factor >= least - TOLD * told - 1e-14, "{gap:e}: {factor} of {least}, told {told:e}");
        assert!(factor <= 1.0 + 1e-14, "{gap:e}: {factor}");
    }
}

#[test]
fn rows_of_recesses_tell_what_they_miss() {
    let gap = 3e-2;
    hold(&found(gap), "recess", gap);
}
