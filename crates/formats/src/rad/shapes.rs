//! The shapes of Radiance's surfaces.
//!
//! Source: Radiance reference manual, "Surfaces".

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::short;

use crate::model::Shape;
use crate::rad::scanner::Primitive;

/// The shape of a surface; none if the primitive is no surface with a shape.
///
/// # Errors
/// Another number of numbers than the shape needs, cones with radii of both signs, rings of radii below 0.
pub(super) fn shape(primitive: &Primitive) -> Result<Option<Shape>, Refusal> {
    let shape = match primitive.kind.as_str() {
        "polygon" => polygon(primitive)?,
        "sphere" | "bubble" => {
            let [x, y, z, radius] = numbers(primitive)?;
            let inward = (primitive.kind == "bubble") != (radius < 0.0);
            Shape::Sphere { center: DVec3::new(x, y, z), radius: radius.abs(), inward }
        }
        "cylinder" | "tube" => {
            let [x, y, z, end_x, end_y, end_z, radius] = numbers(primitive)?;
            let base = DVec3::new(x, y, z);
            let inward = (primitive.kind == "tube") != (radius < 0.0);
            Shape::Cylinder {
                base,
                axis: DVec3::new(end_x, end_y, end_z) - base,
                radius: radius.abs(),
                inward,
            }
        }
        "cone" | "cup" => cone(primitive)?,
        "ring" => ring(primitive)?,
        _ => return Ok(None),
    };
    Ok(Some(shape))
}

/// The numbers of a primitive that has exactly `N` of them.
fn numbers<const N: usize>(primitive: &Primitive) -> Result<[f64; N], Refusal> {
    primitive.reals[..].try_into().map_err(|_| wrong_count(primitive, &N.to_string()))
}

fn wrong_count(primitive: &Primitive, expected: &str) -> Refusal {
    let Primitive { kind, name, reals, .. } = primitive;
    Refusal::new(
        format!("the {kind} '{}' has {} numbers, {expected} are needed", short(name), reals.len()),
        "write them all, and their count before them",
    )
}

fn polygon(primitive: &Primitive) -> Result<Shape, Refusal> {
    let (points, rest) = primitive.reals.as_chunks::<3>();
    if points.len() < 3 || !rest.is_empty() {
        return Err(wrong_count(primitive, "3 for each of 3 vertices or more"));
    }
    Ok(Shape::Polygon { outline: points.iter().copied().map(DVec3::from_array).collect(), holes: Vec::new() })
}

fn cone(primitive: &Primitive) -> Result<Shape, Refusal> {
    let [x, y, z, end_x, end_y, end_z, first, second] = numbers(primitive)?;
    if first.min(second) < 0.0 && first.max(second) > 0.0 {
        return refuse(
            format!("the {} '{}' has radii of both signs", primitive.kind, short(&primitive.name)),
            "give both the sign alike; a cup is a cone seen from inside",
        );
    }
    let base = DVec3::new(x, y, z);
    // With radii below 0 one kind is the other.
    let inward = (primitive.kind == "cup") != (first.min(second) < 0.0);
    Ok(Shape::cone(base, DVec3::new(end_x, end_y, end_z) - base, [first.abs(), second.abs()], inward))
}

/// Radii of a ring come in any order.
fn ring(primitive: &Primitive) -> Result<Shape, Refusal> {
    let [x, y, z, normal_x, normal_y, normal_z, first, second] = numbers(primitive)?;
    if first < 0.0 || second < 0.0 {
        return refuse(
            format!("the ring '{}' has a radius below 0", short(&primitive.name)),
            "write 0 or more",
        );
    }
    Ok(Shape::Disk {
        center: DVec3::new(x, y, z),
        normal: DVec3::new(normal_x, normal_y, normal_z),
        radius: first.max(second),
        inner: first.min(second),
    })
}

/// The six faces of a box from the origin to a corner, as `genbox` makes them; they face outwards.
pub(super) fn genbox(corner: DVec3) -> Vec<Shape> {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z) * corner;
    let corners = [
        [at(0., 0., 0.), at(0., 1., 0.), at(1., 1., 0.), at(1., 0., 0.)],
        [at(0., 0., 1.), at(1., 0., 1.), at(1., 1., 1.), at(0., 1., 1.)],
        [at(0., 0., 0.), at(1., 0., 0.), at(1., 0., 1.), at(0., 0., 1.)],
        [at(0., 1., 0.), at(0., 1., 1.), at(1., 1., 1.), at(1., 1., 0.)],
        [at(0., 0., 0.), at(0., 0., 1.), at(0., 1., 1.), at(0., 1., 0.)],
        [at(1., 0., 0.), at(1., 1., 0.), at(1., 1., 1.), at(1., 0., 1.)],
    ];
    corners.map(|corners| Shape::Polygon { outline: corners.to_vec(), holes: Vec::new() }).into()
}
