//! Polynomial bases in two variables, orthonormal on their domain.
//!
//! | | domain | functions | order |
//! | --- | --- | --- | --- |
//! | [`total`] | square [−1, 1]² | p_i(s) p_j(t), i + j ≤ N | by total degree, then j |
//! | [`tensor`] | square [−1, 1]² | p_i(s) p_j(t), i, j ≤ N | by i, then j |
//! | [`triangle`] | (−1, −1), (1, −1), (−1, 1) | Dubiner's, i + j ≤ N | as [`total`] |

pub mod tensor;
pub mod total;
pub mod triangle;
