//! Pictures in pixels: tones and colours, views of textures, wireframes, triangles for programs that draw
//! them, and marks at points.

pub mod tone;
pub(crate) mod dither;
pub mod image;
pub mod lightmap_view;
pub mod tessellation;
pub mod wireframe;
pub mod marks;
