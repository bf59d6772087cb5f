//! Faults of scenes, with the cure that the message names.

use super::{MORE, Row};

/// Rooms that are refused, and rooms that are right.
pub(super) const ROWS: &[Row] = &[
    Row {
        part: r#"reflectance = 0.5
"#,
        bad: r#"reflectence = 0.5
"#,
        cured: r#"reflectance = 0.5
"#,
        told: &[r#"unknown key "reflectence""#, r#"help: did you mean "reflectance"?"#],
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
        part: r#"reflectance = 0.5
"#,
        bad: r#"reflectance = 0.5
reflectance = 0.6
"#,
        cured: r#"reflectance = 0.5
"#,
        told: &["duplicate key", "help: keep one of them"],
    },
    Row {
        part: r#"reflectance = 0.5
"#,
        bad: r#"reflectance = 1.5
"#,
        cured: r#"reflectance = 0.5
"#,
        told: &[
            "the reflectance is 1.5, outside 0 ≤ ρ < 1",
            "help: choose a value in that range; a surface that loses nothing (ρ = 1)",
        ],
    },
    Row {
        part: r#"emission = 100
"#,
        bad: r#"emission = -1
"#,
        cured: r#"emission = 1
"#,
        told: &["outside", "help: choose a value with"],
    },
    Row {
        part: r#"emission = 100
"#,
        bad: r#"emission = nan
"#,
        cured: r#"emission = 0.5
"#,
        told: &["NaN is not a finite number", "help: write a finite number, e.g. 0.5"],
    },
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
        bad: r#"title = room
"#,
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
        part: r#"disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
"#,
        bad: "",
        cured: r#"quad = { vertices = [[0,0,2],[0,1,2],[1,1,2],[1,0,2]] }
"#,
        told: &["no shape is given", "help: add one, e.g. quad = {"],
    },
    Row {
        part: r#"disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
"#,
        bad: r#"disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
sphere = { center = [0, 0, 2], radius = 0.1 }
"#,
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
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
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
        told: &[
            "the surface is no opening to a sky: there is no sky",
            r#"help: add [sky] with model = "overcast" and illuminance = 10000"#,
        ],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
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
        told: &[
            "no surface is an opening to the sky",
            "help: give a window opening = true, its front to the room",
        ],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
[sky]
model = "uniform"
illuminance = 100
"#,
        cured: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        told: &["no surface is an opening to the sky", "or leave the sky out"],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
[[surfaces]]
name = "window"
material = "white"
opening = true
two_sided = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
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
        told: &["it has two sides", "help: leave two_sided out: its front faces the room"],
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
        part: r#"[materials.white]
"#,
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
        part: "box = { origin",
        bad: "boxx = { origin",
        cured: "box = { origin",
        told: &[r#"unknown key "boxx""#, r#"did you mean "box"?"#],
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
        part: MORE,
        bad: r#"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 0
"#,
        cured: r#"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 0.5
"#,
        told: &["the spacing is 0", "help: choose a value with spacing > 0"],
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
        part: r#"reflectance = 0.5
"#,
        bad: r#"reflectance = 1
"#,
        cured: r#"reflectance = 0.9
"#,
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
        part: "reflectance = 0.5",
        bad: r#"reflectance = "0.5""#,
        cured: "reflectance = 0.5",
        told: &["expected a number, found a text", "help: write it without quotes, e.g. 0.5"],
    },
    Row {
        part: "eye = [2, -2.6, 1.4]",
        bad: "eye = 2",
        cured: "eye = [2, -2.6, 1.4]",
        told: &["expected a list, found a number", "help: write it in brackets, e.g. [0, 0, 1]"],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[sky]
model = "clear"
illuminance = 100
"#,
        cured: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[sky]
model = "clear"
illuminance = 100
sun = { elevation = 40, azimuth = 180 }
"#,
        told: &[
            r#"the key "sun" is missing"#,
            "help: add `sun = …`, where the sun is: { elevation = 40, azimuth = 180 }",
        ],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[sky]
model = "uniform"
illuminance = 100
sun = { elevation = -4, azimuth = 180 }
"#,
        cured: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[sky]
model = "uniform"
illuminance = 100
sun = { elevation = 4, azimuth = 180 }
"#,
        told: &[
            "the elevation of the sun is -4, outside 0 < elevation ≤ 90 degrees",
            "help: choose a value in that range",
        ],
    },
    Row {
        part: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
"#,
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
flux = 3
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[sky]
model = "uniform"
illuminance = 100
"#,
        cured: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
[sky]
model = "uniform"
illuminance = 100
"#,
        told: &["it has a flux", "help: leave the flux out"],
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
];
