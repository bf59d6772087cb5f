//! Radiosity of two opposed plates of exitance 1 and one reflectance, from integral equations in one variable.
//!
//! ```text
//! B(x) = 1 + ρ ∫ K(x, y) B(y) dy
//!
//! strips of width 1 at h, −½ ≤ x, y ≤ ½:    K = ½ h² / ((x − y)² + h²)^{3/2}
//! disks of radius 1 at h, 0 ≤ x, y ≤ 1:     K = 2 h² y (h² + x² + y²) / ((h² + x² + y²)² − 4 x² y²)^{3/2}
//! ```
//!
//! Strips are infinitely long. Nyström's method: values at Gauss's points by iteration, elsewhere by the
//! equation itself. The kernels are analytic, and the rule is exact to rounding for h ≥ 0.1.
//!
//! Reference: E. M. Sparrow, *Application of variational methods to radiation heat-transfer calculations*,
//! J. Heat Transfer 82 (1960).

use radiosity_core::gauss;

/// Points of the rule.
const POINTS: usize = 200;
/// Times that light is reflected: 0.9 to this power is below rounding.
const BOUNCES: usize = 400;

/// The form of two equal plates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plates {
    /// Infinitely long strips of width 1.
    Strips,
    /// Disks of radius 1.
    Disks,
}

/// Two opposed plates.
#[derive(Debug)]
pub struct Opposed {
    plates: Plates,
    distance: f64,
    reflectance: f64,
    nodes: Vec<f64>,
    /// Weight times radiosity at each node.
    weighted: Vec<f64>,
}

impl Opposed {
    /// Plates at a distance of at least 0.1.
    pub fn new(plates: Plates, distance: f64, reflectance: f64) -> Self {
        let mut nodes = vec![0.0; POINTS];
        let mut weights = vec![0.0; POINTS];
        gauss::legendre(&mut nodes, &mut weights).expect("slices are equal and not empty");
        let shift = if plates == Plates::Strips { 0.0 } else { 0.5 };
        nodes.iter_mut().for_each(|x| *x = 0.5 * *x + shift);
        weights.iter_mut().for_each(|w| *w *= 0.5);
        let mut own = Self { plates, distance, reflectance, nodes, weighted: weights.clone() };
        for _ in 0..BOUNCES {
            own.weighted = own.nodes.iter().zip(&weights).map(|(x, w)| w * own.radiosity(*x)).collect();
        }
        own
    }

    /// Radiosity across a strip, from its middle, or along a radius.
    pub fn radiosity(&self, x: f64) -> f64 {
        let arriving = self.nodes.iter().zip(&self.weighted).map(|(y, b)| self.kernel(x, *y) * b);
        1.0 + self.reflectance * arriving.sum::<f64>()
    }

    fn kernel(&self, x: f64, y: f64) -> f64 {
        let squared = self.distance.powi(2);
        match self.plates {
            Plates::Strips => 0.5 * squared / ((x - y).powi(2) + squared).powf(1.5),
            Plates::Disks => {
                let sum = squared + x * x + y * y;
                2.0 * squared * y * sum / (sum * sum - 4.0 * x * x * y * y).powf(1.5)
            }
        }
    }
}
