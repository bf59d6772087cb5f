//! Numbers without structure that are the same in every run: splitmix64 (Steele, Lea, Flood, 2014).

use glam::DVec3;
use proptest::test_runner::{Config, RngSeed};

/// A sequence by its state, of which every one is good.
#[derive(Clone, Debug)]
pub struct Random(pub u64);

impl Random {
    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number, uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 * 2f64.powi(-53)
    }

    /// A number, uniform in [−1, 1).
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// A number, uniform in [low, high).
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number 10^x, x uniform in [low, high).
    pub fn power(&mut self, low: f64, high: f64) -> f64 {
        10f64.powf(self.between(low, high))
    }

    /// An integer, uniform in 0, 1, … below `bound` (≥ 1).
    pub fn below(&mut self, bound: usize) -> usize {
        (self.bits() % bound as u64) as usize
    }

    /// An item of a list that is not empty, all with equal chances.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[self.below(from.len())]
    }

    /// A list of so many numbers, uniform in [−1, 1).
    pub fn numbers(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| self.signed()).collect()
    }

    /// A vector, uniform in the cube [low, high)³.
    pub fn vector(&mut self, low: f64, high: f64) -> DVec3 {
        DVec3::new(self.between(low, high), self.between(low, high), self.between(low, high))
    }

    /// A unit vector, uniform on the sphere.
    pub fn direction(&mut self) -> DVec3 {
        loop {
            let d = self.vector(-1.0, 1.0);
            if (1e-3..1.0).contains(&d.length_squared()) {
                return d.normalize();
            }
        }
    }
}

/// Runs `cases` cases of proptest, the same in every run, and writes no file of those that fail.
pub fn seeded(cases: u32, seed: u64) -> Config {
    Config { cases, rng_seed: RngSeed::Fixed(seed), failure_persistence: None, ..Config::default() }
}
