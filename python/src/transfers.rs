//! Files of transfers, which other runs on the same surfaces take up.

use std::path::PathBuf;

use pyo3::prelude::*;
use radiosity::scene::Scene;
use radiosity::solve::geometry;
use radiosity::work::ranks::Ranks;

use crate::arguments::Arguments;
use crate::error::Trouble;

/// The rank that works on `scene`, with the file of its transfers if one is given.
pub(crate) fn keeping(given: &mut Arguments<'_>, scene: &Scene) -> PyResult<Ranks> {
    let path: Option<PathBuf> = given.value("transfers")?;
    let ranks = path.map(|path| Ranks::alone().keeping_transfers(&path, geometry(scene)));
    Ok(ranks.transpose().map_err(Trouble::from)?.unwrap_or_else(|| Ranks::alone().clone()))
}
