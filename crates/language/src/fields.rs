//! Tree → plain values: numbers, points and lists, each refused at its own place.

use std::{borrow::Cow, sync::Arc};

use radiosity_geom::{DVec3, ShapeError};
use radiosity_scene::{
    Fault, FaultKind,
    error::Located,
    names::check_text,
    place::At,
    ranges::check_number,
    tree::{Node, Value},
};

/// A function that turns a node into a value.
pub(super) type Reader<T> = fn(&Node) -> Result<T, Located>;

/// Cure of a value of the wrong kind.
const KIND: &str = "write a value of that kind";

fn wrong(node: &Node, expected: &str, cure: &str) -> Located {
    Located::at(&node.span, wrong_type(expected, &node.value.kind(), cure))
}

fn wrong_type(expected: &str, found: &str, cure: &str) -> Fault {
    Fault::new(FaultKind::WrongType, format!("expected {expected}, found {found}"), cure)
}

/// A value of the kind `found` where a number is expected.
pub(super) fn not_a_number(found: &str) -> Fault {
    wrong_type("a number", found, "write it without quotes, e.g. 0.5")
}

/// The entries of a table.
pub(super) fn table(node: &Node) -> Result<&[(At<String>, Node)], Located> {
    match &node.value {
        Value::Table(entries) => Ok(entries),
        _ => Err(wrong(node, "a table", KIND)),
    }
}

/// The items of a list.
pub(super) fn list(node: &Node) -> Result<Cow<'_, [Node]>, Located> {
    node.items().ok_or_else(|| wrong(node, "a list", "write it in brackets, e.g. [0, 0, 1]"))
}

/// A text that is not blank.
pub(super) fn text(node: &Node) -> Result<At<String>, Located> {
    let text = match &node.value {
        Value::Text(text) => text,
        Value::Formula(formula) => &formula.text,
        _ => return Err(wrong(node, "a text in quotes", "write it in quotes, e.g. \"white\"")),
    };
    match check_text(text) {
        Ok(()) => Ok(At::new(text.clone(), &node.span)),
        Err(fault) => Err(Located::at(&node.span, fault)),
    }
}

/// A list of texts, or one.
pub(super) fn texts(node: &Node) -> Result<Vec<At<String>>, Located> {
    match node.items() {
        Some(items) => items.iter().map(text).collect(),
        None => Ok(vec![text(node)?]),
    }
}

/// `true` or `false`.
pub(super) fn truth(node: &Node) -> Result<bool, Located> {
    match node.value {
        Value::Truth(truth) => Ok(truth),
        _ => Err(wrong(node, "true or false", KIND)),
    }
}

/// A finite number, or a formula of one, of a size that can be computed with.
pub(super) fn number(node: &Node) -> Result<At<f64>, Located> {
    let value = match &node.value {
        Value::Number(value) => *value,
        Value::Formula(formula) => {
            formula.outcome.clone().map_err(|fault| Located::at(&fault.span, fault.value))?
        }
        _ => return Err(Located::at(&node.span, not_a_number(&node.value.kind()))),
    };
    check_number(value).map_err(|fault| Located::at(&node.span, fault))?;
    Ok(At::new(value, &node.span))
}

/// A finite number; as [`number`], without its place.
pub(super) fn real(node: &Node) -> Result<f64, Located> {
    Ok(number(node)?.value)
}

/// A range of angles, typed in degrees, at most all the way round; in radians. `key` names it in messages.
pub(super) fn angles(node: &Node, key: &'static str) -> Result<[f64; 2], Located> {
    let [low, high] = exactly(node, "a range of angles", "numbers, from and to in degrees", real)?;
    let field = key.to_owned();
    let fault = if low >= high {
        ShapeError::OutOfOrder { field, limit: "its second number".to_owned(), low, high }
    } else if high - low > 360.0 {
        ShapeError::OutOfRange { field, low, high, least: low, most: low + 360.0 }
    } else {
        return Ok([low.to_radians(), high.to_radians()]);
    };
    Err(Located::at(&node.span, fault.into()))
}

/// A whole number from 0 to 2³² − 1.
pub(super) fn whole(node: &Node) -> Result<At<u32>, Located> {
    let number = number(node)?;
    if number.value.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&number.value) {
        return Err(Located::at(&node.span, Fault::not_whole(number.value)));
    }
    Ok(At::new(number.value as u32, &node.span))
}

/// A number that passes `check`.
pub(super) fn checked(node: &Node, check: fn(f64) -> Result<(), Fault>) -> Result<f64, Located> {
    let number = real(node)?;
    check(number).map_err(|fault| Located::at(&node.span, fault))?;
    Ok(number)
}

/// The value of a word among those `known`; `unknown` is the cause of a fault, `list` the title of the words.
pub(super) fn word<T: Copy>(
    node: &Node,
    known: &[(&str, T)],
    unknown: fn(&str) -> String,
    list: &str,
) -> Result<T, Located> {
    let typed = text(node)?;
    let found = known.iter().find(|(word, _)| *word == typed.value);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let known: Vec<String> = known.iter().map(|(word, _)| (*word).to_owned()).collect();
        Located::at(&typed.span, Fault::unknown(unknown(&typed.value), &typed.value, known, list))
    })
}

/// A whole number that passes `check`.
pub(super) fn counted(node: &Node, check: fn(usize) -> Result<(), Fault>) -> Result<usize, Located> {
    let count = whole(node)?;
    let value = count.value as usize;
    check(value).map_err(|fault| Located::at(&count.span, fault))?;
    Ok(value)
}

/// Exactly `N` items, each read by `read`; `what` and `unit` name the list and its items in messages.
pub(super) fn exactly<const N: usize, T: Clone>(
    node: &Node,
    what: &'static str,
    unit: &'static str,
    read: Reader<T>,
) -> Result<[T; N], Located> {
    let items = list(node)?;
    if items.len() != N {
        let fault = Fault::wrong_count(what, &format!("{N} {unit}"), items.len());
        return Err(Located::at(&node.span, fault));
    }
    let values = items.iter().map(read).collect::<Result<Vec<_>, _>>()?;
    Ok(std::array::from_fn(|k| values[k].clone()))
}

/// A point or a vector, three numbers.
pub(super) fn point(node: &Node) -> Result<DVec3, Located> {
    exactly(node, "a point", "numbers", real).map(DVec3::from_array)
}

/// A list of points, shared with the tree where it holds them as such.
pub(super) fn points(node: &Node) -> Result<Arc<Vec<DVec3>>, Located> {
    match &node.value {
        Value::Points(points)
            if points.iter().all(|point| point.to_array().iter().all(|x| check_number(*x).is_ok())) =>
        {
            Ok(Arc::clone(points))
        }
        _ => list(node)?.iter().map(point).collect::<Result<_, _>>().map(Arc::new),
    }
}

/// Exactly `N` points; `what` and `unit` name the list and its points in messages.
pub(super) fn corners<const N: usize>(
    node: &Node,
    what: &'static str,
    unit: &'static str,
) -> Result<[DVec3; N], Located> {
    match &node.value {
        Value::Points(points) if points.len() == N => {
            let points = self::points(node)?;
            Ok(std::array::from_fn(|k| points[k]))
        }
        _ => exactly(node, what, unit, point),
    }
}
