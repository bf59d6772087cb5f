//! Faults of planes of sensors in scene files.

use super::super::{MORE, Row};

pub(super) const ROWS: &[Row] = &[
    Row {
        part: MORE,
        bad: r"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 0
",
        cured: r"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 0.5
",
        told: &["the spacing is 0", "help: choose a value with spacing > 0"],
    },
    Row {
        part: MORE,
        bad: r"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [2, 0, 0]]
spacing = 0.5
",
        cured: r"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 0.5
",
        told: &["the edges are parallel", "help: give two edges, vectors along two sides of the plane"],
    },
    Row {
        part: MORE,
        bad: r"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 1e-9
",
        cured: r"[planes.desk]
origin = [0, 0, 1]
edges = [[1, 0, 0], [0, 1, 0]]
spacing = 3.2e-4
",
        told: &[
            "sensors, more than 10⁷",
            "help: choose a larger spacing: 3.2e-4 for both edges makes few enough",
        ],
    },
];
