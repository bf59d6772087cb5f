//! Faults of parts and instances in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: r#"[parts.p]
[[parts.p.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[instances]]
part = "q"
"#,
        cured: r#"[parts.p]
[[parts.p.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[instances]]
part = "p"
"#,
        told: &[r#"unknown part "q""#, r#"help: did you mean "p"?"#],
    },
    Row {
        part: MORE,
        bad: r#"[parts.p]
[[parts.p.instances]]
part = "p"
[[instances]]
part = "p"
"#,
        cured: r#"[parts.p]
[[parts.p.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[instances]]
part = "p"
"#,
        told: &["the part contains itself: p → p", "help: take one of these instances out"],
    },
    Row {
        part: MORE,
        bad: r#"[parts.p]
[[parts.p.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[instances]]
part = "p"
array = { count = 1000000, step = [0.01, 0, 0] }
"#,
        cured: r#"[parts.p]
[[parts.p.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[instances]]
part = "p"
array = { count = 2, step = [1, 0, 0] }
"#,
        told: &["the instances make more than", "help: make fewer copies"],
    },
];
