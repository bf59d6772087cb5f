//! Files for other programs: arrays, solutions, meshes and models.

pub mod exr_file;
pub(crate) mod npy;
pub(crate) mod npz;
pub mod view_factors;
pub mod glb;
