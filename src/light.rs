//! Irradiance at a point from elements with a known radiosity: direct light, light reflected once, and the first bounce;
//! [`crate::gather`] combines them.
//!
//! ```text
//! E(x) = ∫ κ(x, y) V(x, y) B(y) dA_y ≈ Σ_cells F_c B̄_c ,     B̄_c = Σ_a w_a κ_a V_a B_a / Σ_a w_a κ_a V_a
//! ```
//!
//! Every element is a tree of `cell`s with B at 2 × 2 Gauss points each, walked from each point anew (`traversal`):
//!
//! * a cell that all blockers leave free and that is far from x: F_c B̄_c is the Gauss rule itself;
//! * a flat cell nearer by: F_c is Lambert's closed form, so that contacts cost nothing where B varies little;
//! * a flat cell that planar blockers hide in part: F_c is Lambert's form on its visible pieces
//!   ([`crate::irradiance::visible_polygon`]);
//! * where a cell or a blocker is curved: the Gauss rule or Lambert's form, times the part that lines across the cell show
//!   as seen (`lines::line_quadrature`). A blocker's silhouette mesh shows where its outline crosses a line (`lines::hidden_spans`), and Newton steps
//!   move the crossing from the mesh to the surface itself (`lines::silhouette`);
//! * such a cell that can send no more than the tolerance: its points, each seen or hidden by itself;
//! * a curved surface that shines evenly and hides nothing of itself: Lambert's form on its outline, times the part that lines
//!   across it show as seen, without cells (`area_light`).
//!
//! A cell is divided while the error expected of its rule is above the tolerance: for a clear cell of width h at distance r
//! about F (B 0.02 (h/r)⁴ + ΔB 0.05 (h/r)³), with ΔB the variation of B over it, F ΔB where Lambert's form is used. Blockers
//! are looked for once for a site, a point or a small piece of surface (`occluders`), and cell after cell only those
//! that still may hide something of it are kept.

pub(crate) mod hierarchy;
pub(crate) mod occluders;
pub mod receiver_point;
pub(crate) mod lines;
pub(crate) mod area_light;
pub(crate) mod blockers;
pub(crate) mod traversal;
pub mod direct;
pub(crate) mod reflected;
pub(crate) mod first_bounce;
