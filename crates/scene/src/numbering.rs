//! Numbers for the keys and values of a tree without a text, in place of the bytes that they would stand on,
//! and the path of names that leads to a number, `surfaces[3].polygon.vertices[2]`.
//!
//! Numbers ascend from a table to its keys and values and from there to the next; the place of a value
//! reaches from its own number to behind the last one in it.

use std::collections::HashSet;

use crate::{
    fault::Fault,
    place::At,
    tree::{DEEPEST, Node, PLACES_OF_POINT, Value},
};

/// Lists and tables of parts that have titles of their own in messages.
const LISTS: [&str; 4] = ["surfaces", "luminaires", "instances", "motion"];
const TABLES: [&str; 3] = ["materials", "planes", "variables"];
const SINGLES: [&str; 3] = ["camera", "sky", "include"];
const PARTS: &str = "parts";

/// Numbers a tree from 0 on.
///
/// # Errors
/// Refuses more levels than [`DEEPEST`].
pub(super) fn numbered(tree: &mut Node) -> Result<(), Fault> {
    number(tree, 0, DEEPEST)?;
    Ok(())
}

/// Numbers a value from `next` on, in which at most so many `levels` are nested. Returns the number that
/// follows.
fn number(node: &mut Node, next: usize, levels: usize) -> Result<usize, Fault> {
    let below = || levels.checked_sub(1).ok_or_else(|| Fault::too_deep("lists and tables", DEEPEST));
    let inner = next + 1;
    let end = match &mut node.value {
        Value::List(items) => items.iter_mut().try_fold(inner, |next, item| number(item, next, below()?))?,
        Value::Table(entries) => entries.iter_mut().try_fold(inner, |next, (key, item)| {
            key.span = next..next + 1;
            number(item, next + 1, below()?)
        })?,
        Value::Points(points) => inner + PLACES_OF_POINT * points.len(),
        Value::Text(_) | Value::Formula(_) | Value::Number(_) | Value::Truth(_) | Value::Other(_) => inner,
    };
    node.span = next..end;
    Ok(end)
}

/// The first key that stands twice in its table, the second time.
pub(super) fn repeated_key(node: &Node) -> Option<&At<String>> {
    match &node.value {
        Value::List(items) => items.iter().find_map(repeated_key),
        Value::Table(entries) => {
            let mut known = HashSet::new();
            entries.iter().find_map(
                |(key, item)| {
                    if known.insert(&key.value) { repeated_key(item) } else { Some(key) }
                },
            )
        }
        _ => None,
    }
}

/// One step from a value into it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step<'a> {
    Key(&'a str),
    Item(usize),
}

/// The path of names to the value of that number, or to the table of the key of that number. If `is_titled`
/// the path begins at the part of the scene that has a title of its own.
pub(super) fn path(tree: &Node, number: usize, is_titled: bool) -> String {
    let mut steps = Vec::new();
    follow(tree, number, &mut steps);
    let titled = if is_titled { titled(&steps) } else { 0 };
    let mut text = String::new();
    for step in &steps[titled..] {
        match step {
            Step::Item(index) => text.push_str(&format!("[{index}]")),
            Step::Key(key) => {
                text.push_str(if text.is_empty() { "" } else { "." });
                text.push_str(&shown(key));
            }
        }
    }
    text
}

/// A key as it is; in quotes where it is more than a word.
fn shown(key: &str) -> String {
    let is_word = !key.is_empty() && key.chars().all(|c| c.is_alphanumeric() || "_-".contains(c));
    if is_word { key.to_owned() } else { format!("{key:?}") }
}

/// Adds the steps from `node` to the value of that number in it.
fn follow<'a>(node: &'a Node, number: usize, steps: &mut Vec<Step<'a>>) {
    match &node.value {
        Value::List(items) => {
            let found = items.partition_point(|item| item.span.start <= number).checked_sub(1);
            if let Some(index) = found {
                steps.push(Step::Item(index));
                follow(&items[index], number, steps);
            }
        }
        Value::Table(entries) => {
            let found = entries.partition_point(|(_, item)| item.span.start <= number).checked_sub(1);
            if let Some((key, item)) =
                found.map(|index| &entries[index]).filter(|(_, item)| item.span.contains(&number))
            {
                steps.push(Step::Key(&key.value));
                follow(item, number, steps);
            }
        }
        Value::Points(_) if number > node.span.start => {
            let behind = number - node.span.start - 1;
            steps.push(Step::Item(behind / PLACES_OF_POINT));
            steps.extend((behind % PLACES_OF_POINT).checked_sub(1).map(Step::Item));
        }
        _ => {}
    }
}

/// Number of steps that lead to the part of the scene that has a title.
fn titled(steps: &[Step<'_>]) -> usize {
    match steps {
        [Step::Key(PARTS), Step::Key(_), rest @ ..] => 2 + titled(rest),
        [Step::Key(list), Step::Item(_), ..] if LISTS.contains(list) => 2,
        [Step::Key(table), Step::Key(_), ..] if TABLES.contains(table) => 2,
        [Step::Key(single), ..] if SINGLES.contains(single) => 1,
        // A list of polygons.
        [Step::Item(_), ..] => 1,
        _ => 0,
    }
}

#[cfg(test)]
mod tests {
    use radiosity_geom::DVec3;

    use super::{DEEPEST, numbered, path};
    use crate::tree::{Node, Tree, Value};

    /// All numbers of keys and values in a tree, points and coordinates included, with their paths.
    fn all(node: &Node, at: &str, found: &mut Vec<(usize, String)>) {
        found.push((node.span.start, at.to_owned()));
        if let Value::Table(entries) = &node.value {
            for (key, item) in entries {
                found.push((key.span.start, at.to_owned()));
                let dot = if at.is_empty() { "" } else { "." };
                all(item, &format!("{at}{dot}{}", key.value), found);
            }
        }
        for (index, item) in node.items().iter().flat_map(|items| items.iter()).enumerate() {
            all(item, &format!("{at}[{index}]"), found);
        }
    }

    #[test]
    fn every_number_leads_back_to_its_value() {
        let outline = Tree::table([("vertices", Tree::points(vec![DVec3::ZERO, DVec3::X, DVec3::Y]))]);
        let surface = |name| Tree::table([("name", Tree::text(name)), ("polygon", outline.clone())]);
        let bands = Tree::list([Tree::text("r"), Tree::list([]), Tree::table([("a", Tree::flag(true))])]);
        let surfaces = Tree::list([surface("a"), surface("b")]);
        let Tree(mut tree) =
            Tree::table([("bands", bands), ("none", Tree::table::<&str>([])), ("surfaces", surfaces)]);
        numbered(&mut tree).unwrap();
        let mut found = Vec::new();
        all(&tree, "", &mut found);
        let numbers: Vec<usize> = found.iter().map(|(number, _)| *number).collect();
        assert_eq!(numbers, (0..tree.span.end).collect::<Vec<_>>(), "each number is given once, in order");
        for (number, expected) in found {
            assert_eq!(path(&tree, number, false), expected);
        }
    }

    #[test]
    fn what_is_nested_too_deep_is_refused() {
        let nested = |levels| (0..levels).fold(Tree::number(1.0), |inner, _| Tree::list([inner])).0;
        assert!(numbered(&mut nested(DEEPEST)).is_ok());
        assert!(numbered(&mut nested(DEEPEST + 1)).is_err());
    }
}
