//! Faults of chosen shadow masks in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: r#"[[masks]]
emitter = "lamp"
receiver = "lamp"
"#,
        cured: r#"[[masks]]
emitter = "lamp"
receiver = "room*"
"#,
        told: &[r#""lamp" is the emitter and the receiver of a mask"#, "help: name two surfaces"],
    },
    Row {
        part: MORE,
        bad: r#"[[masks]]
emitter = "lump"
receiver = "room*"
"#,
        cured: r#"[[masks]]
emitter = "lamp"
receiver = "room*"
"#,
        told: &[r#"unknown surface "lump""#, r#"help: did you mean "lamp"?"#],
    },
];
