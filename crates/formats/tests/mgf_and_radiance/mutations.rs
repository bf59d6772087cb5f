//! Broken copies of right scenes are read or refused, never more.

use std::collections::HashMap;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use radiosity_formats::mgf;
use radiosity_formats::model::{Model, Shape};
use radiosity_formats::rad;
use radiosity_photometry::error::Refusal;

use crate::measures::Memory;
use crate::written::parts;

/// One change of a text; places are parts of its length.
#[derive(Clone, Debug)]
enum Mutation {
    Flip(f64, u8),
    Cut(f64, f64),
    Repeat(f64, f64),
    Swap(f64, &'static str),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let place = || 0.0..1.0f64;
    let words = [
        "1e999",
        "-1",
        "NaN",
        "0",
        "99999999999",
        "1e308",
        "1e-308",
        "-a 99999",
        "=",
        "xf",
        "\\\n",
        "{",
        "é",
        "!",
    ];
    prop_oneof![
        (place(), any::<u8>()).prop_map(|(at, byte)| Mutation::Flip(at, byte)),
        (place(), place()).prop_map(|(at, length)| Mutation::Cut(at, length)),
        (place(), place()).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        (place(), prop::sample::select(words.to_vec())).prop_map(|(at, word)| Mutation::Swap(at, word)),
        (place(), prop::sample::select(words.to_vec())).prop_map(|(at, word)| Mutation::Swap(at, word)),
    ]
}

fn mutated(text: &str, mutations: &[Mutation]) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for mutation in mutations {
        if bytes.is_empty() {
            break;
        }
        let count = bytes.len();
        let at = |part: f64| (part * count as f64) as usize;
        let until = |start: usize, part: f64| (start + (part * 100.0) as usize).min(count);
        match *mutation {
            Mutation::Flip(place, byte) => bytes[at(place)] = byte,
            Mutation::Cut(place, length) => drop(bytes.drain(at(place)..until(at(place), length))),
            Mutation::Repeat(place, length) => {
                let part = bytes[at(place)..until(at(place), length)].to_vec();
                drop(bytes.splice(at(place)..at(place), part));
            }
            Mutation::Swap(place, word) => {
                let is_blank = |byte: &u8| byte.is_ascii_whitespace();
                let start = bytes[..at(place)].iter().rposition(is_blank).map_or(0, |start| start + 1);
                let end = bytes[start..].iter().position(is_blank).map_or(count, |end| start + end);
                drop(bytes.splice(start..end, word.bytes()));
            }
        }
    }
    bytes
}

type Reader = fn(&str, &[u8], &Memory) -> Result<Model, Refusal>;

/// Whether no number of a shape is so large or so small that sums of numbers lose it.
fn is_usual(shape: &Shape) -> bool {
    let (points, numbers, _) = parts(shape);
    let mut all = points.iter().flat_map(|point| point.to_array()).chain(numbers);
    all.all(|number| number == 0.0 || (1e-4..1e4).contains(&number.abs()))
}

/// Asserts the promises of readers: a sound model, which can be written and read again, or a refusal with a
/// cause and a file.
fn check(found: Result<Model, Refusal>) {
    match found {
        Ok(model) => {
            let count = model.bands.len();
            assert!(count == 1 || count == 3);
            for material in &model.materials {
                assert!(material.reflectance.len() == count && material.emission.len() == count);
                let values = material.reflectance.iter().chain(&material.emission);
                assert!(values.copied().all(|value| value.is_finite() && value >= 0.0), "{material:?}");
            }
            assert!(
                model
                    .surfaces
                    .iter()
                    .all(|surface| surface.material.is_some_and(|k| k < model.materials.len()))
            );
            if let Ok(text) = mgf::write::write(&model)
                && model.surfaces.iter().all(|surface| is_usual(&surface.shape))
            {
                let again = mgf::read("again", text.as_bytes(), &Memory::default());
                assert!(again.is_ok_and(|again| again.surfaces.len() == model.surfaces.len()), "{text}");
            }
        }
        Err(refusal) => assert!(!refusal.cause.is_empty() && !refusal.file.is_empty(), "{refusal:?}"),
    }
}

fn break_often(cases: u32) {
    let mgf_text =
        format!("{}i part.mgf -a 2 -t 1 0 0\nxf -a 3 -t 0 0 1 -a 2 -mx\nsph a 1\nxf\n", crate::mgf::ALL);
    let rad_text =
        format!("{}!xform -a 2 -t 0 0 1 part.rad\n!genbox white b 1 1 1 | xform -mx\n", crate::rad::ALL);
    let files = Memory(HashMap::from([
        ("part.mgf", "v a =\nm red\nsph a 1\nf a b c\n"),
        ("part.rad", "white sphere ball 0 0 4 0 0 0 1\n"),
    ]));
    let mgf_reader: Reader = |file, bytes, files| mgf::read(file, bytes, files);
    let rad_reader: Reader = |file, bytes, files| rad::read(file, bytes, files);
    for (reader, text) in [(mgf_reader, mgf_text), (rad_reader, rad_text)] {
        assert!(reader("whole", text.as_bytes(), &files).is_ok());
        let config =
            Config { cases, rng_seed: RngSeed::Fixed(27), failure_persistence: None, ..Config::default() };
        TestRunner::new(config)
            .run(&prop::collection::vec(mutation(), 1..4), |mutations| {
                check(reader("broken", &mutated(&text, &mutations), &files));
                Ok(())
            })
            .unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn broken_texts_are_read_or_refused() {
    break_often(256);
}

#[test]
#[ignore = "takes a minute"]
fn ten_thousand_broken_texts_are_read_or_refused() {
    break_often(10_000);
}
