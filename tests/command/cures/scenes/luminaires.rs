//! Faults of luminaires in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
flux = 10
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
flux = 10
point = {}
"#,
        told: &["nothing says how the light is spread over directions", "help: add point = {}"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
flux = 10
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
flux = 10
spot = { angle = 40, edge = 5 }
"#,
        told: &["nothing says how the light is spread over directions", "spot = { angle = 40, edge = 5 }"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
flux = 10
"#,
        told: &[r#"the key "flux" is missing"#, "help: add `flux = …`"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
intensity = 1
"#,
        told: &[r#"the key "flux" is missing"#, "or its peak, `intensity = …`"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
aim = [0, 0, 0]
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
aim = [0, 0, -1]
"#,
        told: &["gives no direction", "help: give a direction, e.g. [0, 0, -1]"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
photometry = "lamp.ies"
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        told: &[
            r#""lamp.ies" cannot be read"#,
            "help: check the path, which starts from the folder of this file",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
flux = 10
extent = 0
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
flux = 10
extent = 0.2
"#,
        told: &[
            "the diameter of the extent is 0, outside diameter > 0",
            "help: choose a value with diameter > 0",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
extent = [0, 0]
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
extent = [0.2, 0.1]
"#,
        told: &["both sides are 0", "help: give two sides, e.g. extent = [1.2, 0.3]"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
along = [0, 0, 1]
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
along = [1, 0, 0]
"#,
        told: &["the vector `along` gives no direction", "help: give a direction across the aim"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 0.1 }
flux = 10
extent = [0.2, 0.1]
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 1 }
flux = 10
extent = [0.2, 0.1]
"#,
        told: &[
            "its intensity falls to nothing within half a degree",
            "help: give the spot an edge of 1 degree or more",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 0.1 }
flux = 10
extent = [0.2, 0.1]
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 0.1 }
flux = 10
"#,
        told: &["its intensity falls to nothing within half a degree", "or leave the extent out for a point"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
extent = "file"
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
spot = { angle = 40, edge = 5 }
flux = 10
extent = [1.2, 0.3]
"#,
        told: &["there is no photometric file", "help: give its sides, e.g. extent = [1.2, 0.3]"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
photometry = "room.toml"
flux = 10
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2]
point = {}
flux = 10
"#,
        told: &[
            "the ending tells no photometric format",
            "help: name it .ies (IES LM-63) or .ldt (EULUMDAT)",
        ],
    },
];
