//! Irradiance gathered anew at a point, from all surfaces and with all shadows (Sloan's iterate).
//!
//! ```text
//! E(x) = D(x) + ∫ κ(x, y) V(x, y) ρ(y) (D(y) + S_h(y)) dA_y ,
//! ```
//!
//! with D the direct light ([`crate::light::direct`]) and S_h the polynomials of what was reflected at least once, not below
//! zero. The integral (`light::reflected`) smooths: shadows and dark corners that polynomials cannot hold appear in E.
//! x may be any point, on a surface or not. What polynomials smear at the foot of an obstacle is still seen in E near by;
//! gathered twice, with S_h replaced by what is itself gathered from it at the points y, that is gone as well.

pub mod spot;

use crate::elements::patch::Node;
use crate::light::direct::DirectLight;
use crate::light::occluders::{Occluders, Site};
use crate::light::receiver_point::ReceiverPoint;
use crate::light::reflected;
use crate::light::reflected::Reflection;
use crate::solution::{Band, Place, Solution};
use crate::visibility::Visibility;

/// Accuracy of what is gathered first, in multiples of that of what is gathered from it: the second integral smooths.
const BEFORE: f64 = 5.0;

/// The reflected light of a solution, ready to be gathered.
#[derive(Debug)]
pub struct Gather<'a> {
    direct: DirectLight<'a>,
    reflection: Reflection<'a>,
}

/// What may stand between a site and the elements.
#[derive(Clone, Debug)]
pub struct Company {
    /// And emitters.
    pub direct: Occluders,
    /// And reflecting elements.
    pub indirect: Occluders,
}

impl<'a> Gather<'a> {
    /// The light of `solution`, to be gathered to about the relative accuracy `eps`.
    pub fn new(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Self {
        let (list, coatings) = (solution.elements().list(), solution.coatings());
        let direct = DirectLight::within(list, &coatings, visibility, eps);
        let lit = |element: usize, node: &Node| {
            let mut lit = direct.at(element, node.position, node.normal);
            add_indirect(solution, element, node, &mut lit);
            lit
        };
        let scale = scales(solution);
        let reflection = Reflection::new(list, &coatings, visibility, &lit, scale, eps);
        Self { direct, reflection }
    }

    /// The same gathered twice: the light that surfaces send is itself gathered.
    pub fn twice(solution: &'a Solution, visibility: &'a Visibility, eps: f64) -> Self {
        let Self { direct, reflection } = Self::new(solution, visibility, BEFORE * eps);
        let (list, coatings) = (solution.elements().list(), solution.coatings());
        let around: Vec<Occluders> =
            list.iter().map(|element| reflection.around(&Site::of(element))).collect();
        let lit = |element: usize, node: &Node| {
            let vantage = ReceiverPoint::on(list[element].surface, node.position, node.normal);
            let lit = direct.at(element, node.position, node.normal);
            let indirect = reflection.irradiance(&vantage, &around[element], &lit);
            lit.iter().zip(indirect).map(|(d, s)| d + s).collect()
        };
        let scale = scales(solution);
        let reflection = Reflection::new(list, &coatings, visibility, &lit, scale, eps);
        Self { direct, reflection }
    }

    /// What may stand around a site.
    pub fn around(&self, site: &Site) -> Company {
        Company { direct: self.direct.around(site), indirect: self.reflection.around(site) }
    }

    /// The light that comes straight from the emitters.
    pub fn direct(&self) -> &DirectLight<'a> {
        &self.direct
    }

    /// The light that was reflected at least once.
    pub fn reflection(&self) -> &Reflection<'a> {
        &self.reflection
    }

    /// Irradiance (W m⁻²) per band at a point of a site.
    pub fn irradiance(&self, vantage: &ReceiverPoint, company: &Company) -> Vec<f64> {
        let direct = self.direct.irradiance(vantage, &company.direct);
        let indirect = self.reflection.irradiance(vantage, &company.indirect, &direct);
        direct.iter().zip(indirect).map(|(d, s)| d + s).collect()
    }

    /// Irradiance (W m⁻²) per band at a point on its own.
    pub fn at(&self, vantage: &ReceiverPoint) -> Vec<f64> {
        self.irradiance(vantage, &self.around(&vantage.site()))
    }
}

/// Mean radiosity of each band over the scene, reflected and emitted.
fn scales(solution: &Solution) -> Vec<f64> {
    let mean = |band: &Band| {
        reflected::scale(solution.elements().list(), band.coefficients.radiosity.iter().copied())
    };
    solution.bands().iter().map(mean).collect()
}

/// Adds S_h per band at a node of an element, where it is not below zero.
fn add_indirect(solution: &Solution, element: usize, node: &Node, sums: &mut [f64]) {
    let surface = solution.elements().list()[element].surface;
    let place = Place { surface, parameters: node.parameters.to_array(), position: node.position };
    let mut indirect = vec![0.0; sums.len()];
    solution.indirect_bands(element, &place, &mut indirect);
    sums.iter_mut().zip(indirect).for_each(|(sum, indirect)| *sum += indirect.max(0.0));
}
