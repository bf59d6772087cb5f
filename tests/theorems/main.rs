//! What must hold whatever the numbers, of scenes, whole solutions and the sources themselves.

mod animation;
mod animation_by_series;
mod animation_series;
mod bases;
mod bounces;
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
mod motions;
mod scene_format;
mod schema;
mod shapes;
mod triangles;
mod variables;
mod whole;
