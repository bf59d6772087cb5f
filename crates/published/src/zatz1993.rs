//! The method of H. R. Zatz, *Galerkin radiosity: a higher order solution method for global illumination*
//! (SIGGRAPH 93), reproduced for comparison: its quadrature and its shadow masks.
//!
//! In order: [`transfers`] (blocks by its rules), `mask` (a function with values from 0 to 1 on an element),
//! `solid_angle` (unshadowed light on curved receivers), [`masked_light`] (light through masks, at points),
//! [`masking`] (cells and averages), [`mask_setting`] (the data that masks are made from), `mask_samples`
//! (their values at nodes) and [`masked_pairs`] (the pairs of a scene that are masked).

pub mod transfers;
mod mask;
mod solid_angle;
pub mod masked_light;
pub mod masking;
pub mod mask_setting;
mod mask_samples;
pub mod masked_pairs;
