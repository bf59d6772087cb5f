//! Irradiance gathered anew at a point, from all surfaces and with all shadows (Sloan's iterate).
//!
//! ```text
//! E(x) = D(x) + ∫ κ(x, y) V(x, y) ρ(y) (D(y) + S_h(y)) dA_y ,
//! ```
//!
//! with D the direct light ([`crate::direct`]) and S_h the polynomials of what was reflected at least once, not below
//! zero. The integral smooths: shadows and dark corners that polynomials cannot hold appear in E. The reflected
//! radiosity is tabulated once per element, D with its shadows included, and summed over from each point
//! ([`crate::view`]). x may be any point, on a surface or not.

pub mod spot;

use rayon::prelude::*;

use crate::direct::DirectLight;
use crate::elements::patch::Node;
use crate::solution::{Place, Solution};
use crate::view::surroundings::{Site, Surroundings};
use crate::view::tree::Tree;
use crate::view::vantage::Vantage;
use crate::view::walk::Walk;
use crate::visibility::Visibility;

/// Error allowed a cell, relative to the irradiance and the accuracy asked: the errors of many cells add up at random.
const PER_CELL: f64 = 1.0;

/// The reflected light of a solution, ready to be gathered.
#[derive(Debug)]
pub struct Gather<'a> {
    solution: &'a Solution,
    visibility: &'a Visibility,
    direct: DirectLight<'a>,
    trees: Vec<Tree>,
    eps: f64,
}

/// What may stand between a site and the elements.
#[derive(Clone, Debug)]
pub struct Company {
    /// And emitters.
    pub direct: Surroundings,
    /// And reflecting elements.
    pub indirect: Surroundings,
}

impl<'a> Gather<'a> {
    /// The light of `solution`, to be gathered to about the relative accuracy `eps`.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Self {
        let direct = DirectLight::within(solution, visibility, eps);
        let scale = scale(solution);
        let list = solution.elements().list();
        let reflects = |i: &usize| solution.bands().iter().any(|band| band.coating.reflectance[*i] > 0.0);
        let reflecting: Vec<usize> = (0..list.len()).filter(reflects).collect();
        let tree = |element: &usize| {
            let field = |node: &Node, out: &mut [f64]| reflected(solution, &direct, *element, node, out);
            Tree::new(&list[*element], &scale, eps, &field)
        };
        let trees = reflecting.par_iter().map(tree).collect();
        Self { solution, visibility, direct, trees, eps }
    }

    /// What may stand around a site.
    pub fn around(&self, site: &Site) -> Company {
        let indirect = Surroundings::new(self.visibility, &self.trees, site);
        Company { direct: self.direct.around(site), indirect }
    }

    /// The light that is not gathered but comes straight from the emitters.
    pub fn direct(&self) -> &DirectLight<'a> {
        &self.direct
    }

    /// Irradiance (W m⁻²) per band at a point of a site.
    pub fn irradiance(&self, vantage: &Vantage, company: &Company) -> Vec<f64> {
        let direct = self.direct.irradiance(vantage, &company.direct);
        let indirect = self.indirect(vantage, &company.indirect, &direct);
        direct.iter().zip(indirect).map(|(d, s)| d + s).collect()
    }

    /// Irradiance (W m⁻²) per band at a point on its own.
    pub fn at(&self, vantage: &Vantage) -> Vec<f64> {
        self.irradiance(vantage, &self.around(&vantage.site()))
    }

    /// Irradiance (W m⁻²) per band that was reflected at least once, at a point of a site; `direct` is known to arrive there
    /// as well, and errors are judged against both.
    pub fn indirect(&self, vantage: &Vantage, surroundings: &Surroundings, direct: &[f64]) -> Vec<f64> {
        let mut walk = Walk::new(vantage, self.visibility, surroundings);
        walk.to_share(&self.trees, PER_CELL * self.eps, self.relative(direct), |walk, tolerance| {
            let mut sum = vec![0.0; self.solution.bands().len()];
            for (index, tree) in self.trees.iter().enumerate() {
                walk.add(index, tree, tolerance, &mut sum);
            }
            let level = self.relative(&sum);
            (sum, level)
        })
    }

    /// The least of the bands, in multiples of its scale.
    fn relative(&self, irradiance: &[f64]) -> f64 {
        let Some(tree) = self.trees.first() else { return 0.0 };
        irradiance.iter().zip(tree.scale()).map(|(e, scale)| e / scale).fold(f64::INFINITY, f64::min)
    }
}

/// Mean radiosity of each band over the scene, reflected and emitted; 1 where nothing shines.
fn scale(solution: &Solution) -> Vec<f64> {
    let list = solution.elements().list();
    let area: f64 = list.iter().map(|element| element.area).sum();
    let mean = |band: &crate::solution::Band| {
        let constants = list.iter().flat_map(|element| &element.constant);
        let reflected: f64 = constants.zip(&band.coefficients.radiosity).map(|(c, b)| c * b).sum();
        if reflected > 0.0 { reflected / area } else { 1.0 }
    };
    solution.bands().iter().map(mean).collect()
}

/// ρ (D + S_h) per band at a node of an element.
fn reflected(solution: &Solution, direct: &DirectLight, element: usize, node: &Node, out: &mut [f64]) {
    let surface = solution.elements().list()[element].surface;
    let place = Place { surface, parameters: node.parameters.to_array(), position: node.position };
    let lit = direct.at(element, node.position, node.normal);
    for (index, (band, out)) in solution.bands().iter().zip(out).enumerate() {
        let indirect = solution.indirect(index, element, &place).max(0.0);
        *out = band.coating.reflectance[element] * (lit[index] + indirect);
    }
}
