//! Reading of a solution file: from its text back to the solved scene.
//!
//! The scene is read and cut again, and every element of the file is compared with it, so that a damaged or
//! changed file is refused. The coefficients are taken as they are.

use std::collections::HashSet;
use std::sync::Arc;

use base64::{Engine, prelude::BASE64_STANDARD as STANDARD};
use radiosity_elements::{Discretization, Elements, Subdivide};
use radiosity_published::zatz1993::masked_light::MaskedLight;
use radiosity_scene::{MAX_PARTS, Scene, Source};
use radiosity_solve::solution::Solution;
use radiosity_solve::solution::group_light::{GroupLight, Incident};
use radiosity_solve::solved::Solved;
use serde::Deserialize;

use super::element::{SavedElement, same};
use super::error::{Mismatch, SolutionError, SolutionFault, VERSION};
use super::tree::{FORMAT, SavedScene, SolutionFile};

/// Largest coefficient of an element of area A, over Φ/√A, where Φ is the power that the scene emits: all of it
/// on this element alone makes 1, times the bounces between mirrors that lose nothing. Chosen.
const MOST_LIGHT: f64 = 1e12;

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
    parse(&source.text())
        .and_then(|file| file.solved())
        .map_err(|fault| SolutionError { origin: source.origin.to_string(), fault })
}

fn parse(text: &str) -> Result<SolutionFile, SolutionFault> {
    let header: Header = serde_json::from_str(text).map_err(|error| syntax(&error))?;
    if header.format_version != VERSION {
        return Err(SolutionFault::Version { found: header.format_version });
    }
    serde_json::from_str(text).map_err(|error| syntax(&error)).and_then(SolutionFile::whole)
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
        if self.mesh.as_ref().is_some_and(|mesh| !mesh.is_valid(scene.surfaces.len())) {
            return Err(SolutionFault::Whole(Mismatch("the mesh")));
        }
        let how = checked(&self.discretization)?;
        let elements = match &self.mesh {
            Some(mesh) => Elements::of_mesh(&scene, how, mesh.clone()),
            None => Elements::new(&scene, how),
        }?;
        check_elements(&self.elements, &scene, &elements)?;
        if !self.groups.are_full(scene.bands.len(), elements.coefficients()) {
            return Err(SolutionFault::Whole(Mismatch("the number of coefficients of the light groups")));
        }
        self.check_sizes(&elements.starts())?;
        let groups = self.group_lights(&scene, &elements)?;
        let solution = Solution::of_groups(elements, &scene, groups);
        for (index, own) in self.elements.iter().enumerate() {
            own.check_coating(&solution, index).map_err(|what| SolutionFault::Element { index, what })?;
        }
        self.check_sums(&solution)?;
        let achieved = self.figures.achieved;
        let outcome = self.figures.outcome(solution);
        let outcome = outcome.ok_or(SolutionFault::Whole(Mismatch("the solver's name")))?;
        Ok(Solved::of(scene, self.options, outcome, achieved))
    }
}

impl SolutionFile {
    /// The light of each group; all light as that of no group where there are none.
    fn group_lights(&self, scene: &Scene, elements: &Elements) -> Result<Vec<GroupLight>, SolutionFault> {
        let mismatch = || SolutionFault::Whole(Mismatch("the list of light groups"));
        let groups = self.groups.list();
        let names: HashSet<&str> = groups.iter().filter_map(|group| group.group.as_deref()).collect();
        if !scene.light_groups().iter().all(|group| names.contains(group.name.as_str())) {
            return Err(mismatch());
        }
        let bands = scene.bands.len();
        if self.groups.is_empty() {
            let band = |band: usize| Incident {
                irradiance: together(&self.elements, |own| &own.orthonormal.irradiance[band]),
                direct: together(&self.elements, |own| &own.orthonormal.direct[band]),
                residual: self.figures.residuals[band],
            };
            let powers = self.figures.powers();
            let bands = (0..bands).map(band).collect();
            let masked = self.masked(0, elements)?;
            return Ok(vec![GroupLight { group: None, bands, powers, masked }]);
        }
        let light = |(index, group): (usize, &GroupLight)| {
            Ok(GroupLight { masked: self.masked(index, elements)?, ..group.clone() })
        };
        groups.iter().enumerate().map(light).collect()
    }

    /// The masked light of group number `index`, or of all light, if light is masked.
    fn masked(&self, index: usize, elements: &Elements) -> Result<Option<Arc<MaskedLight>>, SolutionFault> {
        let expected = if self.options.masks.is_some() { self.groups.list().len().max(1) } else { 0 };
        if self.masked.len() > expected {
            return Err(SolutionFault::Whole(Mismatch("the light through masks")));
        }
        if expected == 0 {
            return Ok(None);
        }
        let masked = self.masked.get(index).ok_or(SolutionFault::NoMasks)?;
        match masked.is_of(elements.list(), self.bands.len()) {
            true => Ok(Some(Arc::new(masked.clone()))),
            false => Err(SolutionFault::Whole(Mismatch("the light through masks"))),
        }
    }

    /// Refuses coefficients that no light of the scene makes: reading off them would not end. Those of each
    /// element begin at its number in `starts`.
    fn check_sizes(&self, starts: &[usize]) -> Result<(), SolutionFault> {
        let emitted = self.emitted();
        let is_usual = |(own, ends): (&SavedElement, &[usize])| {
            let largest = own.largest().max(self.groups.largest(&(ends[0]..ends[1])));
            largest <= MOST_LIGHT * emitted / own.area().sqrt()
        };
        match self.elements.iter().zip(starts.windows(2)).position(|own| !is_usual(own)) {
            None => Ok(()),
            Some(index) => {
                Err(SolutionFault::Element { index, what: Mismatch("the size of the coefficients") })
            }
        }
    }

    /// Compares the light of all groups, at their factors, with the irradiance in the file.
    fn check_sums(&self, solution: &Solution) -> Result<(), SolutionFault> {
        let starts = solution.elements().starts();
        for (index, saved) in self.elements.iter().enumerate() {
            let own = starts[index]..starts[index + 1];
            let sums = solution.bands().iter().map(|band| &band.coefficients.irradiance[own.clone()]);
            if !sums.zip(&saved.orthonormal.irradiance).all(|(sum, own)| same(sum, own)) {
                let what = Mismatch("the light of its groups");
                return Err(SolutionFault::Element { index, what });
            }
        }
        Ok(())
    }
}

/// Coefficients of all elements, one after the other.
fn together<'a>(saved: &'a [SavedElement], own: impl Fn(&'a SavedElement) -> &'a [f64]) -> Vec<f64> {
    saved.iter().flat_map(|element| own(element).iter().copied()).collect()
}

impl SavedScene {
    fn read(&self) -> Result<Scene, SolutionFault> {
        let text = self.text.as_ref().ok_or(SolutionFault::NoScene)?;
        let settings = self.settings.iter().map(|(name, value)| (name.as_str(), *value));
        let source = Source::new(&self.origin, text).within(self.tolerance).set(settings);
        let source =
            self.included.iter().fold(source, |source, own| source.including(&own.origin, &own.text));
        let source = self.pictures.iter().try_fold(source, |source, own| {
            let bytes = STANDARD.decode(&own.base64);
            let bytes = bytes.map_err(|_| SolutionFault::Whole(Mismatch("a picture")))?;
            Ok::<_, SolutionFault>(source.with_picture(&own.origin, bytes))
        })?;
        let mut source = match self.moment {
            Some(moment) => source.at(moment),
            None => source,
        };
        source.record_outside(self.outside.iter().cloned());
        let scene =
            radiosity_language::read(&source).map_err(|error| SolutionFault::Scene(Box::new(error)))?;
        if scene.name != self.name {
            return Err(SolutionFault::Whole(Mismatch("the scene's name")));
        }
        let factors: Vec<(&str, f64)> =
            self.factors.iter().map(|(name, factor)| (name.as_str(), *factor)).collect();
        scene.dimmed(&factors).map_err(|error| SolutionFault::Scene(Box::new(error)))
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
