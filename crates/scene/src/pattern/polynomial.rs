//! Polynomials in the parameters of a surface.

/// Polynomial Σ c_ij u^i v^j of one band in the parameters of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Polynomial(Vec<Term>);

/// Term c u^i v^j of a polynomial.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// Power i of u.
    pub u: u32,
    /// Power j of v.
    pub v: u32,
    /// Factor c.
    pub factor: f64,
}

impl Polynomial {
    /// The sum of these terms.
    pub fn new(terms: impl IntoIterator<Item = Term>) -> Self {
        Self(terms.into_iter().collect())
    }

    /// Its terms.
    pub(super) fn terms(&self) -> &[Term] {
        &self.0
    }

    /// Its value at (u, v).
    pub(super) fn at(&self, [u, v]: [f64; 2]) -> f64 {
        self.0.iter().map(|term| term.factor * u.powi(term.u as i32) * v.powi(term.v as i32)).sum()
    }

    /// Total degree: the largest i + j of a term.
    pub(super) fn degree(&self) -> u32 {
        self.0.iter().map(|term| term.u + term.v).max().unwrap_or(0)
    }

    /// Its mean over [−1, 1]², by ½ ∫ u^i du = 1/(i + 1) for even i, and 0 for odd i.
    pub(super) fn mean(&self) -> f64 {
        let half = |power: u32| if power.is_multiple_of(2) { 1.0 / f64::from(power + 1) } else { 0.0 };
        self.0.iter().map(|term| term.factor * half(term.u) * half(term.v)).sum()
    }

    /// The polynomial times `factor`.
    #[must_use]
    pub fn times(&self, factor: f64) -> Self {
        Self::new(self.0.iter().map(|term| Term { factor: factor * term.factor, ..*term }))
    }
}
