//! Tensor rules between two patches, contracted one direction at a time.
//!
//! With points (s_a, t_b) on the receiver, (u_c, v_d) on the emitter, and functions that are products along
//! each direction,
//!
//! ```text
//! X_β(ab, c)  = Σ_d κ(ab, cd) p_β(v_d) ,      W_l(ab) = Σ_c p_α(u_c) X_β(ab, c) ,     l = (α, β)
//! Z_βl(a)     = Σ_b p_β(t_b) W_l(ab) ,        M_kl    = Σ_a p_α(s_a) Z_βl(a) ,        k = (α, β) :
//! ```
//!
//! This takes N + 1 multiplications a sample, not (N + 1)(N + 2)/2. Receiver points are processed in tiles of
//! [`LANES`], so that every inner loop has a fixed length. Between two planes both cosines are factors of the
//! sums,
//!
//! ```text
//! κ = h(x) h(y) / (π r⁴) ,    h(y) = n_x·(y − x₀),  h(x) = n_y·(x − y₀) ,
//! ```
//!
//! and a sample costs one squared distance and one division.

use core::f64::consts::FRAC_1_PI;

use radiosity_elements::patch::{Node, Patch};
use radiosity_elements::rule::Line;
use radiosity_geom::DVec3;
use radiosity_work::interruption::check_interrupt;

use crate::moments::chart::Chart;
use crate::moments::integrand::Sees;

/// Receiver points in a tile: one AVX-512 register of f64, two of AVX.
pub const LANES: usize = 8;

/// Floor of squared distances: points that coincide exchange nothing, and 0/0 is avoided. r⁴ is then 1e-300,
/// still a normal number.
const LEAST_SQUARE: f64 = 1e-150;

/// Values at the points that are computed together.
pub type Lanes = [f64; LANES];

/// A kernel that is a sum of terms, of which each has moments of its own.
pub trait Terms {
    /// Number of terms.
    fn count(&self) -> usize;

    /// Writes every term between the points of `tile` and `node`, a row of lanes per term.
    fn write(&mut self, tile: &Tile, node: &Node, out: &mut [Lanes]);
}

/// One side of a tensor rule: its points on a patch, and the polynomials in either direction.
pub(crate) struct Grid<'a> {
    chart: &'a Chart,
    counts: [usize; 2],
    /// The points; the parameter across changes fastest.
    nodes: Vec<Node>,
    /// w_a w_b A of each point.
    weights: Vec<f64>,
    /// p_i at each node of either direction, a row per node.
    tables: [Vec<f64>; 2],
    flat: bool,
}

impl<'a> Grid<'a> {
    /// The grid of the nodes `along` × `across` on `patch`, whose functions are those of `chart`.
    pub(crate) fn new(patch: &Patch, chart: &'a Chart, along: Line, across: Line) -> Self {
        let counts = [along.nodes.len(), across.nodes.len()];
        let mut nodes = Vec::with_capacity(counts[0] * counts[1]);
        let mut weights = Vec::with_capacity(counts[0] * counts[1]);
        for (s, ws) in along.nodes.iter().zip(along.weights) {
            for (t, wt) in across.nodes.iter().zip(across.weights) {
                let node = patch.node(*s, *t);
                weights.push(ws * wt * node.area);
                nodes.push(node);
            }
        }
        let table = |direction: usize, places: &[f64]| {
            let mut table = vec![0.0; places.len() * chart.width()];
            for (place, row) in places.iter().zip(table.chunks_exact_mut(chart.width())) {
                chart.polynomials(direction, *place, row);
            }
            table
        };
        let tables = [table(0, along.nodes), table(1, across.nodes)];
        Self { chart, counts, nodes, weights, tables, flat: patch.is_flat() }
    }

    pub(crate) fn len(&self) -> usize {
        self.nodes.len()
    }

    fn row(&self, direction: usize, place: usize) -> &[f64] {
        let width = self.chart.width();
        &self.tables[direction][place * width..(place + 1) * width]
    }

    /// Height of every point over the tangent plane of a node of the other side, times the point's weight.
    fn weighted_heights(&self, other: &Node) -> Vec<f64> {
        let height = |node: &Node| (node.position - other.position).dot(other.normal).max(0.0);
        self.nodes.iter().zip(&self.weights).map(|(node, weight)| weight * height(node)).collect()
    }
}

/// Adds `factor` · M to `moments`, row-major, receiver's functions by emitter's.
///
/// With `sees`, each sample is multiplied by its visibility; `rays` is increased by the segments tested.
pub(crate) fn add(
    moments: &mut [f64],
    factor: f64,
    [receiver, emitter]: [&Grid; 2],
    sees: Option<Sees>,
    rays: &mut u64,
) {
    let gathered = if receiver.flat && emitter.flat {
        let leaving = receiver.weighted_heights(&emitter.nodes[0]);
        let arriving = emitter.weighted_heights(&receiver.nodes[0]);
        gather(receiver, emitter, &leaving, factor * FRAC_1_PI, |tile, c| {
            hidden_removed(tile, &emitter.nodes[c], flat(tile, &emitter.nodes[c], arriving[c]), sees, rays)
        })
    } else {
        gather(receiver, emitter, &receiver.weights, factor * FRAC_1_PI, |tile, c| {
            let node = &emitter.nodes[c];
            hidden_removed(tile, node, general(tile, node, emitter.weights[c]), sees, rays)
        })
    };
    scatter(moments, receiver, emitter.chart.len(), &gathered);
}

/// The moments of every term of `kernel`, each row-major, receiver's functions by emitter's.
pub(crate) fn of_terms([receiver, emitter]: [&Grid; 2], kernel: &mut impl Terms) -> Vec<Vec<f64>> {
    let (terms, count) = (kernel.count(), emitter.chart.len());
    let mut gathered = vec![vec![0.0; receiver.len() * count]; terms];
    let mut values = vec![[0.0; LANES]; terms * emitter.len()];
    let mut sums = Sums::new(emitter);
    let tiles = receiver.nodes.chunks(LANES).zip(receiver.weights.chunks(LANES));
    for (first, (nodes, weights)) in tiles.enumerate() {
        let tile = Tile::new(nodes);
        for (node, out) in emitter.nodes.iter().zip(values.chunks_exact_mut(terms)) {
            check_interrupt();
            kernel.write(&tile, node, out);
        }
        for (term, rows) in gathered.iter_mut().enumerate() {
            sums.contract(emitter, |c| {
                let mut lanes = [0.0; LANES];
                add_scaled(&mut lanes, emitter.weights[c], &values[c * terms + term]);
                lanes
            });
            sums.write(&mut rows[first * LANES * count..], weights, 1.0);
        }
    }
    let moments = |rows: &Vec<f64>| {
        let mut moments = vec![0.0; receiver.chart.len() * count];
        scatter(&mut moments, receiver, count, rows);
        moments
    };
    gathered.iter().map(moments).collect()
}

/// Receiver points of one tile; the last is repeated where there are fewer.
pub struct Tile {
    position: [Lanes; 3],
    normal: [Lanes; 3],
    live: usize,
}

impl Tile {
    fn new(nodes: &[Node]) -> Self {
        let lanes = |value: &dyn Fn(&Node) -> f64| {
            core::array::from_fn(|lane| value(&nodes[lane.min(nodes.len() - 1)]))
        };
        Self {
            position: [lanes(&|n| n.position.x), lanes(&|n| n.position.y), lanes(&|n| n.position.z)],
            normal: [lanes(&|n| n.normal.x), lanes(&|n| n.normal.y), lanes(&|n| n.normal.z)],
            live: nodes.len(),
        }
    }

    /// y − x and its square, not below `LEAST_SQUARE`.
    #[inline(always)]
    pub fn offset(&self, node: &Node, lane: usize) -> [f64; 4] {
        let [x, y, z] = &self.position;
        let (dx, dy, dz) = (node.position.x - x[lane], node.position.y - y[lane], node.position.z - z[lane]);
        [dx, dy, dz, (dx * dx + dy * dy + dz * dz).max(LEAST_SQUARE)]
    }

    /// A point.
    #[inline(always)]
    pub fn point(&self, lane: usize) -> DVec3 {
        DVec3::new(self.position[0][lane], self.position[1][lane], self.position[2][lane])
    }

    /// The normal at a point.
    #[inline(always)]
    pub fn normal(&self, lane: usize) -> DVec3 {
        DVec3::new(self.normal[0][lane], self.normal[1][lane], self.normal[2][lane])
    }
}

/// Sums over the emitter for one tile of receiver points.
struct Sums {
    /// X: over the nodes across, a row per polynomial.
    inner: Vec<Lanes>,
    /// W: over all nodes, a row per function.
    outer: Vec<Lanes>,
}

impl Sums {
    fn new(emitter: &Grid) -> Self {
        let (count, width) = (emitter.chart.len(), emitter.chart.width());
        Self { inner: vec![[0.0; LANES]; width], outer: vec![[0.0; LANES]; count] }
    }

    /// W of the weighted values `kernel` at the emitter's nodes.
    #[inline(always)]
    fn contract(&mut self, emitter: &Grid, mut kernel: impl FnMut(usize) -> Lanes) {
        self.outer.fill([0.0; LANES]);
        for c in 0..emitter.counts[0] {
            self.inner.fill([0.0; LANES]);
            for d in 0..emitter.counts[1] {
                let values = kernel(c * emitter.counts[1] + d);
                for (x, p) in self.inner.iter_mut().zip(emitter.row(1, d)) {
                    add_scaled(x, *p, &values);
                }
            }
            let along = emitter.row(0, c);
            for (w, (alpha, beta)) in self.outer.iter_mut().zip(emitter.chart.degrees()) {
                add_scaled(w, along[*alpha], &self.inner[*beta]);
            }
        }
    }

    /// Writes W times the points' weights and `factor`, a row per point.
    fn write(&self, rows: &mut [f64], weights: &[f64], factor: f64) {
        for (lane, (row, weight)) in rows.chunks_exact_mut(self.outer.len()).zip(weights).enumerate() {
            let scale = factor * weight;
            row.iter_mut().zip(&self.outer).for_each(|(out, w)| *out = scale * w[lane]);
        }
    }
}

/// W: for each receiver point a row of the emitter's functions, times the point's weight and `factor`.
fn gather(
    receiver: &Grid,
    emitter: &Grid,
    weights: &[f64],
    factor: f64,
    mut kernel: impl FnMut(&Tile, usize) -> Lanes,
) -> Vec<f64> {
    let count = emitter.chart.len();
    let mut gathered = vec![0.0; receiver.len() * count];
    let mut sums = Sums::new(emitter);
    let tiles = receiver.nodes.chunks(LANES).zip(weights.chunks(LANES));
    for ((nodes, weights), rows) in tiles.zip(gathered.chunks_mut(LANES * count)) {
        let tile = Tile::new(nodes);
        sums.contract(emitter, |c| kernel(&tile, c));
        sums.write(rows, weights, factor);
    }
    gathered
}

/// M_kl += Σ_a p_α(s_a) Σ_b p_β(t_b) W_l(ab).
fn scatter(moments: &mut [f64], receiver: &Grid, count: usize, gathered: &[f64]) {
    let width = receiver.chart.width();
    let mut inner = vec![0.0; width * count];
    for (a, rows) in gathered.chunks_exact(receiver.counts[1] * count).enumerate() {
        inner.fill(0.0);
        for (b, row) in rows.chunks_exact(count).enumerate() {
            for (z, p) in inner.chunks_exact_mut(count).zip(receiver.row(1, b)) {
                z.iter_mut().zip(row).for_each(|(z, w)| *z += p * w);
            }
        }
        let along = receiver.row(0, a);
        for (out, (alpha, beta)) in moments.chunks_exact_mut(count).zip(receiver.chart.degrees()) {
            let z = &inner[beta * count..(beta + 1) * count];
            out.iter_mut().zip(z).for_each(|(m, z)| *m += along[*alpha] * z);
        }
    }
}

#[inline(always)]
fn add_scaled(out: &mut Lanes, factor: f64, values: &Lanes) {
    for lane in 0..LANES {
        out[lane] += factor * values[lane];
    }
}

/// scale / r⁴; where points can coincide the scale is zero.
#[inline(always)]
fn flat(tile: &Tile, node: &Node, scale: f64) -> Lanes {
    core::array::from_fn(|lane| {
        let [.., r2] = tile.offset(node, lane);
        scale / (r2 * r2)
    })
}

/// scale · max(0, n_x·d) max(0, −n_y·d) / r⁴; zero where the points coincide.
#[inline(always)]
fn general(tile: &Tile, node: &Node, scale: f64) -> Lanes {
    core::array::from_fn(|lane| {
        let [dx, dy, dz, r2] = tile.offset(node, lane);
        let arriving = tile.normal[0][lane] * dx + tile.normal[1][lane] * dy + tile.normal[2][lane] * dz;
        let leaving = -(node.normal.x * dx + node.normal.y * dy + node.normal.z * dz);
        scale * arriving.max(0.0) * leaving.max(0.0) / (r2 * r2)
    })
}

#[inline(always)]
fn hidden_removed(tile: &Tile, node: &Node, values: Lanes, sees: Option<Sees>, rays: &mut u64) -> Lanes {
    let Some(sees) = sees else { return values };
    check_interrupt();
    core::array::from_fn(|lane| {
        if lane >= tile.live || values[lane] == 0.0 {
            return 0.0;
        }
        *rays += 1;
        if sees(tile.point(lane), node.position) { values[lane] } else { 0.0 }
    })
}
