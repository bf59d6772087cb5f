//! Readers of MGF and of Radiance scenes, and the writer of MGF.

mod measures;
mod mgf;
mod written;
mod rad;
mod mutations;
mod rooms;
