//! Points that fill a cube evenly: a rank-1 lattice, moved at random.
//!
//! ```text
//! x_k = frac(k z / n + Δ) ,     0 ≤ k < n = 2^m ,     z_j = a^j mod n      (N. Korobov)
//! ```
//!
//! With Δ even over the cube each point is even over it, so that means over the points are unbiased, and
//! independent Δ give independent means, whose spread is their error (R. Cranley, T. Patterson, SIAM J. Numer.
//! Anal. 13, 1976). Beyond the dimensions of the lattice a walk draws from its own stream of random numbers.

use crate::random::Random;

/// Dimensions of the lattice: where a walk starts and the draws of its first two vertices. Further ones
/// matter too little to gain by it.
pub(crate) const DIMENSIONS: usize = 22;

/// Generators a of the lattices of 2^m points, m = 0, 1, …: of up to 400 odd numbers tried for each, the one of
/// the least mean over k of ∏_j (1 + 2π² w_j B₂(x_kj)), with B₂(x) = x² − x + 1/6, over six coordinates j = 0 to 5
/// of the weights w_j = 1 / (1 + 0.3 j): the error in the worst case of integrands whose mixed derivatives are
/// square integrable (I. Sloan, S. Joe, *Lattice methods for multiple integration*, 1994).
const GENERATORS: [u64; 19] =
    [1, 1, 1, 3, 3, 5, 11, 11, 117, 131, 195, 363, 1405, 3385, 6761, 14_097, 29_225, 59_111, 129_611];

/// Most points of a lattice, as a power of 2.
pub(crate) const MOST: u32 = GENERATORS.len() as u32 - 1;

/// One lattice with its move.
#[derive(Clone, Debug)]
pub(crate) struct Lattice {
    count: u64,
    generators: [u64; DIMENSIONS],
    shift: [f64; DIMENSIONS],
}

impl Lattice {
    /// The lattice of 2^`log` points, log ≤ [`MOST`], moved by what `random` draws.
    pub(crate) fn moved(log: u32, random: &mut Random) -> Self {
        let count = 1u64 << log;
        let mut power = 1;
        let generators = std::array::from_fn(|_| {
            let own = power;
            power = power * GENERATORS[log as usize] % count.max(2);
            own
        });
        Self { count, generators, shift: std::array::from_fn(|_| random.next()) }
    }

    /// Coordinate `dimension` of point k.
    #[inline]
    fn at(&self, k: u64, dimension: usize) -> f64 {
        // The product is reduced as an integer, so that no digit is lost.
        let place = ((k * self.generators[dimension]) & (self.count - 1)) as f64 / self.count as f64;
        let moved = place + self.shift[dimension];
        if moved >= 1.0 { moved - 1.0 } else { moved }
    }
}

/// The draws of one walk: coordinates of a lattice's point, then random numbers.
#[derive(Debug)]
pub(crate) struct Draws<'a> {
    lattice: &'a Lattice,
    point: u64,
    dimension: usize,
    random: Random,
}

impl<'a> Draws<'a> {
    /// The draws of a walk by the point of that number; `random` is its own stream.
    pub(crate) fn new(lattice: &'a Lattice, point: u64, random: Random) -> Self {
        Self { lattice, point, dimension: 0, random }
    }

    /// Goes on at a coordinate, so that it stands for one and the same thing in all walks.
    #[inline]
    pub(crate) fn go_to(&mut self, dimension: usize) {
        self.dimension = dimension;
    }

    /// The next draw, even over [0, 1).
    #[inline]
    pub(crate) fn next(&mut self) -> f64 {
        let dimension = self.dimension;
        self.dimension += 1;
        if dimension < DIMENSIONS { self.lattice.at(self.point, dimension) } else { self.random.next() }
    }

    /// The next two draws.
    #[inline]
    pub(crate) fn pair(&mut self) -> [f64; 2] {
        [self.next(), self.next()]
    }
}
