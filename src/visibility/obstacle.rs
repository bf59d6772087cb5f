//! A surface that may stand between others, and how it lies to itself.

use std::sync::{Arc, OnceLock};

use radiosity_geom::{DVec3, Jet, Rect, Surface};

use crate::visibility::bounding_ball::Ball;
use crate::visibility::silhouette_mesh::SilhouetteMesh;

/// A segment may touch surfaces within this part of its length at both ends.
pub(crate) const END: f64 = 1e-9;

/// Points in each parameter at which a curved surface is looked at.
const LOOKS: usize = 5;

/// Cosine between any two normals of a surface that is taken for flat when it may hide itself.
const ALIKE: f64 = 0.9999;

/// A surface with what is asked of it time and again.
#[derive(Debug)]
pub(super) struct Obstacle {
    pub(super) shape: Arc<dyn Surface>,
    pub(super) hull: Vec<DVec3>,
    /// Around the hull.
    pub(super) ball: Ball,
    /// Convex pieces of a planar obstacle. One that is a single piece can hide a pair by itself.
    pub(super) pieces: Option<Vec<Vec<DVec3>>>,
    /// How it lies to itself.
    pub(super) bend: Bend,
    /// Places and normals of a curved one, here and there.
    pub(super) looks: Vec<(DVec3, DVec3)>,
    /// Made when it is first asked for.
    pub(super) net: OnceLock<SilhouetteMesh>,
}

impl Obstacle {
    pub(super) fn new(shape: &Arc<dyn Surface>) -> Self {
        let hull = shape.region().map_or_else(|| shape.hull(&Rect::FULL), |region| region.outer().to_vec());
        let pieces = shape.region().map(|region| region.convex_pieces().to_vec());
        let jets = if pieces.is_some() { Vec::new() } else { looks(shape.as_ref()) };
        let bend = Bend::of(&jets);
        let looks = jets.iter().map(|jet| (jet.position, jet.normal)).collect();
        let (shape, ball) = (Arc::clone(shape), Ball::around(&hull));
        Self { shape, ball, hull, pieces, bend, looks, net: OnceLock::new() }
    }

    /// Whether it is a single flat convex piece.
    pub(super) fn is_convex(&self) -> bool {
        self.pieces.as_ref().is_some_and(|pieces| pieces.len() == 1)
    }

    /// Whether its normals differ by more than a trifle.
    pub(super) fn is_bent(&self) -> bool {
        self.looks.iter().any(|(_, normal)| normal.dot(self.looks[0].1) < ALIKE)
    }
}

/// A net of points of a surface.
fn looks(shape: &dyn Surface) -> Vec<Jet> {
    let at = |k: usize| 2.0 * k as f64 / (LOOKS - 1) as f64 - 1.0;
    (0..LOOKS * LOOKS).map(|k| shape.jet(at(k / LOOKS), at(k % LOOKS))).collect()
}

/// How a surface lies to the tangent planes of its points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bend {
    /// Behind each of them, or much the same plane everywhere: it hides nothing of itself from any point.
    Outward,
    /// Before each of them, as the inside of a ball: its points see each other.
    Inward,
    /// Neither.
    Mixed,
}

impl Bend {
    /// Judged by a net of points, none of a planar one.
    fn of(jets: &[Jet]) -> Self {
        let size = jets.iter().map(|y| y.position.distance(jets[0].position)).fold(0.0, f64::max);
        let all = |holds: &dyn Fn(&Jet, &Jet) -> bool| jets.iter().all(|x| jets.iter().all(|y| holds(x, y)));
        let height = |x: &Jet, y: &Jet| (y.position - x.position).dot(x.normal);
        if all(&|x, y| height(x, y) <= END * size) || all(&|x, y| y.normal.dot(x.normal) >= ALIKE) {
            return Bend::Outward;
        }
        if all(&|x, y| height(x, y) >= -END * size) { Bend::Inward } else { Bend::Mixed }
    }
}
