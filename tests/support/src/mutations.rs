//! Broken copies of files that are right: whatever reads them must read or refuse, never panic.

use std::ops::Range;

use proptest::prelude::*;
use proptest::test_runner::TestRunner;

use crate::random::seeded;

/// A change of a file; places are parts of its length, in [0, 1).
#[derive(Clone, Debug)]
enum Mutation {
    Flip(f64, u8),
    Cut(f64, f64),
    Repeat(f64, f64),
    /// Overwrites a part by a copy of the part at another place.
    Splice(f64, f64, f64),
    /// Replaces the word at a place.
    Word(f64, &'static str),
    /// Replaces the first number behind a place by another one.
    Number(f64, &'static str),
    /// Overwrites four bytes.
    Bytes(f64, [u8; 4]),
}

/// Texts that are put in place of numbers and names in every format.
const NUMBERS: [&str; 10] = ["1e999", "-1", "NaN", "0", "99999999999", "1e308", "1e-308", "3.5", "", "é"];
/// Finite numbers, small and huge, that formats do not rule out by their form.
const FINITE: [&str; 12] =
    ["0", "1", "-1", "2", "0.5", "7", "1e-9", "-1e9", "1e15", "1e30", "4294967296", "100000000"];
/// Ends of words, besides blanks.
const ENDS: &[u8] = b"\",:[]{}/=";
/// Most bytes that are cut or repeated at once.
const LONGEST: f64 = 120.0;

fn mutation(words: &[&'static str]) -> impl Strategy<Value = Mutation> {
    let place = || 0.0..1.0f64;
    let words = [&NUMBERS[..], words].concat();
    let four = [[0xff; 4], [0; 4], [0, 0, 0x80, 0x7f], [0, 0, 0xc0, 0x7f], [0x7f, 0xff, 0xff, 0xff]];
    prop_oneof![
        1 => (place(), any::<u8>()).prop_map(|(at, byte)| Mutation::Flip(at, byte)),
        1 => (place(), place()).prop_map(|(at, length)| Mutation::Cut(at, length)),
        1 => (place(), place()).prop_map(|(at, length)| Mutation::Repeat(at, length)),
        1 => (place(), place(), place()).prop_map(|(to, from, length)| Mutation::Splice(to, from, length)),
        4 => (place(), prop::sample::select(&FINITE[..])).prop_map(|(at, own)| Mutation::Number(at, own)),
        3 => (place(), prop::sample::select(words)).prop_map(|(at, word)| Mutation::Word(at, word)),
        1 => (place(), prop::sample::select(four.to_vec())).prop_map(|(at, four)| Mutation::Bytes(at, four)),
    ]
}

fn mutate(bytes: &mut Vec<u8>, mutation: &Mutation) {
    let count = bytes.len();
    let at = |part: f64| (part * count as f64) as usize;
    let part = |place: f64, length: f64| at(place)..(at(place) + (length * LONGEST) as usize).min(count);
    match *mutation {
        _ if bytes.is_empty() => {}
        Mutation::Flip(place, byte) => bytes[at(place)] = byte,
        Mutation::Cut(place, length) => drop(bytes.drain(part(place, length))),
        Mutation::Repeat(place, length) => {
            let repeated = bytes[part(place, length)].to_vec();
            drop(bytes.splice(at(place)..at(place), repeated));
        }
        Mutation::Splice(to, from, length) => {
            let copied = bytes[part(from, length)].to_vec();
            let end = (at(to) + copied.len()).min(count);
            drop(bytes.splice(at(to)..end, copied));
        }
        Mutation::Word(place, word) => {
            let word_there = word_at(bytes, at(place));
            drop(bytes.splice(word_there, word.bytes()));
        }
        Mutation::Number(place, number) => {
            let mut words = std::iter::successors(Some(word_at(bytes, at(place))), |word| {
                (word.end < count).then(|| word_at(bytes, word.end + 1))
            });
            let is_number = |word: &Range<usize>| {
                std::str::from_utf8(&bytes[word.clone()]).is_ok_and(|word| word.parse::<f64>().is_ok())
            };
            if let Some(found) = words.find(is_number) {
                drop(bytes.splice(found, number.bytes()));
            }
        }
        Mutation::Bytes(place, four) => {
            let start = at(place);
            let end = (start + 4).min(count);
            bytes[start..end].copy_from_slice(&four[..end - start]);
        }
    }
}

/// The word at a place.
fn word_at(bytes: &[u8], place: usize) -> Range<usize> {
    let ends = |byte: &u8| byte.is_ascii_whitespace() || ENDS.contains(byte);
    let start = bytes[..place].iter().rposition(ends).map_or(0, |start| start + 1);
    let end = bytes[start..].iter().position(ends).map_or(bytes.len(), |end| start + end);
    start..end
}

/// Runs `check` on so many broken copies of a file, whose format has these `words`; panics with the smallest
/// that it fails on.
pub fn break_often(cases: u32, whole: &[u8], words: &[&'static str], check: impl Fn(&[u8])) {
    let changes = prop::collection::vec(mutation(words), 1..5);
    let tried = TestRunner::new(seeded(cases, 27)).run(&changes, |mutations| {
        let mut bytes = whole.to_vec();
        mutations.iter().for_each(|mutation| mutate(&mut bytes, mutation));
        check(&bytes);
        Ok(())
    });
    tried.unwrap_or_else(|error| panic!("{error}"));
}
