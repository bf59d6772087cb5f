//! Outcomes of the rows of the tables: each input runs once, for its own test and for that of all messages.

use std::collections::{BTreeMap, BTreeSet};
use std::process::Output;
use std::sync::LazyLock;

use radiosity_test_support::folders::folder;

use super::workplace::{self, typed};
use super::{Row, Typed, commands, files, runs, scenes, warnings};
use crate::program::radiosity;

/// `check` of the rooms that look wrong, in the order of the rows.
pub(super) static WARNED: LazyLock<Vec<Output>> = LazyLock::new(|| checked(warnings::ROWS));

/// `check` of the rooms that are refused, in the order of the rows.
pub(super) static ROOMS: LazyLock<Vec<Output>> =
    LazyLock::new(|| checked(scenes::ROWS.iter().copied().flatten()));

/// `check` of the scenes with a file that is refused, in the order of the files and their rows.
pub(super) static FILES: LazyLock<Vec<Output>> = LazyLock::new(|| {
    let of_file = |file: &'static super::Changed| file.rows.iter().map(|row| file.refused(row));
    files::CHANGED.iter().flat_map(of_file).collect()
});

/// Commands as they are typed, which share a folder.
pub(super) static COMMANDS: LazyLock<RunCommands> = LazyLock::new(RunCommands::run);

/// Outcomes of commands.
pub(super) struct RunCommands {
    /// Of those that are refused, in the order of the rows.
    pub(super) refused: Vec<Output>,
    /// Of those that warn, in the order of the rows.
    pub(super) warned: Vec<Output>,
    /// Of the cured ones, of which many are one.
    pub(super) cured: BTreeMap<&'static str, Output>,
}

impl RunCommands {
    fn run() -> Self {
        let folder = workplace::files();
        let bad = |row: &Typed| typed(folder.path(), row.bad);
        let rows = || commands::ROWS.iter().copied().flatten();
        let refused = rows().map(bad).collect();
        let warned = runs::ROWS.iter().map(bad).collect();
        let cured: BTreeSet<&str> = rows().chain(runs::ROWS).map(|row| row.cured).collect();
        let cured = cured.into_iter().map(|line| (line, typed(folder.path(), line))).collect();
        Self { refused, warned, cured }
    }
}

fn checked<'a>(rows: impl IntoIterator<Item = &'a Row>) -> Vec<Output> {
    let check = |row: &Row| {
        let folder = folder(&[("room.toml", row.with(row.bad))]);
        radiosity(folder.path(), &["check", "room.toml"])
    };
    rows.into_iter().map(check).collect()
}

/// All outcomes.
pub(super) fn all() -> impl Iterator<Item = &'static Output> {
    WARNED.iter().chain(ROOMS.iter()).chain(FILES.iter()).chain(&COMMANDS.refused).chain(&COMMANDS.warned)
}
