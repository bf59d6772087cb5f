//! Distance of two solutions of one scene, which may have different elements.
//!
//! ```text
//! d(B, B′) = ‖B − B′‖ / ‖B′ − E₀‖ ,     ‖f‖² = Σ_bands ∫ f² dA
//! ```
//!
//! The emitted exitance is given and not computed: it cancels in the difference and is left out of the norm,
//! so that a lamp a thousand times as bright as its room does not make every error look small. The integrals
//! run over the common refinement of the two cuts: every element of B′ meets the elements of B on its surface
//! in patches on which both are polynomials. On flat patches the Gauss rules are exact, on curved ones good
//! to many more digits than the solutions; where reflectance varies, as good as the points of a rule
//! represent its texels. Squares are added in a fixed order: the result does not depend on the number of
//! threads.

use radiosity_elements::Element;
use radiosity_elements::parameters::of_node;
use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::UnitRule;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use crate::solution::{Solution, SurfacePlace};

/// Two solutions that are not of one scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Incomparable {
    /// Different numbers of bands.
    #[error("one solution has {0} bands, the other {1}: compare solutions of the same scene")]
    Bands(usize, usize),
    /// Different numbers of surfaces.
    #[error("one solution has {0} surfaces, the other {1}: compare solutions of the same scene")]
    Surfaces(usize, usize),
}

/// ‖B − B′‖ / ‖B′ − E₀‖ of `solution` B and `reference` B′, all bands pooled; 0 if nothing is reflected in
/// either.
///
/// # Errors
/// Solutions with different numbers of bands or surfaces. The caller guarantees that the surfaces are the
/// same.
pub fn distance(solution: &Solution, reference: &Solution) -> Result<f64, Incomparable> {
    let bands = [solution, reference].map(|s| s.bands().len());
    if bands[0] != bands[1] {
        return Err(Incomparable::Bands(bands[0], bands[1]));
    }
    let surfaces = [solution, reference].map(|s| s.elements().surfaces());
    if surfaces[0] != surfaces[1] {
        return Err(Incomparable::Surfaces(surfaces[0], surfaces[1]));
    }
    let elements = 0..reference.elements().list().len();
    let squares: Vec<Squares> =
        elements.into_par_iter().map(|element| Squares::over(element, solution, reference)).collect();
    let difference: f64 = squares.iter().map(|s| s.difference).sum();
    let size: f64 = squares.iter().map(|s| s.size).sum();
    Ok(if difference > 0.0 { (difference / size).sqrt() } else { 0.0 })
}

/// ∫ (B − B′)² dA and ∫ (B′ − E₀)² dA over one element of the reference.
#[derive(Clone, Copy, Default)]
struct Squares {
    difference: f64,
    size: f64,
}

/// An element with the solution whose light it sends.
#[derive(Clone, Copy)]
struct SolvedElement<'a> {
    solution: &'a Solution,
    element: usize,
}

impl SolvedElement<'_> {
    fn radiosity(&self, band: usize, place: &SurfacePlace) -> f64 {
        self.solution.radiosity(band, self.element, place)
    }
}

impl Squares {
    fn over(element: usize, solution: &Solution, reference: &Solution) -> Self {
        check_interrupt();
        let fine = &reference.elements().list()[element];
        let mut sum = Self::default();
        for other in solution.elements().of_surface(fine.surface) {
            let coarse = &solution.elements().list()[other];
            if !coarse.is_of_part(fine) {
                continue;
            }
            let degree = fine.basis.total_degree().max(coarse.basis.total_degree());
            for patch in reference.elements().patches_over(element, &coarse.rect) {
                for_each_point(&patch, degree, |node, weight| {
                    let place = place(reference, fine, node);
                    let [own, exact] = [
                        SolvedElement { solution, element: other },
                        SolvedElement { solution: reference, element },
                    ];
                    sum.add(weight, &place, own, exact);
                });
            }
        }
        sum
    }

    /// Adds a point of this weight, where the light of `own` misses that of `reference`.
    fn add(&mut self, weight: f64, place: &SurfacePlace, own: SolvedElement, reference: SolvedElement) {
        for (band, light) in reference.solution.bands().iter().enumerate() {
            let exact = reference.radiosity(band, place);
            let emitted = light.coating.exitance_at(reference.element, place.parameters);
            self.difference += weight * (own.radiosity(band, place) - exact).powi(2);
            self.size += weight * (exact - emitted).powi(2);
        }
    }
}

/// The place of a node of an element, whose patches carry no parameters if it is flat.
fn place(solution: &Solution, element: &Element, node: &Node) -> SurfacePlace {
    let shape = solution.elements().shape(element.surface);
    let parameters = of_node(shape, node, element.plane.is_some());
    SurfacePlace { surface: element.surface, parameters, position: node.position }
}

/// Points and area weights that integrate the square of a polynomial of `degree`.
fn for_each_point(patch: &Patch, degree: usize, mut visit: impl FnMut(&Node, f64)) {
    let rule = UnitRule::of(if patch.is_flat() { degree + 1 } else { degree + 5 });
    for (s, ws) in rule.iter() {
        for (t, wt) in rule.iter() {
            let node = patch.node(s, t);
            visit(&node, ws * wt * node.area);
        }
    }
}
