//! Motions as typed.

use std::sync::Arc;

use radiosity_geom::DVec3;
use radiosity_scene::{
    Curve, Fault,
    error::Located,
    place::{At, Span},
    tree::Node,
};
use serde_json::{Value, json};

use crate::{
    fields::{exactly, list, points, real, texts, word},
    file::per_band::{PerBand, per_band},
    keys::{
        DefaultValue, EmptyByDefault, GivenFields, KeyGroup, KeySchema, KeyTable, NameKey, ValueKind,
        WithDefault, keys,
    },
    kinds::{POINT, TRUTH, VECTOR},
    terms,
};

keys! {
    /// `[[motion]]`.
    MotionFile("What moves together along a rigid path, or is dimmed together", terms::required("anyOf", &HOW)) {
        name: At<String> = NameKey, "Its name, given once in the scene";
        surfaces: Vec<At<String>> = NAMES, "Surfaces that move, by name; a * stands for any ending";
        instances: Vec<At<String>> = NAMES, "Instances that move with all that is in them";
        luminaires: Vec<At<String>> = NAMES, "Luminaires that move";
        groups: Vec<At<String>> = NAMES, "Light groups of which all surfaces and luminaires move";
        camera: Option<At<bool>> = TRUTH, "The camera moves along";
        translate: Option<TranslateFile> = ValueKind::new(TranslateFile::read, TranslateFile::schema), "";
        rotate: Option<RotateFile> = ValueKind::new(RotateFile::read, RotateFile::schema), "";
        emission: Option<At<EmissionFile>> = ValueKind::new(EmissionFile::read, EmissionFile::schema), "";
        .._rigid: Rigid;
        ..span: Span;
    }
}

/// The keys that say what happens, of which one has to be given.
const HOW: [&str; 3] = ["translate", "rotate", "emission"];

keys! {
    /// `translate = { … }`.
    TranslateFile("How far it is moved") {
        points: At<Arc<Vec<DVec3>>> = ValueKind::new(points, || terms::list("vector", "", 2)).example(
            ", how far it has moved from where it rests, at least two points, each three numbers in brackets",
        ), "How far it is from where it rests";
        times: Option<At<Vec<f64>>> = TIMES, WHEN;
        curve: Curve = BETWEEN, "What is between two of them";
    }
}

keys! {
    /// `rotate = { … }`, by degrees about one axis, or by an axis and degrees each time.
    RotateFile("How far it is turned", one_notation(); check_turns) {
        center: DVec3 = POINT, "It stays where it is";
        axis: Option<At<DVec3>> = VECTOR, "The axis through the centre";
        angles: Option<At<Vec<f64>>> = ValueKind::new(numbers, || terms::list("number", "", 2)),
            "How far it is turned from where it rests, degrees";
        turns: Option<At<Vec<[f64; 4]>>> = ValueKind::new(turns, turns_schema), "Rotations about several axes";
        times: Option<At<Vec<f64>>> = TIMES, WHEN;
        curve: Curve = BETWEEN, "What is between two of them";
        ..span: Span;
    }
}

keys! {
    /// `emission = { … }`.
    EmissionFile("How brightly it shines") {
        factors: At<Vec<PerBand>> = ValueKind::new(factors, factors_schema).example(
            ", factors on what it emits at rest, at least two, each a number or a list with one per band",
        ), "Factors on what it emits at rest, each for all bands or with one per band";
        times: Option<At<Vec<f64>>> = TIMES, WHEN;
        curve: Curve = BETWEEN, "What is between two of them; a spline is cut off at 0";
    }
}

const NAMES: EmptyByDefault<Vec<At<String>>> = ValueKind::new(texts, names_schema).or_empty();

const TIMES: ValueKind<Vec<f64>> = ValueKind::new(numbers, || {
    let time = terms::with(terms::reference("number"), "description", "A time".into());
    json!({ "type": "array", "items": time })
});

const WHEN: &str = "When, in ascending order; at equal steps unless given";

const CURVES: [(&str, Curve); 2] = [("line", Curve::Line), ("spline", Curve::Spline)];

/// The curve between the values of a path, or between factors.
const BETWEEN: WithDefault<Curve> =
    ValueKind::new(curve, || terms::words(&CURVES.map(|(name, _)| name))).or(DefaultValue::Word("line"));

fn names_schema() -> Value {
    let name = terms::text("A name");
    json!({ "anyOf": [name, { "type": "array", "items": name }] })
}

fn turns_schema() -> Value {
    let turn = terms::exactly(4, "number", "Axis x, y, z and degrees about it");
    json!({ "type": "array", "minItems": 2, "items": turn })
}

fn factors_schema() -> Value {
    let factor = terms::per_band(terms::at_least_zero(), "A factor");
    json!({ "type": "array", "minItems": 2, "items": factor })
}

fn one_notation() -> Value {
    let angles = json!({ "required": ["axis", "angles"], "not": { "required": ["turns"] } });
    let turns = json!({
        "required": ["turns"],
        "not": { "anyOf": [{ "required": ["axis"] }, { "required": ["angles"] }, { "required": ["curve"] }] },
    });
    json!({ "oneOf": [angles, turns] })
}

/// Rotations about several axes go without the keys of one axis, which has to be given otherwise.
fn check_turns(own: &RotateFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    fields.without("turns", &["axis", "angles", "curve"])?;
    match own {
        RotateFile { turns: None, axis: None, .. } => {
            Err(fields.missing("axis", ", three numbers in brackets"))
        }
        RotateFile { turns: None, angles: None, .. } => {
            Err(fields.missing("angles", ", degrees, at least two numbers in brackets"))
        }
        _ => Ok(()),
    }
}

/// The lack of the key `scale`, which shapes and instances have and no motion.
#[derive(Debug)]
pub(crate) struct Rigid;

impl KeyGroup for Rigid {
    fn has(key: &str) -> bool {
        key == "scale"
    }

    fn keys() -> Vec<KeySchema> {
        Vec::new()
    }

    fn take(fields: &GivenFields<'_>) -> Result<Self, Located> {
        let Some(scale) = fields.get("scale") else { return Ok(Rigid) };
        let cure = "leave scale out; what moves keeps its size and shape";
        Err(Located::at(&scale.span, Fault::conflict("a motion keeps all sizes", cure)))
    }
}

fn turns(node: &Node) -> Result<Vec<[f64; 4]>, Located> {
    let turn = |node: &Node| exactly(node, "a turn", "numbers, an axis and degrees", real);
    list(node)?.iter().map(turn).collect()
}

fn factors(node: &Node) -> Result<Vec<PerBand>, Located> {
    list(node)?.iter().map(per_band).collect()
}

fn numbers(node: &Node) -> Result<Vec<f64>, Located> {
    list(node)?.iter().map(real).collect()
}

fn curve(node: &Node) -> Result<Curve, Located> {
    word(node, &CURVES, |name| format!("there is no curve {name:?}"), "curves")
}
