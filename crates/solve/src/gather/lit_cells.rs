//! Direct light where rays end, in the mean over small cells of elements: each is computed when a ray first ends there,
//! and kept.
//!
//! Of many readings most rays end where others did. One ray to an emitter from each end tells its direct light with an
//! error as large as the light, which many rays average as slowly as chance does; the mean over a cell is known to a
//! few percent, and what a receiver sees of such errors is their mean over hundreds of cells.
//!
//! ```text
//! D_c = 1/n Σ_k E₀(z_k) V κ(y_k, z_k)/q(z_k) ,     y_k in the cell, z_k on the emitters        W m⁻² .
//! ```
//!
//! Range of use. Cells are squares of a part of the scene's diagonal, cut out of each element; they count from afar
//! alone, where what is within a cell makes hardly a difference but for a wall that stands in it, and not beside
//! luminaires, whose light has peaks there.

use std::sync::OnceLock;

use radiosity_elements::sampling::kronecker;
use radiosity_elements::sampling::shift::{number_of, shift, shifted};
use radiosity_light::receiver_point::ReceiverPoint;

use crate::gather::sent_rays::{LampLight, NEAR, SentRays};
use crate::solution::{Solution, SurfacePlace};

/// Side of a cell over the diagonal of the scene. Chosen.
const SIDE: f64 = 0.01;

/// Most cells along a side of an element: a bound of memory. Chosen.
const MOST: usize = 256;

/// Sides of a cell from which its mean is taken. Measured in an office of 430 surfaces, 2 × 2 cells each, beside walks:
/// with 4 and 2 its grid erred by .74 and .76 % (L2), in 8.0 and 7.4 s.
const AFAR: f64 = 2.0;

/// Points of a cell from which rays are sent. Chosen: with as many a cell is known to a few percent.
const POINTS: u64 = 32;

/// Sides of a cell within which a luminaire lights it too unevenly for its points. Measured in a room of 14 m with a
/// luminaire 2 cm off a wall, 0.15 sides: the other walls were 12 % too dark.
const PEAK: f64 = 2.0;

/// Direct light by cells.
#[derive(Debug)]
pub(super) struct LitCells {
    /// Side of a cell (scene length).
    side: f64,
    /// About the rays by which all cells are computed.
    rays: f64,
    elements: Vec<OnceLock<LitElement>>,
}

/// The cells of an element.
#[derive(Debug)]
struct LitElement {
    counts: [usize; 2],
    /// Irradiance per band (W m⁻²); None where no point of a cell was found.
    cells: Vec<OnceLock<Option<Vec<f64>>>>,
}

impl LitCells {
    /// The cells of all elements, of which none is computed.
    pub(super) fn of(rays: &SentRays) -> Self {
        let side = SIDE * rays.visibility.bounds().diagonal();
        let list = rays.elements.list();
        let cells: f64 = list.iter().map(|own| (own.area / side.powi(2)).max(1.0)).sum();
        Self { side, rays: POINTS as f64 * cells, elements: list.iter().map(|_| OnceLock::new()).collect() }
    }

    /// Whether so many rays would take longer than all cells.
    pub(super) fn are_worth(&self, rays: f64) -> bool {
        self.rays < rays
    }

    /// Direct light per band (W m⁻²) on the front of an element at a place so far from where it is seen, by the
    /// emitters of the solution `sent`; None where it is near.
    pub(super) fn at(
        &self,
        sent: &Solution,
        rays: &SentRays,
        element: usize,
        place: &SurfacePlace,
        distance: f64,
    ) -> Option<&[f64]> {
        if distance < AFAR * self.side || rays.points.is_within(place.position, PEAK * self.side) {
            return None;
        }
        let own = &rays.elements.list()[element];
        let lit = self.elements[element].get_or_init(|| self.cells(rays, element));
        let ends = [own.rect.u, own.rect.v];
        let at: [usize; 2] = std::array::from_fn(|axis| {
            let [low, high] = ends[axis];
            let share = (place.parameters[axis] - low) / (high - low);
            ((share * lit.counts[axis] as f64) as usize).min(lit.counts[axis] - 1)
        });
        let cell = &lit.cells[at[0] * lit.counts[1] + at[1]];
        cell.get_or_init(|| lit.computed(sent, rays, element, at)).as_deref()
    }

    fn cells(&self, rays: &SentRays, element: usize) -> LitElement {
        let own = &rays.elements.list()[element];
        let shape = rays.elements.shape(own.surface);
        let ([a, b], [c, d]) = (own.rect.u, own.rect.v);
        let at = |u: f64, v: f64| shape.jet(u, v).position;
        let (middle_u, middle_v) = (0.5 * (a + b), 0.5 * (c + d));
        let lengths = [at(a, middle_v).distance(at(b, middle_v)), at(middle_u, c).distance(at(middle_u, d))];
        let counts = lengths.map(|length| ((length / self.side).ceil() as usize).clamp(1, MOST));
        let cells = (0..counts[0] * counts[1]).map(|_| OnceLock::new()).collect();
        LitElement { counts, cells }
    }
}

impl LitElement {
    /// The light of the cell at this place along u and v; None if no point of it lies on the element.
    fn computed(&self, sent: &Solution, rays: &SentRays, element: usize, at: [usize; 2]) -> Option<Vec<f64>> {
        let own = &rays.elements.list()[element];
        let shape = rays.elements.shape(own.surface);
        let number = number_of([element as f64, at[0] as f64, at[1] as f64]);
        let ([a, b, c, d], [e, f, g]): ([f64; 4], [f64; 3]) =
            (shift(number), shift(number_of([f64::from_bits(number)])));
        let (mut sums, mut count) = (vec![0.0; sent.bands().len()], 0.0);
        let ends = [own.rect.u, own.rect.v];
        for index in 0..POINTS {
            let [s, t, choice, x, y, polar, turn] = shifted(kronecker::point(index), &[a, b, c, d, e, f, g]);
            let [u, v]: [f64; 2] = std::array::from_fn(|axis| {
                let [low, high] = ends[axis];
                low + (high - low) * (at[axis] as f64 + [s, t][axis]) / self.counts[axis] as f64
            });
            if rays.elements.at(own.surface, [u, v]) != Some(element) {
                continue;
            }
            count += 1.0;
            let jet = shape.jet(u, v);
            let from = ReceiverPoint::on(own.surface, jet.position, jet.normal);
            rays.points.add(&from, rays.visibility, &mut sums);
            let shares = rays.lamps.seen_from(&from);
            if shares.is_empty() {
                continue;
            }
            let is_near = rays.lamps.is_near(&from, NEAR);
            for LampLight { element, share } in
                rays.direct(&from, &shares, [choice, x, y, polar, turn], is_near)
            {
                let bands = sums.iter_mut().zip(sent.bands());
                bands.for_each(|(sum, band)| *sum += share * band.coating.exitance[element]);
            }
        }
        (count > 0.0).then(|| sums.into_iter().map(|sum| sum / count).collect())
    }
}
