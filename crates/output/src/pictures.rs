//! Pictures in pixels: cameras, samples, frames, light maps, and their files.

pub mod pinhole;
pub mod sights;
mod samples;
pub mod raster;
pub mod tone;
pub(crate) mod dither;
pub mod image;
pub(crate) mod frame_light;
pub mod render;
pub mod lightmap;
pub mod tessellation;
pub mod wireframe;
