//! W(x) of a part of a surface of revolution that carries a constant, by its outline
//! ([`crate::irradiance::swept`]).

use radiosity_elements::patch::Node;

use crate::irradiance::swept::Swept;

/// Kernel values that take as long: two generators and two arcs, about 400 ns.
const COST: u64 = 40;

/// The inner element.
pub(super) struct SweptPart<'a> {
    swept: &'a Swept,
    /// Value of its polynomial.
    constant: f64,
}

impl<'a> SweptPart<'a> {
    pub(super) fn new(swept: &'a Swept, constant: f64) -> Self {
        Self { swept, constant }
    }

    pub(super) fn is_seen_from(&self, x: &Node) -> bool {
        self.swept.irradiance(x.position, x.normal) > 0.0
    }

    /// Adds W(x) to `out`; returns the number of evaluations.
    pub(super) fn seen_from(&self, x: &Node, out: &mut [f64]) -> u64 {
        out[0] += self.constant * self.swept.irradiance(x.position, x.normal);
        COST
    }
}
