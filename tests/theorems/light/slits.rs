//! Closed rooms with two boxes that are joined or leave a slit between them: narrow shadows, and narrow
//! strips of light.

use radiosity::visibility::Shadows;

use crate::light::occlusion::{closure, factors};
use crate::light::shapes::{Quad, quad, room, upright};

/// Two boxes on the floor of a room.
struct Boxes {
    /// Breadth of both, and lengths.
    width: f64,
    lengths: [f64; 2],
    /// The first is the lower one.
    heights: [f64; 2],
    /// Breadth of the slit; 0 where they are joined.
    slit: f64,
    /// Turn about the vertical, and the middle of the second one's near side.
    angle: f64,
    at: [f64; 2],
}

impl Boxes {
    /// The room with them: without the faces that touch, but with what the higher one's shows above the lower
    /// one.
    fn in_room(&self) -> Vec<Quad> {
        let (sin, cos) = self.angle.sin_cos();
        let place = |u: f64, v: f64| [self.at[0] + cos * u - sin * v, self.at[1] + sin * u + cos * v];
        let half = 0.5 * self.width;
        let base =
            |from: f64, to: f64| [place(from, -half), place(to, -half), place(to, half), place(from, half)];
        let low = upright("low", base(-self.lengths[0] - self.slit, -self.slit), [0.0, self.heights[0]]);
        let high = upright("high", base(0.0, self.lengths[1]), [0.0, self.heights[1]]);
        let mut quads = [room([4.0, 3.5, 3.0]), low, high].concat();
        if self.slit == 0.0 {
            quads.retain(|(name, _)| name != "low-side-1" && name != "high-side-3");
            let ([a, b], [c, d], [low, high]) = (place(0.0, half), place(0.0, -half), self.heights);
            quads.push(quad("step", [[a, b, low], [c, d, low], [c, d, high], [a, b, high]]));
        }
        quads
    }
}

fn boxes(width: f64, lengths: [f64; 2], heights: [f64; 2], slit: f64, angle: f64, at: [f64; 2]) -> Boxes {
    Boxes { width, lengths, heights, slit, angle, at }
}

/// Rooms whose rows were the farthest off while rules passed over shadows, and others beside them.
fn rooms() -> Vec<Boxes> {
    vec![
        boxes(0.562, [0.648, 0.939], [1.092, 1.163], 0.0224, 1.160, [2.130, 1.955]),
        boxes(0.345, [0.729, 0.468], [0.636, 1.132], 0.0137, 3.014, [2.387, 1.537]),
        boxes(0.389, [0.283, 0.517], [0.413, 0.563], 0.0084, 0.000, [1.722, 1.776]),
        boxes(0.489, [0.584, 0.534], [0.996, 1.059], 0.0326, 0.000, [1.510, 1.611]),
        boxes(0.742, [0.828, 0.616], [0.969, 1.170], 0.0, 6.263, [2.085, 1.816]),
        boxes(0.489, [0.584, 0.534], [0.996, 1.059], 0.0, 4.132, [1.738, 1.556]),
        boxes(0.290, [0.305, 0.678], [0.525, 0.603], 0.0, 2.916, [1.711, 1.501]),
    ]
}

/// A row adds up some ten blocks with errors of either sign.
#[test]
fn rooms_with_slits_and_steps_are_closed() {
    for (index, boxes) in rooms().iter().enumerate() {
        let found = closure(&factors(&boxes.in_room(), Shadows::Auto, 1e-3));
        assert!(found <= 1e-3, "room {index}: {found:e}");
    }
}

/// Light through a slit falls on a narrow strip, which few points pass by on two levels alike.
#[test]
fn exact_shadows_keep_what_shines_through_slits() {
    let rooms = [
        boxes(0.719, [0.761, 0.966], [0.411, 0.634], 0.079, 2.093, [2.334, 1.682]),
        boxes(0.307, [0.878, 0.811], [0.734, 1.142], 0.011, 0.0, [1.594, 1.42]),
        boxes(0.618, [0.845, 0.968], [0.792, 1.602], 0.042, 0.0, [2.417, 1.574]),
    ];
    for (index, boxes) in rooms.iter().enumerate() {
        let found = closure(&factors(&boxes.in_room(), Shadows::Exact, 1e-5));
        assert!(found <= 3e-5, "room {index}: {found:e}");
    }
}
