//! Included files: found beside the file that names them, no deeper than a limit, never in a circle.

use std::collections::HashMap;
use std::rc::Rc;

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::{decode, short};

use radiosity_photometry::files::Files;

/// Most files that are open at once: scenes have a few in one another, and files that include themselves end
/// here.
const DEEPEST: usize = 32;

/// The files that are open, the main one first, and the texts that were read.
pub(crate) struct Includes<'a> {
    files: &'a dyn Files,
    /// Names for messages and paths from the scene's folder.
    open: Vec<(String, String)>,
    texts: HashMap<String, Rc<str>>,
}

impl<'a> Includes<'a> {
    /// Includes of which only the main file is open, named `file` in messages.
    pub(crate) fn new(file: &str, files: &'a dyn Files) -> Self {
        let base = file.rsplit(['/', '\\']).next().unwrap_or(file);
        Self { files, open: vec![(file.to_owned(), base.to_owned())], texts: HashMap::new() }
    }

    /// Name of the innermost open file, for messages.
    pub(crate) fn current(&self) -> &str {
        self.open.last().map_or("", |(shown, _)| shown)
    }

    /// Names of all open files, for messages.
    pub(crate) fn open(&self) -> impl Iterator<Item = &str> {
        self.open.iter().map(|(shown, _)| &**shown)
    }

    /// Name of the innermost open file, if it is an included one.
    pub(crate) fn included(&self) -> Option<&str> {
        (self.open.len() > 1).then(|| self.current())
    }

    /// Path from the scene's folder of a file named `name` by the innermost open file, relative to its own
    /// folder.
    pub(crate) fn beside(&self, name: &str) -> String {
        let current = self.open.last().map_or("", |(_, path)| path);
        let folder = current.rfind('/').map_or("", |end| &current[..=end]);
        normal(&format!("{folder}{name}"))
    }

    /// Whether there is a file at `path` from the scene's folder.
    pub(crate) fn has(&self, path: &str) -> bool {
        self.texts.contains_key(&normal(path)) || self.files.has(&normal(path))
    }

    /// Opens the file at `path` from the scene's folder and returns its text.
    ///
    /// # Errors
    /// A file that is open already, is missing, is no text, or is nested too deep.
    pub(crate) fn enter(&mut self, path: &str) -> Result<Rc<str>, Refusal> {
        let path = normal(path);
        if self.open.iter().any(|(_, open)| *open == path) {
            return refuse(format!("'{}' includes itself", short(&path)), "take one include out");
        }
        if self.open.len() >= DEEPEST {
            return refuse(
                format!("files are included in one another more than {DEEPEST} deep"),
                "join some of them",
            );
        }
        let text = self.text(&path)?;
        self.open.push((path.clone(), path));
        Ok(text)
    }

    /// Closes the innermost open file.
    pub(crate) fn leave(&mut self) {
        self.open.pop();
    }

    fn text(&mut self, path: &str) -> Result<Rc<str>, Refusal> {
        if let Some(text) = self.texts.get(path) {
            return Ok(text.clone());
        }
        let bytes = self.files.bytes(path).map_err(|error| {
            let what = format!("the included file '{}'", short(path));
            error.refusal(&what, "put it beside the scene, or take the include out")
        })?;
        let text: Rc<str> = decode(&bytes)
            .map_err(|fault| {
                Refusal::new(format!("the included file '{}': {}", short(path), fault.cause), fault.cure)
            })?
            .into();
        self.texts.insert(path.to_owned(), text.clone());
        Ok(text)
    }
}

/// `path` with slashes, without `.` and without folders that `..` leaves again.
fn normal(path: &str) -> String {
    let path = path.replace('\\', "/");
    let mut parts: Vec<&str> = Vec::new();
    for (index, part) in path.split('/').enumerate() {
        match part {
            "." => {}
            "" if index > 0 => {}
            ".." if parts.last().is_some_and(|last| *last != ".." && !last.is_empty()) => {
                parts.pop();
            }
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_told_in_one_way() {
        let told = [
            ("a.mgf", "a.mgf"),
            ("./a.mgf", "a.mgf"),
            ("b/../a.mgf", "a.mgf"),
            ("b\\c//d/./e", "b/c/d/e"),
            ("../../a", "../../a"),
            ("/etc/a", "/etc/a"),
        ];
        for (path, expected) in told {
            assert_eq!(normal(path), expected);
        }
    }
}
