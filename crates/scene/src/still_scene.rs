//! The still scene of given states of all movers.
//!
//! Shapes are fitted together once, at rest, and then moved: each still scene starts from rest, so nothing
//! drifts. Where a moved flat sheet comes into the plane of another one, it is set apart from it, as at rest;
//! what did not move stays where it is. So a surface that does not move, or whose pose is that of rest, is the
//! same to the bit in every still scene; there are as many surfaces in each, in the same order, with the same
//! names and parameters. So it is with light: what a state dims is multiplied by its factors, and what it does
//! not stays to the bit.

use radiosity_fit::sides::front_of;
use std::sync::Arc;

use radiosity_fit::{
    coincident::Occupied,
    gap,
    stacked::{Sheet, steps},
};
use radiosity_geom::{Aabb, COINCIDENT, DQuat, Motion, Placed, Rect, Surface};

use crate::{
    Scene,
    animation::{Animation, Mover},
    camera::Camera,
    error::{SceneError, title},
    fault::{Fault, FaultKind, shown},
    fitted::LiesOn,
    mover_state::MoverState,
    pose::Pose,
    radiance::Radiance,
    surface::SceneSurface,
};

/// Motions that a surface was moved by from rest, as bits: by its mover, and off another sheet.
pub(super) type Placement = Vec<[u64; 13]>;

/// A still scene, with the motions that each surface was moved by.
pub(super) struct StillScene {
    pub(super) scene: Scene,
    pub(super) placements: Vec<Placement>,
}

impl Scene {
    /// The still scene of the states of its movers, one for each. It has the name and the source of this one.
    ///
    /// # Errors
    /// As [`FrameScenes::placed`](crate::FrameScenes::placed); messages name the `frame` if the states are
    /// those of one.
    pub(super) fn placed(
        &self,
        animation: &Animation,
        states: &[MoverState],
        frame: Option<f64>,
    ) -> Result<StillScene, SceneError> {
        let movers = self.moved_by(animation, states);
        let mut still = Self { animation: None, ..self.clone() };
        let mut placements: Vec<Placement> = vec![Vec::new(); movers.len()];
        let moved =
            movers.iter().enumerate().filter_map(|(index, mover)| Some((index, states[(*mover)?].pose)));
        for (index, pose) in moved {
            let surface = &mut still.surfaces[index];
            put(surface, pose.motion());
            placements[index].push(pose.motion().bits());
            turn_radiance(surface, &pose);
        }
        for (index, off) in still.set_apart(&movers) {
            placements[index].push(off.bits());
        }
        for (mover, state) in animation.movers.iter().zip(states) {
            still.change(mover, state);
        }
        still.check_clear(&movers, frame)?;
        Ok(StillScene { scene: still, placements })
    }

    /// For each surface the index of its mover, if that is not at rest.
    pub(super) fn moved_by(&self, animation: &Animation, states: &[MoverState]) -> Vec<Option<usize>> {
        let mut movers = vec![None; self.surfaces.len()];
        let moving = animation.movers.iter().enumerate().filter(|(index, _)| !states[*index].pose.is_rest());
        for (index, mover) in moving {
            mover.surfaces.iter().for_each(|surface| movers[*surface] = Some(index));
        }
        movers
    }

    /// Moves the luminaires and the camera of a mover, and changes what it emits.
    fn change(&mut self, mover: &Mover, state: &MoverState) {
        let pose = &state.pose;
        if !pose.is_rest() {
            for index in &mover.luminaires {
                let own = &mut self.luminaires[*index];
                *own = own.clone().moved(pose.motion());
            }
            if mover.camera {
                self.camera = self.camera.take().map(|camera| seen_from(camera, pose));
            }
        }
        if state.is_dimmed() {
            mover.surfaces.iter().for_each(|index| self.surfaces[*index].dim(&state.factors));
            mover.luminaires.iter().for_each(|index| self.luminaires[*index].dim(&state.factors));
        }
    }

    /// Moves moved flat sheets off those in whose plane they lie; returns the surfaces moved, by index, and
    /// their motions.
    fn set_apart(&mut self, movers: &[Option<usize>]) -> Vec<(usize, Motion)> {
        let fronts: Vec<usize> =
            (0..self.surfaces.len()).filter(|index| self.is_flat_front(*index)).collect();
        let mut moved = Vec::new();
        if fronts.iter().all(|index| movers[*index].is_none()) {
            return moved;
        }
        let sheets: Vec<Sheet> = fronts.iter().map(|index| self.sheet(*index, movers)).collect();
        self.fitted.lying.retain(|own| may_lie(&sheets, own));
        for step in steps(&sheets) {
            let off = Motion::rigid(DQuat::IDENTITY, step.by);
            let front = fronts[step.sheet];
            let sides = if self.has_back(front) { front..front + 2 } else { front..front + 1 };
            for side in sides {
                put(&mut self.surfaces[side], &off);
                moved.push((side, off));
            }
            self.fitted.lying.push(LiesOn::of(&step, &sheets));
        }
        moved
    }

    fn sheet(&self, index: usize, movers: &[Option<usize>]) -> Sheet {
        let SceneSurface { name, shape, .. } = &self.surfaces[index];
        Sheet {
            shape: Arc::clone(shape),
            typed: Arc::clone(shape),
            two_sided: self.has_back(index),
            flip: false,
            stays: movers[index].is_none(),
            name: name.clone(),
        }
    }

    /// Whether the surface after this one is its back.
    fn has_back(&self, index: usize) -> bool {
        let name = &self.surfaces[index].name;
        let next = self.surfaces.get(index + 1);
        next.is_some_and(|next| front_of(&next.name) == Some(name.as_str()))
    }

    fn is_flat_front(&self, index: usize) -> bool {
        let is_back = index > 0 && self.has_back(index - 1);
        !is_back && self.surfaces[index].shape.region().is_some()
    }

    /// Refuses a moved surface that lies in one that is not moved along, or that is far away.
    fn check_clear(&self, movers: &[Option<usize>], frame: Option<f64>) -> Result<(), SceneError> {
        let occupied: Vec<Occupied> =
            self.surfaces.iter().map(|surface| Occupied::new(&surface.shape)).collect();
        for own in (0..movers.len()).filter(|index| movers[*index].is_some()) {
            let bounds = self.surfaces[own].shape.bounds(&Rect::FULL);
            let distance = bounds.min.abs().max(bounds.max.abs()).max_element();
            if distance * f64::EPSILON > COINCIDENT * bounds.diagonal() {
                return Err(self.refused(own, moves_away(distance, frame)));
            }
            let mut others = (0..movers.len()).filter(|other| movers[*other] != movers[own]);
            if let Some(other) = others.find(|other| occupied[own].coincides(&occupied[*other])) {
                return Err(self.refused(own, moves_into(&self.surfaces[other].name, frame)));
            }
        }
        Ok(())
    }

    /// A fault of a surface, at its place.
    fn refused(&self, surface: usize, fault: Fault) -> SceneError {
        let surface = &self.surfaces[surface];
        SceneError {
            origin: self.origin.clone(),
            place: surface.place.clone().map(Box::new),
            owner: Some(title("surface", &surface.name)),
            fault,
        }
    }
}

/// The beginning of a sentence on a frame, if it is about one.
fn in_frame(frame: Option<f64>) -> String {
    frame.map_or_else(String::new, |frame| format!("in frame {} ", shown(frame)))
}

fn moves_away(distance: f64, frame: Option<f64>) -> Fault {
    let when = in_frame(frame);
    let cause = format!("{when}it is {distance:.1e} away from the origin, too far for its size");
    let what = if frame.is_some() { "the path" } else { "the pose" };
    let cure =
        format!("keep {what} near the scene: beyond four million times its size a shape has too few digits");
    Fault::new(FaultKind::OutOfRange, cause, cure)
}

fn moves_into(other: &str, frame: Option<f64>) -> Fault {
    let cause = format!("{}it coincides with surface {other:?}", in_frame(frame));
    let cure = match frame {
        Some(_) => format!(
            "lead the path a millionth of its size or more past {other:?}, or start and end it elsewhere"
        ),
        None => format!("place it a millionth of its size or more away from {other:?}"),
    };
    Fault::new(FaultKind::Coincident, cause, cure)
}

/// Moves a surface. Its parameters and its front go with it.
fn put(surface: &mut SceneSurface, motion: &Motion) {
    let rest: Box<dyn Surface> = Box::new(Arc::clone(&surface.shape));
    surface.shape = Arc::new(Placed::new(rest, *motion));
}

/// Turns the outlook of an opening, or moves the luminous area of a luminaire, along with its surface.
fn turn_radiance(surface: &mut SceneSurface, pose: &Pose) {
    match &surface.radiance {
        None => {}
        Some(Radiance::Sky(outlook)) => {
            let turned = outlook.turned(|normal| pose.vector(normal));
            surface.material.emission = turned.exitance();
            surface.radiance = Some(Radiance::Sky(Arc::new(turned)));
        }
        Some(Radiance::Luminaire(area)) => {
            surface.radiance = Some(Radiance::Luminaire(Arc::new(area.moved(pose.motion()))));
        }
    }
}

/// Whether a sheet that lay on another one at rest is still as near as that.
fn may_lie(sheets: &[Sheet], LiesOn { surface, on, .. }: &LiesOn) -> bool {
    let found = |name: &String| sheets.iter().find(|sheet| sheet.name == *name);
    let bounds = |sheet: &Sheet, gap: f64| -> Aabb { sheet.shape.bounds(&Rect::FULL).inflate(gap) };
    match (found(surface), found(on)) {
        (Some(own), Some(on)) => {
            let gap = gap::closed(own.extent(), on.extent());
            bounds(own, gap).overlaps(&bounds(on, gap))
        }
        _ => false,
    }
}

/// The camera in a pose.
fn seen_from(camera: Camera, pose: &Pose) -> Camera {
    let Camera { eye, target, up, .. } = camera;
    Camera { eye: pose.point(eye), target: pose.point(target), up: pose.vector(up), ..camera }
}
