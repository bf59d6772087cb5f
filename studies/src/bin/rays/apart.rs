//! The difference of two solutions on the same elements.

use radiosity::elements::Element;

/// Relative L2 difference of mean values of elements, by area, from those of the second.
pub(crate) fn apart(list: &[Element], found: &[f64], truth: &[f64]) -> f64 {
    let (mut far, mut all) = (0.0, 0.0);
    for ((element, found), truth) in list.iter().zip(found).zip(truth) {
        far += element.area * (found - truth).powi(2);
        all += element.area * truth * truth;
    }
    (far / all).sqrt()
}

/// The mean over each element of what these coefficients stand for.
pub(crate) fn means(list: &[Element], coefficients: &[f64]) -> Vec<f64> {
    let mut rest = coefficients;
    let mean = |element: &Element| {
        let (own, later) = rest.split_at(element.basis.len());
        rest = later;
        own.iter().zip(&element.constant).map(|(h, c)| h * c).sum::<f64>() / element.area
    };
    list.iter().map(mean).collect()
}
