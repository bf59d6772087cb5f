//! Patterns of materials as typed: pictures, cells and polynomials.

use radiosity_scene::{
    Fault, Placement, Term, Wrap,
    error::Located,
    pattern::check_term,
    place::{At, Span},
    tree::{Node, Value},
};

use crate::{
    fields::{Fields, exactly, list, number, real, text, whole},
    file::per_band::{PerBand, per_band},
    include::IMAGE,
};

/// Numbers of a material that are the same all over a surface, or vary over it.
#[derive(Debug)]
pub(crate) enum Amount {
    Even(PerBand),
    Varied(PatternFile),
}

/// A table in place of numbers.
#[derive(Debug)]
pub(crate) struct PatternFile {
    pub span: Span,
    pub kind: PatternKind,
    pub placement: Placement,
    /// Factors by which the pattern's numbers are multiplied, per band.
    pub factor: Option<PerBand>,
}

/// Source of the numbers of a pattern.
#[derive(Debug)]
pub(crate) enum PatternKind {
    Image {
        path: At<String>,
        encoding: Option<Encoding>,
    },
    /// Rows from the top, each from the left.
    Cells(EachBand<Vec<Vec<At<f64>>>>),
    Polynomial(EachBand<Vec<Term>>),
}

/// Relation of the numbers of an image to light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Linear,
    Srgb,
}

/// A value for all bands, or a list with one per band.
#[derive(Debug)]
pub(crate) enum EachBand<T> {
    All(T),
    Each(Vec<T>),
}

/// The keys of which one is given.
const KINDS: [&str; 3] = [IMAGE, "cells", "polynomial"];

/// The keys of pictures and cells.
const PLACEMENT_KEYS: [&str; 3] = ["scale", "offset", "wrap"];

impl PatternFile {
    /// Span that faults of the pattern's numbers are shown at.
    pub(crate) fn place(&self) -> &Span {
        match &self.kind {
            PatternKind::Image { path, .. } => &path.span,
            PatternKind::Cells(_) | PatternKind::Polynomial(_) => &self.span,
        }
    }
}

impl Amount {
    /// Whether the amount is alike in all bands.
    pub(crate) fn is_one_for_all(&self) -> bool {
        match self {
            Amount::Even(numbers) => numbers.is_one_number(),
            Amount::Varied(PatternFile { kind, factor, .. }) => {
                let is_one = match kind {
                    PatternKind::Image { .. } => true,
                    PatternKind::Cells(own) => matches!(own, EachBand::All(_)),
                    PatternKind::Polynomial(own) => matches!(own, EachBand::All(_)),
                };
                is_one && factor.as_ref().is_none_or(PerBand::is_one_number)
            }
        }
    }
}

/// Reads numbers or a table.
pub(crate) fn amount(node: &Node) -> Result<Amount, Located> {
    match &node.value {
        Value::Table(_) => read_pattern(node).map(Amount::Varied),
        _ => per_band(node).map(Amount::Even),
    }
}

fn read_pattern(node: &Node) -> Result<PatternFile, Located> {
    let known: Vec<&'static str> =
        KINDS.into_iter().chain(PLACEMENT_KEYS).chain(["encoding", "factor"]).collect();
    let fields = Fields::new(node, &known)?;
    let given: Vec<&'static str> = KINDS.into_iter().filter(|key| fields.get(key).is_some()).collect();
    if let [first, second, ..] = given[..] {
        return Err(Located::at(&fields.node(second)?.span, Fault::exclusive(first, second)));
    }
    let kind = match given.first() {
        None => {
            return Err(Located::at(
                fields.span(),
                Fault::missing_key(
                    IMAGE,
                    " for a picture, `cells = …` for rows of numbers or `polynomial = …` for terms [i, j, c] of u^i v^j",
                ),
            ));
        }
        Some(&"cells") => PatternKind::Cells(fields.require("cells", |node| each_band(node, cells))?),
        Some(&"polynomial") => {
            PatternKind::Polynomial(fields.require("polynomial", |node| each_band(node, terms))?)
        }
        Some(_) => PatternKind::Image {
            path: fields.require(IMAGE, text)?,
            encoding: fields.optional("encoding", encoding)?,
        },
    };
    refuse_others(&fields, &kind)?;
    Ok(PatternFile {
        span: fields.span().clone(),
        kind,
        placement: Placement {
            scale: fields.optional("scale", scale)?.unwrap_or([1.0; 2]),
            offset: fields
                .optional("offset", |node| exactly(node, "the offset", "numbers, along u and along v", real))?
                .unwrap_or([0.0; 2]),
            wrap: fields.optional("wrap", wrap)?.unwrap_or_default(),
        },
        factor: fields.optional("factor", per_band)?,
    })
}

/// Refuses keys that say nothing of such a pattern.
fn refuse_others(fields: &Fields<'_>, kind: &PatternKind) -> Result<(), Located> {
    let (own, idle) = match kind {
        PatternKind::Image { .. } => return Ok(()),
        PatternKind::Cells(_) => ("cells", &["encoding"][..]),
        PatternKind::Polynomial(_) => ("polynomial", &["encoding", "scale", "offset", "wrap"][..]),
    };
    match idle.iter().find_map(|key| Some((*key, fields.get(key)?))) {
        Some((second, node)) => Err(Located::at(&node.span, Fault::exclusive(own, second))),
        None => Ok(()),
    }
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
    word(node, "wrap", &[("repeat", Wrap::Repeat), ("mirror", Wrap::Mirror), ("clamp", Wrap::Clamp)])
}

fn encoding(node: &Node) -> Result<Encoding, Located> {
    word(node, "encoding", &[("srgb", Encoding::Srgb), ("linear", Encoding::Linear)])
}

/// The value of a word: `words` are the known ones; `what` names the key in messages.
fn word<T: Copy>(node: &Node, what: &'static str, words: &[(&'static str, T)]) -> Result<T, Located> {
    let typed = text(node)?;
    let found = words.iter().find(|(word, _)| *word == typed.value);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let known: Vec<String> = words.iter().map(|(word, _)| (*word).to_owned()).collect();
        let cause = format!("there is no {what} {:?}", typed.value);
        let cure = format!("known words for {what}");
        Located::at(&typed.span, Fault::unknown(cause, &typed.value, known, cure))
    })
}
