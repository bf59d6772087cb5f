//! Readers of meshes: OBJ, STL, PLY, glTF; the merging of their faces; OBJ written.

mod shapes;
mod merge;
mod stl;
mod ply;
mod obj;
mod gltf;
mod written;
mod mutations;
mod speed;
