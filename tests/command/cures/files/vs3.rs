//! Faults of View3D inputs.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.vs3",
    changed: "scene.vs3",
    arguments: &[],
    files: &[(
        "scene.vs3",
        r"T cube
F 3
V 1 0 0 0
V 2 1 0 0
V 3 1 1 0
V 4 0 1 0
S 1 1 2 3 4 0 0 0.9 floor
E
",
    )],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row { part: "F 3", bad: "F 2", cured: "F 3", told: &["the geometry is '2'", "help: write F 3 or F 3a"] },
    Row {
        part: "V 2 1 0 0",
        bad: "V 2 1 0",
        cured: "V 2 1 0 0",
        told: &["a vertex has 3 words behind its letter", "help: write V, its number, x, y and z"],
    },
    Row {
        part: "V 2 1 0 0",
        bad: "V 2 1e999 0 0",
        cured: "V 2 1 0 0",
        told: &["x is 1e999", "help: write a finite number"],
    },
    Row {
        part: "V 2 1 0 0",
        bad: "V 2 1e200 0 0",
        cured: "V 2 1 0 0",
        told: &["a coordinate is beyond 1e50", "help: write smaller coordinates"],
    },
    Row {
        part: "V 2 1 0 0",
        bad: "V 2 l 0 0",
        cured: "V 2 1 0 0",
        told: &["x is 'l', which is no number", "help: write a number"],
    },
    Row {
        part: "V 2",
        bad: "V 3",
        cured: "V 2",
        told: &[
            "the number of a vertex is '3', it has to be 2",
            "help: number each vertex by its place among them, from 1",
        ],
    },
    Row {
        part: "V 2",
        bad: "W 2",
        cured: "V 2",
        told: &["a line begins with 'W'", "help: begin it with T, C, F, V, S, M, N, O or E"],
    },
    Row {
        part: "T cube\n",
        bad: "W cube\n",
        cured: "! W cube\n",
        told: &["a line begins with 'W'", "or with ! if it is a comment"],
    },
    Row {
        part: "1 2 3 4 0 0 0.9 floor",
        bad: "1 2 3",
        cured: "1 2 3 4 0 0 0.9 floor",
        told: &[
            "a surface lacks some of its four vertices",
            "help: write the letter, its number, four vertices",
        ],
    },
    Row {
        part: "1 2 3 4 0 0 0.9 floor",
        bad: "1 2 3 4 0 0",
        cured: "1 2 3 4 0 0 0.9 floor",
        told: &["a surface lacks its base, its combination or its emittance", "its base (0 for none)"],
    },
    Row {
        part: "E\n",
        bad: "O 2\n",
        cured: r"V 5 0 1 3
V 6 1 1 3
V 7 1 0 3
O 2 5 6 7 0 sign
E
",
        told: &[
            "a surface lacks some of its four vertices",
            "help: write O, its number, four vertices (the fourth 0 for a triangle) and a name",
        ],
    },
    Row {
        part: "1 2 3 4 0 0",
        bad: "1 2 3 5 0 0",
        cured: "1 2 3 4 0 0",
        told: &[
            "there is no vertex 5",
            "help: name one from 1 to 4; only the fourth may be 0, in a triangle",
        ],
    },
    Row {
        part: "1 2 3 4 0 0",
        bad: "1 -2 3 4 0 0",
        cured: "1 2 3 4 0 0",
        told: &[
            "a vertex is '-2', which is no whole number from 0",
            "help: write the number that it has in this file",
        ],
    },
    Row {
        part: "0 0 0.9",
        bad: "0 0 1.1",
        cured: "0 0 0.9",
        told: &["the emittance is 1.1", "help: write a number from 0 to 1; 1 is black"],
    },
    Row {
        part: "0 0 0.9",
        bad: "1 0 0.9",
        cured: "0 0 0.9",
        told: &["the base 1 is neither a surface before this one nor an obstruction", "or write base 0"],
    },
    Row {
        part: "E\n",
        bad: "M 2 1 2 3 0 0 0 0.9 cover\n",
        cured: "E\n",
        told: &["a masking or null surface has no base", "help: write the number of the surface it lies on"],
    },
    Row {
        part: r"S 1 1 2 3 4 0 0 0.9 floor
E
",
        bad: r"S 1 R 0 0 0.9 floor
0 0 0 0
",
        cured: r"S 1 R 0 0 0.9 floor
0 0 0 0 0 1 1
E
",
        told: &[
            "a surface has 4 numbers in the lines behind it, 7 are needed",
            "help: write its origin, azimuth and tilt",
        ],
    },
    Row {
        part: "S 1 1 2 3 4 0 0 0.9 floor\n",
        bad: "",
        cured: "S 1 1 2 3 4 0 0 0.9 floor\n",
        told: &["there are no surfaces", "help: add lines that begin with S"],
    },
    Row {
        part: "E\n",
        bad: r"V 5 0 1 1
V 6 1 1 1
V 7 1 0 1
S 2 5 6 7 0 1 0 0.9 b
",
        cured: r"V 5 0 1 1
V 6 1 1 1
V 7 1 0 1
S 2 5 6 7 0 0 0 0.9 b
",
        told: &["not lie in the plane of its base 1", "or write base 0"],
    },
];
