//! Transforms: translations, rotations, scales, matrices and views, the first written done first.

use glam::{DAffine3, DMat3, DVec3};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::short;

use super::element::Element;
use crate::xform::sin_cos;

/// Largest part of the last row of a matrix, beside its last number, that is still none: matrices are written
/// with fewer than nine digits or computed with more. With a larger value a slight perspective would be left
/// out unsaid.
const PERSPECTIVE: f64 = 1e-9;

/// The transform that `name` is given in an element; none moves nothing.
///
/// # Errors
/// Steps that are not known or that lack numbers.
pub(super) fn of(element: &Element, name: &str) -> Result<DAffine3, Refusal> {
    let Some(transform) = element.property(name) else { return Ok(DAffine3::IDENTITY) };
    if transform.tag != "transform" {
        return Err(transform.refusal(
            format!("{name} is a <{}>", short(&transform.tag)),
            format!("write <transform name=\"{name}\"> with steps in it"),
        ));
    }
    let mut total = DAffine3::IDENTITY;
    for step in &transform.children {
        total = of_step(step.meet())? * total;
    }
    match total.is_finite() {
        true => Ok(total),
        false => Err(transform.refusal("the transform leads beyond all numbers", "write smaller numbers")),
    }
}

fn of_step(step: &Element) -> Result<DAffine3, Refusal> {
    match step.tag.as_str() {
        "translate" => Ok(DAffine3::from_translation(step.vector(0.0)?.into())),
        "scale" => Ok(DAffine3::from_scale(step.vector(1.0)?.into())),
        "rotate" => rotation(step),
        "lookat" => view(step),
        "matrix" => matrix(step),
        tag => Err(step.refusal(
            format!("<{}> is no step of a transform", short(tag)),
            "write translate, rotate, scale, lookat or matrix",
        )),
    }
}

/// A rotation by `angle` degrees about an axis through the origin, counter-clockwise seen from the axis' tip.
fn rotation(step: &Element) -> Result<DAffine3, Refusal> {
    let [angle] = step.numbers("angle")?[..] else {
        return Err(step.refusal("the angle is not one number", "write angle=\"90\", in degrees"));
    };
    let axis = DVec3::from(step.vector(0.0)?);
    let Some(axis) = axis.try_normalize() else {
        return Err(step.refusal("the axis of the rotation is 0", "write an axis: x=\"1\""));
    };
    let (sin, cos) = sin_cos(angle);
    // Rodrigues: x cos + (a × x) sin + a (a · x) (1 − cos).
    let turned = |x: DVec3| x * cos + axis.cross(x) * sin + axis * axis.dot(x) * (1.0 - cos);
    Ok(DAffine3::from_mat3(DMat3::from_cols(turned(DVec3::X), turned(DVec3::Y), turned(DVec3::Z))))
}

/// A view from `origin` to `target`: z becomes the way there, y is in the plane of it and of `up`, x points
/// to the left.
fn view(step: &Element) -> Result<DAffine3, Refusal> {
    let point = |name: &str| step.triple(name).map(DVec3::from);
    let (origin, target) = (point("origin")?, point("target")?);
    let up = step.attribute("up").map_or(Ok(DVec3::ZERO), |_| point("up"))?;
    let Some(way) = (target - origin).try_normalize() else {
        return Err(step.refusal("the view has no direction", "put target elsewhere than origin"));
    };
    let up = if up == DVec3::ZERO { way.any_orthonormal_vector() } else { up };
    let Some(left) = up.normalize_or_zero().cross(way).try_normalize() else {
        return Err(step.refusal("the view looks along its up", "write another up, or leave it out"));
    };
    Ok(DAffine3::from_mat3_translation(DMat3::from_cols(left, way.cross(left), way), origin))
}

/// A matrix of 9 or 16 numbers, row after row.
fn matrix(step: &Element) -> Result<DAffine3, Refusal> {
    let numbers = step.numbers("value")?;
    let side = match numbers.len() {
        9 => 3,
        16 => 4,
        count => {
            return Err(step.refusal(format!("a matrix has {count} numbers"), "write 9 or 16, row after row"));
        }
    };
    let at = |row: usize, column: usize| numbers[row * side + column];
    let column = |column: usize| DVec3::new(at(0, column), at(1, column), at(2, column));
    let linear = DMat3::from_cols(column(0), column(1), column(2));
    if side == 3 {
        return Ok(DAffine3::from_mat3(linear));
    }
    let size = at(3, 3);
    if size == 0.0 || (0..3).any(|column| at(3, column).abs() > PERSPECTIVE * size.abs()) {
        return Err(step.refusal(
            "the matrix is a perspective: its last row is not 0 0 0 1",
            "write a matrix of rotations, scales and translations",
        ));
    }
    Ok(DAffine3::from_mat3_translation(linear * size.recip(), column(3) / size))
}
