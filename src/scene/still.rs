//! The still scene of a frame.
//!
//! Shapes are fitted together once, at rest, and then moved: each frame starts from rest, so nothing drifts. A surface that does
//! not move, or whose pose is that of rest, is the same to the bit in every frame; there are as many surfaces in each, in the same order, with
//! the same names and parameters.

use std::sync::Arc;

use radiosity_geom::{Placed, Surface};

use crate::scene::{
    Scene,
    animation::Animation,
    camera::Camera,
    coincident::Occupied,
    error::{Fault, SceneError, surface_title},
    pose::Pose,
    radiance::Radiance,
    source::Source,
    surface::SceneSurface,
};

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

    /// The still scene at a moment, a real number of frames from 0 to the last one: [`Scene::animation`] is none in it.
    ///
    /// # Errors
    /// [`Fault::NoFrames`] for a scene without motions, [`Fault::NoSuchFrame`], and [`Fault::MovesInto`] where a surface that
    /// moves lies in another one.
    pub fn at_moment(&self, moment: f64) -> Result<Self, SceneError> {
        let (animation, poses) = self.posed(moment)?;
        let movers = self.moved_by(animation, &poses);
        let mut still = Self { animation: None, ..self.clone() };
        still.source = still.source.map(|source| source.at(moment));
        for (surface, mover) in still.surfaces.iter_mut().zip(&movers) {
            if let Some(mover) = mover {
                put(surface, &poses[*mover]);
            }
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
        Ok(still)
    }

    /// The still scene that the source asks for, or this one.
    pub(super) fn at_moment_of(self, source: &Source) -> Result<Self, SceneError> {
        match source.moment {
            Some(moment) => self.at_moment(moment),
            None => Ok(self),
        }
    }

    /// For each surface the index of the mover that has moved it from rest at frame `frame`; None if it is at rest.
    ///
    /// # Errors
    /// [`Fault::NoFrames`], [`Fault::NoSuchFrame`].
    pub fn movers_at(&self, frame: usize) -> Result<Vec<Option<usize>>, SceneError> {
        let (animation, poses) = self.posed(frame as f64)?;
        Ok(self.moved_by(animation, &poses))
    }

    /// The animation, and the poses of its movers at a moment.
    fn posed(&self, moment: f64) -> Result<(&Animation, Vec<Pose>), SceneError> {
        let error = |fault| SceneError { origin: self.origin.clone(), place: None, owner: None, fault };
        let animation = self.animation.as_ref().ok_or_else(|| error(Fault::NoFrames))?;
        Ok((animation, animation.poses(moment).map_err(error)?))
    }

    /// The movers of all surfaces that are not at rest.
    fn moved_by(&self, animation: &Animation, poses: &[Pose]) -> Vec<Option<usize>> {
        let mut movers = vec![None; self.surfaces.len()];
        let moving = animation.movers.iter().enumerate().filter(|(index, _)| !poses[*index].is_rest());
        for (index, mover) in moving {
            mover.surfaces.iter().for_each(|surface| movers[*surface] = Some(index));
        }
        movers
    }

    /// Refuses a moved surface that lies in one that is not moved along.
    fn check_clear(&self, movers: &[Option<usize>], moment: f64) -> Result<(), SceneError> {
        let occupied: Vec<Occupied> =
            self.surfaces.iter().map(|surface| Occupied::new(&surface.shape)).collect();
        let moved = (0..movers.len()).filter(|index| movers[*index].is_some());
        for own in moved {
            let others = (0..movers.len()).filter(|other| movers[*other] != movers[own]);
            if let Some(other) = others.into_iter().find(|other| occupied[own].coincides(&occupied[*other])) {
                let surface = &self.surfaces[own];
                return Err(SceneError {
                    origin: self.origin.clone(),
                    place: surface.place.clone().map(Box::new),
                    owner: Some(surface_title(&surface.name)),
                    fault: Fault::MovesInto { other: self.surfaces[other].name.clone(), moment },
                });
            }
        }
        Ok(())
    }
}

/// Puts a surface into a pose. Its parameters and its front go with it.
fn put(surface: &mut SceneSurface, pose: &Pose) {
    let rest: Box<dyn Surface> = Box::new(Arc::clone(&surface.shape));
    surface.shape = Arc::new(Placed::new(rest, *pose.motion()));
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

/// The camera in a pose.
fn seen_from(camera: Camera, pose: &Pose) -> Camera {
    let Camera { eye, target, up, .. } = camera;
    Camera { eye: pose.point(eye), target: pose.point(target), up: pose.vector(up), ..camera }
}
