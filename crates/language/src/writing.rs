//! Writing scenes that were read: in this language, and as models of other programs.

use std::num::NonZeroUsize;
use std::sync::Arc;

use radiosity_formats::model::Model;
use radiosity_scene::{Fault, Notation, Scene, SceneError, SceneSurface, Source, error::Located};

use crate::export::Export;
use crate::include::{self, FileTree};
use crate::instances;
use crate::language::Language;
use crate::reading::as_typed;
use crate::variables;

/// The scene in this language, with variables, parts, instances and formulas as they are, and without
/// comments. Its text in the language of a scene of another program is that of [`load`](crate::load).
///
/// # Errors
/// [`FaultKind::Foreign`](radiosity_scene::FaultKind::Foreign) for a scene of a
/// [`SceneBuilder`](radiosity_scene::SceneBuilder).
pub fn text(scene: &Scene, notation: Notation) -> Result<String, SceneError> {
    let source = written(scene)?;
    let tree = include::tree_of(source, Language::of(source));
    let mut tree = tree.map_err(|located| located.in_source(source))?;
    if source.settings.is_empty() {
        return Ok(notation.text(&tree));
    }
    match variables::set(Arc::make_mut(&mut tree), &source.settings).first() {
        None => Ok(notation.text(&tree)),
        Some(name) => {
            let cause = format!("the variable {name:?} stands in an included file");
            Err(SceneError::of(&scene.origin, Fault::foreign(cause, "change it there")))
        }
    }
}

/// The text it was read from.
fn written(scene: &Scene) -> Result<&Source, SceneError> {
    let refused = |cause, cure| SceneError::of(&scene.origin, Fault::foreign(cause, cure));
    let source = scene.source.as_ref().ok_or_else(|| refused("a scene made in code has no text", ""))?;
    match source.moment {
        None => Ok(source),
        Some(_) => Err(refused(
            "a frame has no text of its own",
            "write the whole scene, without a frame; `render -o frame.glb` writes what a frame shows",
        )),
    }
}

/// The scene as another program would hold it, shapes as they were typed, or curved ones cut into flat pieces
/// over so many cells each way.
///
/// # Errors
/// [`FaultKind::Foreign`](radiosity_scene::FaultKind::Foreign) for shapes that other programs do not have, and
/// for a scene that was made in code.
pub fn model(scene: &Scene, tessellation: Option<NonZeroUsize>) -> Result<Model, SceneError> {
    let mut source = written(scene)?.clone();
    let language = Language::of(&source);
    let model =
        include::trees(&mut source, language).and_then(|files| exported(scene, files, &source, tessellation));
    model.map_err(|located| located.in_source(&source))
}

/// The model of the scene that was built of these trees.
fn exported(
    scene: &Scene,
    files: Vec<FileTree>,
    source: &Source,
    tessellation: Option<NonZeroUsize>,
) -> Result<Model, Located> {
    let (file, _) = as_typed(files, source)?;
    let mut export = Export::new(scene, tessellation);
    if let Some(camera) = &scene.camera {
        export.camera(camera, scene.middle);
    }
    let placed = instances::placed(file.content(), &file.parts, source)?;
    placed.surfaces.iter().try_for_each(|placed| export.add(placed))?;
    let mut model = export.finish()?;
    model.title = scene.title.clone();
    if scene.surfaces.iter().any(SceneSurface::is_opening) {
        model.note("openings to the sky become diffuse emitters, and the sun is left out", None);
    }
    if !scene.luminaires.is_empty() {
        model.note("luminaires are left out", None);
    }
    if let Some(animation) = &scene.animation {
        model.note("motions are left out: everything is at rest", None);
        if animation.movers.iter().any(|mover| mover.emission.is_some()) {
            model.note("emission over time is left out: everything shines as at rest", None);
        }
    }
    if !scene.masks.is_empty() {
        model.note("chosen shadow masks are left out", None);
    }
    if !scene.planes.is_empty() {
        model.note("planes of sensors are left out", None);
    }
    Ok(model)
}

#[cfg(test)]
mod tests {
    use radiosity_scene::{
        place::At,
        tree::{Node, Value},
    };

    use super::*;
    use crate::{json_text, toml_text};

    const PRINTED: &str = r#"
        title = "a \"desk\" in a\troom"
        bands = ["r", "g"]
        empty = []
        [variables]
        width = "=2 * 3"
        [camera]
        eye = [0, -3e-9, 1.25]
        [materials."white wall"]
        reflectance = 0.1
        [materials.lamp]
        emission = [1e300, 3e15]
        [[surfaces]]
        name = "x"
        two_sided = true
        quad = { vertices = [[0, 0, 0], [1, 0, 0.1]] }
        [[surfaces]]
        box = { open = ["top"] }
        [parts.chair]
        surfaces = [{ name = "seat", order = 6 }]
    "#;

    /// The tree without places.
    fn bare(node: &Node) -> Node {
        let value = match &node.value {
            Value::List(items) => Value::List(items.iter().map(bare).collect()),
            Value::Table(entries) => {
                let mut entries: Vec<_> = entries
                    .iter()
                    .map(|(key, own)| (At::new(key.value.clone(), &(0..0)), bare(own)))
                    .collect();
                entries.sort_by(|a, b| a.0.value.cmp(&b.0.value));
                Value::Table(entries)
            }
            plain => plain.clone(),
        };
        At::new(value, &(0..0))
    }

    #[test]
    fn what_is_printed_reads_as_the_same_tree() {
        let tree = toml_text::parse(PRINTED).unwrap();
        let from_toml = toml_text::parse(&Notation::Toml.text(&tree)).unwrap();
        let from_json = json_text::parse(&Notation::Json.text(&tree)).unwrap();
        assert_eq!(bare(&from_toml), bare(&tree));
        assert_eq!(bare(&from_json), bare(&tree));
    }

    #[test]
    fn each_surface_has_a_line_in_json() {
        let text = Notation::Json.text(&toml_text::parse(PRINTED).unwrap());
        assert!(
            text.lines().any(|line| line.starts_with(r#"    {"name": "x", "two_sided": true"#)),
            "{text}"
        );
    }
}
