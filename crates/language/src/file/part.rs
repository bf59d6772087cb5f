//! Parts and their instances as typed.

use radiosity_geom::{DVec3, Motion};
use radiosity_scene::{
    Fault,
    error::Located,
    place::{At, Span},
    ranges::{MAX_COPIES, check_copies},
    tree::Node,
};
use serde_json::{Value, json};

use crate::{
    fields::{counted, point, points},
    file::{luminaire::LuminaireFile, surface::SurfaceFile},
    keys::{KeyTable, ListOfTables, NameKey, ValueKind, keys},
    kinds::{TEXT, TRANSFORM},
    terms::{reference, whole},
};

/// An instance without a name is called after its part and its number in the list.
pub(crate) const INSTANCES: ListOfTables = ListOfTables { kind: "instance", called_after: Some("part") };

keys! {
    /// `[parts.NAME]`.
    PartFile("A group of surfaces and luminaires that instances put somewhere") {
        surfaces: Vec<SurfaceFile> = ListOfTables::of("surface"), "Its surfaces";
        luminaires: Vec<LuminaireFile> = ListOfTables::of("luminaire"), "Its luminaires";
        instances: Vec<InstanceFile> = INSTANCES, "Instances of other parts in it";
    }
}

impl PartFile {
    pub(crate) fn content(&self) -> Content<'_> {
        let PartFile { surfaces, luminaires, instances } = self;
        Content { surfaces, luminaires, instances }
    }
}

/// Content of a part or of the scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Content<'a> {
    pub surfaces: &'a [SurfaceFile],
    pub luminaires: &'a [LuminaireFile],
    pub instances: &'a [InstanceFile],
}

keys! {
    /// `[[instances]]`.
    InstanceFile("A part put somewhere") {
        part: At<String> = TEXT.example(", the name of one of [parts.…]"), "The name of the part";
        name: At<String> = NameKey, "Its name, given once in its list";
        transform: Option<Motion> = TRANSFORM, "";
        array: Option<ArrayFile> = ValueKind::new(rows, || reference("array")), "";
    }
}

/// Copies in rows.
#[derive(Debug)]
pub(crate) struct ArrayFile {
    pub span: Span,
    pub rows: Vec<CopyRow>,
}

/// A row of copies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CopyRow {
    /// Number of copies.
    pub count: usize,
    /// The step from one copy to the next (length).
    pub step: DVec3,
}

keys! {
    /// A row, `count = 5, step = [1, 0, 0]`, or up to three of them,
    /// `count = [3, 2], step = [[1, 0, 0], [0, 1, 0]]`.
    RowsFile("Copies in rows") {
        count: Node = ValueKind::new(|node| Ok(node.clone()), count_schema).example(", a number, or up to three in brackets"),
            "Copies along each step";
        step: Node = ValueKind::new(|node| Ok(node.clone()), step_schema).example(", a vector, or one for each number of count"),
            "From one copy to the next";
    }
}

fn count_schema() -> Value {
    let count = whole(1, MAX_COPIES, "Copies along a step");
    let counts = json!({ "type": "array", "items": count, "minItems": 1, "maxItems": 3 });
    json!({ "anyOf": [count["anyOf"][0], count["anyOf"][1], counts] })
}

fn step_schema() -> Value {
    let steps = json!({ "type": "array", "items": reference("vector"), "minItems": 1, "maxItems": 3 });
    json!({ "anyOf": [reference("vector"), steps] })
}

fn rows(node: &Node) -> Result<ArrayFile, Located> {
    let RowsFile { count, step } = RowsFile::read(node)?;
    let copies = |node: &Node| counted(node, check_copies);
    let (counts, steps) = match count.items() {
        Some(items) => {
            let counts = items.iter().map(copies).collect::<Result<Vec<_>, _>>()?;
            (counts, points(&step)?.to_vec())
        }
        None => (vec![copies(&count)?], vec![point(&step)?]),
    };
    if !(1..=3).contains(&counts.len()) {
        let fault = Fault::wrong_count("count", "1 to 3 numbers", counts.len());
        return Err(Located::at(&count.span, fault));
    }
    if steps.len() != counts.len() {
        let expected = format!("as many vectors as count has numbers, {}", counts.len());
        return Err(Located::at(&step.span, Fault::wrong_count("step", &expected, steps.len())));
    }
    let rows = counts.into_iter().zip(steps).map(|(count, step)| CopyRow { count, step }).collect();
    Ok(ArrayFile { span: node.span.clone(), rows })
}
