//! Contexts of MGF: a current vertex, colour or material, with or without a name (MGF 2.0, "Entities and
//! Contexts").

use std::collections::HashMap;

use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::text::short;

/// The contexts of one kind.
#[derive(Debug)]
pub(super) struct Contexts<T> {
    /// Name of the kind in messages: "vertex".
    kind: &'static str,
    named: HashMap<String, T>,
    unnamed: T,
    current: Option<String>,
}

impl<T: Clone + Default> Contexts<T> {
    /// Contexts of which the unnamed one alone is there, and is current.
    pub(super) fn new(kind: &'static str) -> Self {
        Self { kind, named: HashMap::new(), unnamed: T::default(), current: None }
    }

    /// Follows an entity `v`, `c` or `m` with these arguments: nothing, `id`, `id =`, or `id = template`.
    ///
    /// # Errors
    /// Names that were not defined, other arguments.
    pub(super) fn switch(&mut self, arguments: &[&str]) -> Result<(), Refusal> {
        match *arguments {
            [] => {
                self.unnamed = T::default();
                self.current = None;
                return Ok(());
            }
            [id] => {
                self.get(id)?;
                self.current = Some(id.to_owned());
                return Ok(());
            }
            [id, "="] => self.named.insert(id.to_owned(), T::default()),
            [id, "=", template] => {
                let value = self.get(template)?.clone();
                self.named.insert(id.to_owned(), value)
            }
            _ => {
                return refuse(
                    format!("the arguments of a {} are not right", self.kind),
                    "write a name, or a name and =, or a name, = and a template, parted by blanks",
                );
            }
        };
        self.current = Some(arguments[0].to_owned());
        Ok(())
    }

    /// The one named `id`.
    ///
    /// # Errors
    /// A name that was not defined.
    pub(super) fn get(&self, id: &str) -> Result<&T, Refusal> {
        self.named.get(id).ok_or_else(|| {
            Refusal::new(
                format!("the {} '{}' is not defined", self.kind, short(id)),
                format!("define it above, with a blank before the equals sign: {} =", short(id)),
            )
        })
    }

    /// The current one with its name.
    pub(super) fn current(&self) -> (Option<&str>, &T) {
        let named = self.current.as_ref().and_then(|id| self.named.get_key_value(id));
        named.map_or((None, &self.unnamed), |(id, value)| (Some(id.as_str()), value))
    }

    /// The current one, to change it.
    pub(super) fn current_mut(&mut self) -> &mut T {
        match self.current.as_ref().and_then(|id| self.named.get_mut(id)) {
            Some(named) => named,
            None => &mut self.unnamed,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn named_contexts_keep_their_changes_and_the_unnamed_one_does_not() {
        let mut contexts: Contexts<i32> = Contexts::new("number");
        *contexts.current_mut() = 1;
        assert_eq!(contexts.switch(&["a", "="]), Ok(()));
        *contexts.current_mut() = 2;
        assert_eq!(contexts.switch(&["b", "=", "a"]), Ok(()));
        *contexts.current_mut() += 1;
        assert_eq!(contexts.switch(&[]), Ok(()));
        assert_eq!(contexts.current(), (None, &0));
        assert_eq!(contexts.switch(&["a"]), Ok(()));
        assert_eq!(contexts.current(), (Some("a"), &2));
        assert_eq!(contexts.get("b"), Ok(&3));
        assert_eq!(contexts.switch(&["a", "="]), Ok(()));
        assert_eq!(contexts.get("a"), Ok(&0));
    }

    #[test]
    fn unknown_names_are_refused() {
        let mut contexts: Contexts<i32> = Contexts::new("vertex");
        for arguments in [&["c"][..], &["d", "=", "c"], &["c="], &["c", "d"], &["c", "=", "c", "c"]] {
            assert!(contexts.switch(arguments).is_err_and(|fault| fault.cause.contains("vertex")));
        }
    }
}
