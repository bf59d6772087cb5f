//! Jacobi polynomials and Gauss rules in fixed point with 320 binary digits, for any float exponents.
//!
//! Independent of the crate: big integers, the textbook recurrence, Newton's method, and the weight from its
//! definition μ₀ γ₁ … γ_{n−1} / (π_n′ π_{n−1}).

use std::ops::{Add, Div, Mul, Neg, Sub};

use num_bigint::BigInt;

const BITS: u32 = 320;

/// An integer times 2⁻³²⁰.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub struct Fixed(BigInt);

impl Fixed {
    /// The number of an integer.
    pub fn new(v: i64) -> Fixed {
        Fixed(BigInt::from(v) << BITS)
    }

    /// A float, exactly as long as its last bit is at least 2⁻³²⁰.
    pub fn float(v: f64) -> Fixed {
        assert!(v.is_finite());
        let bits = v.to_bits();
        let exponent = ((bits >> 52) & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) | if exponent == 0 { 0 } else { 1 << 52 };
        let shift = exponent.max(1) - 1075 + BITS as i32;
        let magnitude = BigInt::from(fraction);
        let magnitude = if shift < 0 { magnitude >> -shift } else { magnitude << shift };
        Fixed(if v < 0.0 { -magnitude } else { magnitude })
    }

    /// A decimal like "-0.125".
    pub fn decimal(text: &str) -> Fixed {
        let (mantissa, exponent) = text.split_once('e').unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let digits: BigInt = format!("{whole}{fraction}").parse().expect("a decimal");
        let exponent = exponent.parse::<i32>().expect("an exponent") - fraction.len() as i32;
        let power = BigInt::from(10).pow(exponent.unsigned_abs());
        Fixed(if exponent < 0 { (digits << BITS) / power } else { (digits * power) << BITS })
    }

    /// The nearest float, up to one unit in its last place.
    pub fn to_f64(&self) -> f64 {
        let excess = self.0.bits() as i64 - 64;
        let (short, shift) = if excess > 0 { (&self.0 >> excess, excess) } else { (self.0.clone(), 0) };
        let magnitude = i128::try_from(short).expect("64 bits and a sign") as f64;
        magnitude * 2.0f64.powi(shift as i32 - BITS as i32)
    }

    /// The distance from a float to this number in units of the last place of the number.
    pub fn ulps(&self, v: f64) -> f64 {
        let size = self.to_f64().abs();
        let ulp = size.next_up() - size;
        (Fixed::float(v) - self.clone()).to_f64().abs() / ulp
    }

    /// self · above/below, rounded towards 0.
    pub fn times(&self, above: i64, below: i64) -> Fixed {
        Fixed(&self.0 * above / below)
    }

    /// The absolute value.
    pub fn abs(&self) -> Fixed {
        if self.0 < BigInt::ZERO { -self.clone() } else { self.clone() }
    }

    /// √self, rounded down.
    pub fn sqrt(&self) -> Fixed {
        Fixed((&self.0 << BITS).sqrt())
    }

    fn is_zero(&self) -> bool {
        self.0 == BigInt::ZERO
    }
}

impl Add for Fixed {
    type Output = Fixed;
    fn add(self, b: Fixed) -> Fixed {
        Fixed(self.0 + b.0)
    }
}

impl Sub for Fixed {
    type Output = Fixed;
    fn sub(self, b: Fixed) -> Fixed {
        Fixed(self.0 - b.0)
    }
}

impl Neg for Fixed {
    type Output = Fixed;
    fn neg(self) -> Fixed {
        Fixed(-self.0)
    }
}

impl Mul<&Fixed> for &Fixed {
    type Output = Fixed;
    fn mul(self, b: &Fixed) -> Fixed {
        Fixed((&self.0 * &b.0) >> BITS)
    }
}

impl Div<&Fixed> for &Fixed {
    type Output = Fixed;
    fn div(self, b: &Fixed) -> Fixed {
        Fixed((&self.0 << BITS) / &b.0)
    }
}

/// π_{k+1} = (x − δ_k) π_k − γ_k π_{k−1}, tabulated for k ≤ n and scaled by 2ᵏ.
pub struct Oracle {
    delta: Vec<Fixed>,
    gamma: Vec<Fixed>,
}

/// The last polynomials at a point x.
struct Evaluated {
    /// 2ᵏ π_k(x), k the degree.
    value: Fixed,
    /// 2ᵏ π_k(x), k one less.
    before: Fixed,
    /// Derivative of the first.
    slope: Fixed,
}

impl Oracle {
    /// The rule of n nodes for the weight (1 − x)^α (1 + x)^β.
    pub fn new(alpha: f64, beta: f64, n: usize) -> Oracle {
        let (a, b) = (Fixed::float(alpha), Fixed::float(beta));
        let delta = (0..=n).map(|k| delta(&a, &b, k as i64)).collect();
        let gamma = (0..=n).map(|k| gamma(&a, &b, k as i64)).collect();
        Oracle { delta, gamma }
    }

    fn degree(&self) -> usize {
        self.delta.len() - 1
    }

    fn evaluate(&self, x: &Fixed) -> Evaluated {
        let two = Fixed::new(2);
        let (mut before, mut last) = (Fixed::new(0), Fixed::new(1));
        let (mut slope_before, mut slope) = (Fixed::new(0), Fixed::new(0));
        for k in 0..self.degree() {
            let factor = &two * &(x.clone() - self.delta[k].clone());
            let back = &Fixed::new(4) * &self.gamma[k];
            let next = &factor * &last - &back * &before;
            let slope_next = &two * &last + &factor * &slope - &back * &slope_before;
            (before, last) = (last, next);
            (slope_before, slope) = (slope, slope_next);
        }
        Evaluated { value: last, before, slope }
    }

    /// The root of π_n next to a float and its weight, as a share of μ₀.
    pub fn root(&self, near: f64) -> (Fixed, Fixed) {
        let mut x = Fixed::float(near);
        for _ in 0..4 {
            let Evaluated { value, slope, .. } = self.evaluate(&x);
            if value.is_zero() {
                break;
            }
            x = x - &value / &slope;
        }
        let Evaluated { before, slope, .. } = self.evaluate(&x);
        let norm = self.gamma[1..self.degree()]
            .iter()
            .fold(Fixed::new(2), |norm, gamma| &(&norm * gamma) * &Fixed::new(4));
        (x, &(&norm / &slope) / &before)
    }

    /// 2ᵏ π_k(x) for the highest k.
    pub fn value(&self, x: &Fixed) -> Fixed {
        self.evaluate(x).value
    }

    /// ‖2ᵏ π_k‖²/μ₀ for the highest k.
    pub fn squared_norm(&self) -> Fixed {
        self.gamma[1..].iter().fold(Fixed::new(1), |norm, gamma| &(&norm * gamma) * &Fixed::new(4))
    }
}

/// μ₀ = ½ (F(p, q) + F(q, p)) with p = α + 1, q = β + 1, F(p, q) = 1/p · Σ Π_{j=1…k} (p + q + j − 1)/(2
/// (p + j)).
pub fn integral(alpha: f64, beta: f64) -> Fixed {
    let (p, q) = (Fixed::float(alpha) + Fixed::new(1), Fixed::float(beta) + Fixed::new(1));
    let half = |p: &Fixed| {
        let (mut sum, mut term, mut j) = (Fixed::new(1), Fixed::new(1), 1);
        while !term.is_zero() {
            let above = Fixed::float(alpha) + Fixed::float(beta) + Fixed::new(j + 1);
            let below = &Fixed::new(2) * &(p.clone() + Fixed::new(j));
            term = &(&term * &above) / &below;
            sum = sum + term.clone();
            j += 1;
        }
        &sum / p
    };
    &(half(&p) + half(&q)) / &Fixed::new(2)
}

/// (β² − α²)/(s (s + 2)), s = 2k + α + β; the mean of the weight for k = 0.
fn delta(a: &Fixed, b: &Fixed, k: i64) -> Fixed {
    let s = Fixed::new(2 * k) + a.clone() + b.clone();
    if k == 0 {
        return &(b.clone() - a.clone()) / &(s + Fixed::new(2));
    }
    &(b * b - a * a) / &(&s * &(s.clone() + Fixed::new(2)))
}

/// 4k (k + α)(k + β)(k + α + β)/(s² (s + 1)(s − 1)); the variance of the weight for k = 1.
fn gamma(a: &Fixed, b: &Fixed, k: i64) -> Fixed {
    let one = Fixed::new(1);
    let s = Fixed::new(2 * k) + a.clone() + b.clone();
    if k == 0 {
        return Fixed::new(0);
    }
    if k == 1 {
        let above = &(&(a.clone() + one.clone()) * &(b.clone() + one.clone())) * &Fixed::new(4);
        return &above / &(&(&s * &s) * &(s.clone() + one));
    }
    let whole = Fixed::new(k);
    let left = &(&whole * &(whole.clone() + a.clone())) * &Fixed::new(4);
    let right = &(whole.clone() + b.clone()) * &(whole + a.clone() + b.clone());
    let below = &(&s * &s) * &(&s * &s - one);
    &(&left * &right) / &below
}
