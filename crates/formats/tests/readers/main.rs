//! Files of other programs: read, repaired, written.

mod measures;
mod memory;
mod promises;
mod left_out;

mod descriptions;
mod meshes;
mod mgf_and_radiance;
mod pictures;
mod repair;
