//! Elements of a scene: tags with attributes, parameters filled in, and what they say.

use std::cell::Cell;
use std::collections::BTreeSet;
use std::rc::Rc;
use std::sync::Arc;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::note::Note;
use radiosity_photometry::note_text::NoteText;
use radiosity_photometry::text::{number, short};

/// Names of files that texts were made of.
pub(super) type Sources = BTreeSet<Rc<str>>;

/// An element and those inside it.
#[derive(Debug)]
pub(super) struct Element {
    /// Tag of the element: `shape`, `bsdf`, `rgb` …
    pub(super) tag: String,
    /// Names and values, as they are written but with parameters filled in.
    pub(super) attributes: Vec<(String, String)>,
    /// The elements inside it, included files spread out.
    pub(super) children: Vec<Element>,
    /// Name of the file that the element stands in.
    pub(super) file: Rc<str>,
    /// The files that values in it, and in those inside it, were made of, as far as these are parameters.
    pub(super) quoted: Sources,
    /// Line of the element, counted from 1.
    pub(super) line: usize,
    /// Number of the element, different from that of any other element of the scene.
    pub(super) number: usize,
    /// Whether a reader has used the element.
    pub(super) is_met: Cell<bool>,
}

impl Element {
    /// The value of an attribute.
    pub(super) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }

    /// The value of an attribute that it must have.
    ///
    /// # Errors
    /// It does not.
    pub(super) fn required(&self, name: &str) -> Result<&str, Refusal> {
        self.attribute(name).ok_or_else(|| {
            self.refusal(format!("<{}> has no {name}", short(&self.tag)), format!("write {name}=\"…\" in it"))
        })
    }

    /// Attribute `type`, empty without one.
    pub(super) fn kind(&self) -> &str {
        self.attribute("type").unwrap_or_default()
    }

    /// Says that something is made of it.
    pub(super) fn meet(&self) -> &Self {
        self.is_met.set(true);
        self
    }

    /// Says that nothing is made of what is inside it, and that this is told already.
    pub(super) fn pass_over(&self) {
        self.meet();
        self.children.iter().for_each(Element::pass_over);
    }

    /// Bytes of its attributes and of those inside it, and some for each element: how long reading it takes.
    pub(super) fn size(&self) -> usize {
        const ELEMENT: usize = 64;
        let own: usize = self.attributes.iter().map(|(name, value)| name.len() + value.len()).sum();
        ELEMENT + own + self.children.iter().map(Element::size).sum::<usize>()
    }

    /// The element inside it that a name is given to.
    pub(super) fn property(&self, name: &str) -> Option<&Element> {
        self.children.iter().find(|child| child.attribute("name") == Some(name)).map(Element::meet)
    }

    /// The number that a name is given to.
    ///
    /// # Errors
    /// A value that is no number.
    pub(super) fn float(&self, name: &str) -> Result<Option<f64>, Refusal> {
        let Some(property) = self.property(name) else { return Ok(None) };
        let value = property.required("value")?.trim();
        number(value, name).map(Some).map_err(|fault| property.at(fault))
    }

    /// The truth that a name is given to, false without one.
    ///
    /// # Errors
    /// A value that is neither true nor false.
    pub(super) fn boolean(&self, name: &str) -> Result<bool, Refusal> {
        let Some(property) = self.property(name) else { return Ok(false) };
        match property.required("value")?.trim().to_ascii_lowercase().as_str() {
            "true" => Ok(true),
            "false" => Ok(false),
            word => Err(property
                .refusal(format!("{name} is '{}'", short(word)), "write value=\"true\" or value=\"false\"")),
        }
    }

    /// The text that a name is given to.
    ///
    /// # Errors
    /// It has no value.
    pub(super) fn string(&self, name: &str) -> Result<Option<&str>, Refusal> {
        self.property(name).map(|property| property.required("value")).transpose()
    }

    /// The numbers of an attribute, parted by blanks or commas.
    ///
    /// # Errors
    /// No such attribute, and words that are no numbers.
    pub(super) fn numbers(&self, attribute: &str) -> Result<Vec<f64>, Refusal> {
        let parsed = words(self.required(attribute)?).map(|word| number(word, attribute));
        parsed.collect::<Result<_, _>>().map_err(|fault| self.at(fault))
    }

    /// The three numbers of `value`, one standing for all, or those of `x`, `y` and `z`, which are `absent`
    /// if they are.
    ///
    /// # Errors
    /// Another count, and words that are no numbers.
    pub(super) fn vector(&self, absent: f64) -> Result<[f64; 3], Refusal> {
        if self.attribute("value").is_some() {
            return self.triple("value");
        }
        let mut vector = [absent; 3];
        for (value, name) in vector.iter_mut().zip(["x", "y", "z"]) {
            if let Some(word) = self.attribute(name) {
                *value = number(word.trim(), name).map_err(|fault| self.at(fault))?;
            }
        }
        Ok(vector)
    }

    /// The three numbers of an attribute, one standing for all.
    ///
    /// # Errors
    /// Another count, and words that are no numbers.
    pub(super) fn triple(&self, attribute: &str) -> Result<[f64; 3], Refusal> {
        match self.numbers(attribute)?[..] {
            [one] => Ok([one; 3]),
            [x, y, z] => Ok([x, y, z]),
            ref numbers => Err(self.refusal(
                format!("{attribute} of <{}> has {} numbers", short(&self.tag), numbers.len()),
                "write three numbers, or one for all three",
            )),
        }
    }

    /// The refusal of what is here.
    pub(super) fn refusal(&self, cause: impl Into<String>, cure: impl Into<String>) -> Refusal {
        self.at(Refusal::new(cause, cure))
    }

    /// The refusal for a fault that is here.
    pub(super) fn at(&self, fault: Refusal) -> Refusal {
        fault.quoting(self.quoted.iter().map(|file| &**file)).in_line(&self.file, self.line)
    }
}

/// Remarks on what was left out or changed, each kind once.
#[derive(Debug, Default)]
pub(super) struct Remarks(pub(super) Vec<Note>);

impl Remarks {
    /// Remarks something about an element.
    pub(super) fn add(&mut self, text: impl Into<NoteText>, element: &Element) {
        let file = Some(Arc::from(&*element.file));
        Note::add_in(&mut self.0, text, file.as_ref(), Some(FilePlace::Line(element.line)));
    }
}

/// The words of a list, parted by blanks or commas.
pub(super) fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty())
}
