//! `--subdivide`.

use std::str::FromStr;

use radiosity_scene::MAX_PARTS;

/// `--subdivide`: elements along u and along v; None, written `auto`, is as the scene needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Subdivide(pub(crate) Option<usize>);

impl FromStr for Subdivide {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = || text.parse().ok().filter(|parts| (1..=MAX_PARTS).contains(parts)).map(Some);
        let subdivide = if text == "auto" { Some(None) } else { parts() };
        subdivide.map(Self).ok_or_else(|| format!("expected a whole number from 1 to {MAX_PARTS}, or auto"))
    }
}
