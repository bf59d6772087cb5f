//! The method of H. R. Zatz, *Galerkin radiosity: a higher order solution method for global illumination*
//! (SIGGRAPH 93), reproduced for comparison: its quadrature and its shadow masks.

pub mod transfers;
mod mask;
mod solid_angle;
pub mod masked_light;
pub mod masking;
pub mod mask_setting;
mod mask_samples;
pub mod masked_pairs;
