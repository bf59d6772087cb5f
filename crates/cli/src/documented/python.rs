//! python/radiosity/options.py: the options that functions of Python take, as the command has them.

use clap::builder::PossibleValue;
use clap::{Arg, Args, Command};
use radiosity_request::{
    AuditRequest, CheckRequest, HeatRequest, ImportRequest, MethodRequest, ReadRequest, TransferRequest,
};

use super::assert_made;
use crate::checkpoint::CheckpointArgs;
use crate::grid::GridArgs;
use crate::options::SceneArg;
use crate::render::RenderArgs;

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../python/radiosity/options.py");
const HEAD: &str = r#""""Options by name: those of the command, with `_` for `-`; see `radiosity solve --help`.

Each function says which of these it takes: `radiosity.load("room.toml").solve(order=5, eps=1e-4)` takes those of `Method`.

Made by `WRITE_DOCUMENTS=1 cargo test --release -p radiosity-cli documented`.
"""

from __future__ import annotations

import os
from typing import Literal, TypedDict
"#;

/// Help on the check of pictures, which are arrays alone in Python.
const AUDIT_OF_PICTURES: &str = "Seconds that about two threads take to check the pixels by path tracing, which warns of more than their errors tell [default: not checked]";

/// Longest line of Python, as ruff has it.
const WIDTH: usize = 132;

/// Options that one function or more of Python takes.
struct Class {
    name: &'static str,
    base: &'static str,
    about: &'static str,
    options: Vec<PythonOption>,
}

/// An option of Python: its name, its type, and what it says.
struct PythonOption {
    name: String,
    kind: Kind,
    help: String,
}

/// Type of an option.
enum Kind {
    /// One of these texts, in quotes.
    Values(Vec<String>),
    /// Any other: for people, and in Python.
    Of(&'static str, &'static str),
}

impl Kind {
    fn told(&self) -> String {
        match self {
            Self::Of(told, _) => (*told).to_owned(),
            Self::Values(values) => match values.split_last() {
                Some((last, others)) if !others.is_empty() => format!("{} or {last}", others.join(", ")),
                _ => values.concat(),
            },
        }
    }

    fn annotation(&self) -> String {
        match self {
            Self::Of(_, annotation) => (*annotation).to_owned(),
            Self::Values(values) => format!("Literal[{}]", values.join(", ")),
        }
    }
}

#[test]
fn the_options_of_python_are_those_of_the_command() {
    assert_made(FILE, &(HEAD.to_owned() + &classes().iter().map(Class::text).collect::<String>()));
}

fn classes() -> Vec<Class> {
    let threads = || {
        of::<MethodRequest>(&["threads"], "Threads to use (as the solution did); results do not depend on it")
    };
    let memory = || {
        of::<MethodRequest>(
            &["memory"],
            "Most bytes to use (as the solution did), a number or a text such as \"2G\"",
        )
    };
    let transfers = || of::<CheckpointArgs>(&["transfers"], "");
    let strict = "Refuses a scene of another program that needs repairs";
    let kept = "Takes the best there is where the solver does not converge, with a warning";
    let conductances = "Whether the conductances between all surfaces are wanted";
    vec![
        Class {
            name: "Import",
            base: "TypedDict",
            about: "How a scene is read.",
            options: together([
                of::<SceneArg>(&["frame", "tolerance_length"], ""),
                vec![flag("strict", strict)],
                of::<ImportRequest>(&[], ""),
            ]),
        },
        Class {
            name: "Method",
            base: "TypedDict",
            about: "How light is computed.",
            options: together([of::<MethodRequest>(&[], ""), vec![flag("keep_partial", kept)]]),
        },
        Class {
            name: "Solving",
            base: "Method",
            about: "How a scene is solved: the options of `Method`, and this.",
            options: together([of::<CheckRequest>(&[], ""), transfers()]),
        },
        Class {
            name: "Reading",
            base: "TypedDict",
            about: "How light is read.",
            options: together([of::<ReadRequest>(&[], ""), threads(), of::<CheckRequest>(&[], "")]),
        },
        Class {
            name: "Cells",
            base: "Reading",
            about: "How means over cells are read: the options of `Reading`, and these.",
            options: together([of::<GridArgs>(&["read_samples"], ""), memory()]),
        },
        Class {
            name: "Auditing",
            base: "TypedDict",
            about: "How light is read and judged.",
            options: together([of::<ReadRequest>(&[], ""), threads(), of::<AuditRequest>(&[], "")]),
        },
        Class {
            name: "Picture",
            base: "TypedDict",
            about: "How a picture is taken.",
            options: together([
                of::<RenderArgs>(&["read", "show", "samples"], ""),
                memory(),
                threads(),
                of::<CheckRequest>(&[], AUDIT_OF_PICTURES),
            ]),
        },
        Class {
            name: "Transfers",
            base: "TypedDict",
            about: "How transfers are integrated.",
            options: together([of::<TransferRequest>(&[], ""), of::<CheckRequest>(&[], ""), transfers()]),
        },
        Class {
            name: "HeatMethod",
            base: "Transfers",
            about: "How a balance of heat is computed: the options of `Transfers`, whose `eps` is then 1e-4, and these.",
            options: together([of::<HeatRequest>(&[], ""), vec![flag("conductances", conductances)]]),
        },
    ]
}

fn together<const N: usize>(parts: [Vec<PythonOption>; N]) -> Vec<PythonOption> {
    parts.into_iter().flatten().collect()
}

/// A truth value that the command states in another way.
fn flag(name: &str, help: &str) -> PythonOption {
    PythonOption { name: name.to_owned(), kind: Kind::Of("bool", "bool"), help: help.to_owned() }
}

/// The options of these names, or all, of a part of the command; they say `help` if it is not empty.
fn of<A: Args>(names: &[&str], help: &str) -> Vec<PythonOption> {
    let command = A::augment_args(Command::new("part"));
    let is_taken = |arg: &&Arg| {
        arg.get_id() != "for" && (names.is_empty() || names.iter().any(|name| arg.get_id() == *name))
    };
    let option = |arg: &Arg| PythonOption {
        name: if arg.get_id() == "from" { "format".to_owned() } else { arg.get_id().to_string() },
        kind: kind(arg),
        help: match told_apart(arg).unwrap_or(help) {
            "" => in_python(&arg.get_help().map(ToString::to_string).unwrap_or_default()),
            help => help.to_owned(),
        },
    };
    command.get_arguments().filter(is_taken).map(option).collect()
}

/// The text of an option whose help speaks of the command line.
fn told_apart(arg: &Arg) -> Option<&'static str> {
    Some(match arg.get_id().as_str() {
        "bounces" => {
            "Light that was reflected so many times at the most before it arrives: 0 for light straight from emitters [default: all]"
        }
        "columns" => {
            "With solver=\"southwell\", when a block column of the transfers is integrated [default: \"shot\"; \"all\" where rays carry the light, and wherever else the report says so]"
        }
        "shots" => {
            "Stops after so many shots of solver=\"southwell\" in each band and light group: the polynomials then hold what was shot and what has arrived [default: as many as `tolerance` takes]"
        }
        "mask_cells" => {
            "Cells of a shadow mask along each side, at the finest, with shadows=\"mask\" [default: 40]"
        }
        "quality" => {
            "Preset of order and accuracies, and of how finely points, planes and cells are read; single options go before it [default: \"default\"]"
        }
        "read_samples" => {
            "Points along each side of a cell at which direct and gathered light are computed [default: (4, 2); as `quality` says]; light is then gathered by cells"
        }
        "time_limit" => "Seconds after which rays end, and no finer run begins",
        _ => return None,
    })
}

/// Texts that some options accept alone, which list no values.
const TEXTS: [&str; 9] = ["mm", "cm", "dm", "m", "in", "ft", "yd", "y", "z"];

/// The type of an option, by the texts that it accepts.
fn kind(arg: &Arg) -> Kind {
    let accepts = |text: &str| {
        let typed = format!("--{}={text}", arg.get_long().expect("options are long"));
        Command::new("one").arg(arg.clone()).try_get_matches_from(["one", &typed]).is_ok()
    };
    let quoted = |texts: &mut dyn Iterator<Item = &str>| texts.map(|text| format!("{text:?}")).collect();
    let values = arg.get_possible_values();
    match () {
        () if !arg.get_action().takes_values() => Kind::Of("bool", "bool"),
        // Solvers have other names besides.
        () if arg.get_id() == "solver" => Kind::Of("str", "str"),
        () if !values.is_empty() => Kind::Values(quoted(&mut values.iter().map(PossibleValue::get_name))),
        () if accepts("any/text") => Kind::Of("str or a path", "str | os.PathLike[str]"),
        () if accepts("0.5") => Kind::Of("float", "float"),
        () if accepts("2G") => Kind::Of("int or str", "int | str"),
        () if accepts("auto") => Kind::Of("int or \"auto\"", "int | Literal[\"auto\"]"),
        () if accepts("3") => Kind::Of("int", "int"),
        () if accepts("4,2") => Kind::Of("two int", "tuple[int, int]"),
        () => Kind::Values(quoted(&mut TEXTS.into_iter().filter(|text| accepts(text)))),
    }
}

/// The text of an option, with others as Python names them: `--read-eps` as `read_eps`, `--eps 1e-3` as
/// `eps=1e-3`.
fn in_python(help: &str) -> String {
    let mut words: Vec<String> = Vec::new();
    let mut is_open = false;
    for word in help.split(' ') {
        let name = word.trim_start_matches('(').strip_prefix("--");
        let is_number = word.starts_with(|first: char| first.is_ascii_digit());
        match (name, words.last_mut()) {
            (None, Some(last)) if is_open && is_number => {
                *last = format!("{}={word}", last.trim_matches('`'))
            }
            (None, _) => words.push(word.to_owned()),
            (Some(name), _) => {
                let end =
                    name.find(|sign: char| !sign.is_ascii_lowercase() && sign != '-').unwrap_or(name.len());
                let (name, rest) = name.split_at(end);
                words.push(format!("`{}`{rest}", name.replace('-', "_")));
            }
        }
        is_open = name.is_some();
    }
    words.join(" ")
}

impl Class {
    fn text(&self) -> String {
        let Self { name, base, about, options } = self;
        let mut text = format!("\n\nclass {name}({base}, total=False):\n    \"\"\"{about}\n");
        for PythonOption { name, kind, help } in options {
            text += &format!("\n    {name}: {}\n{}", kind.told(), wrapped(&format!("{help}.")));
        }
        text += "    \"\"\"\n\n";
        for PythonOption { name, kind, .. } in options {
            text += &format!("    {name}: {}\n", kind.annotation());
        }
        text
    }
}

/// A text of lines that are indented twice.
fn wrapped(text: &str) -> String {
    let mut lines = vec!["       ".to_owned()];
    for word in text.split(' ') {
        let line = lines.last_mut().expect("there is a line");
        if line.chars().count() + 1 + word.chars().count() <= WIDTH {
            *line += &format!(" {word}");
        } else {
            lines.push(format!("        {word}"));
        }
    }
    lines.join("\n") + "\n"
}
