//! Benches of all packages, each a question about speed: `README.md` has the questions and the figures, `core/`,
//! `geom/` and `solvers/` those of the packages that are used by themselves.
