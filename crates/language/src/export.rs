//! Surfaces of a scene → a model, which scenes of other programs are written from.

use std::collections::HashMap;

use radiosity_formats::{
    model::{Camera as ModelCamera, Material as ModelMaterial, Model, Shape, Sides, Surface},
    names::UniqueNames,
};
use radiosity_geom::DVec3;
use radiosity_scene::{
    Camera, Fault, SceneSurface,
    error::{Located, title},
};

use crate::instances::PlacedSurface;

/// Most names that a message spells out, with the key of each: a line or two of a terminal.
const SPELT: usize = 4;

/// A model that grows by surfaces.
pub(super) struct Export<'a> {
    model: Model,
    /// The scene's surfaces by name, which know their materials.
    known: HashMap<&'a str, &'a SceneSurface>,
    /// Indices of the materials in the model, by name and light (as bits).
    materials: HashMap<(&'a str, Vec<u64>), usize>,
    names: UniqueNames,
    /// Surfaces of shapes that a model cannot hold.
    refused: Vec<ForeignSurface>,
}

/// A surface of a shape that a model cannot hold.
struct ForeignSurface {
    name: String,
    /// Key of its shape.
    key: &'static str,
}

impl<'a> Export<'a> {
    /// An empty model for these surfaces, its bands and its unit.
    pub(super) fn new(surfaces: &'a [SceneSurface], bands: &[String], unit: &str) -> Self {
        let model = Model { bands: bands.to_vec(), unit: Some(unit.to_owned()), ..Model::default() };
        let known = surfaces.iter().map(|surface| (surface.name.as_str(), surface)).collect();
        Self { model, known, materials: HashMap::new(), names: UniqueNames::default(), refused: Vec::new() }
    }

    /// Adds the camera of the scene, from whose coordinates `middle` was subtracted.
    pub(super) fn camera(&mut self, camera: &Camera, middle: DVec3) {
        self.model.camera = Some(ModelCamera {
            eye: camera.eye + middle,
            target: camera.target + middle,
            up: camera.up,
            fov: camera.fov,
            size: Some([camera.width, camera.height]),
        });
    }

    /// Adds the surfaces of an entry of the scene.
    pub(super) fn add(&mut self, placed: &PlacedSurface<'_>) -> Result<(), Located> {
        let PlacedSurface { file, name, motion, .. } = placed;
        let shapes = file
            .shape
            .models(motion)
            .map_err(|error| Located::at(&file.shape.span, error.into()).within(|| title("surface", name)))?;
        let Some(shapes) = shapes else {
            self.refused.push(ForeignSurface { name: name.clone(), key: file.shape.kind });
            return Ok(());
        };
        if file.order.is_some() || file.subdivide.is_some() {
            self.model.note("orders and numbers of elements are left out", None);
        }
        for (index, mut shape) in shapes.into_iter().enumerate() {
            let name = file.shape.name(name, index);
            if file.flip {
                shape.turn_over();
            }
            if file.back_material.is_some() {
                self.model.note("materials of backs are left out: both sides have that of the front", None);
            }
            let sides = if file.two_sided { Sides::Both } else { Sides::Front };
            self.push(&name, shape, sides);
        }
        Ok(())
    }

    fn push(&mut self, name: &str, shape: Shape, sides: Sides) {
        let material = self.known.get(name).copied().and_then(|surface| self.material(surface));
        self.model.surfaces.push(Surface { name: name.to_owned(), material, shape, sides, place: None });
    }

    /// The index of the material of a surface; none where the scene gives it none.
    fn material(&mut self, surface: &'a SceneSurface) -> Option<usize> {
        let own = surface.material_name.as_ref()?;
        if surface.group.is_some() {
            self.model.note("light groups are left out", None);
        }
        if surface.material.is_patterned() {
            self.model.note("what varies over surfaces becomes its mean", None);
        }
        if surface.material.transmits() {
            self.model.note("transmittances are left out", None);
        }
        let reflectance = surface.material.reflectance.clone();
        let emission: Vec<f64> =
            (0..surface.material.emission.len()).map(|band| surface.exitance(band)).collect();
        let light = reflectance.iter().chain(&emission).map(|value| value.to_bits()).collect();
        let next = self.model.materials.len();
        let index = *self.materials.entry((own, light)).or_insert(next);
        if index == next {
            self.model.materials.push(ModelMaterial { name: self.names.take(own), reflectance, emission });
        }
        Some(index)
    }

    /// The model; refused if it lacks surfaces.
    pub(super) fn finish(self) -> Result<Model, Located> {
        match self.refused.len() {
            0 => Ok(self.model),
            count => {
                let spelt = |ForeignSurface { name, key }: &ForeignSurface| format!("{name:?} ({key})");
                let spelt = self.refused.iter().take(SPELT).map(spelt);
                let spelt = spelt.collect::<Vec<_>>().join(", ");
                let more = if count > SPELT { format!(" and {} more", count - SPELT) } else { String::new() };
                let cause = format!("other programs have no such shapes as {spelt}{more}");
                let cure = "write the scene as .toml or .json, or leave these surfaces out";
                Err(Located::nowhere(Fault::foreign(cause, cure)))
            }
        }
    }
}
