//! Random pairs of flat shapes: every kind, hinged, sliding, apart, parallel or anyhow, of all sizes.

use std::f64::consts::TAU;
use std::ops::Range;

use glam::DQuat;
use proptest::prelude::*;
use radiosity_geom::DVec3;

use crate::transport::flat::{Flat, Outline};

/// Two flat surfaces, with what they are asked for.
#[derive(Clone, Debug)]
pub(crate) struct Pair {
    pub(crate) sides: [Flat; 2],
    pub(crate) order: usize,
    pub(crate) eps: f64,
    /// Position of the second shape to the first before both are turned and scaled; for messages.
    #[expect(dead_code, reason = "shown by Debug")]
    pub(crate) pose: Pose,
}

/// Random pairs at orders below `orders`.
pub(crate) fn pairs(orders: Range<usize>) -> impl Strategy<Value = Pair> {
    let eps = prop::sample::select(vec![1e-2, 1e-4, 1e-6, 1e-8]);
    let settings = (orders, eps, powers(-6.0, 6.0), turn());
    (outline(), outline(), pose(), settings).prop_map(|(first, second, pose, (order, eps, scale, turn))| {
        let receiver = Flat::facing(first, DVec3::Z);
        let emitter = pose.place(second, first_extent(&receiver));
        let put = |p: DVec3| turn * p * scale;
        Pair { sides: [receiver, emitter].map(|flat| flat.map(put)), order, eps, pose }
    })
}

/// 10^x, x uniform.
fn powers(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|x| 10f64.powf(x))
}

/// A depth beside the unit width: 1 often, else down to 1e-3 and up to 1e3.
fn depth() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(1.0), 2 => powers(-0.7, 0.7), 1 => powers(-3.0, 3.0)]
}

/// A rotation; none half of the time, so that coordinates on the axes occur as well.
fn turn() -> impl Strategy<Value = DQuat> {
    let axis =
        (-1.0..1.0f64, -1.0..1.0f64, 0.1..1.0f64).prop_map(|(x, y, z)| DVec3::new(x, y, z).normalize());
    (axis, prop_oneof![Just(0.0), 0.0..TAU]).prop_map(|(axis, angle)| DQuat::from_axis_angle(axis, angle))
}

/// A shape in z = 0 with y ≥ 0 that has an edge on y = 0, about one wide.
fn outline() -> impl Strategy<Value = Outline> {
    let p = |x: f64, y: f64| DVec3::new(x, y, 0.0);
    let t = || 0.05..0.95f64;
    let shape = prop_oneof![
        Just(Outline::Parallelogram { origin: DVec3::ZERO, edges: [DVec3::X, DVec3::Y] }),
        (-2.0..2.0f64)
            .prop_map(move |x| Outline::Parallelogram { origin: DVec3::ZERO, edges: [DVec3::X, p(x, 1.0)] }),
        (-0.5..0.4f64, 0.3..1.0f64, 0.6..1.5f64, 0.3..1.0f64)
            .prop_map(move |(a, b, c, d)| [p(0., 0.), p(1., 0.), p(c, b), p(a, d)])
            .prop_filter_map("not convex", |corners| is_convex(&corners).then_some(Outline::Quad(corners))),
        (-2.0..3.0f64).prop_map(move |x| Outline::Triangle([p(0., 0.), p(1., 0.), p(x, 1.0)])),
        (t(), t()).prop_map(move |(x, y)| {
            let outer = vec![p(0., 0.), p(1., 0.), p(1., y), p(x, y), p(x, 1.), p(0., 1.)];
            Outline::Polygon { outer, holes: Vec::new() }
        }),
        (0.05..0.4f64, 0.6..0.95f64, 0.05..0.4f64, 0.6..0.95f64).prop_map(move |(a, b, c, d)| {
            let outer = vec![p(0., 0.), p(1., 0.), p(1., 1.), p(0., 1.)];
            Outline::Polygon { outer, holes: vec![vec![p(a, c), p(b, c), p(b, d), p(a, d)]] }
        }),
    ];
    (shape, depth()).prop_map(|(shape, depth)| shape.map(|p| DVec3::new(p.x, p.y * depth, p.z)))
}

/// Whether corners in z = 0 turn left all the way, by a twentieth at least.
fn is_convex(corners: &[DVec3; 4]) -> bool {
    let side = |k: usize| (corners[(k + 1) % 4] - corners[k % 4]).normalize();
    (0..4).all(|k| side(k).cross(side(k + 1)).z > 0.05)
}

/// Position of the second shape, given in z = 0, to the first.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Pose {
    /// Turned about the first one's edge, slid along it, and drawn off by a gap in a direction across it.
    Hinged { degrees: f64, slide: f64, gap: f64, direction: f64 },
    /// Above the first, facing it.
    Parallel { gap: f64, slide: [f64; 2], size: f64 },
    /// Turned anyhow, somewhere.
    Free { angles: [f64; 3], place: [f64; 3] },
}

impl Pose {
    fn place(self, outline: Outline, extent: f64) -> Flat {
        let extent = extent.max(first_extent(&Flat::new(outline.clone())));
        match self {
            Self::Hinged { degrees, slide, gap, direction } => {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let (up, out) = direction.to_radians().sin_cos();
                let shift = DVec3::new(slide, gap * extent * out, gap * extent * up);
                let outline = outline.map(|p| DVec3::new(p.x, p.y * cos, p.y * sin) + shift);
                Flat::facing(outline, DVec3::new(0.0, sin, -cos))
            }
            Self::Parallel { gap, slide, size } => {
                let shift = DVec3::new(slide[0], slide[1], gap * extent);
                Flat::facing(outline.map(|p| p * size + shift), -DVec3::Z)
            }
            Self::Free { angles: [a, b, c], place } => {
                let turned = |p: DVec3| {
                    let p = DVec3::new(p.x * a.cos() - p.y * a.sin(), p.x * a.sin() + p.y * a.cos(), p.z);
                    let p = DVec3::new(p.x, p.y * b.cos() - p.z * b.sin(), p.y * b.sin() + p.z * b.cos());
                    DVec3::new(p.x * c.cos() - p.y * c.sin(), p.x * c.sin() + p.y * c.cos(), p.z)
                };
                let shift = DVec3::from_array(place);
                Flat::facing(outline.map(|p| turned(p) + shift), turned(DVec3::Z))
            }
        }
    }
}

fn pose() -> impl Strategy<Value = Pose> {
    let degrees = prop_oneof![
        3 => prop::sample::select(vec![30.0, 45.0, 60.0, 90.0, 120.0, 150.0]),
        3 => 1.0..179.0f64,
        1 => 1.0..10.0f64,
        1 => 181.0..359.0f64
    ];
    let slide = || prop_oneof![3 => Just(0.0), 1 => Just(1.0), 3 => -1.5..1.5f64];
    let gap = prop_oneof![2 => Just(0.0), 2 => powers(-6.0, 6.0), 2 => powers(-2.0, 1.0)];
    let above = prop_oneof![1 => powers(-6.0, 6.0), 2 => powers(-2.0, 1.0)];
    let angle = || 0.0..TAU;
    let offset = || -3.0..3.0f64;
    prop_oneof![
        3 => (degrees, slide(), gap, 0.0..180.0f64)
            .prop_map(|(degrees, slide, gap, direction)| Pose::Hinged { degrees, slide, gap, direction }),
        1 => (above, slide(), slide(), prop_oneof![Just(1.0), 0.1..10.0f64])
            .prop_map(|(gap, x, y, size)| Pose::Parallel { gap, slide: [x, y], size }),
        1 => ([angle(), angle(), angle()], [offset(), offset(), offset()])
            .prop_map(|(angles, place)| Pose::Free { angles, place }),
    ]
}

fn first_extent(flat: &Flat) -> f64 {
    let outer = &flat.outline.loops()[0];
    outer.iter().map(|p| p.distance(outer[0])).fold(0.0, f64::max)
}
