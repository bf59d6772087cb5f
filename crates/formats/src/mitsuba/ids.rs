//! Ids: what `<ref id>` stands for.

use std::collections::HashMap;

use radiosity_photometry::error::Refusal;
use radiosity_photometry::text::short;

use super::element::Element;

/// The elements that have an id.
#[derive(Debug)]
pub(super) struct Ids<'a>(HashMap<&'a str, &'a Element>);

impl<'a> Ids<'a> {
    /// The elements with ids in the tree of `root`.
    ///
    /// # Errors
    /// An id that two elements have, an alias of none.
    pub(super) fn of(root: &'a Element) -> Result<Self, Refusal> {
        let mut ids = Ids(HashMap::new());
        ids.add(root)?;
        Ok(ids)
    }

    fn add(&mut self, element: &'a Element) -> Result<(), Refusal> {
        match (element.tag.as_str(), element.attribute("id")) {
            ("alias", Some(id)) => self.put(element.required("as")?, self.get(id, element)?, element)?,
            ("ref", _) | (_, None) => {}
            (_, Some(id)) => self.put(id, element, element)?,
        }
        element.children.iter().try_for_each(|child| self.add(child))
    }

    fn put(&mut self, id: &'a str, named: &'a Element, at: &Element) -> Result<(), Refusal> {
        match self.0.insert(id, named) {
            None => Ok(()),
            Some(first) => Err(at.refusal(
                format!("the id '{}' is given twice, first in line {}", short(id), first.line),
                "give one of the two another id",
            )),
        }
    }

    fn get(&self, id: &str, at: &Element) -> Result<&'a Element, Refusal> {
        self.0.get(id).copied().ok_or_else(|| {
            at.refusal(
                format!("nothing has the id '{}'", short(id)),
                "correct the id, or give it to something",
            )
        })
    }

    /// The element that an element stands for: if it is a `<ref>`, the element of its id, else itself.
    ///
    /// # Errors
    /// An id that nothing has.
    pub(super) fn meant(&self, element: &'a Element) -> Result<&'a Element, Refusal> {
        element.meet();
        match element.tag.as_str() {
            "ref" => self.get(element.required("id")?, element).map(Element::meet),
            _ => Ok(element),
        }
    }

    /// The tag of the element that an element stands for, of which nothing is made by this.
    ///
    /// # Errors
    /// An id that nothing has.
    pub(super) fn tag(&self, element: &'a Element) -> Result<&'a str, Refusal> {
        match element.tag.as_str() {
            "ref" => Ok(&self.get(element.required("id")?, element)?.tag),
            tag => Ok(tag),
        }
    }

    /// The element that stands for a property of an element, by the property's name; none without one.
    ///
    /// # Errors
    /// An id that nothing has.
    pub(super) fn property(&self, element: &'a Element, name: &str) -> Result<Option<&'a Element>, Refusal> {
        element.property(name).map(|property| self.meant(property)).transpose()
    }
}
