//! The Rust side of the package `radiosity` of Python.

use pyo3::prelude::*;

/// What `radiosity` is made of.
#[pymodule]
mod _radiosity {
    #[pymodule_export]
    #[allow(non_upper_case_globals, reason = "the name that Python expects")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}
