//! Keys of tables. A key stands once, in the table that it belongs to, with its type, its kind and its
//! meaning: the table is its reader, its schema, and the list of keys for "did you mean".
//!
//! The type of a field says whether its key has to be given: a plain type does, an `Option` does not. `At` of
//! a type knows its place.

use radiosity_scene::{
    Fault,
    error::{Located, title},
    names::check_name,
    place::{At, Span},
    tree::{Node, Value, entry},
};
use serde_json::{Map, Value as Json, json};

use crate::{
    fields::{Reader, list, table, text},
    terms,
};

/// The fields of one table, all of known keys.
pub(super) struct GivenFields<'a> {
    entries: &'a [(At<String>, Node)],
    span: &'a Span,
    /// The name of the table if it states none; of a file, what stands before the names of tables in it.
    context: &'a str,
}

impl<'a> GivenFields<'a> {
    /// The fields of `node`, which must be a table with no other keys than those of `T`.
    fn new<T: KeyGroup>(node: &'a Node, context: &'a str) -> Result<Self, Located> {
        let entries = table(node)?;
        match entries.iter().find(|(key, _)| !T::has(&key.value)) {
            None => Ok(GivenFields { entries, span: &node.span, context }),
            Some((key, _)) => {
                let known: Vec<&str> = T::keys().iter().map(|own| own.name).collect();
                Err(Located::at(&key.span, Fault::unknown_key(&key.value, &known)))
            }
        }
    }

    /// A fault of the table: a key that has to be given.
    pub(super) fn missing(&self, key: &str, example: &str) -> Located {
        self.fault(Fault::missing_key(key, example))
    }

    /// A fault of the table.
    pub(super) fn fault(&self, fault: Fault) -> Located {
        Located::at(self.span, fault)
    }

    /// The value of a key, if it is given.
    pub(super) fn get(&self, key: &str) -> Option<&'a Node> {
        entry(self.entries, key)
    }

    /// Refuses the second of these keys that is given.
    pub(super) fn at_most_one(&self, keys: &[&'static str]) -> Result<(), Located> {
        match keys.iter().position(|key| self.get(key).is_some()) {
            Some(first) => self.without(keys[first], &keys[first + 1..]),
            None => Ok(()),
        }
    }

    /// Refuses keys that do not go with the key `first`, where that is given.
    pub(super) fn without(&self, first: &str, others: &[&'static str]) -> Result<(), Located> {
        let other = others.iter().find_map(|key| Some((key, self.get(key)?)));
        match other.filter(|_| self.get(first).is_some()) {
            Some((second, node)) => Err(Located::at(&node.span, Fault::exclusive(first, second))),
            None => Ok(()),
        }
    }
}

/// The schema of a key.
pub(super) struct KeySchema {
    pub name: &'static str,
    pub schema: Json,
    pub is_required: bool,
}

/// The schema of a table with these keys and no others.
pub(super) fn schema_of(meaning: &str, keys: Vec<KeySchema>) -> Json {
    let required: Vec<&str> = keys.iter().filter(|key| key.is_required).map(|key| key.name).collect();
    let properties: Map<String, Json> =
        keys.iter().map(|key| (key.name.to_owned(), key.schema.clone())).collect();
    json!({
        "description": meaning, "type": "object", "properties": properties, "required": required,
        "additionalProperties": false,
    })
}

/// Keys that are read together: all of a table, or some that several tables share.
pub(super) trait KeyGroup: Sized {
    /// Whether `key` is one of them.
    fn has(key: &str) -> bool;

    /// The keys with their schemas.
    fn keys() -> Vec<KeySchema>;

    /// Reads their values from the table in which they are given.
    fn take(fields: &GivenFields<'_>) -> Result<Self, Located>;
}

/// A group without keys: the place of the table in the text.
impl KeyGroup for Span {
    fn has(_: &str) -> bool {
        false
    }

    fn keys() -> Vec<KeySchema> {
        Vec::new()
    }

    fn take(fields: &GivenFields<'_>) -> Result<Self, Located> {
        Ok(fields.span.clone())
    }
}

/// A kind of table: all its keys.
pub(super) trait KeyTable: KeyGroup {
    /// Its schema.
    fn schema() -> Json;

    /// Reads a table that has no name.
    fn read(node: &Node) -> Result<Self, Located> {
        Self::read_in(node, "")
    }

    /// Reads the table; `context` names it if it states no name, or stands before the names of tables in it.
    fn read_in(node: &Node, context: &str) -> Result<Self, Located> {
        Self::take(&GivenFields::new::<Self>(node, context)?)
    }
}

/// Declares a table: its meaning, more of its schema and a check of what its keys say together; its keys, and
/// groups of keys that it shares with other tables.
macro_rules! keys {
    ($(#[$meta:meta])* $name:ident ($about:literal $(, $more:expr)? $(; $check:path)?) {
        $($(#[$note:meta])* $key:ident: $type:ty = $kind:expr, $meaning:expr;)*
        $(..$group:ident: $keys:ty;)*
    }) => {
        $(#[$meta])*
        #[derive(Debug)]
        pub(crate) struct $name {
            $($(#[$note])* pub $key: $type,)*
            $(pub $group: $keys,)*
        }

        impl $crate::keys::KeyGroup for $name {
            fn has(key: &str) -> bool {
                [$(stringify!($key)),*].contains(&key) $(|| <$keys as $crate::keys::KeyGroup>::has(key))*
            }

            fn keys() -> Vec<$crate::keys::KeySchema> {
                let own = [$($crate::keys::KeyOf::<$type>::key(&$kind, stringify!($key), $meaning)),*];
                own.into_iter()$(.chain(<$keys as $crate::keys::KeyGroup>::keys()))*.collect()
            }

            fn take(
                fields: &$crate::keys::GivenFields<'_>,
            ) -> Result<Self, radiosity_scene::error::Located> {
                let _ = fields;
                let own = Self {
                    $($key: $crate::keys::KeyOf::<$type>::take(&$kind, fields, stringify!($key))?,)*
                    $($group: <$keys as $crate::keys::KeyGroup>::take(fields)?,)*
                };
                $($check(&own, fields)?;)?
                Ok(own)
            }
        }

        impl $crate::keys::KeyTable for $name {
            fn schema() -> serde_json::Value {
                let table = $crate::keys::schema_of($about, <Self as $crate::keys::KeyGroup>::keys());
                $(let table = $crate::terms::and(table, $more);)?
                table
            }
        }
    };
}
pub(super) use keys;

/// A kind of value: how it is read, its schema, and an example for whoever left it out.
pub(super) struct ValueKind<T> {
    read: Reader<T>,
    schema: fn() -> Json,
    /// The range of a number, in its schema.
    range: Option<fn() -> Json>,
    /// Value in the cure "add `key = …`".
    example: &'static str,
}

impl<T> ValueKind<T> {
    pub(super) const fn new(read: Reader<T>, schema: fn() -> Json) -> Self {
        ValueKind { read, schema, range: None, example: "" }
    }

    /// The kind with another example.
    pub(super) const fn example(self, example: &'static str) -> Self {
        ValueKind { read: self.read, schema: self.schema, range: self.range, example }
    }

    /// A number in a range, such as `{ "minimum": 0 }`.
    pub(super) const fn number(read: Reader<T>, range: fn() -> Json) -> Self {
        ValueKind { read, schema: || Json::Null, range: Some(range), example: "" }
    }

    /// The kind with a value for keys that are not given.
    pub(super) const fn or(self, usual: DefaultValue) -> WithDefault<T> {
        WithDefault { kind: self, usual }
    }

    /// The kind with an empty value for keys that are not given.
    pub(super) const fn or_empty(self) -> EmptyByDefault<T> {
        EmptyByDefault(self)
    }

    fn key(&self, name: &'static str, meaning: &str, is_required: bool) -> KeySchema {
        let schema = self.range.map_or_else(self.schema, |range| terms::ranged(range(), ""));
        let schema =
            if meaning.is_empty() { schema } else { terms::with(schema, "description", meaning.into()) };
        KeySchema { name, schema, is_required }
    }

    fn get(&self, fields: &GivenFields<'_>, key: &str) -> Result<Option<At<T>>, Located> {
        fields.get(key).map(|node| Ok(At::new((self.read)(node)?, &node.span))).transpose()
    }
}

/// A type that a field may have whose values are read as `T`: `T` or `Option<T>`, with their place or without.
pub(super) trait FieldType<T>: Sized {
    /// The field for the value that is given, if one is; none where the type demands one.
    fn of(given: Option<At<T>>) -> Option<Self>;
}

impl<T> FieldType<T> for T {
    fn of(given: Option<At<T>>) -> Option<Self> {
        Some(given?.value)
    }
}

impl<T> FieldType<T> for At<T> {
    fn of(given: Option<At<T>>) -> Option<Self> {
        given
    }
}

impl<T> FieldType<T> for Option<T> {
    fn of(given: Option<At<T>>) -> Option<Self> {
        Some(given.map(|given| given.value))
    }
}

impl<T> FieldType<T> for Option<At<T>> {
    fn of(given: Option<At<T>>) -> Option<Self> {
        Some(given)
    }
}

/// A key whose value is held by a field of type `F`.
pub(super) trait KeyOf<F> {
    /// The schema of the key of this name.
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema;

    /// The value of the key, as the field holds it.
    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<F, Located>;
}

impl<T, F: FieldType<T>> KeyOf<F> for ValueKind<T> {
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema {
        self.key(name, meaning, F::of(None).is_none())
    }

    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<F, Located> {
        F::of(self.get(fields, key)?).ok_or_else(|| fields.missing(key, self.example))
    }
}

/// A kind of value, with the value of keys that are not given.
pub(super) struct WithDefault<T> {
    kind: ValueKind<T>,
    usual: DefaultValue,
}

/// A field of type `Option` stays empty where nothing is given, although the schema tells a default: whether
/// a key is given matters where several files are merged, and the default is taken after that.
impl<T, F: FieldType<T>> KeyOf<F> for WithDefault<T> {
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema {
        let key = self.kind.key(name, meaning, false);
        KeySchema { schema: terms::with(key.schema, "default", self.usual.json()), ..key }
    }

    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<F, Located> {
        match F::of(self.kind.get(fields, key)?) {
            Some(given) => Ok(given),
            None => {
                let usual = At::new((self.kind.read)(&self.usual.node())?, fields.span);
                F::of(Some(usual)).ok_or_else(|| fields.missing(key, self.kind.example))
            }
        }
    }
}

/// A kind of value, empty for keys that are not given.
pub(super) struct EmptyByDefault<T>(ValueKind<T>);

impl<T: Default> KeyOf<T> for EmptyByDefault<T> {
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema {
        self.0.key(name, meaning, false)
    }

    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<T, Located> {
        Ok(self.0.get(fields, key)?.map(|own| own.value).unwrap_or_default())
    }
}

/// The value of keys that are not given.
pub(super) enum DefaultValue {
    Number(f64),
    Numbers(&'static [f64]),
    Word(&'static str),
    Truth(bool),
}

impl DefaultValue {
    fn node(&self) -> Node {
        let node = |value| At::new(value, &(0..0));
        node(match self {
            DefaultValue::Number(number) => Value::Number(*number),
            DefaultValue::Numbers(numbers) => {
                Value::List(numbers.iter().map(|number| node(Value::Number(*number))).collect())
            }
            DefaultValue::Word(word) => Value::Text((*word).to_owned()),
            DefaultValue::Truth(truth) => Value::Truth(*truth),
        })
    }

    fn json(&self) -> Json {
        let number = |number: &f64| if number.fract() == 0.0 { json!(*number as i64) } else { json!(number) };
        match self {
            DefaultValue::Number(own) => number(own),
            DefaultValue::Numbers(own) => own.iter().map(number).collect(),
            DefaultValue::Word(word) => json!(word),
            DefaultValue::Truth(truth) => json!(truth),
        }
    }
}

/// The key `name` of a table. A table that states no name is called by its kind and its number in the list.
pub(super) struct NameKey;

impl KeyOf<At<String>> for NameKey {
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema {
        KeySchema { name, schema: terms::text(meaning), is_required: false }
    }

    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<At<String>, Located> {
        match fields.get(key) {
            Some(node) => text(node),
            None => Ok(At::new(fields.context.to_owned(), fields.span)),
        }
    }
}

/// A key whose value is a list of tables. Each has a name: its own, or its kind and its number in the list.
pub(super) struct ListOfTables {
    /// Kind of the entries, which defines them in the schema.
    pub kind: &'static str,
    /// The key whose text stands for the kind in names.
    pub called_after: Option<&'static str>,
}

impl ListOfTables {
    pub(super) const fn of(kind: &'static str) -> Self {
        ListOfTables { kind, called_after: None }
    }

    fn read<T: KeyTable>(&self, node: &Node, number: usize, prefix: &str) -> Result<T, Located> {
        let ListOfTables { kind, called_after } = *self;
        let stem = called_after.map(|key| given(node, key).unwrap_or_default());
        let unnamed = format!("{prefix}{}-{number}", stem.as_deref().unwrap_or(kind));
        let named = || match stem {
            None => title(kind, &given(node, "name").unwrap_or(unnamed.clone())),
            Some(_) => format!("{kind} {number}"),
        };
        T::read_in(node, &unnamed).map_err(|error| error.within(named))
    }
}

impl<T: KeyTable> KeyOf<Vec<T>> for ListOfTables {
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema {
        KeySchema { name, schema: terms::list(self.kind, meaning, 0), is_required: false }
    }

    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<Vec<T>, Located> {
        let Some(node) = fields.get(key) else { return Ok(Vec::new()) };
        let items = list(node)?;
        items.iter().zip(1..).map(|(node, number)| self.read(node, number, fields.context)).collect()
    }
}

/// A key whose value holds tables of this kind by name.
pub(super) struct TablesByName(pub &'static str);

/// A table and its name, by which it is listed.
#[derive(Debug)]
pub(super) struct NamedTable<T> {
    pub name: At<String>,
    pub file: T,
}

impl<T: KeyTable> KeyOf<Vec<NamedTable<T>>> for TablesByName {
    fn key(&self, name: &'static str, meaning: &str) -> KeySchema {
        KeySchema { name, schema: terms::by_name(meaning, self.0), is_required: false }
    }

    fn take(&self, fields: &GivenFields<'_>, key: &'static str) -> Result<Vec<NamedTable<T>>, Located> {
        let read = |(name, node): &(At<String>, Node)| {
            check_name(&name.value).map_err(|fault| Located::at(&name.span, fault))?;
            let file = T::read(node).map_err(|error| error.within(|| title(self.0, &name.value)))?;
            Ok(NamedTable { name: name.clone(), file })
        };
        fields.get(key).map_or(Ok(Vec::new()), |node| table(node)?.iter().map(read).collect())
    }
}

/// A text in a table that may be wrong otherwise.
fn given(node: &Node, key: &str) -> Option<String> {
    Some(text(entry(table(node).ok()?, key)?).ok()?.value)
}
