//! What must hold whatever the numbers, of scenes, whole solutions and the sources themselves.

mod animation;
mod animation_by_series;
mod animation_series;
mod boxes;
mod builder;
mod convergence;
mod documents;
mod flux;
mod fuzz;
mod heat;
mod hierarchy;
mod includes;
mod instances;
mod layering;
mod materials;
mod motions;
mod picture_files;
mod scene_format;
mod schema;
mod shapes;
mod textures;
mod triangles;
mod two_sides;
mod variables;
mod whole;
