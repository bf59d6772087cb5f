//! Solution files with which others are compared.

use std::path::Path;

use radiosity_geom::ROUNDING_OF_AREAS;
use radiosity_language::input;
use radiosity_reading::files::solution_file::{is_solution, read};
use radiosity_scene::{Scene, Source};
use radiosity_solve::solved::Solved;
use radiosity_work::ranks::Ranks;

use crate::error::CliError;

/// Reads the solution file at `path` with these ranks, which has to have the surfaces and bands of `scene`.
pub(crate) fn solution(path: &Path, scene: &Scene, ranks: &Ranks) -> Result<Solved, CliError> {
    let cure = "give a file that `radiosity solve` wrote for this scene";
    let refused = |reason: &str| CliError::refused(format!("{}: {reason}", path.display()), cure);
    let text = input::text(&path.to_string_lossy(), ranks);
    let text = text.map_err(|error| refused(&error.to_string()))?;
    if !is_solution(&text) {
        return Err(refused("it is no solution file"));
    }
    let solved = read(&Source::new(&path.to_string_lossy(), &text))?;
    if solved.scene.bands != scene.bands {
        return Err(refused("it has other bands than the scene"));
    }
    if !same_surfaces(&solved.scene, scene) {
        return Err(refused("it has other surfaces than the scene"));
    }
    Ok(solved)
}

/// Whether materials, and the factors of light groups, are the same surface by surface.
pub(crate) fn same_materials(a: &Scene, b: &Scene) -> bool {
    let mut pairs = a.surfaces.iter().zip(&b.surfaces);
    pairs.all(|(a, b)| a.material == b.material && a.factor() == b.factor())
}

/// Whether names and areas are the same.
fn same_surfaces(a: &Scene, b: &Scene) -> bool {
    let same = |[a, b]: [f64; 2]| (a - b).abs() <= ROUNDING_OF_AREAS * a;
    a.surfaces.len() == b.surfaces.len()
        && a.surfaces
            .iter()
            .zip(&b.surfaces)
            .all(|(a, b)| a.name == b.name && same([a.shape.area(), b.shape.area()]))
}
