//! Collocation: the light that arrives is right at points of each element, and interpolated between them.
//!
//! ```text
//! h_i(x_p) = Σ_j ∫_j κ(x_p, y) V(x_p, y) B(y) dA_y        at N + 1 Gauss points in each direction of each piece
//! ```
//!
//! G holds the coefficients of the polynomial h_i for each function of the emitters. On a parallelogram with
//! polynomials of degree N in each coordinate it passes through all values; of total degree N it is the one
//! nearest to them, and on several pieces the sum of their values with the weights of the rule. One integral
//! over an area less is made than by the Galerkin method, exactly ([`PointTransfers`]). But G is not
//! symmetric: power is lost or won by as much as the interpolation errs.
//!
//! With order 0 it is the usual radiosity method with form factors from the middle of each element.
//!
//! Reference: L. Szirmay-Kalos, *Application of variational calculus in the radiosity method*, Periodica
//! Polytechnica El. Eng. 40 (1996), 123–138, which names point collocation beside Galerkin's method.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_elements::Element;
use radiosity_kernel::Blocks;
use radiosity_light::occluders::Site;
use radiosity_light::point_transfers::PointTransfers;
use radiosity_light::receiver_point::ReceiverPoint;
use radiosity_transport::Demand;
use radiosity_work::interruption::check_interrupt;
use radiosity_work::{Stage, Work};
use rayon::prelude::*;

use crate::zatz1993::transfers::{Piece, Side};

/// The blocks of a demand by collocation, with transfers to points to its accuracy of shadows. They are not
/// symmetric.
pub fn assemble(demand: Demand<'_>, work: &Work<'_>) -> Blocks {
    let Demand { elements, visibility, wanted, accuracy, .. } = demand;
    let (list, starts) = (elements.list(), elements.starts());
    let transfers = PointTransfers::new(list, visibility, accuracy.shadow_eps);
    let done = AtomicUsize::new(0);
    let row = |receiver: &Element| {
        let rows = rows_of(receiver, &transfers, elements.coefficients());
        work.report_done(Stage::Blocks, done.fetch_add(1, Ordering::Relaxed) + 1, list.len());
        rows
    };
    let rows: Vec<Vec<f64>> = list.par_iter().with_max_len(1).map(row).collect();
    let mut blocks = Blocks::empty(starts.clone(), false, work.ranks);
    for (i, rows) in rows.iter().enumerate() {
        for j in (0..list.len()).filter(|j| wanted(i.min(*j), i.max(*j))) {
            let columns = starts[j]..starts[j + 1];
            let block = rows.chunks_exact(elements.coefficients()).flat_map(|row| &row[columns.clone()]);
            blocks.push(i, j, &block.copied().collect::<Vec<_>>());
        }
    }
    blocks
}

/// The rows of G of a receiver, row-major, with `columns` functions of all elements.
fn rows_of(receiver: &Element, transfers: &PointTransfers<'_>, columns: usize) -> Vec<f64> {
    let around = transfers.around(&Site::of(receiver));
    let mut rows = vec![0.0; receiver.basis.len() * columns];
    for piece in Piece::all(receiver) {
        let side = Side::receiving(&piece, receiver.basis.order() + 1);
        for (node, factors) in side.nodes.iter().zip(&side.rows) {
            check_interrupt();
            let point = ReceiverPoint::on(receiver.surface, node.position, node.normal);
            let arriving = transfers.at(&point, &around);
            for (row, factor) in rows.chunks_exact_mut(columns).zip(factors) {
                row.iter_mut().zip(&arriving).for_each(|(sum, value)| *sum += factor * value);
            }
        }
    }
    rows
}
