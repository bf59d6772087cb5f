//! The shapes a scene file can name: their fields as typed, and the surfaces they make.

mod form;
mod flat;
mod solid;
mod spline;
mod turned;

use radiosity_geom::Motion;
use radiosity_scene::{
    Fault, FaultKind,
    error::Located,
    place::{At, Span},
    tree::{Node, Value},
};

use crate::fields::{Fields, Reader};
use form::{Built, Form, Modelled};

/// A shape key and what reads its value.
type Entry = (&'static str, Reader<Box<dyn Form>>);

/// Every shape, in the order of the manual.
const SHAPES: [Entry; 15] = [
    ("parallelogram", flat::parallelogram),
    ("quad", flat::quad),
    ("triangle", flat::triangle),
    ("polygon", flat::polygon),
    ("box", solid::cuboid),
    ("disk", turned::disk),
    ("cylinder", turned::cylinder),
    ("cone", turned::cone),
    ("sphere", turned::sphere),
    ("torus", turned::torus),
    ("bezier", spline::bezier),
    ("patches", spline::patches),
    ("rational", spline::rational),
    ("extrusion", spline::extrusion),
    ("revolution", turned::revolution),
];

/// Keys of all shapes.
pub(super) fn keys() -> impl Iterator<Item = &'static str> {
    SHAPES.iter().map(|(key, _)| *key)
}

/// A shape as typed.
#[derive(Debug)]
pub(super) struct ShapeFile {
    /// Key of the shape.
    pub kind: &'static str,
    /// Span of the key's value.
    pub span: Span,
    form: Box<dyn Form>,
    fields: Vec<FieldPlaces>,
}

/// Span of a field of a shape, and spans of its items, if it is a list.
#[derive(Debug)]
struct FieldPlaces {
    key: String,
    span: Span,
    items: Vec<Span>,
}

impl ShapeFile {
    /// Reads the one shape among the fields of a surface.
    pub(super) fn read(surface: &Fields<'_>) -> Result<Self, Located> {
        let given = |&(key, read): &Entry| Some((key, surface.get(key)?, read));
        match SHAPES.iter().filter_map(given).collect::<Vec<_>>()[..] {
            [] => Err(Located::at(surface.span(), no_shape())),
            [(kind, node, read)] => {
                Ok(ShapeFile { kind, span: node.span.clone(), form: read(node)?, fields: field_places(node) })
            }
            [(first, ..), (second, node, _), ..] => Err(Located::at(&node.span, two_shapes(first, second))),
        }
    }

    /// The surfaces, put where `motion` says; one, but for `box` and `patches`.
    pub(super) fn surfaces(&self, motion: &Motion) -> Built {
        self.form.surfaces(motion)
    }

    /// Shapes of these surfaces in a model of another program; None if models have no such shape.
    pub(super) fn models(&self, motion: &Motion) -> Modelled {
        self.form.models(motion)
    }

    /// The name of the surface at `index` of these, where the shape is called `base`.
    pub(super) fn name(&self, base: &str, index: usize) -> String {
        self.form.name(base, index)
    }

    /// The place of the field that a shape error names (`vertices`, `holes[1]`); the whole shape if there is
    /// none.
    pub(super) fn span_of(&self, field: &str) -> &Span {
        let (key, item) = field.split_once('[').unwrap_or((field, ""));
        let index = item.strip_suffix(']').and_then(|index| index.parse::<usize>().ok());
        match (self.fields.iter().find(|own| own.key == key), index) {
            (None, _) => &self.span,
            (Some(own), None) => &own.span,
            (Some(own), Some(index)) => own.items.get(index).unwrap_or(&self.span),
        }
    }
}

fn no_shape() -> Fault {
    let cure = "add one, e.g. quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }";
    Fault::absent("no shape is given", cure)
}

fn two_shapes(first: &str, second: &str) -> Fault {
    let cause = format!("two shapes are given: {first:?} and {second:?}");
    Fault::new(FaultKind::Exclusive, cause, "make two surfaces, one for each shape")
}

/// Spans of all fields of a shape.
fn field_places(node: &Node) -> Vec<FieldPlaces> {
    let Value::Table(entries) = &node.value else { return Vec::new() };
    let places = |(key, value): &(At<String>, Node)| FieldPlaces {
        key: key.value.clone(),
        span: value.span.clone(),
        items: value.item_places(),
    };
    entries.iter().map(places).collect()
}
