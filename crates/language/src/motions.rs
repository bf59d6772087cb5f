//! `[[motion]]`, `frames` and `fps` as typed → the movers of a scene.

use std::sync::Arc;

use radiosity_geom::DVec3;
use radiosity_scene::{
    Animation, AxisAngle, Clock, EmissionTrack, Fault, FaultKind, Luminaire, MoverDraft, RigidPath,
    SceneSurface, Source, TimeFunction, Turn,
    error::{Located, title},
    member_names::{MemberNames, NamedMember},
    mover_draft::{MovableThings, MoverPlaces, movers},
    place::{At, Span},
    ranges::check_factor,
    surfaces::{Maker, emitting},
};

use crate::{
    file::{EmissionFile, MotionFile, RotateFile, SceneFile, TranslateFile},
    instances::{PlacedLuminaire, PlacedSurface},
    validation::spread,
};

/// The animation of a scene file; none if nothing is said of one.
pub(super) fn animation(
    file: &SceneFile,
    movable: &MovableThings,
    source: &Source,
) -> Result<Option<Animation>, Located> {
    let SceneFile { frames, fps, motion: motions, .. } = file;
    let Some(count) = frames else {
        return match (motions.first(), fps) {
            (Some(motion), _) => {
                let missing = Located::at(&motion.span, Fault::no_frame_count());
                Err(missing.within(|| title("motion", &motion.name.value)))
            }
            (None, Some(rate)) => Err(Located::at(&rate.span, Fault::no_frame_count())),
            (None, None) => Ok(None),
        };
    };
    if motions.is_empty() {
        return Err(Located::at(&count.span, Fault::nothing_moves()));
    }
    let rate = fps.as_ref().map_or(1.0, |rate| rate.value);
    let clock = Clock::new(count.value, rate).map_err(|fault| Located::at(&count.span, fault))?;
    let drafts = motions.iter().map(|motion| {
        draft(motion, clock, movable.bands, source)
            .map_err(|error| error.within(|| title("motion", &motion.name.value)))
    });
    movers(drafts.collect::<Result<_, _>>()?, clock, movable).map(Some)
}

/// The surfaces and luminaires of a scene, as they are placed and as they are made.
#[derive(Clone, Copy)]
pub(super) struct MadeThings<'a> {
    pub placed: &'a [PlacedSurface<'a>],
    /// Maker of each of the `surfaces`.
    pub makers: &'a [Maker],
    pub surfaces: &'a [SceneSurface],
    pub placed_luminaires: &'a [PlacedLuminaire<'a>],
    pub luminaires: &'a [Luminaire],
}

/// Surfaces, luminaires and the camera that motions may move, with the names of surfaces, of entries and of
/// instances.
pub(super) fn movable(made: &MadeThings<'_>, bands: usize, camera: bool) -> MovableThings {
    let MadeThings { placed, makers, surfaces, placed_luminaires, luminaires } = *made;
    let of_luminaire = |(own, lamp): (&PlacedLuminaire<'_>, &Luminaire)| {
        let named = MemberNames::named([own.name.clone()]).within(Arc::clone(&own.instances));
        named.in_group(lamp.group.as_ref())
    };
    let lamps: Vec<MemberNames> = placed_luminaires.iter().zip(luminaires).map(of_luminaire).collect();
    let of_surface = |(Maker { draft, front }, own): (&Maker, &SceneSurface)| match placed.get(*draft) {
        Some(PlacedSurface { name, instances, .. }) => {
            let named = MemberNames::named([front.clone(), name.clone()]).within(Arc::clone(instances));
            named.in_group(own.group.as_ref())
        }
        None => MemberNames::of_area(front, &lamps),
    };
    MovableThings {
        surfaces: makers.iter().zip(surfaces).map(of_surface).collect(),
        luminaires: lamps,
        emitting: emitting(surfaces, luminaires),
        bands,
        camera,
    }
}

/// Names of surfaces and luminaires that stand in files outside the folder of the scene, as they are made of what
/// these say.
pub(super) fn names_outside(made: &MadeThings<'_>, movable: &MovableThings) -> Vec<String> {
    let MadeThings { placed, makers, surfaces, placed_luminaires, .. } = *made;
    let is_lamp_outside =
        |area: &MemberNames| area.luminaire().is_some_and(|lamp| placed_luminaires[lamp].is_outside);
    let is_outside = |(maker, area): (&Maker, &MemberNames)| match placed.get(maker.draft) {
        Some(entry) => entry.is_outside,
        None => is_lamp_outside(area),
    };
    let made = surfaces.iter().zip(makers.iter().zip(&movable.surfaces));
    let made = made.filter(|(_, own)| is_outside(*own)).map(|(surface, _)| surface.name.clone());
    let entries = placed.iter().filter(|own| own.is_outside).map(|own| own.name.clone());
    let lamps = placed_luminaires.iter().filter(|own| own.is_outside).map(|own| own.name.clone());
    made.chain(entries).chain(lamps).collect()
}

fn draft(file: &MotionFile, clock: Clock, bands: usize, source: &Source) -> Result<MoverDraft, Located> {
    let chosen = |names: &[At<String>]| -> Vec<NamedMember> {
        names
            .iter()
            .map(|name| NamedMember { name: name.value.clone(), span: Some(name.span.clone()) })
            .collect()
    };
    let path = path(file, clock)?;
    let emission = file.emission.as_ref().map(|own| track(&own.value, clock, bands)).transpose()?;
    if path == RigidPath::REST && emission.is_none() {
        return Err(Located::at(&file.span, no_path()));
    }
    let draft = MoverDraft::new(&file.name.value, path);
    let draft = emission.into_iter().fold(draft, MoverDraft::emission);
    let typed = MoverPlaces {
        place: source.place(&file.span),
        span: file.span.clone(),
        name: file.name.span.clone(),
        name_line: source.line(file.name.span.start),
        emission: file.emission.as_ref().map(|own| own.span.clone()),
    };
    Ok(draft
        .surfaces(chosen(&file.surfaces))
        .instances(chosen(&file.instances))
        .luminaires(chosen(&file.luminaires))
        .groups(chosen(&file.groups))
        .camera_at(file.camera.as_ref().filter(|moves| moves.value).map(|moves| moves.span.clone()))
        .typed(typed))
}

fn path(file: &MotionFile, clock: Clock) -> Result<RigidPath, Located> {
    let shift = file.translate.as_ref().map(|file| shift(file, clock)).transpose()?;
    let turn = file.rotate.as_ref().map(|file| turn(file, clock)).transpose()?;
    match (turn, shift) {
        (Some(turn), Some(shift)) => Ok(RigidPath::turning_along(turn, shift)),
        (Some(turn), None) => Ok(RigidPath::turning(turn)),
        (None, Some(shift)) => Ok(RigidPath::along(shift)),
        (None, None) => Ok(RigidPath::REST),
    }
}

fn no_path() -> Fault {
    Fault::absent(
        "nothing says how it moves",
        "add translate = { points = [[0, 0, 0], [1, 0, 0]] }, rotate = { center = [0, 0, 2], axis = [0, 0, 1], angles = \
         [0, 90] } or emission = { factors = [1, 0] }, or several of them",
    )
}

fn track(file: &EmissionFile, clock: Clock, bands: usize) -> Result<EmissionTrack, Located> {
    let EmissionFile { factors, times, curve } = file;
    let of_time = |own| spread(own, bands, "the list of factors of a time", check_factor);
    let typed = factors.value.iter().map(of_time).collect::<Result<Vec<Vec<f64>>, _>>()?;
    let track = EmissionTrack::new(&typed, given(times, typed.len(), clock), *curve);
    track.map_err(|fault| located(fault, times, &factors.span))
}

fn shift(file: &TranslateFile, clock: Clock) -> Result<TimeFunction<DVec3>, Located> {
    let TranslateFile { points, times, curve } = file;
    let time_function =
        TimeFunction::new("points", points.value.to_vec(), given(times, points.value.len(), clock), *curve);
    time_function.map_err(|fault| located(fault, times, &points.span))
}

fn turn(file: &RotateFile, clock: Clock) -> Result<Turn, Located> {
    let RotateFile { center, times, curve, span, .. } = file;
    match (&file.turns, &file.axis, &file.angles) {
        (None, Some(axis), Some(angles)) => {
            let given = given(times, angles.value.len(), clock);
            let time_function = TimeFunction::new("angles", angles.value.clone(), given, *curve);
            let time_function = time_function.map_err(|fault| located(fault, times, &angles.span))?;
            let turn = Turn::about_axis(*center, axis.value, time_function);
            turn.map_err(|fault| located(fault, &None, &axis.span))
        }
        (turns, ..) => {
            let (keys, place) = turns.as_ref().map_or((&[][..], span), |turns| (&turns.value, &turns.span));
            let rotation =
                |[x, y, z, degrees]: &[f64; 4]| AxisAngle { axis: DVec3::new(*x, *y, *z), degrees: *degrees };
            let rotations: Vec<AxisAngle> = keys.iter().map(rotation).collect();
            let given = given(times, keys.len(), clock);
            let turn = Turn::by_keys(*center, &rotations, given);
            turn.map_err(|fault| located(fault, times, if keys.is_empty() { span } else { place }))
        }
    }
}

/// The times that are given, or else those of all frames spread evenly.
fn given(times: &Option<At<Vec<f64>>>, count: usize, clock: Clock) -> Vec<f64> {
    times.as_ref().map_or_else(|| clock.spread(count), |times| times.value.clone())
}

/// A fault of the times where they stand, else of the values.
fn located(fault: Fault, times: &Option<At<Vec<f64>>>, values: &Span) -> Located {
    match times {
        Some(times) if fault.kind == FaultKind::Times => Located::at(&times.span, fault),
        _ => Located::at(values, fault),
    }
}
