//! The options and arguments of a command line on which results depend.

use std::ffi::{OsStr, OsString};
use std::path::Path;

use clap::parser::ValueSource;
use clap::{ArgMatches, Command};

/// Options and arguments on which results depend, with their values: a run that resumes may differ in all
/// others.
#[derive(Debug, Default)]
pub(crate) struct TypedOptions(Vec<(String, Vec<OsString>)>);

/// Options on which no number depends: means, messages, and where a run is recorded. Names of outputs may
/// differ, their endings not.
const FREE: [&str; 9] =
    ["checkpoint", "keep_partial", "memory", "quiet", "report", "resume", "threads", "time_limit", "verbose"];

impl TypedOptions {
    /// The first of the options of `some` that `own` does not know and that was typed.
    pub(crate) fn first_beside(&self, some: &Command, own: &Command) -> Option<&str> {
        let has = |command: &Command, id: &str| command.get_arguments().any(|known| known.get_id() == id);
        let mut ids = self.0.iter().map(|(id, _)| id.as_str());
        ids.find(|id| has(some, id) && !has(own, id))
    }

    /// The options and arguments that were typed after a verb of `command`, and the verb.
    pub(crate) fn of(command: &Command, matches: &ArgMatches) -> Self {
        let Some((verb, typed)) = matches.subcommand() else { return Self::default() };
        let known = command.find_subcommand(verb).into_iter().flat_map(Command::get_arguments);
        let counts =
            |id: &&str| typed.value_source(id) == Some(ValueSource::CommandLine) && !FREE.contains(id);
        let ids = known.map(|argument| argument.get_id().as_str()).filter(counts);
        let given = ids.map(|id| (id.to_owned(), values(typed, id)));
        Self(given.chain([(verb.to_owned(), Vec::new())]).collect())
    }
}

/// The values that were typed after an option; of an output its ending only.
fn values(typed: &ArgMatches, id: &str) -> Vec<OsString> {
    let values = typed.get_raw(id).into_iter().flatten();
    let kept = |value: &OsStr| match id {
        "output" => Path::new(value).extension().unwrap_or_default().to_owned(),
        _ => value.to_owned(),
    };
    values.map(kept).collect()
}
