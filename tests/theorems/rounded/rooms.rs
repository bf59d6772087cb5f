//! Rooms with things in them that touch, or miss touching by a gap.

use radiosity::solve::view_factors::ViewFactors;
use radiosity_geom::DVec3;

use crate::rounded::sheet::{Sheet, cuboid, placed, plate, room, sheet, turned};

/// A room in which something misses something else by a gap (metres).
pub(crate) struct Family {
    pub(crate) name: &'static str,
    pub(crate) sheets: fn(f64) -> Vec<Sheet>,
    /// The surfaces that lose light into a body without all of its faces, or to the black back of a sheet,
    /// with the share of their whole area that does; what is covered tightly may be left out of them instead.
    pub(crate) covered: &'static [(&'static str, f64)],
}

impl Family {
    /// The largest error of a row of view factors: what is covered may count or not.
    pub(crate) fn worst_row(&self, found: &ViewFactors) -> f64 {
        let error = |(name, sum): (&String, f64)| {
            let covered = self.covered.iter().find(|(surface, _)| surface == name);
            let lost = covered.map_or(0.0, |(_, share)| *share);
            (sum - 1.0).abs().min((sum - 1.0 + lost).abs())
        };
        found.names.iter().zip(found.row_sums()).map(error).fold(0.0, f64::max)
    }
}

const CLOSED: &[(&str, f64)] = &[];

pub(crate) const FAMILIES: [Family; 20] = [
    Family { name: "box over a floor", sheets: |g| with(on_floor(g, &[])), covered: CLOSED },
    Family {
        name: "box turned",
        sheets: |g| with(turned(on_floor(g, &[]), [1.8, 1.4], 0.3)),
        covered: CLOSED,
    },
    Family {
        name: "box without a bottom",
        sheets: |g| with(turned(on_floor(g, &["bottom"]), [1.8, 1.4], 0.3)),
        covered: &[("room-bottom", 0.8 / 14.0)],
    },
    Family { name: "box at a wall", sheets: |g| with(at_wall(g, &[])), covered: CLOSED },
    Family {
        name: "box without a back",
        sheets: |g| with(at_wall(g, &["x0"])),
        covered: &[("room-x0", 0.48 / 9.8)],
    },
    Family {
        name: "box in a corner",
        sheets: |g| with(cuboid("box", [g, g, g], [g + 0.7, g + 0.8, g + 0.5], &[])),
        covered: CLOSED,
    },
    Family {
        name: "box on a floor at a wall",
        sheets: |g| with(cuboid("box", [g, 1.0, 0.0], [g + 0.7, 1.8, 0.6], &["bottom"])),
        covered: CLOSED,
    },
    Family { name: "corner moved out", sheets: |g| cube(g), covered: CLOSED },
    Family { name: "corner moved in", sheets: |g| cube(-g), covered: CLOSED },
    Family { name: "stack", sheets: |g| with(stack([1.4, 1.1], [2.2, 1.7], g)), covered: CLOSED },
    Family {
        name: "stack overhanging, turned",
        sheets: |g| with(turned(stack([1.4, 1.1], [2.6, 1.7], g), [1.8, 1.4], 0.4)),
        covered: CLOSED,
    },
    Family { name: "stack of equals", sheets: |g| with(stack([1.2, 1.0], [2.4, 1.9], g)), covered: CLOSED },
    Family {
        name: "boxes side by side",
        sheets: |g| {
            let one = cuboid("one", [1.2, 1.0, 0.0], [2.0, 1.9, 0.5], &["bottom"]);
            let other = cuboid("other", [2.0 + g, 1.1, 0.0], [2.6, 1.7, 0.7], &["bottom"]);
            with([one, other].concat())
        },
        covered: CLOSED,
    },
    Family { name: "box on an edge", sheets: |g| with(tilted(DVec3::NEG_Y, 0.4, g)), covered: CLOSED },
    Family {
        name: "box on a corner",
        sheets: |g| with(tilted(DVec3::new(0.6, 0.64, 0.48), 0.9, g)),
        covered: CLOSED,
    },
    Family {
        name: "plates",
        sheets: |g| {
            let lower = plate("lower", &rectangle([1.0, 1.0], [2.0, 2.0], 1.0));
            with(vec![lower, plate("upper", &rectangle([1.2, 1.1], [2.3, 2.2], 1.0 + g))])
        },
        covered: CLOSED,
    },
    Family {
        name: "plate on a floor",
        sheets: |g| with(vec![plate("plate", &rectangle([1.0, 1.0], [2.0, 2.0], g))]),
        covered: CLOSED,
    },
    Family {
        name: "picture on a wall",
        sheets: |g| {
            let corners = [[g, 1.0, 1.0], [g, 2.0, 1.0], [g, 2.0, 1.7], [g, 1.0, 1.7]];
            with(vec![sheet("picture", &corners)])
        },
        covered: &[("room-x0", 0.7 / 9.8)],
    },
    Family {
        name: "thin partition",
        sheets: |g| {
            let corners = [[2.0, g, 0.0], [2.0, 2.5, 0.0], [2.0, 2.5, 2.8 - g], [2.0, g, 2.8 - g]];
            with(vec![plate("partition", &corners)])
        },
        covered: CLOSED,
    },
    Family {
        name: "thick partition",
        sheets: |g| with(cuboid("partition", [1.9, g, g], [2.1, 2.5, 2.8 - g], &[])),
        covered: CLOSED,
    },
];

fn with(things: Vec<Sheet>) -> Vec<Sheet> {
    room().into_iter().chain(things).collect()
}

fn on_floor(gap: f64, open: &[&str]) -> Vec<Sheet> {
    cuboid("box", [1.3, 1.0, gap], [2.3, 1.8, gap + 0.6], open)
}

fn at_wall(gap: f64, open: &[&str]) -> Vec<Sheet> {
    cuboid("box", [gap, 1.0, 0.7], [gap + 0.7, 1.8, 1.3], open)
}

/// A unit cube, fronts inside, one corner of which is moved by about `off`.
fn cube(off: f64) -> Vec<Sheet> {
    let mut walls = cuboid("cube", [0.0; 3], [1.0; 3], &[]);
    walls.iter_mut().for_each(|wall| wall.corners.reverse());
    placed(walls, |x| if x == DVec3::ONE { x + off * DVec3::new(0.7, 0.5, 1.0) } else { x })
}

/// A box with that base over another on the floor.
fn stack([x0, y0]: [f64; 2], [x1, y1]: [f64; 2], gap: f64) -> Vec<Sheet> {
    let lower = cuboid("lower", [1.2, 1.0, 0.0], [2.4, 1.9, 0.5], &["bottom"]);
    [lower, cuboid("upper", [x0, y0, 0.5 + gap], [x1, y1, 1.0 + gap], &[])].concat()
}

/// A box turned about an axis, its lowest point that far over the floor.
fn tilted(axis: DVec3, angle: f64, gap: f64) -> Vec<Sheet> {
    let rotation = radiosity_geom::Motion::new(DVec3::ZERO, axis, angle, 1.0).expect("a motion");
    let sheets = placed(cuboid("box", [0.0; 3], [0.8, 0.6, 0.5], &[]), |x| rotation.point(x));
    let low = sheets.iter().flat_map(|sheet| &sheet.corners).map(|x| x.z).fold(f64::INFINITY, f64::min);
    placed(sheets, |x| DVec3::new(x.x + 1.6, x.y + 1.3, x.z - low + gap))
}

/// A horizontal rectangle, front up.
fn rectangle([x0, y0]: [f64; 2], [x1, y1]: [f64; 2], z: f64) -> [[f64; 3]; 4] {
    [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]]
}
