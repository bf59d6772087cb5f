//! Surfaces of a scene → a model, which scenes of other programs are written from.

use std::collections::HashMap;
use std::num::NonZeroUsize;

use radiosity_formats::{
    model::{Camera as ModelCamera, Material as ModelMaterial, Model, Shape, Sides, Surface},
    names::UniqueNames,
};
use radiosity_geom::{DVec3, ShapeError};
use radiosity_scene::{
    Camera, Fault, Scene, SceneSurface,
    error::{Located, title},
};
use radiosity_work::listed::{SPELT, listed};

use crate::instances::PlacedSurface;

/// Most surfaces of a model, as many as instances make.
const MOST_SURFACES: usize = 1_000_000;

fn too_many() -> Fault {
    let cause = format!("with the pieces of this surface there are more than {MOST_SURFACES} surfaces");
    Fault::foreign(cause, "cut curved surfaces into fewer pieces")
}

/// A model that grows by surfaces.
pub(super) struct Export<'a> {
    model: Model,
    /// The scene's surfaces by name, which know their materials.
    known: HashMap<&'a str, &'a SceneSurface>,
    /// Indices of the materials in the model, by name and light (as bits).
    materials: HashMap<(&'a str, Vec<u64>), usize>,
    names: UniqueNames,
    surface_names: UniqueNames,
    /// Cells along each parameter of a curved surface, of which each becomes a flat piece; None: curved surfaces
    /// stay.
    tessellation: Option<NonZeroUsize>,
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
    /// A model of this scene without surfaces, whose curved surfaces are to be cut into flat pieces, or to stay.
    pub(super) fn new(scene: &'a Scene, tessellation: Option<NonZeroUsize>) -> Self {
        let unit = Some(scene.unit.clone());
        let model = Model { bands: scene.bands.clone(), unit, ..Model::default() };
        Self {
            model,
            known: scene.surfaces.iter().map(|surface| (surface.name.as_str(), surface)).collect(),
            materials: HashMap::new(),
            names: UniqueNames::default(),
            surface_names: UniqueNames::default(),
            tessellation,
            refused: Vec::new(),
        }
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
        let faulty =
            |error: ShapeError| Located::at(&file.shape.span, error.into()).within(|| title("surface", name));
        let Some(shapes) = file.shape.models(motion, self.tessellation).map_err(faulty)? else {
            self.refused.push(ForeignSurface { name: name.clone(), key: file.shape.kind });
            return Ok(());
        };
        if file.order.is_some() || file.subdivide.is_some() {
            self.model.note("orders and numbers of elements are left out", None);
        }
        if file.back_material.is_some() {
            self.model.note("materials of backs are left out: both sides have that of the front", None);
        }
        let sides = if file.two_sided { Sides::Both } else { Sides::Front };
        for (index, parts) in shapes.into_iter().enumerate() {
            self.push(&file.shape.name(name, index), parts, sides, file.flip);
        }
        match self.model.surfaces.len() > MOST_SURFACES {
            true => Err(Located::at(&file.shape.span, too_many())),
            false => Ok(()),
        }
    }

    /// Adds the shapes that a surface is made of.
    fn push(&mut self, name: &str, parts: Vec<Shape>, sides: Sides, is_flipped: bool) {
        let material = self.known.get(name).copied().and_then(|surface| self.material(surface));
        let is_cut = parts.len() > 1;
        if is_cut {
            self.model.note("curved surfaces become flat pieces", None);
        }
        for (part, mut shape) in parts.into_iter().enumerate() {
            if is_flipped {
                shape.turn_over();
            }
            let wanted = if is_cut { format!("{name}-{part}") } else { name.to_owned() };
            let name = self.surface_names.take(&wanted);
            self.model.surfaces.push(Surface { name, material, shape, sides, file: None, place: None });
        }
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
            _ => {
                let spelt = |ForeignSurface { name, key }: &ForeignSurface| format!("{name:?} ({key})");
                let refused: Vec<String> = self.refused.iter().map(spelt).collect();
                let cause = format!("other programs have no such shapes as {}", listed(&refused, SPELT));
                let cure = "cut them into flat pieces (`convert --tessellate 20`), write the scene as .toml or .json, or leave them out";
                Err(Located::nowhere(Fault::foreign(cause, cure)))
            }
        }
    }
}
