//! Broken copies of right texts are read or refused, never more.

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use radiosity_formats::model::{Model, Shape};
use radiosity_formats::vs3;
use radiosity_photometry::error::Refusal;

use crate::measures::Memory;

/// One change of a text; places are parts of its length.
#[derive(Clone, Debug)]
enum Mutation {
    Flip(f64, u8),
    Cut(f64, f64),
    Repeat(f64, f64),
    Word(f64, String),
}

/// Words that take the place of numbers and names.
const WORDS: [&str; 16] = [
    "1e999",
    "-1",
    "NaN",
    "0",
    "99999999999",
    "1e308",
    "1e-308",
    "5",
    "",
    "é",
    "<",
    "\"",
    "$",
    "&lt;",
    "&x;",
    "]]",
];

fn mutation() -> impl Strategy<Value = Mutation> {
    let place = || 0.0..1.0f64;
    let word = || prop::sample::select(WORDS.map(str::to_owned).to_vec());
    prop_oneof![
        1 => (place(), any::<u8>()).prop_map(|(at, byte)| Mutation::Flip(at, byte)),
        1 => (place(), place()).prop_map(|(at, length)| Mutation::Cut(at, length)),
        1 => (place(), place()).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        3 => (place(), word()).prop_map(|(at, word)| Mutation::Word(at, word)),
    ]
}

fn mutated(text: &[u8], mutations: &[Mutation]) -> Vec<u8> {
    let mut bytes = text.to_vec();
    for mutation in mutations {
        let count = bytes.len();
        if count == 0 {
            break;
        }
        let at = |part: f64| (part * count as f64) as usize;
        let until = |start: usize, part: f64| (start + (part * 120.0) as usize).min(count);
        match mutation {
            Mutation::Flip(place, byte) => bytes[at(*place)] = *byte,
            Mutation::Cut(place, length) => drop(bytes.drain(at(*place)..until(at(*place), *length))),
            Mutation::Repeat(place, length) => {
                let part = bytes[at(*place)..until(at(*place), *length)].to_vec();
                drop(bytes.splice(at(*place)..at(*place), part));
            }
            Mutation::Word(place, word) => {
                let is_end = |byte: &u8| byte.is_ascii_whitespace() || b"\",[]=".contains(byte);
                let start = bytes[..at(*place)].iter().rposition(is_end).map_or(0, |start| start + 1);
                let end = bytes[start..].iter().position(is_end).map_or(count, |end| start + end);
                drop(bytes.splice(start..end, word.bytes()));
            }
        }
    }
    bytes
}

/// Runs `check` on `cases` broken copies of `text`.
pub(crate) fn break_often(cases: u32, text: &[u8], check: impl Fn(&[u8])) {
    let config =
        Config { cases, rng_seed: RngSeed::Fixed(27), failure_persistence: None, ..Config::default() };
    TestRunner::new(config)
        .run(&prop::collection::vec(mutation(), 1..4), |mutations| {
            check(&mutated(text, &mutations));
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
}

/// The numbers of a shape.
fn numbers(shape: &Shape) -> Vec<f64> {
    let of = |points: &[glam::DVec3]| points.iter().flat_map(|p| p.to_array()).collect::<Vec<f64>>();
    match shape {
        Shape::Polygon { outline, holes } => {
            assert!(outline.len() >= 3 && holes.iter().all(|hole| hole.len() >= 3));
            of(&[outline.clone(), holes.concat()].concat())
        }
        Shape::Quad(points) => of(points),
        Shape::Disk { center, normal, radius, inner } => {
            [of(&[*center, *normal]), vec![*radius, *inner]].concat()
        }
        Shape::Cylinder { base, axis, radius, .. } => [of(&[*base, *axis]), vec![*radius]].concat(),
        Shape::Cone { base, axis, radii, .. } => [of(&[*base, *axis]), radii.to_vec()].concat(),
        Shape::Sphere { center, radius, .. } => [of(&[*center]), vec![*radius]].concat(),
        Shape::Torus { center, axis, major, minor, .. } => {
            [of(&[*center, *axis]), vec![*major, *minor]].concat()
        }
    }
}

/// Asserts the promises of readers: a sound model, or a refusal with a cause and a file.
pub(crate) fn is_promised(found: &Result<Model, Refusal>) {
    let model = match found {
        Ok(model) => model,
        Err(refusal) => {
            assert!(!refusal.cause.is_empty() && !refusal.file.is_empty(), "{refusal:?}");
            return;
        }
    };
    let count = model.bands.len();
    assert!(count == 1 || count == 3);
    for material in &model.materials {
        assert!(material.reflectance.len() == count && material.emission.len() == count, "{material:?}");
        let mut values = material.reflectance.iter().chain(&material.emission);
        assert!(values.all(|value| value.is_finite() && *value >= 0.0), "{material:?}");
    }
    for surface in &model.surfaces {
        assert!(surface.material.is_none_or(|index| index < model.materials.len()));
        assert!(numbers(&surface.shape).iter().all(|x| x.is_finite()), "{surface:?}");
    }
}

fn break_vs3(cases: u32) {
    for text in [&include_bytes!("../fixtures/window.vs3")[..], include_bytes!("../fixtures/l-room-3a.vs3")] {
        break_often(cases, text, |bytes| {
            let found = vs3::read("broken", bytes, &Memory::default());
            is_promised(&found);
            let Ok(model) = found else { return };
            if let Ok(text) = vs3::write::write(&model) {
                let again = vs3::read("again", text.as_bytes(), &Memory::default());
                assert!(again.is_ok_and(|again| again.surfaces.len() >= model.surfaces.len()), "{text}");
            }
        });
    }
}

#[test]
fn broken_view3d_inputs_are_read_or_refused() {
    break_vs3(256);
}

#[test]
#[ignore = "takes a minute"]
fn ten_thousand_broken_view3d_inputs_are_read_or_refused() {
    break_vs3(10_000);
}
