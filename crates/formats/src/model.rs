//! A scene as another program holds it: named surfaces with shapes and diffuse materials per band.
//!
//! Readers promise: every number is finite, every material index is in range, every vertex list has at least
//! three entries. They do not promise that outlines are sound or that reflectances are below 1: `repair` sees
//! to that.

use std::sync::Arc;

use glam::DVec3;
use radiosity_fit::outline::is_warped;
use radiosity_geom::PlanarRegion;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;
use radiosity_photometry::note_text::NoteText;

/// A scene of another program.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Model {
    /// Title of the scene, for people.
    pub title: Option<String>,
    /// Names of the bands, at least one: `["grey"]` where no material has a colour, else `["r", "g", "b"]`.
    pub bands: Vec<String>,
    /// Unit of exitance, where the format states one.
    pub unit: Option<String>,
    /// Materials; their names are unique.
    pub materials: Vec<Material>,
    /// Surfaces; their names are unique.
    pub surfaces: Vec<Surface>,
    /// The first camera of the file.
    pub camera: Option<Camera>,
    /// Notes on parts of the file that were left out or changed by reading, each kind once.
    pub notes: Vec<Note>,
}

/// A diffuse material: the part of another program's material that radiosity carries.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name of the material.
    pub name: String,
    /// Diffuse reflectance of each band. Not yet below 1.
    pub reflectance: Vec<f64>,
    /// Exitance of each band (π × radiance), ≥ 0.
    pub emission: Vec<f64>,
}

/// A surface: a shape with a name and a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    /// Name of the surface, not blank.
    pub name: String,
    /// Index of its material; none in formats without materials.
    pub material: Option<usize>,
    /// Shape of the surface (coordinates in the model's unit of length).
    pub shape: Shape,
    /// Sides of the surface that reflect and emit.
    pub sides: Sides,
    /// The included file in which the surface stands; none for the file that was read.
    pub file: Option<Arc<str>>,
    /// Place in the file at which the surface stands.
    pub place: Option<FilePlace>,
}

/// Sides of a surface that reflect and emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sides {
    /// The front only.
    Front,
    /// Front and back.
    Both,
    /// The format does not tell whether the back counts.
    Open,
}

/// A shape with its front.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A planar polygon. Front: seen from it the outline runs counter-clockwise. Holes run in any direction.
    Polygon {
        /// The outline, at least three points, the last not repeated.
        outline: Vec<DVec3>,
        /// Outlines of holes, each at least three points, the last not repeated.
        holes: Vec<Vec<DVec3>>,
    },
    /// A bilinear patch through four points not in a plane. Front: (v₁ − v₀) × (v₃ − v₀).
    Quad([DVec3; 4]),
    /// A disk, or a ring if `inner` > 0. Front: `normal`.
    Disk {
        /// Middle of the disk.
        center: DVec3,
        /// Direction of its front, of any length.
        normal: DVec3,
        /// Outer radius, above `inner`.
        radius: f64,
        /// Inner radius, 0 for a disk.
        inner: f64,
    },
    /// The mantle of a cylinder without its lids.
    Cylinder {
        /// Middle of one end.
        base: DVec3,
        /// Vector from `base` to the middle of the other end.
        axis: DVec3,
        /// Radius of the cylinder.
        radius: f64,
        /// Whether the front is the inside.
        inward: bool,
    },
    /// The mantle of a cone or of a frustum without its lids.
    Cone {
        /// Middle of one end.
        base: DVec3,
        /// Vector from `base` to the middle of the other end.
        axis: DVec3,
        /// Radii at `base` and at the other end, ≥ 0, one above 0.
        radii: [f64; 2],
        /// Whether the front is the inside.
        inward: bool,
    },
    /// A whole sphere.
    Sphere {
        /// Middle of the sphere.
        center: DVec3,
        /// Radius of the sphere.
        radius: f64,
        /// Whether the front is the inside.
        inward: bool,
    },
    /// A whole torus.
    Torus {
        /// Middle of the torus.
        center: DVec3,
        /// Direction of the axis, of any length.
        axis: DVec3,
        /// Radius of the circle that the tube's middle runs along.
        major: f64,
        /// Radius of the tube.
        minor: f64,
        /// Whether the front is the inside.
        inward: bool,
    },
}

/// A pinhole camera: its position, its direction and its picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Position of the camera.
    pub eye: DVec3,
    /// A point in the middle of the picture.
    pub target: DVec3,
    /// Direction that points upwards in the picture, of any length.
    pub up: DVec3,
    /// Angle from the lower to the upper border, degrees.
    pub fov: f64,
    /// Pixels along and down, where the file states them.
    pub size: Option<[u32; 2]>,
}

/// The mantle of a cylinder or of a cone.
#[derive(Clone, Copy)]
pub(crate) struct Mantle {
    /// Middle of one end.
    pub base: DVec3,
    /// Vector from `base` to the middle of the other end.
    pub axis: DVec3,
    /// Radii at `base` and at the other end.
    pub radii: [f64; 2],
    /// Whether the front is the inside.
    pub inward: bool,
}

impl Shape {
    /// A face between corners: a bilinear patch if four lie in no plane.
    pub(crate) fn face(corners: Vec<DVec3>) -> Shape {
        match <[DVec3; 4]>::try_from(corners.as_slice()) {
            Ok(four) if is_warped(&four) => Shape::Quad(four),
            _ => Shape::Polygon { outline: corners, holes: Vec::new() },
        }
    }

    /// A cone, or a cylinder if its radii are equal; both ≥ 0.
    pub(crate) fn cone(base: DVec3, axis: DVec3, radii: [f64; 2], inward: bool) -> Shape {
        match radii[0] == radii[1] {
            true => Shape::Cylinder { base, axis, radius: radii[0], inward },
            false => Shape::Cone { base, axis, radii, inward },
        }
    }

    /// The kind, as scenes call it.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Shape::Polygon { .. } => "polygon",
            Shape::Quad(_) => "quad",
            Shape::Disk { .. } => "disk",
            Shape::Cylinder { .. } => "cylinder",
            Shape::Cone { .. } => "cone",
            Shape::Sphere { .. } => "sphere",
            Shape::Torus { .. } => "torus",
        }
    }

    /// The outline and the holes of a flat or bilinear shape; curved ones have none.
    pub(crate) fn rings(&self) -> Vec<&[DVec3]> {
        match self {
            Shape::Polygon { outline, holes } => {
                std::iter::once(outline).chain(holes).map(Vec::as_slice).collect()
            }
            Shape::Quad(corners) => vec![corners],
            _ => Vec::new(),
        }
    }

    /// The mantle, if the shape is a cylinder or a cone.
    pub(crate) fn mantle(&self) -> Option<Mantle> {
        match *self {
            Shape::Cylinder { base, axis, radius, inward } => {
                Some(Mantle { base, axis, radii: [radius; 2], inward })
            }
            Shape::Cone { base, axis, radii, inward } => Some(Mantle { base, axis, radii, inward }),
            _ => None,
        }
    }

    /// All points and directions, and all radii.
    pub(crate) fn numbers(&self) -> (Vec<DVec3>, Vec<f64>) {
        match *self {
            Shape::Polygon { .. } | Shape::Quad(_) => (self.rings().concat(), Vec::new()),
            Shape::Disk { center, normal, radius, inner } => (vec![center, normal], vec![radius, inner]),
            Shape::Cylinder { base, axis, radius, .. } => (vec![base, axis], vec![radius]),
            Shape::Cone { base, axis, radii, .. } => (vec![base, axis], radii.to_vec()),
            Shape::Sphere { center, radius, .. } => (vec![center], vec![radius]),
            Shape::Torus { center, axis, major, minor, .. } => (vec![center, axis], vec![major, minor]),
        }
    }

    /// The shape with its points, the vectors between points, its directions of any length and its lengths
    /// changed.
    pub(crate) fn map(
        &self,
        point: impl Fn(DVec3) -> DVec3,
        vector: impl Fn(DVec3) -> DVec3,
        direction: impl Fn(DVec3) -> DVec3,
        length: impl Fn(f64) -> f64,
    ) -> Shape {
        let mut shape = self.clone();
        match &mut shape {
            Shape::Polygon { outline, holes } => {
                outline.iter_mut().chain(holes.iter_mut().flatten()).for_each(|x| *x = point(*x));
            }
            Shape::Quad(corners) => *corners = corners.map(&point),
            Shape::Disk { center, normal, radius, inner } => {
                (*center, *normal) = (point(*center), direction(*normal));
                (*radius, *inner) = (length(*radius), length(*inner));
            }
            Shape::Cylinder { base, axis, radius, .. } => {
                (*base, *axis, *radius) = (point(*base), vector(*axis), length(*radius));
            }
            Shape::Cone { base, axis, radii, .. } => {
                (*base, *axis, *radii) = (point(*base), vector(*axis), radii.map(length));
            }
            Shape::Sphere { center, radius, .. } => (*center, *radius) = (point(*center), length(*radius)),
            Shape::Torus { center, axis, major, minor, .. } => {
                (*center, *axis) = (point(*center), direction(*axis));
                (*major, *minor) = (length(*major), length(*minor));
            }
        }
        shape
    }

    /// Turns the shape over: its front becomes its back. The first corner stays the first.
    pub fn turn_over(&mut self) {
        match self {
            Shape::Polygon { outline, .. } => {
                outline.reverse();
                outline.rotate_right(1);
            }
            Shape::Quad(corners) => corners.swap(1, 3),
            Shape::Disk { normal, .. } => *normal = -*normal,
            Shape::Cylinder { inward, .. }
            | Shape::Cone { inward, .. }
            | Shape::Sphere { inward, .. }
            | Shape::Torus { inward, .. } => *inward = !*inward,
        }
    }

    /// Lets the rings of a flat or bilinear shape run the other way round.
    pub(crate) fn reverse_rings(&mut self) {
        match self {
            Shape::Polygon { outline, holes } => {
                outline.reverse();
                holes.iter_mut().for_each(|hole| hole.reverse());
            }
            Shape::Quad(corners) => corners.swap(1, 3),
            _ => {}
        }
    }
}

impl Surface {
    /// Convex pieces of three or four corners that together are a polygon of this surface.
    ///
    /// # Errors
    /// Outlines that cross, or without an area.
    pub(crate) fn pieces(&self, outline: &[DVec3], holes: &[Vec<DVec3>]) -> Result<Vec<Vec<DVec3>>, Refusal> {
        match PlanarRegion::new(outline.to_vec(), holes.to_vec()) {
            Ok(region) => Ok(region.convex_pieces().to_vec()),
            Err(_) => refuse(
                format!("the outline of surface {:?} crosses itself or has no area", self.name),
                "repair the scene before it is written",
            ),
        }
    }
}

impl Model {
    /// Whether a surface emits, by its index.
    pub(crate) fn emits(&self, surface: usize) -> bool {
        let material = self.surfaces[surface].material.and_then(|material| self.materials.get(material));
        material.is_some_and(|material| material.emission.iter().any(|value| *value > 0.0))
    }

    /// Reflectances and exitances of all materials, band by band.
    pub(crate) fn values_mut(&mut self) -> impl Iterator<Item = &mut Vec<f64>> {
        self.materials.iter_mut().flat_map(|own| [&mut own.reflectance, &mut own.emission])
    }

    /// Notes something at `place`; what was noted before is only counted.
    pub fn note(&mut self, text: impl Into<NoteText>, place: Option<FilePlace>) {
        Note::add(&mut self.notes, text, place);
    }
}
