//! Pseudo-random numbers: xoshiro256++, started by SplitMix64.
//!
//! Each walk has a stream of its own, named by a few integers, so that what it draws depends on neither
//! threads nor order. No other part of the workspace draws by this generator.
//!
//! References: D. Blackman, S. Vigna, *Scrambled linear pseudorandom number generators*, ACM Trans. Math.
//! Softw. 47(4), 2021; G. Steele, D. Lea, C. Flood, *Fast splittable pseudorandom number generators*, 2014.

/// Weyl increment of SplitMix64: 2⁶⁴ over the golden ratio, made odd.
const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// Parts of names that keep streams apart: those that move lattices of readings, and follow them in walks.
pub(crate) const OF_LATTICES: u64 = 0;
pub(crate) const OF_WALKS: u64 = 1;
/// Of places that are read.
pub(crate) const OF_SAMPLES: u64 = 2;
/// Of rays that look for what ends walks of heat, and of points that tell how much of a sheet is bare.
pub(crate) const OF_PROBES: u64 = 3;
pub(crate) const OF_SHEETS: u64 = 4;
/// Of rows of view factors.
pub(crate) const OF_ROWS: u64 = 5;

/// A stream of numbers.
#[derive(Clone, Debug)]
pub(crate) struct Random {
    state: [u64; 4],
}

/// One output of SplitMix64, a bijection that leaves no pattern of neighbouring integers.
fn mixed(value: u64) -> u64 {
    let mut z = value;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

impl Random {
    /// The stream of that name.
    pub(crate) fn of(name: &[u64]) -> Self {
        let mut seed = name.iter().fold(GOLDEN, |seed, part| mixed(seed ^ mixed(part.wrapping_add(GOLDEN))));
        let mut word = || {
            seed = seed.wrapping_add(GOLDEN);
            mixed(seed)
        };
        Self { state: [word(), word(), word(), word()] }
    }

    /// The next number, even over [0, 1).
    #[inline]
    pub(crate) fn next(&mut self) -> f64 {
        // The upper 53 bits, as many as a number between ½ and 1 holds.
        (self.next_word() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    #[inline]
    fn next_word(&mut self) -> u64 {
        let s = &mut self.state;
        let result = s[0].wrapping_add(s[3]).rotate_left(23).wrapping_add(s[0]);
        let t = s[1] << 17;
        s[2] ^= s[0];
        s[3] ^= s[1];
        s[1] ^= s[2];
        s[0] ^= s[3];
        s[2] ^= t;
        s[3] = s[3].rotate_left(45);
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The first outputs from the state (1, 2, 3, 4), by the definition: rotl(1 + 4, 23) + 1 = 41943041, then
    /// 58720359, as the authors' program prints.
    #[test]
    fn it_is_the_generator_of_its_authors() {
        let mut random = Random { state: [1, 2, 3, 4] };
        assert_eq!([random.next_word(), random.next_word()], [41_943_041, 58_720_359]);
    }

    /// Means and correlations of neighbouring streams are those of chance: within 4 standard deviations.
    #[test]
    fn streams_of_neighbouring_names_are_independent() {
        const COUNT: u64 = 200_000;
        let draws: Vec<f64> = (0..COUNT).map(|k| Random::of(&[7, k]).next() - 0.5).collect();
        let count = COUNT as f64;
        let mean = draws.iter().sum::<f64>() / count;
        assert!(mean.abs() < 4.0 * (1.0 / 12.0 / count).sqrt(), "{mean}");
        let lagged = draws.windows(2).map(|pair| pair[0] * pair[1]).sum::<f64>() / count;
        assert!(lagged.abs() < 4.0 / 12.0 / count.sqrt(), "{lagged}");
    }
}
