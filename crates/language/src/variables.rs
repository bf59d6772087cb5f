//! Variables of a scene file, and the formulas that stand in place of its numbers.

use std::{
    cell::RefCell,
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

use radiosity_scene::{
    Fault, FaultKind, HeatSetting, Source,
    error::{Located, title},
    names::UniqueNames,
    place::{At, Span},
    ranges::check_number,
    tree::{Formula, Node, Value},
};

use crate::{
    fields::{number, table},
    formula::{self, is_name, is_reserved},
};

/// The key of the table of variables, which are evaluated before the rest is read.
pub(super) const VARIABLES: &str = "variables";

/// The mark that a formula begins with.
const MARK: char = '=';

/// Values of variables by name.
#[derive(Debug)]
pub(super) struct Variables {
    values: BTreeMap<String, f64>,
    /// Names of the variables in the order of the text.
    names: Arc<[String]>,
}

impl Variables {
    /// Reads tables of variables, which may use each other in any order; the settings of the source take the
    /// place of what the text says.
    pub(super) fn read<'a>(tables: impl Iterator<Item = &'a Node>, source: &Source) -> Result<Self, Located> {
        let mut entries = Vec::new();
        for node in tables {
            entries.extend(table(node)?);
        }
        let mut unique = UniqueNames::default();
        for (name, _) in &entries {
            check_name(name)?;
            let added = unique.add(&name.value, source.line(name.span.start));
            added.map_err(|fault| Located::at(&name.span, fault))?;
        }
        let names = entries.iter().map(|(name, _)| name.value.clone()).collect();
        let mut variables = Self { values: BTreeMap::new(), names };
        let typed = entries.iter().map(|(name, node)| (name.value.as_str(), node)).collect();
        let definitions = Definitions { typed, settings: &source.settings };
        entries.iter().try_for_each(|(name, _)| variables.find(&name.value, &definitions))?;
        variables.with(&source.settings)
    }

    /// Finds the value of a variable, and before it of those that it needs.
    fn find(&mut self, name: &str, definitions: &Definitions<'_>) -> Result<(), Located> {
        let mut open = vec![name.to_owned()];
        // Of those the ones that wait for others, each for one that comes behind it.
        let mut path = Vec::new();
        let mut waiting = BTreeSet::new();
        while let Some(name) = open.last() {
            if self.values.contains_key(name) {
                if waiting.remove(name) {
                    path.pop();
                }
                open.pop();
                continue;
            }
            let step = self.step(name, definitions);
            match step.map_err(|error| error.within(|| title("variable", name)))? {
                Step::Known(value) => {
                    self.values.insert(name.clone(), value);
                }
                Step::Needs(others, place) => {
                    path.push(name.clone());
                    waiting.insert(name.clone());
                    if let Some(other) = others.iter().find(|other| waiting.contains(*other)) {
                        path.push(other.clone());
                        return Err(cycle(&path, &place));
                    }
                    open.extend(others.into_iter().rev());
                }
            }
        }
        Ok(())
    }

    /// The value of a variable, or the variables that it needs and that are not known yet.
    fn step(&self, name: &str, definitions: &Definitions<'_>) -> Result<Step, Located> {
        if let Some(value) = definitions.settings.get(name) {
            return check_number(*value).map(|()| Step::Known(*value)).map_err(Located::nowhere);
        }
        let Some(node) = definitions.typed.get(name) else {
            return Err(Located::nowhere(self.unknown(name)));
        };
        let needed = RefCell::new(Vec::new());
        let value = number(&evaluated(node, &|other| {
            match definitions.typed.contains_key(other) && !self.values.contains_key(other) {
                true => {
                    needed.borrow_mut().push(other.to_owned());
                    // NaN lets the formula run on, so that the names behind this one are found too.
                    Ok(f64::NAN)
                }
                false => self.value(other),
            }
        }));
        let needed = needed.into_inner();
        match needed.is_empty() {
            false => Ok(Step::Needs(needed, node.span.clone())),
            true => value.map(|number| Step::Known(number.value)),
        }
    }

    /// The variables, if every name in `settings` is one of theirs.
    fn with(self, settings: &BTreeMap<String, f64>) -> Result<Self, Located> {
        let Some(name) = settings.keys().find(|name| !self.values.contains_key(*name)) else {
            return Ok(self);
        };
        let unknown = || match self.names.is_empty() {
            true => Fault::new(
                FaultKind::UnknownName,
                format!("the scene has no variables, yet {name:?} is set"),
                format!(
                    "define it: [variables] with {name} = 2.5, and write \"={name}\" in place of a number; light groups are \
                     set where light is computed"
                ),
            ),
            false => self.unknown(name),
        };
        Err(Located::nowhere(HeatSetting::misplaced(name).unwrap_or_else(unknown)))
    }

    /// Names and values in the order of the text.
    pub(super) fn list(&self) -> Vec<(String, f64)> {
        let value = |name: &String| Some((name.clone(), *self.values.get(name)?));
        self.names.iter().filter_map(value).collect()
    }

    /// Evaluates every text in `tree` that begins with `=`. What comes out counts only where a number is
    /// read.
    pub(super) fn fill(&self, tree: &mut Arc<Node>) {
        if has_formula(tree) {
            self.fill_in(Arc::make_mut(tree));
        }
    }

    fn fill_in(&self, node: &mut Node) {
        match &mut node.value {
            Value::List(items) => items.iter_mut().for_each(|item| self.fill_in(item)),
            Value::Table(entries) => entries.iter_mut().for_each(|(_, item)| self.fill_in(item)),
            Value::Text(text) if text.starts_with(MARK) => {
                *node = evaluated(node, &|name| self.value(name));
            }
            _ => {}
        }
    }

    fn value(&self, name: &str) -> Result<f64, Fault> {
        self.values.get(name).copied().ok_or_else(|| self.unknown(name))
    }

    fn unknown(&self, name: &str) -> Fault {
        let none = format!("define it: [variables] with {name} = 2.5");
        let cause = format!("there is no variable {name:?}");
        Fault::unknown_or(cause, name, Arc::clone(&self.names), "variables of this scene", none)
    }
}

/// Definitions of variables, and settings that take the place of some.
struct Definitions<'a> {
    typed: BTreeMap<&'a str, &'a Node>,
    settings: &'a BTreeMap<String, f64>,
}

/// Outcome of an attempt to find a value.
enum Step {
    Known(f64),
    /// Names of variables that come first, and the span of the formula that needs them.
    Needs(Vec<String>, Span),
}

/// The fault of a path of variables that ends with one of those before.
fn cycle(path: &[String], place: &Span) -> Located {
    let start = path.iter().position(|name| Some(name) == path.last()).unwrap_or_default();
    let cause = format!("it needs its own value: {}", path[start..].join(" → "));
    let fault = Fault::new(FaultKind::Cycle, cause, "give one of them a number");
    Located::at(place, fault).within(|| title("variable", &path[start]))
}

fn check_name(name: &At<String>) -> Result<(), Located> {
    let problem = if is_reserved(&name.value) {
        "means something else in formulas"
    } else if !is_name(&name.value) {
        "is not a word of letters, digits and _"
    } else {
        return Ok(());
    };
    let cause = format!("{:?} {problem}", name.value);
    let fault = Fault::new(FaultKind::BadText, cause, "choose another name, such as width or lamp_2");
    Err(Located::at(&name.span, fault))
}

/// The node with the value of its formula, if it is one; `variable` finds the value of a name.
fn evaluated(node: &Node, variable: &dyn Fn(&str) -> Result<f64, Fault>) -> Node {
    let Some((text, formula)) = formula_of(node) else { return node.clone() };
    let outcome = formula::value(formula, variable);
    let outcome = outcome.map_err(|fault| At::new(fault.value, &place(&node.span, text, &fault.span)));
    At::new(Value::Formula(Box::new(Formula { text: text.to_owned(), outcome })), &node.span)
}

/// Whether a formula stands anywhere in `node`.
fn has_formula(node: &Node) -> bool {
    match &node.value {
        Value::List(items) => items.iter().any(has_formula),
        Value::Table(entries) => entries.iter().any(|(_, item)| has_formula(item)),
        _ => formula_of(node).is_some(),
    }
}

/// The text of a node and the formula in it.
fn formula_of(node: &Node) -> Option<(&str, &str)> {
    let Value::Text(text) = &node.value else { return None };
    Some((text, text.strip_prefix(MARK)?))
}

/// Span of a piece of a formula: within the quotes of its text, if that is typed without escapes, else the
/// whole text.
fn place(node: &Span, text: &str, piece: &Span) -> Span {
    let start = node.start + '"'.len_utf8() + MARK.len_utf8();
    match node.len() == text.len() + 2 {
        true => start + piece.start..start + piece.end,
        false => node.clone(),
    }
}

/// Writes these values in place of those that the tree of a file gives its variables. Returns those that it
/// does not have.
pub(super) fn set(tree: &mut Node, settings: &BTreeMap<String, f64>) -> Vec<String> {
    let mut left: BTreeMap<&str, f64> =
        settings.iter().map(|(name, value)| (name.as_str(), *value)).collect();
    let Value::Table(entries) = &mut tree.value else { return Vec::new() };
    let tables = entries.iter_mut().filter(|(key, _)| key.value == VARIABLES);
    for (_, table) in tables {
        let Value::Table(variables) = &mut table.value else { continue };
        for (name, node) in variables {
            if let Some(value) = left.remove(name.value.as_str()) {
                node.value = Value::Number(value);
            }
        }
    }
    left.into_keys().map(str::to_owned).collect()
}
