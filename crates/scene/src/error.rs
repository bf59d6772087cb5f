//! Errors of scenes: a fault and its place.

use std::{fmt, ops::Range};

use radiosity_work::wording::Wording;
use thiserror::Error;

use crate::{
    fault::Fault,
    place::{Place, Span},
};

/// A scene that cannot be used, with the place in its text where there is one.
///
/// Displays as `file:line:column: owner: message`; the cure is apart, see [`SceneError::cure`].
#[derive(Debug, Error)]
pub struct SceneError {
    /// File name, `<stdin>`, the name that was asked for, or that of a scene built in code.
    pub origin: String,
    /// Place of the fault; none if it is something absent, a file that cannot be read, or in a scene made in
    /// code.
    pub place: Option<Box<Place>>,
    /// The part of the scene it belongs to, e.g. `surface "floor"`; in a [`Tree`](crate::Tree) down to the
    /// value, `surface "floor", polygon.vertices[2]`.
    pub owner: Option<String>,
    /// The fault, without its place.
    #[source]
    pub fault: Fault,
}

/// Title in messages of a part of the scene, such as `surface "floor"`.
pub fn title(kind: &str, name: &str) -> String {
    format!("{kind} {name:?}")
}

/// A fault on its way to the [`SceneError`], while the source is not at hand.
#[derive(Debug)]
pub struct Located {
    pub(super) fault: Fault,
    pub(super) span: Option<Span>,
    pub(super) owner: Option<String>,
}

impl Located {
    /// A fault of something that stands at `span`.
    pub fn at(span: &Span, fault: Fault) -> Self {
        Located { fault, span: Some(span.clone()), owner: None }
    }

    /// A fault of the scene as a whole.
    pub fn nowhere(fault: Fault) -> Self {
        Located { fault, span: None, owner: None }
    }

    /// Names the part of the scene the fault belongs to; the innermost name stays.
    pub fn within(mut self, owner: impl FnOnce() -> String) -> Self {
        self.owner = self.owner.or_else(|| Some(owner()));
        self
    }

    /// The fault with its place moved by `base` bytes; one of a whole text stands at its first byte.
    pub fn shifted(self, base: usize) -> Self {
        let Range { start, end } = self.span.unwrap_or_default();
        Located { span: Some(start + base..end + base), ..self }
    }

    /// The fault with its kind and place alone: it quotes nothing of a file outside the scene's folder.
    pub(super) fn discreet(self) -> Self {
        Located { fault: self.fault.discreet(), owner: None, ..self }
    }

    /// The error in a scene without a text.
    pub(super) fn in_code(self, name: &str) -> SceneError {
        SceneError { origin: name.to_owned(), place: None, owner: self.owner, fault: self.fault }
    }
}

impl SceneError {
    /// A fault of the whole scene or file called `origin`.
    pub fn of(origin: impl Into<String>, fault: Fault) -> Self {
        Self { origin: origin.into(), place: None, owner: None, fault }
    }

    /// Advice that mends the fault; none where the message already says so.
    pub fn advice(&self) -> Option<Wording> {
        self.fault.advice()
    }

    /// The advice as the command line words it.
    pub fn cure(&self) -> Option<String> {
        self.fault.cure()
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.place {
            Some(place) => write!(f, "{place}: ")?,
            None => write!(f, "{}: ", self.origin)?,
        }
        if let Some(owner) = &self.owner {
            write!(f, "{owner}: ")?;
        }
        self.fault.fmt(f)
    }
}
