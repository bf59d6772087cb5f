//! Broken copies of right files are read or refused, never more.

use std::collections::HashSet;

use radiosity_formats::model::{Model, Shape};
use radiosity_formats::{gltf, obj, ply, stl};
use radiosity_photometry::error::Refusal;
use radiosity_test_support::mutations::break_often;

use super::obj::MTL;
use crate::measures::names;
use crate::memory::Memory;
use crate::promises::assert_promised;

/// Replacements of words of meshes.
const WORDS: [&str; 5] = ["\\\n", "[", "{}", "null", "\"a\""];

/// Checks the promises of all readers, and that surfaces are flat, have a place and names of their own.
fn check(found: Result<Model, Refusal>) {
    assert_promised(&found);
    let Ok(model) = found else { return };
    let is_flat = |shape: &Shape| matches!(shape, Shape::Polygon { .. } | Shape::Quad(_));
    assert!(model.surfaces.iter().all(|surface| is_flat(&surface.shape) && surface.place.is_some()));
    assert_eq!(names(&model).into_iter().collect::<HashSet<_>>().len(), model.surfaces.len());
}

/// Mutates every fixture of every format.
fn hunt(cases: u32) {
    let files = super::obj::beside();
    let hunt = |whole: &[u8], read: &dyn Fn(&[u8]) -> Result<Model, Refusal>| {
        assert!(read(whole).is_ok());
        break_often(cases / 9, whole, &WORDS, |bytes| check(read(bytes)));
    };
    for whole in [super::stl::text().as_bytes(), &super::stl::bits()] {
        hunt(whole, &|bytes| stl::read("a.stl", bytes, &files));
    }
    for whole in [super::ply::text().as_bytes(), &super::ply::bits(true)] {
        hunt(whole, &|bytes| ply::read("a.ply", bytes, &files));
    }
    for whole in [super::obj::text(), super::obj::odd()] {
        hunt(whole.as_bytes(), &|bytes| obj::read("a.obj", bytes, &files));
    }
    let of_cube = super::obj::text();
    hunt(MTL.as_bytes(), &|bytes| obj::read("a.obj", of_cube.as_bytes(), &Memory::of([("cube.mtl", bytes)])));
    hunt(super::gltf::text().as_bytes(), &|bytes| gltf::read("a.gltf", bytes, &files));
    hunt(&super::gltf::bits(), &|bytes| gltf::read("a.glb", bytes, &files));
}

#[test]
fn mutated_files_are_read_or_refused() {
    hunt(288);
}

#[test]
#[ignore = "a longer hunt: seconds, even without optimisation"]
fn many_mutated_files_are_read_or_refused() {
    hunt(40_000);
}
