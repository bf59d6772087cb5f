//! Faults of materials in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: "reflectance = 0.5\n",
        bad: "reflectence = 0.5\n",
        cured: "reflectance = 0.5\n",
        told: &[r#"unknown key "reflectence""#, r#"help: did you mean "reflectance"?"#],
    },
    Row {
        part: "reflectance = 0.5\n",
        bad: r"reflectance = 0.5
reflectance = 0.6
",
        cured: "reflectance = 0.5\n",
        told: &["duplicate key", "help: keep one of them"],
    },
    Row {
        part: "reflectance = 0.5\n",
        bad: "reflectance = 1.5\n",
        cured: "reflectance = 0.5\n",
        told: &[
            "the reflectance is 1.5, outside 0 ≤ ρ < 1",
            "help: choose a value in that range; a surface that loses nothing (ρ = 1)",
        ],
    },
    Row {
        part: "emission = 100\n",
        bad: "emission = -1\n",
        cured: "emission = 1\n",
        told: &["outside", "help: choose a value with"],
    },
    Row {
        part: "emission = 100\n",
        bad: "emission = nan\n",
        cured: "emission = 0.5\n",
        told: &["NaN is not a finite number", "help: write a finite number, e.g. 0.5"],
    },
    Row {
        part: MORE,
        bad: r#"[materials.glow]
reflectance = 0.5
transmittance = 0.2
[[surfaces]]
name = "sheet"
material = "glow"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.glow]
reflectance = 0.5
transmittance = 0.2
[[surfaces]]
name = "sheet"
material = "glow"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["a transmittance needs a surface of two sides", "help: add two_sided = true to the surface"],
    },
    Row {
        part: "reflectance = 0.5\n",
        bad: "reflectance = 1\n",
        cured: "reflectance = 0.9\n",
        told: &["outside 0 ≤ ρ < 1", "help: choose a value in that range"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
back_material = "lamp"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
two_sided = true
back_material = "lamp"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["a back material needs a surface of two sides", "help: add two_sided = true"],
    },
    Row {
        part: "reflectance = 0.5",
        bad: r#"reflectance = "0.5""#,
        cured: "reflectance = 0.5",
        told: &["expected a number, found a text", "help: write it without quotes, e.g. 0.5"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
back_material = "lump"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
back_material = "lamp"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[r#"unknown material "lump""#, r#"help: did you mean "lamp"?"#],
    },
    Row {
        part: MORE,
        bad: r#"[materials.glow]
reflectance = 0.5
emission = 5
[[surfaces]]
name = "sheet"
material = "glow"
flux = 3
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.glow]
reflectance = 0.5
[[surfaces]]
name = "sheet"
material = "glow"
flux = 3
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[
            "help: leave the flux out, or give the surface a material of the same reflectance without emission",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[materials.glow]
reflectance = 0.5
[materials.glow.emission]
cells = [[1, 2]]
[[surfaces]]
name = "sheet"
material = "glow"
flux = 3
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.glow]
reflectance = 0.5
[materials.glow.emission]
cells = [[1, 2]]
[[surfaces]]
name = "sheet"
material = "glow"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[
            "help: leave the flux out, and scale the pattern by its `factor`: the mean exitance is the flux over the area",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[materials.pale.reflectance]
cells = [[0.5, -0.2]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.pale.reflectance]
cells = [[0.5, 0.2]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["help: add a constant to the pattern, or choose another one, so that it is nowhere below 0"],
    },
    Row {
        part: MORE,
        bad: r#"[materials.pale.reflectance]
cells = [[0.5, 1.2]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.pale.reflectance]
cells = [[0.5, 1.2]]
factor = 0.75
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["help: scale the pattern down: factor = 0.75"],
    },
    Row {
        part: MORE,
        bad: r#"[materials.pale.reflectance]
cells = []
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.pale.reflectance]
cells = [[0.2, 0.8], [0.8, 0.2]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["the list of cells takes rows of numbers", "such as [[0.2, 0.8], [0.8, 0.2]]"],
    },
    Row {
        part: MORE,
        bad: r#"[materials.pale.reflectance]
cells = [[0.5, 0.2], [0.1]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.pale.reflectance]
cells = [[0.5, 0.2], [0.1, 0.1]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["a row of cells takes 2 numbers, as the first row has", "help: give 2 numbers"],
    },
    Row {
        part: MORE,
        bad: r#"[materials.pale.reflectance]
factor = 0.5
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.pale.reflectance]
factor = 0.5
cells = [[0.5]]
[[surfaces]]
name = "sheet"
material = "pale"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[r#"the key "image" is missing"#, "`cells = …` for rows of numbers"],
    },
    Row {
        part: MORE,
        bad: r#"[materials.thin]
reflectance = 0.5
transmittance = 0.2
[materials.thick]
reflectance = 0.5
transmittance = 0.1
[[surfaces]]
name = "sheet"
material = "thin"
back_material = "thick"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[materials.thin]
reflectance = 0.5
transmittance = 0.2
[materials.thick]
reflectance = 0.5
transmittance = 0.2
[[surfaces]]
name = "sheet"
material = "thin"
back_material = "thick"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[
            "the transmittances of its two sides differ",
            "help: give both materials the same transmittance",
        ],
    },
];
