//! Irradiance at a point from elements of known radiosity: direct light, reflected light, and the first
//! bounce. `solve::gather` combines them.
//!
//! ```text
//! E(x) = ∫ κ(x, y) V(x, y) B(y) dA_y ≈ Σ_cells F_c B̄_c ,     B̄_c = Σ_a w_a κ_a V_a B_a / Σ_a w_a κ_a V_a
//! ```
//!
//! Luminaires that are points have an irradiance of closed form, and one ray tells whether it arrives
//! (`point_lights`); along lines it is integrated (`luminous_line`), and areas are elements. The rest is
//! about elements. Every element is a tree of `cell`s that hold B at 2 × 2 Gauss points each. Each receiver
//! point x traverses the trees (`traversal`). The form factor F_c of a cell depends on the cell and its
//! blockers:
//!
//! * no blocker, far from x: the Gauss rule, F_c B̄_c = Σ_a w_a κ_a B_a;
//! * no blocker, near x, flat cell: Lambert's formula, so that contacts cost nothing where B varies little;
//! * planar blockers, flat cell: Lambert's formula for the visible pieces
//!   ([`radiosity_kernel::irradiance::visible_polygon`]);
//! * curved cell or curved blocker: the Gauss rule or Lambert's formula, times the visible part of scan lines
//!   across the cell (`lines::line_quadrature`). A blocker's silhouette mesh shows where its outline crosses
//!   a line (`lines::hidden_spans`); Newton steps move the crossing from the mesh to the true surface
//!   (`lines::silhouette`);
//! * a cell of the last kind that can send no more than the tolerance: the Gauss rule over its visible
//!   points;
//! * a curved surface of even exitance that hides nothing of itself: Lambert's formula along its outline,
//!   times the visible part of scan lines across it, without cells (`area_light`).
//!
//! Openings to a sky are cut first where the horizon of x crosses them, so that each cell has sky or ground
//! behind it and a smooth radiance.
//!
//! A cell is divided while the expected error of its rule is above the tolerance. For a cell without
//! blockers, of width h at the distance r, with the mean B, the variation ΔB, and the difference δB between
//! B̄ and the mean of its quarters, the error is about F (0.02 B (h/r)⁴ + 0.05 ΔB (h/r)³ + δB) for the Gauss
//! rule and F (ΔB min(1, 0.3 (h/r)²) plus δB) for Lambert's formula (`traversal`). The points of a curved cell may
//! also miss its area and its place, by what another rule shows (`cells::moments`). Possible blockers are
//! listed once per site, which is a point or a small piece of a surface (`occluders`); from cell to cell of a
//! tree only those that may still hide a part of it are kept.
//!
//! Direct light of elements is made in three ways. `solve::gather::gather_method` chooses between the first
//! and the last by their cost at the accuracy asked, pictures between the first two by what is flat.
//!
//! | way | who asks | error | cost at a point |
//! | --- | --- | --- | --- |
//! | cells ([`direct`]) | first bounce, masks, gathering | none if all is flat, else ε | a form each cell |
//! | shadow volumes ([`penumbra`]) | pictures | none behind ≤ 8 flat things, else ε | rays, ~ ε^(−4/3) |
//! | rays ([`lamps`]) | gathering by rays | ε, its deviation is told | rays, ~ ε^(−4/3) |
//!
//! In order: [`tolerances`], [`occluders`], `cells` (trees of cells), [`receiver_point`], [`lamps`] (targets
//! of rays), `lines` (scan lines), `luminous_line`, [`point_lights`] and [`emitters`], `area_light`,
//! `blockers`, `traversal`, [`direct`], `lamp_cells`, `light_sources` and [`penumbra`] (direct light by
//! rays), `coats`, [`reflected`], [`point_transfers`] and [`first_bounce`].
//!
//! Imports `core`, `geom`, `work`, `scene`, `visibility`, `elements` and `kernel`.

pub mod tolerances;
pub mod occluders;
pub(crate) mod cells;
pub mod receiver_point;
pub mod lamps;
pub(crate) mod lines;
mod luminous_line;
pub mod point_lights;
pub mod emitters;
pub(crate) mod area_light;
pub(crate) mod blockers;
pub(crate) mod traversal;
pub mod direct;
mod lamp_cells;
mod light_sources;
pub mod penumbra;
pub(crate) mod coats;
pub mod reflected;
pub mod point_transfers;
pub mod first_bounce;
