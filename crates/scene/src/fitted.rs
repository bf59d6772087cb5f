//! Fitting shapes together after they were read.
//!
//! In this order: the middle of a scene far from the origin is subtracted ([`middle`]), corners and planes
//! that agree to the rounding of the input are made equal ([`weld`](mod@weld)), and flat sheets on others are
//! set apart ([`stacked`]).

use std::sync::Arc;

use radiosity_fit::{
    Welded, middle,
    stacked::{self, Sheet, Step},
    weld::weld,
};
use radiosity_geom::{DVec3, Surface};
use serde::Serialize;

use crate::surface_draft::{NamedShape, SurfaceDraft};

/// Changes to the shapes of a scene, made to fit them together.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Fitted {
    /// Corners and planes that were made equal.
    pub welded: Welded,
    /// Surfaces that lie on others in one plane, and were moved off them slightly.
    pub lying: Vec<LiesOn>,
}

/// A surface that lies on another, in its plane.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LiesOn {
    /// Name of the surface.
    pub surface: String,
    /// Name of the larger surface that it lies on.
    pub on: String,
    /// Whether both are taken for the skins of one shell, back to back, though they were typed face to face: their gap
    /// counts as rounding.
    pub is_turned: bool,
}

impl LiesOn {
    /// A step of these sheets, by their names.
    pub(crate) fn of(step: &Step, sheets: &[Sheet]) -> Self {
        let name = |sheet: usize| sheets[sheet].name.clone();
        Self { surface: name(step.sheet), on: name(step.on), is_turned: step.is_turned }
    }
}

impl Fitted {
    /// The changes in one line; none if all shapes are as they were typed.
    pub fn line(&self) -> Option<String> {
        let welded = (self.welded.corners > 0).then(|| format!("welded: {}", self.welded));
        let lying = match self.lying.len() {
            0 => None,
            1 => Some(format!("'{}' lies on '{}'", self.lying[0].surface, self.lying[0].on)),
            count => Some(format!("{count} surfaces lie on others")),
        };
        let parts: Vec<String> = welded.into_iter().chain(lying).chain(self.turned()).collect();
        (!parts.is_empty()).then(|| parts.join("; "))
    }

    /// Words on faces whose gap counts as rounding, and which see nothing of each other.
    fn turned(&self) -> Option<String> {
        let turned: Vec<&LiesOn> = self.lying.iter().filter(|own| own.is_turned).collect();
        let LiesOn { surface, on, .. } = turned.first()?;
        let more = match turned.len() {
            1 => String::new(),
            count => format!(" (and {} more)", count - 1),
        };
        Some(format!(
            "'{surface}' is taken to lie behind '{on}', before which it was typed within rounding{more}: they see \
             nothing of each other"
        ))
    }
}

/// Fits the shapes of `drafts` together and subtracts `middle`; `tolerance` (scene length) replaces the
/// tolerance of the input.
pub(super) fn fit(drafts: &mut [SurfaceDraft], middle: DVec3, tolerance: Option<f64>) -> Fitted {
    let mut shapes: Vec<&mut Arc<dyn Surface>> =
        drafts.iter_mut().flat_map(|draft| draft.shapes.iter_mut().map(|own| &mut own.shape)).collect();
    if middle != DVec3::ZERO {
        shapes.iter_mut().for_each(|shape| **shape = middle::taken_off(shape, middle));
    }
    let typed: Vec<Arc<dyn Surface>> = shapes.iter().map(|shape| Arc::clone(shape)).collect();
    let welded = weld(&mut shapes, middle, tolerance);
    Fitted { welded, lying: set_apart(drafts, &typed) }
}

/// Moves flat sheets off those that they lie on; `typed` are all shapes before welding.
fn set_apart(drafts: &mut [SurfaceDraft], typed: &[Arc<dyn Surface>]) -> Vec<LiesOn> {
    let mut typed = typed.iter();
    let mut sheets = Vec::new();
    for draft in drafts.iter() {
        for (NamedShape { name, shape }, typed) in draft.shapes.iter().zip(&mut typed) {
            sheets.extend(shape.region().is_some().then(|| Sheet {
                shape: Arc::clone(shape),
                typed: Arc::clone(typed),
                two_sided: draft.two_sided,
                flip: draft.flip,
                stays: false,
                name: name.clone(),
            }));
        }
    }
    let steps = stacked::set_apart(&mut sheets);
    let found = steps.iter().map(|step| LiesOn::of(step, &sheets)).collect();
    let shapes = drafts.iter_mut().flat_map(|draft| &mut draft.shapes).map(|own| &mut own.shape);
    shapes
        .filter(|shape| shape.region().is_some())
        .zip(sheets)
        .for_each(|(shape, sheet)| *shape = sheet.shape);
    found
}
