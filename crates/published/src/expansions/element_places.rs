//! Places of elements relative to where they were seen first.

use std::sync::Arc;

use radiosity_core::dot;
use radiosity_elements::Element;
use radiosity_elements::patch::Patch;
use radiosity_geom::{DQuat, DVec3, Motion};

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
    /// Number of times that it was seen anew because it was another.
    pub changes: u32,
    /// The rigid motion of the reference to it.
    pub place: Motion,
}

impl ElementPlace {
    fn anew(element: &Element, changes: u32) -> Self {
        Self { reference: Arc::new(element.clone()), changes, place: Motion::IDENTITY }
    }

    /// Where it is now.
    fn moved(&self, element: &Element) -> Self {
        match rigid_motion(&self.reference, element) {
            Some(place) => Self { place, ..self.clone() },
            None => Self::anew(element, self.changes + 1),
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

/// The rigid motion that makes one flat element the other, with its functions; None if there is none.
fn rigid_motion(from: &Element, to: &Element) -> Option<Motion> {
    if from.patches == to.patches && from.basis == to.basis {
        return Some(Motion::IDENTITY);
    }
    let [own, other] = [corners(from)?, corners(to)?];
    if own.len() != other.len() {
        return None;
    }
    let translation = Motion::rigid(DQuat::IDENTITY, other.first()? - own.first()?);
    let is_made = |motion: &Motion| is_image([from, to], [&own, &other], motion);
    Some(translation).filter(is_made).or_else(|| turn(&own, &other).filter(is_made))
}

/// Whether `motion` makes one element the other, with these corners.
fn is_image([from, to]: [&Element; 2], [own, other]: [&[DVec3]; 2], motion: &Motion) -> bool {
    let (Some(plane), Some(image)) = (from.plane, to.plane) else { return false };
    let size = own.iter().chain(other).fold(0.0, |most: f64, x| most.max(x.length()));
    let is_moved = |(a, b): (&DVec3, &DVec3)| (b - motion.point(*a)).length() <= ROUNDED * size;
    let is_alike = |(a, b): (&DVec3, &DVec3)| {
        let [own, other] = [values(from, *a), values(to, *b)];
        let most = own.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        own.len() == other.len()
            && own.iter().zip(&other).all(|(x, y)| (x - y).abs() <= ROUNDED_VALUES * most)
    };
    // Corners alone do not tell which side is the front.
    let is_upright = motion.direction(plane.normal).dot(image.normal) > 0.0;
    let all = || own.iter().zip(other);
    is_upright && all().all(is_moved) && all().all(is_alike)
}

/// The rigid motion that takes corners to others, if there is one: the longest way between two of them, and
/// the corner farthest aside, tell it best.
fn turn(own: &[DVec3], other: &[DVec3]) -> Option<Motion> {
    let first = *own.first()?;
    let far = (0..own.len()).max_by(|i, j| own[*i].distance(first).total_cmp(&own[*j].distance(first)))?;
    let along = (own[far] - first).try_normalize()?;
    let aside = |x: &DVec3| (x - first).reject_from_normalized(along).length();
    let wide = (0..own.len()).max_by(|i, j| aside(&own[*i]).total_cmp(&aside(&own[*j])))?;
    let frame = |x: &[DVec3]| {
        let along = (x[far] - x[0]).try_normalize()?;
        let across = (x[wide] - x[0]).reject_from_normalized(along).try_normalize()?;
        Some(Motion::to_frame(x[0], [along, across, along.cross(across)]))
    };
    Some(frame(own)?.inverse().then(&frame(other)?))
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
