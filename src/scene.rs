//! Scenes: surfaces, their materials, and a camera.
//!
//! A [`Scene`] is read from TOML or JSON of one schema, from a [`Tree`] of that schema made in code, or made by a
//! [`SceneBuilder`], and is valid by construction: every number finite, every reflectance below 1, every surface with an area and a front, no two
//! surfaces in one another, every name given once. A fault is a [`SceneError`] with name, cure, line and column.

pub mod csv_rows;
mod coincident;
pub(crate) mod gap;
mod middle;
mod nearest;
mod imported;
mod place;
pub mod input;
mod error;
mod builtin;
mod cure;
mod ranges;
mod pattern;
mod material;
mod named_material;
mod names;
mod unit;
mod sensor_plane;
mod camera;
mod pose;
mod track;
mod path;
mod animation;
mod movement;
mod stacked;
mod light_group;
mod distribution;
mod extent;
mod luminaire;
mod sky;
mod glass;
mod outlook;
mod luminous_area;
mod radiance;
mod thermal;
mod surface;
mod covering;
mod draft;
mod luminous_surface;
mod tree;
mod numbering;
mod print;
mod source;
mod fields;
mod formula;
mod variables;
mod json_text;
mod polygon_list;
mod language;
mod toml_text;
mod include;
mod model_tree;
mod import;
mod shape;
mod file;
mod merging;
mod instances;
mod export;
mod weld;
mod fitted;
mod surfaces;
mod textures;
mod validation;
mod luminaires;
mod motions;
mod builder;
mod dimming;
mod painting;
mod still;
mod schema;

use std::{collections::BTreeSet, io, path::Path, sync::Arc};

use radiosity_formats::model::Model;
use radiosity_geom::DVec3;

pub use animation::{Animation, Clock, Mover};
pub use builder::SceneBuilder;
pub use builtin::{Builtin, Parameter};
pub use camera::Camera;
pub use distribution::Distribution;
pub use draft::SurfaceDraft;
pub use error::{Fault, SceneError};
pub use extent::Extent;
pub use fitted::{Fitted, Lying};
pub use glass::Glass;
pub use import::Import;
pub use imported::Imported;
pub use light_group::LightGroup;
pub use luminaire::{Luminaire, Strength};
pub use luminous_area::LuminousArea;
pub use material::Material;
pub use movement::MoverDraft;
pub use named_material::NamedMaterial;
pub use outlook::{Opening, Outlook};
pub use path::{RigidPath, Turn};
pub use pattern::{Pattern, PictureFile, Placement, Polynomial, Term, Wrap};
pub use place::{Line, Place};
pub use pose::Pose;
pub use print::Notation;
pub use radiance::Radiance;
pub use ranges::{MAX_ORDER, MAX_PARTS};
pub use schema::schema;
pub use sensor_plane::SensorPlane;
pub use sky::{Sky, SkyModel, Sun};
pub use source::Source;
pub use still::Stills;
pub use surface::SceneSurface;
pub use thermal::{Condition, Thermal};
pub use track::{Curve, Mixed, Track};
pub use tree::Tree;
pub use weld::Welded;

use error::{Located, surface_title};
use export::Export;
use file::SceneFile;
use include::FileTree;
use language::Language;
use merging::merged;
use surfaces::{Surfaces, fitted_surfaces};
use tree::{Node, Value, entry};
use variables::{VARIABLES, Variables};

/// A valid scene.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Scene {
    /// The name given in code, the built-in name, or the file's name without folder and ending; `stdin` for standard
    /// input.
    pub name: String,
    /// The title the file gives.
    pub title: Option<String>,
    /// Names of the bands, at least one.
    pub bands: Vec<String>,
    /// Unit of exitance, irradiance and radiosity, `W/m²` unless the file says another; printed, never computed with.
    pub unit: String,
    /// The vector subtracted from all coordinates, of surfaces and camera: zero except for scenes far from the origin.
    pub middle: DVec3,
    /// How the shapes were changed to fit together.
    pub fitted: Fitted,
    /// The surfaces in the order they are given; the back of a two-sided one follows its front.
    pub surfaces: Vec<SceneSurface>,
    /// The luminaires in the order they are given.
    pub luminaires: Vec<Luminaire>,
    /// The camera, if one is given.
    pub camera: Option<Camera>,
    /// What moves, and in how many frames, if anything does; the rest is as it is at rest.
    pub animation: Option<Animation>,
    /// Variables of the text with their values, in its order.
    pub variables: Vec<(String, f64)>,
    /// Planes of sensors, in the coordinates that the scene was given in.
    pub planes: Vec<SensorPlane>,
    /// The name shown in messages: a path, `<stdin>`, or the name of a scene that is built in or made in code.
    pub origin: String,
    /// What it was read from, a text or a tree; none for a scene that a [`SceneBuilder`] made.
    pub source: Option<Source>,
}

impl Scene {
    /// Loads a built-in scene by its name, standard input for `-`, or else the file at the path `source`.
    ///
    /// A file whose ending names a format of another program ([`Format`](radiosity_formats::format::Format)) is read in
    /// that and repaired. A file named `.json`, and any text that starts with `{`, is JSON; one named `.csv` is a list of
    /// polygons. Text of unknown name may also start as a list of polygons in JSON, `[[[`, or in CSV, `name,x,y,z`; everything
    /// else is TOML.
    ///
    /// # Errors
    /// A file that cannot be read, an unknown name, or anything wrong in the text.
    pub fn load(source: &str) -> Result<Scene, SceneError> {
        Scene::load_with(source, &[])
    }

    /// Loads a scene as [`Scene::load`] does, with parameters of a built-in one, or variables of any other, set by name.
    ///
    /// # Errors
    /// As for [`Scene::load`] and [`Scene::builtin_with`]; [`Fault::NoVariables`], [`Fault::UnknownVariable`].
    pub fn load_with(source: &str, settings: &[(&str, f64)]) -> Result<Scene, SceneError> {
        Scene::parse(&Scene::text_of(source, settings)?)
    }

    /// The text that [`Scene::load_with`] reads; files that it includes are read with the scene.
    ///
    /// # Errors
    /// A file that cannot be read, an unknown name of a scene or a parameter.
    pub fn text_of(source: &str, settings: &[(&str, f64)]) -> Result<Source, SceneError> {
        Scene::text_by(source, settings, &Import::default())
    }

    /// The same; `import` says how a file of another program is read.
    ///
    /// # Errors
    /// As [`Scene::text_of`], and what [`Import::model`] refuses.
    pub fn text_by(source: &str, settings: &[(&str, f64)], import: &Import) -> Result<Source, SceneError> {
        if let Some(scene) = builtin::named(source) {
            let text = scene.text(settings).map_err(|fault| whole_file(source, fault))?;
            return Ok(Source::new(source, &text));
        }
        if let Some(format) = import.format_of(source) {
            return Ok(import.source(source, format)?.set(settings.iter().copied()));
        }
        let (origin, text) = match source {
            "-" => ("<stdin>", input::text(source)),
            path => (path, input::text(path)),
        };
        let text = text.map_err(|error| unreadable(source, origin, &error))?;
        Ok(Source::new(origin, &text).with_files().set(settings.iter().copied()))
    }

    /// Reads a scene in the language given by the ending of its origin, or else by its beginning; see [`Scene::load`].
    ///
    /// # Errors
    /// The first fault in the text.
    pub fn parse(source: &Source) -> Result<Scene, SceneError> {
        read(source, Language::of(source))
    }

    /// Reads a scene as [`Scene::parse`] does, with settings of its variables and of its light groups by name; see
    /// [`Scene::dimmed`].
    ///
    /// # Errors
    /// The first fault in the text; [`Fault::UnknownSetting`], [`Fault::VariableAndGroup`] and what [`Scene::dimmed`]
    /// refuses.
    pub fn parse_with(source: &Source, settings: &[(&str, f64)]) -> Result<Scene, SceneError> {
        let mut source = source.clone();
        let language = Language::of(&source);
        let files = include::trees(&mut source, language);
        let files = files.map_err(|located| located.in_source(&source))?;
        let names: BTreeSet<&str> = variable_names(&files).collect();
        let (own, groups): (Vec<_>, Vec<_>) = settings.iter().partition(|(name, _)| names.contains(name));
        let source = source.set(own.iter().copied());
        let scene = built(files, &source).map_err(|located| located.in_source(&source))?;
        let scene = scene.at_moment_of(&source)?;
        let refused = |fault| Err(whole_file(&source.origin, fault));
        let known: Vec<String> = scene.light_groups().iter().map(|group| group.name.clone()).collect();
        let has = |name: &str| known.iter().any(|known| known == name);
        if let Some((name, _)) = own.iter().find(|(name, _)| has(name)) {
            return refused(Fault::VariableAndGroup { name: (*name).to_owned() });
        }
        match groups.iter().find(|(name, _)| !has(name)) {
            Some((name, _)) if !scene.variables.is_empty() => {
                let variables = scene.variables.iter().map(|(name, _)| name.clone()).collect();
                refused(Fault::UnknownSetting { name: (*name).to_owned(), variables, groups: known.into() })
            }
            _ => scene.dimmed(&groups),
        }
    }

    /// Reads TOML; `origin` is its name in messages.
    ///
    /// # Errors
    /// The first fault in the text.
    pub fn from_toml(text: &str, origin: &str) -> Result<Scene, SceneError> {
        read(&Source::new(origin, text), Language::Toml)
    }

    /// Reads JSON: the same tree as the TOML, or a list of polygons without materials, each a list of vertices;
    /// `origin` is its name in messages.
    ///
    /// # Errors
    /// The first fault in the text.
    pub fn from_json(text: &str, origin: &str) -> Result<Scene, SceneError> {
        read(&Source::new(origin, text), Language::Json)
    }

    /// Reads polygons without materials from CSV, a row `name,x,y,z` for each vertex; `origin` is its name in messages.
    ///
    /// # Errors
    /// The first fault in the text.
    pub fn from_csv(text: &str, origin: &str) -> Result<Scene, SceneError> {
        read(&Source::new(origin, text), Language::Csv)
    }

    /// Reads a scene made in code, as one from a text; `name` stands before messages, which lead to what they
    /// mean by names: `desk: surface "lamp", disk.radius: …`.
    ///
    /// # Errors
    /// The first fault in the tree.
    pub fn of_tree(name: &str, tree: Tree) -> Result<Scene, SceneError> {
        Scene::parse(&Source::of_tree(name, tree)?)
    }

    /// What was done to the file of another program that it was read from.
    pub fn imported(&self) -> Option<&Imported> {
        self.source.as_ref()?.imported.as_deref()
    }

    /// The scene in this language, with variables, parts, instances and formulas as they are, and without comments. Its
    /// text in the language of a scene of another program is that of [`Scene::load`].
    ///
    /// # Errors
    /// [`Fault::Foreign`] for a scene of a [`SceneBuilder`].
    pub fn text(&self, notation: Notation) -> Result<String, SceneError> {
        let source = self.written()?;
        let tree = include::tree_of(source, Language::of(source));
        let mut tree = tree.map_err(|located| located.in_source(source))?;
        if source.settings.is_empty() {
            return Ok(notation.text(&tree));
        }
        match variables::set(Arc::make_mut(&mut tree), &source.settings).first() {
            None => Ok(notation.text(&tree)),
            Some(name) => {
                let cause = format!("the variable {name:?} stands in an included file");
                let cure = "change it there".to_owned();
                Err(whole_file(&self.origin, Fault::Foreign { cause, cure }))
            }
        }
    }

    /// The text it was read from.
    fn written(&self) -> Result<&Source, SceneError> {
        let refused = |cause: &str, cure: &str| {
            let (cause, cure) = (cause.to_owned(), cure.to_owned());
            whole_file(&self.origin, Fault::Foreign { cause, cure })
        };
        let source = self.source.as_ref().ok_or_else(|| refused("a scene made in code has no text", ""))?;
        match source.moment {
            None => Ok(source),
            Some(_) => Err(refused(
                "a frame has no text of its own",
                "write the whole scene, without a frame; `render -o frame.glb` writes what a frame shows",
            )),
        }
    }

    /// The scene as another program would hold it, shapes as they were typed.
    ///
    /// # Errors
    /// [`Fault::Foreign`] for shapes that other programs do not have, and for a scene that was made in code.
    pub fn model(&self) -> Result<Model, SceneError> {
        let mut source = self.written()?.clone();
        let language = Language::of(&source);
        let model = include::trees(&mut source, language).and_then(|files| self.exported(files, &source));
        model.map_err(|located| located.in_source(&source))
    }

    /// The model of the scene that was built of these trees.
    fn exported(&self, files: Vec<FileTree>, source: &Source) -> Result<Model, Located> {
        let (file, _) = as_typed(files, source)?;
        let mut export = Export::new(&self.surfaces, &self.bands, &self.unit);
        if let Some(camera) = &self.camera {
            export.camera(camera, self.middle);
        }
        let placed = instances::placed(&file.content, &file.parts, source)?;
        placed.surfaces.iter().try_for_each(|placed| export.add(placed))?;
        let mut model = export.finish()?;
        model.title = self.title.clone();
        if self.surfaces.iter().any(SceneSurface::is_opening) {
            model.note("openings to the sky become diffuse emitters, and the sun is left out", None);
        }
        if !self.luminaires.is_empty() {
            model.note("luminaires are left out", None);
        }
        if self.animation.is_some() {
            model.note("motions are left out: everything is at rest", None);
        }
        if !self.planes.is_empty() {
            model.note("planes of sensors are left out", None);
        }
        Ok(model)
    }

    /// The index of the surface of that name.
    ///
    /// # Errors
    /// [`Fault::UnknownSurface`], which lists the names there are.
    pub fn surface_named(&self, name: &str) -> Result<usize, SceneError> {
        let unknown = || {
            let known = self.surfaces.iter().map(|surface| surface.name.clone()).collect();
            whole_file(&self.origin, Fault::UnknownSurface { name: name.to_owned(), known })
        };
        self.surfaces.iter().position(|surface| surface.name == name).ok_or_else(unknown)
    }

    /// The plane of sensors of that name.
    ///
    /// # Errors
    /// [`Fault::UnknownPlane`], which lists the names there are.
    pub fn plane_named(&self, name: &str) -> Result<&SensorPlane, SceneError> {
        let unknown = || {
            let known = self.planes.iter().map(|plane| plane.name().to_owned()).collect();
            whole_file(&self.origin, Fault::UnknownPlane { name: name.to_owned(), known })
        };
        self.planes.iter().find(|plane| plane.name() == name).ok_or_else(unknown)
    }

    /// The built-in scene `name`, its parameters at their defaults.
    ///
    /// # Errors
    /// [`Fault::UnknownScene`], which lists the names there are.
    pub fn builtin(name: &str) -> Result<Scene, SceneError> {
        Scene::builtin_with(name, &[])
    }

    /// The built-in scene `name` with parameters set by name; of two settings of one parameter the last counts.
    ///
    /// # Errors
    /// [`Fault::UnknownScene`], [`Fault::UnknownParameter`], [`Fault::ParameterRange`].
    pub fn builtin_with(name: &str, settings: &[(&str, f64)]) -> Result<Scene, SceneError> {
        if builtin::named(name).is_none() {
            return Err(whole_file(name, Fault::UnknownScene { name: name.to_owned() }));
        }
        Scene::load_with(name, settings)
    }

    /// The built-in scenes with their parameters.
    pub fn builtins() -> &'static [Builtin] {
        &builtin::ALL
    }

    /// The names of the built-in scenes.
    pub fn builtin_names() -> impl Iterator<Item = &'static str> {
        builtin::ALL.iter().map(|scene| scene.name)
    }

    /// Whether anything in it sends light of its own: a surface or a luminaire.
    pub fn emits(&self) -> bool {
        self.surfaces.iter().any(|surface| surface.material.emits())
            || self.luminaires.iter().any(Luminaire::emits)
    }

    /// Checks what only light needs: a material on every surface, and something that emits.
    ///
    /// # Errors
    /// [`Fault::MissingKey`] for a surface without material, [`Fault::NoMaterials`] if there cannot be any,
    /// [`Fault::NoEmitter`].
    pub fn require_light(&self) -> Result<(), SceneError> {
        if self.source.as_ref().is_some_and(Language::is_polygon_list) {
            return Err(whole_file(&self.origin, Fault::NoMaterials));
        }
        if self.imported().is_some() && self.surfaces.iter().all(|surface| surface.material_name.is_none()) {
            return Err(whole_file(&self.origin, Fault::Bare));
        }
        if let Some(bare) = self.surfaces.iter().find(|surface| surface.material_name.is_none()) {
            return Err(SceneError {
                origin: self.origin.clone(),
                place: bare.place.clone().map(Box::new),
                owner: Some(surface_title(&bare.name)),
                fault: Fault::MissingKey { key: "material" },
            });
        }
        match self.emits() {
            true => Ok(()),
            false => Err(whole_file(&self.origin, Fault::NoEmitter)),
        }
    }
}

/// Text → trees → scene.
fn read(source: &Source, language: Language) -> Result<Scene, SceneError> {
    let mut source = source.clone();
    let trees = include::trees(&mut source, language);
    let scene =
        trees.and_then(|trees| built(trees, &source)).map_err(|located| located.in_source(&source))?;
    scene.at_moment_of(&source)
}

/// The tables of variables in all files.
fn variable_tables(files: &[FileTree]) -> impl Iterator<Item = &Node> {
    files.iter().filter_map(|file| match &file.tree.value {
        Value::Table(entries) => entry(entries, VARIABLES),
        _ => None,
    })
}

/// The names in these tables, as far as they are right.
fn variable_names(files: &[FileTree]) -> impl Iterator<Item = &str> {
    let entries = variable_tables(files).filter_map(|node| match &node.value {
        Value::Table(entries) => Some(entries),
        _ => None,
    });
    entries.flatten().map(|(name, _)| name.value.as_str())
}

/// Trees → trees with formulas evaluated → as typed → valid.
fn built(files: Vec<FileTree>, source: &Source) -> Result<Scene, Located> {
    let (file, variables) = as_typed(files, source)?;
    assemble(file, variables, source)
}

/// Trees → trees with formulas evaluated → as typed, with the values of the variables.
fn as_typed(mut files: Vec<FileTree>, source: &Source) -> Result<(SceneFile, Vec<(String, f64)>), Located> {
    let variables = Variables::read(variable_tables(&files), source)?;
    files.iter_mut().for_each(|file| variables.fill(&mut file.tree));
    let files = files.iter().map(|file| SceneFile::read(&file.tree, &file.prefix));
    let file = merged(files.collect::<Result<_, _>>()?, source)?;
    Ok((file, variables.list()))
}

/// As typed → valid.
fn assemble(file: SceneFile, variables: Vec<(String, f64)>, source: &Source) -> Result<Scene, Located> {
    let is_grey = file.is_grey();
    let bands = validation::bands(file.bands, is_grey, source)?;
    let unit = validation::unit(file.unit)?;
    let planes = file.planes.into_iter().map(validation::plane).collect::<Result<_, _>>()?;
    let materials = validation::materials(file.materials, bands.len(), source)?;
    let sky = file.sky.as_ref().map(|sky| validation::sky(sky, bands.len())).transpose();
    let sky = sky.map_err(|error| error.within(|| "sky".into()))?;
    let instances::Placed { surfaces, luminaires: lamps } =
        instances::placed(&file.content, &file.parts, source)?;
    let (luminaires, luminous) = luminaires::luminaires(&lamps, bands.len(), source)?;
    let drafts = validation::surfaces(&surfaces, &materials, sky.as_ref(), bands.len(), source);
    let Surfaces { list, makers, middle, fitted } =
        fitted_surfaces(drafts.chain(luminous.into_iter().map(Ok)), source.tolerance)?;
    if let (Some(sky), false) = (&file.sky, list.iter().any(SceneSurface::is_opening)) {
        return Err(Located::at(&sky.span, Fault::NoOpening).within(|| "sky".into()));
    }
    let movable = motions::movable(&surfaces, &makers, &lamps, file.camera.is_some());
    let animation = motions::animation(&file.frames, &file.motions, &movable, source)?;
    let camera = file.camera.map(validation::camera).transpose()?;
    Ok(Scene {
        name: stem(&source.origin),
        title: file.title,
        middle,
        fitted,
        surfaces: list,
        luminaires: luminaires.into_iter().map(|own| own.about(middle)).collect(),
        bands,
        unit,
        variables,
        planes,
        camera: camera.map(|camera| camera.about(middle)),
        animation: animation.map(|animation| animation.about(middle)),
        origin: source.origin.to_string(),
        source: Some(source.clone()),
    })
}

/// `rooms/desk.toml` → `desk`, `<stdin>` → `stdin`.
fn stem(origin: &str) -> String {
    let plain = origin.trim_matches(['<', '>']);
    Path::new(plain).file_stem().map_or_else(|| plain.to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// A name without ending or folder is taken for a built-in scene, not for a file.
fn unreadable(source: &str, origin: &str, error: &io::Error) -> SceneError {
    let meant_as_name = error.kind() == io::ErrorKind::NotFound && !source.contains(['.', '/', '\\']);
    whole_file(
        origin,
        match meant_as_name {
            true => Fault::UnknownScene { name: source.to_owned() },
            false => Fault::Unreadable { kind: error.kind(), reason: error.to_string() },
        },
    )
}

fn whole_file(origin: &str, fault: Fault) -> SceneError {
    SceneError { origin: origin.to_owned(), place: None, owner: None, fault }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use radiosity_geom::{DVec3, Ray};

    use super::*;

    /// Areas of the bilinear patches in mm², of the data the scene is made from. Ceiling and floor without their holes.
    const CORNELL_AREAS: [(&str, f64); 16] = [
        ("floor", 308231.04 - 27633.0 - 27626.5),
        ("ceiling", 310915.2 - 13650.0),
        ("back_wall", 303376.64),
        ("right_wall", 306888.96),
        ("left_wall", 306902.807638),
        ("light", 13650.0),
        ("short_block_top", 27633.0),
        ("short_block_side1", 27344.238881),
        ("short_block_side2", 27610.273903),
        ("short_block_side3", 27562.409184),
        ("short_block_side4", 27198.987573),
        ("tall_block_top", 27626.5),
        ("tall_block_side1", 54905.098124),
        ("tall_block_side2", 54688.477763),
        ("tall_block_side3", 55220.547806),
        ("tall_block_side4", 54589.82048),
    ];

    #[test]
    fn cornell_faces_have_the_measured_areas() {
        let scene = Scene::builtin("cornell-box").unwrap();
        assert_eq!(scene.surfaces.len(), CORNELL_AREAS.len());
        for (surface, (name, area)) in scene.surfaces.iter().zip(CORNELL_AREAS) {
            assert_eq!(surface.name, name);
            let found = surface.shape.area();
            assert!((found - area).abs() < 1e-6, "{name}: {found} instead of {area}");
        }
    }

    #[test]
    fn cornell_light_is_pi_times_the_published_radiance() {
        let scene = Scene::builtin("cornell-box").unwrap();
        let light = scene.surfaces.iter().find(|surface| surface.material.emits()).unwrap();
        assert_eq!(light.name, "light");
        assert_eq!(light.material.emission, [16.16, 11.04, 4.8].map(|radiance| PI * radiance));
        assert_eq!(scene.surfaces.iter().filter(|surface| surface.material.emits()).count(), 1);
    }

    #[test]
    fn cornell_fronts_face_the_air() {
        let scene = Scene::builtin("cornell-box").unwrap();
        let inside = DVec3::new(278.0, 400.0, 100.0);
        for surface in &scene.surfaces {
            let center = surface.shape.jet(0.0, 0.0);
            let block = ["short_block", "tall_block"].iter().find(|block| surface.name.starts_with(**block));
            // Out of a block its fronts face away from the middle of its top, lowered; walls face a point of the room.
            let outward = match block {
                Some(block) => {
                    let top =
                        scene.surfaces.iter().find(|other| other.name == format!("{block}_top")).unwrap();
                    center.position - (top.shape.jet(0.0, 0.0).position - 10.0 * DVec3::Y)
                }
                None => inside - center.position,
            };
            assert!(outward.dot(center.normal) > 0.0, "{}", surface.name);
        }
    }

    #[test]
    fn closed_rooms_are_closed_and_face_inward() {
        for name in ["empty-box", "furnace-cube"] {
            let scene = Scene::builtin(name).unwrap();
            let names: Vec<&str> = scene.surfaces.iter().map(|surface| surface.name.as_str()).collect();
            assert_eq!(names, ["floor", "ceiling", "wall-x0", "wall-x1", "wall-y0", "wall-y1"]);
            assert_eq!(scene.bands, ["grey"]);
            let middle = DVec3::splat(0.5);
            for surface in &scene.surfaces {
                let center = surface.shape.jet(0.0, 0.0);
                assert!((middle - center.position).dot(center.normal) > 0.0);
            }
            let area: f64 = scene.surfaces.iter().map(|surface| surface.shape.area()).sum();
            assert!((area - 6.0).abs() < 1e-14);
        }
    }

    #[test]
    fn cameras_of_the_built_in_scenes_see_a_front() {
        for name in Scene::builtin_names() {
            let scene = Scene::builtin(name).unwrap();
            let camera = scene.camera.as_ref().unwrap();
            let ray = Ray::new(camera.eye, camera.target - camera.eye);
            let hits =
                scene.surfaces.iter().filter_map(|surface| Some((surface, surface.shape.intersect(&ray)?)));
            let (seen, hit) = hits.min_by(|a, b| a.1.t.total_cmp(&b.1.t)).unwrap();
            assert!(seen.shape.jet(hit.u, hit.v).normal.dot(camera.target - camera.eye) < 0.0, "{name}");
        }
    }

    const TOML: &str = r#"
        bands = ["grey"]
        [materials.wall]
        reflectance = 0.25
        emission = [2]
        [[surfaces]]
        material = "wall"
        order = 6
        subdivide = [2, 1]
        two_sided = true
        flip = true
        transform = { scale = 2, rotate = [0, 0, 1, 90], translate = [0, 0, 1] }
        triangle = { vertices = [[0,0,0],[1,0,0],[0,1,0]] }
    "#;

    const JSON: &str = r#"{
        "bands": ["grey"],
        "materials": {"wall": {"reflectance": 0.25, "emission": [2]}},
        "surfaces": [{
            "material": "wall", "order": 6, "subdivide": [2, 1], "two_sided": true, "flip": true,
            "transform": {"scale": 2, "rotate": [0, 0, 1, 90], "translate": [0, 0, 1]},
            "triangle": {"vertices": [[0,0,0],[1,0,0],[0,1,0]]}
        }]
    }"#;

    #[test]
    fn toml_and_json_say_the_same() {
        for scene in [Scene::from_toml(TOML, "a/room.toml").unwrap(), Scene::from_json(JSON, "room").unwrap()]
        {
            assert_eq!(scene.name, "room");
            assert_eq!(scene.bands, ["grey"]);
            let [front, back] = &scene.surfaces[..] else { panic!("a two-sided surface is two") };
            assert_eq!((front.name.as_str(), back.name.as_str()), ("surface-1", "surface-1:back"));
            assert_eq!((front.order, front.subdivide), (Some(6), Some([2, 1])));
            assert_eq!(back.material, Material::new(vec![0.25], vec![2.0]).unwrap());
            let (front, back) = (front.shape.jet(0.0, 0.0), back.shape.jet(0.0, 0.0));
            assert!((front.normal + DVec3::Z).length() < 1e-15 && (back.normal - DVec3::Z).length() < 1e-15);
            assert!((front.position.z - 1.0).abs() < 1e-15);
            // Twice as long both ways, and a quarter turn takes +y to −x.
            assert!((scene.surfaces[0].shape.area() - 2.0).abs() < 1e-14);
            assert!(front.position.x < 0.0);
        }
    }
}
