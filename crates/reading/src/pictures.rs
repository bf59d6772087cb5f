//! Light of pixels and texels: cameras, samples, rasters, the light of frames, light maps.

pub mod pinhole;
pub mod seen_surfaces;
pub mod pixel_samples;
pub mod raster;
mod light_field;
mod frame_light;
pub mod render;
pub mod lightmap;
pub mod printed_pixels;
