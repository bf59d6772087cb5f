//! Names by which parts of a scene are meant, and the parts that they mean.

use radiosity_fit::sides::front_of;
use std::{borrow::Borrow, sync::Arc};

use crate::{fault::Fault, light_group::LightGroup, place::Span};

/// The mark behind which a name may end in any way.
const ANY_ENDING: char = '*';

/// The name of something that is meant, with its place in a file.
#[derive(Clone, Debug)]
pub struct NamedMember {
    /// The name.
    pub name: String,
    /// Place of the name in a file; none if it was given in code.
    pub span: Option<Span>,
}

/// The names by which a surface or a luminaire is meant: of what moves, and of what is masked.
#[derive(Debug, Default)]
pub struct MemberNames {
    /// Its own name, and the name of the entry that made it.
    pub(super) names: Vec<String>,
    /// Names of the instances that it is in.
    pub(super) instances: Arc<[String]>,
    /// Name of its light group.
    pub(super) group: Option<String>,
    /// Index of the luminaire whose area it is, if it is one.
    pub(super) luminaire: Option<usize>,
}

impl MemberNames {
    /// Names of a thing with these names, in no instance.
    pub fn named(names: impl Into<Vec<String>>) -> Self {
        Self { names: names.into(), ..Self::default() }
    }

    /// The handles with the names of the instances that the thing is in.
    pub fn within(self, instances: Arc<[String]>) -> Self {
        Self { instances, ..self }
    }

    /// The handles with the name of the light group that the thing is in.
    pub fn in_group(self, group: Option<&LightGroup>) -> Self {
        Self { group: group.map(|own| own.name.clone()), ..self }
    }

    /// Names of the surface `name`, a side of the area of one of these luminaires.
    pub fn of_area(name: &str, luminaires: &[Self]) -> Self {
        let called = |name: &str| luminaires.iter().position(|own| own.names[0] == name);
        let luminaire = called(name).or_else(|| called(front_of(name)?));
        let instances = luminaire.map(|index| Arc::clone(&luminaires[index].instances));
        let named = Self { luminaire, ..Self::named([name.to_owned()]) };
        named.within(instances.unwrap_or_default())
    }

    /// Index of the luminaire whose area it is, if it is one.
    pub fn luminaire(&self) -> Option<usize> {
        self.luminaire
    }

    /// Its own name, and the name of the entry that made it.
    pub(super) fn own(&self) -> Vec<&String> {
        self.names.iter().collect()
    }

    /// Names of the instances that it is in.
    pub(super) fn of_instances(&self) -> Vec<&String> {
        self.instances.iter().collect()
    }

    /// Name of the light group that it is in.
    pub(super) fn of_group(&self) -> Vec<&String> {
        self.group.iter().collect()
    }

    /// All its names but that of its light group.
    pub(super) fn all(&self) -> Vec<&String> {
        self.names.iter().chain(self.instances.iter()).collect()
    }
}

/// The names of a thing that count.
pub(super) type NamesOf = fn(&MemberNames) -> Vec<&String>;

/// The fault of a name that none of those known is.
pub(super) type UnknownName = fn(&str, Vec<String>) -> Fault;

/// Indices of all things that one of the `chosen` names means.
///
/// # Errors
/// The first name that means nothing, with its place.
pub(super) fn found<H: Borrow<MemberNames>>(
    chosen: &[NamedMember],
    all: &[H],
    names: NamesOf,
    unknown: UnknownName,
) -> Result<Vec<usize>, (Option<Span>, Fault)> {
    let mut found = Vec::new();
    for NamedMember { name, span } in chosen {
        let means = |own: &String| match name.strip_suffix(ANY_ENDING) {
            Some(stem) => own.starts_with(stem),
            None => own == name,
        };
        let before = found.len();
        let meant = all.iter().enumerate().filter(|(_, own)| names((*own).borrow()).into_iter().any(means));
        found.extend(meant.map(|(index, _)| index));
        if found.len() == before {
            let mut known: Vec<String> = all.iter().flat_map(|own| names(own.borrow())).cloned().collect();
            known.sort_unstable();
            known.dedup();
            return Err((span.clone(), unknown(name, known)));
        }
    }
    Ok(found)
}
