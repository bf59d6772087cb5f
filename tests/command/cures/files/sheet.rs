//! Faults of files of materials.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.ply",
    changed: "m.toml",
    arguments: &["--materials", "m.toml"],
    files: &[
        (
            "scene.ply",
            r"ply
format ascii 1.0
comment a square
element vertex 4
property float x
property float y
property float z
element face 1
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
",
        ),
        (
            "m.toml",
            r#"[materials.white]
reflectance = 0.5
[surfaces]
"polygon-1" = "white"
"#,
        ),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: "reflectance = 0.5",
        bad: "reflectance = nan",
        cured: "reflectance = 0.5",
        told: &["NaN is no reflectance or exitance", "help: give a finite number, 0 or above"],
    },
    Row {
        part: "reflectance = 0.5",
        bad: "reflectance = [0.1, 0.2]",
        cured: "reflectance = 0.5",
        told: &["there are 2 numbers, the bands are grey", "help: give one number, or one per band"],
    },
    Row {
        part: "reflectance = 0.5",
        bad: "colour = 0.5",
        cured: "reflectance = 0.5",
        told: &["unknown field", "help: write such as [materials.white] with reflectance = 0.8"],
    },
    Row {
        part: r#""polygon-1" = "white""#,
        bad: r#""polygone-1" = "white""#,
        cured: r#""polygon-1" = "white""#,
        told: &[r#"no surface is called "polygone-1""#, r#"help: did you mean "polygon-1"?"#],
    },
    Row {
        part: r#""polygon-1" = "white""#,
        bad: r#""floor" = "white""#,
        cured: r#""polygon-1" = "white""#,
        told: &[r#"no surface is called "floor""#, r#"help: surfaces of the scene: "polygon-1""#],
    },
    Row {
        part: r#""polygon-1" = "white""#,
        bad: r#""polygon-1" = "white"
"polygon*" = "whte""#,
        cured: r#""polygon-1" = "white""#,
        told: &[r#"the scene has no material "whte""#, r#"help: did you mean "white"?"#],
    },
    Row {
        part: r#"[surfaces]
"polygon-1" = "white"
"#,
        bad: "",
        cured: r#"[surfaces]
"polygon-1" = "white"
"#,
        told: &[
            r#"the scene has no material "white""#,
            r#"help: the file has no materials: give surfaces one below [surfaces], such as "*" = "white""#,
        ],
    },
    Row {
        part: "[materials.white]",
        bad: "[materials.grey]",
        cured: "[materials.white]",
        told: &[r#"the scene has no material "grey""#, "below [surfaces]"],
    },
];
