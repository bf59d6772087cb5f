//! Fronts that face the wrong way.

use std::collections::HashSet;

use radiosity_geom::{Aabb, DVec3};
use rayon::prelude::*;

use crate::inspection::{
    sheet::{Sheet, Sheets},
    shell::{Fronts, Group, Shell},
    warning::Warning,
};
use crate::scene::Camera;

/// Fronts that disagree with their neighbours'.
pub(super) fn turned(sheets: &Sheets, groups: &[Group]) -> Vec<Warning> {
    let warning = |(own, other): &(usize, usize)| {
        let [own, other] = [own, other].map(|k| &sheets.list[*k].name);
        let message = format!(
            "turns its front to the other side than {other:?}, which it meets along a border: flip = true turns it over"
        );
        Warning::about("front-turned", own, message)
    };
    groups.iter().flat_map(|group| &group.turned).map(warning).collect()
}

/// Solids whose fronts face in, and rooms whose fronts face out.
pub(super) fn inside_out(sheets: &Sheets, shells: &[Shell], camera: Option<&Camera>) -> Vec<Warning> {
    let warning = |shell: &Shell| {
        let is_inside = |point: DVec3| shell.encloses(sheets, point);
        let mut others = (0..sheets.list.len()).filter(|k| shell.sheets.binary_search(k).is_err()).peekable();
        let stands_alone = others.peek().is_none();
        let holds_something = camera.is_some_and(|camera| is_inside(camera.eye))
            || others.any(|k| is_inside(sheets.list[k].samples()[0].0));
        let emits = shell.sheets.iter().any(|k| sheets.list[*k].emits);
        let first = &sheets.list[shell.sheets[0]].name;
        match shell.fronts {
            Fronts::Outside if holds_something => Some(Warning::about(
                "front-outside",
                first,
                format!(
                    "{}, faces away from what is in it: flip = true turns a surface over",
                    part_of(shell)
                ),
            )),
            Fronts::Inside if !holds_something && !stands_alone && !emits => Some(Warning::about(
                "front-inside",
                first,
                format!(
                    "{}, faces into a closed space with no light in it: flip = true turns a surface over",
                    part_of(shell)
                ),
            )),
            _ => None,
        }
    };
    shells.iter().filter_map(warning).collect()
}

fn part_of(shell: &Shell) -> String {
    match shell.sheets.len() {
        1 => "closed in itself".to_owned(),
        count => format!("with {} others a closed surface", count - 1),
    }
}

/// Fronts that face no other front, according to sampled points; blockers are not considered, and what is
/// `lying` on another surface faces that one.
pub(super) fn blind(sheets: &Sheets, lying: &HashSet<&str>) -> Vec<Warning> {
    let samples: Vec<_> = sheets.list.iter().map(Sheet::samples).collect();
    // If the other lies wholly behind this plane, no pair of points has to be tested.
    let reaches = |own: usize, other: usize| {
        let is_flat = sheets.list[own].shape.region().is_some();
        !is_flat || lies_before(&samples[own][0], &sheets.list[other].bounds)
    };
    let sees = |own: usize, other: usize| {
        let behind = sheets.list[other].two_sided;
        reaches(own, other)
            && (behind || reaches(other, own))
            && samples[own].iter().any(|x| samples[other].iter().any(|y| faces(x, y, behind)))
    };
    let is_blind =
        |own: usize| !sheets.list[own].two_sided && !(0..sheets.list.len()).any(|other| sees(own, other));
    if sheets.list.len() < 2 {
        return Vec::new();
    }
    let blind: Vec<usize> = (0..sheets.list.len()).into_par_iter().filter(|own| is_blind(*own)).collect();
    let message = "faces no other front, it neither lights nor is lit: flip = true turns it over";
    let names = blind.into_iter().map(|own| &sheets.list[own].name);
    names
        .filter(|name| !lying.contains(name.as_str()))
        .map(|name| Warning::about("front-blind", name, message.to_owned()))
        .collect()
}

/// Whether a part of a box lies in front of the plane through the point x with the normal n.
fn lies_before((x, n): &(DVec3, DVec3), bounds: &Aabb) -> bool {
    let half = 0.5 * (bounds.max - bounds.min);
    (bounds.center() - *x).dot(*n) + half.dot(n.abs()) > 0.0
}

/// Whether the fronts at two points face each other, with a sine of at least 1e-6 (chosen, not tuned); the second's
/// back counts too if it is `two_sided`.
fn faces((x, n): &(DVec3, DVec3), (y, m): &(DVec3, DVec3), two_sided: bool) -> bool {
    const GRAZING: f64 = 1e-6;
    let d = *y - *x;
    let (out, into) = (d.dot(*n), -d.dot(*m));
    let least = GRAZING * d.length();
    out > least && (into > least || two_sided && -into > least)
}
