//! The solution as a file that explains itself: polynomials of irradiance per element and band, JSON.

use std::ops::Range;

use serde::Serialize;

use crate::elements::Element;
use crate::elements::basis::Frame;
use crate::elements::space::Space;
use crate::scene::Scene;
use crate::solution::{Band, Solution};

/// How to read the numbers, for whoever opens the file.
const EVALUATION: &str = "On an element of order N, at coordinates (a, b) in [-1, 1]^2, irradiance = sum over k of \
     irradiance[band][k] p_i(a) p_j(b), with p_n(x) = sqrt(n + 1/2) P_n(x) (Legendre) and k running over total degree \
     d = 0..N ascending, within d over j = 0..d with i = d - j (basis total-degree-legendre), or k = i (N + 1) + j with \
     i, j = 0..N (basis tensor-legendre). On a plane frame a = (x - origin).first and \
     b = (x - origin).second for a point x; on a parameter frame a = (u - center_u)/half_u, b = (v - center_v)/half_v. \
     radiosity = exitance[band] + reflectance[band] * irradiance. Unit: that of the scene's exitance (W/m^2).";

/// The file's tree.
#[derive(Debug, Serialize)]
pub struct SolutionFile<'a> {
    format: &'static str,
    format_version: u32,
    scene: &'a str,
    bands: &'a [String],
    evaluation: &'static str,
    elements: Vec<SavedElement<'a>>,
}

#[derive(Debug, Serialize)]
struct SavedElement<'a> {
    surface: &'a str,
    /// Parameter rectangle [[u0, u1], [v0, v1]].
    rectangle: [[f64; 2]; 2],
    order: usize,
    basis: &'static str,
    frame: SavedFrame,
    area: f64,
    reflectance: Vec<f64>,
    exitance: Vec<f64>,
    /// Per band.
    irradiance: Vec<Vec<f64>>,
}

#[derive(Debug, Serialize)]
#[serde(rename_all = "lowercase")]
enum SavedFrame {
    Plane { origin: [f64; 3], first: [f64; 3], second: [f64; 3] },
    Parameters { center: [f64; 2], half: [f64; 2] },
}

impl<'a> SolutionFile<'a> {
    /// The file of a scene's solution.
    pub fn new(scene: &'a Scene, solution: &'a Solution) -> Self {
        let mut start = 0;
        let saved = |(index, element): (usize, &Element)| {
            let range = start..start + element.basis.len();
            start = range.end;
            saved(scene, solution, index, element, &range)
        };
        Self {
            format: "radiosity-solution",
            format_version: 1,
            scene: &scene.name,
            bands: &scene.bands,
            evaluation: EVALUATION,
            elements: solution.elements().list().iter().enumerate().map(saved).collect(),
        }
    }
}

fn saved<'a>(
    scene: &'a Scene,
    solution: &'a Solution,
    index: usize,
    element: &Element,
    range: &Range<usize>,
) -> SavedElement<'a> {
    let bands = solution.bands();
    let irradiance = |band: &Band| element.basis.to_products(&band.coefficients.irradiance[range.clone()]);
    SavedElement {
        surface: &scene.surfaces[element.surface].name,
        rectangle: [element.rect.u, element.rect.v],
        order: element.basis.order(),
        basis: match element.basis.space() {
            Space::Total => "total-degree-legendre",
            Space::Tensor => "tensor-legendre",
        },
        frame: frame(element.basis.frame()),
        area: element.area,
        reflectance: bands.iter().map(|band| band.coating.reflectance[index]).collect(),
        exitance: bands.iter().map(|band| band.coating.exitance[index]).collect(),
        irradiance: bands.iter().map(irradiance).collect(),
    }
}

fn frame(frame: &Frame) -> SavedFrame {
    match frame {
        Frame::Plane { origin, first, second } => SavedFrame::Plane {
            origin: origin.to_array(),
            first: first.to_array(),
            second: second.to_array(),
        },
        Frame::Parameters { center, half } => {
            SavedFrame::Parameters { center: center.to_array(), half: half.to_array() }
        }
    }
}
