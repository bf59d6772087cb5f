//! The block of two elements for any small displacement, as a power series in three variables.
//!
//! ```text
//! |r + p|⁻⁴ = Σ a_k p^k ,   k = (k₁, k₂, k₃) ,  |k| = k₁ + k₂ + k₃ ,   a_0 = r⁻⁴
//! |k| r² a_k = −(2|k| + 2) Σ_i r_i a_{k−e_i} − (|k| + 2) Σ_i a_{k−2e_i}
//! κ(p) = −(n_y·(r + p))(n_x·(r + p))/π · Σ a_k p^k
//! ```
//!
//! (N + 1)(N + 2)(N + 3)/6 coefficients to total degree N; it converges for |p| < r.

use core::f64::consts::FRAC_1_PI;

use radiosity::elements::Element;
use radiosity::elements::patch::Node;
use radiosity::geom::{DVec3, Motion};
use radiosity::kernel::moments::tensor::{LANES, Lanes, Terms, Tile};
use radiosity::kernel::terms::{Demand, blocks};

/// A block as a polynomial of a displacement.
pub(crate) struct DisplacementBlock {
    degree: usize,
    terms: Vec<Vec<f64>>,
    pub samples: u64,
}

impl DisplacementBlock {
    /// The series to total degree `degree` of two elements whose patches face each other, with points enough
    /// for displacements up to this share of their distance.
    pub(crate) fn new(elements: [&Element; 2], degree: usize, share: f64, eps: f64) -> Self {
        let degrees = elements.map(|element| element.basis.total_degree());
        let demand = Demand { place: Motion::IDENTITY, degrees, nearest: 1.0 - share, eps };
        let [receiver, emitter] = elements;
        let of = |p| emitter.patches.iter().map(move |q| (p, q));
        let pairs = receiver.patches.iter().flat_map(of);
        let parts: Vec<_> =
            pairs.flat_map(|(p, q)| demand.divided(p, q).expect("elements do not touch")).collect();
        let exponents: Vec<[usize; 3]> = exponents(degree).collect();
        let distance = vec![[0.0; LANES]; exponents.len()];
        let (terms, samples) = blocks(elements, &parts, &mut Samples { exponents, distance });
        Self { degree, terms, samples }
    }

    /// The block with the emitter displaced by `p`.
    pub(crate) fn at(&self, p: DVec3) -> Vec<f64> {
        let power = |[i, j, k]: [usize; 3]| p.x.powi(i as i32) * p.y.powi(j as i32) * p.z.powi(k as i32);
        let mut values = vec![0.0; self.terms[0].len()];
        for (k, term) in exponents(self.degree).zip(&self.terms) {
            let factor = power(k);
            values.iter_mut().zip(term).for_each(|(value, c)| *value += factor * c);
        }
        values
    }
}

/// The coefficients at pairs of points.
struct Samples {
    exponents: Vec<[usize; 3]>,
    /// a_k of the pairs that are written.
    distance: Vec<Lanes>,
}

impl Terms for Samples {
    fn count(&self) -> usize {
        self.exponents.len()
    }

    fn write(&mut self, tile: &Tile, node: &Node, out: &mut [Lanes]) {
        let offsets: [[f64; 4]; LANES] = core::array::from_fn(|lane| tile.offset(node, lane));
        self.expand_distance(&offsets);
        for (lane, [r @ .., _]) in offsets.iter().enumerate() {
            let (r, x, y) = (DVec3::from_array(*r), tile.normal(lane), node.normal);
            let constant = x.dot(r) * y.dot(r);
            let linear = (x * y.dot(r) + y * x.dot(r)).to_array();
            let (x, y) = (x.to_array(), y.to_array());
            for (k, out) in self.exponents.iter().zip(out.iter_mut()) {
                let mut sum = constant * self.distance[place(*k)][lane];
                for i in 0..3 {
                    let Some(less) = lowered(*k, i) else { continue };
                    sum += linear[i] * self.distance[place(less)][lane];
                    for (j, y) in y.iter().enumerate() {
                        let twice = lowered(less, j).map_or(0.0, |less| self.distance[place(less)][lane]);
                        sum += x[i] * y * twice;
                    }
                }
                out[lane] = -FRAC_1_PI * sum;
            }
        }
    }
}

impl Samples {
    /// a_k of these differences r with their squares.
    fn expand_distance(&mut self, offsets: &[[f64; 4]; LANES]) {
        self.distance[0] = offsets.map(|[.., r2]| 1.0 / (r2 * r2));
        for k in &self.exponents[1..] {
            let total = k.iter().sum::<usize>() as f64;
            let (mut first, mut second) = ([0.0; LANES], [0.0; LANES]);
            for i in 0..3 {
                let Some(less) = lowered(*k, i) else { continue };
                let once = self.distance[place(less)];
                let twice = lowered(less, i).map_or([0.0; LANES], |twice| self.distance[place(twice)]);
                for (lane, offset) in offsets.iter().enumerate() {
                    first[lane] += offset[i] * once[lane];
                    second[lane] += twice[lane];
                }
            }
            self.distance[place(*k)] = core::array::from_fn(|lane| {
                let sum = (2.0 * total + 2.0) * first[lane] + (total + 2.0) * second[lane];
                -sum / (total * offsets[lane][3])
            });
        }
    }
}

/// k − e_i, where k_i > 0.
fn lowered(mut k: [usize; 3], i: usize) -> Option<[usize; 3]> {
    k[i] = k[i].checked_sub(1)?;
    Some(k)
}

/// All k with |k| ≤ `degree`: degree by degree, within one k₁ falling, then k₂ falling.
fn exponents(degree: usize) -> impl Iterator<Item = [usize; 3]> {
    let level = |n: usize| (0..=n).flat_map(move |m| (0..=m).map(move |k| [n - m, m - k, k]));
    (0..=degree).flat_map(level)
}

/// The position of k in that order.
fn place([i, j, k]: [usize; 3]) -> usize {
    let (m, n) = (j + k, i + j + k);
    n * (n + 1) * (n + 2) / 6 + m * (m + 1) / 2 + k
}
