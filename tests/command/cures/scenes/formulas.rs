//! Faults of formulas and variables in scene files.

use super::super::Row;

pub(super) const ROWS: &[Row] = &[
    Row {
        part: "[materials.white]\n",
        bad: r#"[materials.white]
reflectance = "=width"
#"#,
        cured: r#"[variables]
width = 0.5
[materials.white]
reflectance = "=width"
#"#,
        told: &[r#"there is no variable "width""#, "help: define it: [variables] with width = 2.5"],
    },
    Row {
        part: "reflectance = 0.5",
        bad: r#"reflectance = "=0.5 *""#,
        cured: r#"reflectance = "=0.5 * 1""#,
        told: &["the formula cannot be read", r#"help: write it such as "=2 * (width - 0.1)""#],
    },
    Row {
        part: "[materials.white]",
        bad: r#"[variables]
a = "=b"
b = "=a"
[materials.white]"#,
        cured: r#"[variables]
a = "=b"
b = 2
[materials.white]"#,
        told: &["it needs its own value: a → b → a", "help: give one of them a number"],
    },
    Row {
        part: "reflectance = 0.5\n",
        bad: r#"reflectance = "=sine(30)"
"#,
        cured: r#"reflectance = "=sin(30)"
"#,
        told: &[r#"there is no function "sine""#, r#"help: did you mean "sin"?"#],
    },
    Row {
        part: "reflectance = 0.5\n",
        bad: r#"reflectance = "=1/0"
"#,
        cured: r#"reflectance = "=1/2"
"#,
        told: &["help: change the formula, or the variables in it"],
    },
    Row {
        part: "[materials.white]\n",
        bad: r#"[variables]
"a b" = 1
[materials.white]
"#,
        cured: r"[variables]
lamp_2 = 1
[materials.white]
",
        told: &["help: choose another name, such as width or lamp_2"],
    },
    Row {
        part: r"[materials.white]
reflectance = 0.5
",
        bad: r#"[variables]
width = 0.5
[materials.white]
reflectance = "=widht"
"#,
        cured: r#"[variables]
width = 0.5
[materials.white]
reflectance = "=width"
"#,
        told: &[
            r#"there is no variable "widht""#,
            r#"help: did you mean "width"? variables of this scene: width"#,
        ],
    },
];
