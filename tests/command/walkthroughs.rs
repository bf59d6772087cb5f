//! The README and the pages that lead from nothing to a result: their marked commands are run as they stand,
//! and print what the pages say.
//!
//! A mark stands below its command: `<!-- run -->`, or `<!-- output, shown -->` … `<!-- end -->` around what
//! it prints, or `<!-- drawn -->` where a picture takes too long for a test, and is drawn where pages are
//! written only. A block below `<!-- file NAME -->` is a file that the page has its reader write. With
//! `WRITE_DOCUMENTS=1` the tests write what is printed, and the pictures that are drawn, into the pages
//! instead:
//!
//! ```text
//! WRITE_DOCUMENTS=1 cargo test --release --test command walkthroughs
//! ```

use std::env;
use std::fs;
use std::os::unix::fs::symlink;
use std::path::Path;
use std::process::{Command, Stdio};

use tempfile::TempDir;

const FILE: &str = "<!-- file ";
const RUN: &str = "<!-- run -->";
const DRAWN: &str = "<!-- drawn -->";
const SHOWN: &str = "<!-- output, shown -->";
const END: &str = "<!-- end -->";

/// Relative difference of numbers that counts as none: what processors and C libraries round differently.
const ROUNDING: f64 = 1e-6;
/// Numbers below it are roundings themselves.
const NOTHING: f64 = 1e-9;

#[test]
fn the_readme_says_what_its_commands_print() {
    follow("README.md");
}

#[test]
fn a_room_in_lux_is_walked_through() {
    follow("docs/room.md");
}

#[test]
fn an_enclosure_in_watts_is_walked_through() {
    follow("docs/enclosure.md");
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Whether pages are written anew, not compared.
fn is_written() -> bool {
    env::var_os("WRITE_DOCUMENTS").is_some()
}

/// Does what a page says, in a folder where nothing is but what comes with the sources, and what the page has
/// its reader write.
fn follow(page: &str) {
    let place = root().join(page);
    let text = fs::read_to_string(&place).expect("the page is there");
    let unmarked: Vec<&str> = unmarked(&text).collect();
    assert!(unmarked.is_empty(), "{page}: commands on lines of their own without a mark: {unmarked:?}");
    let folder = tempfile::tempdir().expect("a folder");
    symlink(root().join("examples"), folder.path().join("examples")).expect("a link");
    fs::create_dir(folder.path().join("docs")).expect("a folder");
    let fresh = followed(&text, &folder);
    let pictures: Vec<&str> = pictures(&text).filter(|name| folder.path().join(name).exists()).collect();
    assert!(!fresh.1.is_empty(), "{page} has commands");
    if is_written() {
        fs::write(&place, fresh.0).expect("the page can be written");
        for name in pictures {
            fs::copy(folder.path().join(name), place.with_file_name(name)).expect("pictures can be written");
        }
        return;
    }
    for Output { command, said, printed } in fresh.1 {
        assert!(agree(&said, &printed), "{page}: '{command}' prints\n{printed}\nand not\n{said}\n{}", cure());
    }
}

fn cure() -> &'static str {
    "`WRITE_DOCUMENTS=1 cargo test --release --test command walkthroughs` writes it into the page"
}

/// The output of a command as a page has it, and as it is.
struct Output {
    command: String,
    said: String,
    printed: String,
}

/// The page with what its commands print, and all of that.
fn followed(text: &str, folder: &TempDir) -> (String, Vec<Output>) {
    let is_run = |mark: &str| mark == RUN || mark == DRAWN && is_written();
    let (mut fresh, mut outputs) = (String::new(), Vec::new());
    let mut command = None;
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        fresh += &format!("{line}\n");
        command = last_command(line).or(command);
        let mark = line.trim();
        if let Some(name) = mark.strip_prefix(FILE).and_then(|rest| rest.strip_suffix(" -->")) {
            fs::write(folder.path().join(name), block(lines.clone())).expect("files can be written");
        }
        if is_run(mark) {
            printed(command.as_deref().expect("a command stands above its mark"), folder.path());
        }
        if mark == SHOWN {
            let command = command.clone().expect("a command stands above its mark");
            let said = lines.by_ref().take_while(|line| line.trim() != END).collect::<Vec<_>>().join("\n");
            let printed = printed(&command, folder.path());
            let pasted = printed.lines().map(|line| format!("    {line}").trim_end().to_owned() + "\n");
            fresh += &format!("\n{}\n{END}\n", pasted.collect::<String>());
            outputs.push(Output { command, said, printed });
        }
    }
    (fresh, outputs)
}

/// Commands that fill a line, below which no mark stands.
fn unmarked(text: &str) -> impl Iterator<Item = &str> {
    let is_whole = |line: &str| line.starts_with('`') && line.ends_with('`') && last_command(line).is_some();
    let below = text.lines().skip(1).chain([""]);
    let unmarked =
        text.lines().zip(below).filter(move |(line, below)| is_whole(line) && !below.starts_with("<!--"));
    unmarked.map(|(line, _)| line)
}

/// Text of the next block between fences.
fn block<'a>(lines: impl Iterator<Item = &'a str>) -> String {
    let inside = lines.skip_while(|line| !line.starts_with("```")).skip(1);
    inside.take_while(|line| !line.starts_with("```")).map(|line| format!("{line}\n")).collect()
}

/// The last command that a line has in back-quotes.
fn last_command(line: &str) -> Option<String> {
    let quoted = line.split('`').skip(1).step_by(2);
    let commands = quoted.filter_map(|part| {
        let typed = part.strip_prefix("cargo run -qr -- ").or(part.strip_prefix("radiosity "))?;
        Some(format!("radiosity {typed}"))
    });
    commands.last()
}

/// Output of a command in `folder`.
fn printed(command: &str, folder: &Path) -> String {
    let binaries = Path::new(env!("CARGO_BIN_EXE_radiosity")).parent().expect("the binary lies in a folder");
    let path = env::join_paths(
        [binaries.to_owned()].into_iter().chain(env::split_paths(&env::var_os("PATH").unwrap_or_default())),
    );
    let mut shell = Command::new("bash");
    shell.args(["-o", "pipefail", "-c", command]).env("PATH", path.expect("a path")).current_dir(folder);
    let output = shell.stdin(Stdio::null()).output().expect("there is a shell");
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "'{command}' fails: {complaint}");
    String::from_utf8(output.stdout).expect("text")
}

/// The pictures that a page shows.
fn pictures(text: &str) -> impl Iterator<Item = &str> {
    text.split("![").skip(1).filter_map(|rest| rest.split_once("](")?.1.split(')').next())
}

/// Whether two outputs say the same: equal words, and numbers that agree to rounding, but for those of
/// seconds.
fn agree(said: &str, printed: &str) -> bool {
    let [said, printed] = [said, printed].map(|text| {
        text.split(|c: char| c.is_whitespace() || c == ',')
            .filter(|word| !word.is_empty())
            .collect::<Vec<_>>()
    });
    let is_time = |index: usize| said.get(index + 1).is_some_and(|unit| *unit == "s");
    let mut pairs = said.iter().zip(&printed).enumerate();
    said.len() == printed.len() && pairs.all(|(k, (said, printed))| is_time(k) || same(said, printed))
}

fn same(said: &str, printed: &str) -> bool {
    match (said.parse::<f64>(), printed.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= ROUNDING * a.abs().max(b.abs()) + NOTHING,
        _ => said == printed,
    }
}
