//! A solved scene as binary glTF (`.glb`): triangles of every surface, with their light in one texture.
//!
//! | glTF | what it holds |
//! | --- | --- |
//! | root node | turns the scene's up to +y, and moves it to its place |
//! | a node and a mesh for each surface, by its name | positions, normals, indices, and the places in the texture |
//! | one material | the light as base colour, unlit (`KHR_materials_unlit`): viewers add none |
//! | one image | the textures of all surfaces side by side (`glb/atlas.rs`), exposed to sRGB |
//! | a camera | that of the scene |
//!
//! The texels before exposure, linear and per band, are [`BakedScene::raster`], which goes to an OpenEXR
//! file. Only fronts are drawn, which alone have light.
//!
//! Reference: Khronos Group, *glTF 2.0 Specification*, 2.0.1.

mod atlas;
mod binary;
mod up;

use std::io::{self, Write};

use glam::{DMat3, DQuat, DVec3};
use radiosity_reading::pictures::lightmap::{LightTexture, Lightmap};
use radiosity_reading::pictures::raster::Raster;
use radiosity_scene::{Camera, Scene};
use serde_json::{Value, json};

use crate::drawings::picture::Picture;
use crate::pictures::tessellation::Triangulation;
use radiosity_reading::quantity::Quantity;

use atlas::{Atlas, MARGIN};
use binary::{Binary, Component};

/// A scene with its light in textures.
#[derive(Debug)]
pub struct BakedScene<'a> {
    scene: &'a Scene,
    triangulations: &'a [Triangulation],
    lightmap: &'a Lightmap,
    atlas: Atlas,
    raster: Raster,
}

/// Texels across and down of the one texture that holds those of all surfaces, of these sizes.
pub fn texture_size(sizes: Vec<[usize; 2]>) -> [usize; 2] {
    Atlas::of(sizes).size()
}

impl<'a> BakedScene<'a> {
    /// The scene with what is `shown` of the light in `lightmap`, on its `triangulations`: both are of this
    /// scene, surface by surface.
    pub fn new(
        scene: &'a Scene,
        triangulations: &'a [Triangulation],
        lightmap: &'a Lightmap,
        shown: Quantity,
    ) -> Self {
        let atlas = Atlas::of(lightmap.surfaces().iter().map(LightTexture::size).collect());
        let raster = raster(scene, lightmap, &atlas, shown);
        Self { scene, triangulations, lightmap, atlas, raster }
    }

    /// The texels of all surfaces side by side, as they are: unit of exitance, per band, linear. Nothing is
    /// seen between them.
    pub fn raster(&self) -> &Raster {
        &self.raster
    }

    /// Number of triangles.
    pub fn triangles(&self) -> usize {
        self.triangulations.iter().map(|own| own.triangles.len()).sum()
    }

    /// Writes the file, with `picture` as the texture: the raster in colours. `about` is kept beside it.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, picture: &Picture, about: &Value, out: impl Write) -> io::Result<()> {
        let mut binary = Binary::default();
        let (mut nodes, mut meshes) = (vec![Value::Null], Vec::new());
        for (index, own) in self.triangulations.iter().enumerate() {
            // Another surface covers it.
            if own.triangles.is_empty() {
                continue;
            }
            let name = &self.scene.surfaces[index].name;
            nodes.push(json!({"name": name, "mesh": meshes.len()}));
            let primitive = self.primitive(index, own, &mut binary);
            meshes.push(json!({"name": name, "primitives": [primitive]}));
        }
        let cameras: Vec<Value> =
            self.scene.camera.iter().map(|camera| lens(camera, self.extent())).collect();
        nodes.extend(self.scene.camera.iter().map(stand));
        nodes[0] = self.root(nodes.len());
        let mut png = Vec::new();
        picture.write_png(&mut png)?;
        let image = binary.image(&png);
        let mut tree = json!({
            "asset": {"version": "2.0", "generator": concat!("radiosity ", env!("CARGO_PKG_VERSION"))},
            "extensionsUsed": ["KHR_materials_unlit"],
            "scene": 0,
            "scenes": [{"name": self.scene.name, "nodes": [0], "extras": about}],
            "nodes": nodes,
            "meshes": meshes,
            "materials": [material()],
            "textures": [{"sampler": 0, "source": 0}],
            // Linear, without smaller images, held at the border.
            "samplers": [{"magFilter": 9729, "minFilter": 9729, "wrapS": 33071, "wrapT": 33071}],
            "images": [{"name": "light", "mimeType": "image/png", "bufferView": image}],
        });
        if !cameras.is_empty() {
            tree["cameras"] = cameras.into();
        }
        binary.write(tree, out)
    }

    /// The mesh of one surface.
    fn primitive(&self, index: usize, own: &Triangulation, binary: &mut Binary) -> Value {
        let texture = &self.lightmap.surfaces()[index];
        let place = |parameters: &[f64; 2]| {
            self.atlas.place(index, texture.image_coordinates(*parameters)).map(|x| x as f32)
        };
        let single = |vectors: &[DVec3]| -> Vec<[f32; 3]> {
            vectors.iter().map(|vector| vector.as_vec3().to_array()).collect()
        };
        let places: Vec<[f32; 2]> = own.parameters.iter().map(place).collect();
        json!({
            "attributes": {
                "POSITION": binary.vectors(Component::Position, &single(&own.positions)),
                "NORMAL": binary.vectors(Component::Normal, &single(&own.normals)),
                "TEXCOORD_0": binary.vectors(Component::Place, &places),
            },
            "indices": binary.indices(own.triangles.as_flattened()),
            "material": 0,
        })
    }

    /// The node that carries all others, which are so many with it.
    fn root(&self, nodes: usize) -> Value {
        let turn = up::turn(self.scene.camera.as_ref());
        json!({
            "name": self.scene.name,
            "rotation": turn.to_array(),
            "translation": (turn * self.scene.middle).to_array(),
            "children": (1..nodes).collect::<Vec<usize>>(),
        })
    }

    /// About the size of the scene (scene length).
    fn extent(&self) -> f64 {
        let corners = || self.triangulations.iter().flat_map(|own| &own.positions);
        let ends = [DVec3::min, DVec3::max].map(|pick| corners().copied().reduce(pick).unwrap_or_default());
        ends[0].distance(ends[1])
    }
}

/// The texels of all surfaces, where the atlas has them, and their margins.
fn raster(scene: &Scene, lightmap: &Lightmap, atlas: &Atlas, shown: Quantity) -> Raster {
    let [width, height] = atlas.size();
    let bands = scene.bands.len();
    let mut values = vec![0.0; width * height * bands];
    let mut coverage = vec![0.0; width * height];
    for (index, texture) in lightmap.surfaces().iter().enumerate() {
        let [across, down] = texture.size();
        let [left, top] = atlas.corner(index);
        let light: Vec<Vec<f64>> =
            (0..bands).map(|band| light(scene, lightmap, index, band, shown)).collect();
        let inner = |place: usize, count: usize| place.saturating_sub(MARGIN).min(count - 1);
        for (row, column) in
            (0..down + 2 * MARGIN).flat_map(|j| (0..across + 2 * MARGIN).map(move |i| (j, i)))
        {
            let at = (top + row - MARGIN) * width + left + column - MARGIN;
            let texel = inner(row, down) * across + inner(column, across);
            coverage[at] = 1.0;
            for (band, light) in light.iter().enumerate() {
                values[at * bands + band] = light[texel];
            }
        }
    }
    Raster::new([width as u32, height as u32], scene.bands.clone(), values, coverage)
}

/// The `shown` quantity of one band of a surface (unit of exitance), by texel in row order.
fn light(scene: &Scene, lightmap: &Lightmap, surface: usize, band: usize, shown: Quantity) -> Vec<f64> {
    let texture = &lightmap.surfaces()[surface];
    let [across, down] = texture.size();
    let mut irradiance = vec![0.0; across * down];
    for (index, part) in lightmap.parts().iter().enumerate() {
        let own = texture.texels(index, band);
        irradiance.iter_mut().zip(own).for_each(|(sum, x)| *sum += part.factor * f64::from(*x));
    }
    match shown {
        Quantity::Irradiance => irradiance,
        Quantity::Radiosity => {
            let radiosity = |(texel, irradiance): (usize, f64)| {
                let parameters = texture.parameters([texel % across, texel / across]);
                lightmap.radiosity(scene, surface, band, parameters, irradiance)
            };
            irradiance.into_iter().enumerate().map(radiosity).collect()
        }
    }
}

/// The one material: the texture as base colour, unlit.
fn material() -> Value {
    json!({
        "name": "light",
        "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0, "roughnessFactor": 1},
        "extensions": {"KHR_materials_unlit": {}},
    })
}

/// Nearest distance that is drawn, over the extent of the scene. Chosen.
const NEAREST: f64 = 1e-3;

/// The lens of a camera.
fn lens(camera: &Camera, extent: f64) -> Value {
    json!({
        "type": "perspective",
        "perspective": {
            "yfov": camera.fov.to_radians(),
            "aspectRatio": f64::from(camera.width) / f64::from(camera.height),
            "znear": NEAREST * extent,
        },
    })
}

/// The place of a camera: it looks along −z, with y up.
fn stand(camera: &Camera) -> Value {
    let back = (camera.eye - camera.target).normalize();
    let right = camera.up.cross(back).normalize();
    let turn = DQuat::from_mat3(&DMat3::from_cols(right, back.cross(right), back)).normalize();
    json!({
        "name": "camera",
        "camera": 0,
        "translation": camera.eye.to_array(),
        "rotation": turn.to_array(),
    })
}
