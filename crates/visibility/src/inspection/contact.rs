//! Contacts of surfaces.

use std::collections::HashSet;

use radiosity_geom::Adjacency;
use radiosity_scene::Scene;
use rayon::prelude::*;

use crate::inspection::{
    sheet::Sheets,
    warning::{Warning, place},
};

/// Two surfaces that touch.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceContact {
    /// Their indices in the scene, the lower first.
    pub surfaces: [usize; 2],
    /// Kind of the contact.
    pub touch: Adjacency,
}

/// All contacts, in the order of the surfaces' indices.
pub(super) fn contacts(sheets: &Sheets) -> Vec<SurfaceContact> {
    let of_sheet = |a: usize| -> Vec<SurfaceContact> {
        let later = sheets.near(a).into_iter().filter(|b| *b > a);
        later.filter_map(|b| contact(sheets, [a, b])).collect()
    };
    let found: Vec<Vec<SurfaceContact>> = (0..sheets.list.len()).into_par_iter().map(of_sheet).collect();
    found.into_iter().flatten().collect()
}

fn contact(sheets: &Sheets, pair: [usize; 2]) -> Option<SurfaceContact> {
    let [a, b] = pair.map(|k| &sheets.list[k]);
    let touch = Adjacency::of(&a.patch(), &b.patch())?;
    Some(SurfaceContact { surfaces: [a.surface, b.surface], touch })
}

/// Surfaces that pass through each other, or share area; not those that were set apart, `lying` on others.
pub(super) fn intrusion(scene: &Scene, lying: &HashSet<&str>, contact: &SurfaceContact) -> Option<Warning> {
    let [own, other] = contact.surfaces.map(|index| &scene.surfaces[index].name);
    match contact.touch {
        Adjacency::Crossing { at } => {
            let place = place(at + scene.middle);
            let message = format!("passes through {other:?} near {place}: end one where it meets the other");
            Some(Warning::about("crossing", own, message))
        }
        Adjacency::Overlap if [own, other].into_iter().any(|name| lying.contains(name.as_str())) => None,
        Adjacency::Overlap => {
            let message = format!("lies partly in {other:?}: move them apart, or remove one");
            Some(Warning::about("overlap", own, message))
        }
        Adjacency::Edge | Adjacency::Tee | Adjacency::Vertex => None,
    }
}
