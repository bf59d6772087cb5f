//! Makes the figures, tables and outputs of documents anew, each by the command that the text names.
//!
//! `cargo run --release --example refresh -- [FILE] [PART OF A COMMAND]` (README.md, all commands). What may be made anew stands
//! between two marks, and is what the nearest command above it prints on its standard output:
//!
//! ```text
//! … Error against time: `cargo run --release --example read_off`.
//! <!-- output -->
//! | … |
//! <!-- end -->
//! ```
//!
//! A command stands in back-quotes, or alone in an indented line, and begins with `cargo`. `<!-- output, shown -->` indents what is
//! printed by four blanks, so that it stays as it is; `<!-- run -->`, without an end, runs the command for the files it writes. A
//! command that fails leaves its place as it was. Commands run one after another, in the root of the repository.

#![expect(clippy::print_stderr, reason = "progress for people")]

use std::io::{Error, Result};
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;
use std::{env, fs};

const RUN: &str = "<!-- run -->";
const OUTPUT: &str = "<!-- output -->";
const SHOWN: &str = "<!-- output, shown -->";
const END: &str = "<!-- end -->";

fn main() -> Result<ExitCode> {
    let mut arguments = env::args().skip(1);
    let file = arguments.next().unwrap_or_else(|| "README.md".to_owned());
    let part = arguments.next().unwrap_or_default();
    let text = fs::read_to_string(&file)?;
    let mut failed = Vec::new();
    let made = refreshed(&text, |command| {
        let wanted = command.contains(&part);
        wanted.then(|| output(command)).and_then(|made| made.map_err(|why| failed.push(why)).ok())
    })?;
    fs::write(&file, made)?;
    failed.iter().for_each(|why| eprintln!("{why}"));
    Ok(if failed.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The text with what stands between marks replaced; what `run` does not give stays.
fn refreshed(text: &str, mut run: impl FnMut(&str) -> Option<String>) -> Result<String> {
    let (mut made, mut command) = (String::new(), None);
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        made += &format!("{line}\n");
        command = last_command(line).or(command);
        let mark = line.trim();
        if ![RUN, OUTPUT, SHOWN].contains(&mark) {
            continue;
        }
        let named =
            command.as_deref().ok_or_else(|| Error::other(format!("no command stands before {mark}")))?;
        let fresh = run(named);
        if mark == RUN {
            continue;
        }
        let old: Vec<&str> = lines.by_ref().take_while(|line| line.trim() != END).collect();
        made += &fresh.map_or_else(|| old.join("\n") + "\n", |fresh| pasted(&fresh, mark == SHOWN));
        made += &format!("{END}\n");
    }
    Ok(made)
}

/// The last command that a line of a document names.
fn last_command(line: &str) -> Option<String> {
    let quoted = line.split('`').skip(1).step_by(2).filter(|part| part.starts_with("cargo ")).last();
    let alone = line.strip_prefix("    ").filter(|line| line.starts_with("cargo "));
    quoted.or(alone).map(|command| command.split("  #").next().unwrap_or(command).trim().to_owned())
}

/// Blank lines around, so that tables and code are told from the marks.
fn pasted(output: &str, shown: bool) -> String {
    let blanks = if shown { "    " } else { "" };
    let line = |line: &str| if line.is_empty() { "\n".to_owned() } else { format!("{blanks}{line}\n") };
    format!("\n{}\n", output.trim_end().lines().map(line).collect::<String>())
}

/// What a command prints; its errors go to the terminal.
fn output(command: &str) -> std::result::Result<String, String> {
    eprintln!("{command}");
    let start = Instant::now();
    let ran = Command::new("sh").args(["-c", command]).stderr(Stdio::inherit()).output();
    let done = ran.map_err(|why| format!("'{command}' could not be run: {why}"))?;
    eprintln!("    {:.1} s", start.elapsed().as_secs_f64());
    if !done.status.success() {
        return Err(format!("'{command}' failed: {}", done.status));
    }
    String::from_utf8(done.stdout).map_err(|_| format!("'{command}' prints no text"))
}
