//! python/radiosity/options.py: the options that functions of Python take, as the command has them.

use std::{env, fs};

use clap::{Arg, Args, Command};
use radiosity_request::{HeatRequest, ImportRequest, MethodRequest, ReadRequest, TransferRequest};

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

/// Type of an option, for people and in Python.
struct Kind {
    told: String,
    annotation: String,
}

impl Kind {
    fn of(told: &str, annotation: &str) -> Self {
        Self { told: told.to_owned(), annotation: annotation.to_owned() }
    }
}

#[test]
fn the_options_of_python_are_those_of_the_command() {
    let fresh = HEAD.to_owned() + &classes().iter().map(Class::text).collect::<String>();
    if env::var_os("WRITE_DOCUMENTS").is_some() {
        fs::write(FILE, fresh).expect("the file can be written");
        return;
    }
    let file = fs::read_to_string(FILE).expect("the file is there");
    let differing = file.lines().zip(fresh.lines()).find(|(old, new)| old != new);
    let cure = "`WRITE_DOCUMENTS=1 cargo test --release -p radiosity-cli documented` mends options.py";
    assert_eq!(differing, None, "{cure}");
    assert_eq!(file.lines().count(), fresh.lines().count(), "{cure}");
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
            name: "Reading",
            base: "TypedDict",
            about: "How light is read.",
            options: together([of::<ReadRequest>(&[], ""), threads()]),
        },
        Class {
            name: "Cells",
            base: "Reading",
            about: "How means over cells are read: the options of `Reading`, and these.",
            options: together([of::<GridArgs>(&["read_samples"], ""), memory()]),
        },
        Class {
            name: "Picture",
            base: "TypedDict",
            about: "How a picture is taken.",
            options: together([of::<RenderArgs>(&["read", "show", "samples"], ""), memory(), threads()]),
        },
        Class {
            name: "Transfers",
            base: "TypedDict",
            about: "How transfers are integrated.",
            options: of::<TransferRequest>(&[], ""),
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

/// A truth value that Python alone takes so.
fn flag(name: &str, help: &str) -> PythonOption {
    PythonOption { name: name.to_owned(), kind: Kind::of("bool", "bool"), help: help.to_owned() }
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
        help: match help {
            "" => in_python(&arg.get_help().map(ToString::to_string).unwrap_or_default()),
            help => help.to_owned(),
        },
    };
    command.get_arguments().filter(is_taken).map(option).collect()
}

/// The type of an option, by the texts that it accepts.
fn kind(arg: &Arg) -> Kind {
    let accepts = |text: &str| {
        let typed = format!("--{}={text}", arg.get_long().expect("options are long"));
        Command::new("one").arg(arg.clone()).try_get_matches_from(["one", &typed]).is_ok()
    };
    let names: Vec<String> =
        arg.get_possible_values().iter().map(|value| format!("{:?}", value.get_name())).collect();
    match names.split_last() {
        _ if !arg.get_action().takes_values() => Kind::of("bool", "bool"),
        // Solvers have other names besides.
        _ if arg.get_id() == "solver" => Kind::of("str", "str"),
        Some((last, [])) => Kind::of(last, &format!("Literal[{last}]")),
        Some((last, others)) => {
            Kind::of(&format!("{} or {last}", others.join(", ")), &format!("Literal[{}]", names.join(", ")))
        }
        None if accepts("any/text") => Kind::of("str or a path", "str | os.PathLike[str]"),
        None if accepts("0.5") => Kind::of("float", "float"),
        None if accepts("2G") => Kind::of("int or str", "int | str"),
        None if accepts("auto") => Kind::of("int or \"auto\"", "int | Literal[\"auto\"]"),
        None if accepts("3") => Kind::of("int", "int"),
        None if accepts("4,2") => Kind::of("two int", "tuple[int, int]"),
        None => Kind::of("str", "str"),
    }
}

/// What an option says, with others as Python names them: `--read-eps` as `read_eps`, `--eps 1e-3` as
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
            text += &format!("\n    {name}: {}\n{}", kind.told, wrapped(&format!("{help}.")));
        }
        text += "    \"\"\"\n\n";
        for PythonOption { name, kind, .. } in options {
            text += &format!("    {name}: {}\n", kind.annotation);
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
