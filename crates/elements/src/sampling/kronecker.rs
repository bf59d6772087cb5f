//! Points spread evenly over [0, 1]ᴰ: a Kronecker sequence.
//!
//! ```text
//! z_m = fract(½ + m a) ,     a_d = g⁻ᵈ ,   g^(D + 1) = g + 1 .
//! ```
//!
//! Reference: M. Roberts, *The unreasonable effectiveness of quasirandom sequences* (2018): generalised
//! golden ratio.

/// Roots g of g^(D + 1) = g + 1 for D = 1, …, 8.
const ROOTS: [f64; 8] = [
    1.618_033_988_749_895,
    1.324_717_957_244_746,
    1.220_744_084_605_759_6,
    1.167_303_978_261_418_7,
    1.134_724_138_401_519_4,
    1.112_775_684_278_705_5,
    1.096_981_557_798_559_8,
    1.085_070_245_491_451,
];

/// Point number `index` of the sequence in D = 1 to 8 dimensions.
pub fn point<const D: usize>(index: u64) -> [f64; D] {
    let at = index as f64;
    const { steps::<D>() }.map(|step| {
        let place = 0.5 + at * step;
        // Its fraction; `fract` calls a function of the library.
        place - (place as i64) as f64
    })
}

/// Steps a_d of the dimensions.
const fn steps<const D: usize>() -> [f64; D] {
    let (mut steps, mut d) = ([1.0 / ROOTS[D - 1]; D], 1);
    while d < D {
        steps[d] = steps[d - 1] / ROOTS[D - 1];
        d += 1;
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_are_roots() {
        for (k, g) in ROOTS.iter().enumerate() {
            assert!((g.powi(k as i32 + 2) - g - 1.0).abs() < 1e-14, "{g}");
        }
    }

    /// ∫ x y over the unit square and ∫ x y z over the cube.
    #[test]
    fn means_converge_like_one_over_the_number_of_points() {
        for n in [1_000, 10_000, 100_000] {
            let mean = |f: &dyn Fn(u64) -> f64| (0..n).map(f).sum::<f64>() / n as f64;
            let square = mean(&|k| point::<2>(k).iter().product());
            let cube = mean(&|k| point::<3>(k).iter().product());
            assert!((square - 0.25).abs() < 3.0 / n as f64, "{square}");
            assert!((cube - 0.125).abs() < 30.0 / n as f64, "{cube}");
        }
    }
}
