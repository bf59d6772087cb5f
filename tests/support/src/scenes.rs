//! Scenes: built in, typed, or made of shapes.

use std::sync::Arc;

use radiosity::geom::Surface;
use radiosity::scene::{NamedMaterial, Source};
use radiosity::{Material, Scene, SceneBuilder, language};

/// A scene that is built in.
#[track_caller]
pub fn builtin(name: &str) -> Scene {
    builtin_with(name, &[])
}

/// A scene that is built in, some of its parameters set.
#[track_caller]
pub fn builtin_with(name: &str, settings: &[(&str, f64)]) -> Scene {
    language::source(name, settings)
        .and_then(|source| language::read(&source))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The scene of a text in TOML that is right; messages call it `scene`.
#[track_caller]
pub fn typed(text: &str) -> Scene {
    language::read(&Source::new("scene", text)).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

/// The scene of a source that is right, with the files that it includes.
#[track_caller]
pub fn parsed(source: &Source) -> Scene {
    language::read(source).unwrap_or_else(|error| panic!("{error}\n{}", source.text()))
}

/// A scene with one surface of each shape that scene files can name.
pub fn every_shape() -> Scene {
    typed(EVERY_SHAPE)
}

/// The text of [`every_shape`].
pub const EVERY_SHAPE: &str = include_str!("../../data/every-shape.toml");

/// A material of one band.
#[track_caller]
pub fn material(reflectance: f64, exitance: f64) -> Material {
    Material::new(vec![reflectance], vec![exitance]).expect("a reflectance up to 1, an exitance from 0")
}

/// A builder of one band with a material `grey`, of reflectance ½ and exitance 1.
pub fn grey() -> (SceneBuilder, NamedMaterial) {
    let mut builder = SceneBuilder::new("grey", ["grey"]);
    let grey = builder.material("grey", material(0.5, 1.0));
    (builder, grey)
}

/// A builder of one band with these shapes, called `surface 0` and so on, each of reflectance ½ and of its
/// own exitance.
pub fn shining(shapes: impl IntoIterator<Item = (Arc<dyn Surface>, f64)>) -> SceneBuilder {
    let mut builder = SceneBuilder::new("shapes", ["grey"]);
    for (index, (shape, exitance)) in shapes.into_iter().enumerate() {
        let material = builder.material(format!("material {index}"), material(0.5, exitance));
        builder.surface(format!("surface {index}"), shape, &material);
    }
    builder
}
