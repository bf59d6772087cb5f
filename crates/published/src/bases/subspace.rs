//! The subspace that the functions of a basis span among the polynomials on elements, and the orthogonal
//! projection on it.
//!
//! ```text
//! Q = orthonormal columns of (c, T) ,     P = Q Qᵀ
//! ```
//!
//! surface by surface, by modified Gram–Schmidt, done twice; columns that add nothing are left out. c are the
//! coefficients of the constant 1: it comes first, since each of these bases has it in its span, and so power
//! is kept to rounding whatever the basis. Pivots would exchange it for a column that has it only to what is
//! left out. Parts of a surface on which others lie have functions of their own, for they receive other light
//! than what is around them.

use std::ops::Range;

use radiosity_core::{dot, norm};
use radiosity_elements::columns::{add_scaled, take_out};
use radiosity_elements::space::Space;
use radiosity_elements::{Element, Elements};
use radiosity_geom::Rect;
use radiosity_work::interruption::check_interrupt;
use rayon::prelude::*;

use super::basis::Basis;
use super::projection::Projection;

/// Part of a function that the others must leave of it to count: the square root of rounding. Chosen.
const NEW: f64 = 1e-8;

/// The subspace of a basis.
#[derive(Clone, Debug)]
pub struct Subspace {
    groups: Vec<Group>,
    /// Number of coefficients of all elements.
    dim: usize,
}

/// Elements of one surface with common functions.
#[derive(Clone, Debug)]
pub struct Group {
    /// Indices of the elements.
    pub elements: Vec<usize>,
    /// Where the coefficients of each stand.
    ranges: Vec<Range<usize>>,
    /// Q, column by column.
    columns: Vec<Vec<f64>>,
}

impl Subspace {
    /// Subspace of `basis` on `elements`; cosines on the surface s are those of `space` up to `degree(s)`.
    /// None where the polynomials themselves are the basis.
    pub fn new(
        basis: Basis,
        elements: &Elements,
        degree: &(dyn Fn(usize) -> usize + Sync),
        space: Space,
    ) -> Option<Self> {
        if basis.is_elementwise() {
            return None;
        }
        let groups = groups(elements);
        let starts = elements.starts();
        let of_group = |(surface, own): (usize, Vec<usize>)| {
            check_interrupt();
            let cells: Vec<Rect> =
                elements.of_surface(surface).map(|index| elements.list()[index].rect).collect();
            let functions = basis.functions(&cells, degree(surface), space).expect("it is not elementwise");
            let list: Vec<&Element> = own.iter().map(|index| &elements.list()[*index]).collect();
            let projection = Projection::new(functions.as_ref(), elements.shape(surface), &list);
            let constant = list.iter().flat_map(|element| &element.constant).copied().collect();
            let columns = orthonormal(std::iter::once(constant).chain(projection.columns));
            let ranges = own.iter().map(|index| starts[*index]..starts[index + 1]).collect();
            Group { elements: own, ranges, columns }
        };
        Some(Self {
            groups: groups.into_par_iter().map(of_group).collect(),
            dim: starts.last().copied().unwrap_or(0),
        })
    }

    /// Its dimension: the number of coefficients per band.
    pub fn dim(&self) -> usize {
        self.groups.iter().map(Group::count).sum()
    }

    /// The groups of elements with common functions.
    pub fn groups(&self) -> &[Group] {
        &self.groups
    }

    /// P x.
    pub fn projected(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; self.dim];
        for group in &self.groups {
            group.extend(&group.restricted(x), &mut y);
        }
        y
    }
}

impl Group {
    /// Number of functions.
    pub fn count(&self) -> usize {
        self.columns.len()
    }

    /// Qᵀ x: coefficients in the orthonormal functions, for those `x` of all elements.
    pub fn restricted(&self, x: &[f64]) -> Vec<f64> {
        let own: Vec<f64> = self.ranges.iter().flat_map(|range| &x[range.clone()]).copied().collect();
        self.columns.iter().map(|column| dot(column, &own)).collect()
    }

    /// Writes Q a to the coefficients `x` of all elements.
    pub fn extend(&self, a: &[f64], x: &mut [f64]) {
        let mut own = vec![0.0; self.ranges.iter().map(Range::len).sum()];
        self.columns.iter().zip(a).for_each(|(column, a)| add_scaled(&mut own, *a, column));
        let mut rest = &own[..];
        for range in &self.ranges {
            let (first, others) = rest.split_at(range.len());
            x[range.clone()].copy_from_slice(first);
            rest = others;
        }
    }

    /// Σ_k |Q_ka| m_k: bounds of integrals of absolute values, from those `m` of the polynomials of all
    /// elements.
    pub fn bounded(&self, m: &[f64]) -> Vec<f64> {
        let own: Vec<f64> = self.ranges.iter().flat_map(|range| &m[range.clone()]).copied().collect();
        self.columns.iter().map(|column| column.iter().zip(&own).map(|(q, m)| q.abs() * m).sum()).collect()
    }
}

/// Surface by surface the elements that have functions in common.
fn groups(elements: &Elements) -> Vec<(usize, Vec<usize>)> {
    let mut groups: Vec<(usize, Vec<usize>)> = Vec::new();
    for surface in 0..elements.surfaces() {
        let list = elements.list();
        let (open, parts): (Vec<usize>, Vec<usize>) =
            elements.of_surface(surface).partition(|index| list[*index].is_cell());
        groups.extend((!open.is_empty()).then_some((surface, open)));
        let are_one = |a: &usize, b: &usize| list[*a].is_of_part(&list[*b]);
        groups.extend(parts.chunk_by(are_one).map(|own| (surface, own.to_vec())));
    }
    groups
}

/// Orthonormal columns of the same span.
fn orthonormal(columns: impl Iterator<Item = Vec<f64>>) -> Vec<Vec<f64>> {
    let mut done: Vec<Vec<f64>> = Vec::new();
    for mut column in columns {
        let length = norm(&column);
        for _ in 0..2 {
            done.iter().for_each(|unit| {
                take_out(&mut column, unit);
            });
        }
        let rest = norm(&column);
        if rest > NEW * length {
            column.iter_mut().for_each(|x| *x /= rest);
            done.push(column);
        }
    }
    done
}
