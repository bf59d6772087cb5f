//! Light of pixels and texels: cameras, samples, rasters, the light of frames, light maps.

pub mod pinhole;
pub mod sights;
pub mod samples;
pub mod raster;
mod frame_light;
pub mod render;
pub mod lightmap;
