//! One element in the file, and its comparison with an element of the scene.

use std::ops::Range;

use radiosity_elements::Element;
use radiosity_elements::basis::Frame;
use radiosity_elements::space::Space;
use radiosity_scene::Scene;
use radiosity_solve::solution::{Band, Solution};
use serde::{Deserialize, Serialize};

use super::error::Mismatch;

/// Difference of the two forms of a polynomial, over the largest coefficient, that counts as rounding:
/// conversion to products amplifies rounding on elements that fill only a small part of their frame. With a
/// larger value a file whose forms contradict each other would be read.
const SAME: f64 = 1e-6;

/// An element with its polynomials.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct SavedElement {
    surface: String,
    /// Parameter rectangle [[u0, u1], [v0, v1]].
    rectangle: [[f64; 2]; 2],
    /// Whether the element is the part of the surface that another surface covers.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    covered: bool,
    order: usize,
    basis: Basis,
    frame: SavedFrame,
    area: f64,
    /// Reflectance per band.
    reflectance: Vec<f64>,
    /// Emitted exitance per band (W m⁻²).
    exitance: Vec<f64>,
    /// Coefficients in products of Legendre polynomials (W m⁻²), per band.
    irradiance: Vec<Vec<f64>>,
    /// Coefficients in the orthonormal basis.
    pub(super) orthonormal: Orthonormal,
}

/// Coefficients h and G e (or d) per band, in the orthonormal basis (W m⁻² times scene length).
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Orthonormal {
    pub(super) irradiance: Vec<Vec<f64>>,
    pub(super) direct: Vec<Vec<f64>>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
enum Basis {
    #[serde(rename = "total-degree-legendre")]
    Total,
    #[serde(rename = "tensor-legendre")]
    Tensor,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum SavedFrame {
    Plane { origin: [f64; 3], first: [f64; 3], second: [f64; 3] },
    Parameters { center: [f64; 2], half: [f64; 2] },
}

/// Every element of a solution.
pub(super) fn all(scene: &Scene, solution: &Solution) -> Vec<SavedElement> {
    let mut start = 0;
    let saved = |(index, element): (usize, &Element)| {
        let range = start..start + element.basis.len();
        start = range.end;
        saved(scene, solution, index, element, &range)
    };
    solution.elements().list().iter().enumerate().map(saved).collect()
}

fn saved(
    scene: &Scene,
    solution: &Solution,
    index: usize,
    element: &Element,
    range: &Range<usize>,
) -> SavedElement {
    let bands = solution.bands();
    let own = |all: &[f64]| all[range.clone()].to_vec();
    let irradiance: Vec<Vec<f64>> = bands.iter().map(|band| own(&band.coefficients.irradiance)).collect();
    let per_band = |value: fn(&Band) -> &[f64]| bands.iter().map(|band| value(band)[index]).collect();
    SavedElement {
        surface: scene.surfaces[element.surface].name.clone(),
        rectangle: [element.rect.u, element.rect.v],
        covered: !element.is_cell(),
        order: element.basis.order(),
        basis: element.basis.space().into(),
        frame: element.basis.frame().into(),
        area: element.area,
        reflectance: per_band(|band| &band.coating.reflectance),
        exitance: per_band(|band| &band.coating.exitance),
        irradiance: irradiance.iter().map(|own| element.basis.to_products(own)).collect(),
        orthonormal: Orthonormal {
            irradiance,
            direct: bands.iter().map(|band| own(&band.coefficients.direct)).collect(),
        },
    }
}

impl SavedElement {
    /// Compares this with `element` of `scene`, and checks the number of coefficients.
    pub(super) fn check(&self, scene: &Scene, element: &Element) -> Result<(), Mismatch> {
        let surface = &scene.surfaces[element.surface];
        fits(self.surface == surface.name, "the surface")?;
        fits(self.rectangle == [element.rect.u, element.rect.v], "the rectangle")?;
        fits(self.covered != element.is_cell(), "the parts that others lie on")?;
        fits(self.order == element.basis.order(), "the order")?;
        fits(self.basis == element.basis.space().into(), "the basis")?;
        fits(same(&[self.area], &[element.area]), "the area")?;
        let Orthonormal { irradiance, direct } = &self.orthonormal;
        let full = |coefficients: &[Vec<f64>]| {
            let bands = scene.bands.len();
            coefficients.len() == bands && coefficients.iter().all(|own| own.len() == element.basis.len())
        };
        fits(full(&self.irradiance) && full(irradiance) && full(direct), "the number of coefficients")?;
        let mut forms = self.irradiance.iter().zip(irradiance);
        fits(forms.all(|(products, own)| same(products, &element.basis.to_products(own))), "the irradiance")
    }

    /// Its area.
    pub(super) fn area(&self) -> f64 {
        self.area
    }

    /// Its largest coefficient, by its absolute value.
    pub(super) fn largest(&self) -> f64 {
        let Orthonormal { irradiance, direct } = &self.orthonormal;
        irradiance.iter().chain(direct).flatten().map(|own| own.abs()).fold(0.0, f64::max)
    }

    /// Compares its reflectance and its exitance with those of element `index` of the scene's solution.
    pub(super) fn check_coating(&self, solution: &Solution, index: usize) -> Result<(), Mismatch> {
        // To rounding: means of patterns are sums, whose last bits differ from one machine to another.
        let are = |own: &[f64], of: fn(&Band) -> &[f64]| {
            let known: Vec<f64> = solution.bands().iter().map(|band| of(band)[index]).collect();
            own.len() == known.len() && same(own, &known)
        };
        fits(are(&self.reflectance, |band| &band.coating.reflectance), "the reflectance")?;
        fits(are(&self.exitance, |band| &band.coating.exitance), "the exitance")
    }
}

fn fits(holds: bool, what: &'static str) -> Result<(), Mismatch> {
    if holds { Ok(()) } else { Err(Mismatch(what)) }
}

/// Whether `a` and `b` agree up to rounding.
pub(super) fn same(a: &[f64], b: &[f64]) -> bool {
    let largest = a.iter().chain(b).map(|x| x.abs()).fold(0.0, f64::max);
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= SAME * largest)
}

impl From<Space> for Basis {
    fn from(space: Space) -> Self {
        match space {
            Space::Total => Self::Total,
            Space::Tensor => Self::Tensor,
        }
    }
}

impl From<&Frame> for SavedFrame {
    fn from(frame: &Frame) -> Self {
        match frame {
            Frame::Plane { origin, first, second } => {
                Self::Plane { origin: origin.to_array(), first: first.to_array(), second: second.to_array() }
            }
            Frame::Parameters { center, half } => {
                Self::Parameters { center: center.to_array(), half: half.to_array() }
            }
        }
    }
}
