//! The geometry of transport: blocks G between elements, each unordered pair once.
//!
//! ```text
//! G_ij^kl = ∫∫ φ_k(x) φ_l(y) κ(x, y) V(x, y) dA_x dA_y ,     G_ji = G_ijᵀ .
//! ```
//!
//! Reflectance enters afterwards, per band. G has no scale: it is invariant under similarity. In a
//! closed scene G maps the coefficients c of the constant 1 to themselves, and ‖G‖ ≤ 1 always.
//!
//! In order: `tolerances`, `occlusion` (hiding by blockers), `pair` (one pair of elements), `coaxial` (pairs
//! about one axis), `known` (blocks from elsewhere), `kept_blocks` (blocks and rays of an earlier scene),
//! `price` (the cost of a block), `schedule` (all pairs), `sampled` (blocks from rays), `row_exchanges` (of a
//! surface), `facets` (pairs of many small flat elements), `unreached` (rays where rules fail), `assembly` (all
//! blocks) and `carrier` (blocks or links, as checks see them). Quadrature of one pair stands in
//! `radiosity-kernel`.
//!
//! Imports `core`, `geom`, `work`, `scene`, `visibility`, `elements` and `kernel`.

pub mod tolerances;
pub(crate) mod occlusion;
pub(crate) mod pair;
pub(crate) mod coaxial;
pub(crate) mod known;
pub mod kept_blocks;
pub mod price;
mod schedule;
pub(crate) mod sampled;
mod row_exchanges;
mod facets;
mod uncut;
pub(crate) mod unreached;
mod assembly;
mod carrier;

pub use assembly::assemble;
pub use carrier::Carrier;
pub use facets::{FacetExchanges, FacetTransport, MixedPair, RowPairs};
pub use kept_blocks::KeptBlocks;
pub use kept_blocks::kept_rays::RayCounts;
pub use known::{Known, KnownBlocks};
pub use row_exchanges::RowExchanges;
pub use sampled::{Rays, SampledTransport, StandingRays};
pub use schedule::{BlockWork, ColumnsAsShot, Cost, Demand, FactorEnds, shared, work};
pub use uncut::best_whole;
pub use unreached::FINEST as FINEST_BY_RAYS;
