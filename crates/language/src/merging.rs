//! The files of one scene → a single file: lists one after the other, tables with every name once.

use radiosity_scene::{
    Fault, Source,
    error::{Located, title},
    names::UniqueNames,
    place::At,
};

use crate::file::SceneFile;

/// One scene file of all files. Title and camera are those of the last file, which includes the others; so is
/// the sky, and so are frames and their rate, if that file has them.
pub(super) fn merged(files: Vec<SceneFile>, source: &Source) -> Result<SceneFile, Located> {
    let mut files = files.into_iter().rev();
    let mut whole = files.next().unwrap_or_default();
    for file in files {
        whole.bands = stated(whole.bands.take(), file.bands, "bands", names_of)?;
        whole.unit = stated(whole.unit.take(), file.unit, "units", |unit| vec![unit.value.as_str()])?;
        whole.sky = whole.sky.take().or(file.sky);
        whole.frames = whole.frames.take().or(file.frames);
        whole.fps = whole.fps.take().or(file.fps);
        put_before(&mut whole.motion, file.motion);
        put_before(&mut whole.masks, file.masks);
        put_before(&mut whole.planes, file.planes);
        put_before(&mut whole.materials, file.materials);
        put_before(&mut whole.parts, file.parts);
        put_before(&mut whole.surfaces, file.surfaces);
        put_before(&mut whole.luminaires, file.luminaires);
        put_before(&mut whole.instances, file.instances);
    }
    once(whole.planes.iter().map(|plane| &plane.name), "plane", source)?;
    once(whole.materials.iter().map(|material| &material.name), "material", source)?;
    once(whole.parts.iter().map(|part| &part.name), "part", source)?;
    Ok(whole)
}

fn names_of(bands: &At<Vec<At<String>>>) -> Vec<&str> {
    bands.value.iter().map(|band| band.value.as_str()).collect()
}

/// The value that either of two files states; if both do, the values have to be equal.
fn stated<T>(
    own: Option<At<T>>,
    other: Option<At<T>>,
    what: &'static str,
    texts: fn(&At<T>) -> Vec<&str>,
) -> Result<Option<At<T>>, Located> {
    match (&own, &other) {
        (Some(own), Some(other)) if texts(own) != texts(other) => {
            Err(Located::at(&other.span, other_than(what)))
        }
        _ => Ok(own.or(other)),
    }
}

/// Two files that state something differently.
fn other_than(what: &str) -> Fault {
    let cause = format!("the {what} of this file are not those of the other files");
    Fault::conflict(cause, "state it in one of the files only, or alike in all")
}

fn put_before<T>(list: &mut Vec<T>, mut before: Vec<T>) {
    before.append(list);
    *list = before;
}

/// Refuses a name that is given twice.
fn once<'a>(names: impl Iterator<Item = &'a At<String>>, kind: &str, source: &Source) -> Result<(), Located> {
    let mut seen = UniqueNames::default();
    for name in names {
        let added = seen.add(&name.value, source.line(name.span.start));
        added.map_err(|fault| Located::at(&name.span, fault).within(|| title(kind, &name.value)))?;
    }
    Ok(())
}
