//! Parts and their instances as typed.

use radiosity_geom::{DVec3, Motion};
use radiosity_scene::{
    Fault,
    error::{Located, instance_title, part_title},
    names::check_text,
    place::{At, Span},
    ranges::check_copies,
    tree::Node,
};

use crate::{
    fields::{Fields, counted, list, point, points, table, text},
    file::{
        luminaire::{LuminaireFile, read_luminaires},
        surface::{SurfaceFile, read_motion, read_surfaces},
    },
};

/// `[parts.NAME]`.
#[derive(Debug)]
pub(crate) struct PartFile {
    pub name: At<String>,
    pub content: ContentFile,
}

/// Content of a part or of the scene.
#[derive(Debug, Default)]
pub(crate) struct ContentFile {
    pub surfaces: Vec<SurfaceFile>,
    pub luminaires: Vec<LuminaireFile>,
    pub instances: Vec<InstanceFile>,
}

/// `[[instances]]`.
#[derive(Debug)]
pub(crate) struct InstanceFile {
    pub name: At<String>,
    pub part: At<String>,
    pub motion: Motion,
    pub array: Option<ArrayFile>,
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

/// The table of parts.
pub(crate) fn read_parts(node: &Node) -> Result<Vec<PartFile>, Located> {
    let read = |(name, node): &(At<String>, Node)| {
        check_text(&name.value).map_err(|fault| Located::at(&name.span, fault))?;
        read_part(name, node).map_err(|error| error.within(|| part_title(&name.value)))
    };
    table(node)?.iter().map(read).collect()
}

fn read_part(name: &At<String>, node: &Node) -> Result<PartFile, Located> {
    let fields = Fields::new(node, &["surfaces", "luminaires", "instances"])?;
    Ok(PartFile { name: name.clone(), content: read_content(&fields, "")? })
}

/// The lists of surfaces, luminaires and instances; `prefix` stands before the names of those that are given
/// none.
pub(crate) fn read_content(fields: &Fields<'_>, prefix: &str) -> Result<ContentFile, Located> {
    Ok(ContentFile {
        surfaces: fields.get("surfaces").map_or(Ok(Vec::new()), |node| read_surfaces(node, prefix))?,
        luminaires: fields.get("luminaires").map_or(Ok(Vec::new()), |node| read_luminaires(node, prefix))?,
        instances: fields.get("instances").map_or(Ok(Vec::new()), |node| read_instances(node, prefix))?,
    })
}

fn read_instances(node: &Node, prefix: &str) -> Result<Vec<InstanceFile>, Located> {
    let read = |(index, node)| {
        read_instance(index, node, prefix).map_err(|error| error.within(|| instance_title(index + 1)))
    };
    list(node)?.iter().enumerate().map(read).collect()
}

/// An instance without a name is called after its part and its number in the list.
fn read_instance(index: usize, node: &Node, prefix: &str) -> Result<InstanceFile, Located> {
    let fields = Fields::new(node, &["part", "name", "transform", "array"])?;
    let part = fields.require("part", text)?;
    let unnamed = || At::new(format!("{prefix}{}-{}", part.value, index + 1), fields.span());
    Ok(InstanceFile {
        name: fields.optional("name", text)?.unwrap_or_else(unnamed),
        motion: fields.optional("transform", read_motion)?.unwrap_or(Motion::IDENTITY),
        array: fields.optional("array", read_array)?,
        part,
    })
}

/// A row, `count = 5, step = [1, 0, 0]`, or up to three of them,
/// `count = [3, 2], step = [[1, 0, 0], [0, 1, 0]]`.
fn read_array(node: &Node) -> Result<ArrayFile, Located> {
    let fields = Fields::new(node, &["count", "step"])?;
    let (count, step) = (fields.node("count")?, fields.node("step")?);
    let (counts, steps) = match count.items() {
        Some(items) => {
            let counts = items.iter().map(copies).collect::<Result<Vec<_>, _>>()?;
            (counts, points(step)?.to_vec())
        }
        None => (vec![copies(count)?], vec![point(step)?]),
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

fn copies(node: &Node) -> Result<usize, Located> {
    counted(node, check_copies)
}
