//! Hierarchical radiosity: elements that exchange light over links at the level that each exchange needs.
//!
//! ```text
//! Φ = T B ,   T = Σ_links Pₚᵀ w P_q + its transpose ,   B = E₀ + ρ Φ/A          (constants B on the leaves)
//! ```
//!
//! All surfaces hang in a binary tree of clusters; below each surface its parameter rectangle is cut into
//! quarters where the light asks for it (`tree`). A link joins two nodes of which neither contains the other.
//! Of two faces it carries the exchange w = ∬ κ V dA dA (`exchange`, `sight`). A cluster sends and receives
//! by direction: nine spherical harmonics (`harmonics`) hold the clamped cosines of its parts, and the link
//! is the block of rank one
//!
//! ```text
//! w Y(d) Y(−d)ᵀ ,   w = V/(π r²) ,   d the direction between the centres, r their distance.
//! ```
//!
//! *Pull* P takes radiosity up the tree: means by area on faces, moments of the cosines on clusters. *Push*
//! Pᵀ takes received power down. So T is symmetric, and (I − √ρ D T D √ρ) with D = A^−½ is the operator of
//! `System` on constants; every solver takes it.
//!
//! A pair is linked where it carries less than `eps` of all emitted power, or a form factor of less than
//! `eps`, by an upper estimate without visibility (`oracle`); else the larger node is split
//! (`pair_refinement`). Links are refined again as radiosities become known. Then the number of links is of
//! the order of the number of surfaces, not of its square (study `links`). At last a link is handed down to
//! cells whose form factors differ by more than `eps` (`handing_down`), so that the form factors of a leaf add
//! up to 1 in a closed scene.
//!
//! Covered parts of surfaces ([`radiosity_visibility::covered_parts`]) are no leaves of their own: rays find
//! them dark. Footprints are cut out.
//!
//! References: P. Hanrahan, D. Salzman, L. Aupperle, *A rapid hierarchical radiosity algorithm*, SIGGRAPH 91;
//! B. Smits, J. Arvo, D. Greenberg, *A clustering algorithm for radiosity in complex environments*, SIGGRAPH
//! 94; F. Sillion, *A unified hierarchical algorithm for global illumination with scattering volumes and
//! object clusters*, IEEE TVCG 1 (1995); R. Ramamoorthi, P. Hanrahan, *On the relationship between radiance
//! and irradiance*, JOSA A 18 (2001).

pub mod harmonics;
mod face;
mod grouping;
mod tree;
mod options;
mod exchange;
mod oracle;
mod sight;
mod pair_refinement;
mod fields;
mod links;
mod handing_down;
mod network;
mod error;
mod band_system;
mod solution;
mod driver;
mod leaf_elements;

pub use band_system::BandSystem;
pub use driver::solve_hierarchically;
pub use error::HierarchyError;
pub use fields::Fields;
pub use leaf_elements::{LinkedElements, leaf_elements};
pub use network::{Counts, Hierarchy, Leaf};
pub use options::{HierarchyOptions, LinkMeasure};
pub use solution::Hierarchical;
