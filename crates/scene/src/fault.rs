//! Faults of scenes: kind, cause and cure, stated together where the fault is found.

use std::{error::Error, fmt, io, sync::Arc};

use radiosity_geom::ShapeError;
use radiosity_work::{
    listed::{LONG, listed},
    wording::Wording,
};
use strsim::damerau_levenshtein;

use crate::place::Line;

/// A fault of a scene, without its place; displays its cause.
#[derive(Clone, Debug, PartialEq)]
pub struct Fault {
    /// Kind of the fault, by which programs tell faults apart.
    pub kind: FaultKind,
    /// Cause, without a full stop.
    pub(crate) cause: String,
    pub(crate) cure: Cure,
}

/// Advice that mends a fault.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Cure {
    /// None: the cause says so.
    Told,
    Words(Wording),
    Choice(Box<Choice>),
}

/// The advice to take another name of those `known`, which are listed as `list`. The nearest one is sought when
/// it is asked for, as many formulas of a scene may hold such a fault.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Choice {
    name: String,
    known: Arc<[String]>,
    list: String,
    from: Vocabulary,
}

/// Where the names of a choice come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Vocabulary {
    /// From the language of scenes.
    Language,
    /// From a scene and the files that it names.
    Scene,
}

/// Kinds of faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FaultKind {
    /// A file or standard input that cannot be read.
    Unreadable(io::ErrorKind),
    /// A file within a file that cannot be read, or may not be.
    Include,
    /// A file of another program, or a picture, that cannot be read or written, or needs repairs.
    Foreign,
    /// A text that is not in its language: TOML, JSON, CSV, or that of formulas.
    Syntax,
    /// A key that means nothing where it stands.
    UnknownKey,
    /// A key that has to be given.
    MissingKey,
    /// A key that stands twice in one table.
    RepeatedKey,
    /// Two keys of which only one may be given.
    Exclusive,
    /// A value of another kind than its key takes.
    WrongType,
    /// A list of the wrong length.
    WrongCount,
    /// NaN or an infinity.
    NotFinite,
    /// A fraction, a negative or a huge number where a count is needed.
    NotWhole,
    /// A number outside its range.
    OutOfRange,
    /// A formula without a value.
    NoValue,
    /// Times of a path that are too few or too many, or do not ascend.
    Times,
    /// A text that is blank, or cannot be a name or a unit.
    BadText,
    /// A name that nothing has.
    UnknownName,
    /// A name that two things have.
    DuplicateName,
    /// A variable, a part or a file that needs itself.
    Cycle,
    /// More levels, surfaces or sensors than can be computed with.
    TooMany,
    /// Vectors that give no direction, no view or no plane.
    NoDirection,
    /// A shape or a transform that cannot be made, e.g. without area.
    Shape,
    /// A surface that lies in another one.
    Coincident,
    /// Statements that do not go together.
    Conflict,
    /// Something that the scene, or what is asked of it, needs and that is not there.
    Absent,
}

impl FaultKind {
    /// The kind in words.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Unreadable(_) | Self::Include => "a file that cannot be read",
            Self::Foreign => "content that cannot be followed",
            Self::Syntax => "a syntax error",
            Self::UnknownKey => "an unknown key",
            Self::MissingKey => "a missing key",
            Self::RepeatedKey => "a repeated key",
            Self::Exclusive => "two keys of which only one may be given",
            Self::WrongType => "a value of another kind than its key takes",
            Self::WrongCount => "a list of the wrong length",
            Self::NotFinite => "a number that is not finite",
            Self::NotWhole => "a number that is no count",
            Self::OutOfRange => "a number outside its range",
            Self::NoValue => "a formula without a value",
            Self::Times => "times that do not fit",
            Self::BadText => "a text that is no name",
            Self::UnknownName => "an unknown name",
            Self::DuplicateName => "a name that is given twice",
            Self::Cycle => "something that needs itself",
            Self::TooMany => "too many of something",
            Self::NoDirection => "vectors that give no direction",
            Self::Shape => "a shape that cannot be made",
            Self::Coincident => "a surface that lies in another one",
            Self::Conflict => "statements that do not go together",
            Self::Absent => "something that is needed and absent",
        }
    }
}

impl Fault {
    /// A fault with its cause and its cure, both without a full stop.
    pub fn new(kind: FaultKind, cause: impl Into<String>, cure: impl Into<Wording>) -> Self {
        Self { kind, cause: cause.into(), cure: Cure::Words(cure.into()) }
    }

    /// A fault of a file of another program; an empty cure is none.
    pub fn foreign(cause: impl Into<String>, cure: impl Into<String>) -> Self {
        let cure: String = cure.into();
        let cure = if cure.is_empty() { Cure::Told } else { Cure::Words(cure.into()) };
        Self { kind: FaultKind::Foreign, cause: cause.into(), cure }
    }

    /// The fault by its kind alone: it quotes nothing of a file outside the scene's folder.
    #[must_use]
    pub fn discreet(self) -> Self {
        let kind = self.kind.title();
        let cause =
            format!("{kind}, which is not shown, as it stands in a file outside the folder of the scene");
        let cure = "look at that place in the file, or put a copy of it into the folder of the scene to be told what it says";
        Self::new(self.kind, cause, cure)
    }

    /// The fault with those names of the scene alone that may be shown: others stand in files outside its folder.
    #[must_use]
    pub(crate) fn listing(self, may_be_shown: impl Fn(&str) -> bool) -> Self {
        let Cure::Choice(choice) = &self.cure else { return self };
        let known: Vec<String> = choice.known.iter().filter(|name| may_be_shown(name)).cloned().collect();
        match (choice.from, known.len()) {
            (Vocabulary::Language, _) => self,
            (_, count) if count == choice.known.len() => self,
            (_, 0) => self.cured("correct the name; names are not listed, as some are of files outside the folder of the scene"),
            _ => {
                let list = format!("{}, but for files outside its folder", choice.list);
                let choice = Choice { known: known.into(), list, ..(**choice).clone() };
                Self { cure: Cure::Choice(Box::new(choice)), ..self }
            }
        }
    }

    /// Two statements that do not go together.
    pub fn conflict(cause: impl Into<String>, cure: impl Into<Wording>) -> Self {
        Self::new(FaultKind::Conflict, cause, cure)
    }

    /// Something that is needed and not there.
    pub fn absent(cause: impl Into<String>, cure: impl Into<Wording>) -> Self {
        Self::new(FaultKind::Absent, cause, cure)
    }

    /// A key that is not among those `known` here.
    pub fn unknown_key(key: &str, known: &[&str]) -> Self {
        Self::new(FaultKind::UnknownKey, format!("unknown key {key:?}"), choice(key, known, "known keys"))
    }

    /// A key that has to be given; `example` follows "add `key = …`" in the cure.
    pub fn missing_key(key: &str, example: &str) -> Self {
        let cause = format!("the key {key:?} is missing");
        Self::new(FaultKind::MissingKey, cause, format!("add `{key} = …`{example}"))
    }

    /// A missing number of frames.
    pub fn no_frame_count() -> Self {
        let example = ", how many frames there are, e.g. 50; it stands above the first header in brackets";
        Self::missing_key("frames", example)
    }

    /// A missing flux of a luminaire.
    pub fn no_flux() -> Self {
        let example = ", in W or lm, all of it together; or its peak, `intensity = …`, in W/sr or cd";
        Self::missing_key("flux", example)
    }

    /// A key that stands twice in one table.
    pub fn repeated_key(key: &str) -> Self {
        Self::new(FaultKind::RepeatedKey, format!("the key {key:?} stands twice"), "keep one of them")
    }

    /// Two keys of which only one may be given.
    pub fn exclusive(first: &str, second: &str) -> Self {
        let cause = format!("{first:?} and {second:?} are both given");
        Self::new(FaultKind::Exclusive, cause, "leave one of them out")
    }

    /// The list `what` of another length than `expected`.
    pub fn wrong_count(what: &str, expected: &str, found: usize) -> Self {
        let cause = format!("{what} takes {expected}, found {found}");
        Self::new(FaultKind::WrongCount, cause, format!("give {expected}"))
    }

    /// NaN or an infinity.
    pub fn not_finite(value: f64) -> Self {
        let cure = "write a finite number, e.g. 0.5; nan and inf are none";
        Self::new(FaultKind::NotFinite, format!("{value} is not a finite number"), cure)
    }

    /// A fraction, a negative or a huge number where a count is needed.
    pub fn not_whole(value: f64) -> Self {
        Self::new(FaultKind::NotWhole, format!("{value} is not a whole number"), "give 0, 1, 2, …")
    }

    /// The number `what` outside its range, such as `0 ≤ ρ < 1`.
    pub fn out_of_range(what: &str, value: f64, range: &str) -> Self {
        let cause = format!("{what} is {}, outside {range}", shown(value));
        Self::new(FaultKind::OutOfRange, cause, format!("choose a value with {range}"))
    }

    /// A text that has to say something.
    pub(crate) fn empty_text() -> Self {
        Self::new(FaultKind::BadText, "this text is empty", "write at least one letter")
    }

    /// The word `name` is not among those of the language that are `known`, which the cure lists as `list`.
    pub fn unknown(
        cause: impl Into<String>,
        name: &str,
        known: impl Into<Arc<[String]>>,
        list: impl Into<String>,
    ) -> Self {
        Self::unknown_of(Vocabulary::Language, cause.into(), name, known.into(), list.into())
    }

    /// The name `name` is not among those `known` of a scene, which the cure lists as `list`.
    pub(crate) fn unknown_name(
        cause: impl Into<String>,
        name: &str,
        known: impl Into<Arc<[String]>>,
        list: &str,
    ) -> Self {
        Self::unknown_of(Vocabulary::Scene, cause.into(), name, known.into(), list.to_owned())
    }

    fn unknown_of(from: Vocabulary, cause: String, name: &str, known: Arc<[String]>, list: String) -> Self {
        let cure = Cure::Choice(Box::new(Choice { name: name.to_owned(), known, list, from }));
        Self { kind: FaultKind::UnknownName, cause, cure }
    }

    /// As `Fault::unknown_name`, with the cure `none` where nothing is known.
    pub fn unknown_or(
        cause: impl Into<String>,
        name: &str,
        known: impl Into<Arc<[String]>>,
        list: &str,
        none: impl Into<Wording>,
    ) -> Self {
        let known = known.into();
        match known.is_empty() {
            true => Self::new(FaultKind::UnknownName, cause, none),
            false => Self::unknown_name(cause, name, known, list),
        }
    }

    /// An unknown surface.
    pub(crate) fn unknown_surface(name: &str, known: Vec<String>) -> Self {
        Self::unknown_name(format!("unknown surface {name:?}"), name, known, "surfaces of this scene")
    }

    /// An unknown material.
    pub fn unknown_material(name: &str, known: Vec<String>) -> Self {
        let none = format!("define it: [materials.{name}] with reflectance = 0.5");
        Self::unknown_or(format!("unknown material {name:?}"), name, known, "materials of this scene", none)
    }

    /// A name given twice; the line of the first one, if it stands in a file.
    pub(crate) fn duplicate_name(name: &str, first: Option<&Line>) -> Self {
        let cure = match first {
            Some(line) => format!("rename this one or the first, which stands on {line}"),
            None => "rename one of the two".to_owned(),
        };
        Self::new(FaultKind::DuplicateName, format!("the name {name:?} is given twice"), cure)
    }

    /// A variable and a light group of one name, which is set.
    pub fn variable_and_group(name: &str) -> Self {
        let cause = format!("a variable and a light group are both called {name:?}");
        Self::conflict(cause, "rename one of them in the scene")
    }

    /// An unknown light group; `more` follows in the cure where there are none.
    pub(crate) fn unknown_group(cause: String, name: &str, known: Vec<String>, more: &str) -> Self {
        let none = format!(
            "this scene has no light groups: give surfaces that emit, or their material, group = {name:?}{more}"
        );
        Self::unknown_or(cause, name, known, "light groups of this scene", none)
    }

    /// The things `what` within things, more than `most` levels.
    pub fn too_deep(what: &str, most: usize) -> Self {
        let cause = format!("{what} are nested more than {most} deep");
        Self::new(FaultKind::TooMany, cause, "make fewer levels")
    }

    /// A name with an end of a line or a command to a terminal.
    pub(crate) fn unprintable(name: &str) -> Self {
        let cause = format!("the name {name:?} holds a character that cannot be printed");
        Self::new(FaultKind::BadText, cause, "write it in letters, digits and signs, on one line")
    }

    /// The vector of a key without a length, or along the wrong line.
    pub fn no_direction(key: &str, cure: &str) -> Self {
        Self::new(FaultKind::NoDirection, format!("the vector `{key}` gives no direction"), cure)
    }

    /// Something of two sides on a surface of one.
    pub(crate) fn one_sided(what: &str) -> Self {
        Self::conflict(format!("{what} needs a surface of two sides"), "add two_sided = true to the surface")
    }

    /// The heat of a back on a surface of two sides.
    pub(crate) fn two_sided_back() -> Self {
        let cause = "the heat of the back is given, yet the surface has two sides".to_owned();
        let cure = "leave back out, both sides have one condition; or leave two_sided out: back = \"front\" lets both \
                    sides send out heat at one temperature";
        Self::conflict(cause, cure)
    }

    /// An extent that no luminaire has.
    pub fn bad_extent(problem: &str, cure: &str) -> Self {
        Self::conflict(format!("the light of a luminaire cannot come out of this: {problem}"), cure)
    }

    /// A surface that is no opening to a sky.
    pub fn bad_opening(problem: &str, cure: &str) -> Self {
        Self::conflict(format!("the surface is no opening to a sky: {problem}"), cure)
    }

    /// Nothing that moves.
    pub fn nothing_moves() -> Self {
        Self::absent(
            "nothing moves",
            "say what moves: [[motion]] with surfaces = [\"lamp\"], instances, luminaires, groups or camera = true; or leave \
             frames and motions out",
        )
    }

    /// The fault with another cure.
    #[must_use]
    pub(crate) fn cured(self, cure: impl Into<Wording>) -> Self {
        Self { cure: Cure::Words(cure.into()), ..self }
    }

    /// Advice that mends the fault; none where the message already says so.
    pub fn advice(&self) -> Option<Wording> {
        match &self.cure {
            Cure::Told => None,
            Cure::Words(words) => Some(words.clone()),
            Cure::Choice(own) => {
                let most = if own.from == Vocabulary::Scene { LONG } else { own.known.len() };
                Some(chosen(&own.name, &own.known, &own.list, most).into())
            }
        }
    }

    /// The advice as the command line words it.
    pub fn cure(&self) -> Option<String> {
        self.advice().map(|advice| advice.to_string())
    }
}

/// The message holds the cure.
impl From<ShapeError> for Fault {
    fn from(error: ShapeError) -> Self {
        Self { kind: FaultKind::Shape, cause: error.to_string(), cure: Cure::Told }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.cause)
    }
}

impl Error for Fault {}

/// Advice on an unknown name: the nearest known name, if one is near, and the list of all.
pub fn choice(name: &str, known: &[impl AsRef<str>], what: &str) -> String {
    chosen(name, known, what, known.len())
}

/// Such advice with so many names at the most.
fn chosen(name: &str, known: &[impl AsRef<str>], what: &str, most: usize) -> String {
    let known: Vec<&str> = known.iter().map(AsRef::as_ref).collect();
    let list = format!("{what}: {}", listed(&known, most));
    match nearest(name, known.iter().copied()) {
        Some(near) => format!("did you mean {near:?}? {list}"),
        None => list,
    }
}

/// The text of a number, with an exponent where it would have many zeros.
pub(crate) fn shown(value: f64) -> String {
    let plain = value == 0.0 || (1e-6..1e12).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
}

/// The name among `known` that `name` is most likely a slip of, if any is near enough.
///
/// Near enough: at most one edit, plus one for every three letters typed.
pub fn nearest<'a>(name: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let typed = name.to_lowercase();
    known
        .into_iter()
        .map(|candidate| (damerau_levenshtein(&typed, &candidate.to_lowercase()), candidate))
        .min_by_key(|&(edits, _)| edits)
        .filter(|&(edits, _)| edits <= 1 + typed.chars().count() / 3)
        .map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::nearest;

    const KEYS: [&str; 3] = ["reflectance", "emission", "material"];

    #[test]
    fn a_slip_finds_its_word() {
        assert_eq!(nearest("reflectence", KEYS), Some("reflectance"));
        assert_eq!(nearest("Emision", KEYS), Some("emission"));
    }

    #[test]
    fn a_stranger_finds_nothing() {
        assert_eq!(nearest("colour", KEYS), None);
        assert_eq!(nearest("anything", []), None);
    }
}
