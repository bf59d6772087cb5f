//! Fronts that face the wrong way.

use std::collections::HashSet;

use radiosity_geom::{Aabb, Bvh, Plane};
use radiosity_scene::Scene;
use rayon::prelude::*;

use crate::inspection::{
    enclosure::Enclosure,
    sheet::{Sheet, Sheets},
    shell::{Fronts, Group, Shell},
    warning::{Warning, by_keys},
};

/// Least sine of the angles at which one front sees another: fronts in one plane, but for rounding in single
/// precision, do not see each other.
const GRAZING: f64 = 1e-6;

/// Fronts that disagree with their neighbours'.
pub(super) fn turned(scene: &Scene, sheets: &Sheets, groups: &[Group]) -> Vec<Warning> {
    let cure = by_keys(scene, "flip = true turns it over");
    let warning = |(own, other): &(usize, usize)| {
        let [own, other] = [own, other].map(|k| &sheets.list[*k].name);
        let message = format!(
            "turns its front to the other side than {other:?}, which it meets along a border: {cure}"
        );
        Warning::about("front-turned", own, message)
    };
    groups.iter().flat_map(|group| &group.turned).map(warning).collect()
}

/// Solids whose fronts face in, and rooms whose fronts face out.
pub(super) fn inside_out(scene: &Scene, sheets: &Sheets, shells: &[Shell]) -> Vec<Warning> {
    let cure = by_keys(scene, "flip = true turns a surface over");
    // Both sides of a two-sided surface are fronts.
    let has_one_side = |shell: &&Shell| shell.sheets.iter().any(|k| !sheets.list[*k].two_sided);
    let warning = |shell: &Shell| {
        let first = &sheets.list[shell.sheets[0]].name;
        let stands_alone = shell.sheets.len() == sheets.list.len();
        let emits = || shell.sheets.iter().any(|k| sheets.list[*k].emits);
        match shell.fronts {
            Fronts::Outside if holds_something(scene, sheets, shell) => Some(Warning::about(
                "front-outside",
                first,
                format!("{}, faces away from what is in it: {cure}", part_of(shell)),
            )),
            Fronts::Inside if !stands_alone && !emits() && !holds_something(scene, sheets, shell) => {
                Some(Warning::about(
                    "front-inside",
                    first,
                    format!("{}, faces into a closed space with no light in it: {cure}", part_of(shell)),
                ))
            }
            _ => None,
        }
    };
    shells.par_iter().filter(has_one_side).filter_map(warning).collect()
}

/// Whether the camera or the whole of another sheet is inside a shell: what touches it or passes through it is not.
fn holds_something(scene: &Scene, sheets: &Sheets, shell: &Shell) -> bool {
    let enclosure = Enclosure::new(sheets, shell);
    let is_inside = |k: usize| {
        let mut samples = sheets.list[k].samples().into_iter();
        shell.sheets.binary_search(&k).is_err() && samples.all(|sample| enclosure.contains(sample.point))
    };
    scene.camera.as_ref().is_some_and(|camera| enclosure.contains(camera.eye))
        || sheets.around(&enclosure.bounds).any(is_inside)
}

fn part_of(shell: &Shell) -> String {
    match shell.sheets.len() {
        1 => "closed in itself".to_owned(),
        count => format!("with {} others a closed surface", count - 1),
    }
}

/// Fronts that face no other front, according to sampled points; blockers are not considered, what is
/// `lying` on another surface faces that one, and a face of a solid would be wrong if it were turned over, as would
/// one of several faces that agree, of which some see others: a roof over walls.
pub(super) fn blind(
    scene: &Scene,
    sheets: &Sheets,
    groups: &[Group],
    shells: &[Shell],
    lying: &HashSet<&str>,
) -> Vec<Warning> {
    let solids = shells.iter().filter(|shell| shell.fronts == Fronts::Outside);
    let of_solids: HashSet<usize> = solids.flat_map(|shell| shell.sheets.iter().copied()).collect();
    let samples: Vec<_> = sheets.list.iter().map(Sheet::samples).collect();
    let is_flat: Vec<bool> = sheets.list.iter().map(|sheet| sheet.shape.region().is_some()).collect();
    // If the other lies wholly behind this plane, no pair of points has to be tested.
    let reaches = |own: usize, bounds: &Aabb| {
        !is_flat[own] || lies_before(&samples[own][0], sheets.list[own].extent, bounds)
    };
    let sees = |own: usize, other: usize| {
        let behind = sheets.list[other].two_sided;
        reaches(own, &sheets.list[other].bounds)
            && (behind || reaches(other, &sheets.list[own].bounds))
            && samples[own].iter().any(|x| samples[other].iter().any(|y| faces(x, y, behind)))
    };
    let tree = Bvh::build(&sheets.list.iter().map(|sheet| sheet.bounds).collect::<Vec<_>>());
    let is_blind = |own: usize| {
        !sheets.list[own].two_sided
            && !of_solids.contains(&own)
            && !tree.search(|bounds| reaches(own, bounds)).any(|other| sees(own, other))
    };
    if sheets.list.len() < 2 {
        return Vec::new();
    }
    let blind: Vec<usize> = (0..sheets.list.len()).into_par_iter().filter(|own| is_blind(*own)).collect();
    let bodies: Vec<&Group> = groups.iter().filter(|group| group.agrees()).collect();
    let body = |own: usize| bodies.iter().find(|group| group.sheets.binary_search(&own).is_ok());
    let sees_as_a_body = |group: &Group| group.sheets.iter().any(|own| blind.binary_search(own).is_err());
    // What has a temperature or a flux of heat faces space.
    let is_wrong = |own: &usize| {
        let name = sheets.list[*own].name.as_str();
        !sheets.list[*own].has_heat
            && !lying.contains(name)
            && !body(*own).is_some_and(|group| sees_as_a_body(group))
    };
    let warning = |own: usize| {
        let cure = match body(own) {
            None => by_keys(scene, "flip = true turns it over"),
            Some(_) => {
                "if it is a wall of a room, ".to_owned()
                    + &by_keys(scene, "flip = true turns it and those that it meets over")
            }
        };
        let message = format!("faces no other front, it neither lights nor is lit: {cure}");
        Warning::about("front-blind", &sheets.list[own].name, message)
    };
    blind.iter().copied().filter(is_wrong).map(warning).collect()
}

/// Whether a point of a box may be seen, at a sine of at least `GRAZING`, from a planar sheet of this
/// `extent` that lies in `plane` about the point of that.
fn lies_before(plane: &Plane, extent: f64, bounds: &Aabb) -> bool {
    let half = 0.5 * (bounds.max - bounds.min);
    let height = plane.height(bounds.center()) + half.dot(plane.normal.abs());
    height > GRAZING * (bounds.distance_squared(plane.point).sqrt() - extent).max(0.0)
}

/// Whether the fronts of two tangent planes face each other between the points where they touch, with a sine
/// of at least `GRAZING`; the second's back counts too if it is `two_sided`.
fn faces(own: &Plane, other: &Plane, two_sided: bool) -> bool {
    let d = other.point - own.point;
    let (out, into) = (d.dot(own.normal), -d.dot(other.normal));
    let least = GRAZING * d.length();
    out > least && (into > least || two_sided && -into > least)
}
