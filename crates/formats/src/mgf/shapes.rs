//! The shapes of MGF's geometric entities.
//!
//! Source: MGF 2.0, entities `f`, `fh`, `sph`, `cyl`, `cone`, `ring`, `torus`, `prism`.

use glam::DVec3;
use radiosity_geom::area_vector;

use crate::model::Shape;
use radiosity_photometry::error::{Refusal, refuse};

/// A vertex: a point, and a direction where one is needed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Vertex {
    /// Position of the vertex (length).
    pub(super) point: DVec3,
    /// Normal of the vertex, zero for none.
    pub(super) normal: DVec3,
}

/// Entity `f`: a polygon, or a bilinear patch if its four corners lie in no plane.
///
/// # Errors
/// Fewer than three points.
pub(super) fn face(outline: Vec<DVec3>) -> Result<Shape, Refusal> {
    match outline.len() {
        0..3 => refuse(
            format!("a face has {} vertices, 3 are the least", outline.len()),
            "add some, or take it out",
        ),
        _ => Ok(Shape::face(outline)),
    }
}

/// Entity `fh`: the outline, then the holes.
///
/// # Errors
/// An outline or a hole of fewer than three points.
pub(super) fn face_with_holes(mut loops: Vec<Vec<DVec3>>) -> Result<Shape, Refusal> {
    if let Some(short) = loops.iter().find(|points| points.len() < 3) {
        return refuse(
            format!("an outline of a face has {} vertices, 3 are the least", short.len()),
            "add some, or take it out; a - parts outlines",
        );
    }
    match loops.len() {
        1 => face(loops.remove(0)),
        _ => Ok(Shape::Polygon { outline: loops.remove(0), holes: loops }),
    }
}

/// Entity `sph`: a sphere, seen from inside if the radius is below 0.
pub(super) fn sphere(center: DVec3, radius: f64) -> Shape {
    Shape::Sphere { center, radius: radius.abs(), inward: radius < 0.0 }
}

/// Entities `cyl` and `cone`: ends with their radii.
///
/// # Errors
/// Radii of different signs.
pub(super) fn cone([base, end]: [DVec3; 2], radii: [f64; 2]) -> Result<Shape, Refusal> {
    let axis = end - base;
    let inward = radii[0] < 0.0 || radii[1] < 0.0;
    if inward && (radii[0] > 0.0 || radii[1] > 0.0) {
        return refuse(
            "the radii of a cone have different signs",
            "write both above 0, or both below for a cone seen from inside",
        );
    }
    Ok(Shape::cone(base, axis, radii.map(f64::abs), inward))
}

/// Entity `ring`: a ring, or a disk if the inner radius is 0.
///
/// # Errors
/// No normal, radii in disorder.
pub(super) fn ring(vertex: Vertex, inner: f64, radius: f64) -> Result<Shape, Refusal> {
    check_normal(vertex, "ring")?;
    if inner < 0.0 || inner >= radius {
        return refuse(
            "the radii of a ring are not in order",
            "write the inner one, 0 or more, then the outer",
        );
    }
    Ok(Shape::Disk { center: vertex.point, normal: vertex.normal, radius, inner })
}

/// Entity `torus`: its least and greatest distance from the axis, both below 0 if its front is the inside.
///
/// # Errors
/// No normal, radii in disorder.
pub(super) fn torus(vertex: Vertex, least: f64, most: f64) -> Result<Shape, Refusal> {
    check_normal(vertex, "torus")?;
    let inward = least < 0.0 || most < 0.0;
    let sign = if inward { -1.0 } else { 1.0 };
    let (least, most) = (sign * least, sign * most);
    if least < 0.0 || least >= most {
        return refuse(
            "the radii of a torus are not in order",
            "write the smaller one, then the greater, both of one sign",
        );
    }
    Ok(Shape::Torus {
        center: vertex.point,
        axis: vertex.normal,
        major: 0.5 * (least + most),
        minor: 0.5 * (most - least),
        inward,
    })
}

fn check_normal(vertex: Vertex, kind: &str) -> Result<(), Refusal> {
    match vertex.normal == DVec3::ZERO {
        true => {
            refuse(format!("the vertex of a {kind} has no normal"), "write one behind its point: n 0 0 1")
        }
        false => Ok(()),
    }
}

/// Entity `prism`: its faces, the given one first, its opposite last. They face outwards; with a length below
/// 0, inwards.
///
/// # Errors
/// Fewer than three points, no area, no length.
pub(super) fn prism(outline: Vec<DVec3>, length: f64) -> Result<Vec<Shape>, Refusal> {
    let normal = area_vector(&outline).normalize_or_zero();
    if length == 0.0 || normal == DVec3::ZERO {
        return refuse("a prism has no volume", "give it a length and an end with an area");
    }
    let far: Vec<DVec3> = outline.iter().map(|point| *point - length * normal).collect();
    let mut faces = vec![outline.clone()];
    for (index, (near, below)) in outline.iter().zip(&far).enumerate() {
        let next = (index + 1) % outline.len();
        faces.push(vec![*near, *below, far[next], outline[next]]);
    }
    faces.push(far.into_iter().rev().collect());
    faces.into_iter().map(face).collect()
}
