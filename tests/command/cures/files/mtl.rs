//! Faults of material files of OBJ.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.obj",
    changed: "scene.mtl",
    arguments: &[],
    files: &[
        (
            "scene.obj",
            r"mtllib scene.mtl
usemtl white
o square
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
f 1 2 3 4
",
        ),
        (
            "scene.mtl",
            r"newmtl white
Kd 0.5 0.5 0.5
Ke 1 1 1
",
        ),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: r"newmtl white
Kd 0.5 0.5 0.5
",
        bad: r"Kd 0.5 0.5 0.5
newmtl white
",
        cured: r"newmtl white
Kd 0.5 0.5 0.5
",
        told: &["'Kd' stands before the first material", "help: begin each material with 'newmtl NAME'"],
    },
    Row {
        part: "Kd 0.5 0.5 0.5",
        bad: "Kd 0.5 0.5",
        cured: "Kd 0.5 0.5 0.5",
        told: &["Kd has 2 numbers", "help: give it red, green and blue"],
    },
    Row {
        part: "Kd 0.5 0.5 0.5",
        bad: "Kd 0.5 0.5",
        cured: "Kd 0.5",
        told: &["Kd has 2 numbers", "or one number"],
    },
    Row {
        part: "Kd 0.5 0.5 0.5",
        bad: "Kd 0.5 0.5 -0.5",
        cured: "Kd 0.5 0.5 0.5",
        told: &["Kd is -0.5, below 0", "help: correct it"],
    },
    Row {
        part: "Ke 1 1 1",
        bad: "Ke inf",
        cured: "Ke 1",
        told: &["Ke is inf", "help: write a finite number"],
    },
    Row {
        part: "Ke 1 1 1",
        bad: "Ke 1e308",
        cured: "Ke 1",
        told: &["Ke is beyond 1e50", "help: correct it"],
    },
    Row {
        part: "Kd 0.5 0.5 0.5",
        bad: "Kd spectral a.rfl",
        cured: "Kd 0.5 0.5 0.5",
        told: &["Kd is given as 'spectral'", "help: give it as red, green and blue"],
    },
];
