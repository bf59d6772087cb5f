//! The scenes that live in the binary, so that a first run needs no file.

/// Names of the built-in scenes, each the stem of a file in `scenes/`.
pub(super) const NAMES: [&str; 3] = ["cornell-box", "empty-box", "furnace-cube"];

/// The TOML text of a built-in scene.
pub(super) fn text(name: &str) -> Option<&'static str> {
    match name {
        "cornell-box" => Some(include_str!("../../scenes/cornell-box.toml")),
        "empty-box" => Some(include_str!("../../scenes/empty-box.toml")),
        "furnace-cube" => Some(include_str!("../../scenes/furnace-cube.toml")),
        _ => None,
    }
}
