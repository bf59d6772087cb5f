//! Row sums Σ_j F_ij of view factors: whether a scene is closed, and whether a surface sends more than it
//! has.

use radiosity_scene::Scene;
use radiosity_solve::view_factors::{Options, ViewFactors};
use radiosity_visibility::Shadows;
use radiosity_visibility::inspection::Regions;
use radiosity_work::wording::{command, option, set, words};

use crate::warning::Warning;
use radiosity_work::digits::decimals;

/// Error of row sums from which they tell nothing of a scene. Chosen.
const VAGUE: f64 = 0.1;

/// Errors of a factor by which row sums may miss 1 in a closed scene. Chosen.
const FROM_ONE: f64 = 3.0;

/// The row sums of the view factors of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct RowSums {
    /// Number of surfaces.
    pub surfaces: usize,
    /// The least one.
    pub least: RowSum,
    /// The largest one.
    pub most: RowSum,
    /// Surfaces that lose part of what leaves them.
    pub losing: usize,
    /// Distance from 1 up to which sums count as 1.
    pub tolerance: f64,
    /// Whether the surfaces are known to bound closed regions with their fronts ([`Regions`]).
    pub are_of_closed_regions: bool,
    /// Whether surfaces see each other through others.
    pub is_shadowless: bool,
}

/// The row sum of one surface.
#[derive(Clone, Debug, PartialEq)]
pub struct RowSum {
    /// Name of the surface.
    pub surface: String,
    /// Σ_j F_ij.
    pub sum: f64,
}

impl RowSums {
    /// The row sums of the `factors` of `scene` that were found with these options.
    pub fn of(scene: &Scene, factors: &ViewFactors, options: &Options) -> Self {
        let accuracy = options.accuracy;
        let is_closed =
            |regions: Regions| (0..scene.surfaces.len()).all(|surface| regions.is_closed(surface));
        let sums = factors.row_sums();
        let by_sum = |a: &usize, b: &usize| sums[*a].total_cmp(&sums[*b]);
        let row = |surface: usize| RowSum { surface: factors.names[surface].clone(), sum: sums[surface] };
        let shadows = if factors.rays > 0 { accuracy.shadow_eps } else { 0.0 };
        let tolerance = FROM_ONE * accuracy.eps.max(shadows).max(factors.left_in_blocks);
        Self {
            surfaces: sums.len(),
            least: row((0..sums.len()).min_by(by_sum).expect("a scene has surfaces")),
            most: row((0..sums.len()).max_by(by_sum).expect("a scene has surfaces")),
            losing: sums.iter().filter(|sum| **sum < 1.0 - tolerance).count(),
            tolerance,
            are_of_closed_regions: Regions::of(scene).is_some_and(is_closed),
            is_shadowless: options.shadows == Shadows::Off,
        }
    }

    /// Whether all that leaves a surface reaches another; None where the sums are known too badly to tell, or the
    /// surfaces are not known to be closed while nothing is seen to be lost.
    pub fn is_closed(&self) -> Option<bool> {
        match self.losing {
            _ if self.tolerance > VAGUE => None,
            0 => self.are_of_closed_regions.then_some(true),
            _ => Some(false),
        }
    }

    /// The sums in words, and what they say of the scene.
    pub fn lines(&self) -> [String; 2] {
        let [least, most] = [&self.least, &self.most]
            .map(|row| format!("{} (surface '{}')", decimals(row.sum, 9), row.surface));
        let range = format!("row sums {least} to {most}");
        let closed = match self.is_closed() {
            None if self.tolerance > VAGUE => {
                "row sums are known too badly to tell whether the scene is closed".to_owned()
            }
            None => format!("no surface loses more than {:.1e} of what leaves it", self.tolerance),
            Some(true) => "the scene is closed: all that leaves a surface reaches another".to_owned(),
            Some(false) => format!(
                "the scene is open: {} of {} surfaces lose part of what leaves them",
                self.losing, self.surfaces
            ),
        };
        [range, closed]
    }

    /// A warning where a surface sends more than it has.
    pub fn warning(&self) -> Option<Warning> {
        let RowSum { surface, sum } = &self.most;
        let message = || {
            let cure = match self.is_shadowless {
                true => {
                    words("lower ")
                        + option("eps")
                        + "; where surfaces stand between others, leave "
                        + set("shadows", "off")
                        + " out, which lets light through them"
                }
                false => {
                    words("lower ")
                        + option("eps")
                        + " or "
                        + option("shadow-eps")
                        + ", or look for surfaces that pass through each other with "
                        + command("check")
                }
            };
            words(format!("surface '{surface}' sends {:.2} % more than it has: ", 100.0 * (sum - 1.0))) + cure
        };
        let warning = || Warning {
            surface: Some(surface.clone()),
            size: Some(*sum),
            ..Warning::general("row-sum", message())
        };
        (*sum > 1.0 + self.tolerance).then(warning)
    }
}
