//! Movers as they are given, by the names of what they move → movers of a scene, by indices.

use std::{borrow::Borrow, collections::BTreeMap, sync::Arc};

use crate::{
    animation::{Animation, Clock, Mover},
    error::{Located, title},
    fault::Fault,
    names::UniqueNames,
    path::RigidPath,
    place::{Line, Place, Span},
};

/// The mark behind which a name may end in any way.
const ANY_ENDING: char = '*';

/// Surfaces, instances, luminaires and camera that move along one path, by name; see
/// [`SceneBuilder::moves`](crate::SceneBuilder::moves).
#[derive(Debug)]
pub struct MoverDraft {
    name: String,
    surfaces: Vec<NamedMember>,
    instances: Vec<NamedMember>,
    luminaires: Vec<NamedMember>,
    camera: Option<Option<Span>>,
    path: RigidPath,
    typed: Option<MoverPlaces>,
}

/// The name of something that moves, with its place in a file.
#[derive(Clone, Debug)]
pub struct NamedMember {
    /// The name.
    pub name: String,
    /// Place of the name in a file; none if it was given in code.
    pub span: Option<Span>,
}

/// The place of a mover in a file or a tree.
#[derive(Debug)]
pub struct MoverPlaces {
    /// The place of the whole mover.
    pub place: Option<Place>,
    /// Span of the whole mover.
    pub span: Span,
    /// Span of its name.
    pub name: Span,
    /// Line of its name.
    pub name_line: Option<Line>,
}

impl MoverDraft {
    /// A mover along `path` that moves nothing yet.
    pub fn new(name: impl Into<String>, path: RigidPath) -> Self {
        Self {
            name: name.into(),
            surfaces: Vec::new(),
            instances: Vec::new(),
            luminaires: Vec::new(),
            camera: None,
            path,
            typed: None,
        }
    }

    /// Moves the surfaces of that name, both sides; a `*` at its end stands for any ending.
    #[must_use]
    pub fn surface(self, name: impl Into<String>) -> Self {
        self.surfaces([NamedMember { name: name.into(), span: None }])
    }

    /// Moves the luminaires of that name; a `*` at its end stands for any ending.
    #[must_use]
    pub fn luminaire(self, name: impl Into<String>) -> Self {
        self.luminaires([NamedMember { name: name.into(), span: None }])
    }

    /// Moves the camera.
    #[must_use]
    pub fn camera(self) -> Self {
        Self { camera: Some(None), ..self }
    }

    /// Moves surfaces by their names.
    pub fn surfaces(mut self, chosen: impl IntoIterator<Item = NamedMember>) -> Self {
        self.surfaces.extend(chosen);
        self
    }

    /// Moves instances by their names.
    pub fn instances(mut self, chosen: impl IntoIterator<Item = NamedMember>) -> Self {
        self.instances.extend(chosen);
        self
    }

    /// Moves luminaires by their names.
    pub fn luminaires(mut self, chosen: impl IntoIterator<Item = NamedMember>) -> Self {
        self.luminaires.extend(chosen);
        self
    }

    /// Moves the camera if it is named at a place.
    pub fn camera_at(self, span: Option<Span>) -> Self {
        Self { camera: span.map(Some), ..self }
    }

    /// Keeps its places in a file.
    pub fn typed(self, typed: MoverPlaces) -> Self {
        Self { typed: Some(typed), ..self }
    }

    /// A fault at `span` if there is one, else of the whole mover.
    fn located(&self, span: Option<&Span>, fault: Fault) -> Located {
        let span = span.or(self.typed.as_ref().map(|typed| &typed.span));
        let located =
            span.map_or_else(|| Located::nowhere(fault.clone()), |span| Located::at(span, fault.clone()));
        located.within(|| title("motion", &self.name))
    }
}

/// The names by which a surface or a luminaire can be moved.
#[derive(Debug, Default)]
pub struct MemberNames {
    /// Its own name, and the name of the entry that made it.
    pub(super) names: Vec<String>,
    /// Names of the instances that it is in.
    pub(super) instances: Arc<[String]>,
    /// Index of the luminaire whose area it is, if it is one.
    luminaire: Option<usize>,
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

    /// Names of the surface `name`, a side of the area of one of these luminaires.
    pub fn of_area(name: &str, luminaires: &[Self]) -> Self {
        let called = |name: &str| luminaires.iter().position(|own| own.names[0] == name);
        let luminaire = called(name).or_else(|| called(name.strip_suffix(":back")?));
        let instances = luminaire.map(|index| Arc::clone(&luminaires[index].instances));
        let named = Self { luminaire, ..Self::named([name.to_owned()]) };
        named.within(instances.unwrap_or_default())
    }
}

/// Surfaces, luminaires and camera that can be moved, in the order of the scene.
#[derive(Debug)]
pub struct MovableThings {
    /// Names of each surface.
    pub surfaces: Vec<MemberNames>,
    /// Names of each luminaire.
    pub luminaires: Vec<MemberNames>,
    /// Whether there is a camera.
    pub camera: bool,
}

/// The movers of a scene: every name is known, and nothing moves twice.
pub fn movers(drafts: Vec<MoverDraft>, clock: Clock, movable: &MovableThings) -> Result<Animation, Located> {
    let mut names = UniqueNames::default();
    let mut taken = TakenThings::default();
    let mut mover = |draft: MoverDraft| {
        let typed = draft.typed.as_ref();
        let added = names.add(&draft.name, typed.and_then(|typed| typed.name_line.clone()));
        added.map_err(|fault| draft.located(typed.map(|typed| &typed.name), fault))?;
        let mover = draft.resolved(movable)?;
        taken.take(&mover, movable).map_err(|fault| draft.located(None, fault))?;
        Ok(mover)
    };
    let movers = drafts.into_iter().map(&mut mover).collect::<Result<Vec<_>, _>>()?;
    match movers.is_empty() {
        true => Err(Located::nowhere(Fault::nothing_moves())),
        false => Ok(Animation::new(clock, movers)),
    }
}

impl MoverDraft {
    fn resolved(&self, movable: &MovableThings) -> Result<Mover, Located> {
        let surfaces =
            self.found(&self.surfaces, &movable.surfaces, |own| &own.names, Fault::unknown_surface)?;
        let luminaires =
            self.found(&self.luminaires, &movable.luminaires, |own| &own.names, unknown_luminaire)?;
        let all: Vec<&MemberNames> = movable.surfaces.iter().chain(&movable.luminaires).collect();
        let in_instances = self.found(&self.instances, &all, |own| &own.instances, unknown_instance)?;
        let count = movable.surfaces.len();
        let (own, lamps): (Vec<_>, Vec<_>) = in_instances.into_iter().partition(|index| *index < count);
        // A luminaire goes with its area, and the area with the luminaire.
        let surfaces = united(surfaces, own);
        let of_areas = surfaces.iter().filter_map(|index| movable.surfaces[*index].luminaire);
        let lamps = lamps.into_iter().map(|index| index - count).chain(of_areas).collect();
        let luminaires = united(luminaires, lamps);
        let areas = |index: &usize| {
            movable.surfaces[*index].luminaire.is_some_and(|own| luminaires.binary_search(&own).is_ok())
        };
        let areas = (0..count).filter(areas).collect();
        let mover = Mover {
            name: self.name.clone(),
            surfaces: united(surfaces, areas),
            luminaires,
            camera: self.camera.is_some(),
            path: self.path.clone(),
            place: self.typed.as_ref().and_then(|typed| typed.place.clone()),
        };
        match &self.camera {
            Some(span) if !movable.camera => Err(self.located(span.as_ref(), no_camera())),
            None if mover.surfaces.is_empty() && mover.luminaires.is_empty() => {
                Err(self.located(None, Fault::nothing_moves()))
            }
            _ => Ok(mover),
        }
    }

    /// Indices of all things that one of the `chosen` names means.
    fn found<H: Borrow<MemberNames>>(
        &self,
        chosen: &[NamedMember],
        all: &[H],
        names: fn(&MemberNames) -> &[String],
        unknown: fn(&str, Vec<String>) -> Fault,
    ) -> Result<Vec<usize>, Located> {
        let mut found = Vec::new();
        for NamedMember { name, span } in chosen {
            let means = |own: &String| match name.strip_suffix(ANY_ENDING) {
                Some(stem) => own.starts_with(stem),
                None => own == name,
            };
            let before = found.len();
            let meant = all.iter().enumerate().filter(|(_, own)| names((*own).borrow()).iter().any(means));
            found.extend(meant.map(|(index, _)| index));
            if found.len() == before {
                let mut known: Vec<String> =
                    all.iter().flat_map(|own| names(own.borrow()).to_vec()).collect();
                known.sort_unstable();
                known.dedup();
                return Err(self.located(span.as_ref(), unknown(name, known)));
            }
        }
        Ok(found)
    }
}

fn unknown_luminaire(name: &str, known: Vec<String>) -> Fault {
    let none = "the scene has no luminaires: lamps that are surfaces move by surfaces = [\"lamp\"]";
    Fault::unknown_or(format!("unknown luminaire {name:?}"), name, known, "luminaires of this scene", none)
}

fn unknown_instance(name: &str, known: Vec<String>) -> Fault {
    let none = "the scene has no instances: name its surfaces, surfaces = [\"lamp\"]";
    Fault::unknown_or(format!("unknown instance {name:?}"), name, known, "instances of this scene", none)
}

fn no_camera() -> Fault {
    let cure = "add [camera] with eye and target, or leave camera out";
    Fault::absent("the scene has no camera to move", cure)
}

/// Both lists in one, ascending, each index once.
fn united(mut list: Vec<usize>, other: Vec<usize>) -> Vec<usize> {
    list.extend(other);
    list.sort_unstable();
    list.dedup();
    list
}

/// Surfaces, luminaires and camera that belong to a mover already, each with the name of its mover.
#[derive(Default)]
struct TakenThings {
    surfaces: BTreeMap<usize, String>,
    luminaires: BTreeMap<usize, String>,
    camera: Option<String>,
}

impl TakenThings {
    /// Adds a mover; refuses one that moves a thing of another mover.
    fn take(&mut self, mover: &Mover, movable: &MovableThings) -> Result<(), Fault> {
        let twice = |what: String, first: String| {
            let cure = "take it out of one of the two; a path may turn and translate at once";
            Fault::conflict(format!("{what} moves already: with the motion {first:?}"), cure)
        };
        for index in &mover.surfaces {
            if let Some(first) = self.surfaces.insert(*index, mover.name.clone()) {
                return Err(twice(title("surface", &movable.surfaces[*index].names[0]), first));
            }
        }
        for index in &mover.luminaires {
            if let Some(first) = self.luminaires.insert(*index, mover.name.clone()) {
                return Err(twice(title("luminaire", &movable.luminaires[*index].names[0]), first));
            }
        }
        match self.camera.take() {
            Some(first) if mover.camera => Err(twice("the camera".to_owned(), first)),
            first => {
                self.camera = first.or_else(|| mover.camera.then(|| mover.name.clone()));
                Ok(())
            }
        }
    }
}
