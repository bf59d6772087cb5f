//! Faults of photometric files by IES LM-63.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "room.toml",
    changed: "lamp.ies",
    arguments: &[],
    files: &[
        (
            "room.toml",
            r#"title = "room"
bands = ["grey"]
[camera]
eye = [2, -2.6, 1.4]
target = [0, 0, 0.3]
[materials.white]
reflectance = 0.5
[materials.lamp]
reflectance = 0
emission = 100
[[surfaces]]
name = "room"
material = "white"
box = { origin = [-3, -3, 0], size = [6, 6, 3], inward = true }
[[surfaces]]
name = "lamp"
material = "lamp"
disk = { center = [-1, -1, 2.4], normal = [0, 0, -1], radius = 0.2 }
[[luminaires]]
name = "hung"
position = [0.5, 0.5, 2]
photometry = "lamp.ies"
"#,
        ),
        (
            "lamp.ies",
            r"IESNA:LM-63-2002
[TEST] 7
[LUMINAIRE] Downlight
TILT=NONE
1 2000 1.0
3 1
1 1
0 0 0
1.0 1.0 20
0 45 90
0
500 300 0
",
        ),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: "TILT=NONE\n",
        bad: "",
        cured: "TILT=NONE\n",
        told: &["the text ends before a line TILT=", "help: write TILT=NONE before the numbers"],
    },
    Row {
        part: "TILT=NONE",
        bad: "TILT=MH400.TLT",
        cured: "TILT=NONE",
        told: &["TILT= names the file 'MH400.TLT'", "or TILT=NONE where the lamp burns as measured"],
    },
    Row {
        part: "TILT=NONE",
        bad: r"TILT=INCLUDE
4
2
0 90
1 1",
        cured: "TILT=NONE",
        told: &[
            "position of the lamp (1 upright, 2 along, 3 across) is 4",
            "help: write a whole number from 1 to 3",
        ],
    },
    Row {
        part: "LM-63-2002",
        bad: "LM-63-2050",
        cured: "LM-63-2002",
        told: &["the edition of LM-63 is '2050'", "help: write IESNA:LM-63-2002"],
    },
    Row {
        part: "1 2000",
        bad: "1 -2000",
        cured: "1 2000",
        told: &["the lumens of each lamp are -2000", "help: write them"],
    },
    Row {
        part: "1 2000",
        bad: "1 -2000",
        cured: "1 -1",
        told: &["the lumens of each lamp are -2000", "or -1 where the candelas are absolute"],
    },
    Row {
        part: "1 2000",
        bad: "0 2000",
        cured: "1 2000",
        told: &["the number of lamps is 0", "help: write a number above 0"],
    },
    Row {
        part: r"
3 1
",
        bad: r"
1 1
",
        cured: r"
3 1
",
        told: &["the number of vertical angles is 1", "help: write a whole number from 2 to 20000"],
    },
    Row {
        part: "0 45 90\n",
        bad: "0 90 45\n",
        cured: "0 45 90\n",
        told: &[
            "a vertical angle is 45 behind 90",
            "help: let the angles increase; check the counts of angles above",
        ],
    },
    Row {
        part: "500 300 0",
        bad: "500 300 0 1",
        cured: "500 300 0",
        told: &["is left over", "help: check the counts of angles; they say how many intensities there are"],
    },
    Row {
        part: r"
3 1
1 1
0 0 0
1.0 1.0 20
0 45 90
0
500 300 0
",
        bad: r"
3 2
1 1
0 0 0
1.0 1.0 20
0 45 90
0 75
500 300 0
500 300 0
",
        cured: r"
3 2
1 1
0 0 0
1.0 1.0 20
0 45 90
0 90
500 300 0
500 300 0
",
        told: &["the horizontal angles run from 0 to 75", "help: let them be 0 alone, or run from 0 to 90"],
    },
    Row {
        part: r"
1 1
",
        bad: r"
2 1
",
        cured: r"
1 1
",
        told: &["the photometry is of type B", "help: convert the file to type C with a photometric program"],
    },
    Row {
        part: "0 0 0\n",
        bad: "0.5 0.5 -1\n",
        cured: "0 0 0\n",
        told: &["no luminous opening has width", "help: write 0 0 0 for a point"],
    },
    Row {
        part: "0 45 90\n",
        bad: "45 60 90\n",
        cured: "0 45 90\n",
        told: &[
            "the vertical angles run from 45 to 90",
            "help: let them begin at 0 (straight down) or 90, and end at 180 or before",
        ],
    },
    Row {
        part: "500 300",
        bad: "500 -300",
        cured: "500 300",
        told: &["a luminous intensity (2 of 3) is -300", "help: write a number of at least 0"],
    },
    Row {
        part: "500 300",
        bad: "500 NaN",
        cured: "500 300",
        told: &["is NaN", "help: write a finite number"],
    },
    Row {
        part: "500 300",
        bad: "500 3OO",
        cured: "500 300",
        told: &["is '3OO', which is no number", "help: write a number"],
    },
    Row {
        part: "500 300 0",
        bad: "500",
        cured: "500 300 0",
        told: &["the text ends before a luminous intensity (2 of 3)", "help: complete it"],
    },
    Row {
        part: "500 300 0",
        bad: "0 0 0",
        cured: "500 300 0",
        told: &["the greatest luminous intensity is 0", "help: check lumens and factors"],
    },
    Row {
        part: r"
3 1
1 1
0 0 0
1.0 1.0 20
0 45 90
0
500 300 0
",
        bad: r"
2 4
1 2
0 0 0
1 1 1
0 90
0 70 130 190
1 1 1 1 1 1 1 1
",
        cured: r"
2 5
1 2
0 0 0
1 1 1
0 90
0 90 180 270 360
500 300 500 300 500 300 500 300 500 300
",
        told: &[
            "the planes go from C = 0° to 190° without a symmetry that gives the rest",
            "help: give planes all around",
        ],
    },
];
