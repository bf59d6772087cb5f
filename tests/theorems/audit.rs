//! Evidence for the referee: its readings against furnaces, closed forms and quadratures within its own errors,
//! faults that are planted, and how often it raises a false alarm.

#![expect(clippy::print_stdout, reason = "what was found is printed with --nocapture")]

mod trial;
mod fairness;
mod furnaces;
mod lamps;
mod web;
mod luminaires;
mod skies;
mod stacks;
mod means;
mod all;
mod whole;
mod random;
mod alarms;
mod faults;
