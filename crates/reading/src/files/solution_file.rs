//! The solution as a JSON file that explains itself and can be read back.
//!
//! The file holds the text of the scene, how it was cut into elements, and per element and band the
//! polynomial of irradiance twice: in Legendre products, which anyone can evaluate, and in the orthonormal
//! basis of the element, from which [`read`] restores the same solution bit by bit. Numbers have as many
//! digits as they need.

mod figures;
mod error;
mod element;
mod groups;
mod tree;
mod reading;

pub use error::{Mismatch, SolutionError, SolutionFault};
pub use reading::{is_solution, read};
pub use tree::SolutionFile;
