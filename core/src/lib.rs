//! Orthogonal polynomials and Gauss rules, without std and without allocation.
#![no_std]
