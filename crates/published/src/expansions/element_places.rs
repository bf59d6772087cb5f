//! Displacements of elements from where they were seen first.

use std::sync::Arc;

use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::DVec3;

/// Relative difference of coordinates, and of values of functions, that is rounding. Chosen: coordinates of
/// moved things were rounded two or three times, and what follows from them is amplified by the functions.
const ROUNDED: f64 = 1e-14;
const ROUNDED_VALUES: f64 = 1e-10;

/// Where the elements of a scene are.
#[derive(Debug, Default)]
pub(super) struct ElementPlaces {
    /// Place of each element; None of those that are curved.
    now: Vec<Option<ElementPlace>>,
}

/// Where an element is.
#[derive(Clone, Debug)]
pub(super) struct ElementPlace {
    /// The element as it was seen first.
    pub reference: Arc<Element>,
    /// Number of times that it was seen anew because it was not only translated.
    pub turn: u32,
    /// Displacement from the reference (scene length).
    pub shift: DVec3,
}

impl ElementPlace {
    fn anew(element: &Element, turn: u32) -> Self {
        Self { reference: Arc::new(element.clone()), turn, shift: DVec3::ZERO }
    }

    /// Where it is now.
    fn moved(&self, element: &Element) -> Self {
        match translation(&self.reference, element) {
            Some(shift) => Self { shift, ..self.clone() },
            None => Self::anew(element, self.turn + 1),
        }
    }
}

impl ElementPlaces {
    /// Takes note of where the elements of the next scene are; of another number of them all are new.
    pub(super) fn move_to(&mut self, elements: &[Element]) {
        let before = std::mem::take(&mut self.now);
        let are_known = before.len() == elements.len();
        let known = |index: usize| before.get(index).filter(|_| are_known).and_then(Option::as_ref);
        let place = |(index, element): (usize, &Element)| {
            element.plane?;
            Some(known(index).map_or_else(|| ElementPlace::anew(element, 0), |before| before.moved(element)))
        };
        self.now = elements.iter().enumerate().map(place).collect();
    }

    /// Whether the scene had so many elements.
    pub(super) fn are_of(&self, elements: usize) -> bool {
        self.now.len() == elements
    }

    /// Where the element number `index` is; None if it is curved.
    pub(super) fn of(&self, index: usize) -> Option<ElementPlace> {
        self.now.get(index)?.clone()
    }
}

/// The displacement that makes one flat element the other, with its functions; None if there is none.
fn translation(from: &Element, to: &Element) -> Option<DVec3> {
    let [own, other] = [corners(from)?, corners(to)?];
    let shift = *other.first()? - *own.first()?;
    let size = own.iter().chain(&other).fold(0.0, |most: f64, x| most.max(x.length()));
    let is_moved = |(a, b): (&DVec3, &DVec3)| (b - a - shift).length() <= ROUNDED * size;
    let is_alike = |(a, b): (&DVec3, &DVec3)| {
        let [own, other] = [values(from, *a), values(to, *b)];
        let most = own.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        own.len() == other.len()
            && own.iter().zip(&other).all(|(x, y)| (x - y).abs() <= ROUNDED_VALUES * most)
    };
    let is_turned = (from.plane?.normal - to.plane?.normal).length() > ROUNDED;
    let all = || own.iter().zip(&other);
    let is_same = own.len() == other.len() && !is_turned && all().all(is_moved) && all().all(is_alike);
    is_same.then_some(shift)
}

/// The corners of all patches; None if one is curved.
fn corners(element: &Element) -> Option<Vec<DVec3>> {
    let flat = element.patches.iter().all(Patch::is_flat);
    flat.then(|| element.patches.iter().flat_map(Patch::corners).collect())
}

/// φ_k at a point of the plane.
fn values(element: &Element, x: DVec3) -> Vec<f64> {
    let raw = element.raw_values(x, [0.0; 2]);
    let rows = element.basis.transform().chunks_exact(raw.len());
    rows.map(|row| dot(row, &raw)).collect()
}
