//! Faults of files of other programs: scenes, materials and luminaires.

mod ply;
mod stl;
mod obj;
mod mtl;
mod gltf;
mod mgf;
mod rad;
mod mitsuba;
mod vs3;
mod sheet;
mod ies;
mod ldt;

use super::Changed;

/// Files that are refused, and files that are right, by format.
pub(super) const CHANGED: &[Changed] = &[
    ply::CHANGED,
    stl::CHANGED,
    obj::CHANGED,
    mtl::CHANGED,
    gltf::CHANGED,
    mgf::CHANGED,
    rad::CHANGED,
    mitsuba::CHANGED,
    vs3::CHANGED,
    sheet::CHANGED,
    ies::CHANGED,
    ldt::CHANGED,
];
