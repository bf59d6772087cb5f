//! Moments of two patches with a common edge, summed in an order that leaves t and v to the end:
//!
//! ```text
//! S_ij = Σ κ p_i(s) p_j(u) ,   Q_il = Σ p_β(v) S_ij ,   M_kl = Σ p_α(t) Q_il ,   k = (i, α), l = (j, β)
//! ```

use radiosity_elements::columns::add_scaled;

use crate::moments::PatchMoments;

/// The sums S, Q and M of one pair of patches.
pub(crate) struct EdgeSum<'p> {
    /// The pair, whose values are M.
    pub pair: PatchMoments<'p>,
    /// Number of the emitter's polynomials along the edge.
    width: usize,
    /// S, p_i of the receiver by p_j of the emitter.
    both_along: Vec<f64>,
    /// Q, p_i of the receiver by the emitter's products.
    along_receiver: Vec<f64>,
    receiver_row: Vec<f64>,
    emitter_row: Vec<f64>,
}

impl<'p> EdgeSum<'p> {
    pub(crate) fn new(pair: PatchMoments<'p>) -> Self {
        let [rows, width] = [0, 1].map(|side| pair.charts[side].width());
        Self {
            width,
            both_along: vec![0.0; rows * width],
            along_receiver: vec![0.0; rows * pair.charts[1].len()],
            receiver_row: vec![0.0; rows],
            emitter_row: vec![0.0; width],
            pair,
        }
    }

    /// S += value · p_i(s) p_j(u).
    pub(crate) fn add(&mut self, s: f64, u: f64, value: f64) {
        self.pair.charts[0].polynomials(0, s, &mut self.receiver_row);
        self.pair.charts[1].polynomials(0, u, &mut self.emitter_row);
        for (row, left) in self.both_along.chunks_exact_mut(self.width).zip(&self.receiver_row) {
            add_scaled(row, value * left, &self.emitter_row);
        }
    }

    /// Q += p_β(v) S, and S = 0.
    pub(crate) fn close_across_emitter(&mut self, v: f64) {
        let chart = &self.pair.charts[1];
        chart.polynomials(1, v, &mut self.emitter_row);
        let lines = self.along_receiver.chunks_exact_mut(chart.len());
        for (line, row) in lines.zip(self.both_along.chunks_exact(self.width)) {
            for (q, (j, beta)) in line.iter_mut().zip(chart.degrees()) {
                *q += self.emitter_row[*beta] * row[*j];
            }
        }
        self.both_along.fill(0.0);
    }

    /// M += p_α(t) Q, and Q = 0.
    pub(crate) fn close_across_receiver(&mut self, t: f64) {
        let [receiver, emitter] = &self.pair.charts;
        receiver.polynomials(1, t, &mut self.receiver_row);
        let count = emitter.len();
        for (out, (i, alpha)) in self.pair.values.chunks_exact_mut(count).zip(receiver.degrees()) {
            add_scaled(out, self.receiver_row[*alpha], &self.along_receiver[i * count..(i + 1) * count]);
        }
        self.along_receiver.fill(0.0);
    }
}
