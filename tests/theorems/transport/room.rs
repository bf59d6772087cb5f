//! A room of equal reflectance solved by repeated reflection, with nothing of the library's solvers.

use radiosity::elements::Elements;
use radiosity::kernel::Blocks;

/// Radiosity coefficients b = e + ρ G b; `reflectance` per element. Repeats to 1e-14 of the emission at most.
pub(crate) fn radiosity(
    elements: &Elements,
    blocks: &Blocks,
    reflectance: &[f64],
    emitted: &[f64],
) -> Vec<f64> {
    let norm = |x: &[f64]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
    let rho: Vec<f64> = elements
        .list()
        .iter()
        .zip(reflectance)
        .flat_map(|(element, rho)| std::iter::repeat_n(*rho, element.basis.len()))
        .collect();
    let reflected =
        |b: &[f64]| -> Vec<f64> { blocks.apply(b).iter().zip(&rho).map(|(h, rho)| rho * h).collect() };
    let (mut all, mut bounce) = (emitted.to_vec(), emitted.to_vec());
    for _ in 0..400 {
        bounce = reflected(&bounce);
        all.iter_mut().zip(&bounce).for_each(|(b, x)| *b += x);
        if norm(&bounce) <= 1e-14 * norm(emitted) {
            return all;
        }
    }
    panic!("light does not die out: ‖G‖ is above 1")
}

/// Coefficients of constant exitance per element.
pub(crate) fn emission(elements: &Elements, exitance: &[f64]) -> Vec<f64> {
    let scaled = |(element, e): (&radiosity::elements::Element, &f64)| {
        element.constant.iter().map(|c| c * e).collect::<Vec<_>>()
    };
    elements.list().iter().zip(exitance).flat_map(scaled).collect()
}

/// The coefficients of each element in its raw polynomials, for evaluation.
pub(crate) fn raw(elements: &Elements, coefficients: &[f64]) -> Vec<Vec<f64>> {
    let mut rest = coefficients;
    elements
        .list()
        .iter()
        .map(|element| {
            let (own, others) = rest.split_at(element.basis.len());
            rest = others;
            element.basis.to_raw(own)
        })
        .collect()
}
