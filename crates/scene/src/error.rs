//! Errors of scenes: the fault, its place, and its cure.

use std::{borrow::Cow, fmt, io, sync::Arc};

use radiosity_geom::ShapeError;
use radiosity_work::wording::Wording;
use thiserror::Error;

use crate::place::{Line, Place, Span};

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

/// A fault of a scene, without its place.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum Fault {
    /// The file or standard input cannot be read.
    #[error("cannot be read: {reason}")]
    Unreadable {
        /// Kind of the failure.
        kind: io::ErrorKind,
        /// Reason that the system gave.
        reason: String,
    },
    /// A file of another program that cannot be read or written.
    #[error("{cause}")]
    Foreign {
        /// Cause of the refusal, without a full stop.
        cause: String,
        /// Cure, without a full stop; empty where the cause says so.
        cure: String,
    },
    /// A file of another program that needs repairs, where none are to be made.
    #[error("{cause}")]
    NeedsRepairs {
        /// Cause of the refusal, without a full stop.
        cause: String,
    },
    /// A scene of another program without materials, where light is asked for.
    #[error("the file gives its surfaces no materials")]
    Bare,
    /// A scene that is neither built in nor a path.
    #[error("unknown scene {name:?}")]
    UnknownScene {
        /// The scene that was asked for.
        name: String,
        /// The built-in scenes.
        known: Vec<&'static str>,
    },
    /// A setting of a parameter that the built-in scene does not have.
    #[error("there is no parameter {name:?}")]
    UnknownParameter {
        /// The parameter that was set.
        name: String,
        /// The parameters of the scene.
        known: Vec<&'static str>,
    },
    /// A parameter set outside its range.
    #[error("the parameter {name} is {value}, outside {least} ≤ {name} ≤ {most}")]
    ParameterRange {
        /// Name of the parameter.
        name: &'static str,
        /// The value that was set.
        value: f64,
        /// Least value of the parameter.
        least: f64,
        /// Largest value of the parameter.
        most: f64,
    },
    /// A setting of a scene without variables.
    #[error("the scene has no variables, yet {name:?} is set")]
    NoVariables {
        /// The name that was set.
        name: String,
    },
    /// A variable that is not defined.
    #[error("there is no variable {name:?}")]
    UnknownVariable {
        /// The variable that was asked for.
        name: String,
        /// The variables of the scene, shared by all faults.
        known: Arc<[String]>,
    },
    /// A setting of neither a variable nor a light group.
    #[error("there is no variable or light group {name:?}")]
    UnknownSetting {
        /// The name that was set.
        name: String,
        /// The variables of the scene.
        variables: Arc<[String]>,
        /// The light groups of the scene.
        groups: Arc<[String]>,
    },
    /// A setting of a name that a variable and a light group have.
    #[error("a variable and a light group are both called {name:?}")]
    VariableAndGroup {
        /// Name of the variable and of the light group.
        name: String,
    },
    /// A setting of a variable where the scene was read before.
    #[error("{name:?} is a variable, which is set when the scene is read")]
    FixedVariable {
        /// Name of the variable.
        name: String,
    },
    /// A variable whose formula needs its own value.
    #[error("it needs its own value: {}", names.join(" → "))]
    VariableCycle {
        /// The variables of which each needs the next; the last is the first.
        names: Vec<String>,
    },
    /// A name that no variable can have.
    #[error("{name:?} {problem}")]
    BadVariableName {
        /// The name that was given.
        name: String,
        /// Fault of the name.
        problem: &'static str,
    },
    /// A text that begins as a formula and is none.
    #[error("the formula cannot be read: {problem}")]
    FormulaSyntax {
        /// Fault of the formula.
        problem: String,
    },
    /// A function that formulas do not know.
    #[error("there is no function {name:?}")]
    UnknownFunction {
        /// The function that was called.
        name: String,
        /// Every function.
        known: Vec<&'static str>,
    },
    /// A formula without a value.
    #[error("the formula {problem}")]
    NoValue {
        /// Fault of the formula, e.g. `divides by zero`.
        problem: &'static str,
    },
    /// The text is not TOML or JSON.
    #[error("syntax error: {message}")]
    Syntax {
        /// `TOML` or `JSON`.
        language: &'static str,
        /// Message of the parser.
        message: String,
    },
    /// A key that means nothing here.
    #[error("unknown key {key:?}")]
    UnknownKey {
        /// The key that was given.
        key: String,
        /// Every key that may stand here.
        known: Vec<&'static str>,
    },
    /// A key given twice in one table.
    #[error("the key {key:?} stands twice")]
    RepeatedKey {
        /// The key.
        key: String,
    },
    /// A key that has to be given.
    #[error("the key {key:?} is missing")]
    MissingKey {
        /// The key.
        key: &'static str,
    },
    /// A surface without a shape.
    #[error("no shape is given")]
    MissingShape,
    /// A surface with more than one shape.
    #[error("two shapes are given: {first:?} and {second:?}")]
    TwoShapes {
        /// Key of the first shape.
        first: &'static str,
        /// Key of the second shape.
        second: &'static str,
    },
    /// Two keys that say the same in different ways.
    #[error("{first:?} and {second:?} are both given")]
    Exclusive {
        /// The first key.
        first: &'static str,
        /// The second key.
        second: &'static str,
    },
    /// A face that a box does not have.
    #[error("a box has no face {name:?}")]
    UnknownFace {
        /// The face that was asked for.
        name: String,
        /// The faces of a box.
        known: Vec<&'static str>,
    },
    /// A value of the wrong kind.
    #[error("expected {expected}, found {found}")]
    WrongType {
        /// Kind of value that should stand here.
        expected: &'static str,
        /// Kind of value that stands here.
        found: Cow<'static, str>,
    },
    /// A list of the wrong length.
    #[error("{what} takes {expected}, found {found}")]
    WrongCount {
        /// Name of the list, e.g. `a point`.
        what: &'static str,
        /// Length that the list should have, in words.
        expected: String,
        /// Length of the list.
        found: usize,
    },
    /// NaN or an infinity.
    #[error("{value} is not a finite number")]
    NotFinite {
        /// The number.
        value: f64,
    },
    /// A fraction, a negative or a huge number where a count is needed.
    #[error("{value} is not a whole number")]
    NotWhole {
        /// The number.
        value: f64,
    },
    /// A number outside its range.
    #[error("{what} is {}, outside {range}", shown(*value))]
    OutOfRange {
        /// Name of the number, e.g. `the reflectance`.
        what: &'static str,
        /// The number.
        value: f64,
        /// The range, e.g. `0 ≤ ρ < 1`.
        range: &'static str,
    },
    /// A pattern with a value outside its range.
    #[error("{what} is {} {place}, outside {range}", shown(*value))]
    PatternRange {
        /// Name of the quantity, e.g. `the reflectance`.
        what: &'static str,
        /// The value outside the range.
        value: f64,
        /// Place of the value in the pattern, e.g. `at u = 0.5, v = −1`.
        place: Box<str>,
        /// The range, e.g. `0 ≤ ρ < 1`.
        range: &'static str,
    },
    /// A picture that cannot be taken for a pattern.
    #[error("{path:?}: {cause}")]
    BadPicture {
        /// Path of the picture, as it was opened.
        path: Box<str>,
        /// Cause of the refusal, without a full stop.
        cause: Box<str>,
        /// Cure, without a full stop.
        cure: Box<str>,
    },
    /// A surface of one side that has what needs two.
    #[error("{what} needs a surface of two sides")]
    OneSided {
        /// Name of what needs two sides, e.g. `a transmittance`.
        what: &'static str,
    },
    /// Two sides of one surface that do not let through alike.
    #[error("the transmittances of its two sides differ: {front:?} and {back:?}")]
    OtherTransmittance {
        /// Transmittance of its front, per band.
        front: Vec<f64>,
        /// Transmittance of its back, per band.
        back: Vec<f64>,
    },
    /// A word that is not among those that may stand here.
    #[error("there is no {what} {name:?}")]
    UnknownWord {
        /// Kind of word, e.g. `wrap`.
        what: &'static str,
        /// The word that was given.
        name: Box<str>,
        /// The words there are.
        known: Vec<&'static str>,
    },
    /// A text that has to say something.
    #[error("this text is empty")]
    EmptyText,
    /// A material that is not defined.
    #[error("unknown material {name:?}")]
    UnknownMaterial {
        /// The material that was asked for.
        name: String,
        /// The materials of the scene.
        known: Vec<String>,
    },
    /// A flux of a surface whose material emits as well.
    #[error("a flux is given, yet the material {material:?} emits as well")]
    FluxAndEmission {
        /// Name of the material.
        material: String,
        /// Whether its emission varies over the surface.
        is_patterned: bool,
    },
    /// A part that is not defined.
    #[error("unknown part {name:?}")]
    UnknownPart {
        /// The part that was asked for.
        name: String,
        /// The parts of the scene.
        known: Vec<String>,
    },
    /// A part that contains itself.
    #[error("the part contains itself: {}", names.join(" → "))]
    PartCycle {
        /// The parts of which each contains the next; the last is the first.
        names: Vec<String>,
    },
    /// Things within things, too many levels.
    #[error("{what} are nested more than {most} deep")]
    TooDeep {
        /// Name of the things that are nested, e.g. `parts`.
        what: &'static str,
        /// Largest number of levels.
        most: usize,
    },
    /// More surfaces than can be computed with.
    #[error("the instances make more than {most} surfaces")]
    TooManySurfaces {
        /// Largest number of surfaces.
        most: usize,
    },
    /// A surface that was asked for and is not there.
    #[error("unknown surface {name:?}")]
    UnknownSurface {
        /// The surface that was asked for.
        name: String,
        /// The surfaces of the scene.
        known: Vec<String>,
    },
    /// An instance that is to move and is not there.
    #[error("unknown instance {name:?}")]
    UnknownInstance {
        /// The instance that was asked for.
        name: String,
        /// The instances of the scene.
        known: Vec<String>,
    },
    /// A luminaire that is to move and is not there.
    #[error("unknown luminaire {name:?}")]
    UnknownLuminaire {
        /// The luminaire that was asked for.
        name: String,
        /// The luminaires of the scene.
        known: Vec<String>,
    },
    /// A curve of a path that there is not.
    #[error("there is no curve {name:?}")]
    UnknownCurve {
        /// The curve that was asked for.
        name: String,
    },
    /// A motion that moves nothing, or frames without a motion.
    #[error("nothing moves")]
    NothingMoves,
    /// A motion along no path.
    #[error("nothing says how it moves")]
    NoPath,
    /// A motion that scales.
    #[error("a motion keeps all sizes")]
    NotRigid,
    /// Times of a path that do not ascend.
    #[error("the times do not ascend: {} follows {}", shown(*after), shown(*before))]
    TimesFall {
        /// A time of the path.
        before: f64,
        /// The time that follows it, not later.
        after: f64,
    },
    /// A motion of the camera of a scene that has none.
    #[error("the scene has no camera to move")]
    NoCamera,
    /// Something in two motions.
    #[error("{what} moves already: with the motion {first:?}")]
    MovesTwice {
        /// Title of the thing, e.g. `surface "lamp"`.
        what: String,
        /// Name of the other motion.
        first: String,
    },
    /// A frame of a scene without motions.
    #[error("a frame is asked for, yet nothing moves in the scene")]
    NoFrames,
    /// A frame before the first or behind the last.
    #[error("there is no frame {}: frames are counted from 0 to {last}", shown(*moment))]
    NoSuchFrame {
        /// The moment that was asked for, a real number of frames.
        moment: f64,
        /// Number of the last frame, counted from 0.
        last: usize,
    },
    /// A surface that moves into the place of another one.
    #[error("in frame {} it coincides with surface {other:?}", shown(*moment))]
    MovesInto {
        /// Name of the other surface.
        other: String,
        /// The moment, a real number of frames.
        moment: f64,
    },
    /// A surface that moves so far away that its shape is lost in the rounding of its coordinates.
    #[error("in frame {} it is {distance:.1e} away from the origin, too far for its size", shown(*moment))]
    MovesAway {
        /// Its largest coordinate (scene length).
        distance: f64,
        /// The moment, a real number of frames.
        moment: f64,
    },
    /// An extent that no luminaire has.
    #[error("the light of a luminaire cannot come out of this: {problem}")]
    BadExtent {
        /// Fault of the extent.
        problem: &'static str,
    },
    /// A luminaire that does not say how its light is spread.
    #[error("nothing says how the light is spread over directions")]
    NoDistribution,
    /// A vector without a length, or along the wrong line, where a direction is needed.
    #[error("the vector `{what}` gives no direction")]
    NoDirection {
        /// The key of the vector.
        what: &'static str,
    },
    /// A model of the sky that there is not.
    #[error("there is no sky {name:?}")]
    UnknownSky {
        /// The sky that was asked for.
        name: String,
        /// The models there are.
        known: Vec<&'static str>,
    },
    /// A sun below the horizon.
    #[error("the sun is not above the horizon")]
    SunBelow,
    /// An opening that sends no light of a sky.
    #[error("the surface is no opening to a sky: {problem}")]
    BadOpening {
        /// Reason why it is no opening.
        problem: &'static str,
    },
    /// A sky without an opening.
    #[error("no surface is an opening to the sky")]
    NoOpening,
    /// A light group that was set, but of which nothing emits.
    #[error("no light comes from a group {name:?}")]
    UnknownGroup {
        /// The light group that was set.
        name: String,
        /// The light groups of the scene.
        known: Vec<String>,
    },
    /// Two settings of one light group.
    #[error("the light group {name:?} is set twice")]
    GroupSetTwice {
        /// Name of the light group.
        name: String,
    },
    /// A plane of sensors that was asked for and is not there.
    #[error("unknown plane {name:?}")]
    UnknownPlane {
        /// The plane that was asked for.
        name: String,
        /// The planes of the scene.
        known: Vec<String>,
    },
    /// Two things of one name.
    #[error("the name {name:?} is given twice")]
    DuplicateName {
        /// The name.
        name: String,
        /// Line of the first one; none in a scene built in code.
        first: Option<Line>,
    },
    /// A list of polygons where light is asked for.
    #[error("a list of polygons carries no materials")]
    NoMaterials,
    /// A shape or transform that cannot be made, e.g. without area; the message holds the cure.
    #[error("{0}")]
    Shape(ShapeError),
    /// An index beyond the list of points.
    #[error("there is no point {index}: the list has {count}")]
    NoSuchPoint {
        /// The index, counted from 0.
        index: u32,
        /// Number of points in the list.
        count: usize,
    },
    /// An included file that cannot be read.
    #[error("{file:?} cannot be read: {reason}")]
    UnreadableInclude {
        /// Path of the file, as it was opened.
        file: String,
        /// Reason that the system gave.
        reason: String,
    },
    /// An included file where no files are read.
    #[error("{file:?} cannot be included: the text is not that of a file")]
    NoIncludes {
        /// Path of the file.
        file: String,
    },
    /// A file that includes itself.
    #[error("the file includes itself: {}", files.join(" → "))]
    IncludeCycle {
        /// The files of which each includes the next; the last is the first.
        files: Vec<String>,
    },
    /// Two files that state something differently.
    #[error("the {what} of this file are not those of the other files")]
    OtherThan {
        /// Name of what the files state differently.
        what: &'static str,
    },
    /// A camera that looks nowhere.
    #[error("{problem}")]
    BadCamera {
        /// Fault of the camera.
        problem: &'static str,
    },
    /// A plane of sensors whose edges span none.
    #[error("{problem}")]
    BadPlane {
        /// Fault of the edges.
        problem: &'static str,
    },
    /// A plane of more sensors than can be read.
    #[error("there are {count:.1e} sensors, more than 10⁷")]
    TooManySensors {
        /// Number of sensors that the spacing makes.
        count: f64,
        /// Spacing of both edges (scene length) that makes few enough.
        least: f64,
    },
    /// A unit that cannot be printed.
    #[error("{problem}")]
    BadUnit {
        /// Fault of the unit.
        problem: &'static str,
    },
    /// Two surfaces lie in one another.
    #[error("coincides with surface {other:?}")]
    Coincident {
        /// Name of the other surface.
        other: String,
    },
    /// A scene without surfaces.
    #[error("the scene has no surface")]
    EmptyScene,
    /// A scene in which nothing emits, where light is asked for.
    #[error("nothing emits light")]
    NoEmitter,
}

/// Title of a material in messages.
pub fn material_title(name: &str) -> String {
    format!("material {name:?}")
}

/// Title of a light group in messages.
pub(super) fn group_title(name: &str) -> String {
    format!("light group {name:?}")
}

/// Title of a luminaire in messages.
pub fn luminaire_title(name: &str) -> String {
    format!("luminaire {name:?}")
}

/// Title of a motion in messages.
pub fn motion_title(name: &str) -> String {
    format!("motion {name:?}")
}

/// Title of a plane of sensors in messages.
pub fn plane_title(name: &str) -> String {
    format!("plane {name:?}")
}

/// Title of a variable in messages.
pub fn variable_title(name: &str) -> String {
    format!("variable {name:?}")
}

/// Title of a part in messages.
pub fn part_title(name: &str) -> String {
    format!("part {name:?}")
}

/// Title in messages of the instance of that number in its list, counted from 1.
pub fn instance_title(number: usize) -> String {
    format!("instance {number}")
}

/// Title of a surface in messages.
pub fn surface_title(name: &str) -> String {
    format!("surface {name:?}")
}

/// The text of a number, with an exponent where it would have many zeros.
fn shown(value: f64) -> String {
    let plain = value == 0.0 || (1e-6..1e12).contains(&value.abs());
    if plain { value.to_string() } else { format!("{value:e}") }
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

    /// The fault with its place moved by `base` bytes.
    pub fn shifted(self, base: usize) -> Self {
        Located { span: self.span.map(|span| span.start + base..span.end + base), ..self }
    }

    /// The error in a scene without a text.
    pub(super) fn in_code(self, name: &str) -> SceneError {
        SceneError { origin: name.to_owned(), place: None, owner: self.owner, fault: self.fault }
    }
}

impl SceneError {
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
