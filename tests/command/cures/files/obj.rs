//! Faults of OBJ files.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.obj",
    changed: "scene.obj",
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
        part: "f 1 2 3 4\n",
        bad: "",
        cured: "f 1 2 3 4\n",
        told: &["the file holds no faces (f)", "help: save the model with polygons"],
    },
    Row {
        part: "o square\n",
        bad: "hello world\n",
        cured: "",
        told: &["'hello' is no statement of OBJ", "help: take the line out"],
    },
    Row {
        part: "o square\n",
        bad: "hello world\n",
        cured: "# hello world\n",
        told: &["'hello' is no statement of OBJ", "put '#' before it"],
    },
    Row {
        part: "v 1 0 0",
        bad: "v 1 0",
        cured: "v 1 0 0",
        told: &["the vertex has 2 coordinates, it takes 3", "help: give it x, y and z"],
    },
    Row {
        part: "v 1 0 0",
        bad: "v 1 NaN 0",
        cured: "v 1 0 0",
        told: &["y is NaN", "help: write a finite number"],
    },
    Row {
        part: "v 1 0 0",
        bad: "v 1 x 0",
        cured: "v 1 0 0",
        told: &["y is 'x', which is no number", "help: write a number"],
    },
    Row {
        part: "f 1 2 3 4",
        bad: "f 1 2",
        cured: "f 1 2 3",
        told: &["a face has 2 corners, 3 are the least", "or give it three corners"],
    },
    Row {
        part: "f 1 2 3 4\n",
        bad: r"f 1 2 3 4
f 1 2
",
        cured: "f 1 2 3 4\n",
        told: &["a face has 2 corners, 3 are the least", "help: take the face out"],
    },
    Row {
        part: "f 1 2 3 4",
        bad: "f 1 2 3 5",
        cured: "f 1 2 3 4",
        told: &["the face has the vertex 5; 4 are listed", "help: correct the number"],
    },
    Row {
        part: "f 1 2 3 4",
        bad: "f 1 2 3 4 5",
        cured: r"v 0 0.5 0
f 1 2 3 4 5",
        told: &["the face has the vertex 5; 4 are listed", "or list the vertex"],
    },
    Row {
        part: "f 1 2 3 4",
        bad: "f -5 -3 -2 -1",
        cured: "f -4 -3 -2 -1",
        told: &["the face has the vertex -5; 4 are listed above it", "help: correct the number"],
    },
    Row {
        part: "f 1 2 3 4",
        bad: "f 0 1 2 3",
        cured: "f 1 2 3 4",
        told: &["the face has the vertex 0", "help: count vertices from 1 on"],
    },
    Row {
        part: "f 1 2 3 4",
        bad: "f /1 2 3 4",
        cured: "f 1//1 2//1 3//1 4//1",
        told: &["the corner '/1' has no number of a vertex", "help: write it as v, v/vt, v//vn or v/vt/vn"],
    },
    Row {
        part: "v 1 0 0",
        bad: "v 1e60 0 0",
        cured: "v 1 0 0",
        told: &["a coordinate is beyond 1e50", "or scale the model down"],
    },
];
