//! The referee of heat and of view factors against closed forms and integral equations, by its own errors; and
//! that it sees faults.

mod scored;
mod spheres;
mod zones;
mod enclosures;
mod tubes;
mod refusals;
mod strips;
mod closed_forms;
mod factors;
