//! Surfaces that are best left uncut where they carry constants, as a rule knows what wholes exchange.

use radiosity_visibility::Visibility;

use crate::coaxial;
use crate::occlusion::beside_frusta;

/// For each surface, whether it is best left uncut: beside coaxial cylinders, and of disks past cans, cones and disks.
pub fn best_whole(visibility: &Visibility, surfaces: usize) -> Vec<bool> {
    let coaxial = coaxial::best_whole(visibility, surfaces);
    let past_frusta = beside_frusta::best_whole(visibility, surfaces);
    coaxial.into_iter().zip(past_frusta).map(|(one, other)| one || other).collect()
}
