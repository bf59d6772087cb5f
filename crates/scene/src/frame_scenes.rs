//! Still scenes of frames, of moments and of states that nobody knew in advance.
//!
//! Each is made from rest, whatever came before ([`still_scene`](crate::still_scene)). Of scenes made one after
//! the other ([`FrameScenes`]), surfaces that are where they were in the one before are the same ones in memory,
//! too.

use std::{borrow::Cow, sync::Arc};

use radiosity_geom::Surface;

use crate::{
    Scene,
    animation::{Animation, Mover},
    error::{SceneError, title},
    fault::Fault,
    mover_state::MoverState,
    source::Source,
    still_scene::{Placement, StillScene},
    surface::SceneSurface,
};

/// The still scenes of a scene that moves, one after the other, in any order.
#[derive(Debug)]
pub struct FrameScenes<'a> {
    scene: Cow<'a, Scene>,
    /// The surfaces of the still scene that was made last.
    before: Vec<PlacedShape>,
}

/// A surface of a still scene.
#[derive(Debug)]
struct PlacedShape {
    placement: Placement,
    shape: Arc<dyn Surface>,
}

impl FrameScenes<'static> {
    /// The still scenes of `scene`, which they keep.
    pub fn owned(scene: Scene) -> Self {
        Self { scene: Cow::Owned(scene), before: Vec::new() }
    }
}

impl<'a> FrameScenes<'a> {
    /// The still scenes of `scene`, of which none is made yet.
    pub fn of(scene: &'a Scene) -> Self {
        Self { scene: Cow::Borrowed(scene), before: Vec::new() }
    }

    /// The scene with its motions.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The still scene at a moment, equal to that of [`Scene::at_moment`] to the bit.
    ///
    /// # Errors
    /// As [`Scene::at_moment`].
    pub fn at(&mut self, moment: f64) -> Result<Scene, SceneError> {
        let still = self.scene.still_at(moment)?;
        Ok(self.remembered(still))
    }

    /// The still scene in which the movers have these states, one for each in the order of
    /// [`Animation::movers`], whatever their paths and times say. It has the name of the scene, and neither a
    /// [`Scene::source`] nor a [`Scene::animation`].
    ///
    /// # Errors
    /// [`FaultKind::Absent`](crate::FaultKind::Absent) for a scene without motions and for factors on what does
    /// not emit; [`FaultKind::WrongCount`](crate::FaultKind::WrongCount) of states, or of factors in one; a
    /// factor below 0 or not finite; [`FaultKind::OutOfRange`](crate::FaultKind::OutOfRange) for a surface too
    /// far away, [`FaultKind::Coincident`](crate::FaultKind::Coincident) where a surface that moves lies in
    /// another one.
    pub fn placed(&mut self, states: &[MoverState]) -> Result<Scene, SceneError> {
        let animation = self.scene.moving(no_movers)?;
        self.scene.check_states(animation, states)?;
        let mut still = self.scene.placed(animation, states, None)?;
        still.scene.source = None;
        Ok(self.remembered(still))
    }

    /// The still scene with the surfaces in memory that it shares with the one before; it is the one before
    /// from now on.
    fn remembered(&mut self, StillScene { mut scene, placements }: StillScene) -> Scene {
        let shapes = scene.surfaces.iter_mut().map(|surface| &mut surface.shape);
        for ((shape, placement), before) in shapes.zip(&placements).zip(&self.before) {
            if *placement == before.placement {
                *shape = Arc::clone(&before.shape);
            }
        }
        let placed = |(placement, surface): (Placement, &SceneSurface)| PlacedShape {
            placement,
            shape: Arc::clone(&surface.shape),
        };
        self.before = placements.into_iter().zip(&scene.surfaces).map(placed).collect();
        scene
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
    /// [`FaultKind::Absent`](crate::FaultKind::Absent) for a scene without motions,
    /// [`FaultKind::OutOfRange`](crate::FaultKind::OutOfRange) for a frame there is not and for a surface too
    /// far away, [`FaultKind::Coincident`](crate::FaultKind::Coincident) where a surface that moves lies in
    /// another one.
    pub fn at_moment(&self, moment: f64) -> Result<Self, SceneError> {
        Ok(self.still_at(moment)?.scene)
    }

    fn still_at(&self, moment: f64) -> Result<StillScene, SceneError> {
        let (animation, states) = self.states_at(moment)?;
        let mut still = self.placed(animation, &states, Some(moment))?;
        still.scene.name = format!("{}-{moment}", self.name);
        still.scene.source = still.scene.source.map(|source| source.at(moment));
        Ok(still)
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
    /// [`FaultKind::Absent`](crate::FaultKind::Absent) for a scene without motions,
    /// [`FaultKind::OutOfRange`](crate::FaultKind::OutOfRange) for a frame there is not.
    pub fn movers_at(&self, frame: usize) -> Result<Vec<Option<usize>>, SceneError> {
        let (animation, states) = self.states_at(frame as f64)?;
        Ok(self.moved_by(animation, &states))
    }

    /// The animation, and the states of its movers at a moment.
    fn states_at(&self, moment: f64) -> Result<(&Animation, Vec<MoverState>), SceneError> {
        let animation = self.moving(no_frames)?;
        let states = animation.states(moment);
        Ok((animation, states.map_err(|fault| SceneError::of(&self.origin, fault))?))
    }

    /// The animation; the fault that it is `absent` without one.
    fn moving(&self, absent: fn() -> Fault) -> Result<&Animation, SceneError> {
        self.animation.as_ref().ok_or_else(|| SceneError::of(&self.origin, absent()))
    }

    /// Refuses another number of states than of movers, and factors that cannot be, or that nothing takes.
    fn check_states(&self, animation: &Animation, states: &[MoverState]) -> Result<(), SceneError> {
        let movers = &animation.movers;
        if states.len() != movers.len() {
            let expected = format!("{}, one for each mover", movers.len());
            let fault = Fault::wrong_count("the list of states", &expected, states.len());
            return Err(SceneError::of(&self.origin, fault));
        }
        let check = |(mover, state): (&Mover, &MoverState)| {
            state.check(self.bands.len())?;
            match state.is_dimmed() && !self.shines(mover) {
                true => Err(takes_no_factors()),
                false => Ok(()),
            }
        };
        movers.iter().zip(states).try_for_each(|(mover, state)| {
            check((mover, state)).map_err(|fault| SceneError {
                place: mover.place.clone().map(Box::new),
                owner: Some(title("motion", &mover.name)),
                ..SceneError::of(&self.origin, fault)
            })
        })
    }

    /// Whether a mover has a surface or a luminaire that emits.
    fn shines(&self, mover: &Mover) -> bool {
        mover.surfaces.iter().any(|index| self.surfaces[*index].is_source())
            || mover.luminaires.iter().any(|index| self.luminaires[*index].is_source())
    }
}

fn no_frames() -> Fault {
    let cure = "leave the frame out, or add frames = 50 and [[motion]] to the scene";
    Fault::absent("a frame is asked for, yet nothing moves in the scene", cure)
}

fn no_movers() -> Fault {
    let cure = "add frames = 1 and a [[motion]] for each thing that is placed";
    Fault::absent("movers are placed, yet nothing moves in the scene", cure)
}

fn takes_no_factors() -> Fault {
    let cure = "leave its factors empty, or let a surface or a luminaire that emits move along";
    Fault::absent("nothing that moves with it emits light", cure)
}
