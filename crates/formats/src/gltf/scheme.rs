//! The members of a glTF that are read (section 5).

use std::collections::BTreeSet;

use serde::Deserialize;
use serde::de::{IgnoredAny, MapAccess};
use serde_json::value::RawValue;

use super::extension_set::{ExtensionSet, Extensions, extension_set};

/// A list whose items know their places.
type List<'a> = Vec<&'a RawValue>;

/// The root object of the JSON.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Root<'a> {
    pub(super) asset: Asset,
    pub(super) scene: Option<usize>,
    #[serde(borrow, default)]
    pub(super) scenes: List<'a>,
    #[serde(borrow, default)]
    pub(super) nodes: List<'a>,
    #[serde(borrow, default)]
    pub(super) meshes: List<'a>,
    #[serde(borrow, default)]
    pub(super) accessors: List<'a>,
    #[serde(borrow, default)]
    pub(super) buffer_views: List<'a>,
    #[serde(borrow, default)]
    pub(super) buffers: List<'a>,
    #[serde(borrow, default)]
    pub(super) materials: List<'a>,
    #[serde(borrow, default)]
    pub(super) cameras: List<'a>,
    #[serde(borrow, default)]
    pub(super) textures: List<'a>,
    #[serde(borrow, default)]
    pub(super) images: List<'a>,
    #[serde(borrow, default)]
    pub(super) samplers: List<'a>,
    #[serde(default)]
    pub(super) animations: Vec<IgnoredAny>,
    #[serde(default)]
    pub(super) extensions_required: Vec<String>,
    #[serde(default)]
    pub(super) extensions_used: BTreeSet<String>,
    #[serde(default, deserialize_with = "extension_set")]
    pub(super) extensions: Extensions,
}

#[derive(Debug, Deserialize)]
pub(super) struct Asset {
    pub(super) version: String,
}

#[derive(Debug, Deserialize)]
pub(super) struct Scene {
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) nodes: Vec<usize>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Node {
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) children: Vec<usize>,
    pub(super) mesh: Option<usize>,
    pub(super) camera: Option<usize>,
    pub(super) skin: Option<IgnoredAny>,
    pub(super) matrix: Option<[f64; 16]>,
    pub(super) translation: Option<[f64; 3]>,
    pub(super) rotation: Option<[f64; 4]>,
    pub(super) scale: Option<[f64; 3]>,
    #[serde(default, deserialize_with = "extension_set")]
    pub(super) extensions: NodeExtensions,
}

#[derive(Debug, Default)]
pub(super) struct NodeExtensions {
    /// Value of `KHR_lights_punctual`.
    pub(super) light: Option<IgnoredAny>,
    /// Value of `EXT_mesh_gpu_instancing`.
    pub(super) instances: Option<IgnoredAny>,
    pub(super) others: Extensions,
}

impl ExtensionSet for NodeExtensions {
    fn take<'de, A: MapAccess<'de>>(&mut self, name: &str, map: &mut A) -> Result<bool, A::Error> {
        match name {
            "KHR_lights_punctual" => self.light = map.next_value()?,
            "EXT_mesh_gpu_instancing" => self.instances = map.next_value()?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn others(&mut self) -> &mut Extensions {
        &mut self.others
    }
}

#[derive(Debug, Deserialize)]
pub(super) struct Mesh<'a> {
    pub(super) name: Option<String>,
    #[serde(borrow)]
    pub(super) primitives: List<'a>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Primitive {
    pub(super) attributes: Attributes,
    pub(super) indices: Option<usize>,
    pub(super) material: Option<usize>,
    pub(super) mode: Option<u32>,
    pub(super) targets: Option<IgnoredAny>,
    #[serde(default, deserialize_with = "extension_set")]
    pub(super) extensions: Extensions,
}

#[derive(Debug, Deserialize)]
pub(super) struct Attributes {
    #[serde(rename = "POSITION")]
    pub(super) position: Option<usize>,
    #[serde(rename = "NORMAL")]
    pub(super) normal: Option<usize>,
    #[serde(rename = "COLOR_0")]
    pub(super) colour: Option<IgnoredAny>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Accessor {
    pub(super) buffer_view: Option<usize>,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) component_type: u32,
    #[serde(default)]
    pub(super) normalized: bool,
    pub(super) count: usize,
    #[serde(rename = "type")]
    pub(super) kind: String,
    pub(super) sparse: Option<Sparse>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Sparse {
    pub(super) count: usize,
    pub(super) indices: SparsePart,
    pub(super) values: SparsePart,
}

/// Indices or values of a sparse accessor; values have the type of the accessor.
#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct SparsePart {
    pub(super) buffer_view: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) component_type: Option<u32>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct BufferView {
    pub(super) buffer: usize,
    #[serde(default)]
    pub(super) byte_offset: usize,
    pub(super) byte_length: usize,
    pub(super) byte_stride: Option<usize>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Buffer<'a> {
    #[serde(borrow)]
    pub(super) uri: Option<&'a RawValue>,
    pub(super) byte_length: usize,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Material {
    pub(super) name: Option<String>,
    #[serde(default)]
    pub(super) pbr_metallic_roughness: Pbr,
    #[serde(default)]
    pub(super) emissive_factor: [f64; 3],
    pub(super) emissive_texture: Option<IgnoredAny>,
    pub(super) normal_texture: Option<IgnoredAny>,
    pub(super) alpha_mode: Option<String>,
    #[serde(default)]
    pub(super) double_sided: bool,
    #[serde(default, deserialize_with = "extension_set")]
    pub(super) extensions: MaterialExtensions,
}

#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Pbr {
    pub(super) base_color_factor: Option<[f64; 4]>,
    pub(super) base_color_texture: Option<IgnoredAny>,
    pub(super) metallic_factor: Option<f64>,
    pub(super) metallic_roughness_texture: Option<IgnoredAny>,
}

#[derive(Debug, Default)]
pub(super) struct MaterialExtensions {
    /// Value of `KHR_materials_emissive_strength`.
    pub(super) strength: Option<EmissiveStrength>,
    /// Value of `KHR_materials_pbrSpecularGlossiness`.
    pub(super) glossiness: Option<Glossiness>,
    pub(super) others: Extensions,
}

impl ExtensionSet for MaterialExtensions {
    fn take<'de, A: MapAccess<'de>>(&mut self, name: &str, map: &mut A) -> Result<bool, A::Error> {
        match name {
            "KHR_materials_emissive_strength" => self.strength = map.next_value()?,
            "KHR_materials_pbrSpecularGlossiness" => self.glossiness = map.next_value()?,
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn others(&mut self) -> &mut Extensions {
        &mut self.others
    }
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct EmissiveStrength {
    pub(super) emissive_strength: Option<f64>,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "camelCase")]
pub(super) struct Glossiness {
    pub(super) diffuse_factor: Option<[f64; 4]>,
    pub(super) diffuse_texture: Option<IgnoredAny>,
    pub(super) specular_factor: Option<[f64; 3]>,
    pub(super) specular_glossiness_texture: Option<IgnoredAny>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Camera {
    pub(super) perspective: Option<Perspective>,
}

#[derive(Debug, Deserialize)]
pub(super) struct Perspective {
    pub(super) yfov: f64,
}
