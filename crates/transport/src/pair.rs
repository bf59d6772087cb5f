//! The block of one pair of elements, whatever they are: a queue of pairs of parts ([`job`]), and the rules that
//! each of these is summed by, [`flat`] or [`curved`].

pub(crate) mod tolerance;
mod size;
mod budget;
mod job;
pub(crate) mod flat;
pub(crate) mod curved;
