//! Which surfaces touch, and how.

use radiosity_geom::{Adjacency, DVec3};
use rayon::prelude::*;

use crate::inspection::{
    sheet::{Sheets, TOUCH},
    warning::{Warning, place},
};
use crate::scene::Scene;

/// Two surfaces that touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Their indices in the scene, the lower first.
    pub surfaces: [usize; 2],
    /// How they touch.
    pub touch: Touch,
}

/// How two surfaces touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Touch {
    /// Along a whole border of both.
    Edge,
    /// A border of one lies on the face of the other or along part of its border.
    Tee,
    /// In single points.
    Vertex,
    /// One passes through the other.
    Crossing {
        /// A point of both, to two digits of their extent.
        at: DVec3,
    },
    /// They share area, to a millionth of the smaller extent.
    Overlap,
}

/// All contacts, in the order of the surfaces' indices.
pub(super) fn contacts(sheets: &Sheets) -> Vec<Contact> {
    let of_sheet = |a: usize| -> Vec<Contact> {
        let later = sheets.near(a).into_iter().filter(|b| *b > a);
        later.filter_map(|b| contact(sheets, [a, b])).collect()
    };
    let found: Vec<Vec<Contact>> = (0..sheets.list.len()).into_par_iter().map(of_sheet).collect();
    found.into_iter().flatten().collect()
}

fn contact(sheets: &Sheets, pair: [usize; 2]) -> Option<Contact> {
    let [a, b] = pair.map(|k| &sheets.list[k]);
    let room = TOUCH * a.extent.min(b.extent);
    if !a.bounds.inflate(room).overlaps(&b.bounds.inflate(room)) {
        return None;
    }
    let touch = match Adjacency::of(&a.patch(), &b.patch()) {
        Adjacency::Edges(_) => Touch::Edge,
        Adjacency::Tee(_) => Touch::Tee,
        Adjacency::Vertices(_) => Touch::Vertex,
        Adjacency::Crossing { at } => Touch::Crossing { at },
        Adjacency::Same | Adjacency::Overlap => Touch::Overlap,
        Adjacency::Near { .. } | Adjacency::Apart => return None,
    };
    Some(Contact { surfaces: [a.surface, b.surface], touch })
}

/// Surfaces that pass through each other or share area.
pub(super) fn intrusion(scene: &Scene, contact: &Contact) -> Option<Warning> {
    let [own, other] = contact.surfaces.map(|index| &scene.surfaces[index].name);
    match contact.touch {
        Touch::Crossing { at } => {
            let place = place(at + scene.middle);
            let message = format!("passes through {other:?} near {place}: end one where it meets the other");
            Some(Warning::about("crossing", own, message))
        }
        Touch::Overlap => {
            let message = format!("lies partly in {other:?}: move them apart, or remove one");
            Some(Warning::about("overlap", own, message))
        }
        Touch::Edge | Touch::Tee | Touch::Vertex => None,
    }
}
