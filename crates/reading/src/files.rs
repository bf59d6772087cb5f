//! Solutions in files: all of them, to be read again, and the light of curved cells for VTK.

pub mod solution_file;
pub mod vtu;
