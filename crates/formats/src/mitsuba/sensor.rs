//! Sensors: the camera.

use glam::DVec3;
use radiosity_photometry::error::Refusal;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::{number, short};

use super::element::{Element, Remarks};
use super::ids::Ids;
use super::transforms;
use crate::model::Camera;

/// Pixels along and down, where the scene does not say. Source: Mitsuba's `hdrfilm`.
const SIZE: [u32; 2] = [768, 576];

/// Most pixels along or down; a larger number is a slip.
const MOST: f64 = 65536.0;

/// Focal length (mm) where the scene states no angle, and the film it refers to (mm): Mitsuba's own.
const FOCAL_LENGTH: &str = "50mm";
const FILM: [f64; 2] = [36.0, 24.0];

/// The camera of a sensor; none if it is of a type that is left out.
///
/// # Errors
/// Angles and sizes out of range, a transform that leaves no direction.
pub(super) fn camera<'a>(
    sensor: &'a Element,
    ids: &Ids<'a>,
    remarks: &mut Remarks,
) -> Result<Option<Camera>, Refusal> {
    for child in &sensor.children {
        if ids.tag(child).is_ok_and(|tag| tag == "medium") {
            child.pass_over();
            remarks.add("the medium around the camera is left out", child);
        }
    }
    match sensor.meet().kind() {
        "perspective" => {}
        "thinlens" => {
            sensor.pass_over();
            remarks.add("the lens of the camera is left out", sensor);
        }
        kind => {
            sensor.pass_over();
            let text = NoteText::from("sensors of type ").quoting(format!("'{}'", short(kind)));
            remarks.add(text.then(" are left out"), sensor);
            return Ok(None);
        }
    }
    let placed = transforms::of(sensor, "to_world")?;
    let frame = placed.matrix3;
    let (way, up) = (frame.z_axis.normalize_or_zero(), frame.y_axis.normalize_or_zero());
    if way == DVec3::ZERO || way.cross(up) == DVec3::ZERO {
        return Err(sensor.refusal("the transform leaves the camera no direction", "write a <lookat> in it"));
    }
    if frame.determinant() < 0.0 {
        remarks.add("pictures are not mirrored, though the transform of the camera is", sensor);
    }
    let size = size(sensor, ids)?;
    let [width, height] = size.unwrap_or(SIZE).map(f64::from);
    let fov = angle(sensor, width / height)?;
    Ok(Some(Camera { eye: placed.translation, target: placed.translation + way, up, fov, size }))
}

/// Pixels along and down, if the film states them.
fn size<'a>(sensor: &'a Element, ids: &Ids<'a>) -> Result<Option<[u32; 2]>, Refusal> {
    for child in sensor.children.iter().filter(|child| matches!(child.tag.as_str(), "film" | "ref")) {
        let film = ids.meant(child)?;
        if film.tag != "film" {
            continue;
        }
        let mut size = SIZE;
        let mut is_stated = false;
        for (pixels, name) in size.iter_mut().zip(["width", "height"]) {
            let Some(stated) = film.float(name)? else { continue };
            if !(1.0..=MOST).contains(&stated) || stated.fract() != 0.0 {
                return Err(film.refusal(
                    format!("the {name} of the film is {stated}"),
                    format!("write a whole number from 1 to {MOST}"),
                ));
            }
            *pixels = stated as u32;
            is_stated = true;
        }
        return Ok(is_stated.then_some(size));
    }
    Ok(None)
}

/// The angle from the lower to the upper border, degrees; `aspect` is width over height.
fn angle(sensor: &Element, aspect: f64) -> Result<f64, Refusal> {
    // Half the height of the picture at distance 1.
    let half = match sensor.float("fov")? {
        None => FILM[0].hypot(FILM[1]) / (2.0 * focal_length(sensor)?) / aspect.hypot(1.0),
        Some(fov) if fov > 0.0 && fov < 180.0 => (fov / 2.0).to_radians().tan() / height(sensor, aspect)?,
        Some(fov) => {
            return Err(
                sensor.refusal(format!("fov is {fov}"), "write an angle above 0 and below 180 degrees")
            );
        }
    };
    Ok(2.0 * half.atan().to_degrees())
}

/// The extent of a picture along the axis that the angle is measured on, over its height.
fn height(sensor: &Element, aspect: f64) -> Result<f64, Refusal> {
    match sensor.string("fov_axis")?.unwrap_or("x").trim().to_ascii_lowercase().as_str() {
        "x" => Ok(aspect),
        "y" => Ok(1.0),
        "smaller" => Ok(aspect.min(1.0)),
        "larger" => Ok(aspect.max(1.0)),
        "diagonal" => Ok(aspect.hypot(1.0)),
        word => Err(sensor
            .refusal(format!("fov_axis is '{}'", short(word)), "write x, y, smaller, larger or diagonal")),
    }
}

/// Distance of the film (mm).
fn focal_length(sensor: &Element) -> Result<f64, Refusal> {
    let word = sensor.string("focal_length")?.unwrap_or(FOCAL_LENGTH).trim();
    let length = number(word.strip_suffix("mm").unwrap_or(word).trim(), "focal_length");
    match length.map_err(|fault| sensor.at(fault))? {
        length if length > 0.0 => Ok(length),
        _ => Err(sensor.refusal("focal_length is not above 0", "write a length in millimetres: 50mm")),
    }
}
