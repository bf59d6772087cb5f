//! Sums over rays of one element: the weights of all, and those over the rays that count on no pair.

use radiosity_elements::Element;
use serde::{Deserialize, Serialize};

use crate::sampled::hit::Hit;
use crate::sampled::sender::Departure;
use crate::sampled::tally::functions;

/// Sums over rays of an element, in either half of its rays.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct ElementSums {
    /// Sum of the weights of the rays.
    pub weights: [f64; 2],
    /// Σ w φ_k(x) over the rays that met no front.
    pub missed: [Vec<f64>; 2],
    /// Σ w φ_k(x) over the rays that landed on pairs that are carried exactly.
    pub exact: [Vec<f64>; 2],
}

/// A ray that is counted, or taken back.
#[derive(Clone, Copy, Debug)]
pub(super) struct CountedRay<'a> {
    pub element: &'a Element,
    pub departure: &'a Departure,
    /// Half of the rays to which it belongs: 0 or 1.
    pub half: usize,
    /// 1, or −1 where it is taken back.
    pub sign: f64,
}

impl ElementSums {
    /// Sums over no rays of an element of so many functions.
    pub(super) fn nothing(functions: usize) -> Self {
        let sums = || [vec![0.0; functions], vec![0.0; functions]];
        Self { weights: [0.0; 2], missed: sums(), exact: sums() }
    }

    /// Counts a ray and the front that it meets, on an exact pair or not; the hit is left where it counts on
    /// its pair.
    pub(super) fn count(&mut self, ray: CountedRay<'_>, hit: Option<Hit>, is_exact: bool) -> Option<Hit> {
        let CountedRay { element, departure, half, sign } = ray;
        let weight = sign * departure.weight;
        self.weights[half] += weight;
        let own = match hit {
            Some(hit) if !is_exact => return Some(hit),
            Some(_) => &mut self.exact[half],
            None => &mut self.missed[half],
        };
        let values = functions(element, element.basis.frame().coordinates(&departure.node));
        own.iter_mut().zip(values).for_each(|(sum, value)| *sum += weight * value);
        None
    }
}
