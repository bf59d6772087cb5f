//! Theorems that must hold for every method on every system.

mod agreement;
mod choice;
mod exact;
mod factored;
mod operators;
mod refusals;
mod settings;
mod shooting;
mod stress;
mod threads;
mod variational;
