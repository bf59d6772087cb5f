//! Faults of skies and openings in scene files.

use super::super::Row;

pub(super) const ROWS: &[Row] = &[
    Row {
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
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
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
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
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
[sky]
model = "uniform"
illuminance = 100
"#,
        cured: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        told: &["no surface is an opening to the sky", "or leave the sky out"],
    },
    Row {
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
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
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
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
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
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
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
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
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
[[surfaces]]
name = "window"
material = "white"
opening = true
sphere = { center = [0, -8, 1], radius = 1 }
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
        told: &["the surface is no opening to a sky: it is curved", "help: make it of flat surfaces"],
    },
    Row {
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
[[surfaces]]
name = "window"
material = "lamp"
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
        told: &["its material emits", "help: leave the flux out"],
    },
    Row {
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 0
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
            "the illuminance of the sky is 0",
            "help: give what level ground gets from the sky without the sun",
        ],
    },
    Row {
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
up = [0, 0, 0]
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
up = [0, 0, 1]
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
"#,
        told: &["the vector `up` gives no direction", "help: give the direction to the zenith"],
    },
    Row {
        part: "box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }\n",
        bad: r#"box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true, open = ["front"] }
[sky]
model = "uniform"
illuminance = 100
north = [0, 0, 1]
sun = { elevation = 40, azimuth = 180 }
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
north = [0, 1, 0]
sun = { elevation = 40, azimuth = 180 }
[[surfaces]]
name = "window"
material = "white"
opening = true
quad = { vertices = [[-3, -3, 0], [-3, -3, 3], [3, -3, 3], [3, -3, 0]] }
"#,
        told: &["the vector `north` gives no direction", "help: give a direction that is not along `up`"],
    },
];
