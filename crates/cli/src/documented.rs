//! docs/command.md: verbs and options as the command has them.
//!
//! What is above the mark is written by hand, what is below it follows from the command:
//!
//! ```text
//! WRITE_DOCUMENTS=1 cargo test --release -p radiosity-cli documented
//! ```

mod python;

use std::{env, fs};

use clap::{Arg, Args, Command, CommandFactory, FromArgMatches};
use radiosity_request::MethodRequest;
use radiosity_solve::Options;
use radiosity_work::ranks::Ranks;

use crate::Cli;
use crate::options::SceneArg;

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/command.md");
const MARK: &str =
    "<!-- from here on made by `WRITE_DOCUMENTS=1 cargo test --release -p radiosity-cli documented` -->";
/// Heading of the options of [`SceneArg`], which have none in the help.
const SCENE: &str = "The scene";

#[test]
fn the_page_has_the_options_of_the_command() {
    let page = fs::read_to_string(PAGE).expect("the page is there");
    let (by_hand, _) = page.split_once(MARK).expect("the page has its mark");
    assert_made(PAGE, &format!("{by_hand}{MARK}\n\n{}", made_of(Cli::command())));
}

/// Checks that a file holds this text; writes it instead where `WRITE_DOCUMENTS` asks for that.
#[track_caller]
fn assert_made(file: &str, fresh: &str) {
    if env::var_os("WRITE_DOCUMENTS").is_some() {
        fs::write(file, fresh).expect("the file can be written");
        return;
    }
    let held = fs::read_to_string(file).expect("the file is there");
    let differing = held.lines().zip(fresh.lines()).find(|(old, new)| old != new);
    let cure = "`WRITE_DOCUMENTS=1 cargo test --release -p radiosity-cli documented` mends it";
    assert_eq!(differing, None, "{file}: {cure}");
    assert_eq!(held.lines().count(), fresh.lines().count(), "{file}: {cure}");
}

/// The defaults that the help states are those of the library: typed, they change no option.
#[test]
fn defaults_are_true() {
    let command = MethodRequest::augment_args(Command::new("method"));
    let options = |request: &MethodRequest| {
        let options = Options { memory: None, ..request.options(Ranks::alone()) };
        format!("{options:?}")
    };
    let usual = options(&MethodRequest::default());
    let mut stated = 0;
    for arg in command.get_arguments() {
        let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
        let Some((_, default)) = help.split_once("[default: ") else { continue };
        let value = default.trim_end_matches(']').split(';').next().unwrap_or_default();
        let typed = format!("--{}={value}", arg.get_long().expect("options are long"));
        // Typed, --eps is the accuracy of shadows as well where that is not typed.
        let typed = ["method", &typed, "--shadow-eps=3e-3"];
        // Defaults that follow from the scene or the machine are words.
        let Ok(matches) = command.clone().try_get_matches_from(typed) else { continue };
        let request = MethodRequest::from_arg_matches(&matches).expect("what is typed is read");
        assert_eq!(options(&request), usual, "--{} {value}", arg.get_id());
        stated += 1;
    }
    assert!(stated > 15, "{stated} defaults");
}

/// Options under one heading.
#[derive(Clone)]
struct Group {
    heading: String,
    rows: Vec<String>,
}

/// The part of the page that follows from the command.
fn made_of(mut command: Command) -> String {
    command.build();
    let verbs: Vec<&Command> = command.get_subcommands().filter(|verb| verb.get_name() != "help").collect();
    let groups: Vec<Vec<Group>> = verbs.iter().map(|verb| groups(verb)).collect();
    let shared = shared(&groups);
    let mut text = String::from("## Verbs\n\n| verb | |\n| --- | --- |\n");
    for verb in &verbs {
        text += &format!("| [`{0}`](#{0}) | {1} |\n", verb.get_name(), about(verb));
    }
    for (verb, groups) in verbs.iter().zip(&groups) {
        text += &described(verb, groups, &shared);
    }
    text += "\n## Options that several verbs have\n";
    for Group { heading, rows } in &shared {
        text += &format!("\n### {heading}\n\n{}", table(rows));
    }
    text
}

/// A verb with its own options, and the names of the groups that it shares.
fn described(verb: &Command, groups: &[Group], shared: &[Group]) -> String {
    let usage = verb.clone().render_usage().to_string();
    let usage = usage.trim_start_matches("Usage:").trim().to_owned();
    let mut text = format!("\n## {}\n\n{}.\n\n    {usage}\n", verb.get_name(), about(verb));
    let (mut links, mut without) = (Vec::new(), Vec::new());
    for Group { heading, rows } in groups {
        let common = under(shared, heading).map(|group| &group.rows);
        let own: Vec<String> =
            rows.iter().filter(|row| !common.is_some_and(|rows| rows.contains(row))).cloned().collect();
        if !own.is_empty() {
            let title = if heading.is_empty() { String::new() } else { format!("\n**{heading}**\n") };
            text += &format!("{title}\n{}", table(&own));
        }
        let Some(common) = common else { continue };
        if own.len() < rows.len() {
            links.push(format!("[{heading}](#{})", heading.to_lowercase().replace(' ', "-")));
            let is_there = |row: &&String| rows.iter().any(|other| option(other) == option(row));
            without.extend(common.iter().filter(|row| !is_there(row)).map(|row| option(row).to_owned()));
        }
    }
    text += &also(&links, &without);
    text + &notes(verb)
}

/// The sentence on groups of options that stand elsewhere.
fn also(links: &[String], without: &[String]) -> String {
    if links.is_empty() {
        return String::new();
    }
    let but = if without.is_empty() { String::new() } else { format!(", without {}", without.join(", ")) };
    format!("\nAnd the options of {}{but}.\n", links.join(", "))
}

/// The groups that two verbs or more have, as the first of these has them.
fn shared(groups: &[Vec<Group>]) -> Vec<Group> {
    let mut shared: Vec<Group> = Vec::new();
    for group in groups.iter().flatten().filter(|group| !group.heading.is_empty()) {
        let holders = groups.iter().filter(|other| under(other, &group.heading).is_some()).count();
        if holders > 1 && under(&shared, &group.heading).is_none() {
            shared.push(group.clone());
        }
    }
    shared
}

/// The group under a heading.
fn under<'a>(groups: &'a [Group], heading: &str) -> Option<&'a Group> {
    groups.iter().find(|group| group.heading == heading)
}

/// The options of a verb; those of no heading come first.
fn groups(verb: &Command) -> Vec<Group> {
    let of_scenes = SceneArg::augment_args(Command::new("scene"));
    let is_of_scene = |arg: &Arg| of_scenes.get_arguments().any(|other| other.get_id() == arg.get_id());
    let mut groups = vec![Group { heading: String::new(), rows: Vec::new() }];
    let told = |arg: &&Arg| !arg.is_hide_set() && !["help", "version"].contains(&arg.get_id().as_str());
    for arg in verb.get_arguments().filter(told) {
        let usual = if is_of_scene(arg) { SCENE } else { "" };
        let heading = arg.get_help_heading().unwrap_or(usual);
        match groups.iter_mut().find(|group| group.heading == heading) {
            Some(group) => group.rows.push(row(arg)),
            None => groups.push(Group { heading: heading.to_owned(), rows: vec![row(arg)] }),
        }
    }
    groups
}

/// The row of an option: how it is typed, and what it says.
fn row(arg: &Arg) -> String {
    let short = arg.get_short().map(|short| format!("`-{short}`, ")).unwrap_or_default();
    let typed = arg.to_string().replace('|', "\\|");
    let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
    let values = arg.get_possible_values();
    let is_flag = !arg.get_action().takes_values();
    let listed = values.iter().filter(|value| !is_flag && !value.is_hide_set()).map(|value| {
        let help = value.get_help().map(|help| format!(": {help}")).unwrap_or_default();
        format!("<br>`{}`{help}", value.get_name())
    });
    let usual: Vec<String> =
        arg.get_default_values().iter().map(|value| format!("`{}`", value.to_string_lossy())).collect();
    let usual = match usual.is_empty() || is_flag {
        true => String::new(),
        false => format!(" [default: {}]", usual.join(", ")),
    };
    let text = format!("{help}{usual}{}", listed.collect::<String>());
    format!("| {short}`{typed}` | {} |", text.replace('|', "\\|").replace('\n', " "))
}

/// The option of a row.
fn option(row: &str) -> &str {
    row.trim_start_matches("| ").split(" |").next().unwrap_or(row)
}

fn table(rows: &[String]) -> String {
    format!("| option | meaning |\n| --- | --- |\n{}\n", rows.join("\n"))
}

fn about(verb: &Command) -> String {
    verb.get_about().map(ToString::to_string).unwrap_or_default().trim_end_matches('.').to_owned()
}

/// Text below the options: examples and notes.
fn notes(verb: &Command) -> String {
    let Some(notes) = verb.get_after_help() else { return String::new() };
    let lines = notes.to_string();
    let lines = lines.lines().map(|line| match line.strip_prefix("  ") {
        Some(example) => format!("    {example}\n"),
        None if line.starts_with("Example") => format!("{line}\n\n"),
        None => format!("{line}\n"),
    });
    format!("\n{}", lines.collect::<String>())
}
