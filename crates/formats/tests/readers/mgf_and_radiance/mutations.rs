//! Broken copies of right scenes are read or refused, never more.

use radiosity_formats::model::{Model, Shape};
use radiosity_formats::{mgf, rad};
use radiosity_photometry::error::Refusal;
use radiosity_test_support::mutations::break_often;

use crate::memory::Memory;
use crate::promises::{assert_promised, parts};

type Reader = fn(&str, &[u8], &Memory) -> Result<Model, Refusal>;

/// Replacements of words of MGF and Radiance.
const WORDS: [&str; 6] = ["-a 99999", "=", "xf", "\\\n", "{", "!"];

/// Whether no number of a shape is so large or so small that sums of numbers lose it.
fn is_usual(shape: &Shape) -> bool {
    let (points, numbers, _) = parts(shape);
    let mut all = points.iter().flat_map(|point| point.to_array()).chain(numbers);
    all.all(|number| number == 0.0 || (1e-4..1e4).contains(&number.abs()))
}

/// Checks the promises of all readers, that every surface has a material, and that what is written can be read.
fn check(found: Result<Model, Refusal>) {
    assert_promised(&found);
    let Ok(model) = found else { return };
    assert!(model.surfaces.iter().all(|surface| surface.material.is_some()));
    if let Ok(text) = mgf::write::write(&model)
        && model.surfaces.iter().all(|surface| is_usual(&surface.shape))
    {
        let again = mgf::read("again", text.as_bytes(), &Memory::default());
        assert!(again.is_ok_and(|again| again.surfaces.len() == model.surfaces.len()), "{text}");
    }
}

fn break_texts(cases: u32) {
    let mgf_text =
        format!("{}i part.mgf -a 2 -t 1 0 0\nxf -a 3 -t 0 0 1 -a 2 -mx\nsph a 1\nxf\n", super::mgf::ALL);
    let rad_text =
        format!("{}!xform -a 2 -t 0 0 1 part.rad\n!genbox white b 1 1 1 | xform -mx\n", super::rad::ALL);
    let files = Memory::of([
        ("part.mgf", "v a =\nm red\nsph a 1\nf a b c\n"),
        ("part.rad", "white sphere ball 0 0 4 0 0 0 1\n"),
    ]);
    let mgf_reader: Reader = |file, bytes, files| mgf::read(file, bytes, files);
    let rad_reader: Reader = |file, bytes, files| rad::read(file, bytes, files);
    for (reader, text) in [(mgf_reader, mgf_text), (rad_reader, rad_text)] {
        assert!(reader("whole", text.as_bytes(), &files).is_ok());
        break_often(cases, text.as_bytes(), &WORDS, |bytes| check(reader("broken", bytes, &files)));
    }
}

#[test]
fn broken_texts_are_read_or_refused() {
    break_texts(256);
}

#[test]
#[ignore = "takes a minute"]
fn ten_thousand_broken_texts_are_read_or_refused() {
    break_texts(10_000);
}
