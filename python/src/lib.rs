//! The Rust side of the package `radiosity` of Python.
//!
//! Python's classes (`radiosity/*.py`) hold the arguments with their documentation; what is here turns them
//! into those of the library, works without the lock of the interpreter (`work`), and hands arrays back.

mod error;
mod arguments;
mod arrays;
mod progress;
mod work;
mod transfers;
mod tree;
mod core;
mod mesh;
mod scene;
mod checked;
mod heat;
mod view_factors;
mod told;
mod grid;
mod plane;
mod picture;
mod found;
mod light;
mod solution;
mod audit;
mod solve;
mod stage;

use pyo3::prelude::*;

/// The Rust part of the package `radiosity`: its classes and functions.
#[pymodule]
mod _radiosity {
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "the name that Python expects")]
    const __version__: &str = env!("CARGO_PKG_VERSION");

    #[pymodule_export]
    use super::audit::{Audit, audit_of};
    #[pymodule_export]
    use super::core::_core;
    #[pymodule_export]
    use super::error::{Error, RadiosityWarning};
    #[pymodule_export]
    use super::grid::Grid;
    #[pymodule_export]
    use super::heat::{Heat, heat_of, heats_of};
    #[pymodule_export]
    use super::light::Light;
    #[pymodule_export]
    use super::mesh::mesh_polygons;
    #[pymodule_export]
    use super::plane::Plane;
    #[pymodule_export]
    use super::scene::{Scene, builtins, load, made, parse};
    #[pymodule_export]
    use super::solution::{Solution, load_solution};
    #[pymodule_export]
    use super::solve::solution_of;
    #[pymodule_export]
    use super::stage::Stage;
    #[pymodule_export]
    use super::tree::Faces;
    #[pymodule_export]
    use super::view_factors::{ViewFactors, view_factors_of_polygons, view_factors_of_scene};
}
