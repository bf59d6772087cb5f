//! Light of pixels and texels: cameras, samples, rasters, the light of frames, films, light maps.

pub mod pixel_grid;
pub mod pinhole;
pub mod seen_surfaces;
pub mod pixel_samples;
pub mod raster;
mod eye;
mod pixel_count;
mod picture_light;
mod neighbourhoods;
mod light_field;
mod frame_light;
mod shot;
mod oversampling;
pub mod render;
pub mod film;
pub mod lightmap;
pub mod printed_pixels;
