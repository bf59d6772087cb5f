//! Faults of PLY files.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.ply",
    changed: "scene.ply",
    arguments: &[],
    files: &[(
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
    )],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: r"end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
",
        bad: "",
        cured: r"end_header
0 0 0
1 0 0
1 1 0
0 1 0
4 0 1 2 3
",
        told: &["the header does not end", "help: export the model again; a header ends with 'end_header'"],
    },
    Row {
        part: "format ascii 1.0\n",
        bad: "",
        cured: "format ascii 1.0\n",
        told: &["the header names no format", "help: add 'format ascii 1.0' below 'ply'"],
    },
    Row {
        part: "1.0",
        bad: "2.0",
        cured: "1.0",
        told: &["the version 2.0 is not known", "help: save the file as version 1.0"],
    },
    Row {
        part: "ascii",
        bad: "text",
        cured: "ascii",
        told: &["'text' is no format of PLY", "help: write ascii, binary_little_endian or binary_big_endian"],
    },
    Row {
        part: "comment",
        bad: "remark",
        cured: "comment",
        told: &["'remark' is no statement of a header", "or 'comment'"],
    },
    Row {
        part: "vertex 4",
        bad: "vertex -4",
        cured: "vertex 4",
        told: &["the number of 'vertex' is '-4'", "help: write how many there are"],
    },
    Row {
        part: "float x",
        bad: "real x",
        cured: "float x",
        told: &[
            "'real' is no type of numbers",
            "help: write char, uchar, short, ushort, int, uint, float or double",
        ],
    },
    Row {
        part: "float x",
        bad: "float w",
        cured: "float x",
        told: &["the vertices have no property x", "help: give them x, y and z as numbers"],
    },
    Row {
        part: "vertex_indices",
        bad: "corners",
        cured: "vertex_indices",
        told: &[
            "the elements 'face' have no list vertex_indices",
            "help: add 'property list uchar int vertex_indices'",
        ],
    },
    Row {
        part: r"element vertex 4
property float x
",
        bad: r"property float x
element vertex 4
",
        cured: r"element vertex 4
property float x
",
        told: &["a property stands before all elements", "help: put it behind its 'element'"],
    },
    Row {
        part: "vertex 4",
        bad: "vertex 88888888",
        cured: "vertex 4",
        told: &["88888888 elements are announced", "help: export the file again, or correct the count"],
    },
    Row {
        part: "face 1",
        bad: "face 2",
        cured: "face 1",
        told: &["the file ends early", "or correct the counts in its header"],
    },
    Row {
        part: "face 1",
        bad: "face 0",
        cured: "face 1",
        told: &["the file holds no faces with a list vertex_indices", "help: save the model with polygons"],
    },
    Row {
        part: "1 0 0",
        bad: "nan 0 0",
        cured: "1 0 0",
        told: &["a coordinate of this vertex is not finite", "help: correct it, or export the model again"],
    },
    Row { part: "1 0 0", bad: "1 O 0", cured: "1 0 0", told: &["'O' is no number", "help: write a number"] },
    Row {
        part: "4 0 1 2 3",
        bad: "4 0 1 2 4",
        cured: "4 0 1 2 3",
        told: &[
            "the face has the vertex 4; 4 are listed, from 0 on",
            "help: correct the number, or list the vertex",
        ],
    },
    Row {
        part: r"vertex 4
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
        bad: r"vertex 4
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
5 0 1 2 3 4
",
        cured: r"vertex 5
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
0 0.5 0
5 0 1 2 3 4
",
        told: &["the face has the vertex 4", "or list the vertex"],
    },
    Row {
        part: "4 0 1 2 3",
        bad: "-4 0 1 2 3",
        cured: "4 0 1 2 3",
        told: &[
            "the list 'vertex_indices' has the length -4",
            "help: correct its length, or export the model again",
        ],
    },
    Row {
        part: "4 0 1 2 3",
        bad: "2 0 1",
        cured: "4 0 1 2 3",
        told: &["a face has 2 corners, 3 are the least", "help: take the face out, or give it three corners"],
    },
    Row {
        part: "1 0 0\n",
        bad: "1e60 0 0\n",
        cured: "1 0 0\n",
        told: &["a coordinate is beyond 1e50", "help: correct it, or scale the model down"],
    },
];
