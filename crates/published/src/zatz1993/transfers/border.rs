//! The common edge of two patches.

use radiosity_elements::patch::Patch;
use radiosity_geom::{COINCIDENT, DVec3};

use crate::zatz1993::transfers::axis::Axis;

/// One side of the parameter square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Border {
    /// The parameter that is constant on it: 0 is s, 1 is t.
    fixed: usize,
    /// Whether it is constant at +1, not at −1.
    high: bool,
}

impl Border {
    /// The sides t = −1, t = 1, s = −1, s = 1.
    const ALL: [Self; 4] = [
        Self { fixed: 1, high: false },
        Self { fixed: 1, high: true },
        Self { fixed: 0, high: false },
        Self { fixed: 0, high: true },
    ];

    /// Exponents (α, β) of the weight that vanishes doubly on the side.
    pub(super) fn double_zero(self) -> [u8; 2] {
        if self.high { [2, 0] } else { [0, 2] }
    }

    /// The axes of the first and of the second parameter, given those along and across the side.
    pub(super) fn placed(self, along: Axis, across: Axis) -> [Axis; 2] {
        if self.fixed == 1 { [along, across] } else { [across, along] }
    }

    /// Start, middle and end of the side.
    fn points(self, patch: &Patch) -> [DVec3; 3] {
        let fixed = f64::from(u8::from(self.high));
        [0.0, 0.5, 1.0].map(|x| {
            let (s, t) = if self.fixed == 1 { (x, fixed) } else { (fixed, x) };
            patch.node(s, t).position
        })
    }
}

/// The sides of `p` and `q` that are one edge in space, in either direction and at equal speed; None without
/// such sides. A side that is collapsed to a point is no edge.
pub(super) fn common(p: &Patch, q: &Patch) -> Option<[Border; 2]> {
    let corners = [p.corners(), q.corners()].concat();
    let size = corners.iter().map(|c| c.distance(corners[0])).fold(0.0, f64::max);
    let coincide = |x: DVec3, y: DVec3| x.distance(y) <= COINCIDENT * size;
    let pairs = Border::ALL.iter().flat_map(|a| Border::ALL.iter().map(move |b| [*a, *b]));
    pairs.into_iter().find(|[a, b]| {
        let ([start, middle, end], theirs) = (a.points(p), b.points(q));
        let meets = |[x, y, z]: [DVec3; 3]| coincide(start, x) && coincide(middle, y) && coincide(end, z);
        let [x, y, z] = theirs;
        !coincide(start, middle) && (meets([x, y, z]) || meets([z, y, x]))
    })
}
