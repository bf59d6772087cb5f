//! Shapes of several faces: `box`.

use radiosity_formats::model::Shape;
use radiosity_geom::{DVec3, Motion, ShapeError, Surface, shapes::Parallelogram};
use radiosity_scene::{Fault, error::Located, place::At, tree::Node};

use crate::{
    fields::{Fields, exactly, list, point, text, truth},
    shape::form::{Built, Form, Modelled},
};

/// A face of a box: the axis that it is normal to, and whether it lies at the high end of it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Face {
    name: &'static str,
    axis: usize,
    high: bool,
}

const FACES: [Face; 6] = [
    Face { name: "left", axis: 0, high: false },
    Face { name: "right", axis: 0, high: true },
    Face { name: "front", axis: 1, high: false },
    Face { name: "back", axis: 1, high: true },
    Face { name: "bottom", axis: 2, high: false },
    Face { name: "top", axis: 2, high: true },
];

/// Extent of a box as typed (length): a corner and a size, or two corners.
#[derive(Debug)]
enum Extent {
    Sized { origin: DVec3, size: DVec3 },
    Between([DVec3; 2]),
}

#[derive(Debug)]
struct BoxFile {
    extent: Extent,
    inward: bool,
    faces: Vec<Face>,
}

pub(super) fn cuboid(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["origin", "size", "corners", "inward", "open"])?;
    let open = fields.optional("open", |node| list(node)?.iter().map(face).collect::<Result<Vec<_>, _>>())?;
    let open = open.unwrap_or_default();
    let faces: Vec<Face> = FACES.into_iter().filter(|face| !open.contains(face)).collect();
    if let (true, Some(node)) = (faces.is_empty(), fields.get("open")) {
        let expected = "at least one face that is not open".to_owned();
        return Err(Located::at(&node.span, Fault::wrong_count("a box", &expected, 0)));
    }
    let inward = fields.optional("inward", truth)?.unwrap_or(false);
    Ok(Box::new(BoxFile { extent: extent(&fields)?, inward, faces }))
}

/// `corners`, or `origin` and `size`.
fn extent(fields: &Fields<'_>) -> Result<Extent, Located> {
    let corners = fields.optional("corners", |node| exactly(node, "corners", "points", point))?;
    let Some(corners) = corners else {
        return Ok(Extent::Sized {
            origin: fields.require("origin", point)?,
            size: fields.require("size", point)?,
        });
    };
    let other = ["origin", "size"].into_iter().find_map(|key| Some((key, fields.get(key)?)));
    match other {
        None => Ok(Extent::Between(corners)),
        Some((second, node)) => Err(Located::at(&node.span, Fault::exclusive("corners", second))),
    }
}

fn face(node: &Node) -> Result<Face, Located> {
    let At { value: name, span } = text(node)?;
    FACES.into_iter().find(|face| face.name == name).ok_or_else(|| {
        let known = FACES.map(|face| face.name.to_owned());
        Located::at(
            &span,
            Fault::unknown(format!("a box has no face {name:?}"), &name, known, "faces of a box"),
        )
    })
}

impl Extent {
    /// The corners with the lowest and the highest coordinates.
    fn corners(&self) -> Result<[DVec3; 2], ShapeError> {
        match *self {
            Extent::Sized { origin, size } => match size.to_array().into_iter().find(|side| *side <= 0.0) {
                Some(value) => Err(ShapeError::NotPositive { field: "size".into(), value }),
                None => Ok([origin, origin + size]),
            },
            Extent::Between([a, b]) if a.cmpne(b).all() => Ok([a.min(b), a.max(b)]),
            Extent::Between(_) => Err(ShapeError::NoArea { field: "corners".into() }),
        }
    }

    /// The field that says how large the box is.
    fn field(&self) -> &'static str {
        match self {
            Extent::Sized { .. } => "size",
            Extent::Between(_) => "corners",
        }
    }
}

impl Face {
    /// The face of the box between two corners, its front outside or inside. Seen from the front, v runs up
    /// (toward +y at bottom and top), and u to the right.
    fn surface(
        &self,
        [low, high]: [DVec3; 2],
        inward: bool,
        motion: &Motion,
    ) -> Result<Parallelogram, ShapeError> {
        let outward = if self.high { DVec3::AXES[self.axis] } else { -DVec3::AXES[self.axis] };
        let v = if self.axis == 2 { DVec3::Y } else { DVec3::Z };
        let u = v.cross(if inward { -outward } else { outward });
        let at_high = outward.cmpgt(DVec3::ZERO) | u.cmplt(DVec3::ZERO);
        let origin = DVec3::select(at_high, high, low);
        let size = high - low;
        Parallelogram::new(motion.point(origin), motion.vector(u * size), motion.vector(v * size))
    }
}

impl Form for BoxFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let corners = self.extent.corners()?;
        let surface = |face: &Face| match face.surface(corners, self.inward, motion) {
            Ok(face) => Ok(Box::new(face) as Box<dyn Surface>),
            Err(_) => Err(ShapeError::NoArea { field: self.extent.field().into() }),
        };
        self.faces.iter().map(surface).collect()
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let outline = |face: Box<dyn Surface>| Shape::Polygon { outline: face.corners(), holes: Vec::new() };
        Ok(Some(self.surfaces(motion)?.into_iter().map(outline).collect()))
    }

    fn name(&self, base: &str, index: usize) -> String {
        format!("{base}-{}", self.faces[index].name)
    }
}
