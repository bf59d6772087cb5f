//! Double-double numbers: unevaluated sums hi + lo of two floats, about 31 digits.
//!
//! Error-free transformations, in round-to-nearest and without overflow:
//!
//!   two_sum:   a + b = s + e exactly, six operations (Knuth)
//!   split:     a = h + l exactly, h and l of at most 26 bits (Veltkamp)
//!   two_prod:  a · b = p + e exactly, from the split parts (Dekker)
//!
//! Fused multiply-add is deliberately absent: without std it is a library call, and on a target without the
//! instruction it is slower than the seventeen operations here. Everything is `const`, so tables made by the
//! compiler and numbers made at run time are the same bits. Range: |a| < 2⁹⁹⁶ (split multiplies by 2²⁷ + 1).
//!
//! Reference: T. J. Dekker, "A floating-point technique for extending the available precision",
//! Numer. Math. 18 (1971); relative errors below 8 · 2⁻¹⁰⁶ per operation.

/// hi + lo with |lo| ≤ ulp(hi)/2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Double {
    pub(crate) hi: f64,
    pub(crate) lo: f64,
}

/// (s, e) with s = fl(a + b) and s + e = a + b.
#[inline(always)]
pub(crate) const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let v = s - a;
    (s, (a - (s - v)) + (b - v))
}

/// (h, l), both of at most 26 bits, with h + l = a.
#[inline(always)]
pub(crate) const fn split(a: f64) -> (f64, f64) {
    let t = 134_217_729.0 * a;
    let h = t - (t - a);
    (h, a - h)
}

/// ab − p for p = fl(ab), exactly, from the split factors.
#[inline(always)]
pub(crate) const fn product_error(p: f64, a: (f64, f64), b: (f64, f64)) -> f64 {
    ((a.0 * b.0 - p) + a.0 * b.1 + a.1 * b.0) + a.1 * b.1
}

impl Double {
    pub(crate) const ZERO: Double = Double::new(0.0);
    pub(crate) const ONE: Double = Double::new(1.0);

    /// The float a.
    #[inline(always)]
    pub(crate) const fn new(a: f64) -> Double {
        Double { hi: a, lo: 0.0 }
    }

    /// a + b of two floats, exactly.
    #[inline(always)]
    pub(crate) const fn sum(a: f64, b: f64) -> Double {
        let (hi, lo) = two_sum(a, b);
        Double { hi, lo }
    }

    /// a · b of two floats, exactly.
    #[inline(always)]
    pub(crate) const fn product(a: f64, b: f64) -> Double {
        let hi = a * b;
        Double { hi, lo: product_error(hi, split(a), split(b)) }
    }

    /// a / b of two floats.
    #[inline(always)]
    pub(crate) const fn ratio(a: f64, b: f64) -> Double {
        let hi = a / b;
        let back = Double::product(hi, b);
        Double::renormalised(hi, ((a - back.hi) - back.lo) / b)
    }

    /// hi + lo of two floats with |lo| < |hi|.
    #[inline(always)]
    pub(crate) const fn renormalised(hi: f64, lo: f64) -> Double {
        let s = hi + lo;
        Double { hi: s, lo: lo - (s - hi) }
    }

    #[inline(always)]
    pub(crate) const fn add(self, b: Double) -> Double {
        let (s, e) = two_sum(self.hi, b.hi);
        let (t, f) = two_sum(self.lo, b.lo);
        let c = Double::renormalised(s, e + t);
        Double::renormalised(c.hi, c.lo + f)
    }

    #[inline(always)]
    pub(crate) const fn sub(self, b: Double) -> Double {
        self.add(b.neg())
    }

    #[inline(always)]
    pub(crate) const fn neg(self) -> Double {
        Double { hi: -self.hi, lo: -self.lo }
    }

    #[inline(always)]
    pub(crate) const fn mul(self, b: Double) -> Double {
        let p = Double::product(self.hi, b.hi);
        Double::renormalised(p.hi, p.lo + (self.hi * b.lo + self.lo * b.hi))
    }

    /// self · b for a power of two b: exact.
    #[inline(always)]
    pub(crate) const fn scale(self, b: f64) -> Double {
        Double { hi: self.hi * b, lo: self.lo * b }
    }

    #[inline(always)]
    pub(crate) const fn div(self, b: Double) -> Double {
        let q = self.hi / b.hi;
        let r = self.sub(b.mul(Double::new(q)));
        Double::renormalised(q, (r.hi + r.lo) / b.hi)
    }

    /// √self, for a positive normal float hi.
    #[inline(always)]
    pub(crate) const fn sqrt(self) -> Double {
        if self.hi == 0.0 {
            return self;
        }
        let s = heron(self.hi, heron(self.hi, rough_sqrt(self.hi)));
        let square = Double::product(s, s);
        Double::renormalised(s, self.sub(square).hi / (2.0 * s))
    }
}

/// √v for v = 0 or positive and normal, to 10⁻⁶: half the exponent and two steps of Heron.
#[inline(always)]
pub(crate) const fn rough_sqrt(v: f64) -> f64 {
    heron(v, heron(v, f64::from_bits((v.to_bits() >> 1) + 0x1FF7_A3BE_0000_0000)))
}

/// One step of Heron from s towards √v.
#[inline(always)]
const fn heron(v: f64, s: f64) -> f64 {
    0.5 * (s + v / s)
}
