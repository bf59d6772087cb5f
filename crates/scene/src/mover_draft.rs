//! Movers as they are given, by the names of what they move → movers of a scene, by indices.

use std::{collections::BTreeMap, ops::Range, slice};

use crate::{
    animation::{Animation, Clock, Mover},
    emission_track::EmissionTrack,
    error::{Located, title},
    fault::Fault,
    member_names::{MemberNames, NamedMember, NamesOf, UnknownName, found},
    names::UniqueNames,
    path::RigidPath,
    place::{Line, Place, Span},
};

/// Surfaces, instances, luminaires, light groups and camera that move along one path, or change what they emit,
/// by name; see [`SceneBuilder::moves`](crate::SceneBuilder::moves).
#[derive(Debug)]
pub struct MoverDraft {
    name: String,
    surfaces: Vec<NamedMember>,
    instances: Vec<NamedMember>,
    luminaires: Vec<NamedMember>,
    groups: Vec<NamedMember>,
    camera: Option<Option<Span>>,
    path: RigidPath,
    emission: Option<EmissionTrack>,
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
    /// Span of its emission, if it has one.
    pub emission: Option<Span>,
}

impl MoverDraft {
    /// A mover along `path` that moves nothing yet.
    pub fn new(name: impl Into<String>, path: RigidPath) -> Self {
        Self {
            name: name.into(),
            surfaces: Vec::new(),
            instances: Vec::new(),
            luminaires: Vec::new(),
            groups: Vec::new(),
            camera: None,
            path,
            emission: None,
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

    /// Moves all surfaces and luminaires of the light group of that name; a `*` at its end stands for any
    /// ending.
    #[must_use]
    pub fn group(self, name: impl Into<String>) -> Self {
        self.groups([NamedMember { name: name.into(), span: None }])
    }

    /// Changes what its surfaces and luminaires emit, over time.
    #[must_use]
    pub fn emission(self, track: EmissionTrack) -> Self {
        Self { emission: Some(track), ..self }
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

    /// Moves the members of light groups by the names of these.
    pub fn groups(mut self, chosen: impl IntoIterator<Item = NamedMember>) -> Self {
        self.groups.extend(chosen);
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
    /// Whether each surface, then each luminaire, emits.
    pub emitting: Vec<bool>,
    /// Number of bands of the scene.
    pub bands: usize,
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

/// Names of one kind, and the things that they may mean.
struct NameList<'a> {
    members: &'a [NamedMember],
    /// Indices of the things, of all surfaces and after those of all luminaires.
    among: Range<usize>,
    names: NamesOf,
    unknown: UnknownName,
}

/// A name that was chosen, with what it means.
struct ChosenThings<'a> {
    member: &'a NamedMember,
    /// Indices of the surfaces, and after those of the luminaires.
    things: Vec<usize>,
}

/// Indices of the surfaces and of the luminaires that are chosen: a luminaire goes with its area, and the area
/// with the luminaire.
fn together(chosen: &[ChosenThings<'_>], movable: &MovableThings) -> [Vec<usize>; 2] {
    let count = movable.surfaces.len();
    let things = chosen.iter().flat_map(|own| &own.things).copied();
    let (surfaces, lamps) = things.partition::<Vec<_>, _>(|index| *index < count);
    let of_areas = surfaces.iter().filter_map(|index| movable.surfaces[*index].luminaire);
    let luminaires = united(lamps.into_iter().map(|index| index - count).chain(of_areas).collect());
    let is_area = |index: &usize| {
        movable.surfaces[*index].luminaire.is_some_and(|own| luminaires.binary_search(&own).is_ok())
    };
    let areas: Vec<usize> = (0..count).filter(is_area).collect();
    [united([surfaces, areas].concat()), luminaires]
}

impl MoverDraft {
    fn resolved(&self, movable: &MovableThings) -> Result<Mover, Located> {
        let chosen = self.chosen(movable)?;
        let [surfaces, luminaires] = together(&chosen, movable);
        match &self.camera {
            Some(span) if !movable.camera => return Err(self.located(span.as_ref(), no_camera())),
            None if surfaces.is_empty() && luminaires.is_empty() => {
                return Err(self.located(None, Fault::nothing_moves()));
            }
            _ => {}
        }
        self.emission.as_ref().map_or(Ok(()), |track| self.check_emission(track, &chosen, movable))?;
        Ok(Mover {
            name: self.name.clone(),
            surfaces,
            luminaires,
            camera: self.camera.is_some(),
            path: self.path.clone(),
            emission: self.emission.clone(),
            place: self.typed.as_ref().and_then(|typed| typed.place.clone()),
        })
    }

    /// All names that are chosen, with what they mean.
    fn chosen(&self, movable: &MovableThings) -> Result<Vec<ChosenThings<'_>>, Located> {
        let all: Vec<&MemberNames> = movable.surfaces.iter().chain(&movable.luminaires).collect();
        let mut chosen = Vec::new();
        for NameList { members, among, names, unknown } in self.lists(movable.surfaces.len(), all.len()) {
            for member in members {
                let things = found(slice::from_ref(member), &all[among.clone()], names, unknown);
                let things = things.map_err(|(span, fault)| self.located(span.as_ref(), fault))?;
                let things = things.into_iter().map(|index| among.start + index).collect();
                chosen.push(ChosenThings { member, things });
            }
        }
        Ok(chosen)
    }

    /// The lists of its names, in a scene of so many surfaces and of as many things, luminaires included.
    fn lists(&self, surfaces: usize, things: usize) -> [NameList<'_>; 4] {
        let list = |members, among, names: NamesOf, unknown: UnknownName| NameList {
            members,
            among,
            names,
            unknown,
        };
        [
            list(&self.surfaces, 0..surfaces, MemberNames::own, Fault::unknown_surface),
            list(&self.luminaires, surfaces..things, MemberNames::own, unknown_luminaire),
            list(&self.instances, 0..things, MemberNames::of_instances, unknown_instance),
            list(&self.groups, 0..things, MemberNames::of_group, unknown_group),
        ]
    }

    /// Refuses a track of other bands, one of things of which none emits, and on a thing that rests, names of
    /// what does not emit.
    fn check_emission(
        &self,
        track: &EmissionTrack,
        chosen: &[ChosenThings<'_>],
        movable: &MovableThings,
    ) -> Result<(), Located> {
        let typed = self.typed.as_ref().and_then(|typed| typed.emission.as_ref());
        let (own, bands) = (track.bands(), movable.bands);
        if own != bands {
            let expected = format!("{bands}, one of each band");
            return Err(
                self.located(typed, Fault::wrong_count("the list of factors of a time", &expected, own))
            );
        }
        let is_dark = |own: &&ChosenThings<'_>| !own.things.iter().any(|index| movable.emitting[*index]);
        if chosen.iter().all(|own| is_dark(&own)) {
            return Err(self.located(typed, nothing_emits()));
        }
        match (&self.camera, chosen.iter().find(is_dark)) {
            _ if !self.path.is_rest() => Ok(()),
            (Some(span), _) => Err(self.located(span.as_ref(), resting("the camera"))),
            (None, Some(ChosenThings { member, .. })) => {
                Err(self.located(member.span.as_ref(), resting(&format!("{:?}", member.name))))
            }
            (None, None) => Ok(()),
        }
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

fn unknown_group(name: &str, known: Vec<String>) -> Fault {
    Fault::unknown_group(format!("unknown light group {name:?}"), name, known, "")
}

fn no_camera() -> Fault {
    let cure = "add [camera] with eye and target, or leave camera out";
    Fault::absent("the scene has no camera to move", cure)
}

fn nothing_emits() -> Fault {
    let cure = "name surfaces or luminaires that emit, or give their material an emission above 0: factors multiply it; \
                or leave emission out";
    Fault::absent("nothing that the motion names emits light", cure)
}

/// Something that emits nothing in a motion without a path.
fn resting(what: &str) -> Fault {
    let cure = "take it out of the motion, or add translate or rotate, by which it moves along";
    Fault::conflict(format!("{what} emits nothing that could change, and the motion has no path"), cure)
}

/// The list ascending, each index once.
fn united(mut list: Vec<usize>) -> Vec<usize> {
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
            let cure = "take it out of one of the two; a motion may turn, translate and dim at once";
            Fault::conflict(format!("{what} belongs to the motion {first:?} already"), cure)
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
