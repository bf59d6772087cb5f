//! Scenes: surfaces with their materials, luminaires, skies, movers, a camera and planes of sensors.
//!
//! A [`Scene`] is made by a [`SceneBuilder`], or by the crate `language` from a text, and is valid by
//! construction: every number finite, every reflectance below 1, every surface with an area and a front, no
//! two surfaces in one another, every name given once. A fault is a [`SceneError`] with name, cure, and,
//! where there is a text, line and column.
//!
//! In order: faults with their causes, cures and places; patterns, materials, luminaires, skies; poses, paths and
//! animations; surfaces as drafts and as fitted; the [`Source`] that a scene was read from; the builder; what
//! is made of a scene: other heat (`heat_setting`), other factors (`group_factors`), other materials (`with_material`),
//! another moment (`still_scene`, `frame_scenes`).
//!
//! Imports `core`, `geom`, `work`, `fit` and `photometry`.

mod imported;
pub mod place;
pub mod fault;
pub mod error;
pub mod ranges;
pub mod pattern;
pub mod material;
mod named_material;
pub mod names;
pub mod bands;
pub mod unit;
mod sensor_plane;
mod camera;
mod pose;
mod time_function;
mod path;
mod emission_track;
mod mover_state;
pub mod animation;
mod light_group;
pub mod member_names;
pub mod mover_draft;
pub mod masked_pair;
mod distribution;
mod extent;
pub mod luminaire;
pub mod sky;
mod glass;
mod outlook;
mod luminous_area;
mod radiance;
pub mod thermal;
mod surface;
pub mod covering;
pub mod surface_draft;
pub mod luminous_surface;
pub mod tree;
mod numbering;
mod print;
mod source;
mod fitted;
pub mod surfaces;
mod builder;
mod heat_setting;
mod group_factors;
mod with_material;
mod still_scene;
mod frame_scenes;
pub mod backs;

use radiosity_geom::DVec3;
use radiosity_work::wording::{Wording, command, option, set, words};

pub use animation::{Animation, Clock, Mover};
pub use builder::SceneBuilder;
pub use camera::Camera;
pub use distribution::Distribution;
pub use emission_track::EmissionTrack;
pub use error::SceneError;
pub use extent::Extent;
pub use fault::{Fault, FaultKind};
pub use fitted::{Fitted, LiesOn};
pub use frame_scenes::FrameScenes;
pub use glass::Glass;
pub use heat_setting::HeatSetting;
pub use imported::Imported;
pub use light_group::LightGroup;
pub use luminaire::{Luminaire, Strength};
pub use luminous_area::LuminousArea;
pub use masked_pair::{MaskedPair, MaskedPairDraft};
pub use material::Material;
pub use mover_draft::MoverDraft;
pub use mover_state::MoverState;
pub use named_material::NamedMaterial;
pub use outlook::{Opening, Outlook};
pub use path::{AxisAngle, RigidPath, Turn};
pub use pattern::{Pattern, PictureFile, Placement, Polynomial, Term, Wrap};
pub use place::{Line, Place};
pub use pose::Pose;
pub use print::Notation;
pub use radiance::Radiance;
pub use ranges::{MAX_ORDER, MAX_PARTS};
pub use sensor_plane::SensorPlane;
pub use sky::{Sky, SkyModel, Sun};
pub use source::Source;
pub use surface::SceneSurface;
pub use surface_draft::SurfaceDraft;
pub use thermal::{BackCondition, Condition, Thermal};
pub use time_function::{Curve, Interpolable, TimeFunction};
pub use tree::Tree;

use error::{Located, title};

/// A valid scene.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Scene {
    /// The name given in code, the built-in name, or the file's name without folder and ending; `stdin` for
    /// standard input.
    pub name: String,
    /// The title the file gives.
    pub title: Option<String>,
    /// Names of the bands, at least one.
    pub bands: Vec<String>,
    /// Unit of exitance, irradiance and radiosity, `W/m²` unless the file says another; printed, never
    /// computed with.
    pub unit: String,
    /// The vector (scene length) subtracted from all coordinates of surfaces, luminaires, paths and camera:
    /// zero except for scenes far from the origin.
    pub middle: DVec3,
    /// Changes to the shapes, made to fit them together.
    pub fitted: Fitted,
    /// Names of materials that no surface has.
    pub unused_materials: Vec<String>,
    /// The surfaces in the order they are given; the back of a two-sided one follows its front.
    pub surfaces: Vec<SceneSurface>,
    /// The luminaires in the order they are given.
    pub luminaires: Vec<Luminaire>,
    /// The camera, if one is given.
    pub camera: Option<Camera>,
    /// Movers and number of frames, if anything moves; the other fields hold the scene at rest.
    pub animation: Option<Animation>,
    /// Variables of the text, each with its value, in the order of the text.
    pub variables: Vec<(String, f64)>,
    /// Planes of sensors, in the coordinates that the scene was given in.
    pub planes: Vec<SensorPlane>,
    /// Pairs of surfaces chosen for shadow masks, where light is masked.
    pub masks: Vec<MaskedPair>,
    /// The name shown in messages: a path, `<stdin>`, or the name of a scene that is built in or made in
    /// code.
    pub origin: String,
    /// The text or the tree that the scene was read from; none for a scene that a [`SceneBuilder`] made.
    pub source: Option<Source>,
}

/// Stands for a name that messages do not show.
const HIDDEN: &str = "…";

impl Scene {
    /// A scene without parts, whose `middle` is zero.
    pub fn empty(name: String, bands: Vec<String>, unit: String) -> Self {
        Self {
            origin: name.clone(),
            name,
            bands,
            unit,
            title: None,
            middle: DVec3::ZERO,
            fitted: Fitted::default(),
            unused_materials: Vec::new(),
            surfaces: Vec::new(),
            luminaires: Vec::new(),
            camera: None,
            animation: None,
            variables: Vec::new(),
            planes: Vec::new(),
            masks: Vec::new(),
            source: None,
        }
    }

    /// Record of the import from a file of another program; none for other scenes.
    pub fn imported(&self) -> Option<&Imported> {
        self.source.as_ref()?.imported.as_deref()
    }

    /// Name of a surface in messages: an ellipsis where it stands in files outside the folder of the scene.
    pub fn shown_name(&self, surface: usize) -> &str {
        let name = self.surfaces[surface].name.as_str();
        let may_be_shown = self.source.as_ref().is_none_or(|source| source.may_list(name));
        if may_be_shown { name } else { HIDDEN }
    }

    /// The error for what is asked of the scene and does not fit it.
    pub(crate) fn error(&self, located: Located) -> SceneError {
        let listed = |fault| match &self.source {
            Some(source) => source.listing(fault),
            None => fault,
        };
        Located { fault: listed(located.fault), ..located }.in_code(&self.origin)
    }

    /// The index of the surface of that name.
    ///
    /// # Errors
    /// [`FaultKind::UnknownName`]; the cure lists the names there are.
    pub fn surface_named(&self, name: &str) -> Result<usize, SceneError> {
        let unknown = || {
            let known = self.surfaces.iter().map(|surface| surface.name.clone()).collect();
            self.error(Located::nowhere(Fault::unknown_surface(name, known)))
        };
        self.surfaces.iter().position(|surface| surface.name == name).ok_or_else(unknown)
    }

    /// The plane of sensors of that name.
    ///
    /// # Errors
    /// [`FaultKind::UnknownName`]; the cure lists the names there are.
    pub fn plane_named(&self, name: &str) -> Result<&SensorPlane, SceneError> {
        let unknown = || self.error(Located::nowhere(self.unknown_plane(name)));
        self.planes.iter().find(|plane| plane.name() == name).ok_or_else(unknown)
    }

    /// The index of the band of that name.
    ///
    /// # Errors
    /// [`FaultKind::UnknownName`]; the cure lists the names there are.
    pub fn band_named(&self, name: &str) -> Result<usize, SceneError> {
        let unknown = || {
            let cause = format!("there is no band {name:?}");
            let fault = Fault::unknown_name(cause, name, self.bands.clone(), "bands of this scene");
            self.error(Located::nowhere(fault))
        };
        self.bands.iter().position(|band| band == name).ok_or_else(unknown)
    }

    fn unknown_plane(&self, name: &str) -> Fault {
        let known: Vec<String> = self.planes.iter().map(|plane| plane.name().to_owned()).collect();
        let none = words(format!("define it: [planes.{name}] with origin, edges and spacing; or type it: "))
            + set("plane", "\"origin; edge; edge; spacing\"");
        Fault::unknown_or(format!("unknown plane {name:?}"), name, known, "planes of this scene", none)
    }

    /// Whether a surface or a luminaire of the scene emits light; of a frame, whether any does in the scene
    /// that moves.
    pub fn emits(&self) -> bool {
        self.surfaces.iter().any(SceneSurface::is_source) || self.luminaires.iter().any(Luminaire::is_source)
    }

    /// Checks what only light needs: a material on every surface, and something that emits.
    ///
    /// # Errors
    /// [`FaultKind::MissingKey`] for a surface without material, [`FaultKind::Absent`] if there cannot be any,
    /// and if nothing emits.
    pub fn require_light(&self) -> Result<(), SceneError> {
        let refused = |fault| Err(SceneError::of(&self.origin, fault));
        if self.source.as_ref().is_some_and(Source::is_polygon_list) {
            let cure =
                " need none; for light write a TOML scene, where each surface has a shape and a material";
            return refused(Fault::absent(
                "a list of polygons carries no materials",
                needing_no_light() + cure,
            ));
        }
        if self.imported().is_some() && self.surfaces.iter().all(|surface| surface.material_name.is_none()) {
            let cure = needing_no_light()
                + " need none; for light give them in a file, "
                + set("materials", "materials.toml")
                + ", such as [materials.\"*\"] with reflectance = 0.5";
            return refused(Fault::absent("the file gives its surfaces no materials", cure));
        }
        if let Some(bare) = self.surfaces.iter().find(|surface| surface.material_name.is_none()) {
            return Err(SceneError {
                origin: self.origin.clone(),
                place: bare.place.clone().map(Box::new),
                owner: Some(title("surface", &bare.name)),
                fault: Fault::missing_key("material", ", the name of one of [materials.…]"),
            });
        }
        match self.emits() {
            true => Ok(()),
            false => refused(no_emitter()),
        }
    }
}

/// The commands that compute no light.
fn needing_no_light() -> Wording {
    command("view-factors") + " and " + command("check")
}

fn no_emitter() -> Fault {
    let cure = words(
        "give a material an emission above 0, e.g. emission = 10, and use it on a surface, or add ",
    ) + "[[luminaires]], or a [sky] and a window with opening = true; for a file of another program, in a file for "
        + option("materials")
        + "; "
        + command("heat")
        + " takes temperatures instead";
    Fault::absent("nothing emits light", cure)
}
