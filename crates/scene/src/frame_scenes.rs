//! Still scenes of frames and moments.
//!
//! Shapes are fitted together once, at rest, and then moved: each frame starts from rest, so nothing drifts.
//! Where a moved flat sheet comes into the plane of another one, it is set apart from it, as at rest; what
//! did not move stays where it is. So a surface that does not move, or whose pose is that of rest, is the
//! same to the bit in every frame; there are as many surfaces in each, in the same order, with the same names
//! and parameters. Of scenes made one after the other ([`FrameScenes`]), surfaces that are where they were in
//! the one before are the same ones in memory, too.

use std::sync::Arc;

use radiosity_fit::{
    coincident::Occupied,
    gap,
    stacked::{Sheet, Step, steps},
};
use radiosity_geom::{Aabb, COINCIDENT, DQuat, Motion, Placed, Rect, Surface};

use crate::{
    Scene,
    animation::Animation,
    camera::Camera,
    error::{SceneError, title},
    fault::{Fault, FaultKind, shown},
    fitted::LiesOn,
    pose::Pose,
    radiance::Radiance,
    source::Source,
    surface::SceneSurface,
};

/// The still scenes of a scene that moves, one after the other, in any order.
#[derive(Debug)]
pub struct FrameScenes<'a> {
    scene: &'a Scene,
    /// The surfaces of the still scene that was made last.
    before: Vec<PlacedShape>,
}

/// A surface of a still scene.
#[derive(Debug)]
struct PlacedShape {
    placement: Placement,
    shape: Arc<dyn Surface>,
}

/// Motions that a surface was moved by from rest, as bits: by its mover, and off another sheet.
type Placement = Vec<[u64; 13]>;

impl<'a> FrameScenes<'a> {
    /// The still scenes of `scene`, of which none is made yet.
    pub fn of(scene: &'a Scene) -> Self {
        Self { scene, before: Vec::new() }
    }

    /// The scene with its motions.
    pub fn scene(&self) -> &'a Scene {
        self.scene
    }

    /// The still scene at a moment, equal to that of [`Scene::at_moment`] to the bit.
    ///
    /// # Errors
    /// As [`Scene::at_moment`].
    pub fn at(&mut self, moment: f64) -> Result<Scene, SceneError> {
        let (mut still, placements) = self.scene.placed_at(moment)?;
        let shapes = still.surfaces.iter_mut().map(|surface| &mut surface.shape);
        for ((shape, placement), before) in shapes.zip(&placements).zip(&self.before) {
            if *placement == before.placement {
                *shape = Arc::clone(&before.shape);
            }
        }
        let placed = |(placement, surface): (Placement, &SceneSurface)| PlacedShape {
            placement,
            shape: Arc::clone(&surface.shape),
        };
        self.before = placements.into_iter().zip(&still.surfaces).map(placed).collect();
        Ok(still)
    }
}

impl Scene {
    /// Number of frames; 0 of a scene without motions.
    pub fn frames(&self) -> usize {
        self.animation.as_ref().map_or(0, |animation| animation.frames)
    }

    /// The still scene of frame `frame`, counted from 0.
    ///
    /// # Errors
    /// As [`Scene::at_moment`].
    pub fn at_frame(&self, frame: usize) -> Result<Self, SceneError> {
        self.at_moment(frame as f64)
    }

    /// The still scene at a moment, a real number of frames from 0 to the last one. It is called `room-12`,
    /// and its [`Scene::animation`] is none.
    ///
    /// # Errors
    /// [`FaultKind::Absent`] for a scene without motions, [`FaultKind::OutOfRange`] for a frame there is not and
    /// for a surface too far away, [`FaultKind::Coincident`] where a surface that moves lies in another one.
    pub fn at_moment(&self, moment: f64) -> Result<Self, SceneError> {
        Ok(self.placed_at(moment)?.0)
    }

    /// The still scene at a moment, with the motions that each surface was moved by.
    fn placed_at(&self, moment: f64) -> Result<(Self, Vec<Placement>), SceneError> {
        let (animation, poses) = self.posed(moment)?;
        let movers = self.moved_by(animation, &poses);
        let mut still = Self { animation: None, ..self.clone() };
        still.name = format!("{}-{moment}", self.name);
        still.source = still.source.map(|source| source.at(moment));
        let mut placements: Vec<Placement> = vec![Vec::new(); movers.len()];
        let moved = movers.iter().enumerate().filter_map(|(index, mover)| Some((index, poses[(*mover)?])));
        for (index, pose) in moved {
            let surface = &mut still.surfaces[index];
            put(surface, pose.motion());
            placements[index].push(pose.motion().bits());
            turn_radiance(surface, &pose);
        }
        for (index, off) in still.set_apart(&movers) {
            placements[index].push(off.bits());
        }
        for (mover, pose) in animation.movers.iter().zip(&poses).filter(|(_, pose)| !pose.is_rest()) {
            for index in &mover.luminaires {
                let own = &mut still.luminaires[*index];
                *own = own.clone().moved(pose.motion());
            }
            if mover.camera {
                still.camera = still.camera.map(|camera| seen_from(camera, pose));
            }
        }
        still.check_clear(&movers, moment)?;
        Ok((still, placements))
    }

    /// The still scene at the moment that the source states, or this scene if it states none.
    pub fn at_moment_of(self, source: &Source) -> Result<Self, SceneError> {
        match source.moment {
            Some(moment) => self.at_moment(moment),
            None => Ok(self),
        }
    }

    /// For each surface the index of the mover that has moved it from rest at frame `frame`; None if it is at
    /// rest.
    ///
    /// # Errors
    /// [`FaultKind::Absent`] for a scene without motions, [`FaultKind::OutOfRange`] for a frame there is not.
    pub fn movers_at(&self, frame: usize) -> Result<Vec<Option<usize>>, SceneError> {
        let (animation, poses) = self.posed(frame as f64)?;
        Ok(self.moved_by(animation, &poses))
    }

    /// The animation, and the poses of its movers at a moment.
    fn posed(&self, moment: f64) -> Result<(&Animation, Vec<Pose>), SceneError> {
        let error = |fault| SceneError::of(&self.origin, fault);
        let animation = self.animation.as_ref().ok_or_else(|| error(no_frames()))?;
        Ok((animation, animation.poses(moment).map_err(error)?))
    }

    /// For each surface the index of its mover, if that is not at rest.
    fn moved_by(&self, animation: &Animation, poses: &[Pose]) -> Vec<Option<usize>> {
        let mut movers = vec![None; self.surfaces.len()];
        let moving = animation.movers.iter().enumerate().filter(|(index, _)| !poses[*index].is_rest());
        for (index, mover) in moving {
            mover.surfaces.iter().for_each(|surface| movers[*surface] = Some(index));
        }
        movers
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
        for Step { sheet, on, by } in steps(&sheets) {
            let off = Motion::rigid(DQuat::IDENTITY, by);
            let front = fronts[sheet];
            let sides = if self.has_back(front) { front..front + 2 } else { front..front + 1 };
            for side in sides {
                put(&mut self.surfaces[side], &off);
                moved.push((side, off));
            }
            let name = |sheet: usize| sheets[sheet].name.clone();
            self.fitted.lying.push(LiesOn { surface: name(sheet), on: name(on) });
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
        next.is_some_and(|next| next.name.strip_suffix(":back") == Some(name.as_str()))
    }

    fn is_flat_front(&self, index: usize) -> bool {
        let is_back = index > 0 && self.has_back(index - 1);
        !is_back && self.surfaces[index].shape.region().is_some()
    }

    /// Refuses a moved surface that lies in one that is not moved along, or that is far away.
    fn check_clear(&self, movers: &[Option<usize>], moment: f64) -> Result<(), SceneError> {
        let occupied: Vec<Occupied> =
            self.surfaces.iter().map(|surface| Occupied::new(&surface.shape)).collect();
        for own in (0..movers.len()).filter(|index| movers[*index].is_some()) {
            let bounds = self.surfaces[own].shape.bounds(&Rect::FULL);
            let distance = bounds.min.abs().max(bounds.max.abs()).max_element();
            if distance * f64::EPSILON > COINCIDENT * bounds.diagonal() {
                return Err(self.refused(own, moves_away(distance, moment)));
            }
            let mut others = (0..movers.len()).filter(|other| movers[*other] != movers[own]);
            if let Some(other) = others.find(|other| occupied[own].coincides(&occupied[*other])) {
                return Err(self.refused(own, moves_into(&self.surfaces[other].name, moment)));
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

fn no_frames() -> Fault {
    let cure = "leave the frame out, or add frames = 50 and [[motion]] to the scene";
    Fault::absent("a frame is asked for, yet nothing moves in the scene", cure)
}

fn moves_away(distance: f64, moment: f64) -> Fault {
    let moment = shown(moment);
    let cause = format!("in frame {moment} it is {distance:.1e} away from the origin, too far for its size");
    let cure = "keep the path near the scene: beyond four million times its size a shape has too few digits";
    Fault::new(FaultKind::OutOfRange, cause, cure)
}

fn moves_into(other: &str, moment: f64) -> Fault {
    let cause = format!("in frame {} it coincides with surface {other:?}", shown(moment));
    let cure = format!(
        "lead the path a millionth of its size or more past {other:?}, or start and end it elsewhere"
    );
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
fn may_lie(sheets: &[Sheet], LiesOn { surface, on }: &LiesOn) -> bool {
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
