//! Faces whose stated normals point to their backs: in a sheet of two faces, which share their corners, these are the
//! normals of the other one.

use std::collections::HashMap;

use glam::DVec3;
use radiosity_geom::area_vector;
use radiosity_photometry::note::Note;

use crate::face_normals::{FaceNormals, Remark};
use crate::model::{Model, Sides};

/// Such faces, with the note on each.
#[derive(Debug, Default)]
pub(crate) struct OpposedFaces {
    list: Vec<OpposedFace>,
}

#[derive(Debug)]
struct OpposedFace {
    corners: Corners,
    /// Normal of the face, of any length.
    normal: DVec3,
    note: Note,
}

/// The corners of a face in one order, as bits.
type Corners = Vec<[u64; 3]>;

fn corners(outline: &[DVec3]) -> Corners {
    // A zero has one sign.
    let bits = |corner: &DVec3| corner.to_array().map(|x| (x + 0.0).to_bits());
    let mut corners: Corners = outline.iter().map(bits).collect();
    corners.sort_unstable();
    corners
}

impl OpposedFaces {
    /// Notes stated normals of a face of these sides that are not its own, by the note of a text: at once, or, of those
    /// of its back, where all faces are known.
    pub(crate) fn note_normals(
        &mut self,
        stated: &FaceNormals,
        sides: Sides,
        note: impl FnOnce(&'static str) -> Note,
        notes: &mut Vec<Note>,
    ) {
        match stated.remark(sides) {
            None => {}
            Some(remark @ Remark::Opposed) => self.add(stated.corners, note(remark.text())),
            Some(remark @ Remark::Rounded) => note(remark.text()).put(notes),
        }
    }

    /// Adds a face with these corners.
    pub(crate) fn add(&mut self, outline: &[DVec3], note: Note) {
        let (corners, normal) = (corners(outline), area_vector(outline));
        self.list.push(OpposedFace { corners, normal, note });
    }

    /// Notes those that are not one of the two faces of a sheet of `model`.
    pub(crate) fn note(self, model: &mut Model) {
        if self.list.is_empty() {
            return;
        }
        let mut fronts: HashMap<&Corners, Vec<DVec3>> =
            self.list.iter().map(|own| (&own.corners, Vec::new())).collect();
        for surface in &model.surfaces {
            let rings = surface.shape.rings();
            let Some(outline) = rings.first() else { continue };
            if let Some(known) = fronts.get_mut(&corners(outline)) {
                known.push(area_vector(outline));
            }
        }
        let is_of_sheet =
            |own: &OpposedFace| fronts[&own.corners].iter().any(|front| front.dot(own.normal) < 0.0);
        let lone = self.list.iter().filter(|own| !is_of_sheet(own));
        lone.for_each(|own| own.note.clone().put(&mut model.notes));
    }
}
