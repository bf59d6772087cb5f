//! Faults of photometric files by EULUMDAT.

use super::super::{Changed, Row};

pub(super) const CHANGED: Changed = Changed {
    scene: "room.toml",
    changed: "lamp.ldt",
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
photometry = "lamp.ldt"
"#,
        ),
        (
            "lamp.ldt",
            r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
1000
4000 K
1B
12
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0
0
45
90
500
300
0
",
        ),
    ],
    rows: ROWS,
};

const ROWS: &[Row] = &[
    Row {
        part: r"ACME
1
1
",
        bad: r"ACME
1
5
",
        cured: r"ACME
1
1
",
        told: &["the symmetry Isym is 5", "help: write a whole number from 0 to 4"],
    },
    Row {
        part: r"ACME
1
1
1
",
        bad: r"ACME
1
1
0
",
        cured: r"ACME
1
1
1
",
        told: &["the number of planes Mc is 0", "help: write a whole number from 1 to 20000"],
    },
    Row {
        part: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
",
        bad: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
-1
",
        cured: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
",
        told: &["the length of the luminaire is -1", "help: write a number of at least 0"],
    },
    Row {
        part: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
",
        bad: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
0
",
        cured: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
",
        told: &["conversion factor of the intensities is 0", "help: write a number above 0"],
    },
    Row {
        part: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
1000
",
        bad: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
inf
",
        cured: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
1000
",
        told: &["is inf", "help: write a finite number"],
    },
    Row {
        part: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
1000
4000 K
1B
12
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0
",
        bad: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
1000
4000 K
1B
12
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
5
",
        cured: r"ACME
1
1
1
0
3
5
R
Downlight
1
lamp.ldt
today
200
0
80
150
0
0
0
0
0
100
80
1
0
1
1
LED
1000
4000 K
1B
12
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0.5
0
",
        told: &["the angles C run from 5 to 5", "help: let them begin at 0 and end before 360"],
    },
];
