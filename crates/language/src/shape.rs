//! The shapes a scene file can name: their fields as typed, and the surfaces they make.

mod form;
mod flat;
mod solid;
mod spline;
mod turned;

use std::num::NonZeroUsize;

use radiosity_formats::model::Shape;
use radiosity_geom::{Motion, ShapeError};
use radiosity_scene::{
    Fault, FaultKind,
    error::Located,
    place::{At, Span},
    tree::{Node, Value},
};
use serde_json::Value as Json;

use crate::{
    fields::Reader,
    keys::{GivenFields, KeyGroup, KeySchema, KeyTable},
    terms,
    tessellation::pieces,
};
use form::{Built, Form};

/// A shape: its key, what reads its value, and the schema of that.
struct Entry {
    key: &'static str,
    read: Reader<Box<dyn Form>>,
    schema: fn() -> Json,
}

const fn entry<T: KeyTable + Form + 'static>(key: &'static str) -> Entry {
    Entry { key, read: |node| Ok(Box::new(T::read(node)?)), schema: T::schema }
}

/// Every shape, in the order of the manual.
const SHAPES: [Entry; 15] = [
    entry::<flat::ParallelogramFile>("parallelogram"),
    entry::<flat::QuadFile>("quad"),
    entry::<flat::TriangleFile>("triangle"),
    entry::<flat::PolygonFile>("polygon"),
    entry::<solid::BoxFile>("box"),
    entry::<turned::DiskFile>("disk"),
    entry::<turned::CylinderFile>("cylinder"),
    entry::<turned::ConeFile>("cone"),
    entry::<turned::SphereFile>("sphere"),
    entry::<turned::TorusFile>("torus"),
    entry::<spline::BezierFile>("bezier"),
    entry::<spline::PatchesFile>("patches"),
    entry::<spline::RationalFile>("rational"),
    entry::<spline::ExtrusionFile>("extrusion"),
    entry::<turned::RevolutionFile>("revolution"),
];

/// Every shape key with the schema of its value.
pub(super) fn schemas() -> impl Iterator<Item = (&'static str, Json)> {
    SHAPES.iter().map(|shape| (shape.key, (shape.schema)()))
}

/// The schema of a table with one shape.
pub(super) fn one_shape() -> Json {
    terms::required("oneOf", &SHAPES.map(|shape| shape.key))
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

/// The one shape among the keys of a surface.
impl KeyGroup for ShapeFile {
    fn has(key: &str) -> bool {
        SHAPES.iter().any(|shape| shape.key == key)
    }

    fn keys() -> Vec<KeySchema> {
        let key = |shape: &Entry| KeySchema {
            name: shape.key,
            schema: terms::reference(shape.key),
            is_required: false,
        };
        SHAPES.iter().map(key).collect()
    }

    fn take(fields: &GivenFields<'_>) -> Result<Self, Located> {
        let given = |shape: &'static Entry| Some((shape, fields.get(shape.key)?));
        match SHAPES.iter().filter_map(given).collect::<Vec<_>>()[..] {
            [] => Err(fields.fault(no_shape())),
            [(shape, node)] => Ok(ShapeFile {
                kind: shape.key,
                span: node.span.clone(),
                form: (shape.read)(node)?,
                fields: field_places(node),
            }),
            [(first, _), (second, node), ..] => {
                Err(Located::at(&node.span, two_shapes(first.key, second.key)))
            }
        }
    }
}

impl ShapeFile {
    /// The surfaces, put where `motion` says; one, but for `box` and `patches`.
    pub(super) fn surfaces(&self, motion: &Motion) -> Built {
        self.form.surfaces(motion)
    }

    /// Shapes of each of these surfaces in a model of another program, curved ones cut into flat pieces over so
    /// many cells each way, if told to; None if models have no such shape.
    pub(super) fn models(
        &self,
        motion: &Motion,
        tessellation: Option<NonZeroUsize>,
    ) -> Result<Option<Vec<Vec<Shape>>>, ShapeError> {
        if let Some(count) = tessellation {
            let surfaces = self.form.surfaces(motion)?;
            if surfaces.iter().any(|surface| surface.region().is_none()) {
                return Ok(Some(surfaces.iter().map(|surface| pieces(surface.as_ref(), count)).collect()));
            }
        }
        let shapes = self.form.models(motion)?;
        Ok(shapes.map(|shapes| shapes.into_iter().map(|shape| vec![shape]).collect()))
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
