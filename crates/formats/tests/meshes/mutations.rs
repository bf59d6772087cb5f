//! Broken copies of right files are read or refused, never more.

use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use radiosity_formats::model::{Model, Shape};
use radiosity_formats::{gltf, obj, ply, stl};
use radiosity_photometry::error::Refusal;

use crate::shapes::InMemory;

/// One change; places are parts of the length.
#[derive(Clone, Debug)]
enum Mutation {
    Flip(f64, u8),
    Cut(f64, f64),
    Repeat(f64, f64),
    /// Replaces the word at a place.
    Word(f64, &'static str),
    /// Overwrites four bytes at a place.
    Bytes(f64, [u8; 4]),
}

const WORDS: [&str; 14] = [
    "1e999",
    "-1",
    "NaN",
    "0",
    "99999999999",
    "1e308",
    "1e-308",
    "3.5",
    "\\\n",
    "[",
    "{}",
    "null",
    "é",
    "\"a\"",
];

fn mutation() -> impl Strategy<Value = Mutation> {
    let place = || 0.0..1.0f64;
    let words = [[0xff; 4], [0; 4], [0, 0, 0x80, 0x7f], [0, 0, 0xc0, 0x7f], [0x7f, 0xff, 0xff, 0xff]];
    prop_oneof![
        (place(), any::<u8>()).prop_map(|(at, byte)| Mutation::Flip(at, byte)),
        (place(), place()).prop_map(|(at, length)| Mutation::Cut(at, length)),
        (place(), place()).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        (place(), prop::sample::select(WORDS.to_vec())).prop_map(|(at, word)| Mutation::Word(at, word)),
        (place(), prop::sample::select(WORDS.to_vec())).prop_map(|(at, word)| Mutation::Word(at, word)),
        (place(), prop::sample::select(words.to_vec())).prop_map(|(at, word)| Mutation::Bytes(at, word)),
    ]
}

fn mutated(whole: &[u8], mutations: &[Mutation]) -> Vec<u8> {
    let mut bytes = whole.to_vec();
    for mutation in mutations {
        let count = bytes.len();
        if count == 0 {
            break;
        }
        let at = |part: f64| (part * count as f64) as usize;
        let until = |start: usize, part: f64| (start + (part * 100.0) as usize).min(count);
        match *mutation {
            Mutation::Flip(place, byte) => bytes[at(place)] = byte,
            Mutation::Cut(place, length) => drop(bytes.drain(at(place)..until(at(place), length))),
            Mutation::Repeat(place, length) => {
                let part = bytes[at(place)..until(at(place), length)].to_vec();
                drop(bytes.splice(at(place)..at(place), part));
            }
            Mutation::Word(place, word) => {
                let ends = |byte: &u8| byte.is_ascii_whitespace() || b",:[]{}/".contains(byte);
                let start = bytes[..at(place)].iter().rposition(ends).map_or(0, |start| start + 1);
                let end = bytes[start..].iter().position(ends).map_or(count, |end| start + end);
                drop(bytes.splice(start..end, word.bytes()));
            }
            Mutation::Bytes(place, word) => {
                let end = (at(place) + 4).min(count);
                let start = at(place);
                bytes[start..end].copy_from_slice(&word[..end - start]);
            }
        }
    }
    bytes
}

/// Asserts the promises of readers: a sound model, or a refusal with a cause, a cure and a file.
fn assert_promises(result: Result<Model, Refusal>) {
    let model = match result {
        Ok(model) => model,
        Err(refusal) => {
            assert!(!refusal.cause.is_empty() && !refusal.file.is_empty());
            assert!(refusal.cause.len() < 500 && !refusal.cure.is_empty(), "{refusal}: {}", refusal.cure);
            return;
        }
    };
    let mut names: Vec<&str> = model.surfaces.iter().map(|surface| surface.name.as_str()).collect();
    names.sort_unstable();
    assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
    for surface in &model.surfaces {
        assert!(surface.material.is_none_or(|material| material < model.materials.len()));
        assert!(!surface.name.trim().is_empty() && surface.place.is_some());
        let rings: Vec<&[DVec3]> = match &surface.shape {
            Shape::Polygon { outline, holes } => {
                std::iter::once(outline.as_slice()).chain(holes.iter().map(Vec::as_slice)).collect()
            }
            Shape::Quad(corners) => vec![corners],
            other => panic!("{other:?}"),
        };
        assert!(rings.iter().all(|ring| ring.len() > 2 && ring.iter().all(|corner| corner.is_finite())));
    }
    for material in &model.materials {
        let values = || material.reflectance.iter().chain(&material.emission);
        assert!(values().all(|value| value.is_finite() && *value >= 0.0));
        assert_eq!(
            (material.reflectance.len(), material.emission.len()),
            (model.bands.len(), model.bands.len())
        );
    }
    assert!(model.camera.is_none_or(|camera| camera.eye.is_finite() && camera.target.is_finite()));
}

/// Mutates every fixture of every format.
fn hunt(cases: u32) {
    let files = InMemory::of(&[("cube.mtl", crate::obj::MTL.as_bytes())]);
    let strategy = (0..9usize, prop::collection::vec(mutation(), 1..6));
    let config =
        Config { cases, rng_seed: RngSeed::Fixed(11), failure_persistence: None, ..Config::default() };
    let run = |(fixture, mutations): (usize, Vec<Mutation>)| {
        let change = |bytes: &[u8]| mutated(bytes, &mutations);
        assert_promises(match fixture {
            0 => stl::read("a.stl", &change(crate::stl::text().as_bytes()), &files),
            1 => stl::read("a.stl", &change(&crate::stl::bits()), &files),
            2 => ply::read("a.ply", &change(crate::ply::text().as_bytes()), &files),
            3 => ply::read("a.ply", &change(&crate::ply::bits(true)), &files),
            4 => obj::read("a.obj", &change(crate::obj::text().as_bytes()), &files),
            5 => obj::read("a.obj", &change(crate::obj::odd().as_bytes()), &files),
            6 => {
                let files = InMemory::of(&[("cube.mtl", &change(crate::obj::MTL.as_bytes()))]);
                obj::read("a.obj", crate::obj::text().as_bytes(), &files)
            }
            7 => gltf::read("a.gltf", &change(crate::gltf::text().as_bytes()), &files),
            _ => gltf::read("a.glb", &change(&crate::gltf::bits()), &files),
        });
        Ok(())
    };
    TestRunner::new(config).run(&strategy, run).unwrap();
}

#[test]
fn mutated_files_are_read_or_refused() {
    hunt(256);
}

#[test]
#[ignore = "a longer hunt: seconds, even without optimisation"]
fn many_mutated_files_are_read_or_refused() {
    hunt(40_000);
}
