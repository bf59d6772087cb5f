//! Σ_m v_m L_l(a_m, b_m) for all l, over many points at once.
//!
//! The points are processed in tiles that fill the processor's lanes; each lane keeps its own sums to the
//! end.

use radiosity_core::{basis::total, legendre};
use radiosity_elements::basis::HIGHEST_ORDER;
use radiosity_geom::DVec2;

use crate::moments::tensor::LANES;

/// Points with their values.
#[derive(Debug, Default)]
pub(super) struct Samples {
    first: Vec<f64>,
    second: Vec<f64>,
    values: Vec<f64>,
    sums: Vec<[f64; LANES]>,
}

impl Samples {
    pub(super) fn clear(&mut self) {
        self.first.clear();
        self.second.clear();
        self.values.clear();
    }

    pub(super) fn push(&mut self, place: DVec2, value: f64) {
        self.first.push(place.x);
        self.second.push(place.y);
        self.values.push(value);
    }

    pub(super) fn len(&self) -> usize {
        self.values.len()
    }

    /// Writes the sums for all L of total degree ≤ `order`.
    pub(super) fn sum(&mut self, order: usize, out: &mut [f64]) {
        // Padding to whole tiles: points of value zero add nothing.
        let padded = self.len().next_multiple_of(LANES);
        for list in [&mut self.first, &mut self.second, &mut self.values] {
            list.resize(padded, 0.0);
        }
        self.sums.clear();
        self.sums.resize(out.len(), [0.0; LANES]);
        match order {
            0 => self.tiles::<1>(order),
            1..=2 => self.tiles::<3>(order),
            3..=4 => self.tiles::<5>(order),
            5..=8 => self.tiles::<9>(order),
            _ => self.tiles::<{ HIGHEST_ORDER + 1 }>(order),
        }
        out.iter_mut().zip(&self.sums).for_each(|(sum, lanes)| *sum = lanes.iter().sum());
    }

    /// Writes the sums for functions of places that are no products of total degree.
    pub(super) fn sum_of(&self, functions: impl Fn([f64; 2], &mut [f64]), out: &mut [f64]) {
        out.fill(0.0);
        let mut values = vec![0.0; out.len()];
        for ((a, b), value) in self.first.iter().zip(&self.second).zip(&self.values) {
            functions([*a, *b], &mut values);
            out.iter_mut().zip(&values).for_each(|(sum, own)| *sum += value * own);
        }
    }

    fn tiles<const P: usize>(&mut self, order: usize) {
        let (first, _) = self.first.as_chunks::<LANES>();
        let (second, _) = self.second.as_chunks::<LANES>();
        let (values, _) = self.values.as_chunks::<LANES>();
        for ((a, b), v) in first.iter().zip(second).zip(values) {
            let (mut p, mut q) = ([[0.0; LANES]; P], [[0.0; LANES]; P]);
            legendre::tile(a, &mut p);
            legendre::tile(b, &mut q);
            q.iter_mut().for_each(|row| row.iter_mut().zip(v).for_each(|(q, v)| *q *= v));
            for degree in 0..=order {
                let start = total::index(degree, 0);
                for (j, sums) in self.sums[start..=start + degree].iter_mut().enumerate() {
                    for l in 0..LANES {
                        sums[l] += p[degree - j][l] * q[j][l];
                    }
                }
            }
        }
    }
}
