//! Instances of parts → surfaces and luminaires, each with a name and a place of its own.
//!
//! The surface `seat` of the instance `chair` is `chair.seat`; in an array it is `chair[1,0].seat`.

use std::{collections::BTreeMap, sync::Arc};

use radiosity_geom::{DVec3, Motion};
use radiosity_scene::{
    Fault, FaultKind, Source, error::Located, names::UniqueNames, place::At, tree::DEEPEST,
};

use crate::{
    file::{Content, CopyRow, InstanceFile, LuminaireFile, PartFile, SurfaceFile},
    keys::NamedTable,
};

/// Most entries of surfaces and luminaires, and most copies of parts: each takes about a kilobyte.
const MOST: usize = 1_000_000;

/// An entry of a file where it is put.
#[derive(Debug)]
pub(super) struct PlacedEntry<'a, T> {
    pub file: &'a T,
    pub name: String,
    pub motion: Motion,
    /// The instances that it is in, those of an array with and without the place in it.
    pub instances: Arc<[String]>,
    /// Whether it, or an instance that it is in, stands in a file outside the folder of the scene.
    pub is_outside: bool,
}

/// An entry of `[[surfaces]]`, moved as its instance and its own transform say.
pub(super) type PlacedSurface<'a> = PlacedEntry<'a, SurfaceFile>;

/// An entry of `[[luminaires]]`, moved as its instance says.
pub(super) type PlacedLuminaire<'a> = PlacedEntry<'a, LuminaireFile>;

/// Surfaces and luminaires of the scene and of its instances, each where its instance puts it.
#[derive(Debug, Default)]
pub(super) struct Placed<'a> {
    pub surfaces: Vec<PlacedSurface<'a>>,
    pub luminaires: Vec<PlacedLuminaire<'a>>,
    /// Names of instances that stand in files outside the folder of the scene, or within such.
    pub outside: Vec<String>,
}

/// The content of the scene, then that of its instances.
pub(super) fn placed<'a>(
    content: Content<'a>,
    parts: &'a [NamedTable<PartFile>],
    source: &Source,
) -> Result<Placed<'a>, Located> {
    let contents = parts.iter().map(|part| part.file.content()).chain([content]);
    contents.into_iter().try_for_each(|content| check_names(content.instances, source))?;
    let parts: Parts<'_> = parts.iter().map(|part| (part.name.value.as_str(), part.file.content())).collect();
    check_sizes(content, &parts)?;
    let mut placed = Placed::default();
    let scene = Within {
        prefix: String::new(),
        motion: Motion::IDENTITY,
        instances: Arc::default(),
        is_outside: false,
        source,
    };
    place(content, &scene, &parts, &mut placed)?;
    Ok(placed)
}

/// Content of the parts of the scene by name.
type Parts<'a> = BTreeMap<&'a str, Content<'a>>;

/// Refuses two instances of one name in one list.
fn check_names(instances: &[InstanceFile], source: &Source) -> Result<(), Located> {
    let mut names = UniqueNames::default();
    instances.iter().try_for_each(|InstanceFile { name, .. }| {
        let added = names.add(&name.value, source.line(name.span.start));
        added.map_err(|fault| Located::at(&name.span, fault))
    })
}

/// The instance that something is in, or the scene.
struct Within<'s> {
    /// Prefix of names in the instance; empty in the scene.
    prefix: String,
    motion: Motion,
    /// Names of the instances around an entry; see [`PlacedEntry::instances`].
    instances: Arc<[String]>,
    /// Whether one of these stands in a file outside the folder of the scene.
    is_outside: bool,
    source: &'s Source,
}

impl Within<'_> {
    fn entry<'a, T>(&self, file: &'a T, name: &At<String>, motion: Motion) -> PlacedEntry<'a, T> {
        let is_outside = self.is_outside || self.source.is_outside(name.span.start);
        let name = format!("{}{}", self.prefix, name.value);
        PlacedEntry { file, name, motion, instances: Arc::clone(&self.instances), is_outside }
    }

    /// The copy at `index`, moved by `offset`, of an instance in it.
    fn copy(&self, instance: &InstanceFile, index: &str, offset: &Motion) -> Self {
        let plain = format!("{}{}", self.prefix, instance.name.value);
        let own = format!("{plain}{index}");
        let mut instances = self.instances.to_vec();
        instances.extend((!index.is_empty()).then_some(plain));
        instances.push(own.clone());
        let own_motion = instance.transform.unwrap_or(Motion::IDENTITY);
        let motion = own_motion.then(offset).then(&self.motion);
        let is_outside = self.is_outside || self.source.is_outside(instance.name.span.start);
        Self { prefix: own + ".", motion, instances: instances.into(), is_outside, source: self.source }
    }
}

/// Adds all surfaces and luminaires of `content` to `all`, where they are in what it is `within`.
fn place<'a>(
    content: Content<'a>,
    within: &Within<'_>,
    parts: &Parts<'a>,
    all: &mut Placed<'a>,
) -> Result<(), Located> {
    for file in content.surfaces {
        let motion = file.transform.unwrap_or(Motion::IDENTITY).then(&within.motion);
        all.surfaces.push(within.entry(file, &file.name, motion));
    }
    for file in content.luminaires {
        all.luminaires.push(within.entry(file, &file.name, within.motion));
    }
    for instance in content.instances {
        let (_, part) = part_of(instance, parts)?;
        for (index, offset) in copies(instance)? {
            let copy = within.copy(instance, &index, &offset);
            if copy.is_outside {
                all.outside.extend_from_slice(&copy.instances[within.instances.len()..]);
            }
            place(part, &copy, parts, all)?;
        }
    }
    Ok(())
}

/// Name and content of the part of an instance.
fn part_of<'a>(instance: &InstanceFile, parts: &Parts<'a>) -> Result<(&'a str, Content<'a>), Located> {
    let part = parts.get_key_value(instance.part.value.as_str());
    part.map(|(name, content)| (*name, *content))
        .ok_or_else(|| Located::at(&instance.part.span, unknown_part(&instance.part.value, parts)))
}

fn unknown_part(name: &str, parts: &Parts<'_>) -> Fault {
    let none = format!("define it: [parts.{name}] with a list of surfaces, [[parts.{name}.surfaces]]");
    let known: Vec<String> = parts.keys().map(|name| (*name).to_owned()).collect();
    Fault::unknown_or(format!("unknown part {name:?}"), name, known, "parts of this scene", none)
}

/// The indices of all copies of an instance, as they stand behind its name, and how far each is moved.
fn copies(instance: &InstanceFile) -> Result<Vec<(String, Motion)>, Located> {
    let Some(array) = &instance.array else { return Ok(vec![(String::new(), Motion::IDENTITY)]) };
    let mut copies = vec![(Vec::new(), DVec3::ZERO)];
    for CopyRow { count, step } in &array.rows {
        let along = |(indices, offset): &(Vec<String>, DVec3)| {
            let next = |k: usize| ([&indices[..], &[k.to_string()]].concat(), *offset + k as f64 * *step);
            (0..*count).map(next).collect::<Vec<_>>()
        };
        copies = copies.iter().flat_map(along).collect();
    }
    let moved = |(indices, offset): (Vec<String>, DVec3)| {
        let motion = Motion::new(offset, DVec3::ZERO, 0.0, 1.0);
        let motion = motion.map_err(|error| Located::at(&array.span, error.into()))?;
        Ok((format!("[{}]", indices.join(",")), motion))
    };
    copies.into_iter().map(moved).collect()
}

/// Size of a part, its parts included.
#[derive(Clone, Copy)]
struct Size {
    /// Entries of surfaces and luminaires, and copies of parts.
    count: usize,
    /// Depth of parts within the part.
    depth: usize,
}

/// Refuses parts that contain themselves, are nested too deep, or make too many surfaces.
fn check_sizes(content: Content<'_>, parts: &Parts<'_>) -> Result<(), Located> {
    let mut known = BTreeMap::new();
    for (name, part) in parts {
        size((*name, *part), parts, &mut known, &mut Vec::new())?;
    }
    size_of(content, parts, &mut known, &mut Vec::new()).map(|_| ())
}

fn size<'a>(
    (name, part): (&'a str, Content<'a>),
    parts: &Parts<'a>,
    known: &mut BTreeMap<&'a str, Size>,
    path: &mut Vec<&'a str>,
) -> Result<Size, Located> {
    if let Some(size) = known.get(name) {
        return Ok(*size);
    }
    path.push(name);
    let size = size_of(part, parts, known, path)?;
    path.pop();
    known.insert(name, size);
    Ok(size)
}

fn size_of<'a>(
    content: Content<'_>,
    parts: &Parts<'a>,
    known: &mut BTreeMap<&'a str, Size>,
    path: &mut Vec<&'a str>,
) -> Result<Size, Located> {
    let mut all = Size { count: content.surfaces.len() + content.luminaires.len(), depth: 0 };
    for instance in content.instances {
        let refused = |fault| Err(Located::at(&instance.part.span, fault));
        let part = part_of(instance, parts)?;
        if let Some(start) = path.iter().position(|name| *name == part.0) {
            let names = path[start..].iter().chain([&path[start]]);
            let names = names.copied().collect::<Vec<_>>().join(" → ");
            let cause = format!("the part contains itself: {names}");
            return refused(Fault::new(FaultKind::Cycle, cause, "take one of these instances out"));
        }
        if path.len() >= DEEPEST {
            return refused(Fault::too_deep("parts", DEEPEST));
        }
        let own = size(part, parts, known, path)?;
        all.depth = all.depth.max(own.depth + 1);
        if path.len() + all.depth > DEEPEST {
            return refused(Fault::too_deep("parts", DEEPEST));
        }
        let rows = instance.array.iter().flat_map(|array| &array.rows);
        let copies = rows.fold(1, |copies: usize, row| copies.saturating_mul(row.count));
        all.count = all.count.saturating_add(copies.saturating_mul(own.count.saturating_add(1)));
        if all.count > MOST {
            let cause = format!("the instances make more than {MOST} surfaces");
            return refused(Fault::new(FaultKind::TooMany, cause, "make fewer copies"));
        }
    }
    Ok(all)
}
