//! Motions as typed.

use std::sync::Arc;

use radiosity_geom::DVec3;
use radiosity_scene::{
    Curve, Fault,
    error::{Located, motion_title},
    place::{At, Span},
    tree::{Node, entry},
};

use crate::fields::{Fields, exactly, list, point, points, real, table, text, texts, truth};

/// The key of the list of motions.
pub(crate) const MOTION: &str = "motion";

/// `[[motion]]`.
#[derive(Debug)]
pub(crate) struct MotionFile {
    pub name: At<String>,
    pub span: Span,
    pub surfaces: Vec<At<String>>,
    pub instances: Vec<At<String>>,
    pub luminaires: Vec<At<String>>,
    /// Span of `camera = true`; none where the camera does not move along.
    pub camera: Option<Span>,
    pub translate: Option<TranslateFile>,
    pub rotate: Option<RotateFile>,
}

/// `translate = { … }`.
#[derive(Debug)]
pub(crate) struct TranslateFile {
    pub points: At<Arc<Vec<DVec3>>>,
    pub times: Option<At<Vec<f64>>>,
    pub curve: Curve,
}

/// `rotate = { … }`.
#[derive(Debug)]
pub(crate) struct RotateFile {
    pub span: Span,
    pub center: DVec3,
    pub turns: TurnsFile,
    pub times: Option<At<Vec<f64>>>,
}

/// Rotations of a motion, in one of two notations.
#[derive(Debug)]
pub(crate) enum TurnsFile {
    /// Degrees about one axis.
    Axis { axis: At<DVec3>, angles: At<Vec<f64>>, curve: Curve },
    /// An axis and degrees each time.
    Keys(At<Vec<[f64; 4]>>),
}

const MOTION_KEYS: [&str; 7] =
    ["name", "surfaces", "instances", "luminaires", "camera", "translate", "rotate"];

/// The list of motions; `prefix` stands before the names of those that are given none.
pub(crate) fn read_motions(node: &Node, prefix: &str) -> Result<Vec<MotionFile>, Located> {
    let read = |(index, node)| {
        let unnamed = format!("{prefix}motion-{}", index + 1);
        read_motion(node, &unnamed).map_err(|error| error.within(|| motion_title(&unnamed)))
    };
    list(node)?.iter().enumerate().map(read).collect()
}

fn read_motion(node: &Node, unnamed: &str) -> Result<MotionFile, Located> {
    if let Some(scale) = entry(table(node)?, "scale") {
        return Err(Located::at(&scale.span, not_rigid()));
    }
    let fields = Fields::new(node, &MOTION_KEYS)?;
    let name = fields.optional("name", text)?.unwrap_or_else(|| At::new(unnamed.to_owned(), fields.span()));
    let rest = || {
        Ok(MotionFile {
            span: fields.span().clone(),
            surfaces: fields.optional("surfaces", texts)?.unwrap_or_default(),
            instances: fields.optional("instances", texts)?.unwrap_or_default(),
            luminaires: fields.optional("luminaires", texts)?.unwrap_or_default(),
            camera: match fields.get("camera") {
                Some(node) => truth(node)?.then(|| node.span.clone()),
                None => None,
            },
            translate: fields.optional("translate", read_translate)?,
            rotate: fields.optional("rotate", read_rotate)?,
            name: name.clone(),
        })
    };
    rest().map_err(|error: Located| error.within(|| motion_title(&name.value)))
}

fn read_translate(node: &Node) -> Result<TranslateFile, Located> {
    let fields = Fields::new(node, &["points", "times", "curve"])?;
    Ok(TranslateFile {
        points: fields.require("points", |node| Ok(At::new(points(node)?, &node.span)))?,
        times: fields.optional("times", numbers)?,
        curve: fields.optional("curve", curve)?.unwrap_or_default(),
    })
}

fn read_rotate(node: &Node) -> Result<RotateFile, Located> {
    let fields = Fields::new(node, &["center", "axis", "angles", "turns", "times", "curve"])?;
    Ok(RotateFile {
        span: fields.span().clone(),
        center: fields.require("center", point)?,
        times: fields.optional("times", numbers)?,
        turns: match fields.get("turns") {
            Some(node) => read_turns(&fields, node)?,
            None => TurnsFile::Axis {
                axis: fields.require("axis", |node| Ok(At::new(point(node)?, &node.span)))?,
                angles: fields.require("angles", numbers)?,
                curve: fields.optional("curve", curve)?.unwrap_or_default(),
            },
        },
    })
}

/// Rotations about several axes, which go without the keys of one axis.
fn read_turns(fields: &Fields<'_>, node: &Node) -> Result<TurnsFile, Located> {
    for other in ["axis", "angles", "curve"] {
        if let Some(other_node) = fields.get(other) {
            let fault = Fault::exclusive("turns", other);
            return Err(Located::at(&other_node.span, fault));
        }
    }
    let turn = |node: &Node| exactly(node, "a turn", "numbers, an axis and degrees", real);
    let turns = list(node)?.iter().map(turn).collect::<Result<_, _>>()?;
    Ok(TurnsFile::Keys(At::new(turns, &node.span)))
}

fn numbers(node: &Node) -> Result<At<Vec<f64>>, Located> {
    let numbers = list(node)?.iter().map(real).collect::<Result<_, _>>()?;
    Ok(At::new(numbers, &node.span))
}

fn not_rigid() -> Fault {
    Fault::conflict("a motion keeps all sizes", "leave scale out; what moves keeps its size and shape")
}

fn unknown_curve(name: &str) -> Fault {
    let known = ["line", "spline"].map(str::to_owned);
    Fault::unknown(format!("there is no curve {name:?}"), name, known, "curves")
}

fn curve(node: &Node) -> Result<Curve, Located> {
    let name = text(node)?;
    match name.value.as_str() {
        "line" => Ok(Curve::Line),
        "spline" => Ok(Curve::Spline),
        _ => Err(Located::at(&name.span, unknown_curve(&name.value))),
    }
}
