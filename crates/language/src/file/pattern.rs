//! Patterns of materials as typed: pictures, cells and polynomials.

use radiosity_formats::picture::Coding;
use radiosity_scene::{
    Fault, Placement, Term, Wrap,
    error::Located,
    pattern::check_term,
    place::{At, Span},
    tree::{Node, Value},
};
use serde_json::{Value as Json, json};

use crate::{
    fields::{exactly, list, number, real, whole, word},
    file::per_band::{AMOUNTS, PerBand, per_band},
    include::IMAGE,
    keys::{DefaultValue, GivenFields, KeyTable, ValueKind, keys},
    kinds::TEXT,
    terms,
};

/// Numbers of a material that are the same all over a surface, or vary over it.
#[derive(Debug)]
pub(crate) enum Amount {
    Even(PerBand),
    Varied(PatternFile),
}

keys! {
    /// A table in place of numbers.
    PatternFile("What varies over a surface", terms::required("oneOf", &KINDS); check) {
        image: Option<At<String>> = TEXT, "Path of a picture, PNG or OpenEXR, from the folder of this file";
        cells: Option<EachBand<Vec<Vec<At<f64>>>>> = ValueKind::new(|node| each_band(node, cells), cells_schema),
            "Rows of numbers from the top, v = 1, for all bands or for each";
        polynomial: Option<EachBand<Vec<Term>>> = ValueKind::new(|node| each_band(node, terms), polynomial_schema),
            "Terms [i, j, c] of the sum of c u^i v^j, for all bands or for each";
        scale: [f64; 2] = ValueKind::new(scale, scale_schema).or(DefaultValue::Number(1.0)), "How often it fits along u and v";
        offset: [f64; 2] = ValueKind::new(
            |node| exactly(node, "the offset", "numbers, along u and along v", real),
            || terms::exactly(2, "number", ""),
        ).or(DefaultValue::Numbers(&[0.0; 2])), "How much of it is passed at u = −1, v = −1";
        wrap: Wrap = ValueKind::new(wrap, || terms::words(&WRAPS.map(|(name, _)| name))).or(DefaultValue::Word("repeat")),
            "What is beyond its border";
        encoding: Option<Coding> = ValueKind::new(encoding, || terms::words(&ENCODINGS.map(|(name, _)| name))),
            "How the numbers of a picture stand for light";
        factor: PerBand = AMOUNTS.or(DefaultValue::Number(1.0)), "Times its numbers";
        ..span: Span;
    }
}

/// The keys of which one is given.
const KINDS: [&str; 3] = [IMAGE, "cells", "polynomial"];

const WRAPS: [(&str, Wrap); 3] = [("repeat", Wrap::Repeat), ("mirror", Wrap::Mirror), ("clamp", Wrap::Clamp)];

/// Relations of the numbers of a picture to light.
const ENCODINGS: [(&str, Coding); 2] = [("srgb", Coding::Srgb), ("linear", Coding::Linear)];

/// Source of the numbers of a pattern.
#[derive(Debug)]
pub(crate) enum PatternKind<'a> {
    Image(&'a At<String>),
    /// Rows from the top, each from the left.
    Cells(&'a EachBand<Vec<Vec<At<f64>>>>),
    Polynomial(&'a EachBand<Vec<Term>>),
}

/// A value for all bands, or a list with one per band.
#[derive(Debug)]
pub(crate) enum EachBand<T> {
    All(T),
    Each(Vec<T>),
}

impl PatternFile {
    /// Its kind; refused where none is given.
    pub(crate) fn kind(&self) -> Result<PatternKind<'_>, Located> {
        let PatternFile { image, cells, polynomial, .. } = self;
        let image = image.as_ref().map(PatternKind::Image);
        let cells = cells.as_ref().map(PatternKind::Cells);
        let polynomial = polynomial.as_ref().map(PatternKind::Polynomial);
        image.or(cells).or(polynomial).ok_or_else(|| {
            let example =
                " for a picture, `cells = …` for rows of numbers or `polynomial = …` for terms [i, j, c] of u^i v^j";
            Located::at(&self.span, Fault::missing_key(IMAGE, example))
        })
    }

    /// Relation of the pattern to the parameters of the surface.
    pub(crate) fn placement(&self) -> Placement {
        Placement { scale: self.scale, offset: self.offset, wrap: self.wrap }
    }

    /// Span that faults of the pattern's numbers are shown at.
    pub(crate) fn place(&self) -> &Span {
        self.image.as_ref().map_or(&self.span, |path| &path.span)
    }
}

/// Patterns are of one kind, without the keys that say nothing of it.
fn check(own: &PatternFile, fields: &GivenFields<'_>) -> Result<(), Located> {
    fields.at_most_one(&KINDS)?;
    own.kind()?;
    fields.without("cells", &["encoding"])?;
    fields.without("polynomial", &["encoding", "scale", "offset", "wrap"])
}

impl Amount {
    /// Whether the amount is alike in all bands.
    pub(crate) fn is_one_for_all(&self) -> bool {
        match self {
            Amount::Even(numbers) => numbers.is_one_number(),
            Amount::Varied(PatternFile { cells, polynomial, factor, .. }) => {
                !matches!(cells, Some(EachBand::Each(_)))
                    && !matches!(polynomial, Some(EachBand::Each(_)))
                    && factor.is_one_number()
            }
        }
    }
}

/// Reads numbers or a table.
pub(crate) fn amount(node: &Node) -> Result<Amount, Located> {
    match &node.value {
        Value::Table(_) => PatternFile::read(node).map(Amount::Varied),
        _ => per_band(node).map(Amount::Even),
    }
}

/// The schema of numbers, in whose place a pattern may stand.
pub(crate) fn amount_schema(range: Json) -> Json {
    let numbers = terms::per_band(range, "");
    let mut kinds = numbers["anyOf"].as_array().cloned().unwrap_or_default();
    kinds.push(terms::reference("pattern"));
    terms::with(numbers, "anyOf", kinds.into())
}

fn scale_schema() -> Json {
    let scale = terms::ranged(json!({ "exclusiveMinimum": 0, "maximum": 1e6 }), "How often it fits");
    let two = terms::with(terms::exactly(2, "number", "Along u and along v"), "items", scale.clone());
    json!({ "anyOf": [scale["anyOf"][0], scale["anyOf"][1], two] })
}

fn cells_schema() -> Json {
    let row = json!({ "type": "array", "items": terms::reference("number"), "minItems": 1 });
    one_or_each(json!({ "type": "array", "items": row, "minItems": 1 }))
}

fn polynomial_schema() -> Json {
    let term = terms::exactly(3, "number", "Powers of u and v, and a factor");
    one_or_each(json!({ "type": "array", "items": term }))
}

fn one_or_each(one: Json) -> Json {
    let list = json!({ "type": "array", "items": one, "minItems": 1 });
    json!({ "anyOf": [one, list] })
}

/// One list for all bands, or a list of such with one per band: lists of numbers are in it, or lists of
/// those.
fn each_band<T>(node: &Node, read: fn(&Node) -> Result<T, Located>) -> Result<EachBand<T>, Located> {
    let items = list(node)?;
    let first = items.first().and_then(Node::items);
    match first.is_some_and(|inner| inner.first().is_some_and(|node| node.items().is_some())) {
        true => Ok(EachBand::Each(items.iter().map(read).collect::<Result<_, _>>()?)),
        false => read(node).map(EachBand::All),
    }
}

/// Rows of as many numbers each.
fn cells(node: &Node) -> Result<Vec<Vec<At<f64>>>, Located> {
    let row = |node: &Node| list(node)?.iter().map(number).collect::<Result<Vec<_>, _>>();
    let nodes = list(node)?;
    let rows = nodes.iter().map(row).collect::<Result<Vec<_>, _>>()?;
    let count = rows.first().map_or(0, Vec::len);
    let wrong = |what, expected: &str, found| Fault::wrong_count(what, expected, found);
    if count == 0 {
        let fault = wrong("the list of cells", "rows of numbers, such as [[0.2, 0.8], [0.8, 0.2]]", 0);
        return Err(Located::at(&node.span, fault));
    }
    match rows.iter().zip(nodes.iter()).find(|(row, _)| row.len() != count) {
        Some((row, node)) => {
            let fault = wrong("a row of cells", &format!("{count} numbers, as the first row has"), row.len());
            Err(Located::at(&node.span, fault))
        }
        None => Ok(rows),
    }
}

/// Terms [i, j, c].
fn terms(node: &Node) -> Result<Vec<Term>, Located> {
    list(node)?.iter().map(term).collect()
}

fn term(node: &Node) -> Result<Term, Located> {
    let items = list(node)?;
    let [u, v, factor] = &items[..] else {
        let expected = "three numbers, the powers of u and of v and a factor".to_owned();
        return Err(Located::at(&node.span, Fault::wrong_count("a term", &expected, items.len())));
    };
    let term = Term { u: whole(u)?.value, v: whole(v)?.value, factor: real(factor)? };
    check_term(&term).map_err(|fault| Located::at(&node.span, fault))?;
    Ok(term)
}

/// One number, or one along u and one along v.
fn scale(node: &Node) -> Result<[f64; 2], Located> {
    match node.items() {
        Some(_) => exactly(node, "the scale", "numbers, along u and along v", real),
        None => Ok([real(node)?; 2]),
    }
}

fn wrap(node: &Node) -> Result<Wrap, Located> {
    word(node, &WRAPS, |name| format!("there is no wrap {name:?}"), "known words for wrap")
}

fn encoding(node: &Node) -> Result<Coding, Located> {
    word(node, &ENCODINGS, |name| format!("there is no encoding {name:?}"), "known words for encoding")
}
