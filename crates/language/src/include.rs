//! Scenes of several files: `include = ["lamps.toml"]`.
//!
//! Photometric files of luminaires and pictures of materials are read with them.
//!
//! Each file is taken in once, however often it is included, and before the file that includes it. The texts
//! are added to the [`Source`], so that a scene can be read again without its files.

use std::{
    collections::BTreeSet,
    io,
    path::{Component, Path, PathBuf},
    sync::Arc,
};

use radiosity_photometry::files::{CURE_OF_OUTSIDE, Folder, FoundFile, Unread};
use radiosity_scene::{
    Fault, FaultKind, Source,
    error::Located,
    place::At,
    tree::{DEEPEST, Node, Value, entry},
};

use crate::{
    fields::{list, table, text, texts},
    input, json_text,
    language::Language,
    polygon_list, toml_text,
};

/// The key of the list of files.
pub(super) const INCLUDE: &str = "include";

/// The key of a photometric file of a luminaire.
pub(super) const PHOTOMETRY: &str = "photometry";

/// The key of a picture of a material.
pub(super) const IMAGE: &str = "image";

/// The tree of one file.
#[derive(Debug)]
pub(super) struct FileTree {
    pub tree: Arc<Node>,
    /// Prefix of the names that the file leaves out: empty in the first file, `lamps.` in `lamps.toml`.
    pub prefix: String,
}

/// The trees of all files, that of `source` itself last; texts that are read are added to `source`.
pub(super) fn trees(source: &mut Source, language: Language) -> Result<Vec<FileTree>, Located> {
    *source = source.clone().as_polygon_list(Language::is_polygon_list(source));
    let origin = source.origin.to_string();
    let folder = source.reach().map(|reach| Folder::of_scene(Path::new(&origin), reach));
    let mut files = NamedFiles { source, folder, done: Vec::new(), trees: Vec::new() };
    let tree = tree_of(files.source, language)?;
    files.take(tree, String::new(), &mut vec![origin])?;
    let trees = files.trees;
    hide_words(source, &trees);
    Ok(trees)
}

/// Keeps words out of messages that files outside the folder say and none in it does.
fn hide_words(source: &mut Source, trees: &[FileTree]) {
    if source.outside().is_empty() {
        return;
    }
    let words = |is_outside: bool| {
        let mut words = BTreeSet::new();
        let trees = trees.iter().filter(|own| source.is_outside(own.tree.span.start) == is_outside);
        trees.for_each(|own| own.tree.value.add_words(&mut words));
        words
    };
    let hidden: Vec<String> = words(true).difference(&words(false)).cloned().collect();
    source.hide(hidden);
}

/// The tree of `source` itself.
pub(super) fn tree_of(source: &Source, language: Language) -> Result<Arc<Node>, Located> {
    match source.tree() {
        None => parsed(&source.text(), language).map(Arc::new),
        Some(tree) => Ok(polygon_list::from_list(tree).map_or_else(|| Arc::clone(tree), Arc::new)),
    }
}

/// Tree of a text.
fn parsed(text: &str, language: Language) -> Result<Node, Located> {
    match language {
        Language::Toml => toml_text::parse(text),
        Language::Json => json_text::parse(text).map(|tree| polygon_list::from_list(&tree).unwrap_or(tree)),
        Language::Csv => polygon_list::from_csv(text),
    }
}

/// Files on their way into a scene.
struct NamedFiles<'a> {
    source: &'a mut Source,
    /// Where files are read; none where no file may be.
    folder: Option<Folder>,
    /// The files that were begun.
    done: Vec<String>,
    trees: Vec<FileTree>,
}

impl NamedFiles<'_> {
    /// Takes in the files that a tree includes, then the tree; `path` leads to its file from the first.
    fn take(&mut self, tree: Arc<Node>, prefix: String, path: &mut Vec<String>) -> Result<(), Located> {
        for name in names(&tree)? {
            self.include(&name, path)?;
        }
        let from = path.last().map_or("", String::as_str);
        for name in photometric_files(&tree) {
            let file = beside(from, &name.value);
            let read = self.text(&file, &name.value, input::western);
            read.map_err(|fault| Located::at(&name.span, fault))?;
        }
        for name in pictures(&tree) {
            let file = beside(from, &name.value);
            self.picture(&file, &name.value).map_err(|fault| Located::at(&name.span, fault))?;
        }
        self.trees.push(FileTree { tree, prefix });
        Ok(())
    }

    fn include(&mut self, name: &At<String>, path: &mut Vec<String>) -> Result<(), Located> {
        let at_name = |fault| Located::at(&name.span, fault).within(|| INCLUDE.to_owned());
        let file = beside(path.last().map_or("", String::as_str), &name.value);
        if let Some(start) = path.iter().position(|open| *open == file) {
            let cause = format!("the file includes itself: {} → {file}", path[start..].join(" → "));
            return Err(at_name(Fault::new(FaultKind::Cycle, cause, "take one of these includes out")));
        }
        if self.done.contains(&file) {
            return Ok(());
        }
        if path.len() > DEEPEST {
            return Err(at_name(Fault::too_deep("files", DEEPEST)));
        }
        self.done.push(file.clone());
        let (text, base) = self.text(&file, &name.value, input::decoded).map_err(at_name)?;
        let mut tree =
            parsed(&text, Language::of_text(&file, &text)).map_err(|located| located.shifted(base))?;
        tree.shift(base);
        let stem = Path::new(&file).file_stem().unwrap_or_default().to_string_lossy();
        let prefix = format!("{stem}.");
        path.push(file);
        self.take(Arc::new(tree), prefix, path)?;
        path.pop();
        Ok(())
    }

    /// Reads the bytes of a picture, each picture once.
    fn picture(&mut self, file: &str, typed: &str) -> Result<(), Fault> {
        if self.source.picture(file).is_some() {
            return Ok(());
        }
        let bytes = self.bytes(file, typed)?;
        self.source.add_picture(file, bytes.into());
        Ok(())
    }

    /// The text of a named file, as `decode` decodes it, and its first byte in places of the whole.
    fn text(
        &mut self,
        file: &str,
        typed: &str,
        decode: fn(Vec<u8>) -> io::Result<String>,
    ) -> Result<(Arc<str>, usize), Fault> {
        if let Some(known) = self.source.included_text(file) {
            return Ok(known);
        }
        let text = decode(self.bytes(file, typed)?).map_err(|error| unreadable(file, &error))?;
        self.source.include(file, &text);
        self.source.included_text(file).ok_or_else(|| no_files(file))
    }

    /// The bytes of `file`, which the scene calls `typed`.
    fn bytes(&mut self, file: &str, typed: &str) -> Result<Vec<u8>, Fault> {
        let folder = self.folder.as_ref().ok_or_else(|| no_files(file))?;
        match folder.read(Path::new(file)) {
            Ok(FoundFile { bytes, is_outside }) => {
                self.source.record_outside(is_outside.then(|| file.to_owned()));
                Ok(bytes)
            }
            Err(Unread::Failed(error)) => Err(unreadable(file, &error)),
            Err(Unread::Outside) => {
                let cause = format!("{typed:?} is outside the folder of the scene, and is not read");
                Err(Fault::new(FaultKind::Include, cause, CURE_OF_OUTSIDE))
            }
        }
    }
}

fn unreadable(file: &str, error: &io::Error) -> Fault {
    let cause = format!("{file:?} cannot be read: {error}");
    Fault::new(FaultKind::Include, cause, "check the path, which starts from the folder of this file")
}

/// A file within a scene that is none.
pub(super) fn no_files(file: &str) -> Fault {
    let cause = format!("{file:?} cannot be included: the text is not that of a file");
    Fault::new(FaultKind::Include, cause, "read the scene from its file, such as `radiosity check room.toml`")
}

/// The pictures of the materials of a tree, as far as they are given rightly.
fn pictures(tree: &Node) -> Vec<At<String>> {
    let materials = table(tree).ok().and_then(|entries| table(entry(entries, "materials")?).ok());
    let entries = materials.unwrap_or_default().iter().filter_map(|(_, material)| table(material).ok());
    let amounts = entries.flatten().filter_map(|(_, amount)| table(amount).ok());
    amounts.filter_map(|amount| text(entry(amount, IMAGE)?).ok()).collect()
}

/// The files that a tree includes: a list, or one.
fn names(tree: &Node) -> Result<Vec<At<String>>, Located> {
    let Value::Table(entries) = &tree.value else { return Ok(Vec::new()) };
    match entry(entries, INCLUDE) {
        None => Ok(Vec::new()),
        Some(node) => texts(node),
    }
}

/// The photometric files of the luminaires of a tree, and of its parts, as far as they are given rightly.
fn photometric_files(tree: &Node) -> Vec<At<String>> {
    let Ok(entries) = table(tree) else { return Vec::new() };
    let parts = entry(entries, "parts").and_then(|parts| table(parts).ok()).unwrap_or_default();
    let contents = parts.iter().map(|(_, part)| part).chain([tree]).filter_map(|content| table(content).ok());
    let lists = contents.filter_map(|content| list(entry(content, "luminaires")?).ok());
    let file = |luminaire: &Node| text(entry(table(luminaire).ok()?, PHOTOMETRY)?).ok();
    lists.flat_map(|list| list.iter().filter_map(file).collect::<Vec<_>>()).collect()
}

/// The path of `name`, which starts from the folder of `file`, without detours.
pub(super) fn beside(file: &str, name: &str) -> String {
    let mut path = PathBuf::new();
    for part in Path::new(file).parent().unwrap_or(Path::new("")).join(name).components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir if matches!(path.components().next_back(), Some(Component::Normal(_))) => {
                path.pop();
            }
            part => path.push(part),
        }
    }
    path.to_string_lossy().into_owned()
}

#[cfg(test)]
mod tests {
    use super::beside;

    #[test]
    fn paths_start_from_the_folder_of_the_file() {
        for (file, name, path) in [
            ("room.toml", "lamps.toml", "lamps.toml"),
            ("<stdin>", "lamps.toml", "lamps.toml"),
            ("rooms/desk.toml", "lamps.toml", "rooms/lamps.toml"),
            ("rooms/desk.toml", "./more/lamps.toml", "rooms/more/lamps.toml"),
            ("rooms/desk.toml", "../lamps.toml", "lamps.toml"),
            ("desk.toml", "../../lamps.toml", "../../lamps.toml"),
            ("rooms/desk.toml", "/all/lamps.toml", "/all/lamps.toml"),
            ("rooms/../desk.toml", "lamps.toml", "lamps.toml"),
        ] {
            assert_eq!(beside(file, name).replace('\\', "/"), path);
        }
    }
}
