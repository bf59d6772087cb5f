//! The elements of a scene and of the files that it includes, with parameters filled in.

use std::cell::Cell;
use std::collections::HashMap;
use std::rc::Rc;

use radiosity_photometry::error::{Refusal, refuse};
use roxmltree::{Document, Error, Node, ParsingOptions};

use super::element::{Element, Sources};
use super::parameters::Parameters;
use crate::budget::Budget;
use crate::includes::Includes;
use crate::tolerances::{LONGEST_CAUSE, MOST_BYTES_OF_TEXT};
use radiosity_photometry::files::Files;

/// Most bytes of a file: a scene names its meshes, it does not hold them.
const LONGEST: usize = 1 << 26;

/// Most elements of a scene with its includes: two for each surface that a model may have.
const MOST_ELEMENTS: usize = 2_000_000;

/// Most elements in one another. Chosen: scenes have six.
const DEEPEST: usize = 64;

/// Most quotes in an element, since the time of reading them is quadratic: 500 attributes.
const MOST_QUOTES: usize = 1000;
/// Most prefixes of namespaces in a file, since the time of reading them is quadratic; scenes have none.
const MOST_PREFIXES: usize = 100;

/// The root element of the scene `file`, what it includes in the places of the includes.
///
/// # Errors
/// Text that is no XML, entities, parameters without values, files that cannot be included, too much of
/// anything.
pub(super) fn read(file: &str, text: &str, files: &dyn Files) -> Result<Element, Refusal> {
    let mut reader = Reader {
        includes: Includes::new(file, files),
        parameters: Parameters::default(),
        budget: Budget::default(),
        elements: 0,
        characters: 0,
        is_there: HashMap::new(),
    };
    reader.file(text, &[], 0)
}

/// Reader of a scene: parameters and counts up to the element that is read.
struct Reader<'a> {
    includes: Includes<'a>,
    parameters: Parameters,
    budget: Budget,
    elements: usize,
    characters: usize,
    /// Whether there is a file, by path.
    is_there: HashMap<String, bool>,
}

/// A file that is being read.
struct Source {
    name: Rc<str>,
    /// Bytes at which the lines of the file begin.
    lines: Vec<usize>,
    /// Whether the file is of Mitsuba 0, whose names are written in another way.
    is_old: bool,
    /// Folders that files are looked for in, seen from the scene's folder; the first that has one counts.
    folders: Vec<SearchedFolder>,
}

/// A folder that files are looked for in, and the files that name it.
#[derive(Clone)]
struct SearchedFolder {
    /// Its path from the scene's folder.
    path: String,
    sources: Sources,
}

impl Source {
    fn line(&self, node: Node<'_, '_>) -> usize {
        self.lines.partition_point(|line| *line <= node.range().start).max(1)
    }

    fn at(&self, node: Node<'_, '_>, fault: Refusal) -> Refusal {
        fault.in_line(&self.name, self.line(node))
    }
}

impl Reader<'_> {
    /// The root element of a file.
    fn file(&mut self, text: &str, outer: &[SearchedFolder], depth: usize) -> Result<Element, Refusal> {
        let name: Rc<str> = self.includes.current().into();
        check(text).and_then(|()| self.budget.spend(text.len())).map_err(|fault| fault.in_file(&name))?;
        let options = ParsingOptions { nodes_limit: 4 * MOST_ELEMENTS as u32, ..ParsingOptions::default() };
        let document = Document::parse_with_options(text, options).map_err(|error| refusal(&name, &error))?;
        let root = document.root_element();
        let ends = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
        let mut source = Source {
            name,
            lines: std::iter::once(0).chain(ends.map(|(at, _)| at + 1)).collect(),
            is_old: root.attribute("version").is_some_and(is_old),
            folders: std::iter::once(SearchedFolder {
                path: self.includes.beside("."),
                sources: Sources::new(),
            })
            .chain(outer.iter().cloned())
            .collect(),
        };
        self.element(root, &mut source, depth)
    }

    fn element(&mut self, node: Node<'_, '_>, source: &mut Source, depth: usize) -> Result<Element, Refusal> {
        if depth >= DEEPEST {
            let fault = Refusal::new(
                format!("elements are in one another more than {DEEPEST} deep"),
                "take some out",
            );
            return Err(source.at(node, fault));
        }
        let mut quoted = Sources::new();
        let attributes =
            self.attributes(node, source, &mut quoted).map_err(|fault| source.at(node, fault))?;
        let number = self.count(&attributes).map_err(|fault| source.at(node, fault))?;
        let mut children = Vec::new();
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "default" => self.parameter(child, source).map_err(|fault| source.at(child, fault))?,
                "path" => self.folder(child, source).map_err(|fault| source.at(child, fault))?,
                "include" => {
                    let included = self.include(child, source, depth + 1)?;
                    match included.tag == "scene" {
                        true => children.extend(included.children),
                        false => children.push(included),
                    }
                }
                _ => children.push(self.element(child, source, depth + 1)?),
            }
        }
        children.iter().for_each(|child: &Element| quoted.extend(child.quoted.iter().cloned()));
        Ok(Element {
            tag: tag(node, source),
            attributes,
            children,
            file: source.name.clone(),
            quoted,
            line: source.line(node),
            number,
            is_met: Cell::new(false),
        })
    }

    /// The attributes of an element: parameters filled in, the files of which are added to `quoted`, names of Mitsuba 0
    /// as they are now, files found.
    fn attributes(
        &mut self,
        node: Node<'_, '_>,
        source: &Source,
        quoted: &mut Sources,
    ) -> Result<Vec<(String, String)>, Refusal> {
        let is_file = node.attribute("name") == Some("filename");
        let mut attributes = Vec::new();
        for attribute in node.attributes() {
            let mut value = self.parameters.fill(attribute.value(), quoted)?.into_owned();
            match attribute.name() {
                "name" if source.is_old => value = snake(&value),
                "value" if is_file => value = self.found(&value, source, quoted),
                _ => {}
            }
            attributes.push((attribute.name().to_owned(), value));
        }
        Ok(attributes)
    }

    /// The number of a further element.
    fn count(&mut self, attributes: &[(String, String)]) -> Result<usize, Refusal> {
        self.elements += 1;
        self.characters += attributes.iter().map(|(name, value)| name.len() + value.len()).sum::<usize>();
        if self.elements > MOST_ELEMENTS || self.characters > MOST_BYTES_OF_TEXT {
            return refuse(
                format!("more than {MOST_ELEMENTS} elements or {MOST_BYTES_OF_TEXT} characters in them"),
                "join shapes to meshes (type=\"ply\")",
            );
        }
        Ok(self.elements)
    }

    fn parameter(&mut self, node: Node<'_, '_>, source: &Source) -> Result<(), Refusal> {
        let plain =
            Source { is_old: false, name: source.name.clone(), lines: Vec::new(), folders: Vec::new() };
        let mut sources = Sources::from([source.name.clone()]);
        let attributes = self.attributes(node, &plain, &mut sources)?;
        let value = |wanted: &str| attributes.iter().find(|(name, _)| name == wanted).map(|(_, value)| value);
        match (value("name"), value("value")) {
            (Some(name), Some(value)) => {
                let quoted = sources.clone();
                self.parameters.add(name, value, sources).map_err(|fault| fault.quoting(names(&quoted)))
            }
            _ => refuse("a <default> has no name or no value", "write <default name=\"…\" value=\"…\"/>"),
        }
    }

    /// A folder that files are looked for in before all others.
    fn folder(&mut self, node: Node<'_, '_>, source: &mut Source) -> Result<(), Refusal> {
        let Some(value) = node.attribute("value") else {
            return refuse("a <path> has no value", "write <path value=\"…\"/>");
        };
        if source.folders.len() > DEEPEST {
            return refuse(format!("more than {DEEPEST} folders"), "take a <path> out");
        }
        let mut sources = Sources::from([source.name.clone()]);
        let path = self.includes.beside(&self.parameters.fill(value, &mut sources)?);
        source.folders.insert(0, SearchedFolder { path, sources });
        Ok(())
    }

    /// The path of a file seen from the scene's folder: in the first folder that has it, or in the first of
    /// all. The files that name this folder are added to `quoted`.
    fn found(&mut self, name: &str, source: &Source, quoted: &mut Sources) -> String {
        let path = |folder: &SearchedFolder| match folder.path.is_empty() {
            true => name.to_owned(),
            false => format!("{}/{name}", folder.path),
        };
        let mut paths: Vec<String> = source.folders.iter().map(path).collect();
        let mut is_there = |path: &String| match self.is_there.get(path) {
            Some(is_there) => *is_there,
            None => *self.is_there.entry(path.clone()).or_insert(self.includes.has(path)),
        };
        // One folder alone is not looked into.
        let known = if paths.len() > 1 { paths.iter().position(&mut is_there) } else { None };
        let first = known.unwrap_or(0);
        quoted.extend(source.folders[first].sources.iter().cloned());
        paths.swap_remove(first)
    }

    fn include(&mut self, node: Node<'_, '_>, source: &Source, depth: usize) -> Result<Element, Refusal> {
        let mut quoted = Sources::new();
        let mut enter = |reader: &mut Self| {
            let Some(name) = node.attribute("filename") else {
                return refuse("an <include> names no file", "write filename=\"…\" in it");
            };
            reader.budget.spend_on_include()?;
            let name = reader.parameters.fill(name, &mut quoted)?.into_owned();
            let path = reader.found(&name, source, &mut quoted);
            reader.includes.enter(&path)
        };
        let text = enter(self);
        let text = text.map_err(|fault| source.at(node, fault.quoting(names(&quoted))))?;
        let included = self.file(&text, &source.folders, depth)?;
        self.includes.leave();
        Ok(included)
    }
}

/// The names of files, for refusals.
fn names(files: &Sources) -> impl Iterator<Item = &str> {
    files.iter().map(|own| &**own)
}

/// Refuses what would take long to read.
fn check(text: &str) -> Result<(), Refusal> {
    if text.len() > LONGEST {
        return refuse(
            format!("the scene is longer than {LONGEST} bytes"),
            "put its meshes into files of their own",
        );
    }
    let is_tag = |part: &&str| !part.starts_with(['!', '?']);
    let quotes = |part: &str| part.bytes().filter(|byte| matches!(byte, b'"' | b'\'')).count();
    if text.split('<').filter(is_tag).any(|part| quotes(part) > MOST_QUOTES) {
        return refuse(format!("an element has more than {MOST_QUOTES} quotes"), "take some out");
    }
    if text.matches("xmlns:").count() > MOST_PREFIXES {
        return refuse(
            format!("more than {MOST_PREFIXES} namespaces are declared"),
            "take them out: Mitsuba has none",
        );
    }
    Ok(())
}

/// Refusal of a text that is no XML.
fn refusal(file: &str, error: &Error) -> Refusal {
    let (cause, cure) = match error {
        Error::DtdDetected => ("the file declares its own entities (<!DOCTYPE …>)".to_owned(), {
            "write their texts in their places, or use <default> and $name"
        }),
        Error::NodesLimitReached | Error::AttributesLimitReached => {
            ("the file has too many elements".to_owned(), "join shapes to meshes (type=\"ply\")")
        }
        _ => {
            let message = error.to_string();
            let message = message.rsplit_once(" at ").map_or(message.as_str(), |(message, _)| message);
            let message: String = message.chars().take(LONGEST_CAUSE).collect();
            (format!("this is no XML: {message}"), "correct it, or name its format")
        }
    };
    Refusal::new(cause, cure).in_line(file, error.pos().row as usize)
}

/// Whether a version is below 2, and so of Mitsuba 0.
fn is_old(version: &str) -> bool {
    let major = version.trim().split('.').next().unwrap_or_default();
    major.parse::<u32>().is_ok_and(|major| major < 2)
}

fn tag(node: Node<'_, '_>, source: &Source) -> String {
    let tag = node.tag_name().name();
    if source.is_old { tag.to_ascii_lowercase() } else { tag.to_owned() }
}

/// `toWorld` as it is written since Mitsuba 2: `to_world`.
fn snake(name: &str) -> String {
    let mut snake = String::with_capacity(name.len() + 4);
    for c in name.chars() {
        if c.is_ascii_uppercase() && snake.ends_with(|last: char| last.is_ascii_lowercase()) {
            snake.push('_');
        }
        snake.push(c.to_ascii_lowercase());
    }
    snake
}

#[cfg(test)]
mod tests {
    use radiosity_photometry::file_place::FilePlace;

    use super::*;

    #[test]
    fn names_of_mitsuba_0_are_told_as_now() {
        assert_eq!(
            ["toWorld", "fovAxis", "radius", "uOffset"].map(snake),
            ["to_world", "fov_axis", "radius", "u_offset"]
        );
        assert!(is_old("0.6.0") && is_old("1.0.0") && !is_old("2.0.0") && !is_old("3.5") && !is_old("x"));
    }

    #[test]
    fn messages_of_short_words_name_what_is_wrong() {
        let error = Document::parse("<a>\n<b></a>").expect_err("the tags are crossed");
        let refusal = refusal("a.xml", &error);
        assert!(refusal.cause.starts_with("this is no XML") && refusal.cause.contains("'b'"), "{refusal}");
        assert_eq!(refusal.place, Some(FilePlace::Line(2)));
    }
}
