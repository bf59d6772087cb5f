//! Faults of texts in scene files.

use super::super::Row;

pub(super) const ROWS: &[Row] = &[
    Row {
        part: r#"title = "room"
"#,
        bad: r#"title = ""
"#,
        cured: r#"title = "a"
"#,
        told: &["this text is empty", "help: write at least one letter"],
    },
    Row {
        part: r#"title = "room"
"#,
        bad: "title = room\n",
        cured: r#"title = "room"
"#,
        told: &["syntax error", "help: TOML wants `key = value`, texts in quotes"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = [["grey"]]
"#,
        cured: r#"bands = ["grey"]
"#,
        told: &["expected a text in quotes, found a list", r#"help: write it in quotes, e.g. "white""#],
    },
    Row {
        part: r#"title = "room"
"#,
        bad: r#"title = "room"
include = ["none.toml"]
"#,
        cured: r#"title = "room"
"#,
        told: &["cannot be read", "help: check the path, which starts from the folder of this file"],
    },
    Row {
        part: r#"title = "room"
"#,
        bad: r#"title = "room"
unit = "this is a very long text of a unit"
"#,
        cured: r#"title = "room"
unit = "lx"
"#,
        told: &["the unit is longer than 16 characters", r#"help: write a short text, e.g. "lx""#],
    },
];
