//! Faults of Radiance files.

use super::super::{Changed, MORE, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "scene.rad",
    changed: "scene.rad",
    arguments: &[],
    files: &[
        (
            "scene.rad",
            r"void plastic white
0
0
5 .5 .5 .5 0 0
void light lamp
0
0
3 1 1 1
lamp ring disk
0
0
8 0 0 2 0 0 -1 0 .1
white polygon floor
0
0
9 0 0 0 1 0 0 0 1 0
# more
",
        ),
        ("part.rad", "white sphere part 0 0 4 5 5 5 .1\n"),
        ("paint.rad", "void plastic m 0 0 5 .5 .5 .5 0 0\n"),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: "m sphere s 0 0 4 3 0 0 .1\n",
        cured: r"void plastic m 0 0 5 .5 .5 .5 0 0
m sphere s 0 0 4 3 0 0 .1
",
        told: &["the modifier 'm' is not defined", "help: define it above"],
    },
    Row {
        part: MORE,
        bad: "m sphere s 0 0 4 3 0 0 .1\n",
        cured: r"!xform paint.rad
m sphere s 0 0 4 3 0 0 .1
",
        told: &[
            "the modifier 'm' is not defined",
            "or join the file of the materials and this one: !xform materials.rad",
        ],
    },
    Row {
        part: MORE,
        bad: "void mixfunc a 0 0 0\n",
        cured: "",
        told: &["the mixfunc 'a' names no material", "help: name one as its first text"],
    },
    Row {
        part: MORE,
        bad: "white polygon p 0 0 6 0 0 0 1 0 0\n",
        cured: "white polygon p 0 0 9 0 0 1 1 0 1 0 1 1\n",
        told: &["the polygon 'p' has 6 numbers", "help: write them all, and their count before them"],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0 3 1 1 1\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &[
            "the sphere 's' has 3 numbers, 4 are needed",
            "help: write them all, and their count before them",
        ],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0 4 1 1 1 0\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &["a sphere has no radius", "help: give it one"],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0 4 1 1 1 x\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &["'x', which is no number", "help: write a number"],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0 4 1 1 1 nan\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &["a number is nan", "help: write a finite number"],
    },
    Row {
        part: MORE,
        bad: "white cylinder s 0 0 7 3 0 0 3 0 0 1\n",
        cured: "white cylinder s 0 0 7 3 0 0 3 0 1 1\n",
        told: &["a cylinder has no axis", "help: part its ends"],
    },
    Row {
        part: MORE,
        bad: "white cone s 0 0 8 3 0 0 3 0 1 -1 1\n",
        cured: "white cone s 0 0 8 3 0 0 3 0 1 .5 1\n",
        told: &["radii of both signs", "help: give both the sign alike"],
    },
    Row {
        part: MORE,
        bad: "white cone s 0 0 8 3 0 0 3 0 1 -1 1\n",
        cured: "white cup s 0 0 8 3 0 0 3 0 1 .5 1\n",
        told: &["radii of both signs", "a cup is a cone seen from inside"],
    },
    Row {
        part: MORE,
        bad: "white ring s 0 0 8 3 0 0 0 0 1 -1 1\n",
        cured: "white ring s 0 0 8 3 0 0 0 0 1 0 1\n",
        told: &["a radius below 0", "help: write 0 or more"],
    },
    Row {
        part: MORE,
        bad: "void plastic p 0 0 3 1 1 1\n",
        cured: r"void plastic p 0 0 5 .5 .5 .5 0 0
p sphere s 0 0 4 3 1 1 .1
",
        told: &[
            "the plastic 'p' has 3 numbers, 4 are the least",
            "help: write them all, and their count before them",
        ],
    },
    Row {
        part: MORE,
        bad: "void light p 0 0 3 1 -1 1\n",
        cured: r"void light p 0 0 3 1 0 1
p sphere s 0 0 4 3 1 1 .1
",
        told: &["the light 'p' has -1, below 0", "help: write 0 or more"],
    },
    Row {
        part: MORE,
        bad: "white cube c 0 0 0\n",
        cured: "white sphere c 0 0 4 3 1 1 .1\n",
        told: &[
            "'cube' is no type of Radiance",
            "help: correct it; a primitive is modifier, type, name, and three lists with their counts",
        ],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &[
            "the file ends where the number of numbers must stand",
            "help: complete the last primitive: modifier, type, name, and three lists with their counts",
        ],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0 4.5 1\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &[
            "'4.5' is no number of numbers",
            "help: write how many follow: a primitive has three lists, each with its count before it",
        ],
    },
    Row {
        part: MORE,
        bad: "white sphere s 0 0 4000 1\n",
        cured: "white sphere s 0 0 4 3 1 1 .1\n",
        told: &["4000 numbers are announced, more than the file holds", "help: write how many follow"],
    },
    Row {
        part: MORE,
        bad: "!gensky 6 21 12\n",
        cured: "",
        told: &[
            "the command '!gensky 6 21 12' is not run",
            "help: run it yourself and put what it prints in its place",
        ],
    },
    Row {
        part: MORE,
        bad: "!xform -t 1 0 0\n",
        cured: "!xform -t 1 0 0 part.rad\n",
        told: &["an xform names no file", "help: name one behind its transforms"],
    },
    Row {
        part: MORE,
        bad: "!xform -f x part.rad\n",
        cured: "!xform -t 1 0 0 part.rad\n",
        told: &["xform -f is not followed", "help: write -n, -m, -I, -e or -c first"],
    },
    Row {
        part: MORE,
        bad: "!xform none.rad\n",
        cured: "!xform part.rad\n",
        told: &["the included file 'none.rad' cannot be read", "help: put it beside the scene"],
    },
    Row {
        part: MORE,
        bad: "!genbox white b 1 1\n",
        cured: "!genbox white b 1 1 1 | xform -t 4 4 4\n",
        told: &["a genbox lacks arguments", "help: write genbox material name x y z"],
    },
    Row {
        part: MORE,
        bad: "!genbox white b 1 1 0\n",
        cured: "!genbox white b 1 1 1 | xform -t 4 4 4\n",
        told: &["a box has no volume", "help: write three sizes above 0"],
    },
    Row {
        part: MORE,
        bad: "!genbox white b 1 1 1 -r .1 | xform -t 4 4 4\n",
        cured: "!genbox white b 1 1 1 | xform -t 4 4 4\n",
        told: &["genbox -r is not followed", "help: take rounded and bevelled edges out"],
    },
    Row {
        part: MORE,
        bad: "!xform part.rad |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform |xform\n",
        cured: "!xform part.rad\n",
        told: &[
            "a command has more than 32 stages",
            "help: join some of them: one xform takes several transforms",
        ],
    },
    Row {
        part: MORE,
        bad: "!xform scene.rad\n",
        cured: "",
        told: &["'scene.rad' includes itself", "help: take one include out"],
    },
];
