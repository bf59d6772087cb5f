//! Shapes given by their corners: `parallelogram`, `quad`, `triangle`, `polygon`.
//!
//! A motion is applied to the corners, so that planar shapes stay as exact as they are typed.

use std::sync::Arc;

use radiosity_formats::model::Shape;
use radiosity_geom::{
    DVec3, Motion, Surface,
    shapes::{Bilinear, Parallelogram, Polygon, Triangle, Trimmed},
};

use crate::{
    fields::{corners, list, points},
    keys::{EmptyByDefault, ValueKind, keys},
    kinds::{POINT, VECTOR},
    shape::form::{Built, Form, Modelled, one},
    terms,
};

/// Corners of an outline, shared with the tree where it holds them as such.
type Outline = Arc<Vec<DVec3>>;

const OUTLINE: &str = "Corners in order around the outline";

const HOLES: EmptyByDefault<Vec<Outline>> = ValueKind::new(
    |node| list(node)?.iter().map(points).collect(),
    || terms::list("outline", "Outlines of holes, in the plane and inside the outline", 0),
)
.or_empty();

const VERTICES: &str = ", a list of points, each three numbers in brackets";

keys! {
    ParallelogramFile("A parallelogram; its front is edge1 × edge2") {
        origin: DVec3 = POINT, "A corner";
        edge1: DVec3 = VECTOR, "From the corner along u";
        edge2: DVec3 = VECTOR, "From the corner along v";
        holes: Vec<Outline> = HOLES, "";
    }
}

keys! {
    QuadFile("Four corners, in a plane or not") {
        vertices: [DVec3; 4] =
            ValueKind::new(|node| corners(node, "a quad", "vertices"), || terms::exactly(4, "point", OUTLINE))
                .example(VERTICES), "";
        holes: Vec<Outline> = HOLES, "";
    }
}

keys! {
    TriangleFile("Three corners") {
        vertices: [DVec3; 3] =
            ValueKind::new(|node| corners(node, "a triangle", "vertices"), || terms::exactly(3, "point", OUTLINE))
                .example(VERTICES), "";
    }
}

keys! {
    PolygonFile("A flat polygon") {
        vertices: Outline = ValueKind::new(points, || terms::reference("outline")).example(VERTICES),
            "Corners in order around the outline, counter-clockwise seen from the front";
        holes: Vec<Outline> = HOLES, "";
    }
}

impl Form for ParallelogramFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        let (edge1, edge2) = (motion.vector(self.edge1), motion.vector(self.edge2));
        cut(Parallelogram::new(motion.point(self.origin), edge1, edge2)?, &self.holes, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let (origin, edge1, edge2) = (self.origin, self.edge1, self.edge2);
        let corners = [origin, origin + edge1, origin + edge1 + edge2, origin + edge2];
        Ok(Some(vec![polygon_model(&corners, &self.holes, motion)]))
    }
}

impl Form for QuadFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        cut(Bilinear::new(self.vertices.map(|vertex| motion.point(vertex)))?, &self.holes, motion)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        let corners = self.vertices.map(|vertex| motion.point(vertex));
        Ok(Some(vec![match Bilinear::new(corners)?.region() {
            Some(_) => polygon_model(&self.vertices, &self.holes, motion),
            None => Shape::Quad(corners),
        }]))
    }
}

impl Form for TriangleFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        one(Triangle::new(self.vertices.map(|vertex| motion.point(vertex)))?)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        Ok(Some(vec![polygon_model(&self.vertices, &[], motion)]))
    }
}

impl Form for PolygonFile {
    fn surfaces(&self, motion: &Motion) -> Built {
        one(Polygon::new(ring(&self.vertices, motion), rings(&self.holes, motion))?)
    }

    fn models(&self, motion: &Motion) -> Modelled {
        Ok(Some(vec![polygon_model(&self.vertices, &self.holes, motion)]))
    }
}

/// The surface with its holes cut out; its parameters stay those of the whole.
fn cut(outer: impl Surface + 'static, holes: &[Outline], motion: &Motion) -> Built {
    match holes.is_empty() {
        true => one(outer),
        false => one(Trimmed::new(Box::new(outer), rings(holes, motion))?),
    }
}

fn polygon_model(outline: &[DVec3], holes: &[Outline], motion: &Motion) -> Shape {
    Shape::Polygon { outline: ring(outline, motion), holes: rings(holes, motion) }
}

fn ring(points: &[DVec3], motion: &Motion) -> Vec<DVec3> {
    points.iter().map(|point| motion.point(*point)).collect()
}

fn rings(holes: &[Outline], motion: &Motion) -> Vec<Vec<DVec3>> {
    holes.iter().map(|hole| ring(hole, motion)).collect()
}
