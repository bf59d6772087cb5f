//! Faults of STL files.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.stl",
    changed: "scene.stl",
    arguments: &[],
    files: &[(
        "scene.stl",
        r"solid square
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 1 1 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
endloop
endfacet
endsolid square
",
    )],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: r"facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 1 1 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
endloop
endfacet
",
        bad: "",
        cured: r"facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 1 1 0
endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
endloop
endfacet
",
        told: &["the file holds no facets", "help: save the model with polygons"],
    },
    Row {
        part: r"facet normal 0 0 1
outer loop
",
        bad: "",
        cured: r"facet normal 0 0 1
outer loop
",
        told: &[
            "'vertex' cannot stand here",
            "help: export the model again; a facet is 'facet normal', 'outer loop', three 'vertex', 'endloop', 'endfacet'",
        ],
    },
    Row {
        part: r"endloop
endfacet
endsolid square
",
        bad: "",
        cured: r"endloop
endfacet
endsolid square
",
        told: &["the text ends within a facet", "or end the facet with 'endloop', 'endfacet'"],
    },
    Row {
        part: "vertex 0 1 0\n",
        bad: "vertex 0 1\n",
        cured: "vertex 0 1 0\n",
        told: &["a vertex has 2 numbers, it takes three", "help: give it x, y and z"],
    },
    Row {
        part: "vertex 0 1 0\n",
        bad: "vertex 0 1e999 0\n",
        cured: "vertex 0 1 0\n",
        told: &["y is 1e999", "help: write a finite number"],
    },
    Row {
        part: "vertex 0 1 0\n",
        bad: "vertex 0 one 0\n",
        cured: "vertex 0 1 0\n",
        told: &["y is 'one', which is no number", "help: write a number"],
    },
    Row {
        part: "vertex 0 1 0\n",
        bad: "",
        cured: "vertex 0 1 0\n",
        told: &["the facet has 2 corners", "help: a facet of STL is a triangle: give it three"],
    },
    Row {
        part: r"endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
",
        bad: "vertex 0 1 0\n",
        cured: r"endloop
endfacet
facet normal 0 0 1
outer loop
vertex 0 0 0
vertex 1 1 0
vertex 0 1 0
",
        told: &["the facet has 4 corners", "or split it"],
    },
];
