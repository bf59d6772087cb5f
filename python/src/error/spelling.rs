//! Options and verbs in messages as Python has them: `--shadow-eps 1e-3` is `shadow_eps=1e-3`, ``
//! `radiosity scenes` `` a function.

use radiosity::work::wording::{Part, Wording};

/// Options whose arguments have another name: `for` and `from` are words of the language.
const RENAMED: [(&str, &str); 2] = [("for", "aim"), ("from", "format")];

/// Verbs that are functions here.
const FUNCTIONS: [(&str, &str); 3] = [
    ("scenes", "radiosity.builtins()"),
    ("view-factors", "radiosity.view_factors(…)"),
    ("heat", "Scene.heat(…)"),
];

/// The sentence for those who call functions.
pub(crate) fn spelt(wording: &Wording) -> String {
    wording.spelt(|part| match part {
        Part::Text(text) => text.clone(),
        Part::Option { name, value } => argument(name, value.as_deref()),
        Part::Value(name) => format!("{name:?}"),
        Part::Command(verb) => function(verb),
    })
}

/// An option as an argument, with what it is set to.
fn argument(option: &str, value: Option<&str>) -> String {
    let renamed = RENAMED.iter().find(|(own, _)| *own == option);
    let name = renamed.map_or_else(|| option.replace('-', "_"), |(_, name)| (*name).to_owned());
    match (option, value) {
        (_, None) => format!("{name}="),
        ("plane", _) => "plane(origin, u, v, spacing)".to_owned(),
        ("set", Some(setting)) => match setting.split_once('=') {
            Some((variable, number)) => format!("set={{{variable:?}: {number}}}"),
            None => format!("set={setting}"),
        },
        (_, Some(value)) if value.parse::<f64>().is_ok() => format!("{name}={value}"),
        (_, Some(value)) => format!("{name}={value:?}"),
    }
}

/// A verb as a function; those that are none stay verbs of the command.
fn function(verb: &str) -> String {
    let own = FUNCTIONS.iter().find(|(own, _)| *own == verb);
    own.map_or_else(|| format!("the command `radiosity {verb}`"), |(_, function)| format!("`{function}`"))
}
