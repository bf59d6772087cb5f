//! Sources of scenes, texts or trees made in code, and places in them.

use std::{
    borrow::Cow,
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use radiosity_photometry::files::Reach;

use crate::{
    error::{Located, SceneError},
    fault::Fault,
    imported::Imported,
    numbering::{numbered, path, repeated_key},
    place::{Line, LineIndex, Place, Span},
    print::Notation,
    tree::{Node, Tree},
};

/// A mark that some editors put before a text.
const BYTE_ORDER_MARK: char = '\u{feff}';

/// A scene's text, or a tree made in code, with the name shown in messages: a path, `<stdin>` or a built-in
/// scene's name.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Name shown in messages.
    pub origin: Arc<str>,
    /// Distance (scene length) within which corners and planes are made to agree, instead of the tolerance of
    /// the input.
    pub tolerance: Option<f64>,
    /// Values of its variables, by name, instead of those that the text gives them.
    pub settings: Arc<BTreeMap<String, f64>>,
    /// The moment, a real number of frames, whose still scene is read; none where the scene is read with its
    /// motions.
    pub moment: Option<f64>,
    /// Record of the import from a file of another program, if there was one.
    pub imported: Option<Arc<Imported>>,
    /// The texts that it includes, or may include.
    included: Arc<Vec<Included>>,
    /// The pictures that it names, or may name: the path and the bytes of each.
    pictures: Arc<BTreeMap<String, Arc<[u8]>>>,
    /// How far it may reach for the files that it names; none where it may read no file.
    reach: Option<Reach>,
    /// The files that were read outside its folder.
    outside: Arc<BTreeSet<String>>,
    /// Names that stand in these files alone, and names that the scene makes of them.
    hidden: Arc<BTreeSet<String>>,
    /// Whether it was read as a plain list of polygons, which has no materials.
    is_polygon_list: bool,
    content: Content,
}

/// The text or the tree of a source.
#[derive(Clone, Debug, PartialEq)]
enum Content {
    /// A text, without a byte-order mark before it.
    Text(Arc<str>, LineIndex),
    /// A tree whose places are the numbers of its values.
    Tree(Arc<Node>),
}

/// A text that another includes. In the whole source its bytes come behind those of the texts before it.
#[derive(Clone, Debug, PartialEq)]
struct Included {
    origin: Arc<str>,
    text: Arc<str>,
    /// Place of its first byte in the whole source.
    base: usize,
    index: LineIndex,
}

impl Source {
    /// The text `text`, called `origin` in messages.
    pub fn new(origin: &str, text: &str) -> Self {
        let text = without_mark(text);
        Source::of(origin, Content::Text(text.into(), LineIndex::of(text)))
    }

    /// A scene made in code, called `name` in messages, which find values by the names that lead to them.
    ///
    /// # Errors
    /// [`FaultKind::TooMany`](crate::FaultKind::TooMany) levels,
    /// [`FaultKind::RepeatedKey`](crate::FaultKind::RepeatedKey).
    pub fn of_tree(name: &str, tree: Tree) -> Result<Self, SceneError> {
        let Tree(mut tree) = tree;
        numbered(&mut tree).map_err(|fault| Located::nowhere(fault).in_code(name))?;
        let repeated = repeated_key(&tree);
        let repeated = repeated.map(|key| Located::at(&key.span, Fault::repeated_key(&key.value)));
        let source = Source::of(name, Content::Tree(Arc::new(tree)));
        match repeated {
            None => Ok(source),
            Some(located) => Err(located.in_source(&source)),
        }
    }

    fn of(origin: &str, content: Content) -> Self {
        Source {
            origin: origin.into(),
            tolerance: None,
            settings: Arc::default(),
            moment: None,
            imported: None,
            included: Arc::default(),
            pictures: Arc::default(),
            reach: None,
            outside: Arc::default(),
            hidden: Arc::default(),
            is_polygon_list: false,
            content,
        }
    }

    /// The whole text, without a byte-order mark before it; of a tree made in code its text in JSON.
    pub fn text(&self) -> Cow<'_, str> {
        match &self.content {
            Content::Text(text, _) => Cow::Borrowed(text),
            Content::Tree(tree) => Cow::Owned(Notation::Json.text(tree)),
        }
    }

    /// The tree that was made in code, if it is no text.
    pub fn tree(&self) -> Option<&Arc<Node>> {
        match &self.content {
            Content::Text(..) => None,
            Content::Tree(tree) => Some(tree),
        }
    }

    /// Number of places in the source: bytes of the text, or numbers in the tree.
    fn extent(&self) -> usize {
        match &self.content {
            Content::Text(text, _) => text.len(),
            Content::Tree(tree) => tree.span.end,
        }
    }

    /// The source, to be read with corners and planes made to agree within `tolerance` (scene length).
    #[must_use]
    pub fn within(self, tolerance: Option<f64>) -> Self {
        Self { tolerance, ..self }
    }

    /// The source, to be read with these variables set, the last setting of each.
    #[must_use]
    pub fn set<'a>(mut self, settings: impl IntoIterator<Item = (&'a str, f64)>) -> Self {
        let settings = settings.into_iter().map(|(name, value)| (name.to_owned(), value));
        Arc::make_mut(&mut self.settings).extend(settings);
        self
    }

    /// The source, to be read as the still scene of a moment, a real number of frames.
    #[must_use]
    pub fn at(self, moment: f64) -> Self {
        Self { moment: Some(moment), ..self }
    }

    /// The source with the record of its import from a file of another program.
    pub fn made_from(self, imported: Imported) -> Self {
        Self { imported: Some(Arc::new(imported)), ..self }
    }

    /// The source with another text, called `origin`, that it may include: by the path `origin` itself, or
    /// one that leads there from the including text.
    #[must_use]
    pub fn including(mut self, origin: &str, text: &str) -> Self {
        self.include(origin, text);
        self
    }

    /// The texts that it includes, or may include: the name and the text of each.
    pub fn included(&self) -> impl Iterator<Item = (&str, &str)> {
        self.included.iter().map(|own| (&*own.origin, &*own.text))
    }

    /// The source with a picture, a file of these bytes, that it may name: by the path `origin` itself, or
    /// one that leads there from the text.
    #[must_use]
    pub fn with_picture(mut self, origin: &str, bytes: impl Into<Arc<[u8]>>) -> Self {
        self.add_picture(origin, bytes.into());
        self
    }

    /// The pictures that it names, or may name: the path and the bytes of each.
    pub fn pictures(&self) -> impl Iterator<Item = (&str, &[u8])> {
        self.pictures.iter().map(|(path, bytes)| (path.as_str(), &**bytes))
    }

    /// Adds a picture that it names.
    pub fn add_picture(&mut self, path: &str, bytes: Arc<[u8]>) {
        Arc::make_mut(&mut self.pictures).insert(path.to_owned(), bytes);
    }

    /// The bytes of the picture of that path.
    pub fn picture(&self, path: &str) -> Option<Arc<[u8]>> {
        self.pictures.get(path).cloned()
    }

    /// The source, which may read files that it names, in the folder of its own name and below.
    #[must_use]
    pub fn with_files(self) -> Self {
        self.reaching(Reach::Inside)
    }

    /// The source, which may read files that it names, as far as this from the folder of its own name.
    #[must_use]
    pub fn reaching(self, reach: Reach) -> Self {
        Self { reach: Some(reach), ..self }
    }

    /// How far it may reach for the files that it names; none where it may read no file.
    pub fn reach(&self) -> Option<Reach> {
        self.reach
    }

    /// The files that were read outside its folder, by the names that messages give them.
    pub fn outside(&self) -> &BTreeSet<String> {
        &self.outside
    }

    /// Records that these files were read outside its folder.
    pub fn record_outside(&mut self, files: impl IntoIterator<Item = String>) {
        Arc::make_mut(&mut self.outside).extend(files);
    }

    /// The source, marked as a plain list of polygons or not.
    #[must_use]
    pub fn as_polygon_list(self, is_polygon_list: bool) -> Self {
        Self { is_polygon_list, ..self }
    }

    /// Whether it was read as a plain list of polygons, which has no materials.
    pub(crate) fn is_polygon_list(&self) -> bool {
        self.is_polygon_list
    }

    /// The fault with those names alone that stand in the folder of the source.
    pub(crate) fn listing(&self, fault: Fault) -> Fault {
        fault.listing(|name| self.may_list(name))
    }

    /// Whether messages may list a name: it does not stand in files outside its folder alone.
    pub fn may_list(&self, name: &str) -> bool {
        self.outside.is_empty() || !self.hidden.contains(name) && !self.is_joined()
    }

    /// Whether the text holds what files outside its folder say, as that of an import does.
    fn is_joined(&self) -> bool {
        let is_text = |file: &String| self.included.iter().any(|own| *own.origin == **file);
        self.outside.iter().any(|file| !is_text(file) && !self.pictures.contains_key(file))
    }

    /// Keeps names out of the lists of messages.
    pub fn hide(&mut self, names: impl IntoIterator<Item = String>) {
        Arc::make_mut(&mut self.hidden).extend(names);
    }

    /// Whether `index` stands in a file outside its folder.
    pub fn is_outside(&self, index: usize) -> bool {
        !self.outside.is_empty() && self.outside.contains(self.origin_at(index))
    }

    /// A fault in the content of `file`; of one outside its folder it shows nothing.
    pub fn shown(&self, file: &str, fault: Fault) -> Fault {
        if self.outside.contains(file) { fault.discreet() } else { fault }
    }

    /// Adds a text that it includes. Returns the place of its first byte in the whole source.
    pub fn include(&mut self, origin: &str, text: &str) -> usize {
        let last = self.included.last().map_or(self.extent(), |last| last.base + last.text.len());
        let (text, base) = (without_mark(text), last + 1);
        let index = LineIndex::of(text);
        let included = Included { origin: origin.into(), text: text.into(), base, index };
        Arc::make_mut(&mut self.included).push(included);
        base
    }

    /// The included text of that name, with the place of its first byte in the whole source.
    pub fn included_text(&self, origin: &str) -> Option<(Arc<str>, usize)> {
        let own = self.included.iter().find(|own| *own.origin == *origin)?;
        Some((Arc::clone(&own.text), own.base))
    }

    /// The included text in which `index` stands; none for the text itself.
    fn included_at(&self, index: usize) -> Option<&Included> {
        let count = self.included.partition_point(|own| own.base <= index);
        self.included[..count].last()
    }

    /// The name of the text in which `index` stands.
    pub fn origin_at(&self, index: usize) -> &str {
        self.included_at(index).map_or(&*self.origin, |own| &*own.origin)
    }

    /// The line on which `index` stands; none in a tree.
    pub fn line(&self, index: usize) -> Option<Line> {
        match (self.included_at(index), &self.content) {
            (Some(own), _) => {
                let number = own.index.line(index - own.base, own.text.len());
                Some(Line { number, file: Some(Arc::clone(&own.origin)) })
            }
            (None, Content::Text(text, lines)) => {
                Some(Line { number: lines.line(index, text.len()), file: None })
            }
            (None, Content::Tree(_)) => None,
        }
    }

    /// The place where `span` starts; none in a tree. A span over several lines is cut at the end of its
    /// first.
    pub fn place(&self, span: &Span) -> Option<Place> {
        let place = match (self.included_at(span.start), &self.content) {
            (Some(own), _) => {
                let span = span.start - own.base..span.end.saturating_sub(own.base);
                own.index.place(&own.origin, &own.text, &span)
            }
            (None, Content::Text(text, lines)) => lines.place(&self.origin, text, span),
            (None, Content::Tree(_)) => return None,
        };
        Some(if self.is_hidden(span.start) { Place { text: String::new(), ..place } } else { place })
    }

    /// Whether messages show nothing of what stands at `index`: it is of a file outside the folder, or may be.
    fn is_hidden(&self, index: usize) -> bool {
        self.is_outside(index) || self.is_joined()
    }

    /// Title in messages of the value at `span` of the part `owner`: the part, and in a tree the path of
    /// names from there.
    fn owner(&self, span: &Span, owner: Option<String>) -> Option<String> {
        let (None, Content::Tree(tree)) = (self.included_at(span.start), &self.content) else { return owner };
        let path = path(tree, span.start, owner.is_some());
        match (owner, path.is_empty()) {
            (owner, true) => owner,
            (None, false) => Some(path),
            (Some(owner), false) => Some(format!("{owner}, {path}")),
        }
    }
}

impl Located {
    /// The error with its place looked up in `source`.
    pub fn in_source(self, source: &Source) -> SceneError {
        let Located { fault, span, owner } = match &self.span {
            Some(span) if source.is_hidden(span.start) => self.discreet(),
            _ => Located { fault: source.listing(self.fault), ..self },
        };
        let (place, owner) = match span {
            Some(span) => (source.place(&span).map(Box::new), source.owner(&span, owner)),
            None => (None, owner),
        };
        SceneError { origin: source.origin.to_string(), place, owner, fault }
    }
}

fn without_mark(text: &str) -> &str {
    text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text)
}
