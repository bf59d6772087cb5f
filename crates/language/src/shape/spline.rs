//! Shapes given by control points: `bezier`, `patches`, `rational`, `extrusion`.
//!
//! A motion is applied to the control points: these shapes commute with it.

use std::sync::Arc;

use radiosity_geom::{
    DVec3, Motion, ShapeError, Surface,
    shapes::{Bezier, Extrusion, Rational},
};
use radiosity_scene::{Fault, FaultKind, error::Located, place::At, tree::Node};

use crate::{
    fields::{exactly, list, point, points, real, whole},
    keys::{GivenFields, ValueKind, keys},
    kinds::VECTOR,
    shape::form::{Built, Form, one},
    terms,
};

/// Control points or their weights, `net[i][j]` with i along u and j along v.
type Net<T> = [[T; 4]; 4];

const NET: ValueKind<Net<DVec3>> = ValueKind::new(net_of_points, || terms::exactly(4, "row", ""))
    .example(", four rows of four points, each three numbers in brackets");

/// The control points of a cubic curve.
pub(super) const CURVE: ValueKind<[DVec3; 4]> = ValueKind::new(
    |node| exactly(node, "a curve", "control points", point),
    || terms::exactly(4, "point", ""),
)
.example(", four control points, each three numbers in brackets");

keys! {
    BezierFile("A bicubic Bézier patch") {
        points: Net<DVec3> = NET, "Four rows of four control points";
    }
}

keys! {
    PatchesFile("Bicubic Bézier patches, each a surface"; check_patches) {
        points: Arc<Vec<DVec3>> = ValueKind::new(points, || terms::list("point", "", 0))
            .example(", a list of points, each three numbers in brackets"),
            "Control points, shared by the patches";
        patches: At<Vec<[At<u32>; 16]>> =
            ValueKind::new(patches, || terms::list("patch", "", 1))
                .example(", a list of patches, each 16 indices of points, counted from 0"),
            "The patches, each of 16 points";
    }
}

keys! {
    RationalFile("A rational bicubic Bézier patch") {
        points: Net<DVec3> = NET, "Four rows of four control points";
        weights: Net<f64> = ValueKind::new(weights, || terms::exactly(4, "weights", ""))
            .example(", four rows of four numbers above 0"),
            "Four rows of four weights";
    }
}

keys! {
    ExtrusionFile("A curve moved along a straight line") {
        curve: [DVec3; 4] = CURVE, "Control points of a cubic Bézier curve";
        direction: DVec3 = VECTOR, "By this the curve is moved";
    }
}

fn net_of_points(node: &Node) -> Result<Net<DVec3>, Located> {
    exactly(node, "a net", "rows of control points", |row| exactly(row, "a row", "control points", point))
}

fn weights(node: &Node) -> Result<Net<f64>, Located> {
    exactly(node, "a net", "rows of weights", |row| exactly(row, "a row", "weights", real))
}

fn patches(node: &Node) -> Result<Vec<[At<u32>; 16]>, Located> {
    list(node)?.iter().map(|node| exactly(node, "a patch", "indices of points", whole)).collect()
}

/// There is a patch, and all points are there.
fn check_patches(PatchesFile { points, patches }: &PatchesFile, _: &GivenFields<'_>) -> Result<(), Located> {
    if patches.value.is_empty() {
        let fault = Fault::wrong_count("the list of patches", "at least one patch", 0);
        return Err(Located::at(&patches.span, fault));
    }
    match patches.value.iter().flatten().find(|index| index.value as usize >= points.len()) {
        None => Ok(()),
        Some(At { value, span }) => {
            let cause = format!("there is no point {value}: the list has {}", points.len());
            let cure = "count the points from 0, the last index is one less than their number";
            Err(Located::at(span, Fault::new(FaultKind::OutOfRange, cause, cure)))
        }
    }
}

impl Form for BezierFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        one(Bezier::new(forth(&self.points, motion))?)
    }
}

impl Form for PatchesFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let patch = |(index, indices): (usize, &[At<u32>; 16])| {
            let field = format!("patches[{index}]");
            // Row after row of the net.
            let point = |i: usize, j: usize| self.points[indices[4 * i + j].value as usize];
            let net = std::array::from_fn(|i| std::array::from_fn(|j| point(i, j)));
            match Bezier::new(forth(&net, motion)) {
                Ok(patch) => Ok(Box::new(patch) as Box<dyn Surface>),
                Err(ShapeError::NoArea { .. }) => Err(ShapeError::NoArea { field }),
                Err(ShapeError::TurnsBack { .. }) => Err(ShapeError::TurnsBack { field }),
                Err(error) => Err(error),
            }
        };
        self.patches.value.iter().enumerate().map(patch).collect()
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
