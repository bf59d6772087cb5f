//! Gauss–Legendre rules without iteration, O(1) per node, for n > 100.
//!
//! √(sin θ) P_n(cos θ) solves u″ + (ν² + 1/(4 sin² θ)) u = 0 with ν = n + ½, and √y J₀(νy) solves
//! v″ + (ν² + 1/(4y²)) v = 0. A change of variable θ(y) turns one into the other if
//!
//!   θ′² (ν² + 1/(4 sin² θ)) + ½ {θ, y} = ν² + 1/(4y²),   {θ, y} = θ‴/θ′ − 3/2 (θ″/θ′)²,   θ(0) = 0
//!
//! Solving for θ = y + f₁(y)/ν² + f₂(y)/ν⁴ + f₃(y)/ν⁶ order by order,
//!
//!   f₁′ = (1/y² − 1/sin² y)/8
//!   f₂′ = −½ (f₁′² + ½ f₁′ csc² + ¼ f₁ (csc²)′ + ½ f₁‴)
//!   f₃′ = −½ (2 f₁′ f₂′ + ¼ ((2f₂′ + f₁′²) csc² + 2 f₁′ f₁ (csc²)′ + f₂ (csc²)′ + ½ f₁² (csc²)″)
//!             + ½ (f₂‴ − f₁‴ f₁′ − 3/2 f₁″²))
//!
//! all even in y and smooth on [0, π/2]; the tables hold their interpolants at Chebyshev points in y². With
//! α_k the k-th zero of J₀ and y = α_k/ν, the node number k from the right and its weight are
//!
//!   x = cos θ(y),   w = 2 sin θ · θ′(y) / (ν α_k J₁(α_k)²)
//!
//! Near the middle cos θ loses digits, so x is formed as sin φ with φ = π/2 − θ summed from small parts:
//!
//!   νφ = π/2 (n + 1 − 2k) − ε_k − ν (θ − y),   ε_k = α_k − π (k − ¼)
//!
//! ε_k and 2/(π α_k J₁²) come from a table for k ≤ 20 and from the expansions of McMahon and Hankel beyond.
//! The first term neglected, f₄/ν⁸, is below 10⁻¹⁷.
//!
//! Reference: NIST Digital Library of Mathematical Functions, 10.18.17, 10.21.19; the expansion is the one of
//! I. Bogaert, SIAM J. Sci. Comput. 36 (2014), A1008, derived independently in this form.

use core::f64::consts::{FRAC_PI_2, PI};

use super::RuleError;
use super::error::points;
use crate::math::{horner, sin_cos_octant};

/// Nodes per group: one AVX-512 register of f64, two of AVX.
const LANES: usize = 8;

/// The largest n refused: above it the neglected term f₄/ν⁸ is below 10⁻¹⁷.
const TOO_SMALL: usize = 100;

/// Writes the n-point Gauss–Legendre rule on [−1, 1], n = `nodes.len()` > 100, nodes ascending, in O(n).
///
/// Within 3 ulp for nodes and 4 ulp for weights (measured to n = 10⁶); [`legendre`](super::legendre) is
/// correctly rounded and costs O(n²). The rule is symmetric to the last bit.
///
/// # Errors
/// [`RuleError::TooSmall`] for n ≤ 100, where the expansion does not hold; [`RuleError`] if the slices are
/// empty or differ in length. They are then left as they were.
pub fn legendre_asymptotic(nodes: &mut [f64], weights: &mut [f64]) -> Result<(), RuleError> {
    let n = points(nodes, weights)?;
    if n <= TOO_SMALL {
        return Err(RuleError::TooSmall);
    }
    for first in (1..=n.div_ceil(2)).step_by(LANES) {
        let (x, w) = block(n, first);
        for l in 0..LANES.min(n.div_ceil(2) + 1 - first) {
            let k = first + l;
            (nodes[n - k], weights[n - k]) = (x[l], w[l]);
            (nodes[k - 1], weights[k - 1]) = (-x[l], w[l]);
        }
    }
    if n % 2 == 1 {
        nodes[n / 2] = 0.0;
    }
    Ok(())
}

/// Nodes and weights number `first` … `first` + 7 from the right.
#[inline]
fn block(n: usize, first: usize) -> ([f64; LANES], [f64; LANES]) {
    let (shift, amplitude) = zeros(first);
    let nu = n as f64 + 0.5;
    let (e, step) = (1.0 / (nu * nu), PI / nu);
    let (mut x, mut w) = ([0.0; LANES], [0.0; LANES]);
    for l in 0..LANES {
        let k = (first + l) as f64;
        let y = (PI * (k - 0.25) + shift[l]) / nu;
        let q = y * y;
        let bend = y * e * (horner(q, &BEND) + e * (horner(q, &BEND_2) + e * horner(q, &BEND_3)));
        let slope = e * (horner(q, &SLOPE) + e * (horner(q, &SLOPE_2) + e * horner(q, &SLOPE_3)));
        let phi = (FRAC_PI_2 * ((n + 1) as f64 - 2.0 * k) - shift[l]) / nu - bend;
        let theta = y + bend;
        // Of the two angles the smaller one is at most π/4: its sine is relatively, its cosine absolutely
        // exact.
        let (sin, cos) = sin_cos_octant(if theta < phi { theta } else { phi });
        x[l] = if theta < phi { cos } else { sin };
        let height = if theta < phi { sin } else { cos };
        w[l] = step * (amplitude[l] * (height + height * slope));
    }
    (x, w)
}

/// ε_k and 2/(π α_k J₁(α_k)²) for k = `first` … `first` + 7.
#[inline]
fn zeros(first: usize) -> ([f64; LANES], [f64; LANES]) {
    let (mut shift, mut amplitude) = ([0.0; LANES], [0.0; LANES]);
    for l in 0..LANES {
        let b = PI * ((first + l) as f64 - 0.25);
        let u = 0.125 / b;
        shift[l] = u * horner(u * u, &MCMAHON);
        let t = 0.5 / (b + shift[l]);
        amplitude[l] = horner(t * t, &HANKEL);
    }
    for l in 0..(SHIFT.len() + 1).saturating_sub(first).min(LANES) {
        (shift[l], amplitude[l]) = (SHIFT[first - 1 + l], AMPLITUDE[first - 1 + l]);
    }
    (shift, amplitude)
}

/// Σ c_k/(2k + 1) qᵏ = 1/y ∫₀ʸ Σ c_k y²ᵏ dy.
const fn integrated<const N: usize>(c: &[f64; N]) -> [f64; N] {
    let mut out = *c;
    let mut k = 0;
    while k < N {
        out[k] /= (2 * k + 1) as f64;
        k += 1;
    }
    out
}

/// f₁′ as a polynomial in y², to 5 · 10⁻¹³ on [0, π/2].
const SLOPE: [f64; 11] = [
    -0.041666666667021963,
    -0.008333333298568963,
    -0.0013227518824510242,
    -0.00018518168809768097,
    -2.4061164508122472e-05,
    -2.9555068205600583e-06,
    -3.796830485573135e-07,
    -2.482453556515277e-08,
    -1.2359843111414903e-08,
    1.470355570113358e-09,
    -3.247914293990365e-10,
];

/// f₂′, to 1.54e-9.
const SLOPE_2: [f64; 9] = [
    0.00815972328982875,
    0.005968845476330586,
    0.001965583449761955,
    0.0004606209374294916,
    9.698438497573111e-05,
    8.953295982840707e-06,
    6.892771882960126e-06,
    -1.153994275019387e-06,
    3.0878827235505533e-07,
];

/// f₃′, to 2.09e-6.
const SLOPE_3: [f64; 7] = [
    -0.004161433220072501,
    -0.006488852059369589,
    -0.004025318818474274,
    -0.0005649476672519516,
    -0.0011911841652675495,
    0.00034208675401207057,
    -0.00011338109363260189,
];

/// f₁/y, f₂/y, f₃/y.
const BEND: [f64; 11] = integrated(&SLOPE);
const BEND_2: [f64; 9] = integrated(&SLOPE_2);
const BEND_3: [f64; 7] = integrated(&SLOPE_3);

/// ε_k = u Σ `MCMAHON[j]` u²ʲ, u = 1/(8π (k − ¼)).
const MCMAHON: [f64; 5] =
    [1.0, -124.0 / 3.0, 120_928.0 / 15.0, -401_743_168.0 / 105.0, 1_071_187_749_376.0 / 315.0];

/// 2/(π α J₁²) = Σ `HANKEL[j]` t²ʲ, t = 1/(2α).
const HANKEL: [f64; 5] = [1.0, -0.5, 27.0 / 8.0, -3_375.0 / 48.0, 1_157_625.0 / 384.0];

/// ε_k for k = 1 … 20.
const SHIFT: [f64; 20] = [
    0.04863106750342784,
    0.022290966504172484,
    0.014348115539080811,
    0.010561988052556969,
    0.008352603936268065,
    0.006906209769611422,
    0.005886218148154599,
    0.005128465428405139,
    0.004543413129563959,
    0.004078095931491043,
    0.003699187483291371,
    0.003384673983973428,
    0.0031194313583755044,
    0.0028927263170733285,
    0.0026967312123637515,
    0.0025256033585736677,
    0.002374893485959285,
    0.002241153801149329,
    0.0021216712723189117,
    0.0020142818287534232,
];

/// 2/(π α_k J₁(α_k)²) for k = 1 … 20.
const AMPLITUDE: [f64; 20] = [
    0.9822341167218512,
    0.9960951712438778,
    0.9983661220823558,
    0.9991115104807028,
    0.9994434412453226,
    0.9996191732821179,
    0.9997232113735499,
    0.9997898172483115,
    0.9998349989971023,
    0.9998670439582881,
    0.9998905896964102,
    0.9999083950665696,
    0.9999221843802547,
    0.9999330801564748,
    0.999941838566334,
    0.9999489840430771,
    0.9999548895439108,
    0.9999598261634557,
    0.9999639947771563,
    0.9999675467847976,
];
