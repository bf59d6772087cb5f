//! Light gathered beside edges and corners that walls share, against closed forms and graded sums of them.
//!
//! The ceiling of a unit cube shines, the other walls reflect. The ceiling then receives
//!
//! ```text
//! E(x) = ∫ κ(x, y) ρ D(y) dA_y ,
//! ```
//!
//! D from the factors of a rectangle seen from a point before one of its corners (Howell's catalogue, B-3
//! parallel and B-4 perpendicular). Near the edges of the ceiling the walls beside them fill half the view,
//! and in their corners D depends on the direction to the corner alone, however near it is.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use radiosity::light::receiver_point::ReceiverPoint;
use radiosity::scene::{Scene, SceneBuilder};
use radiosity::solve::gather::Gather;
use radiosity::visibility::{Shadows, Visibility};
use radiosity_geom::DVec3;
use radiosity_test_support::given::even;
use radiosity_test_support::scenes::material;
use radiosity_test_support::shapes::plate;

const REFLECTANCE: f64 = 0.5;
/// A wall is summed by cells that are narrower than this part of their distance. Chosen: by 3 × 3 Gauss
/// points they are right to 1e-6.
const NARROW: f64 = 0.3;

/// Ceiling, floor and walls, fronts inside, the ceiling first.
fn room() -> Scene {
    let mut room = SceneBuilder::new("room", ["grey"]);
    let shining = room.material("shining", material(0.0, 1.0));
    let wall = room.material("wall", material(REFLECTANCE, 0.0));
    let [o, x, y, z] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let sides = [[z, y, x], [o, x, y], [o, z, x], [y, x, z], [o, y, z], [x, z, y]];
    for (index, [origin, a, b]) in sides.into_iter().enumerate() {
        let material = if index == 0 { &shining } else { &wall };
        let shape = Arc::new(plate(origin, a, b));
        room.surface(format!("side {index}"), shape, material);
    }
    room.build().unwrap()
}

/// The factor of a rectangle a × b from a point at the distance c before its corner, parallel to it (B-3).
fn parallel(a: f64, b: f64, c: f64) -> f64 {
    let part = |a: f64, b: f64| {
        let root = (1.0 + a * a).sqrt();
        a / root * (b / root).atan()
    };
    let (a, b) = (a / c, b / c);
    (part(a, b) + part(b, a)) / TAU
}

/// The factor of a rectangle that reaches a from the plane of the point and is b wide, at the distance c
/// (B-4).
fn perpendicular(a: f64, b: f64, c: f64) -> f64 {
    let root = c.hypot(a);
    ((b / c).atan() - c / root * (b / root).atan()) / TAU
}

/// D at a point of a wall, so far below the ceiling and so far along the wall.
fn on_wall(depth: f64, along: f64) -> f64 {
    perpendicular(1.0, along, depth) + perpendicular(1.0, 1.0 - along, depth)
}

/// D at a point of the floor.
fn on_floor(x: f64, y: f64) -> f64 {
    [x, 1.0 - x].iter().flat_map(|a| [y, 1.0 - y].map(|b| parallel(*a, b, 1.0))).sum()
}

/// The points of a unit square.
type Chart<'a> = &'a dyn Fn(f64, f64) -> DVec3;

/// ∫ κ D over a unit square of points `place(a, b)`, graded toward the receiver at `x` with the normal `n`.
struct Graded<'a> {
    x: DVec3,
    n: DVec3,
    place: Chart<'a>,
    normal: DVec3,
    light: &'a dyn Fn(f64, f64) -> f64,
}

impl Graded<'_> {
    fn sum(&self, [a, b]: [f64; 2], width: f64) -> f64 {
        let distance = ((self.place)(a + 0.5 * width, b + 0.5 * width) - self.x).length();
        let is_wide = width > NARROW * (distance - 0.71 * width);
        // At the corners that the walls share with the ceiling D has no Taylor series.
        let is_corner = a == 0.0 && (b == 0.0 || b + width == 1.0);
        if width > 1e-5 && (is_wide || is_corner) {
            let half = 0.5 * width;
            let quarters = [[a, b], [a + half, b], [a, b + half], [a + half, b + half]];
            return quarters.into_iter().map(|corner| self.sum(corner, half)).sum();
        }
        let root = 0.6_f64.sqrt();
        let rule = [(0.5 - 0.5 * root, 5.0 / 18.0), (0.5, 8.0 / 18.0), (0.5 + 0.5 * root, 5.0 / 18.0)];
        let mut sum = 0.0;
        for (s, ws) in rule {
            for (t, wt) in rule {
                let (a, b) = (a + width * s, b + width * t);
                let way = (self.place)(a, b) - self.x;
                let cosines = way.dot(self.n) * -way.dot(self.normal);
                let kernel = (cosines / (PI * way.length_squared().powi(2))).max(0.0);
                sum += ws * wt * width * width * kernel * (self.light)(a, b);
            }
        }
        sum
    }
}

/// Irradiance E of the ceiling at (x, y) (W m⁻²).
fn expected(x: f64, y: f64) -> f64 {
    let receiver = DVec3::new(x, y, 1.0);
    let sides: [(Chart<'_>, DVec3); 4] = [
        (&|a, b| DVec3::new(0.0, b, 1.0 - a), DVec3::X),
        (&|a, b| DVec3::new(1.0, b, 1.0 - a), DVec3::NEG_X),
        (&|a, b| DVec3::new(b, 0.0, 1.0 - a), DVec3::Y),
        (&|a, b| DVec3::new(b, 1.0, 1.0 - a), DVec3::NEG_Y),
    ];
    let graded = |place: Chart<'_>, normal: DVec3, light: &dyn Fn(f64, f64) -> f64| {
        Graded { x: receiver, n: DVec3::NEG_Z, place, normal, light }.sum([0.0, 0.0], 1.0)
    };
    let walls: f64 = sides.into_iter().map(|(place, normal)| graded(place, normal, &on_wall)).sum();
    REFLECTANCE * (walls + graded(&|a, b| DVec3::new(a, b, 0.0), DVec3::Z, &on_floor))
}

#[test]
fn light_beside_edges_is_right_to_the_accuracy_asked() {
    let scene = room();
    let solution = even(&scene, 2, 0.0, 0.0);
    let visibility = Visibility::new(&scene, Shadows::Rays, 1e-4);
    let places = [[1e-3, 0.4], [5e-3, 0.4], [0.02, 0.3], [0.1, 0.6], [1e-3, 1e-3], [0.01, 0.02], [0.5, 0.5]];
    let exact = places.map(|[x, y]| expected(x, y));
    for eps in [1e-3, 1e-4] {
        let gather = Gather::new(&solution, &visibility, eps);
        for ([x, y], exact) in places.into_iter().zip(exact) {
            let point = ReceiverPoint::on(0, DVec3::new(x, y, 1.0), DVec3::NEG_Z);
            let found = gather.at(&point)[0];
            assert!(
                (found / exact - 1.0).abs() <= 3.0 * eps,
                "{found} for {exact} at {x}, {y}, asked for {eps}"
            );
        }
    }
}
