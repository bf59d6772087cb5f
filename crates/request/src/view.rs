//! Views of a scene: that of its own camera, one that was asked for, or one that is chosen.

mod chosen_view;

use std::str::FromStr;

use radiosity_geom::DVec3;
use radiosity_scene::{Camera, Fault, Scene};
use radiosity_work::digits::short;

use super::ranges::{AngleOfView, Number};
use chosen_view::chosen_view;

/// A point or direction, `x,y,z`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Triple(DVec3);

impl FromStr for Triple {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers = text.split(',').map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite()));
        let numbers: Option<Vec<f64>> = numbers.collect();
        let triple: Option<[f64; 3]> = numbers.and_then(|numbers| numbers.try_into().ok());
        triple
            .map(|triple| Self(DVec3::from_array(triple)))
            .ok_or("expected three numbers with commas between, such as 2.5,-3,1.6")
    }
}

/// A view of a scene, in the coordinates of its file. What it leaves out is as the scene's camera says, or else
/// as it is chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "clap", derive(clap::Args), command(next_help_heading = "View"))]
pub struct ViewRequest {
    /// Point from which the picture is taken [default: as the scene's camera says; without one, and without
    /// these options, a view is chosen and told: from a corner of a room, from outside of other things]
    #[cfg_attr(feature = "clap", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub eye: Option<Triple>,

    /// Point in the middle of the picture
    #[cfg_attr(feature = "clap", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub target: Option<Triple>,

    /// Direction that is up in the picture [default: 0,0,1 without a camera]
    #[cfg_attr(feature = "clap", arg(long, value_name = "X,Y,Z", allow_hyphen_values = true))]
    pub view_up: Option<Triple>,

    /// Vertical angle of view in degrees
    #[cfg_attr(feature = "clap", arg(long, value_name = "DEGREES"))]
    pub fov: Option<Number<AngleOfView>>,
}

/// A view of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct View {
    /// Its camera, in the coordinates of the scene's surfaces.
    pub camera: Camera,
    /// Words on it, where it was chosen.
    pub told: Option<String>,
}

impl View {
    /// The view of the scene's camera, or else one that is chosen.
    pub fn usual(scene: &Scene) -> Self {
        Self::upright(scene, DVec3::Z)
    }

    /// The view of the scene's camera, or else one that is chosen, in which this direction is up.
    fn upright(scene: &Scene, up: DVec3) -> Self {
        match &scene.camera {
            Some(camera) => Self { camera: camera.clone(), told: None },
            None => Self::chosen(chosen_view(scene, up), scene),
        }
    }

    /// A view that nothing but its scene has decided on.
    fn chosen(camera: Camera, scene: &Scene) -> Self {
        let words = |vector: DVec3| vector.to_array().map(short).join(",");
        let [eye, target] = [camera.eye, camera.target].map(|point| words(point + scene.middle));
        let up =
            if camera.up == DVec3::Z { String::new() } else { format!(", view-up {}", words(camera.up)) };
        let fov = short(camera.fov);
        let told = format!("no camera in the scene: seen from eye {eye} to target {target}{up}, fov {fov}");
        Self { camera, told: Some(told) }
    }
}

impl ViewRequest {
    /// The view of a scene.
    ///
    /// # Errors
    /// An eye and a target, or a direction up, between which there is no view.
    pub fn of(&self, scene: &Scene) -> Result<View, Fault> {
        let Self { eye, target, view_up, fov } = *self;
        let usual = View::upright(scene, view_up.map_or(DVec3::Z, |Triple(direction)| direction));
        if *self == Self::default() {
            return Ok(usual);
        }
        let own = &usual.camera;
        let place = |typed: Option<Triple>, own| typed.map_or(own, |Triple(x)| x - scene.middle);
        let camera = Camera {
            eye: place(eye, own.eye),
            target: place(target, own.target),
            up: view_up.map_or(own.up, |Triple(direction)| direction),
            fov: fov.map_or(own.fov, f64::from),
            ..*own
        };
        let camera = camera.checked()?;
        let is_given = scene.camera.is_some() || (eye.is_some() && target.is_some());
        Ok(if is_given { View { camera, told: None } } else { View::chosen(camera, scene) })
    }

    /// The view where one was asked for, or where the scene has no camera of its own, which may move.
    ///
    /// # Errors
    /// As [`Self::of`].
    pub fn beside_own(&self, scene: &Scene) -> Result<Option<View>, Fault> {
        let is_own = scene.camera.is_some() && *self == Self::default();
        if is_own { Ok(None) } else { self.of(scene).map(Some) }
    }
}
