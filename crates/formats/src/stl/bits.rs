//! Binary STL: 80 bytes of any kind, the number of triangles, and 50 bytes for each: a normal, three corners,
//! and a word that programs use for colours; little-endian.

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse_at};
use radiosity_photometry::file_place::FilePlace;

use crate::mesh::{Coat, Mesh};
use crate::model::Sides;
use crate::scalar::Scalar;

const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// Whether the bytes are a binary STL: as long as the number of triangles says, or no text that begins with
/// `solid`.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
    let is_solid = start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"));
    match count(bytes) {
        Some(count) if length(count) == Some(bytes.len()) => true,
        Some(_) => !is_solid || bytes.contains(&0),
        None => !is_solid && !bytes.is_ascii(),
    }
}

/// The number of triangles that the header states.
fn count(bytes: &[u8]) -> Option<usize> {
    usize::try_from(u32::from_le_bytes(*bytes.get(HEADER - 4..)?.first_chunk()?)).ok()
}

/// The bytes that so many triangles take.
fn length(count: usize) -> Option<usize> {
    count.checked_mul(TRIANGLE)?.checked_add(HEADER)
}

/// Adds the triangles of a binary STL.
pub(super) fn read(bytes: &[u8], mesh: &mut Mesh) -> Result<(), Refusal> {
    let Some(count) = count(bytes) else {
        return refuse_at(
            FilePlace::Byte(bytes.len()),
            format!("the file ends after {} bytes; a binary STL has a header of {HEADER}", bytes.len()),
            "export it again; a text STL begins with 'solid'",
        );
    };
    if length(count).is_none_or(|length| length > bytes.len()) {
        return refuse_at(
            FilePlace::Byte(HEADER - 4),
            format!("{count} triangles are announced, {} are there", (bytes.len() - HEADER) / TRIANGLE),
            "export it again; a text STL begins with 'solid'",
        );
    }
    let object = mesh.object(None);
    let body = &bytes[HEADER..];
    for (index, part) in body.chunks_exact(TRIANGLE).take(count).enumerate() {
        let place = FilePlace::Byte(HEADER + index * TRIANGLE);
        triangle(part, object, mesh, place)?;
    }
    if length(count) != Some(bytes.len()) {
        mesh.model.note("bytes behind the last triangle are left out", length(count).map(FilePlace::Byte));
    }
    Ok(())
}

fn triangle(part: &[u8], object: usize, mesh: &mut Mesh, place: FilePlace) -> Result<(), Refusal> {
    let numbers: Vec<f64> = part[..48].chunks_exact(4).filter_map(|bytes| Scalar::F32.read(bytes)).collect();
    let corners: Vec<DVec3> = numbers.chunks_exact(3).skip(1).map(DVec3::from_slice).collect();
    if !corners.iter().all(|corner| corner.is_finite()) {
        return refuse_at(
            place,
            "a coordinate of this triangle is not finite",
            "export the model again, or take the triangle out",
        );
    }
    if part[48..].iter().any(|byte| *byte != 0) {
        mesh.model.note("attributes of triangles are left out", Some(place));
    }
    let coat = Coat { object, material: None, sides: Sides::Open };
    mesh.face(corners, coat, place).map_err(|fault| fault.at(place))
}
