//! Shapes given by control points: `bezier`, `patches`, `rational`, `extrusion`.
//!
//! A motion is applied to the control points: these shapes commute with it.

use radiosity_geom::{
    DVec3, Motion, ShapeError, Surface,
    shapes::{Bezier, Extrusion, Rational},
};
use radiosity_scene::{Fault, FaultKind, error::Located, place::At, tree::Node};

use crate::{
    fields::{Fields, exactly, list, point, points, real, whole},
    shape::form::{Built, Form, one},
};

/// Control points or their weights, `net[i][j]` with i along u and j along v.
type Net<T> = [[T; 4]; 4];

#[derive(Debug)]
struct BezierFile {
    points: Net<DVec3>,
}

#[derive(Debug)]
struct PatchesFile {
    nets: Vec<Net<DVec3>>,
}

#[derive(Debug)]
struct RationalFile {
    points: Net<DVec3>,
    weights: Net<f64>,
}

#[derive(Debug)]
struct ExtrusionFile {
    curve: [DVec3; 4],
    direction: DVec3,
}

pub(super) fn bezier(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["points"])?;
    Ok(Box::new(BezierFile { points: fields.require("points", net_of_points)? }))
}

pub(super) fn patches(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["points", "patches"])?;
    let points = fields.require("points", points)?;
    let patches = fields.node("patches")?;
    let items = list(patches)?;
    if items.is_empty() {
        let expected = "at least one patch".to_owned();
        return Err(Located::at(&patches.span, Fault::wrong_count("the list of patches", &expected, 0)));
    }
    let nets = items.iter().map(|item| patch(item, &points)).collect::<Result<_, _>>()?;
    Ok(Box::new(PatchesFile { nets }))
}

pub(super) fn rational(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["points", "weights"])?;
    Ok(Box::new(RationalFile {
        points: fields.require("points", net_of_points)?,
        weights: fields.require("weights", |node| {
            exactly(node, "a net", "rows of weights", |row| exactly(row, "a row", "weights", real))
        })?,
    }))
}

pub(super) fn extrusion(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["curve", "direction"])?;
    Ok(Box::new(ExtrusionFile {
        curve: fields.require("curve", |node| exactly(node, "a curve", "control points", point))?,
        direction: fields.require("direction", point)?,
    }))
}

fn net_of_points(node: &Node) -> Result<Net<DVec3>, Located> {
    exactly(node, "a net", "rows of control points", |row| exactly(row, "a row", "control points", point))
}

/// The control points that 16 indices choose, row after row of the net.
fn patch(node: &Node, points: &[DVec3]) -> Result<Net<DVec3>, Located> {
    let indices = exactly::<16, _>(node, "a patch", "indices of points", whole)?;
    let chosen = |index: &_| chosen(index, points);
    let points = indices.iter().map(chosen).collect::<Result<Vec<_>, _>>()?;
    Ok(std::array::from_fn(|i| std::array::from_fn(|j| points[4 * i + j])))
}

fn chosen(index: &At<u32>, points: &[DVec3]) -> Result<DVec3, Located> {
    points.get(index.value as usize).copied().ok_or_else(|| {
        let cause = format!("there is no point {}: the list has {}", index.value, points.len());
        let cure = "count the points from 0, the last index is one less than their number";
        Located::at(&index.span, Fault::new(FaultKind::OutOfRange, cause, cure))
    })
}

impl Form for BezierFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        one(Bezier::new(forth(&self.points, motion))?)
    }
}

impl Form for PatchesFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let patch = |(index, net): (usize, &Net<DVec3>)| {
            let field = format!("patches[{index}]");
            match Bezier::new(forth(net, motion)) {
                Ok(patch) => Ok(Box::new(patch) as Box<dyn Surface>),
                Err(ShapeError::NoArea { .. }) => Err(ShapeError::NoArea { field }),
                Err(ShapeError::TurnsBack { .. }) => Err(ShapeError::TurnsBack { field }),
                Err(error) => Err(error),
            }
        };
        self.nets.iter().enumerate().map(patch).collect()
    }

    fn name(&self, base: &str, index: usize) -> String {
        format!("{base}-{index}")
    }
}

impl Form for RationalFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        one(Rational::new(forth(&self.points, motion), self.weights)?)
    }
}

impl Form for ExtrusionFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let curve = self.curve.map(|point| motion.point(point));
        one(Extrusion::new(curve, motion.vector(self.direction))?)
    }
}

fn forth(net: &Net<DVec3>, motion: &Motion) -> Net<DVec3> {
    net.map(|row| row.map(|point| motion.point(point)))
}
