//! Which surfaces touch, and how.

use radiosity_geom::{Adjacency, DVec3};

use crate::inspection::sheet::{Sheets, TOUCH};

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

/// Every contact, by the surfaces' indices.
pub(super) fn contacts(sheets: &Sheets) -> Vec<Contact> {
    let pairs = (0..sheets.list.len()).flat_map(|a| {
        let later = sheets.near(a).into_iter().filter(move |b| *b > a);
        later.map(move |b| [a, b])
    });
    pairs.filter_map(|pair| contact(sheets, pair)).collect()
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
