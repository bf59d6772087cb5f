//! Planes, and the corners that are meant to lie in them.
//!
//! A plane belongs to one flat sheet or to several that lie in it. It has all their corners, and those of
//! other sheets that end on one of them, such as the foot of a box on a floor.

use std::collections::BTreeSet;

use radiosity_geom::{Aabb, DVec3};

use super::apart::Apart;
use super::corners::Corners;
use super::forest::Forest;
use super::layers::Layers;
use super::sheet::Sheets;

/// The planes of a scene.
#[derive(Debug)]
pub(super) struct Planes {
    pub(super) list: Vec<Plane>,
}

/// A plane and the corners that are meant to lie in it.
#[derive(Debug)]
pub(super) struct Plane {
    /// Unit normal, approximately.
    pub(super) normal: DVec3,
    /// The nodes in it, ascending.
    pub(super) nodes: Vec<usize>,
}

impl Planes {
    /// The planes of the flat `sheets`, whose corners are merged; sheets that are `apart` share none.
    pub(super) fn of(sheets: &Sheets, corners: &Corners, apart: &Apart) -> Self {
        let shared = shared(sheets, apart);
        let mut nodes: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); sheets.list.len()];
        for (own, sheet) in sheets.list.iter().enumerate().filter(|(_, sheet)| sheet.region.is_some()) {
            let of_sheet = sheet.corners.iter().filter_map(|corner| corners.node(*corner));
            nodes[shared.root(own)].extend(of_sheet);
            nodes[shared.root(own)].extend(ending_on(own, sheets, corners, apart));
        }
        let plane = |(own, nodes): (usize, BTreeSet<usize>)| {
            let region = sheets.list[own].region.as_ref().filter(|_| nodes.len() > 3)?;
            Some(Plane { normal: region.normal(), nodes: nodes.into_iter().collect() })
        };
        Self { list: nodes.into_iter().enumerate().filter_map(plane).collect() }
    }
}

/// A forest whose trees are the sheets that share a plane.
fn shared(sheets: &Sheets, apart: &Apart) -> Forest {
    let mut shared = Forest::new(sheets.list.len());
    let mut layers = Layers::of(sheets, apart);
    for (own, sheet) in sheets.list.iter().enumerate() {
        let Some(region) = &sheet.region else { continue };
        for other in sheets.near(sheet.bounds()) {
            let over = &sheets.list[other];
            if other == own || over.region.is_none() || apart.contains(&(own, other)) {
                continue;
            }
            let [low, high] = over.heights_over(region);
            if low.abs().max(high.abs()) <= sheet.tolerance.with(&over.tolerance) {
                layers.join(&mut shared, own, other);
            }
        }
    }
    shared
}

/// The nodes of other sheets that end on the flat sheet `own`.
fn ending_on(own: usize, sheets: &Sheets, corners: &Corners, apart: &Apart) -> Vec<usize> {
    let sheet = &sheets.list[own];
    let Some(region) = &sheet.region else { return Vec::new() };
    let mut found = Vec::new();
    for other in sheets.near(sheet.bounds()).into_iter().filter(|other| *other != own) {
        let tolerance = sheet.tolerance.with(&sheets.list[other].tolerance);
        let bounds: Aabb = Aabb::around(sheet.corners.iter().copied()).inflate(tolerance);
        for corner in sheets.list[other].corners.iter().filter(|x| bounds.contains(**x)) {
            let Some(node) = corners.node(*corner) else { continue };
            let is_held_off = || corners.sheets[node].iter().any(|held| apart.contains(&(own, *held)));
            let ends_here = || region.nearest(*corner).distance(*corner) <= tolerance;
            if region.height(*corner).abs() <= tolerance && ends_here() && !is_held_off() {
                found.push(node);
            }
        }
    }
    found
}
