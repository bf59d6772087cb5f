//! Shapes given by their corners: `parallelogram`, `quad`, `triangle`, `polygon`.
//!
//! A motion is applied to the corners, so that planar shapes stay as exact as they are typed.

use std::sync::Arc;

use radiosity_formats::model::Shape;
use radiosity_geom::{
    DVec3, Motion, Surface,
    shapes::{Bilinear, Parallelogram, Polygon, Triangle, Trimmed},
};
use radiosity_scene::{error::Located, tree::Node};

use crate::{
    fields::{Fields, corners, list, point, points},
    shape::form::{Built, Form, Modelled, one},
};

/// Corners of an outline, shared with the tree where it holds them as such.
type Outline = Arc<Vec<DVec3>>;

#[derive(Debug)]
struct ParallelogramFile {
    origin: DVec3,
    edge1: DVec3,
    edge2: DVec3,
    holes: Vec<Outline>,
}

#[derive(Debug)]
struct QuadFile {
    vertices: [DVec3; 4],
    holes: Vec<Outline>,
}

#[derive(Debug)]
struct TriangleFile {
    vertices: [DVec3; 3],
}

#[derive(Debug)]
struct PolygonFile {
    vertices: Outline,
    holes: Vec<Outline>,
}

pub(super) fn parallelogram(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["origin", "edge1", "edge2", "holes"])?;
    Ok(Box::new(ParallelogramFile {
        origin: fields.require("origin", point)?,
        edge1: fields.require("edge1", point)?,
        edge2: fields.require("edge2", point)?,
        holes: holes(&fields)?,
    }))
}

pub(super) fn quad(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["vertices", "holes"])?;
    let vertices = fields.require("vertices", |node| corners(node, "a quad", "vertices"))?;
    Ok(Box::new(QuadFile { vertices, holes: holes(&fields)? }))
}

pub(super) fn triangle(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["vertices"])?;
    let vertices = fields.require("vertices", |node| corners(node, "a triangle", "vertices"))?;
    Ok(Box::new(TriangleFile { vertices }))
}

pub(super) fn polygon(node: &Node) -> Result<Box<dyn Form>, Located> {
    let fields = Fields::new(node, &["vertices", "holes"])?;
    Ok(Box::new(PolygonFile { vertices: fields.require("vertices", points)?, holes: holes(&fields)? }))
}

fn holes(fields: &Fields<'_>) -> Result<Vec<Outline>, Located> {
    let holes = fields.optional("holes", |node| list(node)?.iter().map(points).collect())?;
    Ok(holes.unwrap_or_default())
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
