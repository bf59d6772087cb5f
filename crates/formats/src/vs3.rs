//! Reads View3D input, `.vs3` (manual of View3D 3.5, sections 3.1 and 4.1; where it differs from the program,
//! the program).
//!
//! Each line begins with a letter, in upper or lower case; blanks and commas part words; `!` and `/` begin
//! comments.
//!
//! * `T` title.
//! * `C` control words: how factors are integrated and printed. Only `encl=1`, which adjusts factors to an
//!   enclosure, is noted.
//! * `F 3` or `F 3a` (`G 3`, `G 4` in old files): vertices by number, or each surface in a plane of its own.
//!   A surface's own line tells which it is.
//! * `V number x y z`
//! * `S number v1 v2 v3 v4 base cmb emit name`: a surface, its vertices counter-clockwise seen from the
//!   front, which alone radiates; v4 = 0 for a triangle. `emit` is the emittance ε, so that the reflectance
//!   is 1 − ε. `base` > 0: it lies on the surface of this number, as a window lies in a wall, and the base
//!   gets a hole there. `cmb` > 0: View3D adds its factors to those of the surface of this number; here it
//!   stays a surface of its own.
//! * `S number R|Q|T base cmb emit name` and numbers in the lines behind: the form `3a`.
//! * `M`, `N` …: a masking or null surface: it lies on its base and takes this part of it from the view. The
//!   base gets a hole, which a black surface fills.
//! * `O number v1 v2 v3 v4 name`: an obstruction: it only blocks the view. It is black.
//! * `E` or `*` ends the data.

mod plane;
mod statements;
pub mod write;

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse, refuse_at};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::decode;

use self::statements::{Corners, Input, OBSTRUCTION, Statement, SurfaceRole};
use crate::builder::{Coat, ModelBuilder};
use crate::model::{Model, Shape, Sides};
use crate::tolerances::{GREATEST, STEPS_OF_EMITTANCE};
use radiosity_photometry::files::Files;

/// Greatest distance of a surface from the plane of its base, in multiples of the base's size, as View3D
/// allows it.
const OFF_PLANE: f64 = 1e-5;

/// Reads the View3D input `bytes` of `file`.
///
/// # Errors
/// A statement that View3D does not have, numbers out of order or out of range, a base that cannot be one.
pub fn read(file: &str, bytes: &[u8], _files: &dyn Files) -> Result<Model, Refusal> {
    let text = decode(bytes).map_err(|fault| fault.in_file(file))?;
    let input = Input::of(&text).map_err(|refusal| refusal.in_file(file))?;
    if input.surfaces.is_empty() {
        let cure = "add lines that begin with S, or name its format";
        return Err(Refusal::new("there are no surfaces", cure).in_file(file));
    }
    let outlines = outlines(&input).map_err(|refusal| refusal.in_file(file))?;
    let holes = holes(&input, &outlines).map_err(|refusal| refusal.in_file(file))?;
    model(&input, outlines, holes).map_err(|refusal| refusal.in_file(file))
}

/// The corners of each surface.
fn outlines(input: &Input) -> Result<Vec<Vec<DVec3>>, Refusal> {
    let corners = |statement: &Statement| {
        outline(input, statement).map_err(|refusal| refusal.at(FilePlace::Line(statement.line)))
    };
    input.surfaces.iter().map(corners).collect()
}

fn outline(input: &Input, surface: &Statement) -> Result<Vec<DVec3>, Refusal> {
    let points = match &surface.corners {
        Corners::Points(points) => points.clone(),
        Corners::Numbers(numbers) => {
            numbers.iter().map(|number| vertex(&input.vertices, *number)).collect::<Result<_, _>>()?
        }
    };
    match points.iter().all(|point| point.is_finite() && point.abs().max_element() <= GREATEST) {
        true => Ok(points),
        false => refuse(format!("a coordinate is beyond {GREATEST:e}"), "write smaller coordinates"),
    }
}

fn vertex(vertices: &[DVec3], number: usize) -> Result<DVec3, Refusal> {
    let found = number.checked_sub(1).and_then(|index| vertices.get(index));
    found.copied().ok_or_else(|| {
        Refusal::new(
            format!("there is no vertex {number}"),
            format!("name one from 1 to {}; only the fourth may be 0, in a triangle", vertices.len()),
        )
    })
}

/// The surfaces that lie on each surface, as outlines of holes.
fn holes(input: &Input, outlines: &[Vec<DVec3>]) -> Result<Vec<Vec<Vec<DVec3>>>, Refusal> {
    let mut holes = vec![Vec::new(); outlines.len()];
    for (index, (surface, outline)) in input.surfaces.iter().zip(outlines).enumerate() {
        if surface.kind == SurfaceRole::Obstruction {
            continue;
        }
        let place = FilePlace::Line(surface.line);
        let base = base(&input.surfaces, index, surface).map_err(|refusal| refusal.at(place))?;
        let Some(base) = base else { continue };
        if !lies_on(outline, &outlines[base]) {
            let cause = format!("the surface does not lie in the plane of its base {}", base + 1);
            return refuse_at(place, cause, "correct its vertices, or write base 0");
        }
        holes[base].push(outline.clone());
    }
    Ok(holes)
}

/// Index of the base of a surface, if it has one. A surface lies on one before it, or on an obstruction.
fn base(surfaces: &[Statement], index: usize, surface: &Statement) -> Result<Option<usize>, Refusal> {
    let Some(base) = surface.base.checked_sub(1) else {
        return match surface.kind {
            SurfaceRole::Masking | SurfaceRole::Null => {
                refuse("a masking or null surface has no base", "write the number of the surface it lies on")
            }
            _ => Ok(None),
        };
    };
    match surfaces.get(base) {
        Some(found) if base < index || (base > index && found.kind == SurfaceRole::Obstruction) => {
            Ok(Some(base))
        }
        _ => refuse(
            format!("the base {} is neither a surface before this one nor an obstruction", surface.base),
            "write the surface behind its base, or write base 0",
        ),
    }
}

fn lies_on(outline: &[DVec3], base: &[DVec3]) -> bool {
    let [first, second, third, ..] = base else { return false };
    let last = base.last().unwrap_or(third);
    let normal = (*third - *first).cross(*last - *second);
    let normal = if base.len() == 3 { (*second - *first).cross(*third - *first) } else { normal };
    let normal = normal.normalize_or_zero();
    let size = base.iter().map(|point| point.distance(*first)).fold(0.0, f64::max);
    outline.iter().all(|point| (*point - *first).dot(normal).abs() <= OFF_PLANE * size)
}

fn model(input: &Input, outlines: Vec<Vec<DVec3>>, holes: Vec<Vec<Vec<DVec3>>>) -> Result<Model, Refusal> {
    let mut model = ModelBuilder::default();
    for (index, (surface, (outline, holes))) in
        input.surfaces.iter().zip(outlines.into_iter().zip(holes)).enumerate()
    {
        let name = surface.name.clone().unwrap_or_else(|| format!("{}-{}", word(surface.kind), index + 1));
        if surface.combined > 0 {
            model.note("the combining of surfaces in the output is left out", surface.line);
        }
        if matches!(surface.kind, SurfaceRole::Masking | SurfaceRole::Null) {
            model.note("a black surface takes the place of a masking or null surface", surface.line);
        }
        let added =
            model.surface(Some(&name), Shape::Polygon { outline, holes }, &coat(surface), surface.line);
        added.map_err(|refusal| refusal.at(FilePlace::Line(surface.line)))?;
    }
    if let Some(line) = input.enclosure {
        model.note("encl=1, which adjusts view factors to an enclosure, is left out", line);
    }
    if let Some(line) = input.transformation {
        model.note("coordinate transformations (X) are left out", line);
    }
    if let Some(line) = input.undocumented {
        model.note("lines that begin with I are left out", line);
    }
    Ok(Model { title: input.title.clone(), ..model.finish() })
}

fn word(kind: SurfaceRole) -> &'static str {
    match kind {
        SurfaceRole::Radiating => "surface",
        SurfaceRole::Masking => "mask",
        SurfaceRole::Null => "null",
        SurfaceRole::Obstruction => "obstruction",
    }
}

/// A material by its emittance; all that does not radiate is one black material.
fn coat(surface: &Statement) -> Coat {
    let (name, reflectance) = match surface.kind {
        SurfaceRole::Radiating => (
            format!("emit-{}", surface.emittance),
            ((1.0 - surface.emittance) * STEPS_OF_EMITTANCE).round() / STEPS_OF_EMITTANCE,
        ),
        _ => (OBSTRUCTION.to_owned(), 0.0),
    };
    Coat { name, reflectance: [reflectance; 3], emission: [0.0; 3], sides: Sides::Front }
}
