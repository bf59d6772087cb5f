//! Faults of motions in scene files.

use super::super::Row;

pub(super) const ROWS: &[Row] = &[
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
"#,
        told: &["nothing moves", r#"help: say what moves: [[motion]] with surfaces = ["lamp"]"#],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
"#,
        cured: r#"bands = ["grey"]
"#,
        told: &["nothing moves", "or leave frames and motions out"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
"#,
        told: &["nothing says how it moves", "help: add translate = { points = [[0, 0, 0], [1, 0, 0]] }"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
emission = { factors = [1, 0] }
"#,
        told: &["nothing says how it moves", "emission = { factors = [1, 0] }"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
"#,
        cured: r#"bands = ["grey"]
frames = 50
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
"#,
        told: &[
            r#"the key "frames" is missing"#,
            "help: add `frames = …`, how many frames there are, e.g. 50",
        ],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]], times = [1, 1] }
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]], times = [0, 1] }
"#,
        told: &["the times do not ascend", "help: give times of which each is larger than the one before"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
luminaires = ["spot"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
[[luminaires]]
name = "spat"
position = [0, 0, 2]
point = {}
flux = 1
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
luminaires = ["spat"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
[[luminaires]]
name = "spat"
position = [0, 0, 2]
point = {}
flux = 1
"#,
        told: &[r#"unknown luminaire "spot""#, r#"help: did you mean "spat"?"#],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
instances = ["p"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
[parts.ball]
[[parts.ball.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.2 }
[[instances]]
name = "q"
part = "ball"
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
instances = ["q"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
[parts.ball]
[[parts.ball.surfaces]]
name = "a"
material = "white"
sphere = { center = [0, 0, 1], radius = 0.2 }
[[instances]]
name = "q"
part = "ball"
"#,
        told: &[r#"unknown instance "p""#, r#"help: did you mean "q"?"#],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
groups = ["p"]
emission = { factors = [1, 0] }
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
emission = { factors = [1, 0] }
"#,
        told: &[r#"unknown light group "p""#, "help: this scene has no light groups"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["room*"]
emission = { factors = [1, 0] }
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
emission = { factors = [1, 0] }
"#,
        told: &["nothing that the motion names emits light", "help: name surfaces or luminaires that emit"],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp", "room-left"]
emission = { factors = [1, 0] }
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
emission = { factors = [1, 0] }
"#,
        told: &[
            "emits nothing that could change, and the motion has no path",
            "help: take it out of the motion",
        ],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
[[motion]]
surfaces = ["lamp"]
emission = { factors = [1, 0] }
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
translate = { points = [[0, 0, 0], [1, 0, 0]] }
emission = { factors = [1, 0] }
"#,
        told: &[
            "belongs to the motion",
            "help: take it out of one of the two; a motion may turn, translate and dim at once",
        ],
    },
    Row {
        part: r#"bands = ["grey"]
"#,
        bad: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
rotate = { center = [0, 0, 2], axis = [0, 0, 0], angles = [0, 90] }
"#,
        cured: r#"bands = ["grey"]
frames = 3
[[motion]]
surfaces = ["lamp"]
rotate = { center = [-1, -1, 2.4], axis = [0, 0, 1], angles = [0, 90] }
"#,
        told: &[
            "the vector `axis` gives no direction",
            "help: give the direction of the axis, e.g. [0, 0, 1]",
        ],
    },
    Row {
        part: r"[camera]
eye = [2, -2.6, 1.4]
target = [0, 0, 0.3]
",
        bad: r"frames = 3
[[motion]]
camera = true
translate = { points = [[0, 0, 0], [0.1, 0, 0]] }
",
        cured: r"frames = 3
[camera]
eye = [2, -2.6, 1.4]
target = [0, 0, 0.3]
[[motion]]
camera = true
translate = { points = [[0, 0, 0], [0.1, 0, 0]] }
",
        told: &["the scene has no camera to move", "help: add [camera] with eye and target"],
    },
];
