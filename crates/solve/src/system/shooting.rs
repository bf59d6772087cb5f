//! The system of one band as light is shot: progressive refinement.
//!
//! The unknown u is the radiosity that was shot, of all elements that send light. With the matrix S of the
//! reflection,
//!
//! ```text
//! (I − S G) u = f ,     h = l + G u ,     b = e + S h = u + r ,     r = f − (I − S G) u ,
//! ```
//!
//! where f is what waits to be shot at first: the exitance e, and what surfaces reflect of the irradiance l
//! of luminaires. Where direct light d is split off, f = S g is what they reflect of the irradiance g of its
//! first bounce, and l = d + g. After any number of shots r is what has arrived and waits, and b, with what
//! waits, is what is shown. Only columns of G that were shot are used, for r too.
//!
//! For the light that the rest of the shots would bring there is an ambient term: the irradiance
//!
//! ```text
//! a = ⟨c, r⟩ / ((1 − ρ̄) Σ A)
//! ```
//!
//! everywhere, with the coefficients c of the constant 1 and the mean ρ̄ of the reflectance over the area. It
//! keeps the power of a closed scene of one reflectance right after any number of shots.
//!
//! References: M. Cohen, S. Chen, J. Wallace, D. Greenberg, *A progressive refinement approach to fast
//! radiosity image generation*, SIGGRAPH 1988; H. Zatz, *Galerkin radiosity*, SIGGRAPH 1993, section 4.1.

use std::ops::Range;

use radiosity_core::dot;
use radiosity_elements::coating::Coating;
use radiosity_elements::{Element, starts};
use radiosity_kernel::block_columns::BlockColumns;
use radiosity_kernel::{Blocks, PlacedBlock};
use radiosity_light::first_bounce::{Bounce, DirectLightEntry};
use radiosity_solvers::{Operator, Partition};

use super::vector::{distance, per_element, sum};
use super::{Coefficients, emitted, radiosity, relative_residual};

/// The system of one band and one emission, as light is shot.
pub(crate) struct Shooting<'a> {
    elements: &'a [Element],
    starts: Vec<usize>,
    coating: &'a Coating,
    /// Elements that send light, ascending: the blocks of unknowns.
    sending: Vec<usize>,
    partition: Partition,
    /// e, element by element.
    emitted: Vec<f64>,
    /// f, element by element.
    first: Vec<f64>,
    /// l of the irradiance that no shot brings, and the part of it that comes straight from emitters.
    apart: Option<Apart>,
}

/// Irradiance that no shot brings.
struct Apart {
    all: Vec<f64>,
    direct: Vec<f64>,
    /// Radiosity that no shot sends, where emitted light is none: e, and what surfaces reflect of d where the first
    /// bounce is known; None where shots send emitted light.
    unshot: Option<Vec<f64>>,
}

/// The matrix I − S G by the columns of G.
pub(crate) struct ShotColumns<'a> {
    shooting: &'a Shooting<'a>,
    columns: &'a dyn BlockColumns,
}

impl<'a> Shooting<'a> {
    /// The system of band number `band`, into which direct light enters in this way.
    pub(crate) fn entered(
        elements: &'a [Element],
        band: usize,
        coating: &'a Coating,
        entry: &DirectLightEntry,
    ) -> Self {
        let starts = starts(elements);
        let emitted = emitted(elements, coating);
        let (first, apart) = match entry {
            DirectLightEntry::Carried => (emitted.clone(), None),
            DirectLightEntry::Lit(lit) => {
                let lit = lit[band].clone();
                let first = sum(&emitted, &coating.reflected(&starts, &lit));
                (first, Some(Apart { all: lit.clone(), direct: lit, unshot: None }))
            }
            DirectLightEntry::Arrived(direct) => {
                let direct = direct[band].clone();
                let first = coating.reflected(&starts, &direct);
                (first, Some(Apart { all: direct.clone(), direct, unshot: Some(emitted.clone()) }))
            }
            DirectLightEntry::Split(Bounce { direct, reflected, .. }) => {
                let (direct, once) = (direct[band].clone(), &reflected[band]);
                let first = coating.reflected(&starts, once);
                let unshot = Some(sum(&emitted, &coating.reflected(&starts, &direct)));
                (first, Some(Apart { all: sum(&direct, once), direct, unshot }))
            }
        };
        let sends = |i: &usize| {
            coating.scatters(*i) || first[starts[*i]..starts[i + 1]].iter().any(|value| *value != 0.0)
        };
        let sending: Vec<usize> = (0..elements.len()).filter(sends).collect();
        let sizes: Vec<usize> = sending.iter().map(|i| elements[*i].basis.len()).collect();
        Self { elements, starts, coating, sending, partition: Partition::new(&sizes), emitted, first, apart }
    }

    /// The matrix, by these columns.
    pub(crate) fn matrix(&'a self, columns: &'a dyn BlockColumns) -> ShotColumns<'a> {
        ShotColumns { shooting: self, columns }
    }

    /// f of the elements that send light.
    pub(crate) fn right_hand_side(&self) -> Vec<f64> {
        self.of_sending(&self.first)
    }

    /// Shooting measure of the unknowns, ∬ |φ_k| dA: times |r_k| it is the power that an unknown has yet to
    /// shoot (Zatz 1993, eq. 25, corrected).
    pub(crate) fn measure(&self) -> Vec<f64> {
        let all = per_element(self.elements, |i, out| out.extend(self.elements[i].absolute_integrals()));
        self.of_sending(&all)
    }

    /// c of the elements that send light: its product with r is the power that waits to be shot.
    pub(crate) fn constant(&self) -> Vec<f64> {
        let all = per_element(self.elements, |i, out| out.extend(&self.elements[i].constant));
        self.of_sending(&all)
    }

    /// Coefficients of the light after the shots u, with what waits; `blocks` hold all columns that were
    /// shot.
    pub(crate) fn found(&self, shot: &[f64], blocks: &Blocks) -> Coefficients {
        let mut sent = vec![0.0; self.first.len()];
        let mut emitted = sent.clone();
        for (block, i) in self.sending.iter().enumerate() {
            let own = &shot[self.partition.range(block)];
            sent[self.range(*i)].copy_from_slice(own);
            if own.iter().any(|value| *value != 0.0) {
                emitted[self.range(*i)].copy_from_slice(&self.emitted[self.range(*i)]);
            }
        }
        let carried = blocks.apply(&sent);
        let (irradiance, direct) = match &self.apart {
            None => (carried, blocks.apply(&emitted)),
            Some(Apart { all, direct, unshot: Some(_) }) => (sum(all, &carried), direct.clone()),
            Some(Apart { all, direct, .. }) => (sum(all, &carried), sum(direct, &blocks.apply(&emitted))),
        };
        let radiosity = radiosity(self.elements, self.coating, &irradiance);
        let known = self.known();
        let reflected = match &self.apart {
            None => None,
            Some(Apart { unshot: Some(unshot), .. }) => Some(&unshot[..]),
            Some(_) => Some(&self.first[..]),
        };
        let missed = distance(&sum(&known, &sent), &radiosity);
        let residual = relative_residual(missed, &self.emitted, reflected);
        let waiting = radiosity.iter().zip(&known).zip(&sent).map(|((b, known), u)| b - known - u).collect();
        Coefficients { irradiance, direct, radiosity, residual, waiting: Some(waiting) }
    }

    /// Radiosity that no shot sends.
    fn known(&self) -> Vec<f64> {
        let unshot = self.apart.as_ref().and_then(|apart| apart.unshot.clone());
        unshot.unwrap_or_else(|| vec![0.0; self.first.len()])
    }

    /// S h for irradiance h on the element `from` alone, added to `y` with the factor −1.
    fn subtract_reflected(&self, from: usize, irradiance: &[f64], y: &mut [f64]) {
        for element in self.coating.all_behind(from).chain([from]) {
            let Ok(block) = self.sending.binary_search(&element) else { continue };
            let mut rows = vec![0.0; self.elements[element].basis.len()];
            self.coating.add_reflected_rows([element, from], irradiance, 1, &mut rows);
            y[self.partition.range(block)].iter_mut().zip(rows).for_each(|(y, row)| *y -= row);
        }
    }

    fn range(&self, element: usize) -> Range<usize> {
        self.starts[element]..self.starts[element + 1]
    }

    /// The part of whole coefficients on the elements that send light.
    fn of_sending(&self, all: &[f64]) -> Vec<f64> {
        self.sending.iter().flat_map(|i| &all[self.range(*i)]).copied().collect()
    }
}

impl Operator for ShotColumns<'_> {
    fn partition(&self) -> &Partition {
        &self.shooting.partition
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        let shooting = self.shooting;
        for PlacedBlock { row, values, .. } in self.columns.column(shooting.sending[column]) {
            let irradiance: Vec<f64> = values.chunks_exact(x.len()).map(|line| dot(line, x)).collect();
            shooting.subtract_reflected(row, &irradiance, y);
        }
        y[shooting.partition.range(column)].iter_mut().zip(x).for_each(|(y, x)| *y += x);
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        let (shooting, element) = (self.shooting, self.shooting.sending[block]);
        let size = shooting.partition.size(block);
        let mut reflected = vec![0.0; size * size];
        for PlacedBlock { row, values, .. } in self.columns.column(element) {
            shooting.coating.add_reflected_rows([element, row], &values, size, &mut reflected);
        }
        for (k, out) in out.iter_mut().enumerate() {
            *out = f64::from(u8::from(k % size == k / size)) - reflected[k % size * size + k / size];
        }
    }
}

/// The ambient irradiance for a radiosity that waits to be shot.
pub(crate) fn ambient(elements: &[Element], coating: &Coating, waiting: &[f64]) -> f64 {
    let starts = starts(elements);
    let (mut power, mut area, mut reflecting) = (0.0, 0.0, 0.0);
    for (i, element) in elements.iter().enumerate().filter(|(_, element)| element.contact.is_none()) {
        power += dot(&element.constant, &waiting[starts[i]..starts[i + 1]]);
        area += element.area;
        reflecting += element.area * (coating.reflectance[i] + coating.transmittance(i));
    }
    if area > reflecting { power / (area - reflecting) } else { 0.0 }
}
