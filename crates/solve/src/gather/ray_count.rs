//! Numbers of rays by which light is gathered.

/// Relative standard deviation times the number of rays to the power ¾: up to this in rooms. Measured in the
/// Cornell box.
const ROUGHNESS: f64 = 1.5;

/// Most rays over their expected number, for a point that is read alone, and for one of the many of a picture
/// or a grid; never more than [`MOST`] are sent: some ten seconds, which is chosen, as the latter is.
/// Measured at points of eight random rooms with lampshades of paper: with 16 and 64 they erred by 3.2 to 6.1
/// % and 1.3 to 4.7 % (L2), the noise of what is right of 1 to 3 % among it, after .7 to 1.0 and 1.2 to 2.1
/// s.
pub(super) const PATIENCE: f64 = 64.0;
pub(super) const PATIENCE_OF_MANY: f64 = 16.0;
const MOST: f64 = 1.6e7;

/// Cosine-distributed rays that an error of `eps` takes.
pub(super) fn usual_rays(eps: f64) -> f64 {
    (ROUGHNESS / eps).powf(4.0 / 3.0)
}

/// Cosine-distributed rays of each sequence before the error is first looked at; in pictures, where readings
/// beside each other are averaged. Half of the former took errors of 2 % for 1 % at bright points of a
/// classroom.
pub(super) const FIRST: u64 = 64;
pub(super) const FIRST_OF_MANY: u64 = 32;

/// As [`FIRST`], of the cells of a grid. Measured in an office: its grid took 7.7 s with 16, which let more cells stop
/// whose sequences agree by chance, and 7.5 s with 32.
pub(super) const FIRST_OF_CELLS: u64 = 32;

/// Rays of each sequence to emitters that are far from a patch before the error is first looked at. Chosen.
pub(super) const FIRST_TO_FAR: u64 = 16;

/// As [`FIRST_OF_MANY`] where all are parts of one sequence. Measured in an office of 160 × 120 pixels: with 32, 16 and
/// 8 a picture took 4.6, 3.6 and 3.6 million rays and erred by 1.04, 1.07 and 1.12 %.
pub(super) const FIRST_TOGETHER: u64 = 16;

/// Noise of a walk, over the light that is read, up to which walks reach what is asked for. Measured: up to 2 in
/// rooms.
const NOISE: f64 = 8.0;

/// Most surfaces that walks come to for a reading, each of which takes two rays: some five seconds, in which walks
/// are many where a hundredth is absorbed, and a few hundred where a ten-thousandth is. Chosen.
pub(super) const MOST_SURFACES: u64 = 4_000_000;

/// Noise of a walk, over the light that is read, in most rooms. Measured: .2 to 1.5.
const USUAL_NOISE: f64 = 0.6;

/// Walks that an error of `eps` takes.
pub(super) fn usual_walks(eps: f64) -> f64 {
    (USUAL_NOISE / eps).powi(2)
}

/// Most walks for an error of `eps`.
pub(super) fn most_walks(eps: f64) -> u64 {
    (NOISE / eps).powi(2).min(MOST) as u64
}

/// Most cosine-distributed rays for an error of `eps`, with so much patience.
pub(super) fn most_rays(eps: f64, patience: f64) -> u64 {
    (patience * usual_rays(eps)).min(MOST) as u64
}
