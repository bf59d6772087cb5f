//! Reading scenes: text → trees → trees with formulas evaluated → as typed → valid.

use std::{collections::BTreeSet, io, path::Path};

use radiosity_formats::format::Format;
use radiosity_photometry::files::Reach;
use radiosity_scene::{
    Fault, FaultKind, HeatSetting, Scene, SceneError, SceneSurface, Source,
    error::Located,
    fault::{choice, nearest},
    masked_pair::masked_pairs,
    surfaces::{Surfaces, fitted_surfaces, unused_materials},
    tree::{Node, Value, entry},
};
use radiosity_work::listed::{LONG, listed};
use radiosity_work::ranks::Ranks;

use crate::builtin::{self, Builtin};
use crate::file::SceneFile;
use crate::import::Import;
use crate::include::{self, FileTree};
use crate::keys::KeyTable;
use crate::language::Language;
use crate::merging::merged;
use crate::motions::MadeThings;
use crate::variables::{VARIABLES, Variables};
use crate::{input, instances, luminaires, motions, validation};

/// Reads the scene of a [`source`], without settings.
///
/// # Errors
/// As [`source`] and [`read`].
pub fn load(name: &str) -> Result<Scene, SceneError> {
    read(&source(name, &[])?)
}

/// Reads the built-in scene `name`, its parameters at their defaults.
///
/// # Errors
/// [`FaultKind::UnknownName`]; the cure lists the names there are.
pub fn builtin(name: &str) -> Result<Scene, SceneError> {
    match builtin::named(name) {
        Some(_) => load(name),
        None => Err(SceneError::of(name, unknown_scene(name))),
    }
}

/// The source of a built-in scene by its name, of standard input for `-`, or else of the file at the path
/// `name`, with parameters of a built-in scene, or variables of any other, set by name: of two settings of
/// one name the last counts. Files that it names are read from its folder and below ([`Reach::Inside`]).
///
/// A file whose ending names a format of another program ([`Format`](radiosity_formats::format::Format)) is
/// read in that and repaired.
///
/// # Errors
/// A file that cannot be read, an unknown name of a scene; or of a parameter, a parameter
/// out of its range.
pub fn source(name: &str, settings: &[(&str, f64)]) -> Result<Source, SceneError> {
    source_by(name, settings, &Import::default(), Reach::Inside, Ranks::alone())
}

/// The [`source`] called `name`, which may `reach` so far for the files that it names; `import` are the options
/// for a file of another program, and the first of these ranks shares its standard input.
///
/// # Errors
/// As [`source`], and what is against the rules of the format; with [`Import::strict`] what needs repairs.
pub fn source_by(
    name: &str,
    settings: &[(&str, f64)],
    import: &Import,
    reach: Reach,
    ranks: &Ranks,
) -> Result<Source, SceneError> {
    if let Some(scene) = builtin::named(name) {
        let text = scene.text(settings).map_err(|fault| SceneError::of(name, fault))?;
        return Ok(Source::new(name, &text));
    }
    if let Some(format) = import.format_of(name) {
        return Ok(import.source(name, format, reach, ranks)?.set(settings.iter().copied()));
    }
    if let Some(cure) = Format::cure_of_others(name) {
        let cause = "scenes of this format are not read".to_owned();
        return Err(SceneError::of(name, Fault::new(FaultKind::Foreign, cause, cure)));
    }
    let origin = if name == "-" { "<stdin>" } else { name };
    let text = input::text(name, ranks).map_err(|error| unreadable(name, origin, &error))?;
    Ok(Source::new(origin, &text).reaching(reach).set(settings.iter().copied()))
}

/// Reads a scene, of a text or made in code.
///
/// A text called `.json`, and any that starts with `{`, is JSON: the same tree as TOML, or a list of polygons
/// without materials, each a list of vertices. One called `.csv` is a list of polygons in CSV, a row
/// `name,x,y,z` for each vertex. A text of unknown name may also start as a list of polygons in JSON, `[[[`,
/// or in CSV; everything else is TOML.
///
/// A scene made in code is one as from a text; messages lead to what they mean by names: `desk: surface
/// "lamp", disk.radius: …`.
///
/// ```
/// use radiosity_geom::DVec3;
/// use radiosity_scene::{Source, Tree};
///
/// let desk = vec![DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y];
/// let surface = Tree::table([
///     ("name", Tree::text("desk")),
///     ("material", Tree::text("wood")),
///     ("polygon", Tree::table([("vertices", Tree::points(desk))])),
/// ]);
/// let wood = Tree::table([("reflectance", Tree::number(0.4))]);
/// let materials = Tree::table([("wood", wood)]);
/// let room = Tree::table([("materials", materials), ("surfaces", Tree::list([surface]))]);
/// let room = radiosity_language::read(&Source::of_tree("room", room)?)?;
/// assert_eq!(room.surfaces[0].name, "desk");
/// # Ok::<(), radiosity_scene::SceneError>(())
/// ```
///
/// # Errors
/// The first fault in the source.
pub fn read(source: &Source) -> Result<Scene, SceneError> {
    let mut source = source.clone();
    let language = Language::of(&source);
    let trees = include::trees(&mut source, language);
    let scene = trees.and_then(|trees| built(trees, &mut source));
    let scene = scene.map_err(|located| located.in_source(&source))?;
    scene.at_moment_of(&source)
}

/// Reads a scene as [`read`] does, with settings of its variables and of its light groups by name; see
/// [`Scene::dimmed`].
///
/// # Errors
/// The first fault in the text; [`FaultKind::UnknownName`], [`FaultKind::Conflict`] and what
/// [`Scene::dimmed`] refuses.
pub fn read_with(source: &Source, settings: &[(&str, f64)]) -> Result<Scene, SceneError> {
    let mut source = source.clone();
    let language = Language::of(&source);
    let files = include::trees(&mut source, language);
    let files = files.map_err(|located| located.in_source(&source))?;
    let names: BTreeSet<&str> = variable_names(&files).collect();
    let (own, groups): (Vec<_>, Vec<_>) = settings.iter().partition(|(name, _)| names.contains(name));
    let mut source = source.set(own.iter().copied());
    let scene = built(files, &mut source).map_err(|located| located.in_source(&source))?;
    let scene = scene.at_moment_of(&source)?;
    let refused = |fault| Err(SceneError::of(&*source.origin, fault));
    let known: Vec<String> = scene.light_groups().iter().map(|group| group.name.clone()).collect();
    let has = |name: &str| known.iter().any(|known| known == name);
    if let Some((name, _)) = own.iter().find(|(name, _)| has(name)) {
        return refused(Fault::variable_and_group(name));
    }
    match groups.iter().find(|(name, _)| !has(name)) {
        Some((name, _)) if !scene.variables.is_empty() => {
            let variables: Vec<&str> = scene.variables.iter().map(|(name, _)| name.as_str()).collect();
            let unknown = || unknown_setting(name, &variables, &known, &source);
            refused(HeatSetting::misplaced(name).unwrap_or_else(unknown))
        }
        _ => scene.dimmed(&groups),
    }
}

/// The built-in scenes with their parameters.
pub fn builtins() -> &'static [Builtin] {
    &builtin::ALL
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
fn built(files: Vec<FileTree>, source: &mut Source) -> Result<Scene, Located> {
    let (file, variables) = as_typed(files, source)?;
    assemble(file, variables, source)
}

/// Trees → trees with formulas evaluated → as typed, with the values of the variables.
pub(crate) fn as_typed(
    mut files: Vec<FileTree>,
    source: &Source,
) -> Result<(SceneFile, Vec<(String, f64)>), Located> {
    let variables = Variables::read(variable_tables(&files), source)?;
    files.iter_mut().for_each(|file| variables.fill(&mut file.tree));
    let files = files.iter().map(|file| SceneFile::read_in(&file.tree, &file.prefix));
    let file = merged(files.collect::<Result<_, _>>()?, source)?;
    Ok((file, variables.list()))
}

/// The valid scene of a scene file as typed.
fn assemble(
    mut file: SceneFile,
    variables: Vec<(String, f64)>,
    source: &mut Source,
) -> Result<Scene, Located> {
    let is_grey = file.is_grey();
    let bands = validation::bands(file.bands.take(), is_grey, source)?;
    let unit = validation::unit(file.unit.take())?;
    let planes =
        std::mem::take(&mut file.planes).into_iter().map(validation::plane).collect::<Result<_, _>>()?;
    let materials = validation::materials(std::mem::take(&mut file.materials), bands.len(), source)?;
    let sky = file.sky.as_ref().map(|sky| validation::sky(sky, bands.len())).transpose();
    let sky = sky.map_err(|error| error.within(|| "sky".into()))?;
    let instances::Placed { surfaces, luminaires: lamps, outside } =
        instances::placed(file.content(), &file.parts, source)?;
    let (luminaires, luminous) = luminaires::luminaires(&lamps, bands.len(), source)?;
    let drafts = validation::surfaces(&surfaces, &materials, sky.as_ref(), bands.len(), source);
    let Surfaces { list, makers, middle, fitted } =
        fitted_surfaces(drafts.chain(luminous.into_iter().map(Ok)), source.tolerance)?;
    check_openings(&file, &list)?;
    let made = MadeThings {
        placed: &surfaces,
        makers: &makers,
        surfaces: &list,
        placed_luminaires: &lamps,
        luminaires: &luminaires,
    };
    let movable = motions::movable(&made, bands.len(), file.camera.is_some());
    source.hide(outside);
    source.hide(motions::names_outside(&made, &movable));
    let masks = masked_pairs(file.masks.iter().map(validation::mask).collect(), &movable.surfaces)?;
    let animation = motions::animation(&file, &movable, source)?;
    let camera = file.camera.map(validation::camera).transpose()?;
    let mut scene = Scene::empty(stem(&source.origin), bands, unit);
    scene.title = file.title;
    scene.middle = middle;
    scene.fitted = fitted;
    scene.unused_materials = unused_materials(materials.keys().map(String::as_str), &list);
    scene.surfaces = list;
    scene.luminaires = luminaires.into_iter().map(|own| own.about(middle)).collect();
    scene.variables = variables;
    scene.planes = planes;
    scene.masks = masks;
    scene.camera = camera.map(|camera| camera.about(middle));
    scene.animation = animation.map(|animation| animation.about(middle));
    scene.origin = source.origin.to_string();
    scene.source = Some(source.clone());
    Ok(scene)
}

/// Refuses a sky that no surface is an opening to.
fn check_openings(file: &SceneFile, surfaces: &[SceneSurface]) -> Result<(), Located> {
    let Some(sky) = file.sky.as_ref().filter(|_| !surfaces.iter().any(SceneSurface::is_opening)) else {
        return Ok(());
    };
    let cure = "give a window opening = true, its front to the room, or leave the sky out";
    let fault = Fault::absent("no surface is an opening to the sky", cure);
    Err(Located::at(&sky.span, fault).within(|| "sky".into()))
}

/// `rooms/desk.toml` → `desk`, `<stdin>` → `stdin`.
fn stem(origin: &str) -> String {
    let plain = origin.trim_matches(['<', '>']);
    Path::new(plain).file_stem().map_or_else(|| plain.to_owned(), |stem| stem.to_string_lossy().into_owned())
}

/// A name without ending or folder is taken for a built-in scene, not for a file.
fn unreadable(source: &str, origin: &str, error: &io::Error) -> SceneError {
    let meant_as_name = error.kind() == io::ErrorKind::NotFound && !source.contains(['.', '/', '\\']);
    SceneError::of(
        origin,
        match meant_as_name {
            true => unknown_scene(source),
            false => input::unreadable(error),
        },
    )
}

/// A scene that is not built in.
fn unknown_scene(name: &str) -> Fault {
    let known: Vec<&str> = builtins().iter().map(|scene| scene.name).collect();
    let cure = choice(name, &known, "built-in scenes")
        + "; a scene file is given by its path, ending in .toml or .json";
    Fault::new(FaultKind::UnknownName, format!("unknown scene {name:?}"), cure)
}

/// A setting of neither a variable nor a light group.
fn unknown_setting(name: &str, variables: &[&str], groups: &[String], source: &Source) -> Fault {
    let own = |names: &mut dyn Iterator<Item = &str>| {
        names.filter(|name| source.may_list(name)).map(str::to_owned).collect::<Vec<_>>()
    };
    let own = [own(&mut variables.iter().copied()), own(&mut groups.iter().map(String::as_str))];
    let near = nearest(name, own.iter().flatten().map(String::as_str));
    let near = near.map(|near| format!("did you mean {near:?}? ")).unwrap_or_default();
    let is_whole = own[0].len() + own[1].len() == variables.len() + groups.len();
    let others = if is_whole { "" } else { "; others stand in files outside the folder of the scene" };
    let [variables, groups] =
        own.map(|names| if names.is_empty() { "none".to_owned() } else { listed(&names, LONG) });
    let cure = format!("{near}variables of this scene: {variables}; light groups: {groups}{others}");
    let cause = format!("there is no variable or light group {name:?}");
    Fault::new(FaultKind::UnknownName, cause, cure)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use radiosity_geom::{DVec3, Ray};

    use radiosity_scene::Material;

    use super::*;

    /// Areas of the bilinear patches in mm², of the data the scene is made from. Ceiling and floor without
    /// their holes.
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
        let scene = builtin("cornell-box").unwrap();
        assert_eq!(scene.surfaces.len(), CORNELL_AREAS.len());
        for (surface, (name, area)) in scene.surfaces.iter().zip(CORNELL_AREAS) {
            assert_eq!(surface.name, name);
            let found = surface.shape.area();
            assert!((found - area).abs() < 1e-6, "{name}: {found} instead of {area}");
        }
    }

    #[test]
    fn cornell_light_is_pi_times_the_published_radiance() {
        let scene = builtin("cornell-box").unwrap();
        let light = scene.surfaces.iter().find(|surface| surface.material.emits()).unwrap();
        assert_eq!(light.name, "light");
        assert_eq!(light.material.emission, [16.16, 11.04, 4.8].map(|radiance| PI * radiance));
        assert_eq!(scene.surfaces.iter().filter(|surface| surface.material.emits()).count(), 1);
    }

    #[test]
    fn cornell_fronts_face_the_air() {
        let scene = builtin("cornell-box").unwrap();
        let inside = DVec3::new(278.0, 400.0, 100.0);
        for surface in &scene.surfaces {
            let center = surface.shape.jet(0.0, 0.0);
            let block = ["short_block", "tall_block"].iter().find(|block| surface.name.starts_with(**block));
            // Out of a block its fronts face away from the middle of its top, lowered; walls face a point of
            // the room.
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
            let scene = builtin(name).unwrap();
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
        for name in builtins().iter().map(|scene| scene.name) {
            let scene = builtin(name).unwrap();
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
        for scene in [("a/room.toml", TOML), ("room", JSON)]
            .map(|(name, text)| read(&Source::new(name, text)).unwrap())
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
