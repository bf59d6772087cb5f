//! What a point sees: the light that arrives from the visible part of elements with a given radiosity.
//!
//! ```text
//! E(x) = ∫ κ(x, y) V(x, y) B(y) dA_y ≈ Σ_cells F_c B̄_c ,     B̄_c = Σ_a w_a κ_a V_a B_a / Σ_a w_a κ_a V_a
//! ```
//!
//! Every element is a tree of `cell`s with B at 2 × 2 Gauss points each, walked from each point anew (`walk`):
//!
//! * a cell that all blockers leave free and that is far from x: F_c B̄_c is the Gauss rule itself;
//! * a flat cell nearer by: F_c is Lambert's closed form, so that contacts cost nothing where B varies little;
//! * a flat cell that planar blockers hide in part: F_c is Lambert's form on its visible pieces
//!   ([`crate::visibility::exact`]);
//! * where a cell or a blocker is curved: the Gauss rule or Lambert's form, times the part that lines across the cell show
//!   as seen (`strips`). A blocker's net of quads shows where its outline crosses a line (`facets`), and Newton steps
//!   move the crossing from the net to the surface itself (`silhouette`);
//! * such a cell that can send no more than the tolerance: its points, each seen or hidden by itself;
//! * a curved surface that shines evenly and hides nothing of itself: Lambert's form on its outline, times the part that lines
//!   across it show as seen, without cells (`lamp`).
//!
//! A cell is divided while the error expected of its rule is above the tolerance: for a clear cell of width h at distance r
//! about F (B 0.02 (h/r)⁴ + ΔB 0.05 (h/r)³), with ΔB the variation of B over it, F ΔB where Lambert's form is used. Blockers
//! are looked for once for a site, a point or a small piece of surface (`surroundings`), and cell after cell only those
//! that still may hide something of it are kept.

pub(crate) mod cell;
pub(crate) mod tree;
pub(crate) mod surroundings;
pub mod vantage;
pub(crate) mod screen;
pub(crate) mod lamp;
pub(crate) mod silhouette;
pub(crate) mod facets;
pub(crate) mod strips;
pub(crate) mod shadows;
pub(crate) mod walk;
