//! Rooms and boxes as lists of quadrilaterals.

/// The name and vertices of a quadrilateral.
pub(crate) type Quad = (String, [[f64; 3]; 4]);

pub(crate) fn quad(name: &str, vertices: [[f64; 3]; 4]) -> Quad {
    (name.to_owned(), vertices)
}

/// The rectangle x0..x1 × y0..y1 at height z, its front up or down.
pub(crate) fn level(name: &str, [x0, x1]: [f64; 2], [y0, y1]: [f64; 2], z: f64, up: bool) -> Quad {
    let mut vertices = [[x0, y0, z], [x1, y0, z], [x1, y1, z], [x0, y1, z]];
    if !up {
        vertices.reverse();
    }
    quad(name, vertices)
}

/// The six walls of a room, fronts inside.
pub(crate) fn room([a, b, c]: [f64; 3]) -> Vec<Quad> {
    vec![
        level("floor", [0.0, a], [0.0, b], 0.0, true),
        level("ceiling", [0.0, a], [0.0, b], c, false),
        quad("x0", [[0., 0., 0.], [0., b, 0.], [0., b, c], [0., 0., c]]),
        quad("x1", [[a, 0., 0.], [a, 0., c], [a, b, c], [a, b, 0.]]),
        quad("y0", [[0., 0., 0.], [0., 0., c], [a, 0., c], [a, 0., 0.]]),
        quad("y1", [[0., b, 0.], [a, b, 0.], [a, b, c], [0., b, c]]),
    ]
}

/// Sides, top and, where it hovers, bottom of an upright box over a counter-clockwise base, fronts outside.
pub(crate) fn upright(name: &str, base: [[f64; 2]; 4], [low, high]: [f64; 2]) -> Vec<Quad> {
    let at = |k: usize, z: f64| [base[k % 4][0], base[k % 4][1], z];
    let side = |k: usize| {
        quad(&format!("{name}-side-{k}"), [at(k, low), at(k + 1, low), at(k + 1, high), at(k, high)])
    };
    let top = quad(&format!("{name}-top"), [at(0, high), at(1, high), at(2, high), at(3, high)]);
    let bottom = (low > 0.0)
        .then(|| quad(&format!("{name}-bottom"), [at(3, low), at(2, low), at(1, low), at(0, low)]));
    (0..4).map(side).chain([top]).chain(bottom).collect()
}
