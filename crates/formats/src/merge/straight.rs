//! Corners in the middle of straight sides.

use super::boundary::Merged;
use super::corners::Corners;
use crate::tolerances::{ROUNDINGS_OF_SIDE, TURN_OF_SIDES};

/// Rounds of taking corners back into sides that would bend: one is enough but for gentle curves.
/// After so many all corners stay.
const ROUNDS: usize = 16;

/// Drops corners at which every surface that has one there goes straight on; so no other surface keeps a
/// corner in the middle of a side. Of `count` surfaces those that are not merged keep all their corners.
pub(super) fn straighten(merged: &mut [Merged], corners: &Corners, count: usize) {
    let mut may_go = droppable(merged, corners, count);
    let mut rounds = 0;
    while bent(merged, corners, &mut may_go) {
        rounds += 1;
        if rounds == ROUNDS {
            return;
        }
    }
    for ring in merged.iter_mut().flat_map(|merged| &mut merged.loops) {
        ring.retain(|corner| !may_go[*corner as usize]);
    }
}

/// Whether, at each corner, all surfaces that have it go straight on.
fn droppable(merged: &[Merged], corners: &Corners, count: usize) -> Vec<bool> {
    let mut may_go = vec![true; corners.count()];
    let mut is_merged = vec![false; count];
    merged.iter().flat_map(|merged| &merged.surfaces).for_each(|surface| is_merged[*surface] = true);
    for surface in (0..count).filter(|surface| !is_merged[*surface]) {
        corners.of(surface).iter().for_each(|corner| may_go[*corner as usize] = false);
    }
    for ring in merged.iter().flat_map(|merged| &merged.loops) {
        for (index, corner) in ring.iter().enumerate() {
            let before = ring[(index + ring.len() - 1) % ring.len()];
            let after = ring[(index + 1) % ring.len()];
            may_go[*corner as usize] &= goes_straight([before, *corner, after], corners);
        }
    }
    may_go
}

/// Whether a side goes straight on at the middle one of three corners.
fn goes_straight(three: [u32; 3], corners: &Corners) -> bool {
    let [a, b, c] = three.map(|corner| corners.point(corner));
    let turn = (b - a).normalize_or_zero().distance((c - b).normalize_or_zero());
    turn <= TURN_OF_SIDES && is_on([three[0], three[2]], three[1], corners)
}

/// Whether a corner lies on the side between two, to rounding.
fn is_on([a, c]: [u32; 2], b: u32, corners: &Corners) -> bool {
    let rounding = corners.rounding(&[a, b, c]);
    let [a, b, c] = [a, b, c].map(|corner| corners.point(corner));
    (b - a).reject_from_normalized((c - a).normalize_or_zero()).length() <= ROUNDINGS_OF_SIDE * rounding
}

/// Takes corners back whose sides would bend without them. Whether there were any.
fn bent(merged: &[Merged], corners: &Corners, may_go: &mut [bool]) -> bool {
    let mut is_changed = false;
    for ring in merged.iter().flat_map(|merged| &merged.loops) {
        let stays: Vec<usize> = (0..ring.len()).filter(|index| !may_go[ring[*index] as usize]).collect();
        if stays.len() < 3 {
            let goes = ring.iter().filter(|corner| may_go[**corner as usize]).count();
            ring.iter().for_each(|corner| may_go[*corner as usize] = false);
            is_changed |= goes > 0;
            continue;
        }
        for (start, end) in stays.iter().zip(stays.iter().cycle().skip(1)) {
            let steps = (end + ring.len() - start - 1) % ring.len();
            let between = || (1..=steps).map(|step| ring[(start + step) % ring.len()]);
            let ends = [ring[*start], ring[*end]];
            if !between().all(|corner| is_on(ends, corner, corners)) {
                between().for_each(|corner| may_go[corner as usize] = false);
                is_changed = true;
            }
        }
    }
    is_changed
}
