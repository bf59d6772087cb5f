//! Interchangeable solvers for dense block systems, each with an honest residual.
