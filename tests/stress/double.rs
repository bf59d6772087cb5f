//! Double-double numbers hi + lo, about 31 digits, with the functions that closed forms need.
//!
//! ```text
//! two_sum:  a + b = s + e exactly (Knuth),      two_prod:  a · b = p + e exactly, e = fma(a, b, −p) (Dekker)
//! ln x = y + z − z²/2 + z³/3 ,  z = x e⁻ʸ − 1 ,   y the float next to ln x
//! ∠(x, y) = θ + atan t ,        t = (y cos θ − x sin θ)/(x cos θ + y sin θ) ,   θ the float next to it
//! ```
//!
//! Exponentials, sines and cosines are sums of their series. Nothing here is shared with the library.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// Terms of a series for an argument up to π.
const TERMS: i32 = 48;

/// hi + lo with |lo| ≤ ulp(hi)/2.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Double {
    hi: f64,
    lo: f64,
}

impl From<f64> for Double {
    fn from(hi: f64) -> Self {
        Self { hi, lo: 0.0 }
    }
}

impl Add for Double {
    type Output = Self;
    fn add(self, b: Self) -> Self {
        let (s, e) = two_sum(self.hi, b.hi);
        let (t, f) = two_sum(self.lo, b.lo);
        let first = Self::of(s, e + t);
        Self::of(first.hi, first.lo + f)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, b: Self) -> Self {
        self + -b
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, b: Self) -> Self {
        let p = self.hi * b.hi;
        Self::of(p, self.hi.mul_add(b.hi, -p) + (self.hi * b.lo + self.lo * b.hi))
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, b: Self) -> Self {
        let first = Self::from(self.hi / b.hi);
        let rest = self - b * first;
        let second = Self::from(rest.hi / b.hi);
        first + second + Self::from((rest - b * second).hi / b.hi)
    }
}

/// (s, e) with s = fl(a + b) and s + e = a + b.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let v = s - a;
    (s, (a - (s - v)) + (b - v))
}

impl Double {
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };
    pub(crate) const ONE: Self = Self { hi: 1.0, lo: 0.0 };
    pub(crate) const PI: Self = Self { hi: std::f64::consts::PI, lo: 1.224_646_799_147_353_2e-16 };

    /// hi + lo, |lo| ≤ |hi|.
    fn of(hi: f64, lo: f64) -> Self {
        let s = hi + lo;
        Self { hi: s, lo: lo - (s - hi) }
    }

    /// The quotient of two whole numbers.
    pub(crate) fn ratio(above: i32, below: i32) -> Self {
        Self::from(f64::from(above)) / Self::from(f64::from(below))
    }

    pub(crate) fn to_f64(self) -> f64 {
        self.hi
    }

    pub(crate) fn abs(self) -> Self {
        if self.hi < 0.0 { -self } else { self }
    }

    pub(crate) fn sqrt(self) -> Self {
        if self.hi == 0.0 {
            return self;
        }
        let s = Self::from(self.hi.sqrt());
        let s = s + (self - s * s) / (s + s);
        s + (self - s * s) / (s + s)
    }

    fn exp(self) -> Self {
        let small = self * Self::from(2f64.powi(-8));
        let (mut sum, mut term) = (Self::ONE, Self::ONE);
        for k in 1..TERMS {
            term = term * small / Self::from(f64::from(k));
            sum = sum + term;
        }
        (0..8).fold(sum, |power, _| power * power)
    }

    /// ln(1 + self), for self > −1; keeps its digits where self is small.
    pub(crate) fn ln_1p(self) -> Self {
        if self.hi.abs() > 1e-2 {
            return (Self::ONE + self).ln();
        }
        // 2 artanh(z/(2 + z)).
        let t = self / (self + Self::from(2.0));
        let (mut sum, mut power) = (Self::ZERO, t + t);
        for k in 0..12 {
            sum = sum + power * Self::ratio(1, 2 * k + 1);
            power = power * t * t;
        }
        sum
    }

    /// ln self, for self > 0.
    pub(crate) fn ln(self) -> Self {
        let near = Self::from(self.hi.ln());
        let z = self * (-near).exp() - Self::ONE;
        near + z - z * z * Self::from(0.5) + z * z * z * Self::ratio(1, 3)
    }

    /// (sin, cos) of a float in [−π, π].
    fn sin_cos(angle: f64) -> (Self, Self) {
        let x = Self::from(angle);
        let mut sums = [Self::ONE, x];
        let mut term = x;
        for k in 2..TERMS {
            term = term * x / Self::from(f64::from(k));
            let signed = if k % 4 < 2 { term } else { -term };
            sums[k as usize % 2] = sums[k as usize % 2] + signed;
        }
        (sums[1], sums[0])
    }

    /// The angle of (x, self) against the axis x, in [−π, π].
    pub(crate) fn atan2(self, x: Self) -> Self {
        let near = self.hi.atan2(x.hi);
        let (sin, cos) = Self::sin_cos(near);
        let t = (self * cos - x * sin) / (x * cos + self * sin);
        Self::from(near) + t - t * t * t * Self::ratio(1, 3)
    }

    pub(crate) fn atan(self) -> Self {
        self.atan2(Self::ONE)
    }
}

#[test]
fn known_constants_have_thirty_digits() {
    let close = |a: Double, b: Double| assert!((a - b).to_f64().abs() < 1e-29, "{a:?} {b:?}");
    // ln 2 and √2 as sums of two floats: their decimals rounded, and what is left of them.
    close(Double::from(2.0).ln(), Double { hi: std::f64::consts::LN_2, lo: 2.319_046_813_846_299_6e-17 });
    close(Double::from(2.0).sqrt(), Double { hi: std::f64::consts::SQRT_2, lo: -9.667_293_313_452_913e-17 });
    close(Double::ONE.atan() * Double::from(4.0), Double::PI);
    close(Double::ZERO.atan2(-Double::ONE), Double::PI);
    // Machin: π = 16 atan(1/5) − 4 atan(1/239).
    let machin =
        Double::from(16.0) * Double::ratio(1, 5).atan() - Double::from(4.0) * Double::ratio(1, 239).atan();
    close(machin, Double::PI);
    close(Double::from(1e-9).ln_1p(), (Double::ONE + Double::from(1e-9)).ln());
    close((Double::from(3.0).ln() + Double::from(7.0).ln()) - Double::from(21.0).ln(), Double::ZERO);
}
