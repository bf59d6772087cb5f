//! The geometry of transport: blocks G between elements, each unordered pair once.
//!
//! ```text
//! G_ij^kl = ∫∫ φ_k(x) φ_l(y) κ(x, y) V(x, y) dA_x dA_y ,     G_ji = G_ijᵀ .
//! ```
//!
//! Reflectance enters afterwards, per band. G has no scale: it is invariant under similarity. In a
//! closed scene G maps the coefficients c of the constant 1 to themselves, and ‖G‖ ≤ 1 always.
//!
//! The submodules, each built on those before it: `moments` (sums over pairs of points), `contact` (how two patches
//! meet), `estimates` (sizes of blocks before integration), `blocks` (the matrix), `rules` (quadrature for each kind of
//! contact), `occlusion` (what blockers hide), `pair` (one pair of elements), `terms` (kernels that are sums of terms),
//! `known` (blocks from elsewhere), `memory` (blocks and rays of an earlier scene), `schedule` (all pairs),
//! `price` (what a block costs), `sampled` (blocks from rays), `unreached` (rays where rules fail), `assembly` (all
//! blocks) and `carrier` (blocks or links, as checks see them).

pub(crate) mod moments;
pub(crate) mod contact;
pub(in crate::transport) mod estimates;
pub(crate) mod blocks;
pub(in crate::transport) mod rules;
pub(in crate::transport) mod occlusion;
pub(in crate::transport) mod pair;
pub(crate) mod terms;
pub(crate) mod known;
pub(crate) mod memory;
pub(crate) mod price;
mod schedule;
pub(crate) mod sampled;
pub(in crate::transport) mod unreached;
mod assembly;
mod carrier;

pub(crate) use assembly::assemble_again;
pub use assembly::{assemble, assemble_factors, assemble_pairs, assemble_senders};
pub use blocks::Blocks;
pub use blocks::block::{Accuracy, Kind};
pub use blocks::miss::Miss;
pub use blocks::pair_counts::PairCounts;
pub use blocks::reciprocity::Reciprocity;
pub(crate) use blocks::remainder::Remainder;
pub use carrier::Carrier;
pub(crate) use known::{Known, KnownBlocks};
pub(crate) use memory::Memory;
pub use memory::met::RayCounts;
pub use moments::integrand::kernel;
pub use rules::contour::polygon_exchange;
pub use sampled::{Rays, SampledTransport};
pub use schedule::{Work, cost, shared, work};
pub use unreached::FINEST as FINEST_BY_RAYS;
