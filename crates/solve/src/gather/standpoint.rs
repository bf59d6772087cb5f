//! Where a sensor stands: on the uppermost face on its side, or in the open.
//!
//! Faces may lie on each other, in one plane or with a gap: mats on desks, pictures on walls, sheets on sheets.
//! The *side* of a sensor is the one that its normal looks to. Of the faces within a tolerance of the point, the
//! nearest one and all those that lie on that one, up to a gap that is none, make a *stack*; the sensor belongs
//! to the uppermost face of the stack on its side, whatever the order in the scene:
//!
//! ```text
//! stack = { i : |h_i − h_b| ≤ t_i } ,    h_b nearest to the point ,    uppermost = max h_i + rounding ,
//! ```
//!
//! where h is the height along the normal of the face that the sensor looks away from. Of fronts in one plane the
//! smallest counts: it was laid on the others. The point is moved onto that face, and aside from what touches it
//! there ([`SurfacePoint`]): coordinates that are typed are rounded. Where the uppermost is a back, of a face of
//! one side, the sensor stands just before it in the open. Where it looks along all faces that it touches, it stands
//! on the first of them that reaches on before it, and else, as on the edge of a sheet, a little before the point.
//! A face of one side that it looks at from a little before it, more than coordinates are rounded by, is seen and
//! not stood on, nor is what lies behind that face.
//!
//! A sensor that is tilted against its face sees what it would see just above it: nothing through the face, but
//! the face itself, below the horizon of which it has the part (1 − cos θ)/2 of its hemisphere. So what is read
//! does not change from the face to small heights over it.

use radiosity_elements::Elements;
use radiosity_geom::{Aabb, DVec3, Jet, Surface, layer_order, touching};
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_visibility::Visibility;

use crate::gather::surface_point::{INWARDS, OF_ITS_OWN, ON_SURFACE, SurfacePoint};

/// Part of a face's diagonal up to which a sensor on another one belongs to it: some sixteen roundings of single
/// precision, as a referee has it. With a larger value sensors under a sheet would get the light above it.
const NO_GAP: f64 = 1e-6;

/// Least cosine between the normals of faces of one stack (0.8°): bent ones are met beside their foot.
const ALIKE: f64 = 0.9999;

/// Cosine between the normals of a sensor and of a face up to which it looks along it: normals are typed with few
/// digits.
const ALONG: f64 = 1e-4;

/// Part of the scene's diagonal from which on a sensor before a face that it looks at sees it: more than sheets in
/// one plane are set apart by, as otherwise a sensor on a sheet would see one that lies on it face down.
const SEEN: f64 = 2e-7;

/// Where a sensor stands.
#[derive(Clone, Copy, Debug)]
pub enum Standpoint {
    /// On the front of a surface.
    On(SurfacePoint),
    /// On no front: in the air, on a black back, or on an edge.
    Open(ReceiverPoint),
}

impl Standpoint {
    /// The standpoint of a sensor at the point `x` with the unit normal `n`.
    pub fn find(elements: &Elements, visibility: &Visibility, x: DVec3, n: DVec3) -> Self {
        let diagonal = visibility.bounds().diagonal();
        let touched = without_seen(touched(elements, visibility, x), x, n, diagonal);
        if touched.is_empty() {
            return Self::Open(ReceiverPoint::free(x, n));
        }
        let size = touched.iter().map(|face| face.extent).fold(diagonal, f64::min);
        let Some(stack) = Stack::under(&touched, x, n) else {
            let before = x + INWARDS * size * n;
            let within = touched.iter().find(|face| face.reaches(elements, before, 0.5 * INWARDS * size, n));
            let point = within.and_then(|face| face.point(elements, &touched, diagonal));
            return point.map_or(Self::Open(ReceiverPoint::free(before, n)), Self::On);
        };
        stack.point(elements, diagonal).map_or_else(
            || {
                let position = stack.top.foot + INWARDS * size * stack.up;
                let ground = (stack.up != n).then_some(stack.up);
                Self::Open(ReceiverPoint { ground, ..ReceiverPoint::free(position, n) })
            },
            Self::On,
        )
    }

    /// The surface point, if the sensor stands on a surface.
    pub fn on(&self) -> Option<&SurfacePoint> {
        match self {
            Self::On(point) => Some(point),
            Self::Open(_) => None,
        }
    }

    /// The receiver of a sensor with the unit normal `n`, which does not see the surface that it stands on.
    pub fn receiver_point(&self, n: DVec3) -> ReceiverPoint {
        match self {
            Self::On(point) => point.receiver_point(n),
            Self::Open(receiver) => *receiver,
        }
    }
}

/// A face that a point touches.
#[derive(Clone, Copy, Debug)]
struct Touched {
    surface: usize,
    /// Parameters of the foot of the point.
    parameters: [f64; 2],
    foot: DVec3,
    /// Unit normal of the front there.
    normal: DVec3,
    /// Diagonal of the surface's box (scene length).
    extent: f64,
}

impl Touched {
    fn height(&self, x: DVec3, up: DVec3) -> f64 {
        (self.foot - x).dot(up)
    }

    /// Height of `x` over the front (scene length).
    fn distance(&self, x: DVec3) -> f64 {
        (x - self.foot).dot(self.normal)
    }

    /// Whether another face is the other side of this one.
    fn is_backed_by(&self, other: &Self, rounding: f64) -> bool {
        other.normal.dot(self.normal) <= -ALIKE && other.foot.distance(self.foot) <= rounding
    }

    /// Whether the foot of `x` is no farther than `step` behind it, along the unit vector `n`.
    fn reaches(&self, elements: &Elements, x: DVec3, step: f64, n: DVec3) -> bool {
        let (_, foot) = foot(elements.shape(self.surface), x);
        (foot.position - x).dot(n) > -step
    }

    /// The point of the surface, aside from what else is touched but lies in no plane with it, in a scene of this
    /// diagonal.
    fn point(&self, elements: &Elements, touched: &[Self], diagonal: f64) -> Option<SurfacePoint> {
        let beside = touched.iter().filter(|face| face.normal.dot(self.normal).abs() < ALIKE);
        let away = beside.map(|face| face.normal.reject_from(self.normal).normalize_or_zero()).sum();
        SurfacePoint::within(elements, self.surface, self.parameters, INWARDS * diagonal, away)
    }
}

/// The faces that a point touches.
fn touched(elements: &Elements, visibility: &Visibility, x: DVec3) -> Vec<Touched> {
    let tolerance = ON_SURFACE * visibility.bounds().diagonal();
    let face = |surface: usize| {
        let (shape, extent) = (elements.shape(surface), elements.extent(surface));
        let (parameters, jet) = foot(shape, x);
        let is_near = jet.position.distance(x) <= tolerance.min(OF_ITS_OWN * extent);
        let face = || Touched { surface, parameters, foot: jet.position, normal: jet.normal, extent };
        is_near.then(face)
    };
    let around = Aabb { min: x, max: x }.inflate(tolerance);
    visibility.near(&around).into_iter().filter_map(face).collect()
}

/// The faces without those that a sensor at `x` with the unit normal `n` sees, and what lies behind these, in a scene
/// of this diagonal.
fn without_seen(touched: Vec<Touched>, x: DVec3, n: DVec3, diagonal: f64) -> Vec<Touched> {
    let rounding = touching(0.0, diagonal);
    let is_seen = |face: &&Touched| {
        let is_faced = face.normal.dot(n) < -ALONG && face.distance(x) > SEEN * diagonal;
        is_faced && !touched.iter().any(|other| face.is_backed_by(other, rounding))
    };
    let nearer = |a: &&Touched, b: &&Touched| a.distance(x).total_cmp(&b.distance(x));
    let Some(seen) = touched.iter().filter(is_seen).min_by(nearer).copied() else { return touched };
    let is_before = |face: &Touched| (x - face.foot).dot(seen.normal) < seen.distance(x);
    touched.into_iter().filter(is_before).collect()
}

/// The point of a surface that is nearest to `x`, and its parameters.
fn foot(shape: &dyn Surface, x: DVec3) -> ([f64; 2], Jet) {
    let foot = shape.project(shape.region().map_or(x, |region| region.nearest(x)));
    ([foot.u, foot.v], shape.jet(foot.u, foot.v))
}

/// Faces on each other.
struct Stack<'a> {
    /// All faces that the point touches.
    touched: &'a [Touched],
    /// The faces of the stack.
    faces: Vec<&'a Touched>,
    /// Unit normal of the side that the sensor looks to.
    up: DVec3,
    /// The uppermost of the stack.
    top: &'a Touched,
}

impl<'a> Stack<'a> {
    /// The stack under a sensor at `x` with the unit normal `n`; None where it looks along all that it touches.
    fn under(touched: &'a [Touched], x: DVec3, n: DVec3) -> Option<Self> {
        let up = side(touched, n)?;
        let is_alike = |face: &&Touched| face.normal.dot(up).abs() >= ALIKE;
        let alike = || touched.iter().filter(is_alike);
        let nearer = |a: &&Touched, b: &&Touched| a.foot.distance(x).total_cmp(&b.foot.distance(x));
        let base = alike().min_by(nearer)?;
        let lies_on = |face: &&Touched| {
            let gap = (face.foot - base.foot).dot(up).abs();
            gap <= NO_GAP * face.extent
        };
        let faces: Vec<&Touched> = alike().filter(lies_on).collect();
        let lower = |a: &&&Touched, b: &&&Touched| a.height(x, up).total_cmp(&b.height(x, up));
        let top = faces.iter().max_by(lower)?;
        Some(Self { touched, up, top, faces })
    }

    /// The point of the smallest of the fronts that lie uppermost, if one does, in a scene of this diagonal.
    fn point(&self, elements: &Elements, diagonal: f64) -> Option<SurfacePoint> {
        let rounding = touching(0.0, diagonal);
        let is_front = |face: &&&Touched| {
            face.normal.dot(self.up) > 0.0 && face.height(self.top.foot, self.up) >= -rounding
        };
        let area = |face: &Touched| elements.shape(face.surface).area();
        let upper = |a: &&&Touched, b: &&&Touched| layer_order(area(b), area(a));
        self.faces.iter().filter(is_front).min_by(upper)?.point(elements, self.touched, diagonal)
    }
}

/// Unit normal of the side that a sensor with the unit normal `n` looks to from one of the faces: that nearest to
/// n, of a front where it looks away from one.
fn side(touched: &[Touched], n: DVec3) -> Option<DVec3> {
    let up = |side: f64| {
        let normals = touched.iter().map(move |face| side * face.normal);
        let faced = normals.filter(|normal| normal.dot(n) > ALONG);
        faced.reduce(|best, normal| if normal.dot(n) > best.dot(n) { normal } else { best })
    };
    up(1.0).or_else(|| up(-1.0))
}
