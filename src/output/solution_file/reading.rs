//! From the file back to the solved scene.
//!
//! The scene is read and cut again, and every element of the file is compared with it, so that a damaged or changed
//! file is refused. The coefficients are taken as they are.

use serde::Deserialize;

use super::element::SavedElement;
use super::error::{Mismatch, SolutionError, SolutionFault};
use super::tree::{SavedScene, SolutionFile};
use super::version::{FORMAT, VERSION};
use crate::elements::coating::Coating;
use crate::elements::{Discretization, Elements, Subdivide};
use crate::scene::{MAX_PARTS, Scene, Source};
use crate::solution::{Band, Solution};
use crate::solve::{Options, masked_light};
use crate::solved::Solved;
use crate::system::Coefficients;
use crate::visibility::Visibility;

/// The keys that identify a solution file of any version.
#[derive(Deserialize)]
struct Header {
    #[serde(default)]
    format: serde_json::Value,
    #[serde(default)]
    format_version: u32,
}

/// Whether a text is meant as a solution file rather than a scene.
pub fn is_solution(text: &str) -> bool {
    let quoted = format!("\"{FORMAT}\"");
    let likely = text.trim_start().starts_with('{') && text.contains(&quoted);
    // Text that contains the word but is not valid JSON is reported as a damaged solution.
    likely && serde_json::from_str(text).map_or(true, |header: Header| header.format == FORMAT)
}

/// Reads a solution file: the scene, the options and the solution that it was written from, bit by bit.
///
/// # Errors
/// A text that is damaged, of another version, or does not fit the scene in it.
pub fn read(source: &Source) -> Result<Solved, SolutionError> {
    parse(&source.text)
        .and_then(SolutionFile::solved)
        .map_err(|fault| SolutionError { origin: source.origin.to_string(), fault })
}

fn parse(text: &str) -> Result<SolutionFile, SolutionFault> {
    let header: Header = serde_json::from_str(text).map_err(|error| syntax(&error))?;
    if header.format_version != VERSION {
        return Err(SolutionFault::Version { found: header.format_version });
    }
    serde_json::from_str(text).map_err(|error| syntax(&error))
}

/// The parser's message without the place at its end.
fn syntax(error: &serde_json::Error) -> SolutionFault {
    let (line, column) = (error.line(), error.column());
    let message = error.to_string();
    let place = format!(" at line {line} column {column}");
    SolutionFault::Syntax { line, column, message: message.trim_end_matches(&place).to_owned() }
}

impl SolutionFile {
    fn solved(self) -> Result<Solved, SolutionFault> {
        let scene = self.scene.read()?;
        if self.bands != scene.bands || self.figures.residuals.len() != scene.bands.len() {
            return Err(SolutionFault::Whole(Mismatch("the list of bands")));
        }
        let elements = self.options.elements(&scene, checked(&self.discretization)?)?;
        check_elements(&self.elements, &scene, &elements)?;
        let bands: Vec<Band> = (0..scene.bands.len())
            .map(|index| band(&scene, &elements, &self.elements, index, self.figures.residuals[index]))
            .collect();
        let solution = with_masks(Solution::new(elements, bands), &scene, &self.options);
        let achieved = self.figures.achieved;
        let outcome = self.figures.outcome(solution);
        let outcome = outcome.ok_or(SolutionFault::Whole(Mismatch("the solver's name")))?;
        Ok(Solved::of(scene, self.options, outcome, achieved))
    }
}

/// The solution with its masks, if it has any, made again from the scene and the options.
fn with_masks(solution: Solution, scene: &Scene, options: &Options) -> Solution {
    if options.masks.is_none() {
        return solution;
    }
    let visibility = Visibility::new(scene, options.into());
    let masked = masked_light(scene, solution.elements(), &solution.coatings(), &visibility, options);
    solution.with_masks(masked)
}

impl SavedScene {
    fn read(&self) -> Result<Scene, SolutionFault> {
        let text = self.text.as_ref().ok_or(SolutionFault::NoScene)?;
        let scene = Scene::parse(&Source::new(&self.origin, text).within(self.tolerance))
            .map_err(|error| SolutionFault::Scene(Box::new(error)))?;
        if scene.name == self.name {
            Ok(scene)
        } else {
            Err(SolutionFault::Whole(Mismatch("the scene's name")))
        }
    }
}

fn checked(how: &Discretization) -> Result<&Discretization, SolutionFault> {
    match how.subdivide {
        Subdivide::Uniform(parts) if !(1..=MAX_PARTS).contains(&parts) => {
            Err(SolutionFault::Whole(Mismatch("the subdivision")))
        }
        _ => Ok(how),
    }
}

fn check_elements(saved: &[SavedElement], scene: &Scene, elements: &Elements) -> Result<(), SolutionFault> {
    if saved.len() != elements.list().len() {
        return Err(SolutionFault::Whole(Mismatch("the number of elements")));
    }
    for (index, (saved, element)) in saved.iter().zip(elements.list()).enumerate() {
        saved.check(scene, element).map_err(|what| SolutionFault::Element { index, what })?;
    }
    Ok(())
}

fn band(scene: &Scene, elements: &Elements, saved: &[SavedElement], index: usize, residual: f64) -> Band {
    let list = elements.list();
    let coating = Coating::of(scene, list, index);
    let together = |own: fn(&SavedElement) -> &[Vec<f64>]| -> Vec<f64> {
        saved.iter().flat_map(|element| own(element)[index].iter().copied()).collect()
    };
    let coefficients = Coefficients::of_irradiance(
        list,
        &coating,
        together(|element| &element.orthonormal.irradiance),
        together(|element| &element.orthonormal.direct),
        residual,
    );
    Band::new(scene.bands[index].clone(), elements, coating, coefficients)
}
