//! The binary part of a GLB: numbers of vertices by kind, indices, an image.
//!
//! A GLB is a header, the JSON, padded with blanks, and the binary, padded with zeros, each to a multiple of
//! four bytes.

use std::io::{self, Write};

use serde_json::{Value, json};

/// A quantity at each vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Component {
    Position,
    Normal,
    /// Place in the texture, in [0, 1]².
    Place,
}

/// glTF's codes of component types, and of the targets of buffer views.
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// Views of the binary, in this order, beside that of the image, which comes last.
const VIEWS: usize = 4;
const INDEX_VIEW: usize = 3;

/// Accessors and the bytes that they speak of.
#[derive(Debug, Default)]
pub(super) struct Binary {
    /// Positions, normals, places in the texture, indices.
    parts: [Vec<u8>; VIEWS],
    image: Vec<u8>,
    accessors: Vec<Value>,
}

impl Binary {
    /// Adds vectors of `N` numbers; the index of their accessor.
    pub(super) fn vectors<const N: usize>(&mut self, component: Component, vectors: &[[f32; N]]) -> usize {
        let view = component as usize;
        let mut accessor = json!({
            "bufferView": view,
            "byteOffset": self.parts[view].len(),
            "componentType": FLOAT,
            "count": vectors.len(),
            "type": format!("VEC{N}"),
        });
        if component == Component::Position {
            let ends = |pick: fn(f32, f32) -> f32| -> Vec<f64> {
                let along = |k: usize| vectors.iter().map(|vector| vector[k]).reduce(pick).unwrap_or(0.0);
                (0..N).map(|k| f64::from(along(k))).collect()
            };
            (accessor["min"], accessor["max"]) = (ends(f32::min).into(), ends(f32::max).into());
        }
        self.parts[view].extend(vectors.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Adds indices of vertices; the index of their accessor.
    pub(super) fn indices(&mut self, indices: &[u32]) -> usize {
        self.accessors.push(json!({
            "bufferView": INDEX_VIEW,
            "byteOffset": self.parts[INDEX_VIEW].len(),
            "componentType": UNSIGNED_INT,
            "count": indices.len(),
            "type": "SCALAR",
        }));
        self.parts[INDEX_VIEW].extend(indices.iter().flat_map(|index| index.to_le_bytes()));
        self.accessors.len() - 1
    }

    /// Takes the image; the index of its view.
    pub(super) fn image(&mut self, bytes: &[u8]) -> usize {
        self.image = bytes.to_vec();
        VIEWS
    }

    /// Writes the file of `tree`, to which accessors, views and the buffer are added.
    pub(super) fn write(self, mut tree: Value, mut out: impl Write) -> io::Result<()> {
        let mut views = Vec::new();
        let mut bytes: Vec<u8> = Vec::new();
        for (view, part) in self.parts.iter().enumerate() {
            let mut own = json!({"buffer": 0, "byteOffset": bytes.len(), "byteLength": part.len()});
            own["target"] = if view == INDEX_VIEW { INDICES } else { VERTICES }.into();
            match view {
                0 | 1 => own["byteStride"] = 12.into(),
                2 => own["byteStride"] = 8.into(),
                _ => {}
            }
            views.push(own);
            bytes.extend(part);
        }
        views.push(json!({"buffer": 0, "byteOffset": bytes.len(), "byteLength": self.image.len()}));
        bytes.extend(self.image);
        tree["accessors"] = self.accessors.into();
        tree["bufferViews"] = views.into();
        tree["buffers"] = json!([{"byteLength": bytes.len()}]);
        let mut text = serde_json::to_vec(&tree)?;
        text.resize(text.len().next_multiple_of(4), b' ');
        bytes.resize(bytes.len().next_multiple_of(4), 0);
        let length = |bytes: usize| u32::try_from(bytes).map_err(|_| io::Error::other("it is above 4 GB"));
        out.write_all(b"glTF")?;
        out.write_all(&2u32.to_le_bytes())?;
        out.write_all(&length(12 + 8 + text.len() + 8 + bytes.len())?.to_le_bytes())?;
        for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &bytes)] {
            out.write_all(&length(chunk.len())?.to_le_bytes())?;
            out.write_all(kind)?;
            out.write_all(chunk)?;
        }
        Ok(())
    }
}
