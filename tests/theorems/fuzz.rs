//! Broken scene files: whatever is done to a text, it is read or refused, and what is read can be inspected
//! and cut into elements.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use radiosity::elements::{Discretization, Elements};
use radiosity::scene::{Scene, Source};
use radiosity::visibility::inspection::Inspection;
use radiosity_test_support::mutations::break_often;
use radiosity_test_support::readers::{Reader, ReaderAtWork, WORDS};
use radiosity_test_support::scenes::EVERY_SHAPE;

const BUILT_IN: [&str; 5] = ["cornell-box", "empty-box", "furnace-cube", "occluder-box", "hinge-squares"];

/// Numbers at the ends of what a number can be, and words that are none.
const EXTREMES: [&str; 24] = [
    "0", "-0.0", "1", "-1", "2", "0.5", "360", "-360", "1e-9", "1e9", "1e-15", "1e15", "1e-30", "1e30",
    "-1e30", "1e-160", "1e-300", "1e-308", "5e-324", "1e308", "nan", "inf", "\"1\"", "[1]",
];

/// A change of a text; numbers in [0, 1) choose places in proportion.
#[derive(Clone, Debug)]
enum Mutation {
    SetByte(f64, u8),
    DropByte(f64),
    SetNumber(f64, usize),
    /// Multiplies a number by a power of ten.
    ScaleNumber(f64, i32),
    CopyNumber(f64, f64),
    DropToken(f64),
    SwapTokens(f64, f64),
    CopyToken(f64, f64),
    DropLine(f64),
    RepeatLine(f64),
    SwapLines(f64, f64),
    Cut(f64),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let at = || 0.0..1.0;
    prop_oneof![
        1 => (at(), any::<u8>()).prop_map(|(at, byte)| Mutation::SetByte(at, byte)),
        1 => at().prop_map(Mutation::DropByte),
        8 => (at(), 0..EXTREMES.len()).prop_map(|(at, k)| Mutation::SetNumber(at, k)),
        4 => (at(), -20..20).prop_map(|(at, k)| Mutation::ScaleNumber(at, k)),
        4 => (at(), at()).prop_map(|(at, from)| Mutation::CopyNumber(at, from)),
        1 => at().prop_map(Mutation::DropToken),
        1 => (at(), at()).prop_map(|(a, b)| Mutation::SwapTokens(a, b)),
        1 => (at(), at()).prop_map(|(a, b)| Mutation::CopyToken(a, b)),
        2 => at().prop_map(Mutation::DropLine),
        1 => at().prop_map(Mutation::RepeatLine),
        1 => (at(), at()).prop_map(|(a, b)| Mutation::SwapLines(a, b)),
        1 => at().prop_map(Mutation::Cut),
    ]
}

/// Item `at` of `count`, from the first at 0 to the last just before 1.
fn index(at: f64, count: usize) -> usize {
    ((at * count as f64) as usize).min(count.saturating_sub(1))
}

/// Words, numbers and single other characters; joined they give the text again.
fn tokens(text: &str) -> Vec<String> {
    let is_word = |c: char| c.is_alphanumeric() || "_.-+".contains(c);
    let mut tokens: Vec<String> = Vec::new();
    for c in text.chars() {
        match tokens.last_mut() {
            Some(last) if is_word(c) && last.chars().all(is_word) => last.push(c),
            _ => tokens.push(c.to_string()),
        }
    }
    tokens
}

fn edit_tokens(text: &str, edit: impl FnOnce(&mut Vec<String>)) -> String {
    let mut tokens = tokens(text);
    edit(&mut tokens);
    tokens.concat()
}

/// Replaces the number at `at` by what `new` makes of all numbers and its index.
fn edit_number(text: &str, at: f64, new: impl FnOnce(&[f64], usize) -> String) -> String {
    edit_tokens(text, |tokens| {
        let numbers: Vec<(usize, f64)> =
            tokens.iter().enumerate().filter_map(|(k, token)| Some((k, token.parse().ok()?))).collect();
        if !numbers.is_empty() {
            let chosen = index(at, numbers.len());
            let values: Vec<f64> = numbers.iter().map(|(_, value)| *value).collect();
            tokens[numbers[chosen].0] = new(&values, chosen);
        }
    })
}

fn edit_lines(text: &str, edit: impl FnOnce(&mut Vec<&str>)) -> String {
    let mut lines: Vec<&str> = text.lines().collect();
    if !lines.is_empty() {
        edit(&mut lines);
    }
    lines.join("\n")
}

fn edit_bytes(text: &str, edit: impl FnOnce(&mut Vec<u8>)) -> String {
    let mut bytes = text.as_bytes().to_vec();
    if !bytes.is_empty() {
        edit(&mut bytes);
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

fn mutate(text: &str, mutation: &Mutation) -> String {
    let count = |tokens: &Vec<String>, at| index(at, tokens.len());
    match *mutation {
        Mutation::SetByte(at, byte) => edit_bytes(text, |bytes| {
            let k = index(at, bytes.len());
            bytes[k] = byte;
        }),
        Mutation::DropByte(at) => edit_bytes(text, |bytes| {
            bytes.remove(index(at, bytes.len()));
        }),
        Mutation::SetNumber(at, k) => edit_number(text, at, |_, _| EXTREMES[k].to_owned()),
        Mutation::ScaleNumber(at, k) => {
            edit_number(text, at, |values, own| format!("{:e}", values[own] * 10_f64.powi(k)))
        }
        Mutation::CopyNumber(at, from) => {
            edit_number(text, at, |values, _| values[index(from, values.len())].to_string())
        }
        Mutation::DropToken(at) => edit_tokens(text, |tokens| {
            if !tokens.is_empty() {
                drop(tokens.remove(count(tokens, at)))
            }
        }),
        Mutation::SwapTokens(a, b) => edit_tokens(text, |tokens| {
            if !tokens.is_empty() {
                let (a, b) = (count(tokens, a), count(tokens, b));
                tokens.swap(a, b);
            }
        }),
        Mutation::CopyToken(a, b) => edit_tokens(text, |tokens| {
            if !tokens.is_empty() {
                let (a, b) = (count(tokens, a), count(tokens, b));
                tokens[a] = tokens[b].clone();
            }
        }),
        Mutation::DropLine(at) => edit_lines(text, |lines| {
            lines.remove(index(at, lines.len()));
        }),
        Mutation::RepeatLine(at) => edit_lines(text, |lines| {
            let k = index(at, lines.len());
            lines.insert(k, lines[k]);
        }),
        Mutation::SwapLines(a, b) => edit_lines(text, |lines| {
            let (a, b) = (index(a, lines.len()), index(b, lines.len()));
            lines.swap(a, b);
        }),
        Mutation::Cut(at) => edit_bytes(text, |bytes| bytes.truncate(index(at, bytes.len()))),
    }
}

/// The texts in both languages, their parameters set; JSON with one item on a line.
fn texts() -> Vec<(String, bool)> {
    let json = |text: &str| {
        let tree: toml::Value = toml::from_str(text).unwrap();
        serde_json::to_string_pretty(&tree).unwrap()
    };
    let built_in = BUILT_IN.map(|name| radiosity::language::source(name, &[]).unwrap().text().to_string());
    let texts = built_in.into_iter().chain([EVERY_SHAPE.to_owned()]);
    let texts: Vec<String> = texts.collect();
    texts.iter().flat_map(|text| [(text.clone(), false), (json(text), true)]).collect()
}

/// Surfaces cut finer, or of higher order, are left out: they cost time and nothing else.
fn is_small(scene: &Scene) -> bool {
    let cells = |parts: Option<[usize; 2]>| parts.map_or(1, |[u, v]| u * v);
    scene.surfaces.iter().all(|surface| surface.order.unwrap_or(0) <= 4 && cells(surface.subdivide) <= 16)
}

/// Reads, cuts and inspects a text; whether it was read.
fn survives(text: &str, is_json: bool) -> bool {
    let scene = if is_json {
        radiosity::language::read(&Source::new("x.json", text))
    } else {
        radiosity::language::read(&Source::new("x.toml", text))
    };
    if text.len().is_multiple_of(8) {
        let whole = Source::new("room.toml", "title = \"room\"\ninclude = \"x\"").including("x", text);
        let included = radiosity::language::read(&whole);
        assert!(included.is_ok() || scene.is_err(), "what is right alone is right included");
    }
    match scene {
        Ok(scene) => {
            let order = if text.len().is_multiple_of(2) { 0 } else { 2 };
            if is_small(&scene) {
                let cut = Elements::new(&scene, &Discretization::uniform(order, 1));
                let area = |elements: Elements| elements.list().iter().map(|e| e.area).sum::<f64>();
                assert!(cut.map_or(true, |elements| area(elements).is_finite()));
            }
            // An inspection takes longer than all the rest.
            if text.len().is_multiple_of(16) && is_small(&scene) {
                Inspection::of(&scene);
            }
            true
        }
        Err(error) => {
            assert!(!error.fault.to_string().is_empty());
            false
        }
    }
}

/// Runs `cases` mutated texts; panics with the smallest text found that does.
fn run(cases: u32) {
    let texts = texts();
    for (text, is_json) in &texts {
        assert!(survives(text, *is_json), "the texts themselves are right");
    }
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    let broken = (0..texts.len(), prop::collection::vec(mutation(), 1..5));
    let read = std::cell::Cell::new(0);
    TestRunner::new(config)
        .run(&broken, |(k, mutations)| {
            let (text, is_json) = &texts[k];
            let text = mutations.iter().fold(text.clone(), |text, mutation| mutate(&text, mutation));
            let survived = std::panic::catch_unwind(|| survives(&text, *is_json));
            prop_assert!(survived.is_ok(), "{}", text);
            read.set(read.get() + u32::from(survived.is_ok_and(|read| read)));
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
    // Were nearly all refused, little would have been tried.
    assert!(read.get() > cases / 20, "only {} of {cases} texts were read", read.get());
}

/// `cargo run --release -p radiosity-studies --bin mutations` tries more, and takes time and memory.
#[test]
fn broken_files_of_every_reader_are_read_or_refused() {
    for reader in Reader::ALL {
        let at_work = ReaderAtWork::new(reader);
        assert!(at_work.read(&at_work.whole), "{reader:?}: the file itself is right");
        break_often(25, &at_work.whole, &WORDS, |bytes| {
            at_work.read(bytes);
        });
    }
}

#[test]
fn broken_texts_are_read_or_refused() {
    run(1000);
}

#[test]
#[ignore = "takes minutes: a hundred times as many texts"]
fn very_many_broken_texts_are_read_or_refused() {
    run(100_000);
}
