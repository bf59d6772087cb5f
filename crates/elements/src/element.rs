//! One element: a cell of a surface, cut out of its holes, and the polynomials on it.

use std::sync::Arc;

use radiosity_core::dot;
use radiosity_geom::{
    Aabb, DVec2, DVec3, PARALLEL_DIRECTIONS, Plane, Rect, Surface, clip_polygon, overhang, polygon_area,
};
use radiosity_scene::SceneSurface;
use smallvec::{SmallVec, smallvec};

use super::basis::AreaBasis;
use super::fault::ElementError;
use super::frame::Frame;
use super::measure::Measure;
use super::patch::{Patch, plane_of};
use super::rule::UnitRule;
use super::space::Space;

/// A piece of a surface with its orthonormal polynomials.
#[derive(Clone, Debug)]
pub struct Element {
    /// Index of the surface in the scene.
    pub surface: usize,
    /// The parameters it covers, as far as the surface exists there.
    pub rect: Rect,
    /// φ_k, k = 0..basis.len().
    pub basis: AreaBasis,
    /// Disjoint patches that cover it.
    pub patches: Vec<Patch>,
    /// Its plane, where it is a polygon.
    pub plane: Option<Plane>,
    /// The plane in which all of it lies, facing one way: of discs too.
    pub level: Option<Plane>,
    /// Area (scene length²).
    pub area: f64,
    /// c_k = ∫ φ_k dA, the coefficients of the constant 1.
    pub constant: Vec<f64>,
    /// Points whose convex hull contains it.
    pub hull: Vec<DVec3>,
    /// Diagonal of its bounding box (scene length).
    pub extent: f64,
    /// The contact by which it is covered, if any ([`radiosity_visibility::covered_parts`]).
    pub contact: Option<usize>,
    /// The surface over the narrow gap in which it lies, if it was cut for that (`shaded_parts`).
    pub shaded_by: Option<usize>,
}

impl Element {
    /// Whether it is a cell of its surface: no part that another surface covers or shades.
    pub fn is_cell(&self) -> bool {
        self.contact.is_none() && self.shaded_by.is_none()
    }

    /// Whether another element is of the same part of its surface: of its cells, or of what one thing covers or shades.
    pub fn is_of_part(&self, other: &Self) -> bool {
        (self.contact, self.shaded_by) == (other.contact, other.shaded_by)
    }

    /// Value at a point of the polynomial with the raw coefficients `raw` ([`AreaBasis::to_raw`]).
    ///
    /// `position` matters on flat elements, `parameters` on curved ones.
    pub fn evaluate(&self, raw: &[f64], position: DVec3, parameters: [f64; 2]) -> f64 {
        dot(&self.raw_values(position, parameters), raw)
    }

    /// R_k at a point, for evaluating several polynomials there.
    pub fn raw_values(&self, position: DVec3, parameters: [f64; 2]) -> SmallVec<[f64; 28]> {
        let place = self.basis.frame().locate(position, DVec2::from_array(parameters));
        let mut values = smallvec![0.0; self.basis.len()];
        self.basis.raw(place, &mut values);
        values
    }

    /// ∬ |φ_k| dA (length) for each k by a Gauss rule, to a few percent.
    pub fn absolute_integrals(&self) -> Vec<f64> {
        let count = self.basis.len();
        let mut sums = vec![0.0; count];
        let mut raw = vec![0.0; count];
        let rule = UnitRule::of(2 * self.basis.order() + 2);
        for patch in &self.patches {
            for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
                let node = patch.node(s, t);
                self.basis.raw(self.basis.frame().coordinates(&node), &mut raw);
                for (sum, row) in sums.iter_mut().zip(self.basis.transform().chunks_exact(count)) {
                    *sum += ws * wt * node.area * dot(row, &raw).abs();
                }
            }
        }
        sums
    }

    /// Whether a point of the element's plane lies in it, or nearer than `tolerance` (scene length) to one of
    /// its patches; false on curved elements.
    pub fn covers(&self, x: DVec3, tolerance: f64) -> bool {
        let Some(Plane { normal, .. }) = self.plane else { return false };
        self.patches.iter().any(|patch| overhang(&patch.corners(), normal, x) <= tolerance)
    }

    /// Disjoint patches that cover the part of it over the parameters `rect`; `shape` is that of its surface.
    pub(crate) fn patches_over(&self, shape: &dyn Surface, rect: &Rect) -> Vec<Patch> {
        let Some(common) = overlap(&self.rect, rect) else { return Vec::new() };
        let Some(Plane { normal, .. }) = self.plane else {
            return self.patches.iter().map(|patch| patch.with_parameters(&common)).collect();
        };
        let pieces: Vec<Vec<DVec3>> = self.patches.iter().map(Patch::polygon).collect();
        let parts = clip_to_cell(shape, &pieces, rect);
        parts.iter().flat_map(|part| Patch::of_polygon(part, normal)).collect()
    }

    /// Bounding box.
    pub fn bounds(&self) -> Aabb {
        Aabb::around(self.hull.iter().copied())
    }
}

/// Common part of two rectangles of parameters; None if it has no area.
pub(super) fn overlap(a: &Rect, b: &Rect) -> Option<Rect> {
    let common = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].min(b[1])];
    let (u, v) = (common(a.u, b.u), common(a.v, b.v));
    (u[0] < u[1] && v[0] < v[1]).then_some(Rect { u, v })
}

/// The part of a surface that becomes an element.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part<'a> {
    /// The shape of its surface.
    pub shape: &'a Arc<dyn Surface>,
    /// Convex pieces that contain it, where the surface is flat.
    pub pieces: &'a [Vec<DVec3>],
    /// The parameters it covers, as far as the pieces reach.
    pub rect: Rect,
    /// The contact by which it is covered.
    pub contact: Option<usize>,
    /// The surface that shades it.
    pub shaded_by: Option<usize>,
}

/// The element of one part of the surface number `index`; None where the part is empty (pieces below 1e-14 of
/// the surface are).
pub(super) fn element(
    index: usize,
    surface: &SceneSurface,
    part: Part,
    space: Space,
    order: usize,
) -> Result<Option<Element>, ElementError> {
    let Part { shape, pieces, rect, contact, shaded_by } = part;
    let thin = || ElementError::Thin { surface: surface.name.clone(), order };
    let (patches, plane) = match shape.region() {
        Some(region) => {
            let (patches, plane) = flat_patches(shape, pieces, region.area(), &rect);
            (patches, Some(plane))
        }
        None => (vec![Patch::curved(Arc::clone(shape), &rect)], None),
    };
    if patches.is_empty() {
        return Ok(None);
    }
    let frame = frame(shape.as_ref(), &patches, plane, &rect, contact.is_some());
    let measure = Measure::new(&patches, space.chart_degree(order, &patches));
    let basis = AreaBasis::over(&measure, space, order, frame, &patches).ok_or_else(thin)?;
    let area = measure.area();
    // φ₀ is constant, so ∫ φ dA = (√area, 0, …, 0) up to rounding; the exact vector makes the constant
    // function exact.
    let mut constant = vec![0.0; basis.len()];
    constant[0] = area.sqrt();
    let hull = match plane {
        Some(_) => patches.iter().flat_map(Patch::polygon).collect(),
        None => shape.hull(&rect),
    };
    let extent = Aabb::around(hull.iter().copied()).diagonal();
    let level = plane.or_else(|| plane_of(&patches));
    Ok(Some(Element {
        surface: index,
        rect,
        basis,
        patches,
        plane,
        level,
        area,
        constant,
        hull,
        extent,
        contact,
        shaded_by,
    }))
}

/// The patches of the part of flat `pieces` over `rect`, those below 1e-14 of the surface's `area` left out,
/// and its plane.
pub fn flat_patches(
    shape: &Arc<dyn Surface>,
    pieces: &[Vec<DVec3>],
    area: f64,
    rect: &Rect,
) -> (Vec<Patch>, Plane) {
    let jet = shape.jet(rect.center()[0], rect.center()[1]);
    let parts =
        if *rect == Rect::FULL { pieces.to_vec() } else { clip_to_cell(shape.as_ref(), pieces, rect) };
    let patches = parts
        .iter()
        .filter(|part| polygon_area(part) > 1e-14 * area)
        .flat_map(|part| Patch::of_polygon(part, jet.normal))
        .collect();
    (patches, Plane { point: jet.position, normal: jet.normal })
}

/// The frame for the patches of a cell; `is_cover`: they are any part of a surface instead of a cell.
fn frame(shape: &dyn Surface, patches: &[Patch], plane: Option<Plane>, rect: &Rect, is_cover: bool) -> Frame {
    let [u, v] = rect.center();
    match plane {
        Some(Plane { normal, .. }) => {
            let corners: Vec<DVec3> = patches.iter().flat_map(Patch::polygon).collect();
            let jet = shape.jet(u, v);
            let parallel =
                |x: DVec3, y: DVec3| x.cross(y).length() <= PARALLEL_DIRECTIONS * x.length() * y.length();
            // A parallelogram fills the frame along its own sides, ordered as the parameters along them.
            let sides = match patches {
                [patch] if patch.is_parallelogram() => {
                    let own = [corners[1] - corners[0], corners[3] - corners[0]];
                    let along = |d: DVec3| own.iter().any(|side| parallel(d, *side));
                    if along(jet.du) && along(jet.dv) { [jet.du, jet.dv] } else { own }
                }
                _ if is_cover => return Frame::along_diameter(&corners, normal),
                _ => [jet.du, jet.dv],
            };
            Frame::bounding(&corners, sides)
        }
        None => Frame::Parameters {
            center: DVec2::new(u, v),
            half: 0.5 * DVec2::new(rect.u[1] - rect.u[0], rect.v[1] - rect.v[0]),
        },
    }
}

/// The part of planar convex `pieces` over a rectangle of the parameters of a planar surface, whose parameter
/// lines are straight.
pub fn clip_to_cell(surface: &dyn Surface, pieces: &[Vec<DVec3>], rect: &Rect) -> Vec<Vec<DVec3>> {
    let at = |u: f64, v: f64| surface.jet(u, v);
    let corners = [
        at(rect.u[0], rect.v[0]),
        at(rect.u[1], rect.v[0]),
        at(rect.u[1], rect.v[1]),
        at(rect.u[0], rect.v[1]),
    ]
    .map(|jet| jet.position);
    let middle = corners.iter().sum::<DVec3>() * 0.25;
    let normal = at(0.0, 0.0).normal;
    let mut parts = pieces.to_vec();
    for k in 0..4 {
        let (start, end) = (corners[k], corners[(k + 1) % 4]);
        let inward = normal.cross(end - start).normalize();
        let inward = if inward.dot(middle - start) < 0.0 { -inward } else { inward };
        parts = parts.iter().map(|part| clip_polygon(part, start, inward)).filter(|p| p.len() > 2).collect();
    }
    parts
}
