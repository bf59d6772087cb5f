//! The geometry of transport: blocks G between elements, each unordered pair once; by the rules of [`paper`], for
//! comparison, each ordered pair.
//!
//! ```text
//! G_ij^kl = ∫∫ φ_k(x) φ_l(y) κ(x, y) V(x, y) dA_x dA_y ,     G_ji = G_ijᵀ .
//! ```
//!
//! Reflectance enters afterwards, per band. G has no scale: it is invariant under similarity. In a
//! closed scene G maps the coefficients c of the constant 1 to themselves, and ‖G‖ ≤ 1 always.

mod analytic;
mod assembly;
mod block;
mod blocks;
mod change;
mod chart;
mod clip;
mod congruent;
mod contact;
mod contour;
mod counts;
mod curved;
mod edge;
mod edge_sum;
mod edge_table;
mod facing;
mod fineness;
mod hinge;
mod horizon;
mod integrand;
mod moments;
mod near;
mod obstruction;
mod order;
mod pair;
pub mod paper;
mod parts;
mod planar;
mod planes;
mod product;
mod reach;
mod rough;
mod same;
mod scatter;
mod seam;
mod sectors;
mod separated;
mod shade;
mod touch;
mod trial;
mod vertex;
mod wedge;
mod yardstick;

pub use block::{Accuracy, Kind};
pub use blocks::Blocks;
pub use contour::polygon_exchange;
pub use counts::PairCounts;
pub use integrand::kernel;
