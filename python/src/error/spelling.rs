//! Options in messages, which the library calls as the command does, as arguments of Python: `--shadow-eps` is `shadow_eps=`.

/// What options may be set to by name, where a message says so.
const NAMES: [&str; 20] = [
    "auto",
    "basis",
    "block",
    "cells",
    "cg",
    "constant",
    "direct",
    "exact",
    "gather",
    "gathered",
    "gmres",
    "harmonic",
    "hierarchical",
    "legendre",
    "linear",
    "mask",
    "off",
    "projected",
    "rays",
    "sampled",
];

/// Options whose arguments have another name: `for` and `from` are words of the language.
const RENAMED: [(&str, &str); 2] = [("for", "aim"), ("from", "format")];

/// What the command is told in one text, and Python by a call.
const CALLS: [(&str, &str); 1] =
    [("--plane \"origin; edge; edge; spacing\"", "plane(origin, u, v, spacing)")];

/// The message with its options as arguments.
pub(super) fn spelt(message: &str) -> String {
    let message = CALLS.iter().fold(message.to_owned(), |text, (own, call)| text.replace(own, call));
    let mut parts = message.split("--");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_lowercase() && c != '-').unwrap_or(part.len());
        let (option, rest) = part.split_at(end);
        match option.is_empty() {
            true => text = text + "--" + rest,
            false => text += &argument(option, rest),
        }
    }
    text
}

/// An option and what follows it; where that is a value, it is set to it.
fn argument(option: &str, rest: &str) -> String {
    let renamed = RENAMED.iter().find(|(own, _)| *own == option).map(|(_, name)| (*name).to_owned());
    let name = renamed.unwrap_or_else(|| option.replace('-', "_"));
    let Some(after) = rest.strip_prefix(' ') else { return format!("{name}={rest}") };
    let end = after.find([' ', ',', ';', ':']).unwrap_or(after.len());
    let (value, rest) = after.split_at(end);
    if value.parse::<f64>().is_ok() {
        return format!("{name}={value}{rest}");
    }
    if let (true, Some((parameter, number))) = (option == "set", value.split_once('=')) {
        return format!("{name}={{{parameter:?}: {number}}}{rest}");
    }
    match NAMES.contains(&value) {
        true => format!("{name}={value:?}{}", other_value(rest).unwrap_or_else(|| rest.to_owned())),
        false => format!("{name}= {after}"),
    }
}

/// What follows a value, where it begins with another one.
fn other_value(rest: &str) -> Option<String> {
    let (joint, after) = ["or", "and"].iter().find_map(|joint| {
        let after = rest.strip_prefix(' ')?.strip_prefix(joint)?.strip_prefix(' ')?;
        Some((joint, after))
    })?;
    let end = after.find([' ', ',', ';', ':']).unwrap_or(after.len());
    let (value, rest) = after.split_at(end);
    NAMES.contains(&value).then(|| format!(" {joint} {value:?}{rest}"))
}
