//! Surfaces that pass through others between two frames, and may be clear of them in both.
//!
//! Points of both surfaces of a pair are followed through the step, each on the chords of its path relative
//! to the other surface, which a ray along the chord meets or does not. Where a surface slides along another
//! one, or ends on it, nothing is passed through.

use radiosity_geom::{Aabb, DVec3, LOOSE, Ray};
use radiosity_scene::{Animation, Pose, Scene};

use crate::inspection::sheet::{Sheet, Sheets};

/// Chords of a step: of a turn by 40° from a frame to the next they are off by 4e-3 of the radius. Chosen.
const CHORDS: usize = 4;

/// Parts of a border between which its nearest place to a point is looked for, and how often what is left is
/// cut by a third: to 1e-8 of the border.
const PARTS: u32 = 16;
const THIRDS: usize = 40;

/// The pairs of sheets, by index, that pass through each other between a frame and the next one.
pub(super) fn leaps(scene: &Scene, rest: &Sheets, frame: usize) -> Vec<[usize; 2]> {
    let Some(animation) = &scene.animation else { return Vec::new() };
    let Some(step) = Step::of(animation, frame) else { return Vec::new() };
    let movers = movers(scene, animation);
    let boxes: Vec<Aabb> = rest.list.iter().map(|own| step.swept(movers[own.surface], &own.bounds)).collect();
    let mut found = Vec::new();
    for (index, own) in rest.list.iter().enumerate() {
        let Some(mover) = movers[own.surface] else { continue };
        for (other_index, other) in rest.list.iter().enumerate() {
            let other_mover = movers[other.surface];
            // Of two that move the first one is told.
            let is_told = other_mover.is_none_or(|other| other != mover && index < other_index);
            if !is_told || !boxes[index].overlaps(&boxes[other_index]) {
                continue;
            }
            let pair = [Some(mover), other_mover];
            if step.leads_through(own, other, pair) || step.leads_through(other, own, [pair[1], pair[0]]) {
                found.push([index, other_index]);
            }
        }
    }
    found
}

/// For each surface the index of its mover.
fn movers(scene: &Scene, animation: &Animation) -> Vec<Option<usize>> {
    let mut movers = vec![None; scene.surfaces.len()];
    for (index, mover) in animation.movers.iter().enumerate() {
        mover.surfaces.iter().for_each(|surface| movers[*surface] = Some(index));
    }
    movers
}

/// The poses of all movers at the ends of the chords from a frame to the next one.
struct Step(Vec<Vec<Pose>>);

impl Step {
    /// The step from a frame; None after the last one.
    fn of(animation: &Animation, frame: usize) -> Option<Self> {
        let poses = |k: usize| {
            let states = animation.states(frame as f64 + k as f64 / CHORDS as f64).ok()?;
            Some(states.into_iter().map(|state| state.pose).collect())
        };
        (0..=CHORDS).map(poses).collect::<Option<_>>().map(Self)
    }

    /// A box around all that a box meets.
    fn swept(&self, mover: Option<usize>, bounds: &Aabb) -> Aabb {
        match mover {
            None => *bounds,
            Some(mover) => {
                let corners = |poses: &Vec<Pose>| bounds.corners().map(|corner| poses[mover].point(corner));
                Aabb::around(self.0.iter().flat_map(corners))
            }
        }
    }

    /// Whether a point of a sheet passes through another one; with the movers of both.
    fn leads_through(&self, own: &Sheet, other: &Sheet, [mover, other_mover]: [Option<usize>; 2]) -> bool {
        let place = |poses: &Vec<Pose>, point: DVec3| {
            let point = mover.map_or(point, |mover| poses[mover].point(point));
            other_mover.map_or(point, |mover| poses[mover].point_back(point))
        };
        points(own).into_iter().any(|point| {
            let places: Vec<DVec3> = self.0.iter().map(|poses| place(poses, point)).collect();
            passes(&places, other)
        })
    }
}

/// Points of a sheet all over it, most of them on its borders.
fn points(sheet: &Sheet) -> Vec<DVec3> {
    let borders = sheet.patch().borders();
    let on_borders = borders.iter().flat_map(|border| [-1.0, -0.5, 0.0, 0.5].map(|w| border.point(w)));
    on_borders.chain(sheet.samples().into_iter().map(|plane| plane.point)).collect()
}

/// Whether a point of a sheet lies within `tolerance` of its border (scene length): what slides over it there
/// stands on that border, or ends at it.
fn is_on_border(sheet: &Sheet, point: DVec3, tolerance: f64) -> bool {
    let step = 2.0 / f64::from(PARTS);
    sheet.patch().borders().iter().any(|border| {
        let distance = |w: f64| border.point(w.clamp(-1.0, 1.0)).distance(point);
        let places = (0..=PARTS).map(|part| -1.0 + step * f64::from(part));
        let nearest = places.min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(0.0);
        let (mut low, mut high) = (nearest - step, nearest + step);
        for _ in 0..THIRDS {
            let [a, b] = [(2.0 * low + high) / 3.0, (low + 2.0 * high) / 3.0];
            if distance(a) < distance(b) { high = b } else { low = a }
        }
        distance(0.5 * (low + high)) <= tolerance
    })
}

/// Whether the chords between these places lead through the sheet: all of them together begin and end off it.
fn passes(places: &[DVec3], sheet: &Sheet) -> bool {
    let [start, end] = [places[0], places[places.len() - 1]];
    let tolerance = LOOSE * sheet.extent;
    places.windows(2).any(|ends| {
        let ray = Ray::segment(ends[0], ends[1]);
        if ray.direction.length() <= tolerance {
            return false;
        }
        let Some(hit) = sheet.shape.intersect(&ray) else { return false };
        if is_on_border(sheet, ray.at(hit.t), tolerance) {
            return false;
        }
        let normal = sheet.shape.jet(hit.u, hit.v).normal;
        let off = [start, end].map(|place| (place - ray.at(hit.t)).dot(normal));
        off.iter().all(|height| height.abs() > tolerance) && off[0] * off[1] < 0.0
    })
}
