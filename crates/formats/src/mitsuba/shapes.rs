//! Shapes: placed in the world, with the bsdf and the emitter that they have.

use glam::{DAffine3, DVec3};
use radiosity_photometry::error::Refusal;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::short;

use super::bsdfs::{Bsdfs, Finish, USUAL};
use super::colours::Colours;
use super::element::{Element, Remarks};
use super::emitters;
use super::ids::Ids;
use super::meshes::{Meshes, stem};
use super::placed;
use super::transforms;
use crate::budget::Budget;
use crate::builder::{Coat, ModelBuilder};
use crate::model::{Model, Shape, Sides};
use radiosity_photometry::files::Files;

/// The shapes of a scene as a model.
pub(super) struct Shapes<'a, 'b> {
    ids: &'b Ids<'a>,
    bsdfs: Bsdfs,
    meshes: Meshes<'b>,
    model: ModelBuilder,
    budget: Budget,
    /// Shapes so far, repetitions counted.
    count: usize,
    pub(super) remarks: Remarks,
}

impl<'a, 'b> Shapes<'a, 'b> {
    /// A model without shapes yet.
    pub(super) fn new(ids: &'b Ids<'a>, files: &'b dyn Files) -> Self {
        Shapes {
            ids,
            bsdfs: Bsdfs::default(),
            meshes: Meshes::new(files),
            model: ModelBuilder::default(),
            budget: Budget::default(),
            count: 0,
            remarks: Remarks::default(),
        }
    }

    /// The model of all that was added.
    pub(super) fn finish(self) -> Model {
        self.model.finish()
    }

    /// Adds a shape of the scene.
    ///
    /// # Errors
    /// A shape that lacks a property or has one that cannot be followed, and transforms that distort round
    /// shapes.
    pub(super) fn add(&mut self, shape: &'a Element) -> Result<(), Refusal> {
        match shape.meet().kind() {
            "shapegroup" => Ok(()),
            "instance" => self.instance(shape),
            _ => self.plain(shape, &DAffine3::IDENTITY),
        }
    }

    /// The shapes of a group, where an instance puts them.
    fn instance(&mut self, instance: &'a Element) -> Result<(), Refusal> {
        let outer = transforms::of(instance, "to_world")?;
        for child in instance.children.iter().filter(|child| matches!(child.tag.as_str(), "ref" | "shape")) {
            let group = self.ids.meant(child)?;
            if group.kind() != "shapegroup" {
                return Err(child.refusal(
                    "the instance is of something else than a shapegroup",
                    "name a <shape type=\"shapegroup\">",
                ));
            }
            for shape in group.children.iter().filter(|shape| shape.tag == "shape") {
                if matches!(shape.meet().kind(), "instance" | "shapegroup") {
                    return Err(shape.refusal(
                        "a shapegroup holds an instance or a shapegroup",
                        "take it out of the group: Mitsuba follows none",
                    ));
                }
                self.plain(shape, &outer)?;
            }
        }
        Ok(())
    }

    /// A shape that is no group.
    fn plain(&mut self, shape: &'a Element, outer: &DAffine3) -> Result<(), Refusal> {
        self.count += 1;
        self.budget.spend(shape.size()).map_err(|fault| shape.at(fault))?;
        let kind = shape.kind();
        if !matches!(kind, "rectangle" | "cube" | "disk" | "cylinder" | "sphere" | "obj" | "ply") {
            shape.pass_over();
            let text = NoteText::from("shapes of type ").quoting(format!("'{}'", short(kind)));
            self.remarks.add(text.then(" are left out"), shape);
            return Ok(());
        }
        let Some(coat) = self.coat(shape)? else {
            shape.pass_over();
            self.remarks.add("shapes with a bsdf of type 'null' are left out", shape);
            return Ok(());
        };
        let placed = *outer * transforms::of(shape, "to_world")?;
        let parts = self.parts(shape, &placed)?;
        let name = self.name(shape)?;
        let is_alone = parts.len() == 1;
        for (index, part) in parts.into_iter().enumerate() {
            let name = if is_alone { name.clone() } else { format!("{name}-{}", index + 1) };
            self.model.stand_in(Some(&shape.file));
            let added = self.model.surface(Some(&name), part, &coat, shape.line);
            added.map_err(|fault| shape.at(fault))?;
        }
        Ok(())
    }

    /// Id of a shape, or the name of its file, or its type and a number.
    fn name(&self, shape: &Element) -> Result<String, Refusal> {
        if let Some(id) = shape.attribute("id").filter(|id| !id.trim().is_empty()) {
            return Ok(id.to_owned());
        }
        Ok(match shape.kind() {
            "obj" | "ply" => stem(shape.string("filename")?.unwrap_or_default()).to_owned(),
            kind => format!("{kind}-{}", self.count),
        })
    }

    /// The surfaces of a shape in the world.
    fn parts(&mut self, shape: &'a Element, placed: &DAffine3) -> Result<Vec<Shape>, Refusal> {
        let is_flipped = shape.boolean("flip_normals")?;
        let at = |fault: Refusal| shape.at(fault);
        let one = |shape: Shape| vec![shape];
        match shape.kind() {
            "rectangle" => Ok(one(placed::rectangle(placed, is_flipped))),
            "cube" => placed::cube(placed, is_flipped).map_err(at),
            "disk" => placed::disk(placed, is_flipped).map(one).map_err(at),
            "cylinder" => {
                let ends = [point(shape, "p0", DVec3::ZERO)?, point(shape, "p1", DVec3::Z)?];
                let radius = radius(shape)?;
                placed::cylinder(placed, ends, radius, is_flipped).map(one).map_err(at)
            }
            "sphere" => {
                let (center, radius) = (point(shape, "center", DVec3::ZERO)?, radius(shape)?);
                placed::sphere(placed, center, radius, is_flipped).map(one).map_err(at)
            }
            _ => {
                let is_flat = shape.boolean("face_normals")?;
                let mesh = self.meshes.of(shape, is_flat)?;
                mesh.remarks
                    .iter()
                    .for_each(|text| self.remarks.add(NoteText::from("of meshes: ").followed(text), shape));
                let own = transforms::of(shape, "to_world")?;
                let has_normals = mesh.has_normals && !is_flat;
                let is_lost = placed::is_mirror(&own) && !has_normals;
                let is_turned = (placed::is_mirror(placed) != is_flipped) != is_lost;
                Ok(mesh.faces.iter().map(|face| placed::face(placed, face, is_turned)).collect())
            }
        }
    }

    /// Material and sides of a shape; none if light goes through it. A lamp's material is named after the
    /// lamp, so that the material that it is painted with keeps its name.
    fn coat(&mut self, shape: &'a Element) -> Result<Option<Coat>, Refusal> {
        let emitter = self.only(shape, "emitter")?;
        let finish = self.finish_of(shape, emitter.is_some())?;
        let exitance = match emitter {
            Some(emitter) => {
                emitters::exitance(emitter, &mut Colours { ids: self.ids, remarks: &mut self.remarks })?
            }
            None => None,
        };
        let Some(emission) = exitance else {
            let Finish { name, reflectance, sides, is_void } = finish;
            return Ok((!is_void).then_some(Coat { name, reflectance, emission: [0.0; 3], sides }));
        };
        if finish.sides == Sides::Both {
            self.remarks
                .add("backs of surfaces that shine are black: Mitsuba's shine on the front only", shape);
        }
        let lamp = emitter.and_then(|emitter| emitter.attribute("id")).or(shape.attribute("id"));
        let name = lamp.unwrap_or("lamp").to_owned();
        Ok(Some(Coat { name, reflectance: finish.reflectance, emission, sides: Sides::Front }))
    }

    /// The finish of a shape, or Mitsuba's own.
    fn finish_of(&mut self, shape: &'a Element, is_lamp: bool) -> Result<Finish, Refusal> {
        if let Some(bsdf) = self.only(shape, "bsdf")? {
            return self.bsdfs.finish(bsdf, &mut Colours { ids: self.ids, remarks: &mut self.remarks });
        }
        let reflectance = if is_lamp { [0.0; 3] } else { [USUAL; 3] };
        Ok(Finish { name: "default".to_owned(), reflectance, sides: Sides::Front, is_void: false })
    }

    /// The only thing of a kind in a shape.
    fn only(&self, shape: &'a Element, tag: &str) -> Result<Option<&'a Element>, Refusal> {
        let mut found = None;
        for child in shape.children.iter().filter(|child| child.tag == tag || child.tag == "ref") {
            if self.ids.tag(child)? == tag && found.replace(self.ids.meant(child)?).is_some() {
                return Err(child.refusal(format!("the shape has two of <{tag}>"), "take one out"));
            }
        }
        Ok(found)
    }
}

/// The point that a name is given to.
fn point(shape: &Element, name: &str, absent: DVec3) -> Result<DVec3, Refusal> {
    shape.property(name).map_or(Ok(absent), |property| property.vector(0.0).map(DVec3::from))
}

fn radius(shape: &Element) -> Result<f64, Refusal> {
    Ok(shape.float("radius")?.unwrap_or(1.0))
}
