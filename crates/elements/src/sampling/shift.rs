//! Shifts that make many sequences of one: z ↦ fract(z + shift).
//!
//! Shifted by independent numbers, evenly distributed in [0, 1)ᴰ, a sequence gives independent estimates
//! without bias (R. Cranley, T. Patterson, SIAM J. Numer. Anal. 13 (1976) 904-914).

/// Numbers in [0, 1) that belong to `number`.
pub fn shift<const D: usize>(number: u64) -> [f64; D] {
    std::array::from_fn(|k| {
        (hash(number.wrapping_mul(4).wrapping_add(k as u64)) >> 11) as f64 / (1u64 << 53) as f64
    })
}

/// z + shift modulo 1, of numbers in [0, 1).
pub fn shifted<const D: usize>(mut z: [f64; D], shift: &[f64; D]) -> [f64; D] {
    for (z, shift) in z.iter_mut().zip(shift) {
        *z += shift;
        *z -= if *z >= 1.0 { 1.0 } else { 0.0 };
    }
    z
}

/// A number that depends on all bits of these numbers.
pub fn number_of(values: impl IntoIterator<Item = f64>) -> u64 {
    values.into_iter().fold(0, |number, value| hash(number ^ value.to_bits()))
}

/// SplitMix64: G. Steele, D. Lea, C. Flood, *Fast splittable pseudorandom number generators*, OOPSLA 2014.
fn hash(value: u64) -> u64 {
    let z = value.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}
