//! Faults of heat in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
two_sided = true
temperature = 300
back = "front"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
two_sided = true
temperature = 300
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["the heat of the back is given, yet the surface has two sides", "help: leave back out"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
two_sided = true
temperature = 300
back = "front"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
back = "front"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["the heat of the back is given", "or leave two_sided out"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
heat_flux = 3
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[r#""temperature" and "heat_flux" are both given"#, "help: leave one of them out"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
adiabatic = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["both given", "help: leave one of them out"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = -3
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 293.15
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[
            "the temperature is -3, outside 0 ≤ T",
            "help: write it in kelvin, which are degrees Celsius + 273.15: 20 °C is temperature = 293.15",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
back = "warm"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
back = "front"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[r#"a back is "adiabatic", as the "front", or has a temperature"#, "help: write one of both"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
back = "warm"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
temperature = 300
back = 290
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[r#"a back is "adiabatic", as the "front", or has a temperature"#, "or kelvin"],
    },
    Row {
        part: "reflectance = 0.5\n",
        bad: r"reflectance = 0.5
emissivity = 0
",
        cured: r"reflectance = 0.5
emissivity = 0.5
",
        told: &[
            "help: choose a value in that range; a surface that neither absorbs nor emits has adiabatic = true",
        ],
    },
];
