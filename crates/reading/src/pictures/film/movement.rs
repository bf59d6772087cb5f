//! Movement in some frames of a film: which surfaces move by how much, and whether anything does.

use std::collections::HashMap;

use radiosity_elements::Elements;
use radiosity_geom::{Aabb, DVec3, Rect};
use radiosity_scene::{Animation, MoverState, Scene};

use super::span::{POINTS, Span};

/// Most step of a surface between two frames in which light is known, over its distance from a place, for which that
/// light may be interpolated. Chosen: the light of what passes changes over about as long a way as it is far.
const STEP: f64 = 0.5;

/// Parameters of a surface's points that are followed.
const FOLLOWED: [f64; 3] = [-1.0, 0.0, 1.0];

/// Movement in some frames that follow each other.
pub(super) struct Movement {
    /// Whether anything moves or shines otherwise between each frame and the next.
    moves: Vec<bool>,
    /// Mover of each surface that moves.
    movers: HashMap<usize, usize>,
    paths: Vec<SurfacePath>,
    /// Whether the scene's camera moves.
    moves_camera: bool,
}

/// The way of a surface through all frames.
struct SurfacePath {
    mover: usize,
    boxes: Vec<Aabb>,
    points: Vec<[DVec3; FOLLOWED.len() * FOLLOWED.len()]>,
}

impl Movement {
    /// The movement of a scene in the frames of these numbers, whose surfaces are these.
    pub(super) fn of(scene: &Scene, numbers: &[usize], frames: &[&Elements]) -> Self {
        let animation = scene.animation.as_ref();
        let states = |number: &usize| -> Vec<MoverState> {
            let states = |animation: &Animation| animation.states(*number as f64);
            animation.map(|own| states(own).expect("films show frames of their scenes")).unwrap_or_default()
        };
        let states: Vec<Vec<MoverState>> = numbers.iter().map(states).collect();
        let moves = states.windows(2).map(|pair| pair[0] != pair[1]).collect();
        let is_moving = |mover: usize| states.iter().any(|own| own[mover].pose != states[0][mover].pose);
        let mut movers = HashMap::new();
        let count = animation.map_or(0, |animation| animation.movers.len());
        for mover in (0..count).filter(|mover| is_moving(*mover)) {
            movers.extend(surfaces(animation, mover).map(|surface| (surface, mover)));
        }
        let is_camera = |mover: usize| animation.is_some_and(|animation| animation.movers[mover].camera);
        let moves_camera = (0..count).any(|mover| is_moving(mover) && is_camera(mover));
        let path = |(surface, mover): (&usize, &usize)| SurfacePath::of(*surface, *mover, frames);
        Self { moves, paths: movers.iter().map(path).collect(), movers, moves_camera }
    }

    /// Whether something moves in all steps of a span, or in none.
    pub(super) fn is_even(&self, span: Span) -> bool {
        let mut steps = self.moves[span.first..span.last].iter();
        let first = steps.next();
        steps.all(|moves| Some(moves) == first)
    }

    /// Whether a surface rests, and so does the camera.
    pub(super) fn is_seen_at_rest(&self, surface: usize) -> bool {
        !self.moves_camera && !self.movers.contains_key(&surface)
    }

    /// Whether surfaces pass a place of another surface, which lies at `at` in these frames of a span, in small steps.
    pub(super) fn passes(
        &self,
        surface: usize,
        at: [DVec3; POINTS],
        span: Span,
        points: [usize; POINTS],
    ) -> bool {
        let own = self.movers.get(&surface);
        self.paths.iter().filter(|path| Some(&path.mover) != own).all(|path| {
            let step = points.windows(2).map(|pair| path.step([pair[0], pair[1]])).fold(0.0, f64::max);
            let distance = at.iter().map(|at| path.distance(span, *at)).fold(f64::INFINITY, f64::min);
            step <= STEP * distance
        })
    }
}

/// The surfaces of a mover.
fn surfaces(animation: Option<&Animation>, mover: usize) -> impl Iterator<Item = usize> + use<'_> {
    animation.into_iter().flat_map(move |animation| animation.movers[mover].surfaces.iter().copied())
}

impl SurfacePath {
    fn of(surface: usize, mover: usize, frames: &[&Elements]) -> Self {
        let shapes = || frames.iter().map(|elements| elements.shape(surface));
        let at = |k: usize| [k % FOLLOWED.len(), k / FOLLOWED.len()].map(|axis| FOLLOWED[axis]);
        let points = shapes().map(|shape| {
            std::array::from_fn(|k| {
                let [u, v] = at(k);
                shape.jet(u, v).position
            })
        });
        Self {
            mover,
            boxes: shapes().map(|shape| shape.bounds(&Rect::FULL)).collect(),
            points: points.collect(),
        }
    }

    /// The longest way of a point from one frame to another (scene length).
    fn step(&self, [from, to]: [usize; 2]) -> f64 {
        let pairs = self.points[from].iter().zip(&self.points[to]);
        pairs.map(|(from, to)| from.distance(*to)).fold(0.0, f64::max)
    }

    /// Distance of a place from the boxes of the surface in the frames of a span (scene length).
    fn distance(&self, span: Span, at: DVec3) -> f64 {
        let of_box = |own: &Aabb| at.distance(at.clamp(own.min, own.max));
        self.boxes[span.first..=span.last].iter().map(of_box).fold(f64::INFINITY, f64::min)
    }
}
