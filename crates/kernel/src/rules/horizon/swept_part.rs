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
    /// Whether the outer patch lies before it, so that what it has in common with it is a contact.
    is_before: bool,
}

impl<'a> SweptPart<'a> {
    /// `outer` are points of the outer patch.
    pub(super) fn new(swept: &'a Swept, constant: f64, outer: &[Node]) -> Self {
        let is_before = outer.iter().any(|x| swept.is_before(x.position));
        Self { swept, constant, is_before }
    }

    pub(super) fn is_seen_from(&self, x: &Node) -> bool {
        self.irradiance(x) > 0.0
    }

    fn irradiance(&self, x: &Node) -> f64 {
        match self.is_before {
            true => self.swept.irradiance_of_touching(x.position, x.normal),
            false => self.swept.irradiance(x.position, x.normal),
        }
    }

    /// Adds W(x) to `out`; returns the number of evaluations.
    pub(super) fn seen_from(&self, x: &Node, out: &mut [f64]) -> u64 {
        out[0] += self.constant * self.irradiance(x);
        COST
    }
}
