//! Jumps of light where it should be continuous.
//!
//! ```text
//! jump = |X⁺ − X⁻| / max(|X⁺|, |X⁻|) ,     largest over bands and places
//! ```
//!
//! X is the radiosity B at seams between the elements of one surface, and the irradiance E at joints, where the
//! border of a surface lies on another one that has the same normal there: their reflectances may differ, but
//! light falls on both alike. Galerkin solutions jump by about their error (Zatz 1993, sections 9 and 10).

use radiosity_elements::{Element, Elements};
use radiosity_geom::{Aabb, Bvh, DVec3, Foot, PARALLEL_PLANES, Rect, sides, touching};

use crate::solution::{Solution, SurfacePlace};

/// Places along the side of an element or of a surface at which light is compared.
const PLACES: [f64; 5] = [0.1, 0.3, 0.5, 0.7, 0.9];

/// Parameters by which a place on the border of a surface is moved into it to find its element.
const INTO: f64 = 1e-9;

/// The largest jump of irradiance across a joint of two surfaces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointJump {
    /// The jump over the larger of the two irradiances.
    pub jump: f64,
    /// Indices of the surfaces.
    pub surfaces: [usize; 2],
}

/// A point on a side of an element's rectangle.
struct SeamPoint {
    /// (u, v).
    parameters: [f64; 2],
    /// Direction across the side, in (u, v).
    across: [f64; 2],
}

/// An element, and a place of its surface.
#[derive(Clone, Copy)]
struct Spot {
    element: usize,
    place: SurfacePlace,
}

/// The largest jump of B across the seams inside a surface.
pub(super) fn seam_jump(solution: &Solution) -> f64 {
    let elements = solution.elements();
    let radiosity = |band: usize, spot: &Spot| solution.radiosity(band, spot.element, &spot.place);
    let mut largest = 0.0f64;
    for (index, element) in elements.list().iter().enumerate() {
        for SeamPoint { parameters, across } in seam_points(element) {
            let Some(other) = elements.across_seam(element.surface, parameters, across) else { continue };
            let position = elements.shape(element.surface).jet(parameters[0], parameters[1]).position;
            let place = SurfacePlace { surface: element.surface, parameters, position };
            let spots = [index, other].map(|element| Spot { element, place });
            largest = largest.max(relative_jump(solution, &spots, radiosity));
        }
    }
    largest
}

/// The largest jump of E across the joints at which two surfaces go on smoothly; None without such joints. For
/// 10⁴ surfaces this takes about half as long as their light by rays.
pub fn joint_jump(solution: &Solution) -> Option<JointJump> {
    let joints = Joints::of(solution.elements());
    let irradiance = |band: usize, spot: &Spot| solution.irradiance(band, spot.element, &spot.place);
    let mut largest: Option<JointJump> = None;
    for own in 0..joints.boxes.len() {
        for spots in joints.of_surface(own) {
            let jump = relative_jump(solution, &spots, irradiance);
            let surfaces = spots.map(|spot| spot.place.surface);
            if largest.is_none_or(|largest| jump > largest.jump) && !joints.are_parted(&spots) {
                largest = Some(JointJump {
                    jump,
                    surfaces: [surfaces[0].min(surfaces[1]), surfaces[0].max(surfaces[1])],
                });
            }
        }
    }
    largest
}

/// Surfaces by place.
struct Joints<'a> {
    elements: &'a Elements,
    boxes: Vec<Aabb>,
    tree: Bvh,
}

impl<'a> Joints<'a> {
    fn of(elements: &'a Elements) -> Self {
        let bounds = |surface| elements.shape(surface).bounds(&Rect::FULL);
        let boxes: Vec<Aabb> = (0..elements.surfaces()).map(bounds).collect();
        Self { elements, tree: Bvh::build(&boxes), boxes }
    }

    /// The places on the border of a surface at which others go on smoothly, on both of the surfaces.
    fn of_surface(&self, own: usize) -> Vec<[Spot; 2]> {
        let around = self.boxes[own].inflate(self.reach(own));
        let may_join = |other: &usize| *other != own && may_be_smooth(self.elements, [own, *other]);
        let others: Vec<usize> = self.tree.near(&around).into_iter().filter(may_join).collect();
        if others.is_empty() {
            return Vec::new();
        }
        let met = |spot: Spot| {
            let beyond = others.iter().filter_map(move |other| self.met(&spot.place, *other));
            beyond.map(move |beyond| [spot, beyond]).collect::<Vec<_>>()
        };
        border(self.elements, own).into_iter().flat_map(met).collect()
    }

    /// The spot of `surface` where a place of another one lies on it, with the same normal.
    fn met(&self, place: &SurfacePlace, surface: usize) -> Option<Spot> {
        let foot = self.touched(place, surface)?;
        let [u, v] = place.parameters;
        let normal = self.elements.shape(place.surface).jet(u, v).normal;
        let there = self.elements.shape(surface).jet(foot.u, foot.v).normal;
        if is_one_normal(normal, there) { spot(self.elements, surface, [foot.u, foot.v]) } else { None }
    }

    /// Whether a third surface stands on the joint, such as a wall between two rooms.
    fn are_parted(&self, spots: &[Spot; 2]) -> bool {
        let place = &spots[0].place;
        let [u, v] = place.parameters;
        let normal = self.elements.shape(place.surface).jet(u, v).normal;
        let around = Aabb::around([place.position]).inflate(self.reach(place.surface));
        self.tree
            .near(&around)
            .into_iter()
            .filter(|third| spots.iter().all(|spot| spot.place.surface != *third))
            .any(|third| {
                let stands = |foot: Foot| {
                    self.elements.shape(third).jet(foot.u, foot.v).normal.cross(normal).length()
                        > PARALLEL_PLANES
                };
                self.touched(place, third).is_some_and(stands)
            })
    }

    /// The place of `surface` on which another place lies, if it does.
    fn touched(&self, place: &SurfacePlace, surface: usize) -> Option<Foot> {
        let (shape, reach) = (self.elements.shape(surface), self.reach(surface));
        if self.boxes[surface].distance_squared(place.position) > reach * reach {
            return None;
        }
        if shape.region().is_some_and(|region| !region.contains(place.position)) {
            return None;
        }
        Some(shape.project(place.position)).filter(|foot| foot.distance <= reach)
    }

    /// Distance below which a place lies on a surface (scene length).
    fn reach(&self, surface: usize) -> f64 {
        touching(self.boxes[surface].diagonal(), 0.0)
    }
}

/// Largest jump of a quantity between two spots, over the bands.
fn relative_jump(solution: &Solution, spots: &[Spot; 2], quantity: impl Fn(usize, &Spot) -> f64) -> f64 {
    let jump = |band: usize| {
        let [here, there] = spots.each_ref().map(|spot| quantity(band, spot));
        let scale = here.abs().max(there.abs());
        if scale > 0.0 { (here - there).abs() / scale } else { 0.0 }
    };
    (0..solution.bands().len()).map(jump).fold(0.0, f64::max)
}

/// Points on the far sides of an element's rectangle.
fn seam_points(element: &Element) -> impl Iterator<Item = SeamPoint> {
    let rect = element.rect;
    PLACES.into_iter().flat_map(move |x| {
        let (u, v) = (rect.u[0] + x * (rect.u[1] - rect.u[0]), rect.v[0] + x * (rect.v[1] - rect.v[0]));
        [
            SeamPoint { parameters: [rect.u[1], v], across: [1.0, 0.0] },
            SeamPoint { parameters: [u, rect.v[1]], across: [0.0, 1.0] },
        ]
    })
}

/// Whether two surfaces may have one normal at a place: not if both are planar and their planes differ.
fn may_be_smooth(elements: &Elements, surfaces: [usize; 2]) -> bool {
    let normal = |surface: usize| elements.shape(surface).region().map(|region| region.normal());
    match surfaces.map(normal) {
        [Some(a), Some(b)] => is_one_normal(a, b),
        _ => true,
    }
}

fn is_one_normal(a: DVec3, b: DVec3) -> bool {
    a.dot(b) > 0.0 && a.cross(b).length() <= PARALLEL_PLANES
}

/// Spots along the border of a surface: the sides of its outline, or of its parameters if it is curved.
fn border(elements: &Elements, surface: usize) -> Vec<Spot> {
    let shape = elements.shape(surface);
    let parameters: Vec<[f64; 2]> = match shape.region() {
        Some(region) => sides(region.outer())
            .flat_map(|[a, b]| PLACES.map(|x| a.lerp(b, x)))
            .map(|point| shape.project(point))
            .map(|foot| [foot.u, foot.v])
            .collect(),
        None => PLACES
            .iter()
            .map(|x| 2.0 * x - 1.0)
            .flat_map(|x| [[-1.0, x], [1.0, x], [x, -1.0], [x, 1.0]])
            .collect(),
    };
    parameters.into_iter().filter_map(|at| spot(elements, surface, at)).collect()
}

fn spot(elements: &Elements, surface: usize, parameters: [f64; 2]) -> Option<Spot> {
    let inside = parameters.map(|x| x.clamp(INTO - 1.0, 1.0 - INTO));
    // What covers a part of a surface is not beside it.
    let element = elements.at(surface, inside).filter(|index| elements.list()[*index].is_cell())?;
    let position = elements.shape(surface).jet(parameters[0], parameters[1]).position;
    Some(Spot { element, place: SurfacePlace { surface, parameters, position } })
}
