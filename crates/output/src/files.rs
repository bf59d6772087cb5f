//! Files for other programs: arrays, solutions, meshes and models.

pub mod exr_file;
pub mod solution_file;
pub mod npy;
pub mod npz;
pub mod view_factors;
pub mod vtu;
pub mod glb;
