//! The shapes a scene file can name: their fields as typed, and the surface they make.

use radiosity_geom::{
    DVec3, ShapeError, Surface,
    shapes::{Bilinear, Parallelogram, Polygon, Triangle, Trimmed},
};

use crate::scene::{
    error::Located,
    fields::{Fields, exactly, list, point, points},
    placement::Placement,
    source::Span,
    tree::{Node, Value},
};

/// The shape keys, in the order of the manual.
pub(super) const KEYS: [&str; 4] = ["parallelogram", "quad", "triangle", "polygon"];

/// A shape as typed.
#[derive(Debug)]
pub(super) struct ShapeFile {
    /// Its key, one of [`KEYS`].
    pub kind: &'static str,
    /// Where its value stands.
    pub span: Span,
    outline: Outline,
    holes: Vec<Vec<DVec3>>,
    fields: Vec<(String, Span)>,
}

#[derive(Debug)]
enum Outline {
    Parallelogram { origin: DVec3, edge1: DVec3, edge2: DVec3 },
    Quad([DVec3; 4]),
    Triangle([DVec3; 3]),
    Polygon(Vec<DVec3>),
}

impl ShapeFile {
    /// Reads the value of the shape key `kind`.
    pub(super) fn read(kind: &'static str, node: &Node) -> Result<Self, Located> {
        let (outline, holes) = match kind {
            "parallelogram" => read_parallelogram(node)?,
            "quad" => read_quad(node)?,
            "triangle" => read_triangle(node)?,
            _ => read_polygon(node)?,
        };
        Ok(ShapeFile { kind, span: node.span.clone(), outline, holes, fields: field_spans(node) })
    }

    /// The surface, put where `placement` says.
    pub(super) fn build(&self, placement: &Placement) -> Result<Box<dyn Surface>, ShapeError> {
        let holes: Vec<_> = self.holes.iter().map(|hole| placement.points(hole)).collect();
        let outer: Box<dyn Surface> = match &self.outline {
            Outline::Parallelogram { origin, edge1, edge2 } => Box::new(Parallelogram::new(
                placement.point(*origin),
                placement.vector(*edge1),
                placement.vector(*edge2),
            )?),
            Outline::Quad(vertices) => {
                Box::new(Bilinear::new(vertices.map(|vertex| placement.point(vertex)))?)
            }
            Outline::Triangle(vertices) => {
                Box::new(Triangle::new(vertices.map(|vertex| placement.point(vertex)))?)
            }
            Outline::Polygon(outer) => return Ok(Box::new(Polygon::new(placement.points(outer), holes)?)),
        };
        match holes.is_empty() {
            true => Ok(outer),
            false => Ok(Box::new(Trimmed::new(outer, holes)?)),
        }
    }

    /// Where the field a shape error names stands (`vertices`, `holes[1]`); the whole shape if it names none of ours.
    pub(super) fn span_of(&self, field: &str) -> &Span {
        self.fields.iter().find(|(name, _)| name == field).map_or(&self.span, |(_, span)| span)
    }
}

type Read = Result<(Outline, Vec<Vec<DVec3>>), Located>;

fn read_parallelogram(node: &Node) -> Read {
    let fields = Fields::new(node, &["origin", "edge1", "edge2", "holes"])?;
    let outline = Outline::Parallelogram {
        origin: fields.require("origin", point)?,
        edge1: fields.require("edge1", point)?,
        edge2: fields.require("edge2", point)?,
    };
    Ok((outline, read_holes(&fields)?))
}

fn read_quad(node: &Node) -> Read {
    let fields = Fields::new(node, &["vertices", "holes"])?;
    let vertices = fields.require("vertices", |node| exactly(node, "a quad", "vertices", point))?;
    Ok((Outline::Quad(vertices), read_holes(&fields)?))
}

fn read_triangle(node: &Node) -> Read {
    let fields = Fields::new(node, &["vertices"])?;
    let vertices = fields.require("vertices", |node| exactly(node, "a triangle", "vertices", point))?;
    Ok((Outline::Triangle(vertices), Vec::new()))
}

fn read_polygon(node: &Node) -> Read {
    let fields = Fields::new(node, &["vertices", "holes"])?;
    Ok((Outline::Polygon(fields.require("vertices", points)?), read_holes(&fields)?))
}

fn read_holes(fields: &Fields<'_>) -> Result<Vec<Vec<DVec3>>, Located> {
    let holes = fields.optional("holes", |node| list(node)?.iter().map(points).collect())?;
    Ok(holes.unwrap_or_default())
}

/// Every field of a shape and, where it is a list, every item: `holes`, `holes[0]`, …
fn field_spans(node: &Node) -> Vec<(String, Span)> {
    let Value::Table(entries) = &node.value else { return Vec::new() };
    let mut spans = Vec::new();
    for (key, value) in entries {
        spans.push((key.value.clone(), value.span.clone()));
        if let Value::List(items) = &value.value {
            let items = items.iter().enumerate();
            spans.extend(items.map(|(k, item)| (format!("{}[{k}]", key.value), item.span.clone())));
        }
    }
    spans
}
