//! Faults of MGF files.

use super::super::{Changed, MORE, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.mgf",
    changed: "scene.mgf",
    arguments: &[],
    files: &[
        (
            "scene.mgf",
            r"m white =
 rd 0.5
 ed 1
v a =
 p 0 0 0
v b =
 p 1 0 0
v c =
 p 0 1 0
v n =
 p 0 0 1
 n 0 0 1
v d =
 p 5 0 5
v e =
 p 6 0 5
v g =
 p 5 1 6
m white
f a b c
# more
",
        ),
        (
            "part.mgf",
            r"v p =
 p 5 5 5
sph p .1
",
        ),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: "f d e\n",
        cured: "f d e g\n",
        told: &["a face has 2 vertices, 3 are the least", "help: add some"],
    },
    Row {
        part: MORE,
        bad: "f d e\n",
        cured: "",
        told: &["a face has 2 vertices, 3 are the least", "or take it out"],
    },
    Row {
        part: MORE,
        bad: "fh d e g - d e\n",
        cured: "fh d e g\n",
        told: &[
            "an outline of a face has 2 vertices, 3 are the least",
            "help: add some, or take it out; a - parts outlines",
        ],
    },
    Row {
        part: MORE,
        bad: "sph z .1\n",
        cured: r"v z =
 p 3 0 0
sph z .1
",
        told: &[
            "the vertex 'z' is not defined",
            "help: define it above, with a blank before the equals sign: z =",
        ],
    },
    Row {
        part: MORE,
        bad: "c a b\n",
        cured: "c a =\n",
        told: &[
            "the arguments of a colour are not right",
            "help: write a name, or a name and =, or a name, = and a template, parted by blanks",
        ],
    },
    Row {
        part: MORE,
        bad: r"v d =
 p 1 2 x
",
        cured: r"v d =
 p 1 2 3
",
        told: &["a number of p is 'x', which is no number", "help: write a number"],
    },
    Row {
        part: MORE,
        bad: r"v d =
 p 1 2 1e999
",
        cured: r"v d =
 p 1 2 3
",
        told: &["a number of p is 1e999", "help: write a finite number"],
    },
    Row {
        part: MORE,
        bad: r"v d =
 p 1 2
",
        cured: r"v d =
 p 1 2 3
",
        told: &["p has 2 arguments, 3 are needed", "help: write them on one line"],
    },
    Row {
        part: MORE,
        bad: r"v d =
 p 1 2
 3
",
        cured: r#"v d =
 p 1 2 \
 3
"#,
        told: &["p has 2 arguments, 3 are needed", "or end lines with a backslash"],
    },
    Row {
        part: MORE,
        bad: "rd -1\nf d e g\n",
        cured: "rd 0\nf d e g\n",
        told: &["rd is -1, below 0", "help: write 0 or more"],
    },
    Row {
        part: MORE,
        bad: "sides 3\n",
        cured: "sides 1\n",
        told: &["a material has 3 sides", "help: write sides 1 or sides 2"],
    },
    Row {
        part: MORE,
        bad: r"c x =
 cxy .9 .9
m odd =
 rd .1
f d e g
",
        cured: r"c x =
 cxy .3 .3
m odd =
 rd .1
f d e g
",
        told: &[
            "no colour has the chromaticity 0.9, 0.9",
            "help: write x from 0 and y from 0.001 that sum to 1 at most",
        ],
    },
    Row {
        part: MORE,
        bad: r"c x =
 cspec 400 700 1
m odd =
 rd .1
f d e g
",
        cured: r"c x =
 cspec 400 700 1 1
m odd =
 rd .1
f d e g
",
        told: &[
            "a spectrum has no range",
            "help: write the shorter wavelength, the longer one, and two values or more",
        ],
    },
    Row {
        part: MORE,
        bad: r"c x =
 cspec 400 700 1 -1
m odd =
 rd .1
f d e g
",
        cured: r"c x =
 cspec 400 700 1 0
m odd =
 rd .1
f d e g
",
        told: &["a spectrum has a value below 0", "help: write 0 or more"],
    },
    Row {
        part: MORE,
        bad: r"c x =
 cspec 400 700 0 0
m odd =
 rd .1
f d e g
",
        cured: r"c x =
 cspec 400 700 1 1
m odd =
 rd .1
f d e g
",
        told: &[
            "a spectrum has no light that an eye sees",
            "help: write values above 0 between 380 and 780 nm",
        ],
    },
    Row {
        part: MORE,
        bad: r"c x =
 cct 10
m odd =
 rd .1
f d e g
",
        cured: r"c x =
 cct 1000
m odd =
 rd .1
f d e g
",
        told: &["a black body of 10 K hardly glows", "help: write 1000 K or more"],
    },
    Row {
        part: MORE,
        bad: r"c x =
 cct 10
m odd =
 rd .1
f d e g
",
        cured: r"c x =
 cxy .6 .35
m odd =
 rd .1
f d e g
",
        told: &["a black body of 10 K hardly glows", "or a chromaticity by cxy"],
    },
    Row {
        part: MORE,
        bad: r"c x =
c y =
 cmix 1
",
        cured: r"c x =
c y =
 cmix 1 x
",
        told: &["a mixture lacks a colour", "help: write a weight before each colour"],
    },
    Row {
        part: MORE,
        bad: r"c x =
c y =
 cmix 0 x
m odd =
 rd .1
f d e g
",
        cured: r"c x =
c y =
 cmix 1 x
m odd =
 rd .1
f d e g
",
        told: &["the weights of a mixture are not right", "help: write weights from 0, one above"],
    },
    Row {
        part: MORE,
        bad: "sph n\n",
        cured: "sph n .1\n",
        told: &["sph does not have 1 arguments", "help: write sph vertex radius"],
    },
    Row {
        part: MORE,
        bad: "cyl n .1\n",
        cured: "cyl n .1 a\n",
        told: &["cyl does not have 2 arguments", "help: write cyl vertex radius vertex"],
    },
    Row {
        part: MORE,
        bad: "cone n .1 a\n",
        cured: "cone n .1 a .2\n",
        told: &["cone does not have 3 arguments", "help: write cone vertex radius vertex radius"],
    },
    Row {
        part: MORE,
        bad: "ring n 0\n",
        cured: "ring n 0 .1\n",
        told: &["ring does not have 2 arguments", "help: write ring vertex inner-radius outer-radius"],
    },
    Row {
        part: MORE,
        bad: "torus n .1\n",
        cured: "torus n .1 .2\n",
        told: &["torus does not have 2 arguments", "help: write torus vertex least-radius greatest-radius"],
    },
    Row {
        part: MORE,
        bad: "prism\n",
        cured: "prism d e g -.5\n",
        told: &["prism does not have 0 arguments", "help: write prism vertex vertex vertex … length"],
    },
    Row {
        part: MORE,
        bad: "sph n 0\n",
        cured: "sph n .1\n",
        told: &["a sphere has no radius", "help: give it one"],
    },
    Row { part: MORE, bad: "sph n 0\n", cured: "", told: &["a sphere has no radius", "or take it out"] },
    Row {
        part: MORE,
        bad: "cyl n .1 n\n",
        cured: "cyl n .1 a\n",
        told: &["a cylinder has no axis", "help: part its ends"],
    },
    Row {
        part: MORE,
        bad: "cone n .1 a -.2\n",
        cured: "cone n .1 a .2\n",
        told: &["the radii of a cone have different signs", "help: write both above 0"],
    },
    Row {
        part: MORE,
        bad: "cone n .1 a -.2\n",
        cured: "cone n -.1 a -.2\n",
        told: &["the radii of a cone have different signs", "or both below for a cone seen from inside"],
    },
    Row {
        part: MORE,
        bad: "ring d 0 .1\n",
        cured: r"v d
 n 0 0 1
ring d 0 .1
",
        told: &["the vertex of a ring has no normal", "help: write one behind its point: n 0 0 1"],
    },
    Row {
        part: MORE,
        bad: "ring n .2 .1\n",
        cured: "ring n .1 .2\n",
        told: &[
            "the radii of a ring are not in order",
            "help: write the inner one, 0 or more, then the outer",
        ],
    },
    Row {
        part: MORE,
        bad: "torus n -.1 .2\n",
        cured: "torus n .1 .2\n",
        told: &[
            "the radii of a torus are not in order",
            "help: write the smaller one, then the greater, both of one sign",
        ],
    },
    Row {
        part: MORE,
        bad: "prism d e g 0\n",
        cured: "prism d e g -.5\n",
        told: &["a prism has no volume", "help: give it a length"],
    },
    Row { part: MORE, bad: "xf\n", cured: "", told: &["an xf ends no transform", "help: take it out"] },
    Row {
        part: MORE,
        bad: r"sph n .1
xf
",
        cured: r"xf -t 0 0 1
sph n .1
xf
",
        told: &["an xf ends no transform", "or begin one above: xf -t 0 0 1"],
    },
    Row {
        part: MORE,
        bad: r"xf -q 1
xf
",
        cured: r"xf -rx 1
xf
",
        told: &[
            "'-q' is no part of a transform",
            "help: write -t, -rx, -ry, -rz, -s, -mx, -my, -mz, -i or -a with their numbers",
        ],
    },
    Row {
        part: MORE,
        bad: r"xf -a 2 -t 1 0 0
sph n .1
",
        cured: r"xf -a 2 -t 1 0 0
sph n .1
xf
",
        told: &["an array is not ended", "help: write a line with xf alone behind what it repeats"],
    },
    Row {
        part: MORE,
        bad: r"xf -a 0 -t 1 0 0
sph n .1
xf
",
        cured: r"xf -a 1 -t 1 0 0
sph n .1
xf
",
        told: &["-a 0 makes no array", "help: write a whole number from 1"],
    },
    Row {
        part: MORE,
        bad: r"xf -i -1 -t 1 0 0
sph n .1
xf
",
        cured: r"xf -i 0 -t 1 0 0
sph n .1
xf
",
        told: &["-i -1 is no number of repetitions", "help: write a whole number from 0"],
    },
    Row {
        part: MORE,
        bad: r"xf -t 1 0
sph n .1
xf
",
        cured: r"xf -t 1 0 0
sph n .1
xf
",
        told: &["-t lacks a number", "help: write its numbers behind it, parted by blanks"],
    },
    Row {
        part: MORE,
        bad: r"xf -s 0
sph n .1
xf
",
        cured: r"xf -s 1
sph n .1
xf
",
        told: &["a scale is 0", "help: write another factor behind -s"],
    },
    Row {
        part: MORE,
        bad: r"xf -a 100000000 -t 1 0 0
sph n .1
xf
",
        cured: r"xf -a 2 -t 1 0 0
sph n .1
xf
",
        told: &["an array has more than", "help: make it smaller"],
    },
    Row {
        part: MORE,
        bad: "i\n",
        cured: "i part.mgf\n",
        told: &["an include names no file", "help: write its name behind i"],
    },
    Row {
        part: MORE,
        bad: "\0\n",
        cured: "",
        told: &["this is not a text: it holds a zero byte", "or save it as UTF-8"],
    },
    Row {
        part: MORE,
        bad: "i none.mgf\n",
        cured: "i part.mgf\n",
        told: &["the included file 'none.mgf' cannot be read", "help: put it beside the scene"],
    },
    Row {
        part: MORE,
        bad: "i none.mgf\n",
        cured: "",
        told: &["the included file 'none.mgf' cannot be read", "or take the include out"],
    },
    Row {
        part: MORE,
        bad: "i scene.mgf\n",
        cured: "",
        told: &["'scene.mgf' includes itself", "help: take one include out"],
    },
    Row {
        part: MORE,
        bad: r"m bright =
 rd 1e99
f d e g
",
        cured: r"m bright =
 rd .5
f d e g
",
        told: &["the material 'bright' has a value beyond", "help: correct its reflectance or its emission"],
    },
    Row {
        part: MORE,
        bad: r"xf -s 1e200 -s 1e200
sph b 1
xf
",
        cured: r"xf -s 3
sph b .1
xf
",
        told: &["is beyond 1e50 after transforms", "help: scale the scene down"],
    },
];
