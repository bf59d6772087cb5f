//! The light in a report: figures, pictures and plans, ready to be set.

use radiosity_scene::SensorPlane;
use radiosity_solve::Options;

use crate::drawings::picture::Picture;
use radiosity_reading::quality::ReadSettings;
use radiosity_reading::report::Report;
use radiosity_reading::surface_light::SurfaceLight;
use radiosity_reading::uniformity::Uniformity;

/// The name of the figure of the camera's picture.
pub const PICTURE: &str = "picture";

/// The name of the figure of a plane, counted from 0.
pub fn plan_name(plane: usize) -> String {
    format!("plane-{}", plane + 1)
}

/// The light of a scene as it was read.
#[derive(Clone, Debug)]
pub struct LightPart<'a> {
    /// Counts and self-checks, with the figures of the planes.
    pub report: &'a Report,
    /// Options by which the light was solved.
    pub options: &'a Options,
    /// Way in which the light of planes and surfaces was read.
    pub reading: ReadSettings,
    /// Picture of the scene's camera, if there is one.
    pub picture: Option<Picture>,
    /// The planes, in the order of the report's.
    pub plans: Vec<ReportedPlane<'a>>,
    /// Cells along u and v of each surface; none where cells are of one size.
    pub cells: Option<[usize; 2]>,
    /// The light of the surfaces.
    pub surfaces: Vec<SurfaceLight>,
}

/// A plane with its plan.
#[derive(Clone, Debug)]
pub struct ReportedPlane<'a> {
    /// The plane.
    pub plane: &'a SensorPlane,
    /// The figures of what the plan shows: of the only band, of the one chosen, or of the mean of all.
    pub shown: Uniformity,
    /// Name of the band or of the mean, where there are several bands.
    pub band: Option<String>,
    /// The plan.
    pub picture: Picture,
}
