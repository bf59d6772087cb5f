//! Shells: sheets connected along their borders, and the volume of the closed ones.
//!
//! A shell is closed where every place of every border meets exactly one other border. Its volume follows
//! from Gauss' theorem, V = ⅓ ∮ (x − c) · n dA for any c, positive where the fronts are outside. Two fronts
//! agree along a common border if they run along it in opposite directions.

use std::collections::HashSet;

use radiosity_core::gauss::{Legendre, Rule};
use radiosity_geom::{Aabb, DVec3, Rect};

use crate::inspection::{
    sheet::{Sheet, Sheets},
    sheet_border::{Meeting, MetBorder, SheetBorder},
};

/// A closed surface made of one or more surfaces.
#[derive(Clone, Debug, PartialEq)]
pub struct Shell {
    /// Indices in the scene, ascending.
    pub surfaces: Vec<usize>,
    /// Enclosed volume (scene length³).
    pub volume: f64,
    /// Where its fronts are.
    pub fronts: Fronts,
    /// Indices among the sheets.
    pub(super) sheets: Vec<usize>,
}

/// Where the fronts of a closed surface are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fronts {
    /// They face the enclosed space, as those of a room.
    Inside,
    /// They face away from it, as those of a solid.
    Outside,
    /// Some face inside, some outside.
    Mixed,
}

/// Connected sheets.
#[derive(Debug)]
pub(super) struct Group {
    pub(super) sheets: Vec<usize>,
    /// Sheets whose front disagrees with the larger part, each with a neighbour that it disagrees with.
    pub(super) turned: Vec<(usize, usize)>,
    /// 1 for fronts that agree with the first sheet's, −1 for others, in the order of the sheets.
    signs: Vec<f64>,
    is_closed: bool,
}

impl Group {
    /// Whether it is of several sheets, whose fronts agree.
    pub(super) fn agrees(&self) -> bool {
        self.sheets.len() > 1 && self.turned.is_empty()
    }
}

/// All groups, by their first sheets.
pub(super) fn groups(sheets: &Sheets, borders: &[SheetBorder]) -> Vec<Group> {
    let joints = joints(sheets, borders);
    let mut is_open = vec![false; sheets.list.len()];
    for border in borders {
        let single = |meeting: &Meeting| matches!(meeting, Meeting::Borders(others) if others.len() == 1);
        is_open[border.sheet] |= !border.places.iter().all(|place| single(&place.meeting));
    }
    let mut sign = vec![0.0; sheets.list.len()];
    let mut groups = Vec::new();
    for first in 0..sheets.list.len() {
        if sign[first] == 0.0 {
            groups.push(spread(sheets, first, &joints, &mut sign, &is_open));
        }
    }
    groups
}

/// A sheet and its neighbour across a border.
#[derive(Clone, Copy)]
struct Joint {
    /// Index of the neighbour.
    other: usize,
    /// 1 if the fronts agree, −1 if they disagree, 0 if neither is defined.
    agree: f64,
}

/// For each sheet the joints with its neighbours.
fn joints(sheets: &Sheets, borders: &[SheetBorder]) -> Vec<Vec<Joint>> {
    let mut joints = vec![Vec::new(); sheets.list.len()];
    let mut known = HashSet::new();
    for border in borders {
        for place in &border.places {
            let Meeting::Borders(others) = &place.meeting else { continue };
            for MetBorder { sheet: other, cosine } in
                others.iter().filter(|other| other.sheet != border.sheet)
            {
                let is_clear = others.len() == 1
                    && !sheets.list[border.sheet].two_sided
                    && !sheets.list[*other].two_sided;
                let agree = if is_clear { -cosine.signum() } else { 0.0 };
                if known.insert((border.sheet, *other, agree.to_bits())) {
                    joints[border.sheet].push(Joint { other: *other, agree });
                }
            }
        }
    }
    joints
}

/// The group of the sheet `first`, with signs spread from neighbour to neighbour.
fn spread(sheets: &Sheets, first: usize, joints: &[Vec<Joint>], sign: &mut [f64], is_open: &[bool]) -> Group {
    sign[first] = 1.0;
    let mut members = vec![first];
    let mut next = 0;
    while next < members.len() {
        let own = members[next];
        for Joint { other, agree } in &joints[own] {
            if sign[*other] == 0.0 {
                sign[*other] = if *agree == 0.0 { sign[own] } else { agree * sign[own] };
                members.push(*other);
            }
        }
        next += 1;
    }
    members.sort_unstable();
    let area = |side: f64| -> f64 {
        members.iter().filter(|k| sign[**k] == side).map(|k| sheets.list[*k].shape.area()).sum()
    };
    let minority = if area(-1.0) <= area(1.0) { -1.0 } else { 1.0 };
    let against = |own: &usize| {
        let joint = joints[*own].iter().find(|joint| joint.agree == -1.0);
        joint.filter(|_| sign[*own] == minority).map(|joint| (*own, joint.other))
    };
    Group {
        turned: members.iter().filter_map(against).collect(),
        signs: members.iter().map(|k| sign[*k]).collect(),
        is_closed: members.iter().all(|k| !is_open[*k]),
        sheets: members,
    }
}

/// The shell of a closed group.
pub(super) fn shell(sheets: &Sheets, group: &Group) -> Option<Shell> {
    if !group.is_closed {
        return None;
    }
    let members = || group.sheets.iter().map(|k| &sheets.list[*k]);
    let bounds = members().fold(Aabb::EMPTY, |bounds, sheet| bounds.union(sheet.bounds));
    let center = bounds.center();
    let flux: f64 = members().zip(&group.signs).map(|(sheet, sign)| sign * flux(sheet, center)).sum();
    let fronts = match (group.turned.is_empty(), flux > 0.0) {
        (false, _) => Fronts::Mixed,
        (true, true) => Fronts::Outside,
        (true, false) => Fronts::Inside,
    };
    let surfaces = members().map(|sheet| sheet.surface).collect();
    Some(Shell { surfaces, volume: flux.abs() / 3.0, fronts, sheets: group.sheets.clone() })
}

/// ∫ (x − c) · n dA: constant over a plane, else by the ten-point Gauss rule over 8 × 8 parts.
fn flux(sheet: &Sheet, center: DVec3) -> f64 {
    if let Some(region) = sheet.shape.region() {
        return (region.origin() - center).dot(region.normal()) * region.area();
    }
    let quarters = |rects: Vec<Rect>| rects.iter().flat_map(Rect::quarters).collect::<Vec<_>>();
    let parts = quarters(quarters(Rect::FULL.quarters().to_vec()));
    parts.iter().map(|rect| flux_over(sheet, rect, center)).sum()
}

fn flux_over(sheet: &Sheet, rect: &Rect, center: DVec3) -> f64 {
    let Rule { nodes, weights } = Legendre::<10>::RULE;
    let at = |s: f64, t: f64| {
        let [u, v] = rect.at(s, t);
        let jet = sheet.shape.jet(u, v);
        jet.area * (jet.position - center).dot(jet.normal)
    };
    let row = |s: f64| nodes.iter().zip(weights).map(|(t, w)| w * at(s, *t)).sum::<f64>();
    let [du, dv] = rect.half_extent();
    du * dv * nodes.iter().zip(weights).map(|(s, w)| w * row(*s)).sum::<f64>()
}
