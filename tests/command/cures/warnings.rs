//! Warnings of `check`, with the cures that they name.

use super::{MORE, Row};

/// Rooms in which `check` finds something, and rooms in which it does not.
pub(super) const ROWS: &[Row] = &[
    Row {
        part: r#"emission = 100
"#,
        bad: r#"emission = 0
"#,
        cured: r#"emission = 100
"#,
        told: &["nothing emits light: give a material an emission above 0"],
    },
    Row {
        part: r#"[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
"#,
        bad: "",
        cured: r#"[[luminaires]]
name = "point"
position = [0, 0, 2.4]
point = {}
flux = 10
"#,
        told: &["nothing emits light", "add luminaires"],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        cured: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
"#,
        told: &["nothing emits light", "a sky and an opening to it"],
    },
    Row {
        part: r#"[camera]
eye = [2, -2.6, 1.4]
target = [0, 0, 0.3]
"#,
        bad: "",
        cured: r#"[camera]
eye = [2, -2.6, 1.4]
target = [0, 0, 0.3]
"#,
        told: &["there is no camera", "add a [camera] with eye and target"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "post"
material = "white"
box = { origin = [0, 0, -0.5], size = [0.3, 0.3, 1] }
"#,
        cured: r#"[[surfaces]]
name = "post"
material = "white"
box = { origin = [0, 0, 0], size = [0.3, 0.3, 0.5], open = ["bottom"] }
"#,
        told: &["passes through", "end one where it meets the other"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "curtain"
material = "white"
two_sided = true
quad = { vertices = [[0, 0, 0.005], [1, 0, 0.005], [1, 0, 2], [0, 0, 2]] }
"#,
        cured: r#"[[surfaces]]
name = "curtain"
material = "white"
two_sided = true
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 0, 2], [0, 0, 2]] }
"#,
        told: &["leaves a gap of", "move their borders together"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "top"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
[[surfaces]]
name = "side"
material = "white"
flip = true
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]] }
"#,
        cured: r#"[[surfaces]]
name = "top"
material = "white"
quad = { vertices = [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]] }
[[surfaces]]
name = "side"
material = "white"
flip = false
quad = { vertices = [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]] }
"#,
        told: &["turns its front to the other side than", "flip = true turns it over"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "ball"
material = "white"
flip = true
sphere = { center = [0, 0, 0.6], radius = 0.4 }
"#,
        cured: r#"[[surfaces]]
name = "ball"
material = "white"
sphere = { center = [0, 0, 0.6], radius = 0.4 }
"#,
        told: &["faces into a closed space with no light in it: flip = true turns a surface over"],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3] }
"#,
        cured: r#"flip = true
box = { origin = [-3, -3, 0], size = [6, 6, 3] }
"#,
        told: &["faces away from what is in it: flip = true turns a surface over"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "sheet"
material = "white"
quad = { vertices = [[0, 0, 3.5], [1, 0, 3.5], [1, 1, 3.5], [0, 1, 3.5]] }
"#,
        cured: r#"[[surfaces]]
name = "sheet"
material = "white"
flip = true
quad = { vertices = [[0, 0, 3.5], [1, 0, 3.5], [1, 1, 3.5], [0, 1, 3.5]] }
"#,
        told: &["faces no other front, it neither lights nor is lit: flip = true turns it over"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "south"
material = "white"
quad = { vertices = [[0, 0, 3.5], [1, 0, 3.5], [1, 0.5, 3.5], [0, 0.5, 3.5]] }
[[surfaces]]
name = "north"
material = "white"
quad = { vertices = [[0, 0.5, 3.5], [1, 0.5, 3.5], [1, 1, 3.5], [0, 1, 3.5]] }
"#,
        cured: r#"[[surfaces]]
name = "south"
material = "white"
flip = true
quad = { vertices = [[0, 0, 3.5], [1, 0, 3.5], [1, 0.5, 3.5], [0, 0.5, 3.5]] }
[[surfaces]]
name = "north"
material = "white"
flip = true
quad = { vertices = [[0, 0.5, 3.5], [1, 0.5, 3.5], [1, 1, 3.5], [0, 1, 3.5]] }
"#,
        told: &[
            "faces no other front, it neither lights nor is lit: if it is a wall of a room, flip = true turns it and those that it meets over",
        ],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 3.2]
aim = [0, 0, 1]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 2.2]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        told: &["lights no front of a surface", "move it"],
    },
    Row {
        part: MORE,
        bad: r#"[[surfaces]]
name = "solid"
material = "white"
box = { origin = [0, 0, 0.5], size = [1, 1, 1] }
[[luminaires]]
name = "spot"
position = [0.5, 0.5, 1]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        cured: r#"[[surfaces]]
name = "solid"
material = "white"
box = { origin = [0, 0, 0.5], size = [1, 1, 1] }
[[luminaires]]
name = "spot"
position = [0, 0, 2.2]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        told: &["lights no front of a surface: it is within a body", "move it"],
    },
    Row {
        part: MORE,
        bad: r#"[[luminaires]]
name = "spot"
position = [0, 0, 3]
aim = [0, 0, 1]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        cured: r#"[[luminaires]]
name = "spot"
position = [0, 0, 3]
spot = { angle = 40, edge = 5 }
flux = 10
"#,
        told: &["lights no front of a surface", "or turn it"],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
[sky]
model = "uniform"
illuminance = 100
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[[surfaces]]
name = "eave"
material = "white"
two_sided = true
quad = { vertices = [[-3, -4, 3], [3, -4, 3], [3, -3, 3], [-3, -3, 3]] }
"#,
        cured: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
[sky]
model = "uniform"
illuminance = 100
[[surfaces]]
name = "sky-front"
material = "white"
opening = true
quad = { vertices = [[-3, -4, 0], [-3, -4, 3], [3, -4, 3], [3, -4, 0]] }
[[surfaces]]
name = "sky-left"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [-3, -4, 3], [-3, -4, 0]] }
[[surfaces]]
name = "sky-right"
material = "white"
opening = true
quad = { vertices = [[3, -4, 0], [3, -4, 3], [3, -3, 3], [3, -3, 0]] }
[[surfaces]]
name = "ground"
material = "white"
quad = { vertices = [[-3, -4, 0], [3, -4, 0], [3, -3, 0], [-3, -3, 0]] }
[[surfaces]]
name = "eave"
material = "white"
two_sided = true
quad = { vertices = [[-3, -4, 3], [3, -4, 3], [3, -3, 3], [-3, -3, 3]] }
"#,
        told: &[
            r#"is an opening to the sky, and "eave", outside before it"#,
            "close the space outside, beyond what stands there, with openings",
        ],
    },
];
