//! Surfaces of every shape, with their areas where a closed form is known, for the conformance suite.

use radiosity_geom::shapes::{
    Bezier, Bilinear, Cone, Cylinder, Disk, Extrusion, FULL_TURN, Parallelogram, Polygon, Rational,
    Revolution, Sphere, SpherePatch, Torus, Triangle, Trimmed,
};
use radiosity_geom::{DVec3, Flipped, Motion, Placed, Surface};
use std::f64::consts::PI;

/// A surface on show.
pub struct Exhibit {
    /// Name of the surface in messages.
    pub name: &'static str,
    /// The surface itself.
    pub surface: Box<dyn Surface>,
    /// Area (length²), by a formula of its own, not the crate's; None where no closed form is known.
    pub area: Option<f64>,
    /// A point the whole front faces away from, for shapes that curve around one.
    pub inside: Option<DVec3>,
}

fn show(name: &'static str, surface: impl Surface + 'static, area: f64) -> Exhibit {
    Exhibit { name, surface: Box::new(surface), area: Some(area), inside: None }
}

fn around(inside: DVec3, exhibit: Exhibit) -> Exhibit {
    Exhibit { inside: Some(inside), ..exhibit }
}

/// Every shape at least once.
pub fn gallery() -> Vec<Exhibit> {
    let mut all = flat();
    all.extend(turned());
    all.extend(curved());
    all.extend(modified());
    all
}

fn flat() -> Vec<Exhibit> {
    let (e, f) = (DVec3::new(2.0, 0.5, 0.1), DVec3::new(-0.3, 1.0, 0.7));
    let l_shape = || {
        [[0.0, 0.0], [2.0, 0.3], [1.8, 1.0], [1.0, 0.9], [0.9, 2.0], [-0.1, 1.9]]
            .map(|[x, y]| DVec3::new(x, y, 3.0 - x))
    };
    let hole = || [[0.2, 0.3], [0.7, 0.3], [0.5, 0.8]].map(|[x, y]| DVec3::new(x, y, 3.0 - x)).to_vec();
    // Areas over the plane z = 3 − x are √2 times those of the shadows on z = 0 (shoelace).
    let shadow = 0.5 * (0.0 + (2.0 - 0.54) + (1.62 - 1.0) + (2.0 - 0.81) + (1.71 + 0.2) + 0.0);
    let quad = [[0.0, 0.0], [2.0, 0.0], [1.5, 1.0], [0.0, 1.2]].map(|[x, y]| DVec3::new(x, y, 0.5 * y));
    vec![
        show("parallelogram", Parallelogram::new(DVec3::ONE, e, f).unwrap(), e.cross(f).length()),
        show(
            "triangle",
            Triangle::new([DVec3::ONE, DVec3::ONE + e, DVec3::ONE + f]).unwrap(),
            0.5 * e.cross(f).length(),
        ),
        show("polygon", Polygon::new(l_shape().to_vec(), vec![]).unwrap(), 2.0_f64.sqrt() * shadow),
        show(
            "polygon with a hole",
            Polygon::new(l_shape().to_vec(), vec![hole()]).unwrap(),
            2.0_f64.sqrt() * (shadow - 0.125),
        ),
        show(
            "planar quad",
            Bilinear::new(quad).unwrap(),
            0.5 * (1.5 + 1.2 * 1.5 + 0.5) * 1.25_f64.sqrt() - 0.0,
        ),
    ]
}

fn turned() -> Vec<Exhibit> {
    let (c, axis) = (DVec3::new(0.4, -0.2, 1.0), DVec3::new(1.0, 2.0, 2.0));
    let middle = c + 0.5 * axis;
    let below = c - 20.0 * axis;
    let some = [0.3, 2.4];
    vec![
        around(below, show("disk", Disk::new(c, axis, 1.5, 0.0, FULL_TURN).unwrap(), PI * 2.25)),
        around(below, show("ring sector", Disk::new(c, axis, 1.5, 0.5, some).unwrap(), 0.5 * 2.1 * 2.0)),
        around(
            middle,
            show("cylinder", Cylinder::new(c, axis, 0.8, FULL_TURN).unwrap(), 2.0 * PI * 0.8 * 3.0),
        ),
        around(middle, show("cylinder strip", Cylinder::new(c, axis, 0.8, some).unwrap(), 2.1 * 0.8 * 3.0)),
        around(
            middle,
            show("cone", Cone::new(c, axis, 1.2, 0.0, FULL_TURN).unwrap(), PI * 1.2 * 10.44_f64.sqrt()),
        ),
        around(
            middle,
            show(
                "frustum strip",
                Cone::new(c, axis, 0.5, 1.3, some).unwrap(),
                0.5 * 2.1 * 1.8 * 9.64_f64.sqrt(),
            ),
        ),
        around(
            c,
            show("sphere", Sphere::new(c, 1.1, axis, [-1.1, 1.1], FULL_TURN).unwrap(), 4.0 * PI * 1.21),
        ),
        around(
            c,
            show("sphere zone", Sphere::new(c, 1.1, axis, [-0.3, 1.0], some).unwrap(), 2.1 * 1.1 * 1.3),
        ),
        around(c, show("sphere patch", SpherePatch::cube(c, 1.1).unwrap()[3].clone(), 4.0 * PI * 1.21 / 6.0)),
        show(
            "torus",
            Torus::new(c, axis, 1.3, 0.4, FULL_TURN, FULL_TURN).unwrap(),
            4.0 * PI * PI * 1.3 * 0.4,
        ),
        show(
            "torus part",
            Torus::new(c, axis, 1.3, 0.4, some, [-1.0, 2.0]).unwrap(),
            2.1 * 0.4 * (1.3 * 3.0 + 0.4 * (2.0_f64.sin() + 1.0_f64.sin())),
        ),
    ]
}

fn curved() -> Vec<Exhibit> {
    let saddle = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]].map(|[x, y]| DVec3::new(x, y, x * y));
    // ∬ √(1 + x² + y²) over the unit square, four times.
    let saddle_area = 4.0 * (3.0_f64.sqrt() / 3.0 + 4.0 / 3.0 * 0.5_f64.sqrt().asinh() - PI / 18.0);
    let arch = parabola().map(|[x, y]| DVec3::new(x, y, 0.2 * x));
    let slide = DVec3::new(-0.2, 0.0, 1.0);
    let bowl = parabola().map(|[x, y]| DVec3::new(x, 0.0, y));
    vec![
        show("bilinear saddle", Bilinear::new(saddle).unwrap(), saddle_area),
        Exhibit { area: None, ..show("bézier wave", Bezier::new(wave()).unwrap(), 0.0) },
        show("bézier cone", Bezier::new(tent()).unwrap(), 0.5 * 3.0_f64.sqrt()),
        around(DVec3::ZERO, show("rational sphere octant", octant(), 0.5 * PI)),
        // The direction is perpendicular to (1, 0, 0.2): the curve seen along it is stretched by √1.04 along
        // x.
        show(
            "extrusion",
            Extrusion::new(arch, slide).unwrap(),
            1.04_f64.sqrt() * parabola_length(1.04_f64.sqrt()),
        ),
        // The paraboloid z = x², x ≤ 1: 2π ∫ x √(1 + 4x²) dx.
        show(
            "revolution",
            Revolution::new(bowl, DVec3::ZERO, DVec3::Z, FULL_TURN).unwrap(),
            PI / 6.0 * (5.0_f64.powf(1.5) - 1.0),
        ),
        Exhibit { area: None, ..show("vase", vase(), 0.0) },
    ]
}

fn modified() -> Vec<Exhibit> {
    let motion = Motion::new(DVec3::new(0.5, -2.0, 1.0), DVec3::new(1.0, -1.0, 0.3), 2.0, 1.7).unwrap();
    let octant = || Box::new(octant());
    let wall = || Box::new(Parallelogram::new(DVec3::ZERO, 2.0 * DVec3::X, DVec3::Y + DVec3::Z).unwrap());
    let window =
        || vec![[[0.3, 0.2], [0.9, 0.2], [0.9, 0.6], [0.3, 0.6]].map(|[x, y]| DVec3::new(x, y, y)).to_vec()];
    let trimmed = || Trimmed::new(wall(), window()).unwrap();
    let area = 2.0_f64.sqrt() * (2.0 - 0.24);
    vec![
        show("trimmed", trimmed(), area),
        show("placed octant", Placed::new(octant(), motion), 0.5 * PI * 1.7 * 1.7),
        show("placed trimmed", Placed::new(Box::new(trimmed()), motion), area * 1.7 * 1.7),
        show("flipped octant", Flipped::new(octant()), 0.5 * PI),
        show("flipped trimmed", Flipped::new(Box::new(trimmed())), area),
    ]
}

/// y = x² for 0 ≤ x ≤ 1 as a cubic Bézier curve.
fn parabola() -> [[f64; 2]; 4] {
    [[0.0, 0.0], [1.0 / 3.0, 0.0], [2.0 / 3.0, 1.0 / 3.0], [1.0, 1.0]]
}

/// Length of y = x², 0 ≤ x ≤ 1, with x stretched by k: ∫ √(k² + 4x²) dx.
fn parabola_length(k: f64) -> f64 {
    let end = (k * k + 4.0).sqrt();
    0.5 * end + 0.25 * k * k * (2.0 / k).asinh()
}

/// A bumpy sheet.
fn wave() -> [[DVec3; 4]; 4] {
    let height =
        [[0.0, 0.4, -0.6, 0.3], [0.8, -0.5, 0.2, 0.0], [-0.3, 0.9, 0.4, -0.7], [0.1, 0.0, -0.2, 0.5]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| DVec3::new(i as f64 / 3.0, j as f64 / 3.0 + 0.1 * height[j][i], height[i][j]))
    })
}

/// The triangle between the axes' unit points, its first edge collapsed to the top.
fn tent() -> [[DVec3; 4]; 4] {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| DVec3::Z.lerp(DVec3::X.lerp(DVec3::Y, j as f64 / 3.0), i as f64 / 3.0))
    })
}

/// A cubic vase with a waist that ends on the axis.
fn vase() -> Revolution {
    let curve = [[0.0, -1.0], [1.4, -0.9], [-0.1, 0.4], [0.6, 1.0]].map(|[x, z]| DVec3::new(x, 0.0, z));
    Revolution::new(curve, DVec3::ZERO, DVec3::Z, [-1.0, 4.0]).unwrap()
}

/// The part x, y, z ≥ 0 of the unit sphere as a rational bicubic patch, the pole a collapsed edge: quarter
/// circles of degree two with weights 1, √½, 1, raised to degree three, turned about each other.
pub fn octant() -> Rational {
    let w = 0.5_f64.sqrt();
    // Homogeneous (x, y, weight) of the quarter circle, degree raised.
    let arc = [
        [1.0, 0.0, 1.0],
        [(1.0 + 2.0 * w) / 3.0, 2.0 * w / 3.0, (1.0 + 2.0 * w) / 3.0],
        [2.0 * w / 3.0, (1.0 + 2.0 * w) / 3.0, (1.0 + 2.0 * w) / 3.0],
        [0.0, 1.0, 1.0],
    ];
    let weights = std::array::from_fn(|i| std::array::from_fn(|j| arc[i][2] * arc[j][2]));
    let point =
        |i: usize, j: usize| DVec3::new(arc[i][0] * arc[j][0], arc[i][1] * arc[j][0], arc[i][2] * arc[j][1]);
    let points = std::array::from_fn(|i| std::array::from_fn(|j| point(i, j) / (arc[i][2] * arc[j][2])));
    Rational::new(points, weights).unwrap()
}
