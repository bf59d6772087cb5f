//! The fourfold sum over the points of two patches,
//!
//! ```text
//! K_J^kl = Σ_abcd w_a w_b w_c w_d κ(x_ab, y_cd) A_j(c, d) R_k(a, b) T_l(c, d) ,
//! ```
//!
//! for each (a, b) first over d, then over c.

use radiosity_core::basis::total;
use radiosity_elements::patch::Patch;
use radiosity_geom::DVec3;
use radiosity_kernel::kernel;

use crate::zatz1993::transfers::axis::Axis;
use crate::zatz1993::transfers::charted_element::ChartedElement;

/// Whether nothing stands between two points.
pub type Sees<'a> = &'a dyn Fn(DVec3, DVec3) -> bool;

/// The sum under way.
pub(super) struct Sum<'a> {
    pair: [ChartedElement<'a>; 2],
    sees: Option<Sees<'a>>,
    /// K_J^kl, row-major.
    pub values: Vec<f64>,
    /// Kernel evaluations.
    pub samples: u64,
    /// Visibility tests.
    pub rays: u64,
}

impl<'a> Sum<'a> {
    pub(super) fn new(pair: [ChartedElement<'a>; 2], sees: Option<Sees<'a>>) -> Self {
        let [rows, columns] = pair.map(|element| total::count(element.order));
        Self { pair, sees, values: vec![0.0; rows * columns], samples: 0, rays: 0 }
    }

    /// Adds the terms of all points of the axes.
    pub(super) fn add(&mut self, [s, t]: &[Axis; 2], emitter: &[Axis; 2]) {
        for a in 0..s.nodes.len() {
            for b in 0..t.nodes.len() {
                let arriving = self.arriving(s.nodes[a], t.nodes[b], emitter);
                let weight = s.weights[a] * t.weights[b];
                for (k, row) in self.values.chunks_exact_mut(arriving.len()).enumerate() {
                    let (p, q) = total::degrees(k);
                    let factor = weight * s.value(a, p) * t.value(b, q);
                    row.iter_mut().zip(&arriving).for_each(|(sum, h)| *sum += factor * h);
                }
            }
        }
    }

    /// ∬ κ A_j T_l du dv at one point of the receiver, for all l: first over v, then over u.
    fn arriving(&mut self, s: f64, t: f64, [u, v]: &[Axis; 2]) -> Vec<f64> {
        let [receiver, emitter] = self.pair;
        let at = |patch: &Patch, x: f64, y: f64| patch.node(0.5 * (1.0 + x), 0.5 * (1.0 + y));
        let here = at(receiver.patch, s, t);
        let mut arriving = vec![0.0; total::count(emitter.order)];
        let mut over_v = vec![0.0; emitter.order + 1];
        for c in 0..u.nodes.len() {
            over_v.fill(0.0);
            for d in 0..v.nodes.len() {
                let there = at(emitter.patch, u.nodes[c], v.nodes[d]);
                let mut value = kernel(&here, &there);
                self.samples += 1;
                if let (Some(sees), true) = (self.sees, value > 0.0) {
                    self.rays += 1;
                    value *= f64::from(u8::from(sees(here.position, there.position)));
                }
                // The area element of [0, 1]² is four times that of [−1, 1]².
                let factor = 0.25 * there.area * v.weights[d] * value;
                over_v.iter_mut().enumerate().for_each(|(q, sum)| *sum += factor * v.value(d, q));
            }
            for (l, sum) in arriving.iter_mut().enumerate() {
                let (p, q) = total::degrees(l);
                *sum += u.weights[c] * u.value(c, p) * over_v[q];
            }
        }
        arriving
    }
}
