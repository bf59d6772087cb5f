//! Figures of documents: changed ones are found, times never; every output says where it was made, and
//! numbers that texts repeat are those of their tables.

use std::fs;
use std::path::Path;

use radiosity_test_support::documents::block::{Block, blocks};
use radiosity_test_support::documents::comparison::{Difference, Extent, differences};
use radiosity_test_support::documents::number::{Part, parts};
use radiosity_test_support::documents::quotes::{Renewed, renewed};
use radiosity_test_support::documents::shell::{QUOTING, TABLES, WALKS};
use radiosity_test_support::documents::stamp::is_stamp;
use radiosity_test_support::documents::steps::{Kind, Place, Step, steps};

const TABLE: &str = "
| way | samples | error | ratio | s |
| --- | --- | --- | ---: | --- |
| quick, 2 × 2 | 574487 | 0.442 % | 12 | 0.11 |
| quick, 3 × 3 | 1 113 196 | 4.4e-3 in 1.4 µs | 8 | 0.12 |

3 surfaces: error 1.2e-2, 441 links, 0.52 s.
";

fn text(document: &str) -> String {
    fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(document)).expect("the document is there")
}

/// All that differs once a part of the table is another.
fn changed(from: &str, to: &str) -> Vec<Difference> {
    assert!(TABLE.contains(from), "{from}");
    differences(TABLE, &TABLE.replacen(from, to, 1), Extent::Whole)
}

#[test]
fn times_never_differ() {
    let all = [
        ("| 0.11 |", "| 7.5 |"),
        ("| 12 |", "| 99 |"),
        ("1.4 µs", "9.4 µs"),
        ("1.4 µs", "0.23 ms"),
        ("0.52 s", "3 s"),
    ];
    for (from, to) in all {
        assert_eq!(changed(from, to), []);
    }
    let shown = |time: &str| format!("order  samples  seconds  error\n0      297623   {time}   2.5e-1\n");
    assert_eq!(differences(&shown("0.0493"), &shown("1.7"), Extent::Whole), []);
}

#[test]
fn a_unit_of_the_last_digit_is_no_difference_of_errors_and_is_one_of_counts() {
    assert_eq!(changed("0.442 %", "0.443 %"), []);
    assert_eq!(changed("4.4e-3", "4.5e-3"), []);
    assert_eq!(changed("1.2e-2,", "1.1e-2,"), []);
    for (from, to) in [("0.442 %", "0.444 %"), ("4.4e-3", "4.6e-3"), ("1.2e-2,", "1.4e-2,")] {
        assert_eq!(changed(from, to).len(), 1, "{from}");
    }
    for (from, to) in [("574487", "574488"), ("1 113 196", "1 113 197"), ("441 links", "442 links")] {
        assert_eq!(changed(from, to).len(), 1, "{from}");
    }
}

#[test]
fn a_difference_names_its_row_and_its_column() {
    let found = changed("0.442 %", "0.512 %");
    let row = "quick, 2 × 2 | 574487".to_owned();
    let [column, there, now] = ["error", "0.442 %", "0.512 %"].map(str::to_owned);
    assert_eq!(found, [Difference { row, column, there, now }]);
    let said = found[0].to_string();
    assert_eq!(said, "row 'quick, 2 × 2 | 574487', column 'error': '0.442 %' there, '0.512 %' now");
}

#[test]
fn words_columns_and_rows_that_are_others_are_found() {
    for (from, to) in [("| quick, 2 × 2 |", "| slow |"), ("| samples |", "| terms |"), ("links", "pairs")] {
        assert!(!changed(from, to).is_empty(), "{from}");
    }
    let without = TABLE.replace("| quick, 2 × 2 | 574487 | 0.442 % | 12 | 0.11 |\n", "");
    assert_eq!(differences(TABLE, &without, Extent::Whole).len(), 1);
    assert_eq!(differences(TABLE, &without, Extent::Part), []);
    assert_eq!(differences(&without, TABLE, Extent::Part).len(), 1);
}

/// The places of all documents whose tables are printed by commands, with their commands.
fn tables() -> Vec<Step> {
    let documents = TABLES.iter().chain(&WALKS);
    documents.flat_map(|document| steps(&text(document)).expect("marks are whole")).collect()
}

fn places(steps: &[Step]) -> impl Iterator<Item = (&str, &Place)> {
    steps.iter().filter_map(|step| match &step.kind {
        Kind::Output(place) => Some((step.command.as_str(), place)),
        _ => None,
    })
}

/// The digits of a document's own table, one by one.
#[test]
fn every_digit_of_the_cornell_table_is_compared() {
    let steps = tables();
    let (_, place) = places(&steps).find(|(command, _)| command.contains("read_off")).expect("it is there");
    let there = place.there.trim();
    let blocks = blocks(there);
    let [Block::Table(table)] = &blocks[..] else { panic!("one table") };
    let first = there.match_indices('\n').nth(1).expect("rows begin in the third line").0;
    let mut counts = [0; 2];
    for (at, digit) in there.char_indices().filter(|(at, c)| *at > first && c.is_ascii_digit()) {
        let line = there[..at].lines().last().unwrap_or_default();
        let column = &table.columns[line.matches('|').count() - 1];
        let other = char::from_digit((digit.to_digit(10).expect("a digit") + 5) % 10, 10).expect("a digit");
        let seeded = format!("{}{other}{}", &there[..at], &there[at + 1..]);
        let is_found = !differences(there, &seeded, Extent::Whole).is_empty();
        counts[usize::from(is_found)] += 1;
        assert_eq!(is_found, !column.of_machine, "{digit} behind '{line}'");
    }
    assert!(counts.iter().all(|count| *count > 50), "{counts:?}");
}

#[test]
fn places_agree_with_themselves() {
    let mut found = 0;
    for (command, place) in places(&tables()) {
        found += 1;
        assert_eq!(differences(&place.there, &place.there, Extent::Whole), [], "{command}");
    }
    assert!(found > 20, "{found} places");
}

#[test]
fn outputs_say_where_they_were_made() {
    for document in TABLES {
        let text = text(document);
        let outputs = text.split("<!-- output").skip(1).filter_map(|rest| rest.split("<!-- end -->").next());
        for output in outputs {
            assert!(output.lines().any(is_stamp), "{document}: no stamp in{output}");
        }
    }
    for document in WALKS {
        assert_eq!(text(document).lines().filter(|line| is_stamp(line)).count(), 1, "{document}");
    }
}

#[test]
fn numbers_are_repeated_as_they_stand_in_tables() {
    let cell = |line: &str| {
        let text = format!("`cargo run`\n<!-- output -->\n{TABLE}\n<!-- end -->\n{line}");
        let Renewed { text, faults } = renewed(&text, &steps(&text).expect("marks are whole"));
        if faults.is_empty() { Ok(text.lines().last().unwrap_or_default().to_owned()) } else { Err(faults) }
    };
    let mark = "<!-- cargo run → quick, 2 × 2 → error -->";
    for (written, right) in [("0.40", "0.44"), ("0.4", "0.4"), ("9e-1", "4e-1"), ("7.123", "0.4420")] {
        assert_eq!(cell(&format!("is {written}{mark} %")), Ok(format!("is {right}{mark} %")));
    }
    for wrong in ["<!-- cargo run → quick → error -->", "<!-- cargo test → quick, 2 × 2 → error -->"]
    {
        assert!(cell(&format!("0.40{wrong} %")).is_err(), "{wrong}");
    }
}

#[test]
fn documents_repeat_the_numbers_of_their_tables() {
    let (steps, mut found) = (tables(), 0);
    for document in TABLES.iter().chain(&WALKS).chain(&QUOTING) {
        let text = text(document);
        let Renewed { text: fresh, faults } = renewed(&text, &steps);
        assert!(faults.is_empty(), "{document}: {faults:?}");
        found += text.matches(" → ").count();
        for (own, fresh) in text.lines().zip(fresh.lines()) {
            assert_eq!(own, fresh, "{document}: `refresh` writes it");
        }
    }
    assert!(found > 20, "{found} numbers");
}

/// The bounds that a document names stand in the files of the tests.
#[test]
fn bounds_are_those_of_the_tests() {
    let text = text("docs/measured.md");
    let rows = text.lines().filter(|line| line.starts_with('|') && line.contains(".rs` |"));
    let mut found = 0;
    for row in rows {
        let cells: Vec<&str> = row.split('|').collect();
        let file = cells[4].split('`').rfind(|part| part.ends_with(".rs")).expect("it names a file");
        let source = self::text(file);
        let asserted: Vec<&str> = numbers(&source).collect();
        for number in cells[2..4].iter().flat_map(|cell| numbers(cell)) {
            found += 1;
            assert!(asserted.contains(&number), "{file} has no {number}");
        }
    }
    assert!(found > 8, "{found} bounds");
}

fn numbers(text: &str) -> impl Iterator<Item = &str> {
    parts(text).into_iter().filter_map(|part| match part {
        Part::Number(number) => Some(number.text),
        Part::Word(_) => None,
    })
}
