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

/// The text of a room of two bands with a block, a panel of two sides in it, and a lamp and a glow of this
/// emission in groups of their own; with these further materials and surfaces.
pub fn lamps_room([lamp, glow]: [[f64; 2]; 2], materials: &str, surfaces: &str) -> String {
    format!(
        r#"
bands = ["a", "b"]
materials.wall = {{ reflectance = [0.7, 0.4] }}
materials.lamp = {{ reflectance = 0, emission = {lamp:?}, group = "lamp" }}
materials.glow = {{ reflectance = 0.2, emission = {glow:?}, group = "glow" }}
{materials}
[[surfaces]]
name = "room"
material = "wall"
box = {{ origin = [0, 0, 0], size = [1, 1, 1], inward = true }}
[[surfaces]]
name = "block"
material = "wall"
box = {{ origin = [0.5, 0.5, 0], size = [0.25, 0.3, 0.5] }}
[[surfaces]]
name = "lamp"
material = "lamp"
parallelogram = {{ origin = [0.2, 0.4, 0.9], edge1 = [0, 0.2, 0], edge2 = [0.2, 0, 0] }}
[[surfaces]]
name = "glow"
material = "glow"
parallelogram = {{ origin = [0.05, 0.05, 0.2], edge1 = [0.2, 0, 0], edge2 = [0, 0.2, 0] }}
{surfaces}
[[surfaces]]
name = "panel"
material = "wall"
two_sided = true
parallelogram = {{ origin = [0.1, 0.5, 0.6], edge1 = [0.3, 0, 0], edge2 = [0, 0.3, 0] }}
"#
    )
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

/// Unit plates 2 cm apart, of which even fluxes tell nearly a tenth too much: `body` sends out 44.34 W (Monte Carlo of
/// another program, ± 0.08), order 0 finds 48.38.
pub const NEAR_PLATES: &str = r#"
    materials.body = { emissivity = 0.8, temperature = 293.15 }
    materials.foil = { emissivity = 0.05, temperature = 143 }
    [[surfaces]]
    name = "body"
    material = "body"
    quad = { vertices = [[0,0,0],[1,0,0],[1,1,0],[0,1,0]] }
    [[surfaces]]
    name = "foil"
    material = "foil"
    quad = { vertices = [[0,0,0.02],[0,1,0.02],[1,1,0.02],[1,0,0.02]] }
"#;

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
