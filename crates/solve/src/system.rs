//! The linear system of one band.
//!
//! With the coefficients e of the emitted exitance and a reflectance ρ per element, b = e + ρ G b. All
//! coefficients are in W m⁻² times length, G has no unit. Written with b = e + √ρ y,
//!
//! ```text
//! (I − √ρ G √ρ) y = √ρ G e
//! ```
//!
//! is symmetric, and positive definite with lowest eigenvalue ≥ 1 − ρ_max because ‖G‖ ≤ 1 (Szirmay-Kalos 1996
//! in another notation). With the rules of 1993, for comparison, neither G nor the system is symmetric.
//! Nothing is divided by ρ. Elements with ρ = 0 have no unknowns: they only enter the right-hand side. The
//! irradiance is h = G b everywhere.
//!
//! Where the reflectance varies over elements, the matrix S takes the place of ρ
//! ([`radiosity_elements::coating`]), its symmetric root that of √ρ, and all of this holds: S^½ G S^½ is
//! symmetric, and its norm is below the largest ρ. Where surfaces let light through, S couples both of their
//! sides, and has negative eigenvalues as soon as τ² > ρ ρ'. Then the unknown is the radiosity that is not
//! known itself, and
//!
//! ```text
//! (I − S G) r = S G e ,     b = e + r
//! ```
//!
//! is not symmetric, but ‖S G‖ ≤ max (ρ + τ) < 1: Richardson's iteration and GMRES converge as fast as
//! before.
//!
//! Where direct light is split off (`light::first_bounce`), the coefficients d of direct irradiance and g of
//! irradiance that was reflected exactly once are known; s of the irradiance that was reflected at least once
//! is unknown. With s = g + G √ρ z,
//!
//! ```text
//! (I − √ρ G √ρ) z = √ρ g ,     h = d + s ,     b = e + ρ h .
//! ```
//!
//! Where luminaires shine and nothing is split off, the coefficients l of their irradiance are known, and
//!
//! ```text
//! (I − √ρ G √ρ) y = √ρ G (e + ρ l) ,     b = e + ρ l + √ρ y ,     h = l + G b .
//! ```
//!
//! All are one system: the radiosity is a known part, e (or e + ρ l, or e + ρ d), plus the unknown √ρ y (or
//! √ρ z); the irradiance is a known part, 0 (or l, or d), plus that of the first transport, G e (or G (e + ρ
//! l), or g), plus G times the unknown radiosity.

pub(crate) mod vector;
mod series;
mod reduction;
mod projected;
pub(crate) mod shooting;
pub(crate) mod known_light;
pub mod ritz;

use std::borrow::Cow;
use std::collections::HashMap;
use std::ops::Range;

use radiosity_core::norm;
use radiosity_elements::coating::{Coating, SquareRoot};
use radiosity_elements::columns::transposed;
use radiosity_elements::{Element, starts};
use radiosity_kernel::{Blocks, PlacedBlock};
use radiosity_light::first_bounce::{Bounce, DirectLightEntry};
use radiosity_solvers::auto::{DENSE, DIRECT};
use radiosity_solvers::method::{Access, Method};
use radiosity_solvers::{BlockSparse, Dense, Operator, Partition, SolveError, SparseBlock};
use radiosity_work::ranks::Ranks;

use vector::{distance, per_element, sum};

/// Share of the entries of a matrix above which it is held entry by entry, if it is small: a product by
/// blocks takes some four times as long for each entry. Chosen.
const THIN: f64 = 0.125;

/// Right-hand sides from which on a direct method is wanted for more unknowns, and the most of these: twice 160 MB. For
/// 32 of them conjugate gradients take about as many products as a factorisation of a thin matrix takes time. Chosen.
pub(crate) const MANY: usize = 32;
pub(crate) const MOST_FOR_MANY: usize = 4500;

/// The system of one band.
#[derive(Debug)]
pub struct System<'a> {
    elements: &'a [Element],
    blocks: &'a Blocks,
    coating: &'a Coating,
    /// Elements with ρ > 0, ascending: the blocks of unknowns.
    reflecting: Vec<usize>,
    emitted: Vec<f64>,
    /// Known radiosity: e, e + ρ l, or e + ρ d.
    known: Vec<f64>,
    /// Irradiance that G does not carry: l of luminaires, or d if direct light is split off.
    apart: Option<Vec<f64>>,
    /// Irradiance that comes straight from emitters: G e, l + G e, or d.
    direct: Vec<f64>,
    /// Irradiance of the first transport: G e, G (e + ρ l), or g.
    first: Vec<f64>,
    /// Whether direct light is split off, so that the first transport carries what was reflected once.
    is_split: bool,
}

/// Coefficients of one band's solution, element by element, all in W m⁻² times scene length.
#[derive(Clone, Debug)]
pub struct Coefficients {
    /// h of the irradiance.
    pub irradiance: Vec<f64>,
    /// The part of h that comes straight from the emitters: G e, l + G e where luminaires shine, or d where
    /// direct light was split off.
    pub direct: Vec<f64>,
    /// b of the radiosity, b = e + ρ h.
    pub radiosity: Vec<f64>,
    /// ‖b − e − ρ h‖₂ / ‖e‖₂ with the solver's b before that substitution, black elements included; over the
    /// known radiosity ‖e + ρ d‖₂ where direct light d enters apart and that is more; 0 if nothing shines.
    pub residual: f64,
    /// The part of b that has arrived and waits to be shot, where light was shot.
    pub waiting: Option<Vec<f64>>,
}

impl Coefficients {
    /// The coefficients for a known irradiance h and its direct part, both element by element.
    pub fn of_irradiance(
        elements: &[Element],
        coating: &Coating,
        irradiance: Vec<f64>,
        direct: Vec<f64>,
        residual: f64,
    ) -> Self {
        let radiosity = radiosity(elements, coating, &irradiance);
        Self { irradiance, direct, radiosity, residual, waiting: None }
    }
}

impl<'a> System<'a> {
    /// The system of `coating` over `elements`: G, given by `blocks`, transports all light.
    pub fn new(elements: &'a [Element], blocks: &'a Blocks, coating: &'a Coating) -> Self {
        Self::entered(elements, blocks, 0, &[(coating, &DirectLightEntry::Carried)]).remove(0)
    }

    /// The systems of band number `band` for some coatings, into each of which direct light enters in its way.
    pub(crate) fn entered<'e>(
        elements: &'a [Element],
        blocks: &'a Blocks,
        band: usize,
        all: &[(&'a Coating, &'e DirectLightEntry)],
    ) -> Vec<Self> {
        let sent = all.iter().flat_map(|(own, entry)| sent_first(elements, blocks, band, own, entry));
        let mut arrived = blocks.apply_to_each(&sent.collect::<Vec<_>>()).into_iter();
        let of = |(coating, entry): &(&'a Coating, &'e DirectLightEntry)| {
            Self::where_arrived(elements, blocks, band, coating, entry, &mut arrived)
        };
        all.iter().map(of).collect()
    }

    /// The system of a coating of which G carries all light, where G e has `arrived`.
    pub(crate) fn carried_by(
        elements: &'a [Element],
        blocks: &'a Blocks,
        coating: &'a Coating,
        arrived: Vec<f64>,
    ) -> Self {
        let entry = DirectLightEntry::Carried;
        Self::where_arrived(elements, blocks, 0, coating, &entry, &mut [arrived].into_iter())
    }

    /// The system where G times what is [sent first](sent_first) has `arrived`.
    fn where_arrived(
        elements: &'a [Element],
        blocks: &'a Blocks,
        band: usize,
        coating: &'a Coating,
        entry: &DirectLightEntry,
        arrived: &mut dyn Iterator<Item = Vec<f64>>,
    ) -> Self {
        let mut next = || arrived.next().expect("all that is sent arrives");
        let emitted = emitted(elements, coating);
        let known = |lit: &[f64]| radiosity(elements, coating, lit);
        let (known, apart, direct, first, is_split) = match entry {
            DirectLightEntry::Carried => {
                let first = next();
                (emitted.clone(), None, first.clone(), first, false)
            }
            DirectLightEntry::Lit(lit) => {
                let lit = lit[band].clone();
                let direct = sum(&lit, &next());
                (known(&lit), Some(lit), direct, next(), false)
            }
            DirectLightEntry::Arrived(direct) => {
                let direct = direct[band].clone();
                (known(&direct), Some(direct.clone()), direct, next(), true)
            }
            DirectLightEntry::Split(Bounce { direct, reflected, .. }) => {
                let direct = direct[band].clone();
                (known(&direct), Some(direct.clone()), direct, reflected[band].clone(), true)
            }
        };
        let reflecting = reflecting(coating);
        Self { elements, blocks, coating, reflecting, emitted, known, apart, direct, first, is_split }
    }

    /// I − √ρ G √ρ on the reflecting elements.
    ///
    /// # Errors
    /// Values that are not finite.
    pub fn matrix(&self) -> Result<Dense, SolveError> {
        let sizes: Vec<usize> = self.reflecting.iter().map(|i| self.elements[*i].basis.len()).collect();
        let partition = Partition::new(&sizes);
        let dim = partition.dim();
        let mut values = vec![0.0; dim * dim];
        values.iter_mut().step_by(dim + 1).for_each(|diagonal| *diagonal = 1.0);
        let place =
            |element: usize| self.reflecting.binary_search(&element).ok().map(|b| partition.range(b).start);
        let mut subtract = |row: usize, column: usize, block: &[f64], both: bool| {
            let (Some(i), Some(j)) = (place(row), place(column)) else { return };
            let columns = self.elements[column].basis.len();
            for (index, g) in block.iter().enumerate() {
                let (k, l) = (i + index / columns, j + index % columns);
                values[k + l * dim] -= g;
                if both {
                    values[l + k * dim] -= g;
                }
            }
        };
        for PlacedBlock { row, column, values: block } in self.blocks.gathered().iter() {
            let both = self.blocks.symmetric() && row != column;
            if !self.coating.transmits() {
                subtract(row, column, &self.halved([row, column], &block), both);
                continue;
            }
            self.scattered([row, column], &block, &mut |row, own| subtract(row, column, own, false));
            if both {
                let block = transposed(&block, self.elements[column].basis.len());
                self.scattered([column, row], &block, &mut |column, own| subtract(column, row, own, false));
            }
        }
        Dense::new(partition, values, self.is_symmetric())
    }

    /// I − √ρ G √ρ on the reflecting elements for the solver `method`: entry by entry where it is small and
    /// not thin for so many right-hand sides; elsewhere by its blocks, which solvers that only multiply take from G
    /// as it is.
    ///
    /// # Errors
    /// Values that are not finite.
    pub fn operator(
        &self,
        method: &Method,
        rights: usize,
        threads: usize,
    ) -> Result<Box<dyn Operator + '_>, SolveError> {
        let unknowns = self.unknown_count();
        let only_multiplies = method.only_multiplies();
        let is_thin = (self.blocks.stored_numbers() as f64) < THIN * (unknowns as f64).powi(2);
        let is_for_many = method.access == Access::BySize && rights >= MANY && unknowns <= MOST_FOR_MANY;
        if is_for_many && is_thin && self.is_symmetric() {
            return Ok(Box::new(Product { entries: Some(self.matrix()?), ..Product::new(self) }));
        }
        let most = if only_multiplies && is_thin { DENSE.min(DIRECT.saturating_mul(rights)) } else { DENSE };
        if unknowns <= most || !self.blocks.symmetric() || (self.coating.transmits() && !only_multiplies) {
            return Ok(Box::new(self.matrix()?));
        }
        if only_multiplies {
            return Ok(Box::new(Product::new(self)));
        }
        Ok(Box::new(self.block_sparse()?.with_threads(threads)))
    }

    /// I − √ρ G √ρ, multiplied by the blocks of G.
    pub(crate) fn product(&self) -> Box<dyn Operator + '_> {
        Box::new(Product::new(self))
    }

    /// The ranks that hold the blocks.
    fn ranks(&self) -> &Ranks {
        self.blocks.held().ranks()
    }

    fn unknown_count(&self) -> usize {
        self.reflecting.iter().map(|i| self.elements[*i].basis.len()).sum()
    }

    /// The matrix by those of its blocks that differ from zero.
    fn block_sparse(&self) -> Result<BlockSparse, SolveError> {
        let sizes: Vec<usize> = self.reflecting.iter().map(|i| self.elements[*i].basis.len()).collect();
        let place = |element: usize| self.reflecting.binary_search(&element).ok();
        let mut blocks: Vec<(usize, usize, Vec<f64>)> = Vec::new();
        for (block, size) in sizes.iter().enumerate() {
            let mut identity = vec![0.0; size * size];
            identity.iter_mut().step_by(size + 1).for_each(|diagonal| *diagonal = 1.0);
            blocks.push((block, block, identity));
        }
        for PlacedBlock { row, column, values } in self.blocks.gathered().iter() {
            let (Some(i), Some(j)) = (place(row), place(column)) else { continue };
            let halved = self.halved([row, column], &values);
            blocks.push((i, j, halved.iter().map(|g| -g).collect()));
        }
        let borrowed: Vec<SparseBlock<'_>> =
            blocks.iter().map(|(i, j, values)| SparseBlock::new(*i, *j, values)).collect();
        BlockSparse::symmetric(Partition::new(&sizes), &borrowed)
    }

    /// √ρ times the irradiance of the first transport, on the reflecting elements; S times it where surfaces
    /// transmit.
    pub fn right_hand_side(&self) -> Vec<f64> {
        self.halved_unknowns(&self.first)
    }

    /// √ρ times coefficients of irradiance, on the reflecting elements; S times them where surfaces transmit. Of the
    /// irradiance that G makes of all radiosity these are the unknowns.
    fn halved_unknowns(&self, irradiance: &[f64]) -> Vec<f64> {
        let halved = self.halved_light(irradiance);
        self.unknowns(|_, offset| halved[offset])
    }

    /// Shooting measure of the unknowns, √ρ ∬ |φ_k| dA: times |y_k| it is the power that an unknown has yet
    /// to shoot (Zatz 1993, eq. 25, corrected).
    pub fn shooting_measure(&self) -> Vec<f64> {
        let absolute = per_element(self.elements, |i, out| out.extend(self.elements[i].absolute_integrals()));
        let root = |i: usize| if self.coating.transmits() { 1.0 } else { self.coating.reflectance[i].sqrt() };
        self.unknowns(|i, offset| root(i) * absolute[offset])
    }

    /// Radiosity and irradiance from the unknowns: what G does not carry, the first transport, and G times
    /// the unknown radiosity; then b = e + ρ h.
    pub fn coefficients(&self, unknowns: &[f64]) -> Coefficients {
        let unknown = self.unknown_radiosity(0..self.reflecting.len(), unknowns);
        let irradiance = self.irradiance(self.blocks.apply(&self.carried(&unknown)));
        self.with_irradiance(&unknown, irradiance, self.direct.clone())
    }

    /// The radiosity that G carries to find h for the unknown radiosity √ρ y.
    fn carried(&self, unknown: &[f64]) -> Vec<f64> {
        if self.apart.is_none() { sum(&self.known, unknown) } else { unknown.to_vec() }
    }

    /// h where `arrived` is G times [what it carries](Self::carried).
    fn irradiance(&self, arrived: Vec<f64>) -> Vec<f64> {
        match &self.apart {
            None => arrived,
            Some(apart) => sum(apart, &sum(&self.first, &arrived)),
        }
    }

    /// The coefficients for an unknown radiosity √ρ y and the irradiance, with its direct part, that follows
    /// from it.
    fn with_irradiance(&self, unknown: &[f64], irradiance: Vec<f64>, direct: Vec<f64>) -> Coefficients {
        let solved = sum(&self.known, unknown);
        let radiosity = radiosity(self.elements, self.coating, &irradiance);
        let residual = self.relative(distance(&solved, &radiosity));
        Coefficients { irradiance, direct, radiosity, residual, waiting: None }
    }

    /// The size of a radiosity over that of the known one.
    fn relative(&self, size: f64) -> f64 {
        relative_residual(size, &self.emitted, self.apart.as_ref().map(|_| &self.known[..]))
    }

    /// The radiosity that is unknown where all of it is this.
    fn unknown_part(&self, radiosity: &[f64]) -> Vec<f64> {
        radiosity.iter().zip(&self.known).map(|(all, known)| all - known).collect()
    }

    /// Whether I − √ρ G √ρ is symmetric.
    fn is_symmetric(&self) -> bool {
        self.blocks.symmetric() && !self.coating.transmits()
    }

    /// √ρ_i G_ij √ρ_j for a block G_ij, row-major.
    fn halved<'b>(&self, [row, column]: [usize; 2], block: &'b [f64]) -> Cow<'b, [f64]> {
        if let (SquareRoot::Number(_), SquareRoot::Number(_)) =
            (self.coating.square_root(row), self.coating.square_root(column))
        {
            let root = (self.coating.reflectance[row] * self.coating.reflectance[column]).sqrt();
            return block.iter().map(|g| root * g).collect();
        }
        let columns = self.elements[column].basis.len();
        let left = multiplied(self.coating.square_root(row), block, columns);
        let turned = transposed(&left, columns);
        let both = multiplied(self.coating.square_root(column), &turned, block.len() / columns);
        transposed(&both, block.len() / columns).into()
    }

    /// Calls `visit` with the rows of S G that a block of G makes, for each element that reflects or
    /// transmits what arrives on the element of the block's rows.
    fn scattered(&self, [row, column]: [usize; 2], block: &[f64], visit: &mut dyn FnMut(usize, &[f64])) {
        let columns = self.elements[column].basis.len();
        for element in self.coating.all_behind(row).chain([row]) {
            let mut rows = vec![0.0; self.elements[element].basis.len() * columns];
            self.coating.add_reflected_rows([element, row], block, columns, &mut rows);
            visit(element, &rows);
        }
    }

    /// √ρ times coefficients of irradiance, element by element; S times them where surfaces transmit.
    fn halved_light(&self, irradiance: &[f64]) -> Vec<f64> {
        if self.coating.transmits() {
            return self.coating.reflected(self.blocks.starts(), irradiance);
        }
        self.coating.halved(self.blocks.starts(), irradiance)
    }

    /// Coefficients of the radiosity that unknowns of the reflecting elements number `blocks` stand for,
    /// element by element: √ρ times them, or themselves where surfaces transmit.
    fn unknown_radiosity(&self, blocks: Range<usize>, unknowns: &[f64]) -> Vec<f64> {
        let mut radiosity = vec![0.0; self.known.len()];
        let mut rest = unknowns;
        for i in &self.reflecting[blocks] {
            let range = self.range(*i);
            let (own, others) = rest.split_at(range.len());
            rest = others;
            let root =
                if self.coating.transmits() { SquareRoot::Number(1.0) } else { self.coating.square_root(*i) };
            root.multiply(own, &mut radiosity[range]);
        }
        radiosity
    }

    fn range(&self, element: usize) -> Range<usize> {
        let starts = self.blocks.starts();
        starts[element]..starts[element + 1]
    }

    fn unknowns(&self, value: impl Fn(usize, usize) -> f64) -> Vec<f64> {
        self.reflecting
            .iter()
            .flat_map(|i| self.range(*i).map(|k| value(*i, k)).collect::<Vec<_>>())
            .collect()
    }
}

/// I − √ρ G √ρ on the reflecting elements, or I − S G, multiplied by the blocks of G as they are stored.
struct Product<'a> {
    system: &'a System<'a>,
    partition: Partition,
    /// Blocks G_ii of the elements that see themselves.
    own: HashMap<usize, Vec<f64>>,
    /// All entries, where they are to be factored.
    entries: Option<Dense>,
}

impl<'a> Product<'a> {
    fn new(system: &'a System<'a>) -> Self {
        let sizes: Vec<usize> = system.reflecting.iter().map(|i| system.elements[*i].basis.len()).collect();
        let own = system.blocks.diagonal();
        Self { system, partition: Partition::new(&sizes), own, entries: None }
    }

    /// √ρ G √ρ x on the unknowns, for the unknowns x of the reflecting elements number `blocks`.
    fn reflected(&self, blocks: Range<usize>, x: &[f64]) -> Vec<f64> {
        let sent = self.system.unknown_radiosity(blocks, x);
        let received = self.system.halved_light(&self.system.blocks.apply_in_chunks(&sent));
        self.system.unknowns(|_, k| received[k])
    }
}

impl Operator for Product<'_> {
    fn partition(&self) -> &Partition {
        &self.partition
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let reflected = self.reflected(0..self.partition.len(), x);
        y.iter_mut().zip(x).zip(reflected).for_each(|((y, x), r)| *y = x - r);
    }

    fn apply_many(&self, x: &[f64], y: &mut [f64]) {
        let (system, dim) = (self.system, self.partition.dim().max(1));
        let sent = x.chunks_exact(dim).map(|x| system.unknown_radiosity(0..self.partition.len(), x));
        let arrived = system.blocks.apply_to_each(&sent.collect::<Vec<_>>());
        for ((x, y), arrived) in x.chunks_exact(dim).zip(y.chunks_exact_mut(dim)).zip(arrived) {
            let received = system.halved_light(&arrived);
            let reflected = system.unknowns(|_, k| received[k]);
            y.iter_mut().zip(x).zip(reflected).for_each(|((y, x), r)| *y = x - r);
        }
    }

    fn dense(&self) -> Option<&[f64]> {
        self.entries.as_ref().map(Dense::values)
    }

    fn shoot(&self, column: usize, x: &[f64], y: &mut [f64]) {
        let reflected = self.reflected(column..column + 1, x);
        y.iter_mut().zip(reflected).for_each(|(y, r)| *y -= r);
        y[self.partition.range(column)].iter_mut().zip(x).for_each(|(y, x)| *y += x);
    }

    fn diagonal(&self, block: usize, out: &mut [f64]) {
        let (system, element) = (self.system, self.system.reflecting[block]);
        let size = self.partition.size(block);
        let mut reflected = vec![0.0; size * size];
        if let Some(values) = self.own.get(&element) {
            match system.coating.transmits() {
                true => system.coating.add_reflected_rows([element; 2], values, size, &mut reflected),
                false => reflected.copy_from_slice(&system.halved([element; 2], values)),
            }
        }
        for (k, out) in out.iter_mut().enumerate() {
            *out = f64::from(u8::from(k % size == k / size)) - reflected[k % size * size + k / size];
        }
    }

    fn symmetric(&self) -> bool {
        !self.system.coating.transmits()
    }
}

/// The size of a radiosity over that of the emitted one, or of the known one where that is given and more: of
/// what luminaires light, surfaces reflect a part first.
fn relative_residual(size: f64, emitted: &[f64], known: Option<&[f64]>) -> f64 {
    let scale = norm(emitted).max(known.map_or(0.0, norm));
    if scale > 0.0 { size / scale } else { 0.0 }
}

/// Elements that reflect or transmit, ascending.
fn reflecting(coating: &Coating) -> Vec<usize> {
    (0..coating.reflectance.len()).filter(|i| coating.scatters(*i)).collect()
}

/// The radiosities that G carries first: e; e and e + ρ l; ρ d; or none.
fn sent_first(
    elements: &[Element],
    blocks: &Blocks,
    band: usize,
    coating: &Coating,
    entry: &DirectLightEntry,
) -> Vec<Vec<f64>> {
    match entry {
        DirectLightEntry::Carried => vec![emitted(elements, coating)],
        DirectLightEntry::Lit(lit) => {
            vec![emitted(elements, coating), radiosity(elements, coating, &lit[band])]
        }
        DirectLightEntry::Arrived(direct) => vec![coating.reflected(blocks.starts(), &direct[band])],
        DirectLightEntry::Split(_) => Vec::new(),
    }
}

/// e, the coefficients of the emitted exitance.
pub(crate) fn emitted(elements: &[Element], coating: &Coating) -> Vec<f64> {
    let ones: Vec<f64> = elements.iter().flat_map(|element| &element.constant).copied().collect();
    coating.emitted(&starts(elements), &ones)
}

/// b = e + S h.
fn radiosity(elements: &[Element], coating: &Coating, irradiance: &[f64]) -> Vec<f64> {
    sum(&emitted(elements, coating), &coating.reflected(&starts(elements), irradiance))
}

/// √ρ M for a row-major matrix M of so many columns.
fn multiplied(root: SquareRoot<'_>, matrix: &[f64], columns: usize) -> Vec<f64> {
    let turned = transposed(matrix, columns);
    let mut out = vec![0.0; matrix.len()];
    let rows = matrix.len() / columns;
    for (out, column) in out.chunks_exact_mut(rows).zip(turned.chunks_exact(rows)) {
        root.multiply(column, out);
    }
    transposed(&out, rows)
}
