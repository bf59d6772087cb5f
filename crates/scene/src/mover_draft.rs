//! Movers as they are given, by the names of what they move → movers of a scene, by indices.

use std::{borrow::Borrow, collections::BTreeMap};

use crate::{
    animation::{Animation, Clock, Mover},
    error::{Located, title},
    fault::Fault,
    member_names::{MemberNames, NamedMember, NamesOf, UnknownName, found},
    names::UniqueNames,
    path::RigidPath,
    place::{Line, Place, Span},
};

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
            self.found(&self.surfaces, &movable.surfaces, MemberNames::own, Fault::unknown_surface)?;
        let luminaires =
            self.found(&self.luminaires, &movable.luminaires, MemberNames::own, unknown_luminaire)?;
        let all: Vec<&MemberNames> = movable.surfaces.iter().chain(&movable.luminaires).collect();
        let in_instances = self.found(&self.instances, &all, MemberNames::of_instances, unknown_instance)?;
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
        names: NamesOf,
        unknown: UnknownName,
    ) -> Result<Vec<usize>, Located> {
        found(chosen, all, names, unknown).map_err(|(span, fault)| self.located(span.as_ref(), fault))
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
