//! Shapes of several faces: `box`.

use radiosity_formats::model::Shape;
use radiosity_geom::{DVec3, Motion, ShapeError, Surface, shapes::Parallelogram};
use radiosity_scene::{Fault, error::Located, place::At, tree::Node};
use serde_json::{Value as Json, json};

use crate::{
    fields::{exactly, list, point, text},
    keys::{GivenFields, ValueKind, keys},
    kinds::{FLAG, POINT},
    shape::form::{Built, Form, Modelled},
    terms,
};

/// A face of a box: the axis that it is normal to, and whether it lies at the high end of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Face {
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

keys! {
    BoxFile("A cuboid along the axes, six surfaces", one_extent(); check) {
        origin: Option<DVec3> = POINT, "The corner of the lowest coordinates";
        size: Option<DVec3> = ValueKind::new(point, size_schema), "Lengths along x, y and z";
        corners: Option<[DVec3; 2]> =
            ValueKind::new(|node| exactly(node, "corners", "points", point), || terms::exactly(2, "point", "")),
            "Two opposite corners, instead of origin and size";
        inward: bool = FLAG, "Fronts inside, as in a room";
        open: Vec<Face> = ValueKind::new(|node| list(node)?.iter().map(face).collect(), open_schema).or_empty(),
            "Faces that are left out";
    }
}

fn size_schema() -> Json {
    terms::with(terms::exactly(3, "number", ""), "items", terms::positive("A length"))
}

fn open_schema() -> Json {
    json!({ "type": "array", "items": { "enum": FACES.map(|face| face.name) } })
}

fn one_extent() -> Json {
    let none_of = |key: &str| json!({ "not": { "required": [key] } });
    json!({ "oneOf": [
        { "required": ["origin", "size"], "not": { "required": ["corners"] } },
        { "required": ["corners"], "allOf": [none_of("origin"), none_of("size")] },
    ] })
}

/// A box has a face, and `corners` or else `origin` and `size`.
fn check(own: &BoxFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    if let (None, Some(node)) = (own.faces().next(), fields.get("open")) {
        let fault = Fault::wrong_count("a box", "at least one face that is not open", 0);
        return Err(Located::at(&node.span, fault));
    }
    match own {
        BoxFile { corners: Some(_), .. } => fields.without("corners", &["origin", "size"]),
        BoxFile { origin: None, .. } => Err(fields.missing("origin", ", three numbers in brackets")),
        BoxFile { size: None, .. } => {
            Err(fields.missing("size", ", three lengths in brackets; or give two corners"))
        }
        _ => Ok(()),
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

impl BoxFile {
    /// The faces that are not open.
    fn faces(&self) -> impl Iterator<Item = Face> {
        FACES.into_iter().filter(|face| !self.open.contains(face))
    }

    /// The corners with the lowest and the highest coordinates.
    fn bounds(&self) -> Result<[DVec3; 2], ShapeError> {
        if let Some([a, b]) = self.corners {
            return match a.cmpne(b).all() {
                true => Ok([a.min(b), a.max(b)]),
                false => Err(ShapeError::NoArea { field: "corners".into() }),
            };
        }
        let [origin, size] = [self.origin, self.size].map(Option::unwrap_or_default);
        match size.to_array().into_iter().find(|side| *side <= 0.0) {
            Some(value) => Err(ShapeError::NotPositive { field: "size".into(), value }),
            None => Ok([origin, origin + size]),
        }
    }

    /// The field that says how large the box is.
    fn field(&self) -> &'static str {
        if self.corners.is_some() { "corners" } else { "size" }
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
        let corners = self.bounds()?;
        let surface = |face: Face| match face.surface(corners, self.inward, motion) {
            Ok(face) => Ok(Box::new(face) as Box<dyn Surface>),
            Err(_) => Err(ShapeError::NoArea { field: self.field().into() }),
        };
        self.faces().map(surface).collect()
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let outline = |face: Box<dyn Surface>| Shape::Polygon { outline: face.corners(), holes: Vec::new() };
        Ok(Some(self.surfaces(motion)?.into_iter().map(outline).collect()))
    }

    fn name(&self, base: &str, index: usize) -> String {
        let face = self.faces().nth(index).map_or("", |face| face.name);
        format!("{base}-{face}")
    }
}
