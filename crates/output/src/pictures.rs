//! Pictures in pixels: tones and colours, wireframes, and triangles for programs that draw them.

pub mod tone;
pub(crate) mod dither;
pub mod image;
pub mod tessellation;
pub mod wireframe;
