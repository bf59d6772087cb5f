//! The statements of a View3D input: title, vertices, surfaces, by line.

use glam::DVec3;
use radiosity_photometry::error::{Refusal, refuse};
use radiosity_photometry::file_place::FilePlace;
use radiosity_photometry::text::{number, short};

use super::plane::{self, Form};
use crate::tolerances::MOST_VERTICES;

/// Name of the material of what only blocks the view.
pub(super) const OBSTRUCTION: &str = "obstruction";

/// Role of a surface: the letter that its line begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SurfaceRole {
    /// `S`: it radiates to other surfaces.
    Radiating,
    /// `M`: it covers a part of its base and faces it.
    Masking,
    /// `N`: it takes a part of its base away.
    Null,
    /// `O`: it only blocks the view.
    Obstruction,
}

/// Corners by the numbers of vertices, counted from 1, or as points.
#[derive(Clone, Debug)]
pub(super) enum Corners {
    Numbers(Vec<usize>),
    Points(Vec<DVec3>),
}

/// The line of a surface.
#[derive(Clone, Debug)]
pub(super) struct Statement {
    pub(super) line: usize,
    pub(super) kind: SurfaceRole,
    pub(super) corners: Corners,
    /// Number of the surface that it lies on, 0 for none.
    pub(super) base: usize,
    /// Number of the surface that it is combined with in View3D's output, 0 for none.
    pub(super) combined: usize,
    /// Emittance, 0 to 1; 1 for obstructions.
    pub(super) emittance: f64,
    pub(super) name: Option<String>,
}

/// Title, vertices and surfaces of an input.
#[derive(Clone, Debug, Default)]
pub(super) struct Input {
    pub(super) title: Option<String>,
    pub(super) vertices: Vec<DVec3>,
    pub(super) surfaces: Vec<Statement>,
    /// Line of `encl=1`, which asks View3D to adjust its factors.
    pub(super) enclosure: Option<usize>,
    /// Line of the first coordinate transformation, which View3D skips.
    pub(super) transformation: Option<usize>,
    /// Line of the first `I`, which the program knows and its manual does not.
    pub(super) undocumented: Option<usize>,
}

/// A line in words.
struct Words<'a> {
    /// Its number, counted from 1.
    line: usize,
    words: Vec<&'a str>,
}

/// Lines up to the end of the data.
struct Lines<'a> {
    lines: std::iter::Enumerate<std::str::Lines<'a>>,
    is_over: bool,
}

impl<'a> Lines<'a> {
    /// The next line that is not over and its number.
    fn next(&mut self) -> Option<(usize, &'a str)> {
        let (index, line) = self.lines.next().filter(|_| !self.is_over)?;
        Some((index + 1, line))
    }

    /// Words of `line`. Blanks and commas part them, `!` and `/` begin a comment, `*` ends the data.
    fn words(&mut self, line: &'a str) -> Vec<&'a str> {
        let data = line.split('!').next().unwrap_or_default();
        let mut words = Vec::new();
        for word in data.split([' ', '\t', ',', '\r']).filter(|word| !word.is_empty()) {
            self.is_over |= word.starts_with('*');
            if word.starts_with(['*', '/']) {
                break;
            }
            words.push(word);
        }
        words
    }
}

impl Input {
    /// Reads the statements of `text`.
    ///
    /// # Errors
    /// A line that is none of View3D's, with words missing, or numbers out of order.
    pub(super) fn of(text: &str) -> Result<Self, Refusal> {
        let mut input = Self::default();
        let mut lines = Lines { lines: text.lines().enumerate(), is_over: false };
        while let Some((at, line)) = lines.next() {
            let words = lines.words(line);
            let Some((letter, rest)) = words.split_first() else { continue };
            let placed = |refusal: Refusal| refusal.at(FilePlace::Line(at));
            match letter.chars().next().map(|c| c.to_ascii_uppercase()) {
                Some('E') => break,
                Some('T') => input.title = title(line),
                Some('C') => input.enclosure = input.enclosure.or(asks_for_enclosure(rest).then_some(at)),
                Some('F' | 'G') => geometry(rest).map_err(placed)?,
                Some('V') => {
                    let vertex = vertex(rest, input.vertices.len() + 1).map_err(placed)?;
                    input.vertices.push(vertex);
                }
                Some(letter @ ('S' | 'M' | 'N' | 'O')) => {
                    let wanted = input.surfaces.len() + 1;
                    let surface =
                        surface(kind(letter), Words { line: at, words: rest.to_vec() }, wanted, &mut lines);
                    input.surfaces.push(surface.map_err(placed)?);
                }
                Some('X') => input.transformation = input.transformation.or(Some(at)),
                Some('I') => input.undocumented = input.undocumented.or(Some(at)),
                _ => return Err(placed(unknown(letter))),
            }
        }
        Ok(input)
    }
}

fn unknown(letter: &str) -> Refusal {
    Refusal::new(
        format!("a line begins with '{}'", short(letter)),
        "begin it with T, C, F, V, S, M, N, O or E, or with ! if it is a comment",
    )
}

fn kind(letter: char) -> SurfaceRole {
    match letter {
        'M' => SurfaceRole::Masking,
        'N' => SurfaceRole::Null,
        'O' => SurfaceRole::Obstruction,
        _ => SurfaceRole::Radiating,
    }
}

/// Title of a line: the text behind the first word; none if it is blank.
fn title(line: &str) -> Option<String> {
    let (_, title) = line.trim().split_once([' ', '\t', ','])?;
    Some(title.trim().to_owned()).filter(|title| !title.is_empty())
}

/// Whether control words say `encl=1`.
fn asks_for_enclosure(words: &[&str]) -> bool {
    let parts: Vec<&str> =
        words.iter().flat_map(|word| word.split('=')).filter(|part| !part.is_empty()).collect();
    parts.windows(2).any(|pair| pair[0].eq_ignore_ascii_case("encl") && pair[1].parse() != Ok(0))
}

/// Accepts both three-dimensional geometries: the surfaces themselves tell in which of the two they are
/// written.
fn geometry(words: &[&str]) -> Result<(), Refusal> {
    let found = words.first().copied().unwrap_or_default();
    match ["3", "3a", "3b", "4"].iter().any(|known| known.eq_ignore_ascii_case(found)) {
        true => Ok(()),
        false => refuse(
            format!("the geometry is '{}'", short(found)),
            "write F 3 or F 3a; surfaces have to be given in three dimensions",
        ),
    }
}

fn vertex(words: &[&str], wanted: usize) -> Result<DVec3, Refusal> {
    let [index, x, y, z, ..] = words else {
        return refuse(
            format!("a vertex has {} words behind its letter", words.len()),
            "write V, its number, x, y and z",
        );
    };
    in_order(index, wanted, "vertex")?;
    Ok(DVec3::new(number(x, "x")?, number(y, "y")?, number(z, "z")?))
}

/// Refuses a `word` other than the number `wanted`: vertices and surfaces are numbered from 1 without a gap.
fn in_order(word: &str, wanted: usize, what: &str) -> Result<(), Refusal> {
    if wanted > MOST_VERTICES {
        return refuse(format!("there are more than {MOST_VERTICES} of a kind"), "divide the scene");
    }
    match word.parse() == Ok(wanted) {
        true => Ok(()),
        false => refuse(
            format!("the number of a {what} is '{}', it has to be {wanted}", short(word)),
            format!("number each {what} by its place among them, from 1"),
        ),
    }
}

/// The surface whose line behind the letter is `words`.
fn surface(
    kind: SurfaceRole,
    Words { line, words }: Words,
    wanted: usize,
    lines: &mut Lines,
) -> Result<Statement, Refusal> {
    let (index, rest) = words.split_first().ok_or_else(|| missing("its number, its corners", kind))?;
    in_order(index, wanted, "surface")?;
    let form = rest.first().and_then(|word| Form::of(word));
    let (corners, rest) = match form {
        Some(_) => (Corners::Points(Vec::new()), &rest[1..]),
        None => numbers(rest, kind)?,
    };
    let mut statement = Statement { line, kind, corners, base: 0, combined: 0, emittance: 1.0, name: None };
    match kind {
        SurfaceRole::Obstruction => statement.name = obstruction_name(rest),
        _ => data(&mut statement, rest)?,
    }
    if let Some(form) = form {
        let numbers = following(form.count(), lines)?;
        statement.corners = Corners::Points(plane::corners(form, &numbers));
    }
    Ok(statement)
}

fn missing(what: &str, kind: SurfaceRole) -> Refusal {
    let cure = match kind {
        SurfaceRole::Obstruction => {
            "write O, its number, four vertices (the fourth 0 for a triangle) and a name"
        }
        _ => {
            "write the letter, its number, four vertices (the fourth 0 for a triangle) or R, Q or T, its base (0 for \
             none), the surface it is combined with (0 for none), its emittance and a name"
        }
    };
    Refusal::new(format!("a surface lacks {what}"), cure)
}

/// The numbers of its vertices, and the words behind.
fn numbers<'a, 'b>(words: &'b [&'a str], kind: SurfaceRole) -> Result<(Corners, &'b [&'a str]), Refusal> {
    let (vertices, rest) =
        words.split_at_checked(4).ok_or_else(|| missing("some of its four vertices", kind))?;
    let mut numbers = vertices.iter().map(|word| whole(word, "a vertex")).collect::<Result<Vec<_>, _>>()?;
    if numbers.last() == Some(&0) {
        numbers.pop();
    }
    Ok((Corners::Numbers(numbers), rest))
}

fn whole(word: &str, what: &str) -> Result<usize, Refusal> {
    word.parse().map_err(|_| {
        Refusal::new(
            format!("{what} is '{}', which is no whole number from 0", short(word)),
            "write the number that it has in this file",
        )
    })
}

/// Base, combination, emittance and name.
fn data(statement: &mut Statement, words: &[&str]) -> Result<(), Refusal> {
    let [base, combined, emittance, rest @ ..] = words else {
        return Err(missing("its base, its combination or its emittance", statement.kind));
    };
    statement.base = whole(base, "the base")?;
    statement.combined = whole(combined, "the combination")?;
    statement.emittance = number(emittance, "the emittance")?;
    statement.name = rest.first().map(|name| (*name).to_owned());
    match (0.0..=1.0).contains(&statement.emittance) {
        true => Ok(()),
        false => refuse(
            format!("the emittance is {}", statement.emittance),
            "write a number from 0 to 1; 1 is black",
        ),
    }
}

/// The name of an obstruction stands behind its vertices, or where that of other surfaces stands.
fn obstruction_name(words: &[&str]) -> Option<String> {
    let is_number = |word: &&str| word.parse::<f64>().is_ok();
    let word = match words {
        [_, _, _, name, ..] if words.iter().take(3).all(is_number) => name,
        [name, ..] if !is_number(name) => name,
        _ => return None,
    };
    Some((*word).to_owned())
}

/// The next `count` numbers, which may stand in several lines.
fn following(count: usize, lines: &mut Lines) -> Result<Vec<f64>, Refusal> {
    let mut numbers = Vec::with_capacity(count);
    while numbers.len() < count {
        let Some((at, text)) = lines.next() else {
            return refuse(
                format!("a surface has {} numbers in the lines behind it, {count} are needed", numbers.len()),
                "write its origin, azimuth and tilt, then width and height or two coordinates for each corner",
            );
        };
        for word in lines.words(text).into_iter().take(count - numbers.len()) {
            let measure = number(word, "a measure of a surface");
            numbers.push(measure.map_err(|refusal| refusal.at(FilePlace::Line(at)))?);
        }
    }
    Ok(numbers)
}
