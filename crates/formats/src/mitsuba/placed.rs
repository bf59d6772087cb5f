//! Shapes where a transform puts them. Mirror images keep their fronts: normals are turned by the inverse
//! transpose, as in Mitsuba. So do meshes that state normals; of others the front is where the corners run
//! counter-clockwise once they are placed.

use glam::{DAffine3, DVec3};

use crate::model::Shape;
use radiosity_photometry::error::{Refusal, refuse};

/// Greatest relative difference of scales in two directions, and greatest deviation of two directions from a
/// right angle (radians), for a circle to be one. Chosen: matrices written with six digits are within.
const ROUND: f64 = 1e-5;

/// Cure for curved shapes that a transform distorts.
const CURE: &str = "scale it alike in all directions, or write it as a mesh (type=\"ply\")";

/// Directions that were at right angles and of length 1, after a transform.
struct Frame([DVec3; 3]);

impl Frame {
    /// The directions x, y and z.
    fn of(placed: &DAffine3) -> Self {
        let linear = placed.matrix3;
        Frame([linear.x_axis, linear.y_axis, linear.z_axis])
    }

    /// Directions around an axis, which comes last.
    fn around(placed: &DAffine3, axis: DVec3) -> Self {
        let (x, y) = axis.any_orthonormal_pair();
        Frame([x, y, axis].map(|direction| placed.transform_vector3(direction)))
    }

    /// Whether the directions `a` and `b` are still at right angles.
    fn is_square(&self, a: usize, b: usize) -> bool {
        let [a, b] = [self.0[a], self.0[b]];
        a.dot(b).abs() <= ROUND * a.length() * b.length()
    }

    /// Whether the directions `a` and `b` are still of one length, which is not 0.
    fn is_even(&self, a: usize, b: usize) -> bool {
        let [a, b] = [self.0[a].length(), self.0[b].length()];
        a > 0.0 && (a - b).abs() <= ROUND * a
    }

    /// Direction of the transformed plane's normal, on the side of the transformed z; of any length.
    fn normal(&self) -> DVec3 {
        let [x, y, z] = self.0;
        let normal = x.cross(y);
        if normal.dot(z) < 0.0 { -normal } else { normal }
    }
}

/// The square from −1 to 1 in x and y, its front towards z, or towards −z if it is flipped.
pub(super) fn rectangle(placed: &DAffine3, is_flipped: bool) -> Shape {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let outline = corners.map(|[x, y]| placed.transform_point3(DVec3::new(x, y, 0.0)));
    let [x, y, z] = Frame::of(placed).0;
    let is_mirrored = x.cross(y).dot(z) < 0.0;
    Shape::Polygon { outline: turned(outline.to_vec(), is_mirrored != is_flipped), holes: Vec::new() }
}

/// The six sides of the cube from −1 to 1, their fronts outwards, or inwards if it is flipped.
pub(super) fn cube(placed: &DAffine3, is_flipped: bool) -> Result<Vec<Shape>, Refusal> {
    let mirror = placed.matrix3.determinant();
    if mirror == 0.0 {
        return refuse("the transform makes the cube flat", "write it as a rectangle");
    }
    let side = |axis: usize, sign: f64| {
        let mut middle = DVec3::ZERO;
        middle[axis] = sign;
        let [mut a, mut b] = [DVec3::ZERO; 2];
        a[(axis + 1) % 3] = 1.0;
        b[(axis + 2) % 3] = sign;
        let corners = [-a - b, a - b, a + b, b - a];
        let outline = corners.map(|corner| placed.transform_point3(middle + corner));
        let outline = turned(outline.to_vec(), (mirror < 0.0) != is_flipped);
        Shape::Polygon { outline, holes: Vec::new() }
    };
    Ok([-1.0, 1.0]
        .into_iter()
        .flat_map(|sign| (0..3).map(move |axis| (axis, sign)))
        .map(|(axis, sign)| side(axis, sign))
        .collect())
}

/// The disk of radius 1 about the origin, its front towards z, or towards −z if it is flipped.
pub(super) fn disk(placed: &DAffine3, is_flipped: bool) -> Result<Shape, Refusal> {
    let frame = Frame::of(placed);
    if !frame.is_square(0, 1) || !frame.is_even(0, 1) {
        return refuse("the transform makes the disk an ellipse", CURE);
    }
    let normal = frame.normal().normalize_or_zero();
    Ok(Shape::Disk {
        center: placed.translation,
        normal: if is_flipped { -normal } else { normal },
        radius: frame.0[0].length(),
        inner: 0.0,
    })
}

/// The mantle of a cylinder between two points.
pub(super) fn cylinder(
    placed: &DAffine3,
    ends: [DVec3; 2],
    radius: f64,
    is_flipped: bool,
) -> Result<Shape, Refusal> {
    let Some(way) = (ends[1] - ends[0]).try_normalize() else {
        return refuse("the cylinder has no length", "part p0 and p1");
    };
    let frame = Frame::around(placed, way);
    let is_upright = frame.is_square(0, 2) && frame.is_square(1, 2);
    if !is_upright || !frame.is_square(0, 1) || !frame.is_even(0, 1) {
        return refuse("the transform makes the cylinder oblique or not round", CURE);
    }
    let [base, end] = ends.map(|point| placed.transform_point3(point));
    let radius = radius * frame.0[0].length();
    Ok(Shape::Cylinder { base, axis: end - base, radius, inward: is_flipped })
}

/// The sphere of a center and a radius, its front inside if it is flipped.
pub(super) fn sphere(
    placed: &DAffine3,
    center: DVec3,
    radius: f64,
    is_flipped: bool,
) -> Result<Shape, Refusal> {
    let frame = Frame::of(placed);
    let pairs = [(0, 1), (1, 2), (2, 0)];
    if !pairs.iter().all(|(a, b)| frame.is_square(*a, *b) && frame.is_even(*a, *b)) {
        return refuse("the transform makes the sphere an ellipsoid", CURE);
    }
    let radius = radius * frame.0[0].length();
    Ok(Shape::Sphere { center: placed.transform_point3(center), radius, inward: is_flipped })
}

/// Whether a transform is a mirror image (determinant below 0).
pub(super) fn is_mirror(placed: &DAffine3) -> bool {
    placed.matrix3.determinant() < 0.0
}

/// A flat shape of a mesh, its corners run through the other way round if it is turned.
pub(super) fn face(placed: &DAffine3, shape: &Shape, is_turned: bool) -> Shape {
    let point = |x| placed.transform_point3(x);
    let mut moved = shape.map(point, |vector| vector, |direction| direction, |length| length);
    if is_turned {
        moved.reverse_rings();
    }
    moved
}

/// The outline, the other way round if it is turned.
fn turned(mut outline: Vec<DVec3>, is_turned: bool) -> Vec<DVec3> {
    if is_turned {
        outline.reverse();
    }
    outline
}
