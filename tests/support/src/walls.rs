//! The six walls of a closed box with a corner at the origin, seen from inside.

/// Parameters of the walls as parallelograms: at z = 0, at z = `z`, at x = 0 and `x`, at y = 0 and `y`.
pub fn walls([x, y, z]: [f64; 3]) -> [String; 6] {
    let face = |origin: [f64; 3], u: [f64; 3], v: [f64; 3]| {
        format!("parallelogram = {{ origin = {origin:?}, edge1 = {u:?}, edge2 = {v:?} }}\n")
    };
    let ([a, b, c], low) = ([[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]], [0.0; 3]);
    [face(low, a, b), face(c, b, a), face(low, b, c), face(a, c, b), face(low, c, a), face(b, a, c)]
}
