//! The first bounce: what arrives straight from the emitters, and what of it arrives reflected once, with all shadows.
//!
//! ```text
//! D(x) = ∫ κ V E₀ dA_y ,     g(x) = ∫ κ V ρ D dA_y
//! d_k = ∫ φ_k D dA ,         g_k = ∫ φ_k g dA
//! ```
//!
//! Where direct light is split off, g feeds the polynomials in place of G ρ d: the shadow edges of D, which no polynomial
//! holds, then are smoothed by one transport before anything is projected. D itself is never transported by
//! polynomials; d serves those who read polynomials alone.
//!
//! The integrals over x are Gauss rules on m × m cells of each patch: many cells for D with its edges, few for the smooth g,
//! where the points are exact for φ_k times what varies linearly.

use rayon::prelude::*;

use crate::elements::Element;
use crate::elements::coating::Coating;
use crate::elements::patch::{Direction, Node, Patch};
use crate::elements::rule::UnitRule;
use crate::light::direct::DirectLight;
use crate::light::occluders::Site;
use crate::light::receiver_point::ReceiverPoint;
use crate::light::reflected;
use crate::light::reflected::{Lit, Reflection};
use crate::visibility::Visibility;

/// Halvings of a patch in each direction for D and for g; a patch that is a small part of its element takes fewer for g.
const DIRECT_HALVINGS: usize = 2;
const REFLECTED_HALVINGS: usize = 1;

/// Part of its element below which a patch counts as small.
const SMALL: f64 = 0.25;

/// Relative accuracy of g at a point where none finer is asked for: what it feeds are means over many points.
pub(crate) const LOOSEST: f64 = 2e-2;

/// Coefficients in the orthonormal bases, element by element, per band.
#[derive(Debug)]
pub struct Bounce {
    /// d of the direct irradiance (W m⁻²).
    pub direct: Vec<Vec<f64>>,
    /// g of the irradiance (W m⁻²) that was reflected once.
    pub reflected: Vec<Vec<f64>>,
}

impl Bounce {
    /// That of exact direct light on elements with their coatings, one a band, good to about the relative accuracy `eps` and
    /// to [`LOOSEST`].
    pub fn new(elements: &[Element], coatings: &[&Coating], visibility: &Visibility, eps: f64) -> Self {
        let eps = eps.min(LOOSEST);
        let direct = DirectLight::within(elements, coatings, visibility, eps);
        let lit = |element: usize, node: &Node| direct.at(element, node.position, node.normal);
        Self::of(elements, coatings, visibility, &lit, eps)
    }

    /// That of any direct light `lit`.
    pub fn of(
        elements: &[Element],
        coatings: &[&Coating],
        visibility: &Visibility,
        lit: Lit<'_>,
        eps: f64,
    ) -> Self {
        let projected = |project: &(dyn Fn(usize) -> Vec<Vec<f64>> + Sync)| -> Vec<Vec<f64>> {
            let parts: Vec<_> = (0..elements.len()).into_par_iter().with_max_len(1).map(project).collect();
            let bands = 0..coatings.len();
            bands.map(|band| parts.iter().flat_map(|part| &part[band]).copied().collect()).collect()
        };
        let d = projected(&|index| of_direct(&elements[index], index, lit, coatings.len()));
        let scale = scales(elements, coatings, &d);
        let reflection = Reflection::new(elements, coatings, visibility, lit, scale, eps);
        let g = projected(&|index| of_reflected(&elements[index], index, lit, &reflection, coatings.len()));
        Self { direct: d, reflected: g }
    }
}

/// Mean reflected radiosity ρ D of each band over the scene.
fn scales(elements: &[Element], coatings: &[&Coating], direct: &[Vec<f64>]) -> Vec<f64> {
    let mean = |(coating, direct): (&&Coating, &Vec<f64>)| {
        let reflectances = elements.iter().zip(&coating.reflectance);
        let reflectances =
            reflectances.flat_map(|(element, rho)| std::iter::repeat_n(rho, element.constant.len()));
        reflected::scale(elements, reflectances.zip(direct).map(|(rho, d)| rho * d))
    };
    coatings.iter().zip(direct).map(mean).collect()
}

/// d of an element, per band.
fn of_direct(element: &Element, index: usize, lit: Lit<'_>, bands: usize) -> Vec<Vec<f64>> {
    let mut sums = Sums::new(element, bands);
    let points = (element.basis.order() >> DIRECT_HALVINGS) + 2;
    for cell in element.patches.iter().flat_map(|patch| cells(patch, DIRECT_HALVINGS)) {
        sums.add(&cell, points, |node| lit(index, node));
    }
    sums.finish()
}

/// g of an element, per band.
fn of_reflected(
    element: &Element,
    index: usize,
    lit: Lit<'_>,
    reflection: &Reflection,
    bands: usize,
) -> Vec<Vec<f64>> {
    let mut sums = Sums::new(element, bands);
    for patch in &element.patches {
        let halvings = if area(patch) < SMALL * element.area { 0 } else { REFLECTED_HALVINGS };
        let points = element.basis.order().div_ceil(1 << halvings) + 1;
        for cell in cells(patch, halvings) {
            let site = Site { points: &cell.hull(), ..Site::of(element) };
            let around = reflection.around(&site);
            sums.add(&cell, points, |node| {
                let vantage = ReceiverPoint::on(element.surface, node.position, node.normal);
                reflection.irradiance(&vantage, &around, &lit(index, node))
            });
        }
    }
    sums.finish()
}

/// The 2^halvings × 2^halvings cells of a patch.
fn cells(patch: &Patch, halvings: usize) -> Vec<Patch> {
    let mut cells = vec![patch.clone()];
    for _ in 0..halvings {
        let columns = cells.iter().flat_map(|cell| cell.halves(Direction::Along));
        cells = columns.flat_map(|half| half.halves(Direction::Across)).collect();
    }
    cells
}

/// About the area of a patch.
fn area(patch: &Patch) -> f64 {
    patch.node(0.5, 0.5).area
}

/// ∫ R_k f dA in the raw polynomials R_k of an element, per band.
struct Sums<'a> {
    element: &'a Element,
    raw: Vec<f64>,
    sums: Vec<Vec<f64>>,
}

impl<'a> Sums<'a> {
    fn new(element: &'a Element, bands: usize) -> Self {
        let zero = vec![0.0; element.basis.len()];
        Self { element, sums: vec![zero.clone(); bands], raw: zero }
    }

    /// Adds the integral over a cell by so many points along each direction.
    fn add(&mut self, cell: &Patch, points: usize, value: impl Fn(&Node) -> Vec<f64>) {
        let basis = &self.element.basis;
        let rule = UnitRule::of(points);
        for ((s, ws), (t, wt)) in rule.iter().flat_map(|s| rule.iter().map(move |t| (s, t))) {
            let node = cell.node(s, t);
            basis.raw(basis.frame().coordinates(&node), &mut self.raw);
            for (sums, value) in self.sums.iter_mut().zip(value(&node)) {
                let weighted = ws * wt * node.area * value;
                sums.iter_mut().zip(&self.raw).for_each(|(sum, raw)| *sum += weighted * raw);
            }
        }
    }

    /// ∫ φ_k f dA with φ_k = Σ_l T_kl R_l.
    fn finish(self) -> Vec<Vec<f64>> {
        let basis = &self.element.basis;
        let rows = || basis.transform().chunks_exact(basis.len());
        let orthonormal =
            |sums: &Vec<f64>| rows().map(|row| row.iter().zip(sums).map(|(t, sum)| t * sum).sum()).collect();
        self.sums.iter().map(orthonormal).collect()
    }
}
