//! The brightness of a scene, by which errors are judged.

use radiosity_light::reflected;

use crate::solution::{Band, Solution};

/// Mean radiosity (W m⁻²) of each band over the scene; 1 where nothing shines.
pub(super) fn mean_radiosity(solution: &Solution) -> Vec<f64> {
    let mean = |band: &Band| {
        reflected::scale(solution.elements().list(), band.coefficients.radiosity.iter().copied())
    };
    solution.bands().iter().map(mean).collect()
}
