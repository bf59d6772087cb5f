//! Kinds of values that keys of several tables have.

use radiosity_geom::{DVec3, Motion};
use radiosity_scene::{
    error::Located,
    tree::{Node, entry},
};

use crate::{
    fields::{exactly, point, real, table, text, truth},
    keys::{DefaultValue, KeyTable, ValueKind, WithDefault, keys},
    terms,
};

pub(super) const REAL: ValueKind<f64> = ValueKind::new(real, || terms::reference("number"));

/// A number above 0.
pub(super) const POSITIVE: ValueKind<f64> =
    ValueKind::new(real, || terms::positive("")).example(", a length");

pub(super) const POINT: ValueKind<DVec3> = triple(|| terms::reference("point"));

pub(super) const VECTOR: ValueKind<DVec3> = triple(|| terms::reference("vector"));

const fn triple(schema: fn() -> serde_json::Value) -> ValueKind<DVec3> {
    ValueKind::new(point, schema).example(", three numbers in brackets")
}

pub(super) const TEXT: ValueKind<String> = ValueKind::new(|node| Ok(text(node)?.value), || terms::text(""));

pub(super) const TRUTH: ValueKind<bool> = ValueKind::new(truth, || terms::truth(""));

/// True where it is said.
pub(super) const FLAG: WithDefault<bool> = TRUTH.or(DefaultValue::Truth(false));

/// Where a shape or an instance is put.
pub(super) const TRANSFORM: ValueKind<Motion> = ValueKind::new(motion, || terms::reference("transform"));

keys! {
    TransformFile("Scales, then turns, then moves") {
        translate: DVec3 = VECTOR.or(DefaultValue::Numbers(&[0.0; 3])), "Where it is moved at last";
        rotate: Option<[f64; 4]> =
            ValueKind::new(|node| exactly(node, "rotate", "numbers, an axis and degrees", real), || {
                terms::exactly(4, "number", "")
            }),
            "Axis x, y, z through the origin, and degrees about it";
        scale: f64 = POSITIVE.or(DefaultValue::Number(1.0)), "Factor on all lengths, about the origin";
    }
}

fn motion(node: &Node) -> Result<Motion, Located> {
    let TransformFile { translate, rotate, scale } = TransformFile::read(node)?;
    let [x, y, z, degrees] = rotate.unwrap_or([0.0; 4]);
    let motion = Motion::new(translate, DVec3::new(x, y, z), degrees.to_radians(), scale);
    motion.map_err(|error| {
        let field = table(node).ok().and_then(|fields| entry(fields, error.field()));
        Located::at(field.map_or(&node.span, |field| &field.span), error.into())
    })
}
