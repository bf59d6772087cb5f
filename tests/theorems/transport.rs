//! Evidence for the transport between elements: exact transfers, theorems on random shapes, whole rooms.

#![expect(clippy::print_stdout, reason = "errors and costs are measured here, and shown with --nocapture")]

mod among_others;
mod balls;
mod contour;
mod coaxial;
mod convex_rooms;
mod curved;
mod dented_rooms;
mod empty_box;
mod flat;
mod flush;
mod furnace;
mod grazing;
mod horizons;
mod paper;
mod past_frusta;
mod polyhedra;
mod room;
mod sampled;
mod turned;
mod shapes;
mod stress;
mod tangent;
mod transfers;
mod tubes_apart;
mod unreached;
mod view_factors;
