//! Goals of adaptation: the light of which an accuracy is wanted.

use std::str::FromStr;

use radiosity_geom::DVec3;
use radiosity_reading::pictures::pinhole::Pinhole;
use radiosity_reading::probe::Probe;
use radiosity_scene::{Camera, Scene};
use radiosity_solve::studies::adaptation::{Aim, Goal};
use radiosity_visibility::Visibility;
use radiosity_work::wording::{set, words};

use super::refusal::Refusal;

/// Forms that are accepted.
const FORM: &str = "expected gathered, solution, picture, points FILE or plane NAME";

/// Light of which an accuracy is wanted, as `--for` states it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum AccuracyOf {
    /// Light as sensors and pictures read it, on all surfaces.
    Gathered,
    /// The polynomials, as `--read basis` shows them.
    Solution,
    /// Light at the points of this file.
    Points(String),
    /// Light at the sensors of this plane.
    Plane(String),
    /// Light that the scene's camera sees.
    Picture,
}

impl FromStr for AccuracyOf {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some(("points", file)) if !file.is_empty() => Ok(Self::Points(file.to_owned())),
            Some(("plane", name)) if !name.is_empty() => Ok(Self::Plane(name.to_owned())),
            None if text == "gathered" => Ok(Self::Gathered),
            None if text == "solution" => Ok(Self::Solution),
            None if text == "picture" => Ok(Self::Picture),
            _ => Err(FORM.to_owned()),
        }
    }
}

impl AccuracyOf {
    /// The goal of this accuracy in a scene; `sensors` are those of the points or the plane.
    ///
    /// # Errors
    /// Errors of `sensors`; of a picture, a scene without a camera, or with one that sees no front.
    pub fn goal<E: From<Refusal>>(
        &self,
        accuracy: f64,
        scene: &Scene,
        sensors: impl FnOnce() -> Result<Vec<Probe>, E>,
    ) -> Result<Goal, E> {
        match self {
            Self::Gathered => Ok(Goal::new(accuracy, Aim::Gathered)),
            Self::Solution => Ok(Goal::new(accuracy, Aim::Solution)),
            Self::Points(_) | Self::Plane(_) => Ok(at_probes(accuracy, &sensors()?, scene)),
            Self::Picture => Ok(of_picture(accuracy, scene)?),
        }
    }
}

/// Points of a picture along each of its sides. Chosen: about as many as errors are estimated at.
const ACROSS: u32 = 16;

/// The goal of this accuracy at these sensors.
pub fn at_probes(accuracy: f64, probes: &[Probe], scene: &Scene) -> Goal {
    let at = |probe: &Probe| [probe.position - scene.middle, probe.normal];
    Goal::at(accuracy, probes.iter().map(at).collect())
}

/// The goal of this accuracy of what the scene's camera sees.
///
/// # Errors
/// A scene without a camera, or with one that sees no front.
fn of_picture(accuracy: f64, scene: &Scene) -> Result<Goal, Refusal> {
    let Some(camera) = &scene.camera else {
        return Err(Refusal::new(
            format!("{}: there is no camera, so nothing says what the picture shows", scene.origin),
            words("add [camera] with eye and target, or take ") + set("for", "gathered"),
        ));
    };
    match seen(scene, camera) {
        points if points.is_empty() => Err(Refusal::new(
            format!("{}: the camera sees no front of any surface", scene.origin),
            words("turn the camera, or take ") + set("for", "gathered"),
        )),
        points => Ok(Goal::seen(accuracy, points)),
    }
}

/// Points, with normals, of surfaces that a camera sees, evenly over its picture.
fn seen(scene: &Scene, camera: &Camera) -> Vec<[DVec3; 2]> {
    let visibility = Visibility::open(scene);
    let pinhole = Pinhole::new(camera);
    let place = |k: u32, size: u32| (f64::from(k) + 0.5) * f64::from(size) / f64::from(ACROSS);
    let rays = (0..ACROSS * ACROSS)
        .map(|k| pinhole.ray(place(k % ACROSS, camera.width), place(k / ACROSS, camera.height)));
    let point = |ray| {
        let met = visibility.nearest(&ray)?;
        let jet = scene.surfaces[met.surface].shape.jet(met.hit.u, met.hit.v);
        met.front.then_some([jet.position, jet.normal])
    };
    rays.filter_map(point).collect()
}
