//! Tolerances that several readers and repairs share, those that bound one quantity differently in several
//! places, and what readers take at the most.
//!
//! Lengths that count as none and planes that are one are set by [`radiosity_geom`], what overlaps and which areas
//! are equal by [`radiosity_fit::tolerances`].

/// Roundings by which two corners that are meant to be one may differ: each is computed, by a few operations.
/// Banks of a slit and sides that touch are found by it too. A mesh whose corners were computed in several
/// ways would not hang together with the two roundings that rings allow.
pub(crate) const ROUNDINGS_OF_CORNERS: f64 = 8.0;

/// Roundings by which a corner and the plane of its own face differ: two of the corner, two of the plane. A
/// plane through corners of other faces may miss by twice as many.
pub(crate) const ROUNDINGS_OF_FACE: f64 = 4.0;

/// Roundings within which a dropped corner lies on its side: of it and of both ends, and one to spare.
pub(crate) const ROUNDINGS_OF_SIDE: f64 = 4.0;

/// Distance of corners from their face's plane over the face's extent, where faces are merged: half of
/// [`PLANARITY`](radiosity_geom::PLANARITY), so that the polygon that they make is flat too.
pub(crate) const PLANARITY_OF_FACE: f64 = 1e-5;

/// Greatest angle between normals of faces in one plane (radians), before rounding. With a larger value
/// gently curved sheets would be made flat; with a smaller one faces with few decimals are not merged.
pub(crate) const TILT_OF_FACES: f64 = 1e-4;

/// Largest turn of a side that is straight (radians), as [`TILT_OF_FACES`]: with a larger value gentle curves
/// lose corners.
pub(crate) const TURN_OF_SIDES: f64 = 1e-4;

/// Gap by which disks and mantles are raised off what they lie on, over the extent of the face or the radius:
/// a hundred times what is no length, so that neither touches the other. With a larger value more light
/// passes through the gap.
pub(crate) const RAISED: f64 = 1e-7;

/// Part of the largest of red, green and blue by which those of a grey may differ where they are given:
/// rounding leaves less.
pub(crate) const GREY_OF_NUMBERS: f64 = 1e-12;

/// Part of the largest of red, green and blue by which those of a grey may differ where they are given by
/// chromaticities, which are written with three digits.
pub(crate) const GREY_OF_CHROMATICITIES: f64 = 4e-3;

/// One over the step that emittances and reflectances of View3D are rounded to, so that 1 − 0.9 is 0.1.
pub(crate) const STEPS_OF_EMITTANCE: f64 = 1e12;

/// Greatest coordinate, radius, reflectance or exitance that a reader takes, of any unit: its sixth power is
/// still a number.
pub(crate) const GREATEST: f64 = 1e50;

/// Greatest coordinate that the repair reckons with, of models that no reader made: its fourth power is a
/// number. `radiosity` refuses larger ones than 10³⁰.
pub(crate) const GREATEST_OF_REPAIR: f64 = 1e60;

/// Most surfaces that a reader makes, faces of meshes counted before they are merged: a model of so many
/// holds half a gigabyte.
pub(crate) const MOST_SURFACES: usize = 1_000_000;

/// Most vertices of a file, and of all surfaces: ten for each of [`MOST_SURFACES`].
pub(crate) const MOST_VERTICES: usize = 10_000_000;

/// Most rows of numbers of one table, such as an accessor of a glTF or the corners of a PLY: four for each of
/// [`MOST_VERTICES`]. A file of few bytes cannot ask for more memory than that.
pub(crate) const MOST_ROWS: usize = 40_000_000;

/// Most bytes of all buffers of a glTF, which are held at once, as those of one file.
pub(crate) const MOST_BYTES_OF_BUFFERS: usize = 1 << 30;

/// Most bytes of text beside meshes, held at once: of the JSON of a glTF, of all material files of an OBJ, of
/// the attributes of a Mitsuba scene. Its tree takes several times as much.
pub(crate) const MOST_BYTES_OF_TEXT: usize = 1 << 28;

/// Most characters of a cause that another reader of JSON or XML tells: two lines of a terminal.
pub(crate) const LONGEST_CAUSE: usize = 160;

/// Most characters of a name that is put together of the names around it, in MGF and in Radiance: names must
/// not grow with each file that includes another.
pub(crate) const LONGEST_NAME: usize = 1000;
