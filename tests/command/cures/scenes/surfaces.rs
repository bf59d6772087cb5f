//! Faults of surfaces and cameras in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "red\u001b[31m\nwarning: all is well"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "red"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[
            r#"the name "red\u{1b}[31m\nwarning: all is well" holds a character that cannot be printed"#,
            "help: write it in letters, digits and signs, on one line",
        ],
    },
    Row {
        part: r#"material = "lamp"
"#,
        bad: r#"material = "lump"
"#,
        cured: r#"material = "lamp"
"#,
        told: &[r#"unknown material "lump""#, r#"help: did you mean "lamp"?"#],
    },
    Row {
        part: "disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }\n",
        bad: "",
        cured: "quad = { vertices = [[0,0,2],[0,1,2],[1,1,2],[1,0,2]] }\n",
        told: &["no shape is given", "help: add one, e.g. quad = {"],
    },
    Row {
        part: "disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }\n",
        bad: r"disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
sphere = { center = [0, 0, 2], radius = 0.1 }
",
        cured: r#"disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
[[surfaces]]
name = "second"
material = "white"
sphere = { center = [0, 0, 2], radius = 0.1 }
"#,
        told: &["two shapes are given", "help: make two surfaces, one for each shape"],
    },
    Row {
        part: "radius = 0.2 }",
        bad: "radius = 0 }",
        cured: "radius = 0.1 }",
        told: &["`radius` is 0; it must be greater than zero"],
    },
    Row {
        part: "center = [-1, -1, 2.4]",
        bad: "center = [-1, -1]",
        cured: "center = [-1, -1, 2.4]",
        told: &["takes 3 numbers", "help: give 3 numbers"],
    },
    Row {
        part: "normal = [0, 0, -1]",
        bad: "normal = [0, 0, 0]",
        cured: "normal = [0, 0, -1]",
        told: &["`normal` has no length; give a vector that does not vanish"],
    },
    Row {
        part: "target = [0, 0, 0.3]",
        bad: "target = [2, -2.6, 1.4]",
        cured: "target = [0, 0, 0.3]",
        told: &["eye and target are the same point", "help: move the eye, the target or the up vector"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "one"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[surfaces]]
name = "two"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
"#,
        cured: r#"[[surfaces]]
name = "one"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
"#,
        told: &[r#"coincides with surface "one""#, "help: remove one of the two"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "one"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[surfaces]]
name = "two"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
"#,
        cured: r#"[[surfaces]]
name = "one"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.4 }
[[surfaces]]
name = "two"
material = "white"
sphere = { center = [0, 0, 2], radius = 0.4 }
"#,
        told: &[r#"coincides with surface "one""#, "move them apart by a millionth of their size or more"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "one"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
[[surfaces]]
name = "two"
material = "white"
quad = { vertices = [[0, 0, 1], [0, 1, 1], [1, 1, 1], [1, 0, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "one"
material = "white"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &[r#"coincides with surface "one""#, "for both sides of one surface use two_sided = true"],
    },
    Row {
        part: "box = { origin",
        bad: "boxx = { origin",
        cured: "box = { origin",
        told: &[r#"unknown key "boxx""#, r#"did you mean "box"?"#],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "one"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
[[surfaces]]
name = "one"
material = "white"
quad = { vertices = [[0, 0, 2], [1, 0, 2], [1, 1, 2], [0, 1, 2]] }
"#,
        cured: r#"[[surfaces]]
name = "one"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
[[surfaces]]
name = "two"
material = "white"
quad = { vertices = [[0, 0, 2], [1, 0, 2], [1, 1, 2], [0, 1, 2]] }
"#,
        told: &[r#"the name "one" is given twice"#, "help: rename this one"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "ball"
material = "white"
transform = { scale = 0 }
sphere = { center = [0, 0, 1], radius = 0.4 }
"#,
        cured: r#"[[surfaces]]
name = "ball"
material = "white"
transform = { scale = 0.5 }
sphere = { center = [0, 0, 1], radius = 0.4 }
"#,
        told: &["`scale` is 0; it must be greater than zero"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
subdivide = [0, 1]
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
subdivide = [1, 1]
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["outside", "help: choose a value with"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
order = 99
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
order = 2
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["the order is 99, outside 0 ≤ order ≤ 20", "help: choose a value with 0 ≤ order ≤ 20"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
order = 1.5
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
order = 2
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["1.5 is not a whole number", "help: give 0, 1, 2, …"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
two_sided = "yes"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
two_sided = true
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
"#,
        told: &["expected true or false, found a text", "help: write a value of that kind"],
    },
    Row {
        part: "eye = [2, -2.6, 1.4]",
        bad: "eye = 2",
        cured: "eye = [2, -2.6, 1.4]",
        told: &["expected a list, found a number", "help: write it in brackets, e.g. [0, 0, 1]"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "wall"
material = "white"
box = { origin = [0, 0, 1], size = [1, 1, 1], open = ["fornt"] }
"#,
        cured: r#"[[surfaces]]
name = "wall"
material = "white"
box = { origin = [0, 0, 1], size = [1, 1, 1], open = ["front"] }
"#,
        told: &[r#"a box has no face "fornt""#, r#"help: did you mean "front"? faces of a box"#],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "pot"
material = "white"
patches = { points = [[0, 0, 1], [1, 0, 1]], patches = [[0, 1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]] }
"#,
        cured: "",
        told: &[
            "there is no point 2: the list has 2",
            "help: count the points from 0, the last index is one less than their number",
        ],
    },
];
