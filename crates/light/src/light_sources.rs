//! Emitters as a point sees them one by one, and what each sends without shadows where that has a closed
//! form.
//!
//! ```text
//! U(x) = ∫ κ(x, y) dA_y        W m⁻² for the exitance 1
//! ```
//!
//! A flat element sends what Lambert's formula says; that of an opening to a sky is summed over its cells, which
//! are cut at the horizon of the point. A curved surface that shines evenly and hides nothing of
//! itself is one source, however many elements it has: a disk is a polygon of many corners, a ball has a
//! formula, and of other bent surfaces only the outline counts ([`super::area_light`]). Of luminous areas that
//! are no diffuse emitters, surfaces that hide a part of themselves, and what is near or reaches below the
//! receiver, rays have to tell U.

use radiosity_elements::Element;
use radiosity_geom::{Aabb, DVec3, Plane};
use radiosity_kernel::irradiance::ball::ball;
use radiosity_scene::Radiance;
use radiosity_visibility::Visibility;

use crate::area_light::{AreaLight, flat_outline, irradiance};
use crate::blockers::Extent;
use crate::cells::tree::Tree;
use crate::emitters::Emitters;
use crate::lamps::{Lamp, brightness};
use crate::occluders::{Occluders, Sender};
use crate::receiver_point::ReceiverPoint;
use crate::tolerances::{OUTLINE_FROM, PER_CELL};
use crate::traversal::Traversal;

/// Part of a surface's parameters that its elements may leave out by rounding.
const COVERED: f64 = 1e-9;

/// An emitter as one thing: an element, or a whole curved surface.
#[derive(Debug)]
pub(super) struct LightSource<'a> {
    /// Points on it for rays. Its element stands for all that belong to the source.
    pub(super) lamp: Lamp,
    /// Index of its surface.
    pub(super) surface: usize,
    hull: Vec<DVec3>,
    bounds: Aabb,
    form: Form<'a>,
}

/// Form in which a point sees an emitter.
#[derive(Debug)]
enum Form<'a> {
    /// Flat convex polygons.
    Polygons(Vec<Vec<DVec3>>),
    /// A ball.
    Ball { center: DVec3, radius: f64 },
    /// The outline of a curved surface.
    Outline(AreaLight<'a>),
    /// Cells of an opening to a sky, of exitance 1.
    Opening(Tree),
    /// Points for rays alone.
    Points,
}

impl<'a> LightSource<'a> {
    /// The sources of a scene, elements of one surface beside each other.
    pub(super) fn all(sources: &Emitters<'a>, visibility: &'a Visibility) -> Vec<Self> {
        let scale = vec![1.0; sources.coatings.len()];
        let lamp =
            |element| Lamp::of(sources.elements, element, brightness(&sources.coatings, &scale, element));
        let lamps: Vec<Lamp> = (0..sources.elements.len()).filter_map(lamp).collect();
        let surface = |lamp: &Lamp| sources.elements[lamp.element].surface;
        let mut all = Vec::new();
        let mut left = lamps.into_iter().peekable();
        while let Some(first) = left.next() {
            let own = surface(&first);
            let mut group = vec![first];
            while let Some(next) = left.next_if(|next| surface(next) == own) {
                group.push(next);
            }
            Self::add(group, sources, visibility, &mut all);
        }
        all
    }

    /// Adds the emitting elements of one surface, as one if they are seen as one.
    fn add(group: Vec<Lamp>, sources: &Emitters<'a>, visibility: &'a Visibility, all: &mut Vec<Self>) {
        let elements: Vec<&Element> = group.iter().map(|lamp| &sources.elements[lamp.element]).collect();
        let surface = elements[0].surface;
        let radiance = sources.radiances.of_surface(surface);
        let is_diffuse = radiance.is_none();
        let first = group[0].element;
        let shines_as_first = |lamp: &Lamp| {
            sources.coatings.iter().all(|own| own.exitance[lamp.element] == own.exitance[first])
        };
        let is_even = group.iter().all(shines_as_first);
        let is_one = is_diffuse && is_even && is_whole(&elements);
        let whole = if is_one { whole_form(&elements, visibility) } else { None };
        if let Some((form, plane)) = whole {
            let whole = group.into_iter().next().map(|lamp| lamp.whole(&elements, plane));
            return all.extend(whole.map(|lamp| Self::new(lamp, &elements, form)));
        }
        for (lamp, element) in group.into_iter().zip(elements) {
            let form = match element.plane {
                Some(_) if is_diffuse => {
                    Form::Polygons(element.patches.iter().map(|patch| patch.polygon()).collect())
                }
                Some(_) if radiance.is_some_and(Radiance::is_of_opening) => {
                    Form::Opening(Tree::uniform(element, 1.0).spread(radiance.cloned()))
                }
                _ => Form::Points,
            };
            all.push(Self::new(lamp, &[element], form));
        }
    }

    fn new(lamp: Lamp, elements: &[&Element], form: Form<'a>) -> Self {
        let hull: Vec<DVec3> = match &form {
            Form::Polygons(polygons) => polygons.concat(),
            _ => elements.iter().flat_map(|element| element.hull.iter().copied()).collect(),
        };
        let bounds = Aabb::around(hull.iter().copied());
        Self { lamp, surface: elements[0].surface, hull, bounds, form }
    }

    /// The emitter as a sender of light, for lists of occluders.
    pub(super) fn sender(&self) -> Sender {
        Sender { surface: self.surface, plane: self.lamp.plane(), bounds: self.bounds }
    }

    /// Extent of the emitter that may be hidden.
    pub(super) fn extent(&self) -> Extent<'_> {
        Extent { hull: &self.hull, center: self.bounds.center(), radius: 0.5 * self.bounds.diagonal() }
    }

    /// Whether it is an opening to a sky.
    pub(super) fn is_opening(&self) -> bool {
        matches!(self.form, Form::Opening(_))
    }

    /// Its bounding box.
    pub(super) fn bounds(&self) -> &Aabb {
        &self.bounds
    }

    /// The convex polygons that it consists of, if it is flat and diffuse.
    pub(super) fn polygons(&self) -> Option<&[Vec<DVec3>]> {
        match &self.form {
            Form::Polygons(polygons) => Some(polygons),
            _ => None,
        }
    }

    /// U(x) v of an opening to a sky behind `occluders`, to about the relative accuracy `eps`; None of other
    /// emitters.
    pub(super) fn through_opening(
        &self,
        receiver: &ReceiverPoint,
        visibility: &Visibility,
        occluders: &Occluders,
        eps: f64,
    ) -> Option<f64> {
        let Form::Opening(tree) = &self.form else { return None };
        let mut traversal = Traversal::new(receiver, visibility, occluders);
        let add = |traversal: &mut Traversal, index: usize, tolerance: f64, out: &mut [f64]| {
            traversal.add(index, tree, tolerance, out);
        };
        let factors =
            traversal.within_share(std::slice::from_ref(tree), PER_CELL * eps, 0.0, add, |own| own[0]);
        Some(factors[0])
    }

    /// Whether all `surfaces` only close it, and hide nothing of it from anywhere.
    pub(super) fn is_closed_by(&self, surfaces: &[usize]) -> bool {
        matches!(&self.form, Form::Outline(light) if light.is_closed_by(surfaces))
    }

    /// U(x), to about the relative accuracy `eps` where it has no closed form; None where rays have to tell.
    pub(super) fn whole(&self, receiver: &ReceiverPoint, visibility: &Visibility, eps: f64) -> Option<f64> {
        match &self.form {
            Form::Points => None,
            Form::Opening(_) => self.through_opening(receiver, visibility, &Occluders::nothing(), eps),
            Form::Polygons(polygons) => {
                Some(polygons.iter().map(|polygon| receiver.factor(polygon, [].iter())).sum())
            }
            Form::Ball { center, radius } => {
                let under =
                    receiver.ground.is_some_and(|ground| (center - receiver.position).dot(ground) < *radius);
                if under { None } else { ball(receiver.position, receiver.normal, *center, *radius) }
            }
            Form::Outline(light) => {
                let eye = receiver.position;
                if light.center.distance(eye) < OUTLINE_FROM * light.radius {
                    return None;
                }
                let sides = light.outline(eye);
                if !receiver.clears(light.center, light.radius) {
                    let corners: Vec<DVec3> = sides.iter().map(|side| side[0]).collect();
                    if receiver.is_above(&corners) {
                        return Some(0.0);
                    }
                    if !receiver.overlooks(&corners) {
                        return None;
                    }
                }
                Some(irradiance(eye, receiver.normal, &sides))
            }
        }
    }
}

/// Form of the whole of a curved surface, of which these are all elements, if it can be seen at once; and its
/// plane, if it is flat.
fn whole_form<'a>(elements: &[&Element], visibility: &'a Visibility) -> Option<(Form<'a>, Option<Plane>)> {
    let surface = elements[0].surface;
    let area = elements.iter().map(|element| element.area).sum();
    if let Some((center, radius)) =
        visibility.only_ball(&[surface]).filter(|_| !visibility.hides_itself(surface))
    {
        return Some((Form::Ball { center, radius }, None));
    }
    match flat_outline(visibility, surface, area) {
        Some((corners, normal)) => {
            let plane = Plane { point: corners[0], normal };
            Some((Form::Polygons(vec![corners]), Some(plane)))
        }
        None => Some((Form::Outline(AreaLight::rough(visibility, surface)?), None)),
    }
}

/// Whether elements of one surface cover all of a curved one.
fn is_whole(elements: &[&Element]) -> bool {
    let covered: f64 =
        elements.iter().map(|Element { rect, .. }| (rect.u[1] - rect.u[0]) * (rect.v[1] - rect.v[0])).sum();
    elements[0].plane.is_none() && covered >= 4.0 * (1.0 - COVERED)
}
